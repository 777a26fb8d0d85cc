#pragma once
/// Whether the iron changed, by what the innovations of a filter say together. Of a change d of the state the innovations ν of a window
/// show h·d, so with rows g = h/√v and values w = ν/√v (v their variance; white, as they are without a change)
///   S = Σ g w, J = Σ g gᵀ:  S²/J of A, of B and of C is χ² with 1,  Sᵀ J⁻¹ S of B and C, of D and E, and of each load with 2.
/// The sum of squares of a window, which asks for no shape, needs half as many updates again to see 1° in B.
/// Air that turns rough makes all innovations larger, which lifts these statistics too. So a window whose innovations scatter about the
/// change more than by chance is judged by its own scatter (F in place of χ²), and the change has to stand in what most of them say: in the
/// same statistic of innovations that are cut at 1.5 standard deviations, by its own scatter, at a chance of its own.

#include <array>
#include <deque>
#include <optional>

#include "core/inflight/StateFilter.h"

namespace lubberline {

class InnovationWatch {
public:
    static constexpr std::array<int, 4> kWindows{10, 20, 40, 80};
    /// Of one statistic of one window: of all innovations, and of those that are cut where the window scatters as stated and where it does
    /// not. With them 5 % of series of 1400 updates raise a false alarm, and 10 % to 24 % of those in which errors are 1.5 to 5 times as large
    /// for 60 to 400 updates; 1° in B is found after 11 (simulated, noise 0.5°).
    static constexpr double kChance = 1.2e-5, kChanceCutUsual = 5e-3, kChanceCut = 2e-3;

    struct Found {
        int window = 0;
        double p = 1;
    };

    explicit InnovationWatch(int states);
    /// The newest innovation, standardised as above.
    std::optional<Found> take(const StateFilter::State& row, double white);
    void forget();

private:
    struct Sums {
        StateFilter::State score, cutScore, square, cross; ///< S, S of what is cut, the diagonal of J, and of J one beside it
        double size = 0, cutSize = 0;                      ///< Σ w²
    };
    struct Entry {
        StateFilter::State row;
        double white = 0, cut = 0;
    };
    /// Of statistics with 1 or 2 degrees of freedom.
    struct Limits {
        double chance = 0, own = 0;   ///< by the stated scatter, by that of the window
        double cut = 0, cutUsual = 0; ///< of what is cut
        double usual = 0;             ///< up to which the scatter of a window is as stated
    };
    struct Statistic {
        double whole = 0, cut = 0;
    };
    [[nodiscard]] double beyond(const Statistic& statistic, int freedom, const Sums& sums, std::size_t window) const;
    static void add(Sums& sums, const Entry& entry, double sign);
    void sumAnew();
    [[nodiscard]] std::optional<Found> largestOf(const Sums& sums, std::size_t window) const;

    int m_states;
    std::array<Sums, kWindows.size()> m_sums;
    std::deque<Entry> m_entries;
    int m_sinceAnew = 0;
    std::array<std::array<Limits, 2>, kWindows.size()> m_limits;
};

} // namespace lubberline
