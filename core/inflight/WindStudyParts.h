#pragma once
/// Private to the winds: what is kept of an aircraft while its reports go by.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/angle/Angle.h"
#include "core/inflight/WindStudy.h"

namespace lubberline {

/// A report with texts of its own; its aircraft and flight are known where it is held.
struct HeldReport {
    WindReport report;
    std::string source;
};

struct WindStudy::Flight {
    std::string name;
    double from_s = kMissing, to_s = kMissing;
    FlightSums sums;
    std::vector<std::pair<std::size_t, WindForms>> forms; ///< by band of altitude, in which a flight has few
    std::size_t lastForms = 0;
    double level_deg = 0; ///< running mean of what the aircraft's fit leaves: a report far from it counts less
    std::int64_t levelled = 0;
    // The report before.
    double last_s = kMissing, lastAltitude_m = kMissing, lastTrack_deg = kMissing;
    double lastLatitude_deg = kMissing, lastLongitude_deg = kMissing, lastFix_s = kMissing;
    std::optional<LeftOut> lastLeftOut;
    std::array<std::uint64_t, 64> recent{}; ///< fingerprints: a report that comes again is known among so many
    std::size_t recentNext = 0;
    std::vector<HeldReport> held;
    double latest_s = -std::numeric_limits<double>::infinity(); ///< of the reports that were judged

    WindForms& formsOf(std::size_t band)
    {
        if (lastForms < forms.size() && forms[lastForms].first == band)
            return forms[lastForms].second;
        const auto found = std::find_if(forms.begin(), forms.end(), [band](const auto& one) { return one.first == band; });
        lastForms = static_cast<std::size_t>(found - forms.begin());
        return found == forms.end() ? forms.emplace_back(band, WindForms{}).second : found->second;
    }
};

struct WindStudy::Aircraft {
    std::string name;
    std::deque<Flight> flights;
    std::unordered_map<std::string, std::vector<std::size_t>> byName;
    Flight* last = nullptr;
    double latest_s = -std::numeric_limits<double>::infinity();
    std::int64_t observations = 0, used = 0;
    std::array<std::int64_t, kLeftOut.size()> leftOut{};
    // Of all flights: for the running fit, and the mean airspeed.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d product = Eigen::Vector3d::Zero();
    double airspeed = 0;
    WindRow running = WindRow::Zero(); ///< fit so far [deg]
    std::int64_t refitAt = 32;
    double median_deg = 1.5; ///< of what is left, running
    double medianUp = 1;     ///< the factor by which it moves; as good as the same for some reports on end
    std::int64_t medianMovedAnew = 0;
    WindSense sense;
    // Headings of their own column, held against the reported winds.
    double headingOff = 0, headingOffMagnetic = 0;
    std::int64_t headings = 0;
    // Of e on the declination: headings that were magnetic make a wind that is wrong by it.
    double declinations = 0, declinationSquares = 0, declinationErrors = 0, errors = 0;
    std::int64_t declined = 0;
    std::array<WindSector, 36> sectors{}; ///< sums
    std::string group;
    std::int64_t fromPositions = 0;
    double positionSquares = 0; ///< Σ of variances [kt²]
    std::vector<WindDot> dots;
    std::int64_t dotStride = 1;

    std::int64_t late = 0;
    double cosines = 0;    ///< Σ cos e of the first reports
    bool reversed = false; ///< e is about 180°, and counted from 0° to 360°

    void leave(LeftOut why) { ++leftOut[static_cast<std::size_t>(why)]; }

    /// Differences of directions wrap at 180°: errors about it, of a compass that reads the other end, must not fall on both sides.
    double sideOf(double error_deg)
    {
        constexpr std::int64_t kFirst = 32;
        constexpr double kBeyond = -0.25; // mean cosine: some 105°, to which no sine of a compass that points north comes
        if (used < kFirst) {
            cosines += std::cos(toRadians(error_deg));
            reversed = cosines < kBeyond * static_cast<double>(used + 1);
        }
        return reversed && error_deg < 0 ? error_deg + 360.0 : error_deg;
    }

    /// One in so many, so that few stand for all.
    void addDot(const WindDot& dot)
    {
        constexpr std::size_t kMostDots = 600;
        if (used % dotStride != 0)
            return;
        dots.push_back(dot);
        if (dots.size() < kMostDots)
            return;
        for (std::size_t i = 0; 2 * i < dots.size(); ++i)
            dots[i] = dots[2 * i];
        dots.resize(dots.size() / 2);
        dotStride *= 2;
    }

    /// By a step that shrinks with the reports that were used.
    void moveMedian(double off_deg)
    {
        if (used >= medianMovedAnew) {
            medianUp = std::exp(1.0 / (10.0 + std::pow(static_cast<double>(used), 0.7)));
            medianMovedAnew = used + 1 + used / 64;
        }
        median_deg = off_deg > median_deg ? median_deg * medianUp : median_deg / medianUp;
    }

    void add(const FlightSums::Report& report)
    {
        for (int j = 0; j < 3; ++j) {
            const double weighted = report.weight * report.row[static_cast<std::size_t>(j)];
            for (int i = j; i < 3; ++i)
                normal(i, j) += weighted * report.row[static_cast<std::size_t>(i)];
            product(j) += weighted * report.error_deg;
        }
        airspeed += report.airspeed;
    }
};

struct WindStudy::Source {
    std::string name;
    std::int64_t count = 0;
    double errors = 0, across = 0;
};

/// Reports wait until so many do; then those of the flight that waits longest are judged, in order of time.
struct WindStudy::Held {
    static constexpr std::size_t kMost = std::size_t{1} << 12; // of some hundred bytes: they stay near the processor
    struct Waiting {
        Aircraft* aircraft = nullptr;
        Flight* flight = nullptr;
    };
    void hold(WindStudy& study, Aircraft& aircraft, Flight& flight, const WindReport& report);
    void release(WindStudy& study, const Waiting& which);
    void releaseAll(WindStudy& study);
    std::deque<Waiting> waiting; ///< one of a flight more than once, where flights are merged
    std::size_t count = 0;
    std::vector<std::vector<HeldReport>> spare; ///< empty, with memory that serves again
};

struct WindStudy::Twin {
    double time_s = kMissing, east = 0, north = 0;
    const Aircraft* aircraft = nullptr;
    std::string source;
};

/// The vectors of a report [kt, east and north].
struct WindStudy::Use {
    Eigen::Vector2d ground, wind, reference; ///< winds blow to
    Eigen::Vector2d air, airReference;
    double groundError_kt = 0; ///< of the ground velocity, each component, where it stands in the heading's error
};

} // namespace lubberline
