#include "db/SiteRepository.h"

#include "db/ResultCache.h"
#include "db/Saving.h"

namespace lubberline::db {

Result<std::vector<Site>> SiteRepository::sites()
{
    Statement row(m_database, "SELECT id, record, name, latitude_deg, longitude_deg, elevation_m, variation_deg, variation_source, note FROM site ORDER BY name");
    if (const auto done = row.run(); !done)
        return done.error();
    std::vector<Site> sites;
    while (row.next())
        sites.push_back({row.id<SiteId>(0), row.text(1), row.text(2), row.optionalReal(3), row.optionalReal(4), row.optionalReal(5), row.optionalReal(6),
            row.text(7), row.text(8)});
    return sites;
}

Result<std::vector<LimitsProfile>> SiteRepository::limitsProfiles()
{
    Statement row(m_database, "SELECT id, record, name, document, issue, scope, max_deviation_deg, max_spread_deg FROM limits_profile ORDER BY name");
    if (const auto done = row.run(); !done)
        return done.error();
    std::vector<LimitsProfile> profiles;
    while (row.next())
        profiles.push_back({row.id<LimitsProfileId>(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5), row.optionalReal(6), row.optionalReal(7)});
    return profiles;
}

Result<SiteId> SiteRepository::save(const Site& site)
{
    if (const auto named = requireName(site.name, "the site"); !named)
        return named.error();
    return saveRecord(m_database, "site", site.id, site.record, site.name,
        "INSERT INTO site (record, name, latitude_deg, longitude_deg, elevation_m, variation_deg, variation_source, note) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        "UPDATE site SET name = ?, latitude_deg = ?, longitude_deg = ?, elevation_m = ?, variation_deg = ?, variation_source = ?, note = ? WHERE id = ?",
        [&](Statement& statement) {
            statement << site.name << site.latitude_deg << site.longitude_deg << site.elevation_m << site.variation_deg << site.variationSource << site.note;
        });
}

Result<LimitsProfileId> SiteRepository::save(const LimitsProfile& profile)
{
    if (const auto named = requireName(profile.name, "the limits profile"); !named)
        return named.error();
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto saved = saveRecord(m_database, "limits profile", profile.id, profile.record, profile.name,
        "INSERT INTO limits_profile (record, name, document, issue, scope, max_deviation_deg, max_spread_deg) VALUES (?, ?, ?, ?, ?, ?, ?)",
        "UPDATE limits_profile SET name = ?, document = ?, issue = ?, scope = ?, max_deviation_deg = ?, max_spread_deg = ? WHERE id = ?",
        [&](Statement& statement) {
            statement << profile.name << profile.document << profile.issue << profile.scope << profile.maxDeviation_deg << profile.maxSpread_deg;
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
