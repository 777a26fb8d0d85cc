#pragma once
/// A dated series for one size of its scatter: how likely it is, its trend, and what a step at each of its places would explain. The
/// same as core/fleet/JumpTest.h for errors that are known, without its critical values: what ScatterPosterior asks for many sizes.
///   A figure is a level that wanders plus an error of its own, so that all of this is filtered and not solved: the level from the
///   figures before a place (variance G) and from those after it (variance H); a step there is their difference, of variance G + H +
///   what wanders in between. The restricted likelihood of figures less their level is that of their differences, innovation by
///   innovation; a known step takes its difference out. The years go through the same filter for the trend. In the order of n, no
///   differences of large numbers in the recursion.

#include <optional>
#include <span>
#include <vector>

#include "core/fleet/JumpTest.h"

namespace lubberline {

/// Of one coefficient of one kind of compass.
struct ScatterSize {
    double swing_deg2 = 0;       ///< variance of a swing beyond its fit
    double wander_deg2_year = 0; ///< variance by which the coefficient wanders in a year
};

struct SeriesPlace {
    std::size_t place = 0; ///< the figure after the step
    double statistic = 0;  ///< standard normal without a step
    double length2 = 0;    ///< inverse variance of the step's size
};

struct SeriesFit {
    double logLikelihood = 0; ///< restricted: of what the levels and the trend leave; less a constant
    int freedom = 0;
    std::optional<double> perYear; ///< the trend; none: the dates do not tell it
    double perYearError = 0;
    std::vector<SeriesPlace> places;
};

enum class SeriesSteps { Asked, NotAsked }; ///< of places that are not known: half of the work and more

/// One series that is asked for many sizes.
class SeriesFitter {
public:
    /// @param series  variances of the fits alone. @param trend  in the null of steps and of the likelihood. @param at  known steps
    SeriesFitter(std::span<const DatedValue> series, bool trend, std::span<const std::size_t> at);
    void fit(const ScatterSize& size, SeriesSteps steps, SeriesFit& into); ///< what was in it goes, its room stays

private:
    struct Figure {
        double value, years; ///< since the first
        double gap;          ///< years since the one before
        double variance, swingShare;
        bool known; ///< a step or a correction before it
        bool asked; ///< whether it jumped before it
    };
    /// What the figures on one side tell: the level of the values, and the same of the years.
    struct Level {
        double variance, value, years;
    };
    std::vector<Figure> m_figures;
    std::vector<double> m_error; ///< variance of each figure at the size asked
    std::vector<Level> m_before; ///< of each figure: from itself and those before it
    bool m_trend;
    int m_levels = 0;
};

[[nodiscard]] SeriesFit fitSeries(std::span<const DatedValue> series, const ScatterSize& size, bool trend, std::span<const std::size_t> at,
    SeriesSteps steps = SeriesSteps::Asked);

/// Logarithm of the likelihood where a rare step is also thought of: one of N(0, 2°) at any place in each hundredth series.
[[nodiscard]] double withRareStep(const SeriesFit& fit);
/// With a step at one of the places for certain, of any size.
[[nodiscard]] double withStepAt(const SeriesFit& fit, const SeriesPlace& place);

} // namespace lubberline
