#include "core/fleet/Ranking.h"

#include <algorithm>
#include <cmath>

#include "core/base/Number.h"
#include "core/fleet/ByTwoHands.h"
#include "core/fleet/Futures.h"

namespace lubberline {

namespace {

constexpr double kLoose_deg2 = 25.0; ///< what a correction or a jump may have done: far more than any fit's error
constexpr int kFutures = 1000, kSteps = 4;
constexpr int kHorizonYears = 20;

/// What a coefficient of a kind of compass is, before anything of one of them is known.
struct Prior {
    double mean = 0, variance = kLoose_deg2;
    double slope = 0, slopeVariance = 0; ///< a year
};

struct Weighted {
    double mean = 0, variance = 0;
    int n = 0;
};
/// Mean and variance between, less the mean of the errors'.
Weighted between(const std::vector<std::pair<double, double>>& valuesAndErrors)
{
    Weighted w;
    w.n = static_cast<int>(valuesAndErrors.size());
    double error = 0, squares = 0;
    for (const auto& [value, variance] : valuesAndErrors) {
        w.mean += value / w.n;
        error += variance / w.n;
    }
    for (const auto& each : valuesAndErrors)
        squares += (each.first - w.mean) * (each.first - w.mean);
    w.variance = w.n > 1 ? std::max(0.0, squares / (w.n - 1) - error) : 0.0;
    return w;
}

class Ranker {
public:
    Ranker(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories, const FleetChanges& changes,
        const RankingOptions& options)
        : m_fleet(fleet)
        , m_curves(curves)
        , m_histories(histories)
        , m_changes(changes)
        , m_options(options)
    {
        m_priors.resize(static_cast<std::size_t>(curves.kinds));
        const auto ofKind = historiesByKind(curves, histories);
        byTwoHands(ofKind.size() * kCoefficientCount, 1, {}, [&](std::size_t job) {
            const std::size_t k = job / kCoefficientCount, c = job % kCoefficientCount;
            m_priors[k][c] = priorOf(ofKind[k], k, c);
        });
        m_drift.resize(fleet.compasses.size());
        for (const auto& each : changes.drifts) { // the surest first
            auto& mine = m_drift[static_cast<std::size_t>(each.compass)];
            mine.surest = mine.surest ? mine.surest : &each;
            mine.squared[each.coefficient] = each.drift.perYear * each.drift.perYear;
        }
        m_interval = options.interval_days > 0 ? options.interval_days : medianInterval();
    }

    Result<Ranking> rank(const Progress& progress)
    {
        Ranking ranking;
        std::vector<std::optional<double>> limits(m_histories.size());
        std::vector<std::size_t> asked;
        for (std::size_t h = 0; h < m_histories.size(); ++h) {
            const auto& compass = m_fleet.compasses[static_cast<std::size_t>(m_histories[h].compass)];
            limits[h] = m_options.limit_deg ? m_options.limit_deg : compass.limit_deg;
            if (!limits[h])
                ++ranking.withoutLimit;
            else if (std::ranges::none_of(m_histories[h].rows, [&](auto row) { return m_curves.curves[row].fitted(); }))
                ++ranking.withoutCurve;
            else
                asked.push_back(h);
        }
        ranking.compasses.resize(asked.size());
        const auto rankOne = [&](std::size_t i) { ranking.compasses[i] = ranked(asked[i], *limits[asked[i]]); };
        if (!byTwoHands(asked.size(), 4, progress, rankOne))
            return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
        // Equal chances (two of no risk): by what is expected, then by name, which is the order that they are in.
        std::ranges::stable_sort(
            ranking.compasses, {}, [](const RankedCompass& r) { return std::pair(-r.probability, -r.largestExpected_deg / r.limit_deg); });
        return ranking;
    }

private:
    [[nodiscard]] std::size_t kindOf(std::size_t history) const
    {
        return static_cast<std::size_t>(m_curves.kindOf[static_cast<std::size_t>(m_histories[history].compass)]);
    }

    Prior priorOf(const std::vector<std::size_t>& mine, std::size_t kind, std::size_t c) const
    {
        std::vector<std::pair<double, double>> levels, slopes;
        for (const auto h : mine) {
            const auto series = seriesOf(m_fleet, m_curves, m_histories[h], c, m_changes.scatter[kind][c]);
            double sum = 0, error = 0;
            for (const auto& value : series.values) {
                sum += value.value;
                error += value.variance;
            }
            const auto n = static_cast<double>(series.values.size());
            if (n > 0)
                levels.emplace_back(sum / n, error / (n * n));
            if (const auto& drift = m_changes.driftOf[h][c])
                slopes.emplace_back(drift->perYear, drift->standardError * drift->standardError);
        }
        Prior prior;
        const Weighted level = between(levels), slope = between(slopes);
        if (level.n > 2) {
            prior.mean = level.mean;
            prior.variance = level.variance + 0.01;
        }
        if (slope.n > 2)
            prior.slopeVariance = slope.variance; // about zero: a type has no direction of its own to drift in
        else if (slope.n > 0)
            prior.slopeVariance = slope.mean * slope.mean;
        return prior;
    }

    int medianInterval() const
    {
        std::vector<int> days;
        for (const auto& history : m_histories)
            for (std::size_t i = 1; i < history.rows.size(); ++i)
                if (const int gap = m_fleet.swings[history.rows[i]].day - m_fleet.swings[history.rows[i - 1]].day; gap > 30) // of one visit
                    days.push_back(gap);
        if (days.empty())
            return 365;
        const auto middle = days.begin() + static_cast<std::ptrdiff_t>(days.size() / 2);
        std::ranges::nth_element(days, middle);
        return *middle;
    }

    /// The filter over all swings; what a correction or a kept jump did is not held against the compass.
    CompassOutlook filtered(std::size_t h) const
    {
        const auto kind = kindOf(h);
        CompassOutlook compass;
        compass.day = m_fleet.swings[m_histories[h].rows.back()].day;
        for (std::size_t c = 0; c < 5; ++c) {
            const auto& scatter = m_changes.scatter[kind][c];
            const Prior& prior = m_priors[kind][c];
            compass.walk[c] = scatter.walkVariance_deg2_year;
            LevelAndDrift& state = compass.state[c];
            state
                = {prior.mean, prior.slope, prior.variance, 0, std::max(prior.slopeVariance, keptDriftSquared(m_histories[h].compass, c))};
            const auto series = seriesOf(m_fleet, m_curves, m_histories[h], c, scatter);
            int day = series.values.empty() ? compass.day : series.values.front().day;
            for (std::size_t i = 0; i < series.values.size(); ++i) {
                const auto& value = series.values[i];
                state.wait((value.day - day) / kDaysPerYear, compass.walk[c]);
                if (value.corrected || jumpedInto(series.rows[i], c))
                    state.p00 += kLoose_deg2;
                state.see(value.value, value.variance);
                day = value.day;
            }
            state.wait((compass.day - day) / kDaysPerYear, compass.walk[c]);
        }
        return compass;
    }

    /// One that is known to drift is not shrunk to those that do not.
    [[nodiscard]] double keptDriftSquared(std::int32_t compass, std::size_t c) const
    {
        return m_drift[static_cast<std::size_t>(compass)].squared[c];
    }

    [[nodiscard]] bool jumpedInto(std::uint32_t row, std::size_t c) const
    {
        const auto compass = m_fleet.swings[row].compass;
        const auto first = std::ranges::lower_bound(m_changes.jumps, compass, {}, &FleetJump::compass);
        for (auto jump = first; jump != m_changes.jumps.end() && jump->compass == compass; ++jump)
            if (jump->beforeRow == row && jump->coefficient == c)
                return true;
        return false;
    }

    RankedCompass ranked(std::size_t h, double limit_deg) const
    {
        const auto& history = m_histories[h];
        const auto& compass = m_fleet.compasses[static_cast<std::size_t>(history.compass)];
        const CompassOutlook now = filtered(h);
        RankedCompass ranked;
        ranked.compass = history.compass;
        ranked.limit_deg = limit_deg;
        ranked.swings = static_cast<int>(history.rows.size());
        ranked.lastSwing_day = now.day;
        ranked.by_day = std::max({compass.due_day.value_or(now.day + m_interval), m_options.today_day, now.day});
        const double years = (ranked.by_day - now.day) / kDaysPerYear;
        for (std::size_t c = 0; c < 5; ++c) {
            LevelAndDrift then = now.state[c];
            then.wait(years, now.walk[c]);
            ranked.expected_deg[c] = then.level;
            ranked.standardDeviation_deg[c] = std::sqrt(std::max(0.0, then.p00));
            ranked.drift_deg_year[c] = then.slope;
        }
        ranked.largestExpected_deg = largestOf_deg(ranked.expected_deg);
        ranked.probability = chance(now, ranked, years);
        reason(history, now, ranked);
        if (ranked.probability > 0.05 || ranked.reason == RankReason::Drift)
            findDays(now, ranked);
        return ranked;
    }

    /// The union over headings bounds it; where that says nothing, futures are drawn.
    double chance(const CompassOutlook& now, const RankedCompass& ranked, double years) const
    {
        double bound = 0;
        for (int heading = 0; heading < 360; heading += 15) {
            const FiveTerms x = termsAt(heading);
            double mean = 0, variance = 0;
            for (std::size_t c = 0; c < 5; ++c) {
                mean += x[c] * ranked.expected_deg[c];
                variance += x[c] * x[c] * ranked.standardDeviation_deg[c] * ranked.standardDeviation_deg[c];
            }
            const double s = std::sqrt(std::max(variance, 1e-12));
            bound += normalTail((ranked.limit_deg - mean) / s) + normalTail((ranked.limit_deg + mean) / s);
        }
        if (bound < 1e-3)
            return bound;
        static const FutureNormals normals(kFutures, kSteps);
        const Futures futures(now, years / kSteps);
        int out = 0;
        for (int future = 0; future < kFutures; ++future)
            out += futures.goesOut(normals.of(future), kSteps, ranked.limit_deg) ? 1 : 0;
        return (out + 0.5) / (kFutures + 1.0);
    }

    void findDays(const CompassOutlook& now, RankedCompass& ranked) const
    {
        constexpr int drawn = 400, perYear = 4;
        static const FutureNormals normals(drawn, kHorizonYears * perYear);
        const Futures futures(now, 1.0 / perYear);
        std::vector<int> steps;
        for (int future = 0; future < drawn; ++future) {
            const int out = futures.goesOut(normals.of(future), kHorizonYears * perYear, ranked.limit_deg);
            steps.push_back(out > 0 ? out - 1 : kHorizonYears * perYear + 1);
        }
        std::ranges::sort(steps);
        for (int step = 0; step <= kHorizonYears * perYear; ++step)
            ranked.reachedShare.push_back(static_cast<double>(std::ranges::upper_bound(steps, step) - steps.begin()) / drawn);
        const auto day = [&](double share) -> std::optional<int> {
            const int step = steps[static_cast<std::size_t>(share * (drawn - 1))];
            if (step > kHorizonYears * perYear)
                return {};
            return now.day + static_cast<int>(std::lround(step * kDaysPerYear / perYear));
        };
        ranked.reached5_day = day(0.05);
        ranked.reached50_day = day(0.50);
        ranked.reached95_day = day(0.95);
    }

    void reason(const CompassHistory& history, const CompassOutlook& now, RankedCompass& ranked) const
    {
        const auto set = [&](RankReason why, std::size_t c, double figure) {
            ranked.reason = why;
            ranked.coefficient = c;
            ranked.figure = figure;
        };
        FiveTerms level{};
        for (std::size_t c = 0; c < 5; ++c)
            level[c] = now.state[c].level;
        if (const double largest = largestOf_deg(level); largest > ranked.limit_deg)
            return set(RankReason::OutNow, 0, largest);
        if (const FleetDrift* surest = m_drift[static_cast<std::size_t>(history.compass)].surest;
            surest && ranked.largestExpected_deg > largestOf_deg(level))
            return set(RankReason::Drift, surest->coefficient, ranked.drift_deg_year[surest->coefficient]);
        if (ranked.largestExpected_deg > 0.8 * ranked.limit_deg)
            return set(RankReason::NearLimit, 0, ranked.largestExpected_deg);
        const auto jump = std::ranges::lower_bound(m_changes.jumps, history.compass, {}, &FleetJump::compass);
        if (jump != m_changes.jumps.end() && jump->compass == history.compass)
            return set(RankReason::Jump, jump->coefficient, jump->change_deg);
        if (ranked.swings < 3)
            return set(RankReason::FewSwings, 0, ranked.swings);
        if (const double years = (ranked.by_day - ranked.lastSwing_day) / kDaysPerYear; years > 1.5 * m_interval / kDaysPerYear)
            return set(RankReason::LongAgo, 0, years);
        set(RankReason::Steady, 0, ranked.largestExpected_deg);
    }

    const FleetSwings& m_fleet;
    const FleetCurves& m_curves;
    std::span<const CompassHistory> m_histories;
    const FleetChanges& m_changes;
    const RankingOptions& m_options;
    struct KeptDrift {
        const FleetDrift* surest = nullptr;
        std::array<double, 5> squared{};
    };
    std::vector<KeptDrift> m_drift; ///< of each compass
    std::vector<std::array<Prior, 5>> m_priors;
    int m_interval = 365;
};

std::string letter(std::size_t c) { return std::string(1, static_cast<char>('A' + static_cast<int>(c))); }

} // namespace

Result<Ranking> rankingOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    const FleetChanges& changes, const RankingOptions& options, const Progress& progress)
{
    return Ranker(fleet, curves, histories, changes, options).rank(progress);
}

Message inWords(const RankedCompass& ranked)
{
    switch (ranked.reason) {
    case RankReason::OutNow:
        return {MARKED("core", "%1° by its last swing, beyond its limit of %2°"), figureText(ranked.figure, 1),
            figureText(ranked.limit_deg, 1)};
    case RankReason::Drift:
        return {MARKED("core", "%1 drifts by %2° a year"), letter(ranked.coefficient), signedFigureText(ranked.figure, 2)};
    case RankReason::Jump: return {MARKED("core", "%1 jumped by %2°"), letter(ranked.coefficient), signedFigureText(ranked.figure, 1)};
    case RankReason::NearLimit:
        return {MARKED("core", "%1° expected, near its limit of %2°"), figureText(ranked.figure, 1), figureText(ranked.limit_deg, 1)};
    case RankReason::FewSwings: return {MARKED_N("core", "%n swing(s) known: mostly its type's scatter"), static_cast<int>(ranked.figure)};
    case RankReason::LongAgo: return {MARKED("core", "%1 years since its last swing by then"), figureText(ranked.figure, 1)};
    case RankReason::Steady: break;
    }
    return {MARKED("core", "%1° expected of a limit of %2°"), figureText(ranked.figure, 1), figureText(ranked.limit_deg, 1)};
}

} // namespace lubberline
