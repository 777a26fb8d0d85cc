#pragma once
/// Logs of turns made from known coefficients, with delays, winds and variations, and what is read back from them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"

namespace lubberline::test {

inline const ApproximateSmith kTruth{toRadians(0.8), toRadians(-3.0), toRadians(2.0), toRadians(1.2), toRadians(-0.4)};

struct Leg {
    double rate_deg_s = 0, seconds = 0;
};

/// A flight (or a walk on wheels) that a log is made of.
struct Flight {
    std::vector<Leg> legs{{1.0, 400.0}};
    double airspeed_kt = 6.0, windFrom_deg = 0.0, wind_kt = 0.0;
    double delay_s = 0.0; ///< the track that is sent is so old
    int compassHz = 1;
    bool compassFirst = true;
    double variation_deg = 15.2, variationTold_deg = 15.2;
    double noise_deg = 0.0;
    const char* date = "201125";
    double began_deg = 20.0;
};

/// Magnetic heading at a moment; it turned before the log began, and is steady after it.
inline double headingAt(const Flight& flight, double seconds)
{
    double heading = flight.began_deg + flight.legs.front().rate_deg_s * std::min(0.0, seconds);
    for (const Leg& leg : flight.legs) {
        heading += leg.rate_deg_s * std::clamp(seconds, 0.0, leg.seconds);
        seconds -= std::max(0.0, std::min(seconds, leg.seconds));
    }
    return heading;
}

inline std::string formatted(const char* format, auto... values)
{
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

inline std::string logOf(const Flight& flight)
{
    std::mt19937 random(17);
    std::normal_distribution<double> noise(0.0, 1.0);
    double length_s = 0;
    for (const Leg& leg : flight.legs)
        length_s += leg.seconds;
    std::string log;
    const auto compass = [&](double seconds) {
        const double magnetic_deg = headingAt(flight, seconds);
        double reads_deg = magnetic_deg; // deviations are small: the steps shrink by a factor of ten each
        for (int step = 0; step < 20; ++step)
            reads_deg = magnetic_deg - deviationAt(kTruth, CompassHeading::fromDegrees(reads_deg)).degrees();
        log += makeNmea(formatted("HCHDG,%.1f,,,,", wrap360(std::round(wrap360(reads_deg) * 10) / 10))) + "\r\n";
    };
    const auto track = [&](int second) {
        const double heading = toRadians(headingAt(flight, second - flight.delay_s) + flight.variation_deg);
        const double from = toRadians(flight.windFrom_deg);
        const double east = flight.airspeed_kt * std::sin(heading) - flight.wind_kt * std::sin(from);
        const double north = flight.airspeed_kt * std::cos(heading) - flight.wind_kt * std::cos(from);
        const double made = wrap360(toDegrees(std::atan2(east, north)) + flight.noise_deg * noise(random));
        log += makeNmea(formatted("GPRMC,%02d%02d%02d.00,A,4736.0,N,12218.0,W,%.1f,%.1f,%s,%.1f,%s,A", 9 + second / 3600, second / 60 % 60,
                   second % 60, std::hypot(east, north), made, flight.date, std::abs(flight.variationTold_deg),
                   flight.variationTold_deg < 0 ? "W" : "E"))
            + "\r\n";
    };
    for (int second = 0; second < length_s; ++second) {
        if (flight.compassFirst)
            compass(second);
        track(second);
        for (int part = flight.compassFirst ? 1 : 0; part < flight.compassHz; ++part)
            compass(second + static_cast<double>(part) / flight.compassHz);
    }
    return log;
}

struct Answer {
    NmeaSwing swing;
    Analysis analysis;
    [[nodiscard]] double of(Coefficient which) const { return toDegrees(*analysis.approximate.of(which)); }
    [[nodiscard]] double errorOf(Coefficient which) const { return toDegrees(*analysis.approximate.standardError[indexOf(which)]); }
    [[nodiscard]] bool says(const std::string& words) const
    {
        const auto told = inEnglish(swing.warnings);
        return std::any_of(told.begin(), told.end(), [&](const auto& one) { return one.find(words) != std::string::npos; });
    }
};

inline Answer answerOf(const std::string& log, NmeaOptions options = {})
{
    options.today = "2026-11-26";
    std::istringstream stream(log);
    auto swing = readNmeaSwing(stream, "turn.nmea", options);
    EXPECT_TRUE(swing) << (swing ? "" : swing.error().message.english());
    const Swing record = toSwing(*swing);
    auto analysis = analyse(observationsOf(record), {.shared = record.sharedErrors});
    EXPECT_TRUE(analysis);
    return {std::move(swing.value()), std::move(analysis.value())};
}

/// Figures of a tenth of a degree that are met again and again at the same fraction are out by half of it.
inline void expectTruth(const Answer& answer, double tolerance_deg, const std::string& what)
{
    const std::array truth{0.8, -3.0, 2.0, 1.2, -0.4};
    for (const auto which : {Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E})
        EXPECT_NEAR(answer.of(which), truth[indexOf(which)], tolerance_deg) << letterOf(which) << ' ' << what;
    for (const auto which : kCoefficients)
        EXPECT_LE(std::abs(answer.of(which) - truth[indexOf(which)]), 2.0 * answer.errorOf(which) + 0.05) << letterOf(which) << ' ' << what;
}

} // namespace lubberline::test
