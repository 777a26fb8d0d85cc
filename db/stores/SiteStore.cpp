#include "db/stores/SiteStore.h"

#include "core/format/exchange/SiteJson.h"
#include "core/record/Ranges.h"
#include "db/saving/Saving.h"
#include "db/stores/ResultCache.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

Site siteFrom(const Statement& row)
{
    Site site{row.id<SiteId>(0), row.record(1), row.name(2), row.optionalReal(3, kLatitudeRange), row.optionalReal(4, kSignedAngleRange),
        row.optionalReal(5, kElevationRange), row.optionalReal(6, kSignedAngleRange), row.text(7), row.text(8)};
    site.owner = row.text(9);
    site.siteClass = row.as(10, SiteClass::Class2);
    site.certificate = row.text(11);
    site.certificateExpiry = row.day(12);
    site.paintedVariation_deg = row.optionalReal(13, kSignedAngleRange);
    site.paintedDate = row.day(14);
    site.surveyDate = row.day(15);
    site.surveyor = row.text(16);
    site.surveyInstrument = row.text(17);
    const std::string points = row.longText(18);
    if (points.empty())
        return site;
    if (auto survey = readSurvey(points, {}))
        site.survey = std::move(*survey);
    else
        row.damages(18, survey.error());
    return site;
}

LimitsProfile limitsFrom(const Statement& row)
{
    return {row.id<LimitsProfileId>(0), row.record(1), row.name(2), row.text(3), row.text(4), row.text(5),
        row.optionalReal(6, kPositiveRange), row.optionalReal(7, kPositiveRange)};
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

DatumInstrument instrumentFrom(const Statement& row)
{
    const auto kind = row.as(3, DatumKind::ElectricalCalibrator);
    return {row.record(1), row.name(2), row.flag(12) ? DatumKind::ShadowPin : kind, row.text(4), row.text(5), row.day(6),
        row.as(7, SightingDirection::Reciprocal), row.flag(8), row.real(9, kFigureRange), row.real(10, kInstrumentResolutionRange),
        row.text(11)};
}

void bindInstrument(Statement& statement, const DatumInstrument& instrument)
{
    const bool pin = instrument.kind == DatumKind::ShadowPin; // see the seventh step of the schema
    statement << instrument.name << static_cast<int>(pin ? DatumKind::Astrocompass : instrument.kind) << instrument.maker
              << instrument.serialNumber << instrument.calibrationDue << static_cast<int>(instrument.ahead) << instrument.givesTrue
              << instrument.zero_deg << instrument.resolution_deg << instrument.note << pin;
}

} // namespace

const Table& siteTable()
{
    static const Table table{MARKED("db", "site"), "site",
        {"name", "latitude_deg", "longitude_deg", "elevation_m", "variation_deg", "variation_source", "note", "owner", "site_class",
            "certificate", "certificate_expiry", "painted_variation_deg", "painted_date", "survey_date", "surveyor", "survey_instrument",
            "survey_json"},
        [](const Statement& row) { (void)siteFrom(row); }};
    return table;
}

const Table& limitsTable()
{
    static const Table table{MARKED("db", "limits profile"), "limits_profile",
        {"name", "document", "issue", "scope", "max_deviation_deg", "max_spread_deg"}, [](const Statement& row) { (void)limitsFrom(row); }};
    return table;
}

const Table& instrumentTable()
{
    static const Table table{MARKED("db", "datum instrument"), "datum_instrument",
        {"name", "kind", "maker", "serial_number", "calibration_due", "ahead", "gives_true", "zero_deg", "resolution_deg", "note",
            "shadow_pin"},
        [](const Statement& row) { (void)instrumentFrom(row); }};
    return table;
}

Result<std::vector<Site>> SiteStore::sites()
{
    Statement statement(m_database, selectFrom(siteTable()) + "ORDER BY name");
    return rowsOf<Site>(statement, siteFrom);
}

Result<std::vector<LimitsProfile>> SiteStore::limitsProfiles()
{
    Statement statement(m_database, selectFrom(limitsTable()) + "ORDER BY name");
    return rowsOf<LimitsProfile>(statement, limitsFrom);
}

Result<std::optional<Site>> SiteStore::site(SiteId id)
{
    Statement statement(m_database, selectFrom(siteTable()) + "WHERE id = ?");
    statement << id;
    return firstOf<Site>(statement, siteFrom);
}

Result<std::optional<LimitsProfile>> SiteStore::limitsOf(CompassId compass)
{
    Statement statement(m_database, selectFrom(limitsTable()) + "WHERE id = (SELECT limits_id FROM compass WHERE id = ?)");
    statement << compass;
    return firstOf<LimitsProfile>(statement, limitsFrom);
}

Result<std::vector<DatumInstrument>> SiteStore::instruments()
{
    Statement statement(m_database, selectFrom(instrumentTable()) + "ORDER BY name");
    return rowsOf<DatumInstrument>(statement, instrumentFrom);
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
