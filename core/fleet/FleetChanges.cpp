#include "core/fleet/FleetChanges.h"

#include "core/base/Middle.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

/// Fewer increments give no median to take as known: then the error's scale is estimated in each series.
constexpr std::size_t kEnoughIncrements = 30;
constexpr double kMedianOfChiSquare = 0.454936423119572; ///< one degree of freedom
constexpr int kRounds = 3;                               ///< jumps looked for in one series

/// Corrections turn screws and mounts, which move A, B and C; soft iron stays.
bool movedByCorrection(std::size_t c) { return c < 3; }

struct Increment {
    double squared, variance, years;
    bool later; ///< both swings after the crews' day
};
struct Increments {
    std::vector<Increment> next; ///< from a swing to the next
    std::vector<Increment> far;  ///< over half of a run of swings without a correction
};

/// d² of N(0, v + 2τ²) has its median at 0.4549 (v + 2τ²).
double swingVarianceOf(const std::vector<Increment>& increments, bool later)
{
    std::vector<double> candidates;
    for (const auto& each : increments)
        if (each.later == later)
            candidates.push_back(0.5 * (each.squared / kMedianOfChiSquare - each.variance));
    return candidates.empty() ? 0.0 : std::max(0.0, middleOf(candidates));
}

double medianYears(const std::vector<Increment>& increments)
{
    std::vector<double> years;
    for (const auto& each : increments)
        years.push_back(each.years);
    return middleOf(years);
}

/// What changes grow by over longer times is wandered: the rest of a change is there at once. Takes the wandered part out of the swings'.
void tellWander(const Increments& increments, ChangeScatter& scatter)
{
    if (increments.far.size() < kEnoughIncrements || increments.next.size() < kEnoughIncrements)
        return;
    const double near = medianYears(increments.next), longer = medianYears(increments.far) - near;
    std::vector<double> grown;
    for (const auto& each : increments.far)
        grown.push_back(
            each.squared / kMedianOfChiSquare - each.variance - 2 * (each.later ? scatter.laterVariance_deg2 : scatter.swingVariance_deg2));
    const double excess = middleOf(grown);
    if (!(excess > 0) || !(longer > 0.5 * near))
        return;
    scatter.wanderVariance_deg2_year = excess / longer;
    for (double* each : {&scatter.swingVariance_deg2, &scatter.laterVariance_deg2})
        *each = std::max(0.0, *each - 0.5 * near * scatter.wanderVariance_deg2_year);
}

ChangeScatter scatterOf(const Increments& all, std::optional<int> crews_day)
{
    const auto& increments = all.next;
    ChangeScatter scatter;
    scatter.crews_day = crews_day;
    scatter.increments = increments.size();
    scatter.swingVariance_deg2 = swingVarianceOf(increments, false);
    scatter.laterVariance_deg2 = swingVarianceOf(increments, true);
    tellWander(all, scatter);
    double beyond = 0, years = 0;
    for (const auto& each : increments) {
        beyond += each.squared - each.variance - 2 * (each.later ? scatter.laterVariance_deg2 : scatter.swingVariance_deg2);
        years += each.years;
    }
    scatter.walkVariance_deg2_year = years > 0 ? std::max(0.0, beyond / years) : 0.0;
    scatter.known = increments.size() >= kEnoughIncrements;
    return scatter;
}

Increment incrementOf(const DatedValue& before, const DatedValue& after, std::optional<int> crews_day)
{
    return {std::pow(after.value - before.value, 2), before.variance + after.variance, (after.day - before.day) / kDaysPerYear,
        crews_day && before.day >= *crews_day};
}

/// Two changes of each run, from its first swing to its middle and from there to its last.
void addFar(std::span<const DatedValue> series, std::optional<int> crews_day, std::vector<Increment>& far)
{
    constexpr std::size_t fewest = 3; // swings in a half
    for (std::size_t first = 0, next = 0; first < series.size(); first = next) {
        for (next = first + 1; next < series.size() && !series[next].corrected;)
            ++next;
        const std::size_t half = (next - first - 1) / 2;
        if (half + 1 < fewest)
            continue;
        for (const std::size_t from : {first, first + half})
            if (series[from + half].day > series[from].day)
                far.push_back(incrementOf(series[from], series[from + half], crews_day));
    }
}

std::vector<std::array<ChangeScatter, 5>> scattersOf(
    const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories, std::optional<int> crews_day)
{
    const auto kinds = static_cast<std::size_t>(curves.kinds);
    std::vector<std::array<Increments, 5>> increments(kinds);
    for (const auto& history : histories) {
        auto& mine = increments[static_cast<std::size_t>(curves.kindOf[static_cast<std::size_t>(history.compass)])];
        for (std::size_t c = 0; c < 5; ++c) {
            const std::optional<int> day = c == 0 ? crews_day : std::nullopt;
            ChangeScatter none;
            none.crews_day = day;
            const auto series = seriesOf(fleet, curves, history, c, none);
            for (std::size_t i = 1; i < series.values.size(); ++i) {
                const auto &before = series.values[i - 1], &after = series.values[i];
                if (!after.corrected && after.day > before.day)
                    mine[c].next.push_back(incrementOf(before, after, day));
            }
            addFar(series.values, day, mine[c].far);
        }
    }
    std::vector<std::array<ChangeScatter, 5>> scatters(kinds);
    for (std::size_t k = 0; k < kinds; ++k)
        for (std::size_t c = 0; c < 5; ++c)
            scatters[k][c] = scatterOf(increments[k][c], c == 0 ? crews_day : std::nullopt);
    return scatters;
}

JumpOptions optionsFor(const ChangeScatter& scatter)
{
    JumpOptions options;
    options.scale = scatter.known ? ErrorScale::Known : ErrorScale::Unknown;
    options.leastSegment = scatter.known ? 1 : 2;
    options.walk_year = scatter.known ? scatter.wanderVariance_deg2_year : 0.0;
    return options;
}

/// A trend in the null hides half of a jump in the middle of its series (the two are correlated by 0.87). Where a kind of compass hardly
/// drifts, jumps are therefore looked for without one; what is found must then also stand beside a trend at this level, so that the
/// single compass that does drift is not said to have jumped.
constexpr double kBesideATrend = 0.1;

std::optional<Jump> jumpOf(std::span<const DatedValue> series, const ChangeScatter& scatter, const JumpOptions& options)
{
    if (!scatter.known || scatter.driftIsCommon)
        return largestJump(series, options, false);
    JumpOptions level = options;
    level.trend = false;
    auto jump = largestJump(series, level, false);
    if (jump && jump->p < kFalseDiscoveryRate) {
        const auto beside = largestJump(series, options, true);
        if (!beside || beside->p > kBesideATrend)
            jump->p = 1;
    }
    return jump;
}

/// Half of the trends are beyond what their errors explain by a fifth: jumps of a few do not move a median.
bool driftIsCommon(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories, std::int32_t kind,
    std::size_t c, const ChangeScatter& scatter)
{
    constexpr std::size_t enough = 10;
    constexpr double wider = 1.2 * 1.2;
    std::vector<double> squares;
    for (const auto& history : histories) {
        if (curves.kindOf[static_cast<std::size_t>(history.compass)] != kind)
            continue;
        if (const auto drift = driftOf(seriesOf(fleet, curves, history, c, scatter).values, optionsFor(scatter)))
            squares.push_back(std::pow(drift->perYear / drift->standardError, 2));
    }
    if (squares.size() < enough)
        return true;
    // of fewer series the median itself scatters more
    return middleOf(squares) > kMedianOfChiSquare * (wider + 3.0 / std::sqrt(static_cast<double>(squares.size())));
}

/// One series in which jumps are looked for.
struct Candidate {
    std::size_t history = 0, coefficient = 0;
    JumpOptions options;
    std::optional<Jump> best; ///< of this round
};

std::string eventBetween(const FleetCompass& compass, int after, int before)
{
    for (const auto& event : compass.events)
        if (event.day >= after && event.day <= before)
            return event.text;
    return {};
}

class ChangeSearch {
public:
    ChangeSearch(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories, FleetChanges& changes)
        : m_fleet(fleet)
        , m_curves(curves)
        , m_histories(histories)
        , m_changes(changes)
    {
    }

    bool look(const Progress& progress)
    {
        for (std::size_t h = 0; h < m_histories.size(); ++h) {
            if (progress && h % 64 == 0 && !progress(static_cast<double>(h) / static_cast<double>(m_histories.size())))
                return false;
            for (std::size_t c = 0; c < 5; ++c) {
                Candidate candidate{h, c, optionsFor(scatterFor(h, c)), {}};
                candidate.best = jumpOf(series(candidate).values, scatterFor(h, c), candidate.options);
                if (candidate.best)
                    m_candidates.push_back(std::move(candidate));
            }
        }
        m_changes.tested = m_candidates.size();
        return true;
    }

    /// Keeps those that hold at the rate among all series, and looks for another jump beside each.
    void keep(double rate)
    {
        for (int round = 0; round < kRounds; ++round) {
            std::vector<double> p;
            for (const auto& candidate : m_candidates)
                p.push_back(candidate.best ? candidate.best->p : 1.0);
            const auto found = discoveries(p, rate, std::max(m_changes.tested, p.size()));
            bool any = false;
            for (std::size_t i = 0; i < m_candidates.size(); ++i) {
                auto& candidate = m_candidates[i];
                if (found[i]) {
                    note(candidate);
                    candidate.options.at.push_back(candidate.best->before);
                    any = true;
                }
                candidate.best = found[i]
                    ? jumpOf(series(candidate).values, scatterFor(candidate.history, candidate.coefficient), candidate.options)
                    : std::nullopt;
            }
            if (!any)
                break;
        }
        std::ranges::sort(m_changes.jumps, {}, [](const FleetJump& j) { return std::tuple(j.compass, j.beforeRow, j.coefficient); });
    }

    void drifts(double rate)
    {
        m_changes.driftOf.resize(m_histories.size());
        std::vector<FleetDrift> all;
        std::vector<std::vector<std::size_t>> jumps(m_histories.size() * 5);
        for (const auto& candidate : m_candidates)
            jumps[candidate.history * 5 + candidate.coefficient] = candidate.options.at;
        for (std::size_t h = 0; h < m_histories.size(); ++h)
            for (std::size_t c = 0; c < 5; ++c) {
                JumpOptions options = optionsFor(scatterFor(h, c));
                options.at = jumps[h * 5 + c];
                const auto mine = seriesOf(m_fleet, m_curves, m_histories[h], c, scatterFor(h, c));
                const auto drift = lubberline::driftOf(mine.values, options);
                m_changes.driftOf[h][c] = drift;
                if (drift)
                    all.push_back({m_histories[h].compass, c, *drift, mine.rows.front(), mine.rows.back()});
            }
        std::vector<double> p;
        for (const auto& each : all)
            p.push_back(each.drift.p);
        const auto found = discoveries(p, rate, p.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            if (found[i])
                m_changes.drifts.push_back(all[i]);
        std::ranges::stable_sort(m_changes.drifts, {}, [](const FleetDrift& d) { return d.drift.p; });
    }

private:
    const ChangeScatter& scatterFor(std::size_t history, std::size_t c) const
    {
        return m_changes.scatter[static_cast<std::size_t>(m_curves.kindOf[static_cast<std::size_t>(m_histories[history].compass)])][c];
    }
    CoefficientSeries series(const Candidate& candidate) const
    {
        return seriesOf(
            m_fleet, m_curves, m_histories[candidate.history], candidate.coefficient, scatterFor(candidate.history, candidate.coefficient));
    }
    void note(const Candidate& candidate)
    {
        const auto mine = series(candidate);
        const Jump& best = *candidate.best;
        FleetJump jump;
        jump.compass = m_histories[candidate.history].compass;
        jump.coefficient = candidate.coefficient;
        jump.afterRow = mine.rows[best.after];
        jump.beforeRow = mine.rows[best.before];
        jump.change_deg = best.change;
        jump.standardError_deg = best.standardError;
        jump.p = best.p;
        jump.event = eventBetween(
            m_fleet.compasses[static_cast<std::size_t>(jump.compass)], mine.values[best.after].day, mine.values[best.before].day);
        m_changes.jumps.push_back(std::move(jump));
    }

    const FleetSwings& m_fleet;
    const FleetCurves& m_curves;
    std::span<const CompassHistory> m_histories;
    FleetChanges& m_changes;
    std::vector<Candidate> m_candidates;
};

} // namespace

CoefficientSeries seriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter)
{
    CoefficientSeries series;
    bool corrected = false; // also by swings that do not tell this coefficient
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
        const auto row = history.rows[i];
        corrected = corrected || (history.corrected[i] && movedByCorrection(c));
        if (scatter.crews_day && i > 0 && fleet.swings[row].day >= *scatter.crews_day
            && fleet.swings[history.rows[i - 1]].day < *scatter.crews_day)
            corrected = true;
        if (!curves.curves[row].known(c))
            continue;
        const FleetSwing& swing = fleet.swings[row];
        series.values.push_back({swing.day, curves.curves[row].value_deg[c],
            curves.variance_deg2(swing, row, c) + scatter.varianceAt(swing.day), corrected && !series.values.empty()});
        series.rows.push_back(row);
        corrected = false;
    }
    return series;
}

Result<FleetChanges> changesOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    std::optional<int> crews_day, double rate, const Progress& progress)
{
    FleetChanges changes;
    changes.scatter = scattersOf(fleet, curves, histories, crews_day);
    for (std::int32_t kind = 0; kind < curves.kinds; ++kind)
        for (std::size_t c = 0; c < 5; ++c) {
            auto& scatter = changes.scatter[static_cast<std::size_t>(kind)][c];
            scatter.driftIsCommon = driftIsCommon(fleet, curves, histories, kind, c, scatter);
        }
    ChangeSearch search(fleet, curves, histories, changes);
    if (!search.look(progress))
        return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
    search.keep(rate);
    search.drifts(rate);
    return changes;
}

CoefficientSet jumpedTogether(const FleetChanges& changes, const FleetJump& jump)
{
    CoefficientSet together;
    for (const auto& other : changes.jumps)
        if (other.compass == jump.compass && other.afterRow < jump.beforeRow && other.beforeRow > jump.afterRow)
            together.set(other.coefficient);
    return together;
}

LikelyPart likelyPart(CoefficientSet jumped, CompassKind kind)
{
    const bool index = jumped[0], hard = jumped[1] || jumped[2], soft = jumped[3] || jumped[4];
    if (index && !hard && !soft)
        return LikelyPart::Mount;
    if (hard && !soft)
        return LikelyPart::Magnets;
    if (soft && !hard)
        return kind == CompassKind::DirectReading ? LikelyPart::Corrector : LikelyPart::Transmission;
    return LikelyPart::Several;
}

Message inWords(LikelyPart part)
{
    switch (part) {
    case LikelyPart::Mount: return MARKED("core", "A alone: the compass or detector was turned in its mount");
    case LikelyPart::Magnets: return MARKED("core", "B and C: permanent magnetism, of the aircraft or of the compensating magnets");
    case LikelyPart::Transmission:
        return MARKED(
            "core", "D and E of a remote compass: the transmission of its signal (two-cycle error), or soft iron near the detector");
    case LikelyPart::Corrector: return MARKED("core", "D and E: soft iron, the correctors or parts near the compass");
    case LikelyPart::Several: break;
    }
    return MARKED("core", "several coefficients at once: iron near the compass was changed, or the compass itself");
}

} // namespace lubberline
