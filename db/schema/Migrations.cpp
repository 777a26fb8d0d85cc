// The schema, step by step. A step that has been released is never changed; a new one is added.
// Enumerations are stored as the numbers of their order in core/record, held by CHECK.

#include "db/chain/Links.h"
#include "db/engine/Statement.h"
#include "db/schema/Schema.h"

namespace lubberline::db {

namespace {

const Migration kFirst{1, "fleet, swings, readings, limits, audit",
    {
        "CREATE TABLE limits_profile (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE, document TEXT NOT NULL,"
        " issue TEXT NOT NULL, scope TEXT NOT NULL, max_deviation_deg REAL CHECK (max_deviation_deg > 0), max_spread_deg REAL CHECK (max_spread_deg > 0))",
        "CREATE TABLE site (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE, latitude_deg REAL, longitude_deg REAL,"
        " elevation_m REAL, variation_deg REAL, variation_source TEXT NOT NULL, note TEXT NOT NULL)",
        "CREATE TABLE aircraft_type (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE, maker TEXT NOT NULL, note TEXT NOT NULL)",
        "CREATE TABLE aircraft (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, type_id INTEGER NOT NULL REFERENCES aircraft_type(id),"
        " registration TEXT NOT NULL UNIQUE CHECK (registration <> ''), serial_number TEXT NOT NULL, operator_name TEXT NOT NULL, built_year INTEGER,"
        " note TEXT NOT NULL, demonstration INTEGER NOT NULL CHECK (demonstration IN (0, 1)))",
        "CREATE INDEX aircraft_by_type ON aircraft(type_id)",
        // status: of the latest swing that has a result; a cache
        "CREATE TABLE compass (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, aircraft_id INTEGER NOT NULL REFERENCES aircraft(id),"
        " name TEXT NOT NULL, kind INTEGER NOT NULL CHECK (kind BETWEEN 0 AND 2), compensator INTEGER NOT NULL CHECK (compensator BETWEEN 0 AND 4),"
        " maker TEXT NOT NULL, part_number TEXT NOT NULL, serial_number TEXT NOT NULL, location TEXT NOT NULL,"
        " resolution_deg REAL NOT NULL CHECK (resolution_deg > 0), limits_id INTEGER REFERENCES limits_profile(id),"
        " status INTEGER NOT NULL DEFAULT 0 CHECK (status BETWEEN 0 AND 2), UNIQUE (aircraft_id, name))",
        "CREATE TABLE event (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, aircraft_id INTEGER NOT NULL REFERENCES aircraft(id),"
        " date TEXT NOT NULL, kind TEXT NOT NULL, note TEXT NOT NULL)",
        "CREATE INDEX event_by_aircraft ON event(aircraft_id, date)",
        // reading_count and all from max_abs_deviation_deg on: a cache of what core computes from the readings
        "CREATE TABLE swing (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, compass_id INTEGER NOT NULL REFERENCES compass(id),"
        " site_id INTEGER REFERENCES site(id), date TEXT NOT NULL, kind INTEGER NOT NULL CHECK (kind BETWEEN 0 AND 3),"
        " stage INTEGER NOT NULL CHECK (stage BETWEEN 0 AND 1), state INTEGER NOT NULL CHECK (state BETWEEN 0 AND 2),"
        " radio INTEGER NOT NULL CHECK (radio BETWEEN 0 AND 2), engines TEXT NOT NULL, electrics TEXT NOT NULL, other_configuration TEXT NOT NULL,"
        " datum_instrument TEXT NOT NULL, datum_serial_number TEXT NOT NULL, datum_calibration_due TEXT NOT NULL,"
        " datum_reader TEXT NOT NULL, cockpit_reader TEXT NOT NULL, adjuster TEXT NOT NULL, inspector TEXT NOT NULL,"
        " variation_deg REAL, procedure_name TEXT NOT NULL, work_order TEXT NOT NULL, reason TEXT NOT NULL, note TEXT NOT NULL,"
        " reading_count INTEGER NOT NULL DEFAULT 0, max_abs_deviation_deg REAL, a_deg REAL, b_deg REAL, c_deg REAL, d_deg REAL, e_deg REAL,"
        " status INTEGER NOT NULL DEFAULT 0 CHECK (status BETWEEN 0 AND 2))",
        "CREATE INDEX swing_by_compass ON swing(compass_id, date)",
        "CREATE INDEX swing_by_date ON swing(date)",
        "CREATE TABLE reading (id INTEGER PRIMARY KEY, swing_id INTEGER NOT NULL REFERENCES swing(id) ON DELETE CASCADE, position INTEGER NOT NULL,"
        " nominal_deg REAL CHECK (nominal_deg >= 0 AND nominal_deg < 360), magnetic_heading_deg REAL CHECK (magnetic_heading_deg >= 0 AND magnetic_heading_deg < 360),"
        " compass_heading_deg REAL CHECK (compass_heading_deg >= 0 AND compass_heading_deg < 360),"
        " true_heading_deg REAL CHECK (true_heading_deg >= 0 AND true_heading_deg < 360), pitch_deg REAL CHECK (pitch_deg BETWEEN -90 AND 90),"
        " roll_deg REAL CHECK (roll_deg BETWEEN -180 AND 180), note TEXT NOT NULL, exclusion_reason TEXT CHECK (exclusion_reason <> ''), extra_json TEXT NOT NULL)",
        "CREATE INDEX reading_by_swing ON reading(swing_id, position)",
        "CREATE TABLE audit_entry (id INTEGER PRIMARY KEY, time_utc TEXT NOT NULL, what TEXT NOT NULL, record TEXT NOT NULL, detail TEXT NOT NULL)",
        "CREATE INDEX audit_by_record ON audit_entry(record)",
        "CREATE TRIGGER audit_is_kept BEFORE DELETE ON audit_entry BEGIN SELECT RAISE(ABORT, 'the audit trail is append-only'); END",
        "CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit_entry BEGIN SELECT RAISE(ABORT, 'the audit trail is append-only'); END",
        // What is signed is frozen; the cached results are not part of what was signed.
        "CREATE TRIGGER signed_swing_is_kept BEFORE DELETE ON swing WHEN OLD.state = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER signed_swing_is_frozen BEFORE UPDATE OF record, compass_id, site_id, date, kind, stage, state, radio, engines, electrics,"
        " other_configuration, datum_instrument, datum_serial_number, datum_calibration_due, datum_reader, cockpit_reader, adjuster, inspector,"
        " variation_deg, procedure_name, work_order, reason, note ON swing WHEN OLD.state = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER signed_readings_no_update BEFORE UPDATE ON reading WHEN (SELECT state FROM swing WHERE id = OLD.swing_id) = 2"
        " OR (SELECT state FROM swing WHERE id = NEW.swing_id) = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER signed_readings_no_insert BEFORE INSERT ON reading WHEN (SELECT state FROM swing WHERE id = NEW.swing_id) = 2"
        " BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER signed_readings_no_delete BEFORE DELETE ON reading WHEN (SELECT state FROM swing WHERE id = OLD.swing_id) = 2"
        " BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
    }};

const Migration kSecond{2, "what is signed and the audit trail withstand REPLACE; badges from an index, search without one",
    {
        // REPLACE deletes the row that is in its way without the triggers on DELETE; so does UPDATE OR REPLACE, which needs a changed id.
        "CREATE TRIGGER audit_is_not_replaced BEFORE INSERT ON audit_entry WHEN EXISTS (SELECT 1 FROM audit_entry WHERE id = NEW.id)"
        " BEGIN SELECT RAISE(ABORT, 'the audit trail is append-only'); END",
        "CREATE TRIGGER signed_swing_is_not_replaced BEFORE INSERT ON swing WHEN EXISTS (SELECT 1 FROM swing WHERE state = 2 AND"
        " (id = NEW.id OR record = NEW.record)) BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER signed_readings_are_not_replaced BEFORE INSERT ON reading WHEN EXISTS (SELECT 1 FROM reading r JOIN swing s ON s.id = r.swing_id"
        " WHERE r.id = NEW.id AND s.state = 2) BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "CREATE TRIGGER swing_stays_the_same_record BEFORE UPDATE ON swing WHEN NEW.id <> OLD.id OR NEW.record <> OLD.record"
        " BEGIN SELECT RAISE(ABORT, 'a record keeps its identity'); END",
        "CREATE TRIGGER reading_stays_the_same BEFORE UPDATE ON reading WHEN NEW.id <> OLD.id BEGIN SELECT RAISE(ABORT, 'a reading keeps its identity'); END",
        "CREATE INDEX compass_by_status ON compass(aircraft_id, status)",
        // Only search ordered by it, and visiting every swing in the order of an index takes four times as long as in that of the table.
        "DROP INDEX swing_by_date",
    }};

const Migration kThird{3, "sensor models of compasses; the Earth's field that a swing was computed with; an index taken out after it",
    {
        "CREATE TABLE sensor_model (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, compass_id INTEGER NOT NULL REFERENCES compass(id),"
        " name TEXT NOT NULL CHECK (name <> ''), origin INTEGER NOT NULL CHECK (origin BETWEEN 0 AND 3), note TEXT NOT NULL,"
        " model_json TEXT NOT NULL CHECK (model_json <> ''), bench_json TEXT CHECK (bench_json <> ''), states_json TEXT NOT NULL CHECK (states_json <> ''),"
        " UNIQUE (compass_id, name))",
        // The stamp is there whole or not at all.
        "ALTER TABLE swing ADD COLUMN field_model TEXT CHECK (field_model <> '')",
        "ALTER TABLE swing ADD COLUMN field_latitude_deg REAL CHECK (field_latitude_deg BETWEEN -90 AND 90)",
        "ALTER TABLE swing ADD COLUMN field_longitude_deg REAL CHECK (field_longitude_deg BETWEEN -180 AND 180)",
        "ALTER TABLE swing ADD COLUMN field_height_m REAL",
        "ALTER TABLE swing ADD COLUMN field_date TEXT CHECK (field_date <> '')",
        "ALTER TABLE swing ADD COLUMN field_north_nT REAL",
        "ALTER TABLE swing ADD COLUMN field_east_nT REAL",
        "ALTER TABLE swing ADD COLUMN field_down_nT REAL CHECK ((field_model IS NULL) + (field_latitude_deg IS NULL) + (field_longitude_deg IS NULL)"
        " + (field_height_m IS NULL) + (field_date IS NULL) + (field_north_nT IS NULL) + (field_east_nT IS NULL) + (field_down_nT IS NULL) IN (0, 8))",
        "ALTER TABLE swing ADD COLUMN index_removed_deg REAL",
        "CREATE TRIGGER signed_swing_field_is_frozen BEFORE UPDATE OF field_model, field_latitude_deg, field_longitude_deg, field_height_m, field_date,"
        " field_north_nT, field_east_nT, field_down_nT, index_removed_deg ON swing WHEN OLD.state = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
    }};

const Migration kFourth{4,
    "the ramp: guided swings, signatures, revisions, raw figures, instruments, due rules, waivers, bases, electrical swings",
    {
        "ALTER TABLE swing ADD COLUMN datum_read_out TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN start_utc TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN end_utc TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN site_override TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN weather TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN job_record TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN supersedes TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN amendment TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE swing ADD COLUMN revision INTEGER NOT NULL DEFAULT 1 CHECK (revision >= 1)",
        "CREATE UNIQUE INDEX swing_by_superseded ON swing(supersedes) WHERE supersedes <> ''", // one amendment for each: the next amends that one
        "CREATE INDEX swing_by_job ON swing(job_record) WHERE job_record <> ''",
        "CREATE TRIGGER signed_swing_ramp_is_frozen BEFORE UPDATE OF datum_read_out, start_utc, end_utc, site_override, weather, job_record, supersedes,"
        " amendment, revision ON swing WHEN OLD.state = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        "ALTER TABLE reading ADD COLUMN raw_json TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE reading ADD COLUMN time_utc TEXT NOT NULL DEFAULT ''",
        "CREATE TABLE signature (id INTEGER PRIMARY KEY, swing_id INTEGER NOT NULL REFERENCES swing(id), role INTEGER NOT NULL CHECK (role BETWEEN 0 AND 2),"
        " name TEXT NOT NULL CHECK (name <> ''), licence TEXT NOT NULL, time_utc TEXT NOT NULL, hash TEXT NOT NULL CHECK (length(hash) = 64))",
        "CREATE INDEX signature_by_swing ON signature(swing_id)",
        "CREATE TRIGGER signature_is_kept BEFORE DELETE ON signature BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TRIGGER signature_is_not_changed BEFORE UPDATE ON signature BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TRIGGER signature_is_not_replaced BEFORE INSERT ON signature WHEN EXISTS (SELECT 1 FROM signature WHERE id = NEW.id) BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        // state: 0 open, 1 finished, 2 abandoned
        "CREATE TABLE swing_job (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, swing_id INTEGER NOT NULL UNIQUE REFERENCES swing(id) ON DELETE CASCADE,"
        " plan_json TEXT NOT NULL CHECK (plan_json <> ''), state INTEGER NOT NULL DEFAULT 0 CHECK (state BETWEEN 0 AND 2))",
        "CREATE TABLE job_event (id INTEGER PRIMARY KEY, job_id INTEGER NOT NULL REFERENCES swing_job(id) ON DELETE CASCADE, place INTEGER NOT NULL,"
        " event_json TEXT NOT NULL CHECK (event_json <> ''), UNIQUE (job_id, place))",
        "CREATE TRIGGER job_event_is_not_changed BEFORE UPDATE ON job_event BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TRIGGER job_event_is_not_replaced BEFORE INSERT ON job_event WHEN EXISTS (SELECT 1 FROM job_event WHERE id = NEW.id"
        " OR (job_id = NEW.job_id AND place = NEW.place)) BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TRIGGER signed_job_no_event BEFORE INSERT ON job_event WHEN (SELECT s.state FROM swing s JOIN swing_job j ON j.swing_id = s.id"
        " WHERE j.id = NEW.job_id) = 2 BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
        // Only with the draft that it belongs to; what has been completed keeps how it was made.
        "CREATE TRIGGER job_is_kept BEFORE DELETE ON swing_job WHEN (SELECT state FROM swing WHERE id = OLD.swing_id) > 0 BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "ALTER TABLE site ADD COLUMN owner TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN site_class INTEGER NOT NULL DEFAULT 0 CHECK (site_class BETWEEN 0 AND 2)",
        "ALTER TABLE site ADD COLUMN certificate TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN certificate_expiry TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN painted_variation_deg REAL",
        "ALTER TABLE site ADD COLUMN painted_date TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN survey_date TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN surveyor TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN survey_instrument TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE site ADD COLUMN survey_json TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE aircraft ADD COLUMN base_id INTEGER REFERENCES site(id)",
        "ALTER TABLE compass ADD COLUMN installed TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE event ADD COLUMN cause INTEGER NOT NULL DEFAULT 0 CHECK (cause BETWEEN 0 AND 11)",
        "CREATE TABLE datum_instrument (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE CHECK (name <> ''),"
        " kind INTEGER NOT NULL CHECK (kind BETWEEN 0 AND 8), maker TEXT NOT NULL, serial_number TEXT NOT NULL, calibration_due TEXT NOT NULL,"
        " ahead INTEGER NOT NULL CHECK (ahead BETWEEN 0 AND 1), gives_true INTEGER NOT NULL CHECK (gives_true IN (0, 1)), zero_deg REAL NOT NULL,"
        " resolution_deg REAL NOT NULL CHECK (resolution_deg > 0), note TEXT NOT NULL)",
        "CREATE TABLE due_rule (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE CHECK (name <> ''),"
        " months INTEGER NOT NULL CHECK (months > 0), grace_days INTEGER NOT NULL CHECK (grace_days >= 0), warn_days INTEGER NOT NULL CHECK (warn_days >= 0),"
        " document TEXT NOT NULL, issue TEXT NOT NULL, type_record TEXT NOT NULL)",
        "CREATE TABLE waiver (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, event_id INTEGER NOT NULL REFERENCES event(id), date TEXT NOT NULL,"
        " reason TEXT NOT NULL CHECK (reason <> ''), signed_by TEXT NOT NULL CHECK (signed_by <> ''))",
        "CREATE INDEX waiver_by_event ON waiver(event_id)",
        "CREATE TRIGGER waiver_is_kept BEFORE DELETE ON waiver BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TRIGGER waiver_is_not_changed BEFORE UPDATE ON waiver BEGIN SELECT RAISE(ABORT, 'the record is append-only'); END",
        "CREATE TABLE electrical_swing (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, compass_id INTEGER NOT NULL REFERENCES compass(id),"
        " date TEXT NOT NULL, electrical_json TEXT NOT NULL CHECK (electrical_json <> ''))",
        "CREATE INDEX electrical_by_compass ON electrical_swing(compass_id, date)",
    }};

const Migration kFifth{5, "signatures name the version of what they stand for",
    {
        "ALTER TABLE signature ADD COLUMN contents INTEGER NOT NULL DEFAULT 1 CHECK (contents >= 1)",
    }};

/// The checks of the first step know no "not stated": it is kept beside, and what stands there then is the usual (0).
const Migration kSixth{6, "kind and stage of a swing, kind and resolution of a compass may be not stated",
    {
        "ALTER TABLE swing ADD COLUMN kind_stated INTEGER NOT NULL DEFAULT 1 CHECK (kind_stated IN (0, 1))",
        "ALTER TABLE swing ADD COLUMN stage_stated INTEGER NOT NULL DEFAULT 1 CHECK (stage_stated IN (0, 1))",
        "ALTER TABLE compass ADD COLUMN kind_stated INTEGER NOT NULL DEFAULT 1 CHECK (kind_stated IN (0, 1))",
        "ALTER TABLE compass ADD COLUMN resolution_stated INTEGER NOT NULL DEFAULT 1 CHECK (resolution_stated IN (0, 1))",
        "CREATE TRIGGER signed_swing_stated_is_frozen BEFORE UPDATE OF kind_stated, stage_stated ON swing WHEN OLD.state = 2"
        " BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
    }};

/// The check of the fourth step knows nine kinds of instrument: a shadow pin stands there as an astrocompass, which it is beside.
const Migration kSeventh{7, "a datum instrument may be a shadow pin",
    {
        "ALTER TABLE datum_instrument ADD COLUMN shadow_pin INTEGER NOT NULL DEFAULT 0 CHECK (shadow_pin IN (0, 1))",
    }};

/// The chain over what is in the trail already.
Result<void> beginTrail(const Database& database)
{
    // Signatures that came with an import had no entry: from here on each has one that names it.
    Statement kept(database,
        "INSERT INTO audit_entry (time_utc, what, record, detail) SELECT ?, 'kept signature', k.record, k.detail"
        " FROM (SELECT s.record, CASE g.role WHEN 0 THEN 'performer' WHEN 1 THEN 'inspector' ELSE 'authority' END || ': ' || g.name || ' ' || g.licence"
        " || ', hash ' || g.hash AS detail, g.id FROM signature g JOIN swing s ON s.id = g.swing_id) k"
        " WHERE NOT EXISTS (SELECT 1 FROM audit_entry a WHERE a.record = k.record AND a.what = 'signed swing' AND a.detail = k.detail) ORDER BY k.id");
    kept << database.clock().nowUtc_ms();
    auto done = kept.run();
    if (done)
        done = beginChain(database);
    if (done)
        done = execute(database,
            "CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit_entry BEGIN SELECT RAISE(ABORT, 'the audit trail is append-only'); END");
    return done;
}

const Migration kEighth{8,
    "the audit trail is a hash chain; signatures keep what they cover, with which key they were given; keys of the station",
    {
        "ALTER TABLE audit_entry ADD COLUMN link TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE audit_entry ADD COLUMN file_link TEXT NOT NULL DEFAULT ''",
        // entries_before: were there when the chain was begun
        "CREATE TABLE audit_head (id INTEGER PRIMARY KEY CHECK (id = 1), file TEXT NOT NULL, entries INTEGER NOT NULL, head TEXT NOT NULL,"
        " entries_before INTEGER NOT NULL, since_utc TEXT NOT NULL)",
        "ALTER TABLE signature ADD COLUMN file TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN file_head TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN record_head TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN particulars TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN key TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN public_key TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE signature ADD COLUMN openpgp TEXT NOT NULL DEFAULT ''",
        "CREATE TABLE signing_key (id INTEGER PRIMARY KEY, fingerprint TEXT NOT NULL UNIQUE CHECK (length(fingerprint) >= 40),"
        " holder TEXT NOT NULL CHECK (holder <> ''), public_key TEXT NOT NULL CHECK (public_key <> ''), added_utc TEXT NOT NULL)",
        "DROP TRIGGER audit_is_not_changed", // made again once the entries have their links
    },
    beginTrail};

/// SQLite gives the number of the newest row again when that is removed. A window that still shows it, or could undo something of it, would
/// then act on another record.
Result<void> giveNoNumberTwice(const Database& database)
{
    for (const char* table : {"aircraft_type", "aircraft", "compass", "event", "swing", "reading", "site", "limits_profile"})
        if (auto done = execute(database,
                QStringLiteral(
                    "CREATE TRIGGER %1_number_is_used AFTER DELETE ON %1 WHEN OLD.id > COALESCE((SELECT MAX(id) FROM %1), 0) BEGIN"
                    " INSERT INTO used_number (name, last) VALUES ('%1', OLD.id)"
                    " ON CONFLICT (name) DO UPDATE SET last = MAX(last, excluded.last); END")
                    .arg(QString::fromLatin1(table)));
            !done)
            return done;
    return {};
}

const Migration kNinth{9,
    "a guided swing keeps what is typed and not stored as a step yet; no number of a record is given twice; a swing has the errors that its readings share",
    {
        // Part of the record, so that it goes wherever its database goes and never to another one; a step that is stored takes it away.
        "CREATE TABLE job_typed (id INTEGER PRIMARY KEY, job_id INTEGER NOT NULL REFERENCES swing_job(id) ON DELETE CASCADE,"
        " field TEXT NOT NULL CHECK (field <> ''), typed TEXT NOT NULL CHECK (typed <> ''), UNIQUE (job_id, field))",
        // last: the greatest number of a row that was removed
        "CREATE TABLE used_number (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, last INTEGER NOT NULL CHECK (typeof(last) = 'integer'))",
        // As in a Swing CSV: A 0.6 B 0.2.
        "ALTER TABLE swing ADD COLUMN shared_error_deg TEXT NOT NULL DEFAULT ''",
        "CREATE TRIGGER signed_swing_shared_error_is_frozen BEFORE UPDATE OF shared_error_deg ON swing WHEN OLD.state = 2"
        " BEGIN SELECT RAISE(ABORT, 'the swing is signed'); END",
    },
    giveNoNumberTwice};

const Migration kTenth{10, "a sensor model is kept with how sure it is; results of a log may be behind its readings",
    {
        // As in a Model JSON; empty: not known.
        "ALTER TABLE sensor_model ADD COLUMN uncertainty_json TEXT NOT NULL DEFAULT ''",
        // Changes of its readings since its results were computed: no keystroke in a log waits for them.
        "ALTER TABLE swing ADD COLUMN results_behind INTEGER NOT NULL DEFAULT 0 CHECK (results_behind >= 0)",
        "CREATE INDEX swing_behind ON swing(id) WHERE results_behind > 0",
    }};

const Migration kEleventh{11, "coil benches of sensors; what was kept of compasses far out as a whole is computed anew",
    {
        "CREATE TABLE coil_bench (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE, compass_id INTEGER NOT NULL REFERENCES compass(id),"
        " date TEXT NOT NULL CHECK (date <> ''), coil_json TEXT NOT NULL CHECK (coil_json <> ''))",
        "CREATE INDEX coil_bench_by_compass ON coil_bench(compass_id, date)",
        // B to E of a compass that is far out as a whole are those of the compass mounted right now: its results are computed anew.
        "UPDATE swing SET results_behind = results_behind + 1, max_abs_deviation_deg = NULL, a_deg = NULL, b_deg = NULL, c_deg = NULL,"
        " d_deg = NULL, e_deg = NULL, status = 0 WHERE abs(a_deg) > 44",
    }};

const Migration kTwelfth{12, "a compass that was not read all around is not in limits: verdicts are given anew",
    {
        // The verdict alone is another: figures stay, and those in limits are judged when the database is opened.
        "UPDATE swing SET results_behind = results_behind + 1 WHERE status = 1",
    }};

} // namespace

const std::vector<Migration>& migrations()
{
    static const std::vector<Migration> steps{
        kFirst, kSecond, kThird, kFourth, kFifth, kSixth, kSeventh, kEighth, kNinth, kTenth, kEleventh, kTwelfth};
    return steps;
}

int schemaVersion() { return migrations().back().version; }

Result<Database> openDatabase(const QString& path, OpenMode mode) { return Database::open(path, mode, migrations()); }

} // namespace lubberline::db
