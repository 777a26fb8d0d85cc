#pragma once
/// Whether the iron changed, by what the innovations of a filter say together. Of a change d of the state the innovations ν of a window
/// show h·d, so with rows g = h/√v and values w = ν/√v (v their variance; white, as they are without a change)
///   S = Σ g w, J = Σ g gᵀ:  S²/J of A, of B and of C is χ² with 1,  Sᵀ J⁻¹ S of B and C, of D and E, and of each load with 2.
/// The sum of squares of a window, which asks for no shape, needs half as many updates again to see 1° in B.

#include <array>
#include <deque>
#include <optional>

#include "core/inflight/StateFilter.h"

namespace lubberline {

class InnovationWatch {
public:
    static constexpr std::array<int, 4> kWindows{10, 20, 40, 80};
    /// Of one statistic of one window: 10 % of series of 1400 updates raise a false alarm at headings that have nothing to do with each
    /// other (simulated: 8 % to 10 %, by how the headings follow each other).
    static constexpr double kChance = 1.2e-5;

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
        StateFilter::State score, square, cross; ///< S, the diagonal of J, and of J one beside it
    };
    struct Entry {
        StateFilter::State row;
        double white = 0;
    };
    static void add(Sums& sums, const Entry& entry, double sign);
    void sumAnew();
    [[nodiscard]] std::optional<Found> largestOf(const Sums& sums, int window) const;

    int m_states;
    std::array<Sums, kWindows.size()> m_sums;
    std::deque<Entry> m_entries;
    int m_sinceAnew = 0;
    double m_limitOne, m_limitTwo; ///< of χ² with 1 and with 2
};

} // namespace lubberline
