#include "core/fleet/FleetChanges.h"

#include "core/base/Middle.h"

#include <algorithm>
#include <cmath>

#include "core/fleet/ByTwoHands.h"

namespace lubberline {

namespace {

constexpr int kRounds = 3; ///< jumps looked for in one series

using Places = std::vector<std::size_t>;

JumpOptions optionsFor(const ChangeScatter& scatter, const Places& at, bool trend)
{
    JumpOptions options;
    options.trend = trend;
    options.at = at;
    options.walk_year = scatter.wanderVariance_deg2_year;
    return options;
}

/// Of one coefficient of one history, in the scatter of its kind.
struct Watched {
    std::size_t history = 0;
    const ChangeScatter& scatter;
    std::vector<DatedValue> series; ///< with the kind's scatter in its variances where that is known
};

Watched watched(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories, std::size_t h,
    std::size_t c, const ChangeScatter& scatter)
{
    return {h, scatter,
        scatter.known ? seriesOf(fleet, curves, histories[h], c, scatter).values : bareSeriesOf(fleet, curves, histories[h], c, scatter)};
}

std::optional<Jump> largestOf(const Watched& one, const Places& at, bool trend, JumpChance chance = JumpChance::Decisive)
{
    return one.scatter.known ? largestJump(one.series, optionsFor(one.scatter, at, trend), chance)
                             : one.scatter.posterior->jump(one.history, one.series, at, trend);
}

std::optional<Drift> trendOf(const Watched& one, const Places& at)
{
    return one.scatter.known ? driftOf(one.series, optionsFor(one.scatter, at, true))
                             : one.scatter.posterior->drift(one.history, one.series, at);
}

/// A trend in the null hides half of a jump in the middle of its series (the two are correlated by 0.87). Where a kind of compass hardly
/// drifts, jumps are therefore looked for without one; what is found must then also stand beside a trend at this level, so that the
/// single compass that does drift is not said to have jumped.
constexpr double kBesideATrend = 0.1;

std::optional<Jump> jumpOf(const Watched& one, const Places& at)
{
    if (one.scatter.driftIsCommon)
        return largestOf(one, at, true);
    auto jump = largestOf(one, at, false);
    if (jump && jump->p < kFalseDiscoveryRate) {
        const auto beside = largestOf(one, at, true);
        if (!beside || beside->p > kBesideATrend)
            jump->p = 1;
        else if (const auto drift = trendOf(one, at); drift && std::abs(drift->perYear / drift->standardError) > std::abs(jump->statistic))
            jump->p = std::max(jump->p, beside->p); // a trend alone explains more than the step: it is what stands beside it that counts
    }
    return jump;
}

/// The same with the least that its p can be, where finding it out takes longer.
std::optional<Jump> jumpAtLeast(const Watched& one, const Places& at)
{
    return one.scatter.known ? largestOf(one, at, one.scatter.driftIsCommon, JumpChance::Least) : jumpOf(one, at);
}

/// Half of the trends are beyond what their errors explain by a fifth: jumps of a few do not move a median.
bool driftIsCommon(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    const std::vector<std::size_t>& mine, std::size_t c, const ChangeScatter& scatter)
{
    constexpr std::size_t enough = 10;
    constexpr double wider = 1.2 * 1.2;
    std::vector<double> squares;
    for (const auto h : mine)
        if (const auto drift = trendOf(watched(fleet, curves, histories, h, c, scatter), {}))
            squares.push_back(std::pow(drift->perYear / drift->standardError, 2));
    if (squares.size() < enough)
        return true;
    // of fewer series the median itself scatters more
    return middleOf(squares) > kMedianOfChiSquare * (wider + 3.0 / std::sqrt(static_cast<double>(squares.size())));
}

/// One series in which jumps are looked for.
struct Candidate {
    std::size_t history = 0, coefficient = 0;
    Places at;                ///< of jumps that were kept
    std::optional<Jump> best; ///< of this round
    bool exact = false;       ///< its p is; else it is the least that p can be
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
        std::vector<std::array<std::optional<Jump>, kCoefficientCount>> least(m_histories.size());
        const auto lookAt = [&](std::size_t h) {
            for (std::size_t c = 0; c < kCoefficientCount; ++c)
                least[h][c] = jumpAtLeast(watch(h, c), {});
        };
        if (!byTwoHands(m_histories.size(), 4, progress, lookAt))
            return false;
        for (std::size_t h = 0; h < m_histories.size(); ++h)
            for (std::size_t c = 0; c < kCoefficientCount; ++c)
                if (least[h][c])
                    m_candidates.push_back({h, c, {}, least[h][c], !scatterFor(h, c).known});
        m_changes.tested = m_candidates.size();
        return true;
    }

    /// Keeps those that hold at the rate among all series, and looks for another jump beside each.
    void keep(double rate)
    {
        for (int round = 0; round < kRounds; ++round) {
            const auto found = discovered(rate);
            std::vector<std::size_t> again;
            for (std::size_t i = 0; i < m_candidates.size(); ++i) {
                auto& candidate = m_candidates[i];
                if (found[i]) {
                    note(candidate);
                    candidate.at.push_back(candidate.best->before);
                    again.push_back(i);
                } else {
                    candidate.best.reset();
                    candidate.exact = true;
                }
            }
            if (again.empty())
                break;
            lookClosely(again);
        }
        std::ranges::sort(m_changes.jumps, {}, [](const FleetJump& j) { return std::tuple(j.compass, j.beforeRow, j.coefficient); });
    }

    void drifts(double rate)
    {
        m_changes.driftOf.resize(m_histories.size());
        std::vector<std::pair<std::size_t, FleetDrift>> all; // with the history's place
        std::vector<Places> jumps(m_histories.size() * 5);
        for (const auto& candidate : m_candidates)
            jumps[candidate.history * 5 + candidate.coefficient] = candidate.at;
        byTwoHands(m_histories.size(), 4, {}, [&](std::size_t h) {
            for (std::size_t c = 0; c < 5; ++c)
                m_changes.driftOf[h][c] = trendOf(watch(h, c), jumps[h * 5 + c]);
        });
        for (std::size_t h = 0; h < m_histories.size(); ++h)
            for (std::size_t c = 0; c < 5; ++c) {
                const auto& drift = m_changes.driftOf[h][c];
                if (!drift)
                    continue;
                all.push_back({h, {m_histories[h].compass, c, *drift}});
            }
        std::vector<double> p;
        for (const auto& [h, each] : all)
            p.push_back(each.drift.p);
        const auto found = discoveries(p, rate, p.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!found[i])
                continue;
            auto& [h, drift] = all[i];
            const auto rows = seriesOf(m_fleet, m_curves, m_histories[h], drift.coefficient, scatterFor(h, drift.coefficient)).rows;
            drift.firstRow = rows.front();
            drift.lastRow = rows.back();
            m_changes.drifts.push_back(drift);
        }
        std::ranges::stable_sort(m_changes.drifts, {}, [](const FleetDrift& d) { return d.drift.p; });
    }

private:
    /// What the exact chances of all would keep. Larger ones never keep more, so that only what the least ones keep is worked out: of
    /// ten thousand compasses a few hundred.
    std::vector<bool> discovered(double rate)
    {
        for (;;) {
            std::vector<double> p;
            for (const auto& candidate : m_candidates)
                p.push_back(candidate.best ? candidate.best->p : 1.0);
            auto found = discoveries(p, rate, std::max(m_changes.tested, p.size()));
            std::vector<std::size_t> inexact;
            for (std::size_t i = 0; i < m_candidates.size(); ++i)
                if (found[i] && !m_candidates[i].exact)
                    inexact.push_back(i);
            if (inexact.empty())
                return found;
            lookClosely(inexact);
        }
    }

    /// The exact chances of these.
    void lookClosely(const std::vector<std::size_t>& some)
    {
        byTwoHands(some.size(), 1, {}, [&](std::size_t i) {
            auto& candidate = m_candidates[some[i]];
            candidate.best = jumpOf(watch(candidate.history, candidate.coefficient), candidate.at);
            candidate.exact = true;
        });
    }

    const ChangeScatter& scatterFor(std::size_t history, std::size_t c) const
    {
        return m_changes.scatter[static_cast<std::size_t>(m_curves.kindOf[static_cast<std::size_t>(m_histories[history].compass)])][c];
    }
    Watched watch(std::size_t history, std::size_t c) const
    {
        return watched(m_fleet, m_curves, m_histories, history, c, scatterFor(history, c));
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

Result<FleetChanges> changesOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    std::optional<int> crews_day, double rate, const Progress& progress)
{
    FleetChanges changes;
    auto scatter = scattersOf(fleet, curves, histories, crews_day, progress);
    if (!scatter)
        return scatter.error();
    changes.scatter = std::move(scatter.value());
    const auto ofKind = historiesByKind(curves, histories);
    byTwoHands(ofKind.size() * kCoefficientCount, 1, {}, [&](std::size_t job) {
        const std::size_t kind = job / kCoefficientCount, c = job % kCoefficientCount;
        auto& mine = changes.scatter[kind][c];
        mine.driftIsCommon = driftIsCommon(fleet, curves, histories, ofKind[kind], c, mine);
    });
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
