#include "app/Tables.h"

#include <algorithm>
#include <optional>

#include "app/Console.h"
#include "core/angle/PrintedHeading.h"
#include "core/deviation/SlipWords.h"
#include "core/swing/CardRemarks.h"
#include "ui/report/card/CardWords.h"

namespace lubberline::app {

namespace {

constexpr int kSmithColumn = 12;

std::string signedCell(std::optional<double> value, int width, int decimals)
{
    return value ? text("%+*.*f", width, decimals, *value) : text("%*s", width, "-");
}

std::string cell(std::optional<double> value, int decimals)
{
    return value ? text("%*.*f", kSmithColumn, decimals, *value) : text("%*s", kSmithColumn, "-");
}

std::optional<double> degrees(std::optional<double> angle_rad) { return angle_rad ? std::optional(toDegrees(*angle_rad)) : std::nullopt; }

std::string readingsTable(const Analysis& analysis)
{
    std::string out = "magnetic  compass  deviation  residual (deg)\n"
                      "   (deg)    (deg)  (deg, E+)    approx.     exact\n";
    for (const auto& reading : analysis.readings) {
        out += text("%8.2f %8.2f   %+8.2f ", printedHeading_deg(reading.magnetic.degrees(), 2),
            printedHeading_deg(reading.compass.degrees(), 2), reading.deviation.degrees());
        out += signedCell(degrees(reading.residualApproximate_rad), 10, 2) + signedCell(degrees(reading.residualExact_rad), 10, 2);
        if (reading.suspect)
            out += "  <- look again";
        out += "\n";
    }
    return out;
}

std::string slipsTable(const Analysis& analysis)
{
    std::string out;
    for (const auto& slip : analysis.slips.slips) {
        const auto& reading = analysis.readings[slip.reading];
        out += text("look again at %.1f magnetic, which reads %.1f: %s with %.0f %%", printedHeading_deg(reading.magnetic.degrees(), 1),
            printedHeading_deg(reading.compass.degrees(), 1),
            slip.orReadings.empty() ? "it was misread" : "one of the readings that cannot be told apart was misread",
            100 * slip.probability);
        for (const auto& candidate : slip.candidates)
            out += candidate.slip == Slip::Unexplained
                ? text("; %s %.0f %%", wordFor(candidate.slip).english().c_str(), 100 * candidate.probability)
                : candidate.slip == Slip::WrongRow ? text("; %s, it fits %.1f, %.0f %%", wordFor(candidate.slip).english().c_str(),
                      printedHeading_deg(candidate.meant_deg, 1), 100 * candidate.probability)
                                                   : text("; %s, %.1f meant, %.0f %%", wordFor(candidate.slip).english().c_str(),
                                                       printedHeading_deg(candidate.meant_deg, 1), 100 * candidate.probability);
        out += "\n";
    }
    return out;
}

std::string pointRuleCell(const std::optional<PointRules>& rules, Coefficient coefficient)
{
    if (!rules)
        return {};
    const std::optional<double> values_rad[] = {rules->A_rad, rules->B_rad, rules->C_rad, rules->D_rad, rules->E_rad};
    return signedCell(degrees(values_rad[indexOf(coefficient)]), kSmithColumn + 3, 3);
}

std::string coefficientsTable(const Analysis& analysis)
{
    const auto& rules = analysis.pointRules;
    std::string out = text("\n%13s%12s%12s%12s%12s%12s", "approx. (deg)", "s.e.", "95 % +-", "exact", "s.e.", "95 % +-");
    out += rules ? text("%15s\n", rules->points == 8 ? "8-point (deg)" : "4-point (deg)") : "\n";
    for (const Coefficient coefficient : kCoefficients) {
        const auto i = indexOf(coefficient);
        out += letterOf(coefficient) + signedCell(degrees(analysis.approximate.value[i]), kSmithColumn, 3);
        out += cell(degrees(analysis.approximate.standardError[i]), 3) + cell(degrees(analysis.approximate.interval95(coefficient)), 3);
        out += signedCell(analysis.exact.value[i], kSmithColumn, 5);
        out += cell(analysis.exact.standardError[i], 5) + cell(analysis.exact.interval95(coefficient), 5);
        out += pointRuleCell(rules, coefficient) + "\n";
    }
    out += text("rms residual: approximate %.3f deg, exact %.3f deg; condition number %.1f\n", toDegrees(analysis.approximate.rms_rad),
        toDegrees(analysis.exact.rms_rad), analysis.approximate.conditionNumber);
    return out;
}

std::string harmonicsTable(const Harmonics& harmonics)
{
    std::string out = text("\nharmonics on magnetic heading (%s)\norder       sin       cos  amplitude (deg)\n",
        harmonics.method == HarmonicsMethod::Fft ? "FFT" : "least squares");
    for (const auto& order : harmonics.orders)
        out += text("%5d %+9.3f %+9.3f %10.3f%s\n", order.order, toDegrees(order.sin_rad), toDegrees(order.cos_rad),
            toDegrees(order.amplitude_rad()), order.nyquist ? "  (its sine cannot be seen)" : "");
    if (harmonics.noiseFloor_rad)
        out += text("noise floor (95 %%): %.3f deg\n", toDegrees(*harmonics.noiseFloor_rad));
    return out;
}

} // namespace

std::string tableOf(const Analysis& analysis)
{
    const auto& summary = analysis.summary;
    return readingsTable(analysis) + slipsTable(analysis) + coefficientsTable(analysis) + harmonicsTable(analysis.harmonics)
        + text("\nlargest deviation %+.2f deg at magnetic heading %.1f deg; rms %.2f deg\n", toDegrees(summary.largestDeviation_rad),
            printedHeading_deg(summary.maxAbsDeviationAt.degrees(), 1), toDegrees(summary.rmsDeviation_rad))
        + "deviation = magnetic - compass, east positive; approximate fit on compass heading, exact fit on magnetic heading\n";
}

std::string tableOf(const Analysis& analysis, const Removal& removal, CoefficientSet removed)
{
    std::string out = "\nwithout";
    for (const Coefficient coefficient : kCoefficients)
        if (removed.test(indexOf(coefficient)))
            out += std::string(" ") + letterOf(coefficient);
    out += ":\nmagnetic  deviation  would remain (deg)\n";
    for (std::size_t i = 0; i < analysis.readings.size(); ++i)
        out += text("%8.2f   %+8.2f  %+12.2f\n", analysis.readings[i].magnetic.degrees(), analysis.readings[i].deviation.degrees(),
            toDegrees(removal.remaining_rad[i]));
    out += text("largest %.2f deg, rms %.2f deg (before: %.2f, %.2f)\n", toDegrees(removal.maxAbs_rad), toDegrees(removal.rms_rad),
        toDegrees(analysis.summary.maxAbsDeviation_rad), toDegrees(analysis.summary.rmsDeviation_rad));
    out += "order  amplitude before  after (deg)\n";
    for (std::size_t k = 0; k < std::min(analysis.harmonics.orders.size(), removal.harmonics.orders.size()); ++k)
        out += text("%5zu  %16.3f  %11.3f\n", k, toDegrees(analysis.harmonics.orders[k].amplitude_rad()),
            toDegrees(removal.harmonics.orders[k].amplitude_rad()));
    return out;
}

std::string tableOf(const Correction& correction)
{
    std::string out = text("A %+.2f deg   B %+.2f deg   C %+.2f deg   (deviation = magnetic - compass, east positive)\n\n"
                           "coefficient  on  magnetic  compass reads  make compass read\n",
        toDegrees(correction.A_rad), toDegrees(correction.B_rad), toDegrees(correction.C_rad));
    for (const auto& step : correction.steps)
        out += text("%11c  %2c  %8.1f  %13.1f  %17.1f\n", letterOf(step.coefficient), letterOf(step.on),
            printedHeading_deg(step.magnetic.degrees(), 1), printedHeading_deg(step.compassReads.degrees(), 1),
            printedHeading_deg(step.makeCompassRead.degrees(), 1));
    return out + "Correct C on one of N and S, then B on one of E and W.\n";
}

std::string tableOf(const ui::CardInput& input)
{
    const auto& columns = input.columns;
    const bool byCompass = columns.front().card.options.by == CardBy::Compass;
    const auto figureOf = [byCompass](const CardRow& row) { return byCompass ? row.magneticRounded_deg() : row.steerRounded_deg(); };
    std::string out;
    if (const QString banner = ui::cardBanner(input); !banner.isEmpty() && !input.record().swing.record.empty())
        out = banner.toStdString() + "\n"; // of a file nobody asks whether it is signed
    out += byCompass ? "COMPASS" : "    FOR";
    for (const auto& column : columns)
        out += text("  %12s  +-95%%", byCompass && columns.size() == 1 ? "MAGNETIC" : column.heading.toStdString().c_str());
    out += "\n";
    for (std::size_t row = 0; row < columns.front().card.rows.size(); ++row) {
        const CardRow& first = columns.front().card.rows[row];
        out += text("    %03d", byCompass ? first.steerRounded_deg() : first.magneticRounded_deg());
        for (const auto& column : columns) {
            const CardRow& here = column.card.rows[row];
            out += text("  %9s%-3s", text("%03d", figureOf(here)).c_str(), ui::markOf(here, column).toStdString().c_str());
            out += here.band_rad ? text("  %5.1f", bandInTenths_deg(*here.band_rad)) : text("  %5s", "-");
        }
        out += "\n";
    }
    for (const auto& column : columns) {
        const std::string of = columns.size() > 1 ? column.heading.toStdString() + ": " : "";
        if (const Date& swung = column.record.swing.date; columns.size() > 1 && !swung.empty()) // they may be years apart
            out += of + "swung " + swung.text() + "\n";
        out += of + ui::recordLine(column).toStdString() + "\n";
        out += of + ui::qualityLine(column).toStdString() + "\n" + of + ui::largestLine(column).toStdString() + "\n";
        for (const auto& remark : inEnglish(remarksOn(column.card, column.record)))
            out += of + remark + "\n";
    }
    const std::string marks = "* nobody read near this row; ! over the limit";
    return out
        + (byCompass ? "MAGNETIC: the magnetic heading when the compass reads COMPASS (degrees)\n"
                     : "FOR: magnetic heading to make good; STEER: compass heading (degrees)\n")
        + marks + "\n";
}

} // namespace lubberline::app
