// The tables of a fleet as CSV.

#include <cmath>

#include "core/base/Number.h"
#include "core/format/csv/TextCell.h"
#include "core/format/results/FleetFigures.h"
#include "core/format/results/FleetJson.h"
#include "core/format/results/ResultFigures.h"

namespace lubberline {

namespace {

/// One table of the CSV.
class Rows {
public:
    Rows(std::string& csv, const char* name, const char* head) : m_csv(csv)
    {
        if (!csv.empty())
            csv += '\n';
        csv += std::string("# ") + name + '\n' + head + '\n';
    }
    Rows& operator<<(const std::string& text)
    {
        cell();
        m_csv += csvTextCell(text);
        return *this;
    }
    Rows& operator<<(const std::optional<double>& value)
    {
        return plain(value && std::isfinite(*value) ? shortestNumber(toTenDecimals(*value)) : std::string());
    }
    Rows& operator<<(double value) { return *this << std::optional(value); }
    Rows& operator<<(std::int64_t count) { return plain(std::to_string(count)); }
    Rows& operator<<(int count) { return plain(std::to_string(count)); }
    void end()
    {
        m_csv += '\n';
        m_first = true;
    }

private:
    Rows& plain(const std::string& figure)
    {
        cell();
        m_csv += figure;
        return *this;
    }
    void cell()
    {
        if (!m_first)
            m_csv += ',';
        m_first = false;
    }
    std::string& m_csv;
    bool m_first = true;
};

void selectionRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "selection", "aircraft,compasses,swings,used");
    rows << report.counts.aircraft << report.counts.compasses << report.counts.swings << report.counts.used;
    rows.end();
    Rows left(csv, "left out", "reason,swings");
    for (const auto& each : report.counts.leftOut) {
        left << each.reason << each.swings;
        left.end();
    }
}

void patternRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "pattern",
        "heading_deg,aircraft,mean_deg,standard_deviation_deg,between_aircraft_deg,percentile_5_deg,percentile_50_deg,percentile_95_deg");
    for (const auto& p : report.pattern.points) {
        rows << p.heading_deg << p.units << p.mean_deg << p.standardDeviation_deg << p.between_deg << p.percentile5_deg
             << p.percentile50_deg << p.percentile95_deg;
        rows.end();
    }
}

void coefficientRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "coefficients",
        "coefficient,aircraft,mean_deg,standard_error_deg,standard_deviation_deg,between_aircraft_deg,percentile_5_deg,percentile_50_deg,percentile_95_deg");
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const auto& s = report.pattern.coefficients[c];
        rows << letterAt(c) << s.units << s.mean_deg << s.standardError_deg << s.standardDeviation_deg << s.between_deg << s.percentile5_deg
             << s.percentile50_deg << s.percentile95_deg;
        rows.end();
    }
}

void harmonicRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "harmonics", "of,order,sin_deg,cos_deg,amplitude_deg,phase_deg");
    for (const auto& [name, orders] : {std::pair("mean", &report.pattern.mean), std::pair("standard deviation", &report.pattern.spread),
             std::pair("mean as found", &report.found), std::pair("mean as left", &report.left)})
        for (const auto& o : *orders) {
            rows << std::string(name) << o.order << toDegrees(o.sin_rad) << toDegrees(o.cos_rad) << toDegrees(o.amplitude_rad())
                 << toDegrees(o.phase_rad());
            rows.end();
        }
}

void exceedanceRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "exceedance", "of,name,pairs,exceeded,share,share_95_low,share_95_high,expected_share,three_sigma_share");
    const auto& all = report.exceedance;
    const auto share = [](std::int64_t exceeded, std::int64_t pairs) {
        return pairs > 0 ? std::optional(static_cast<double>(exceeded) / static_cast<double>(pairs)) : std::nullopt;
    };
    const auto low = all.share95 ? std::optional(all.share95->low) : std::nullopt,
               high = all.share95 ? std::optional(all.share95->high) : std::nullopt;
    rows << std::string("all") << std::string() << all.pairs << all.exceeded << share(all.exceeded, all.pairs) << low << high
         << all.expectedShare << all.threeSigmaShare;
    rows.end();
    for (const auto& [name, groups] : {std::pair("type", &all.byType), std::pair("site", &all.bySite), std::pair("crew", &all.byCrew)})
        for (const auto& group : *groups) {
            rows << std::string(name) << group.name << group.pairs << group.exceeded << share(group.exceeded, group.pairs)
                 << group.share95.low << group.share95.high << std::string() << std::string();
            rows.end();
        }
    for (const auto& heading : all.headings) {
        rows << std::string("heading") << shortestNumber(heading.heading_deg) << std::string() << std::string() << std::string()
             << std::string() << std::string() << heading.expectedShare << heading.threeSigmaShare;
        rows.end();
    }
}

void varianceRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "variance", "coefficient,component,variance_deg2,low_95_deg2,high_95_deg2");
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        if (!report.variance[c].report)
            continue;
        const auto& v = *report.variance[c].report;
        for (const auto& [name, component] : {std::pair("aircraft", v.aircraft), std::pair("crew", v.crew), std::pair("site", v.site),
                 std::pair("residual", std::optional(v.residual))})
            if (component) {
                rows << letterAt(c) << std::string(name) << component->variance << component->interval.low << component->interval.high;
                rows.end();
            }
    }
}

void plantRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "A by base and crew", "of,name,swings,mean_A_deg,mean_abs_A_deg,mean_abs_A_95_low_deg,mean_abs_A_95_high_deg");
    for (const auto& [name, groups] : {std::pair("site", &report.plants.bySite), std::pair("crew", &report.plants.byCrew)})
        for (const auto& g : *groups) {
            rows << std::string(name) << g.name << g.swings << g.meanA_deg << g.meanAbsA_deg << g.meanAbsA95_deg.low
                 << g.meanAbsA95_deg.high;
            rows.end();
        }
}

void alarmRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "alarms of the control charts of A", "of,name,first_date,last_date,ewma,cusum,average_A_deg");
    if (!report.plants.charts)
        return;
    for (const auto& a : report.plants.charts->alarms) {
        rows << std::string(a.crew ? "crew" : "site") << a.name << dateOfDay(a.day) << dateOfDay(a.last_day) << static_cast<int>(a.ewma)
             << static_cast<int>(a.cusum) << a.level_deg;
        rows.end();
    }
}

void softIronRows(std::string& csv, const FleetReport& report)
{
    Rows rows(csv, "soft iron of the types",
        "type,compass,coefficient,aircraft,mean_deg,standard_error_deg,between_aircraft_deg,next_aircraft_95_low_deg,next_aircraft_95_high_deg");
    for (const auto& standard : report.softIron)
        for (const auto& [letter, one] : {std::pair("D", &standard.D), std::pair("E", &standard.E)})
            if (*one) {
                rows << standard.type << standard.compass << std::string(letter) << (*one)->aircraft << (*one)->mean_deg
                     << (*one)->standardError_deg << (*one)->between_deg << (*one)->next95_deg.low << (*one)->next95_deg.high;
                rows.end();
            }
}

void changeRows(std::string& csv, const FleetReport& report, const FleetSwings& fleet)
{
    Rows rows(csv, "jumps", "aircraft,compass,after,before,coefficient,change_deg,standard_error_deg,p,event");
    for (const auto& j : report.changes.jumps) {
        const auto& compass = compassAt(fleet, j.compass);
        rows << compass.aircraft << compass.compass << dateOfDay(dayAt(fleet, j.afterRow)) << dateOfDay(dayAt(fleet, j.beforeRow))
             << letterAt(j.coefficient) << j.change_deg << j.standardError_deg << shortestNumber(j.p) << j.event;
        rows.end();
    }
    Rows drifts(csv, "drifts",
        "aircraft,compass,coefficient,deg_per_year,standard_error_deg_per_year,low_95_deg_per_year,high_95_deg_per_year,p,from,to");
    for (const auto& d : report.changes.drifts) {
        const auto& compass = compassAt(fleet, d.compass);
        drifts << compass.aircraft << compass.compass << letterAt(d.coefficient) << d.drift.perYear << d.drift.standardError
               << d.drift.interval95.low << d.drift.interval95.high << shortestNumber(d.drift.p) << dateOfDay(dayAt(fleet, d.firstRow))
               << dateOfDay(dayAt(fleet, d.lastRow));
        drifts.end();
    }
}

void rankingRows(std::string& csv, const FleetReport& report, const FleetSwings& fleet)
{
    Rows rows(csv, "who next", "aircraft,compass,probability,by_date,expected_max_abs_deviation_deg,limit_deg,last_swing,reason");
    for (const auto& r : report.ranking.compasses) {
        const auto& compass = compassAt(fleet, r.compass);
        rows << compass.aircraft << compass.compass << r.probability << dateOfDay(r.by_day) << r.largestExpected_deg << r.limit_deg
             << dateOfDay(r.lastSwing_day) << inWords(r).english();
        rows.end();
    }
}

} // namespace

std::string toCsv(const FleetReport& report, const FleetSwings& fleet)
{
    std::string csv;
    selectionRows(csv, report);
    patternRows(csv, report);
    coefficientRows(csv, report);
    harmonicRows(csv, report);
    exceedanceRows(csv, report);
    varianceRows(csv, report);
    plantRows(csv, report);
    alarmRows(csv, report);
    softIronRows(csv, report);
    changeRows(csv, report, fleet);
    rankingRows(csv, report, fleet);
    return csv;
}

} // namespace lubberline
