// A file that is damaged, or was written by another program: in each column of each table one cell after the other is made to hold what
// it should not. Whatever is read then, it is told or unharmed; nothing ends the program.

#include <QDate>

#include "core/due/DueList.h"
#include "core/fleet/FleetSelection.h"
#include "core/format/exchange/Exchange.h"
#include "db/stores/KeyStore.h"
#include "db/stores/PopulationStore.h"
#include "tests/db/SwingStores.h"

namespace lubberline::test {

namespace {

constexpr const char* kBad[] = {"NULL", "''", "'x'", "-1", "99", "1e308", "9e999", "9223372036854775807", "zeroblob(10)", "x'1b5d00ff'",
    "hex(zeroblob(10000))", "'2026-13-45'", "999999999999", "CAST(x'41fffe42' AS TEXT)"};

struct Column {
    std::string table, name;
    [[nodiscard]] QString cell() const { return QString::fromStdString(name); }
};

} // namespace

class DamagedCell : public SwingStores {
protected:
    DamagedCell()
    {
        // A record of every kind.
        Swing swing = worksheetSwing(m_stored);
        swing.field = stampOf("2026-11-20");
        swing.variation_deg = 6.5;
        swing.readings[2].raw = {{46.5, 47.5}, {}, {42, 42}};
        swing.readings[2].extra = {{"gust", "5 kt"}};
        swing.readings[3].exclusion = Exclusion{"a truck passed"};
        const SwingId id = *save(m_swings, swing);
        EXPECT_TRUE(m_jobs.add(id, smallJob(), true));
        EXPECT_TRUE(m_signing.complete(id));
        EXPECT_TRUE(m_signing.sign(id, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
        EXPECT_TRUE(m_signing.sign(id, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
        const EventId event = *save(m_fleet, Event{{}, {}, m_stored.aircraft, "2026-11-21", "struck", DueCause::Lightning, ""});
        EXPECT_TRUE(event.valid());
        db::DueStore due(m_database);
        EXPECT_TRUE(
            save(due, Waiver{newRecordId(), m_fleet.eventsOf(m_stored.aircraft)->front().record, "2026-11-22", "two headings", "Cleo"}));
        EXPECT_TRUE(save(due, DueRule{{}, "two years", 24, 0, 30, "TO 5N3", "1", m_fleet.type(m_stored.type)->record}));
        EXPECT_TRUE(save(db::SensorStore(m_database), sensorOf(m_stored)));
        db::SiteStore sites(m_database);
        DatumInstrument instrument;
        instrument.record = newRecordId();
        instrument.name = "B-16";
        EXPECT_TRUE(save(sites, instrument));
        Site site = **sites.site(m_stored.site);
        site.latitude_deg = 51.55;
        site.longitude_deg = 21.89;
        site.survey = {{0, 0, 1, 6.5, 49000}};
        EXPECT_TRUE(save(sites, site));
        ElectricalSwing electrical;
        electrical.date = "2026-11-20";
        EXPECT_TRUE(save(db::ElectricalStore(m_database), m_stored.compass, electrical));
        EXPECT_TRUE(db::CoilStore(m_database).add(m_stored.compass, coilBenchOn("2026-01-01")));
        EXPECT_TRUE(db::execute(m_database, "INSERT INTO job_typed (job_id, field, typed) VALUES (1, 'guidedDatum', '44')"));
        EXPECT_TRUE(db::KeyStore(m_database).put({std::string(40, 'A'), "Ada", "a public key", ""}));
        EXPECT_TRUE(m_swings.remove(draft())); // its number is used
        // Another program holds itself to none of our rules.
        for (const char* sql : {"PRAGMA foreign_keys = OFF", "PRAGMA ignore_check_constraints = ON"})
            EXPECT_TRUE(db::execute(m_database, sql));
        for (const auto& trigger : texts("SELECT name FROM sqlite_master WHERE type = 'trigger'"))
            EXPECT_TRUE(db::execute(m_database, QString::fromStdString("DROP TRIGGER " + trigger)));
        for (const char* sql : {"PRAGMA writable_schema = ON",
                 "UPDATE sqlite_master SET sql = replace(sql, ' NOT NULL', '') WHERE type = 'table'", "PRAGMA writable_schema = RESET"})
            EXPECT_TRUE(db::execute(m_database, sql));
    }

    std::vector<std::string> texts(const QString& sql)
    {
        db::Statement statement(m_database, sql);
        return *db::rowsOf<std::string>(statement, [](db::Statement& row) { return row.anything(0); });
    }

    std::vector<Column> columns()
    {
        std::vector<Column> all;
        for (const auto& table : texts("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"))
            for (const auto& column : texts(QString::fromStdString("SELECT name FROM pragma_table_info('" + table + "')")))
                all.push_back({table, column});
        return all;
    }

    /// Everything that pages and commands read. @return how many of them told a fault.
    int read()
    {
        int faults = 0;
        const auto tell = [&](const auto& result) {
            faults += result ? 0 : 1;
            if (!result) {
                EXPECT_FALSE(describe(result.error()).empty());
            }
            return result.ok();
        };
        tell(m_fleet.totals());
        if (const auto types = m_fleet.types(); tell(types))
            for (const auto& type : *types)
                if (const auto aircraft = m_fleet.aircraftOf(type.id); tell(aircraft))
                    for (const auto& one : *aircraft) {
                        tell(m_fleet.aircraft(one.id));
                        tell(m_fleet.eventsOf(one.id));
                        if (const auto compasses = m_fleet.compassesOf(one.id); tell(compasses))
                            for (const auto& compass : *compasses)
                                readCompass(compass.id, tell);
                    }
        tell(m_fleet.search("standby 2026", 10));
        db::SiteStore sites(m_database);
        tell(sites.sites());
        tell(sites.limitsProfiles());
        tell(sites.instruments());
        tell(m_jobs.open());
        db::DueStore due(m_database);
        if (const auto compasses = due.compasses(); tell(compasses))
            if (const auto rules = due.rules(); tell(rules))
                (void)dueList(*compasses, *rules, {}, "2026-11-27");
        tell(db::PopulationStore(m_database).columns(FleetSelection{}, {}));
        if (const auto fleet = db::exportFleet(m_database, {}, {}); tell(fleet)) {
            EXPECT_TRUE(readExchange(writeExchange(*fleet), "again")); // what is written can be read
        }
        return faults;
    }

    template <class Tell>
    void readCompass(CompassId id, Tell tell)
    {
        tell(m_fleet.compass(id));
        tell(db::SensorStore(m_database).of(id));
        tell(db::ElectricalStore(m_database).of(id));
        tell(db::CoilStore(m_database).of(id));
        if (const auto swings = m_swings.swingsOf(id); tell(swings))
            for (const auto& swing : *swings) {
                tell(m_swings.previous(swing.id));
                tell(m_jobs.typed(swing.id));
                tell(m_signing.hold(swing.id));
                if (const auto named = m_swings.recordOf(swing.id); tell(named))
                    tell(m_signing.auditOf(*named));
                if (const auto record = m_swings.record(swing.id); tell(record)) {
                    (void)m_results.resultOf(*record);
                    (void)m_results.placeOf(*record);
                }
            }
    }
};

TEST_F(DamagedCell, isToldWhateverItHolds)
{
    ASSERT_EQ(read(), 0);
    const auto whole = db::verify(m_database, {});
    ASSERT_THAT(inEnglish(whole->findings), testing::IsEmpty());
    int changed = 0, told = 0;
    std::size_t next = 0;
    for (const auto& [table, column] : columns()) {
        const QString set = QString::fromStdString("UPDATE " + table + " SET " + column + " = ");
        const QString row = QString::fromStdString(texts(QString::fromStdString("SELECT MIN(rowid) FROM " + table)).front());
        const QString where = " WHERE rowid = " + row;
        ASSERT_NE(texts(QString::fromStdString("SELECT COUNT(*) FROM " + table)).front(), "0") << table << " has no row to damage";
        ASSERT_TRUE(db::execute(
            m_database, QString::fromStdString("CREATE TEMP TABLE kept AS SELECT " + column + " AS value FROM " + table) + where));
        for (std::size_t turn = 0; turn < 2; ++turn) { // each value in many columns; all of them in each would take minutes
            const char* const value = kBad[next++ * 5 % std::size(kBad)];
            if (!db::execute(m_database, set + value + where))
                continue; // SQLite itself refuses it: a row number that is no number, a name that is there
            ++changed;
            SCOPED_TRACE(table + "." + column + " = " + value);
            const int faults = read();
            const auto report = db::verify(m_database, {});
            ASSERT_TRUE(report) << describe(report.error());
            told += report->findings.empty() ? 0 : 1;
            if (faults > 0) {
                EXPECT_THAT(report->findings, testing::Not(testing::IsEmpty())) << "a page tells what verify does not";
            }
            const QString now = column == "id" ? QStringLiteral(" WHERE rowid = ") + value : where; // a row's number is how it is found
            ASSERT_TRUE(db::execute(m_database, set + "(SELECT value FROM kept)" + now));
        }
        ASSERT_TRUE(db::execute(m_database, "DROP TABLE kept"));
    }
    EXPECT_GT(changed, 200);
    EXPECT_GT(told, changed / 2); // the rest are texts, which may be 'x', and whole numbers that fit
    EXPECT_EQ(read(), 0) << "the test puts back what it changed";
}

TEST_F(DamagedCell, isNamedWithItsTableRowAndColumn)
{
    const std::pair<const char*, const char*> damages[] = {
        {"UPDATE swing SET kind = 99", "swing.kind, row 1: 99 is stored; expected a whole number from 0 to 3"},
        {"UPDATE swing SET record = 'x'", "swing.record, row 1: \"x\" is stored; expected a record id"},
        {"UPDATE reading SET compass_heading_deg = 9e999 WHERE id = 3",
            "reading.compass_heading_deg, row 3: an infinite number is stored; expected a number from 0 to 360"},
        {"UPDATE site SET latitude_deg = 'north'", "site.latitude_deg, row 1: \"north\" is stored; expected a number from -90 to 90"},
        {"UPDATE event SET date = '2026-02-30'", "event.date, row 1: \"2026-02-30\" is stored; expected a day of the calendar"},
        {"UPDATE compass SET name = zeroblob(3)", "compass.name, row 1: a block of 3 bytes is stored; expected a text"},
        {"UPDATE signature SET role = -1", "signature.role, row 1: -1 is stored; expected a whole number from 0 to 2"},
        {"UPDATE aircraft SET note = CAST(x'41fffe' AS TEXT)", "aircraft.note, row 1: the byte 0xFF behind \"A\" is not UTF-8"},
        {"UPDATE reading SET time_utc = 'half past nine' WHERE id = 2",
            "reading.time_utc, row 2: \"half past nine\" is stored; expected a moment of UTC as YYYY-MM-DDTHH:MM:SSZ"},
        {"UPDATE reading SET time_utc = '2026-11-20T25:00:00Z' WHERE id = 2",
            "reading.time_utc, row 2: \"2026-11-20T25:00:00Z\" is stored; expected a moment of UTC"},
        {"UPDATE swing SET start_utc = '2026-13-45'", "swing.start_utc, row 1: \"2026-13-45\" is stored; expected a moment of UTC"},
        {"UPDATE swing SET end_utc = '2026-11-20T09:00:00+02:00'", "swing.end_utc, row 1: \"2026-11-20T09:00:00+02:00\" is stored"},
        {"UPDATE signature SET time_utc = 'x'", "signature.time_utc, row 1: \"x\" is stored; expected a moment of UTC"},
        {"UPDATE audit_entry SET time_utc = '' WHERE id = 1", "audit_entry.time_utc, row 1: \"\" is stored; expected a moment of UTC"},
        {"UPDATE audit_head SET since_utc = 'today'", "audit_head.since_utc, row 1: \"today\" is stored; expected a moment of UTC"},
        {"UPDATE signing_key SET added_utc = '-1'", "signing_key.added_utc, row 1: \"-1\" is stored; expected a moment of UTC"},
        {"UPDATE signing_key SET fingerprint = replace(fingerprint, 'A', 'z')",
            "signing_key.fingerprint, row 1: \"zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz\" is stored; expected 40 or 64 capital hexadecimal digits"},
        {"UPDATE swing SET site_id = 77", "foreign key: a row of swing (1) refers to a missing row of site"},
    };
    for (const auto& [sql, words] : damages) {
        const QString column = QString(sql).section(' ', 3, 3), table = QString(sql).section(' ', 1, 1);
        ASSERT_TRUE(db::execute(m_database, "CREATE TEMP TABLE kept AS SELECT rowid AS number, " + column + " AS value FROM " + table));
        ASSERT_TRUE(db::execute(m_database, sql));
        EXPECT_THAT(inEnglish(db::verify(m_database, {})->findings), testing::Contains(testing::HasSubstr(words))) << sql;
        ASSERT_TRUE(db::execute(
            m_database, "UPDATE " + table + " SET " + column + " = (SELECT value FROM kept WHERE number = " + table + ".rowid)"));
        ASSERT_TRUE(db::execute(m_database, "DROP TABLE kept"));
    }
}

TEST_F(DamagedCell, allOfThemAreListed)
{
    for (const char* sql : {"UPDATE swing SET variation_deg = 'x'", "UPDATE reading SET pitch_deg = 'steep' WHERE id IN (2, 5)",
             "UPDATE compass SET kind = 7", "UPDATE due_rule SET months = 1e9"})
        ASSERT_TRUE(db::execute(m_database, sql));
    const auto findings = inEnglish(db::verify(m_database, {})->findings);
    for (const char* place : {"swing.variation_deg, row 1", "reading.pitch_deg, row 2", "reading.pitch_deg, row 5", "compass.kind, row 1",
             "due_rule.months, row 1"})
        EXPECT_THAT(findings, testing::Contains(testing::HasSubstr(place)));
}

TEST_F(DamagedCell, aListShowsWhatCanBeShown)
{
    ASSERT_TRUE(db::execute(m_database, "UPDATE swing SET status = 'x', date = '2026-99-99'"));
    const SwingId other = draft();
    const auto rows = m_swings.swingsOf(m_stored.compass);
    ASSERT_TRUE(rows) << describe(rows.error());
    ASSERT_EQ(rows->size(), 2u);
    EXPECT_THAT(*rows, testing::Contains(testing::Field(&SwingRow::id, other)));
    EXPECT_THAT(inEnglish(db::listDamages(m_database)), testing::Contains(testing::HasSubstr("swing.date, row 1")));
    ASSERT_TRUE(db::execute(m_database, "UPDATE compass SET name = zeroblob(2)"));
    EXPECT_EQ(m_fleet.compassesOf(m_stored.aircraft)->size(), 1u);
}

TEST_F(DamagedCell, whatCouldNotBeReadAgainIsNotStored)
{
    Site site = **db::SiteStore(m_database).site(m_stored.site);
    site.latitude_deg = 95;
    const auto refused = save(db::SiteStore(m_database), site);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(describe(refused.error()), testing::HasSubstr("site.latitude_deg, row 1: 95 is stored; expected a number from -90 to 90"));
    EXPECT_EQ((*db::SiteStore(m_database).site(m_stored.site))->latitude_deg, 51.55);
    Swing swing = *m_swings.swing(draft());
    swing.configuration.other = std::string(20'000, 'x');
    EXPECT_EQ(save(m_swings, swing).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(m_swings
                  .insertReading(swing.id, 0,
                      [] {
                          Reading long_;
                          long_.note = std::string(20'000, 'x');
                          return long_;
                      }())
                  .error()
                  .code,
        ErrorCode::InvalidInput);
}

TEST_F(DamagedCell, aBackupOfADamagedFileSaysSo)
{
    const QTemporaryDir folder;
    const QString copy = folder.filePath("copy.db");
    ASSERT_TRUE(db::execute(m_database, "UPDATE swing SET kind = 99"));
    const auto done = db::backup(m_database, copy);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::Corrupt);
    EXPECT_THAT(describe(done.error()), testing::HasSubstr("swing.kind"));
    EXPECT_TRUE(QFile::exists(copy)); // better than none
}

} // namespace lubberline::test
