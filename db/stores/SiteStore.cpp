#include "db/stores/SiteStore.h"

#include "core/format/exchange/SiteJson.h"
#include "db/stores/ResultCache.h"
#include "db/stores/Saving.h"

namespace lubberline::db {

namespace {

const Table& siteTable()
{
    static const Table table{MARKED("db", "site"), "site",
        {"name", "latitude_deg", "longitude_deg", "elevation_m", "variation_deg", "variation_source", "note", "owner", "site_class",
            "certificate", "certificate_expiry", "painted_variation_deg", "painted_date", "survey_date", "surveyor", "survey_instrument",
            "survey_json"}};
    return table;
}

const Table& limitsTable()
{
    static const Table table{
        MARKED("db", "limits profile"), "limits_profile", {"name", "document", "issue", "scope", "max_deviation_deg", "max_spread_deg"}};
    return table;
}

QString selectSite() { return "SELECT id, record, " + siteTable().fields.join(", ") + " FROM site "; }
QString selectLimits() { return "SELECT id, record, " + limitsTable().fields.join(", ") + " FROM limits_profile "; }

/// Errors: Corrupt (a survey that does not read).
Result<Site> siteFrom(const Statement& row, const Database& database)
{
    Site site{row.id<SiteId>(0), row.text(1), row.text(2), row.optionalReal(3), row.optionalReal(4), row.optionalReal(5),
        row.optionalReal(6), row.text(7), row.text(8)};
    site.owner = row.text(9);
    site.siteClass = row.as<SiteClass>(10);
    site.certificate = row.text(11);
    site.certificateExpiry = row.day(12);
    site.paintedVariation_deg = row.optionalReal(13);
    site.paintedDate = row.day(14);
    site.surveyDate = row.day(15);
    site.surveyor = row.text(16);
    site.surveyInstrument = row.text(17);
    const std::string points = row.text(18);
    if (points.empty())
        return site;
    auto survey = readSurvey(points, database.path().toStdString());
    if (!survey)
        return Error{ErrorCode::Corrupt, {MARKED("db", "the survey of the site %1 does not read: %2"), site.name, survey.error().message},
            database.path().toStdString()};
    site.survey = std::move(*survey);
    return site;
}

LimitsProfile limitsFrom(const Statement& row)
{
    return {row.id<LimitsProfileId>(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5), row.optionalReal(6),
        row.optionalReal(7)};
}

void bindSite(Statement& statement, const Site& site)
{
    statement << site.name << site.latitude_deg << site.longitude_deg << site.elevation_m << site.variation_deg << site.variationSource
              << site.note << site.owner << static_cast<int>(site.siteClass) << site.certificate << site.certificateExpiry
              << site.paintedVariation_deg << site.paintedDate << site.surveyDate << site.surveyor << site.surveyInstrument
              << (site.survey.empty() ? std::string() : writeSurvey(site.survey));
}

void bindLimits(Statement& statement, const LimitsProfile& profile)
{
    statement << profile.name << profile.document << profile.issue << profile.scope << profile.maxDeviation_deg << profile.maxSpread_deg;
}

const Table& instrumentTable()
{
    static const Table table{MARKED("db", "datum instrument"), "datum_instrument",
        {"name", "kind", "maker", "serial_number", "calibration_due", "ahead", "gives_true", "zero_deg", "resolution_deg", "note",
            "shadow_pin"}};
    return table;
}

void bindInstrument(Statement& statement, const DatumInstrument& instrument)
{
    const bool pin = instrument.kind == DatumKind::ShadowPin; // see the seventh step of the schema
    statement << instrument.name << static_cast<int>(pin ? DatumKind::Astrocompass : instrument.kind) << instrument.maker
              << instrument.serialNumber << instrument.calibrationDue << static_cast<int>(instrument.ahead) << instrument.givesTrue
              << instrument.zero_deg << instrument.resolution_deg << instrument.note << pin;
}

} // namespace

Result<std::vector<Site>> SiteStore::sites()
{
    Statement statement(m_database, selectSite() + "ORDER BY name");
    return wholeRows(rowsOf<Result<Site>>(statement, [this](Statement& row) { return siteFrom(row, m_database); }));
}

Result<std::vector<LimitsProfile>> SiteStore::limitsProfiles()
{
    Statement statement(m_database, selectLimits() + "ORDER BY name");
    return rowsOf<LimitsProfile>(statement, limitsFrom);
}

Result<std::optional<Site>> SiteStore::site(SiteId id)
{
    Statement statement(m_database, selectSite() + "WHERE id = ?");
    statement << id;
    auto found = firstOf<Result<Site>>(statement, [this](Statement& row) { return siteFrom(row, m_database); });
    if (!found)
        return found.error();
    if (!*found)
        return std::optional<Site>{};
    if (!**found)
        return (*found)->error();
    return std::optional(std::move((**found).value()));
}

Result<std::optional<LimitsProfile>> SiteStore::limitsOf(CompassId compass)
{
    Statement statement(m_database, selectLimits() + "WHERE id = (SELECT limits_id FROM compass WHERE id = ?)");
    statement << compass;
    return firstOf<LimitsProfile>(statement, limitsFrom);
}

Result<std::vector<DatumInstrument>> SiteStore::instruments()
{
    Statement statement(m_database, "SELECT record, " + instrumentTable().fields.join(", ") + " FROM datum_instrument ORDER BY name");
    return rowsOf<DatumInstrument>(statement, [](Statement& row) {
        return DatumInstrument{row.text(0), row.text(1), row.integer(11) != 0 ? DatumKind::ShadowPin : row.as<DatumKind>(2), row.text(3),
            row.text(4), row.day(5), row.as<SightingDirection>(6), row.integer(7) != 0, row.real(8), row.real(9), row.text(10)};
    });
}

Result<SiteId> SiteStore::add(const Site& site)
{
    if (const auto named = requireName(site.name, MARKED("db", "the name of the site")); !named)
        return named.error();
    return noting(
        m_database, [&] { return addRecord<SiteId>(m_database, siteTable(), site, bindSite); }, [&](SiteId) { noteSites(); });
}

Result<void> SiteStore::change(const Site& known, const Site& site)
{
    if (const auto named = requireName(site.name, MARKED("db", "the name of the site")); !named)
        return named.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, siteTable(), site.id, known, site, bindSite); }, [&] { noteSites(); });
}

Result<LimitsProfileId> SiteStore::add(const LimitsProfile& profile)
{
    if (const auto named = requireName(profile.name, MARKED("db", "the name of the limits profile")); !named)
        return named.error();
    return noting(
        m_database, [&] { return addRecord<LimitsProfileId>(m_database, limitsTable(), profile, bindLimits); },
        [&](LimitsProfileId) { noteSites(); });
}

Result<void> SiteStore::change(const LimitsProfile& known, const LimitsProfile& profile)
{
    if (const auto named = requireName(profile.name, MARKED("db", "the name of the limits profile")); !named)
        return named.error();
    const auto store = [&]() -> Result<void> {
        if (auto changed = changeRecord(m_database, limitsTable(), profile.id, known, profile, bindLimits); !changed)
            return changed;
        return refreshSwingsUnder(m_database, profile.id);
    };
    return noting(m_database, store, [&] {
        noteSites();
        m_database.changes().note(change::Fleet{}); // what is in limits may be other
    });
}

Result<RecordId> SiteStore::add(const DatumInstrument& instrument)
{
    if (const auto named = requireName(instrument.name, MARKED("db", "the name of the instrument")); !named)
        return named.error();
    DatumInstrument whole = instrument;
    if (whole.record.empty())
        whole.record = newRecordId();
    const auto store = [&]() -> Result<RecordId> {
        const auto added = addRecord<RowId>(m_database, instrumentTable(), whole, bindInstrument);
        return added ? Result<RecordId>(whole.record) : added.error();
    };
    return noting(m_database, store, [&](const RecordId&) { noteSites(); });
}

Result<void> SiteStore::change(const DatumInstrument& known, const DatumInstrument& instrument)
{
    if (const auto named = requireName(instrument.name, MARKED("db", "the name of the instrument")); !named)
        return named.error();
    const auto id = rowWith(m_database, instrumentTable(), known.record);
    if (!id)
        return id.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, instrumentTable(), *id, known, instrument, bindInstrument); },
        [&] { noteSites(); });
}

Result<void> SiteStore::removeInstrument(const RecordId& record)
{
    return noting(
        m_database, [&] { return removeRecord(m_database, instrumentTable(), record); }, [&] { noteSites(); });
}

Result<void> SiteStore::removeSite(const RecordId& record)
{
    return noting(
        m_database, [&] { return removeRecord(m_database, siteTable(), record); }, [&] { noteSites(); });
}

void SiteStore::noteSites() { m_database.changes().note(change::Sites{}); }

} // namespace lubberline::db
