#pragma once
/// The mean of what an instrument sends while a compass comes to rest.

#include <deque>
#include <optional>

namespace lubberline {

struct SettledHeading {
    double mean_deg = 0;   ///< circular mean, [0, 360)
    double spread_deg = 0; ///< largest − smallest
    double standardDeviation_deg = 0;
    std::optional<double> turnRate_deg_s; ///< clockwise positive: the line through them; none of less than a second
    int count = 0;
    double age_s = 0;     ///< since the last of them was heard
    bool settled = false; ///< the window is full and the spread within the limit
};

/// Keeps the headings of the last `length_s` seconds. Time is given with each heading, from a clock that does not jump.
class SettlingWindow {
public:
    explicit SettlingWindow(double length_s = 5.0, double mostSpread_deg = 1.0) : m_length_s(length_s), m_mostSpread_deg(mostSpread_deg) {}

    /// A time before the last one begins the window anew: the clock was set back.
    void add(double time_s, double heading_deg);
    void clear() { m_headings.clear(); }
    /// None while empty, or when the last heading is older than the window: the instrument has gone silent.
    [[nodiscard]] std::optional<SettledHeading> at(double time_s) const;

private:
    struct Heading {
        double time_s, heading_deg;
    };
    double m_length_s, m_mostSpread_deg;
    std::deque<Heading> m_headings;
    double m_since_s = 0; ///< when the window began to fill
};

} // namespace lubberline
