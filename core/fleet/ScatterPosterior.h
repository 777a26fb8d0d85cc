#pragma once
/// How much a coefficient of one kind of compass scatters from swing to swing, and wanders through the years, where few swings tell it:
/// not one size but all that the swings leave possible, each with its weight. Series of six swings tell scatter from wander badly, and
/// one size taken for known made intervals of drift too short and jumps of what had only wandered.
///   Restricted likelihood of every series with a trend of its own and a rare step (SeriesFit.h), over a grid of sizes. The prior is that
///   of compasses: scatter of half a degree and wander of 0.35° in the root of a year are usual, ten times less or four times more rare;
///   flat in the variance of the wander, because a wander that is overlooked is the worse error.

#include <map>

#include "core/fleet/SeriesFit.h"

namespace lubberline {

class ScatterPosterior {
public:
    /// @param series  of all histories of the kind, by history; variances of the fits alone.
    explicit ScatterPosterior(const std::map<std::size_t, std::vector<DatedValue>>& series);

    [[nodiscard]] ScatterSize mean() const;

    /// The trend over all sizes. @param history  whose series it is
    [[nodiscard]] std::optional<Drift> drift(
        std::size_t history, std::span<const DatedValue> series, std::span<const std::size_t> at) const;
    /// The largest step: what its own series says of the sizes is read with the step taken out, as Student's t does.
    [[nodiscard]] std::optional<Jump> jump(
        std::size_t history, std::span<const DatedValue> series, std::span<const std::size_t> at, bool trend) const;

private:
    /// What one history tells of the sizes.
    struct Told {
        std::vector<double> log;
        std::vector<double> perYear, perYearError; ///< its trend; an error of 0: its dates tell none
    };
    void tell(const std::map<std::size_t, std::vector<DatedValue>>& series, const std::vector<std::size_t>& sizes);
    void keep(const std::vector<std::size_t>& sizes);
    [[nodiscard]] std::optional<Drift> mixed(const std::vector<double>& logs, const Told& told) const;
    /// Logarithms without what a history itself has told.
    [[nodiscard]] std::vector<double> without(std::size_t history) const;

    std::vector<ScatterSize> m_sizes;
    std::vector<double> m_log;          ///< by size, of all histories
    std::map<std::size_t, Told> m_told; ///< by history, then size
};

} // namespace lubberline
