#include "db/SiteRepository.h"

#include "core/format/exchange/RampJson.h"
#include "db/ResultCache.h"
#include "db/Saving.h"

namespace lubberline::db {

namespace {

const Table& siteTable()
{
    static const Table table{"site", "site",
        {"name", "latitude_deg", "longitude_deg", "elevation_m", "variation_deg", "variation_source", "note", "owner", "site_class",
            "certificate", "certificate_expiry", "painted_variation_deg", "painted_date", "survey_date", "surveyor", "survey_instrument",
            "survey_json"}};
    return table;
}

const Table& limitsTable()
{
    static const Table table{
        "limits profile", "limits_profile", {"name", "document", "issue", "scope", "max_deviation_deg", "max_spread_deg"}};
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
    site.certificateExpiry = row.text(12);
    site.paintedVariation_deg = row.optionalReal(13);
    site.paintedDate = row.text(14);
    site.surveyDate = row.text(15);
    site.surveyor = row.text(16);
    site.surveyInstrument = row.text(17);
    const std::string points = row.text(18);
    if (points.empty())
        return site;
    auto survey = readSurvey(points, database.path().toStdString());
    if (!survey)
        return Error{ErrorCode::Corrupt, "the survey of the site " + site.name + " does not read: " + survey.error().message,
            database.path().toStdString()};
    site.survey = std::move(*survey);
    return site;
}

LimitsProfile limitsFrom(const Statement& row)
{
    return {row.id<LimitsProfileId>(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5), row.optionalReal(6),
        row.optionalReal(7)};
}

} // namespace

Result<std::vector<Site>> SiteRepository::sites()
{
    Statement statement(m_database, selectSite() + "ORDER BY name");
    return wholeRows(rowsOf<Result<Site>>(statement, [this](Statement& row) { return siteFrom(row, m_database); }));
}

Result<std::vector<LimitsProfile>> SiteRepository::limitsProfiles()
{
    Statement statement(m_database, selectLimits() + "ORDER BY name");
    return rowsOf<LimitsProfile>(statement, limitsFrom);
}

Result<std::optional<Site>> SiteRepository::site(SiteId id)
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

Result<std::optional<LimitsProfile>> SiteRepository::limitsOf(CompassId compass)
{
    Statement statement(m_database, selectLimits() + "WHERE id = (SELECT limits_id FROM compass WHERE id = ?)");
    statement << compass;
    return firstOf<LimitsProfile>(statement, limitsFrom);
}

Result<SiteId> SiteRepository::save(const Site& site)
{
    if (const auto named = requireName(site.name, "the name of the site"); !named)
        return named.error();
    return saveRecord(m_database, siteTable(), site.id, site.record, [&](Statement& statement) {
        statement << site.name << site.latitude_deg << site.longitude_deg << site.elevation_m << site.variation_deg << site.variationSource
                  << site.note << site.owner << static_cast<int>(site.siteClass) << site.certificate << site.certificateExpiry
                  << site.paintedVariation_deg << site.paintedDate << site.surveyDate << site.surveyor << site.surveyInstrument
                  << (site.survey.empty() ? std::string() : writeSurvey(site.survey));
    });
}

Result<LimitsProfileId> SiteRepository::save(const LimitsProfile& profile)
{
    if (const auto named = requireName(profile.name, "the name of the limits profile"); !named)
        return named.error();
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto saved = saveRecord(m_database, limitsTable(), profile.id, profile.record, [&](Statement& statement) {
        statement << profile.name << profile.document << profile.issue << profile.scope << profile.maxDeviation_deg
                  << profile.maxSpread_deg;
    });
    if (!saved)
        return saved.error();
    if (profile.id.valid())
        if (const auto refreshed = refreshSwingsUnder(m_database, profile.id); !refreshed)
            return refreshed.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return *saved;
}

} // namespace lubberline::db
