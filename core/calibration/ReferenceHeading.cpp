#include "core/calibration/ReferenceHeading.h"

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/ModelHeader.h"

namespace lubberline {

namespace {

constexpr double kAgreement_deg = 0.02;

/// What headings are rounded to: the coarsest of the usual steps that all are whole numbers of.
double roundingOf(const std::vector<double>& values)
{
    for (const double step : {1.0, 0.5, 0.1, 0.01})
        if (std::all_of(values.begin(), values.end(),
                [step](double value) { return !std::isfinite(value) || std::abs(value / step - std::round(value / step)) < 1e-6; }))
            return step;
    return 0;
}

} // namespace

Message headingOfItsOwn(const SensorLog& log, const std::vector<std::uint8_t>& used)
{
    if (log.heading_deg.empty())
        return {};
    const double allowed = kAgreement_deg + roundingOf(log.heading_deg) / 2;
    for (const bool levelled : {true, false}) {
        double sine = 0, cosine = 0;
        std::vector<double> differences;
        for (std::size_t row = 0; row < log.size(); ++row) {
            if (used[row] == 0 || !std::isfinite(log.heading_deg[row]))
                continue;
            const bool tilted = levelled && !log.pitch_deg.empty() && !log.roll_deg.empty();
            const double own = headingOf_deg(log.at(row), tilted ? log.pitch_deg[row] : 0.0, tilted ? log.roll_deg[row] : 0.0);
            differences.push_back(wrap180(own - log.heading_deg[row]));
            sine += std::sin(toRadians(differences.back()));
            cosine += std::cos(toRadians(differences.back()));
        }
        if (differences.size() < 8)
            return {};
        const double turn = toDegrees(std::atan2(sine, cosine));
        if (std::all_of(
                differences.begin(), differences.end(), [&](double difference) { return std::abs(wrap180(difference - turn)) <= allowed; }))
            return {
                MARKED("core",
                    "heading_deg is what this compass itself reads%1, to %2° in every row: it cannot show its own deviation; expected a "
                    "reference of its own (inertial, GPS, datum compass)"),
                std::abs(turn) > 0.1 ? " (" + signedFigureText(turn, 2) + "°)" : std::string(), figureText(allowed, 2)};
    }
    return {};
}

} // namespace lubberline
