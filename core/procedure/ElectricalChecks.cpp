#include "core/procedure/ElectricalChecks.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/angle/Circle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kSlip_deg = 30.0;
constexpr double kMinute_deg = 1.0 / 60.0;
constexpr double kRounding_deg = 1e-9; // figures of tenths add up to 0.2 within rounding
constexpr std::size_t kHeadings = 24;

bool complete(const std::vector<SelectedHeading>& headings)
{
    return headings.size() == kHeadings
        && std::all_of(headings.begin(), headings.end(), [](const SelectedHeading& each) { return each.indicated_deg.has_value(); });
}

/// indicated − selected, with the mean (index) taken out.
std::vector<double> errorsWithoutIndex(const std::vector<SelectedHeading>& headings)
{
    std::vector<double> errors;
    for (const auto& each : headings)
        errors.push_back(wrap180(*each.indicated_deg - each.selected_deg));
    const double roughly_deg = circularMean(errors).mean_deg; // a set turned round has errors on both sides of ±180°
    double sum = 0.0;
    for (double& error : errors)
        sum += error = wrap180(error - roughly_deg);
    for (double& error : errors)
        error -= sum / static_cast<double>(headings.size());
    return errors;
}

} // namespace

std::optional<double> FieldVoltage::mean_V() const
{
    return normal_V && reversed_V ? std::optional((*normal_V + *reversed_V) / 2.0) : std::nullopt;
}

std::vector<SelectedHeading> everyFifteenDegrees()
{
    std::vector<SelectedHeading> headings;
    for (std::size_t i = 0; i < kHeadings; ++i)
        headings.push_back({15.0 * static_cast<double>(i), {}});
    return headings;
}

Result<FourPointErrors> errorsOf(const FourPointTable& table)
{
    FourPointErrors errors;
    for (std::size_t i = 0; i < 4; ++i) {
        const int selected = static_cast<int>(i) * 90;
        if (!table.indicated_deg[i])
            return Error{
                ErrorCode::InvalidInput, {MARKED("core", "nothing is indicated with %1° selected; expected all four points"), selected}};
        errors.error_deg[i] = wrap180(*table.indicated_deg[i] - selected);
        if (std::abs(errors.error_deg[i]) > kSlip_deg)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "with %1° selected the figure is more than 30° off; expected what is indicated there"), selected}};
    }
    const auto& e = errors.error_deg;
    errors.northSouth_deg = (e[0] - e[2]) / 2.0;
    errors.eastWest_deg = (e[1] - e[3]) / 2.0;
    errors.index_deg = (e[0] + e[1] + e[2] + e[3]) / 4.0;
    errors.pair0_180_deg = std::abs(e[0] - e[2]);
    errors.pair90_270_deg = std::abs(e[1] - e[3]);
    errors.pairsAgree = errors.pair0_180_deg <= kPairLimit_deg + kRounding_deg && errors.pair90_270_deg <= kPairLimit_deg + kRounding_deg;
    return errors;
}

Result<SelfCheck> selfCheckOf(const ElectricalSwing& swing)
{
    if (!complete(swing.headings) || !complete(swing.selfCheck))
        return Error{
            ErrorCode::InvalidInput, MARKED("core", "the self-check needs all 24 headings both electrically and by the turntable")};
    for (std::size_t i = 0; i < kHeadings; ++i)
        if (swing.headings[i].selected_deg != swing.selfCheck[i].selected_deg)
            return Error{ErrorCode::InvalidInput,
                MARKED("core", "the two tables of the self-check are of different headings; expected the same in the same order")};
    const auto electrical = errorsWithoutIndex(swing.headings), turntable = errorsWithoutIndex(swing.selfCheck);
    SelfCheck check;
    for (std::size_t i = 0; i < kHeadings; ++i) {
        const double differ = std::abs(electrical[i] - turntable[i]);
        check.largest_deg = std::max(check.largest_deg, differ);
        check.mean_deg += differ / static_cast<double>(kHeadings);
        check.beyondSixMinutes += differ > 6 * kMinute_deg + kRounding_deg;
    }
    const bool oneMayExceed = check.beyondSixMinutes == 1 && check.mean_deg <= 4 * kMinute_deg + kRounding_deg;
    check.passed = check.largest_deg <= 8 * kMinute_deg + kRounding_deg && (check.beyondSixMinutes == 0 || oneMayExceed);
    return check;
}

std::optional<ElectricalErrors> electricalErrorsOf(const ElectricalSwing& swing)
{
    ElectricalErrors all;
    std::vector<double> errors_deg;
    for (const SelectedHeading& one : swing.headings) {
        if (!one.indicated_deg)
            continue;
        const double error_deg = wrap180(*one.indicated_deg - one.selected_deg);
        errors_deg.push_back(error_deg);
        all.slips += std::abs(error_deg) > kSlip_deg;
        if (all.read++ == 0 || std::abs(error_deg) > std::abs(all.largest_deg)) {
            all.largest_deg = error_deg;
            all.largestAt_deg = one.selected_deg;
        }
        for (std::size_t i = 0; i < swing.after.indicated_deg.size(); ++i) {
            const auto& inF1_deg = swing.after.indicated_deg[i];
            if (!inF1_deg || std::abs(wrap180(one.selected_deg - 90.0 * static_cast<double>(i))) > kRounding_deg)
                continue;
            const double differ_deg = wrap180(*one.indicated_deg - *inF1_deg);
            if (std::abs(differ_deg) > std::abs(all.againstF1_deg)) {
                all.againstF1_deg = differ_deg;
                all.againstF1At_deg = one.selected_deg;
            }
        }
    }
    if (all.read == 0)
        return std::nullopt;
    all.mean_deg = circularMean(errors_deg).mean_deg;
    return all;
}

std::vector<Message> openPoints(const ElectricalSwing& swing)
{
    std::vector<Message> open;
    if (swing.line.empty())
        open.push_back(MARKED("core", "the north–south line is not named"));
    if (!swing.E1.mean_V() || !swing.E2.mean_V())
        open.push_back(MARKED("core", "E1 and E2 are not both nulled in NORM and REV"));
    if (const auto after = errorsOf(swing.after); !after)
        open.push_back({MARKED("core", "table F1 after the adjustment: %1"), after.error().message});
    else if (!after->pairsAgree)
        open.push_back(MARKED("core", "the pairs 0/180 and 90/270 do not agree within 0.2°"));
    if (!complete(swing.headings))
        open.push_back(MARKED("core", "not all of the 24 headings are read"));
    const auto errors = electricalErrorsOf(swing);
    if (errors && errors->slips > 0)
        open.push_back({MARKED_N("core", "%n heading(s) indicated more than 30° off what was selected, %1° at %2°: read them again"),
            errors->slips, signedFigureText(errors->largest_deg, 2), shortestNumber(errors->largestAt_deg)});
    else if (errors && std::abs(errors->againstF1_deg) > kPairLimit_deg + kRounding_deg)
        open.push_back(
            {MARKED("core",
                 "with %1° selected the headings indicate %2° more than table F1 after the adjustment; expected the same within 0.2°"),
                shortestNumber(errors->againstF1At_deg), signedFigureText(errors->againstF1_deg, 2)});
    return open;
}

Swing swingFrom(const ElectricalSwing& electrical)
{
    Swing swing;
    swing.date = electrical.date;
    swing.kind = SwingKind::Calibration;
    swing.stage = SwingStage::AsLeft;
    swing.procedure = "electrical swing on the line " + electrical.line;
    swing.datum = {"electrical calibrator " + electrical.calibrator, electrical.calibratorSerial, {}, {}};
    for (const auto& one : electrical.headings) {
        if (!one.indicated_deg)
            continue;
        Reading reading;
        reading.nominal_deg = one.selected_deg;
        reading.magnetic = MagneticHeading::fromDegrees(one.selected_deg);
        reading.compass = CompassHeading::fromDegrees(*one.indicated_deg);
        swing.readings.push_back(std::move(reading));
    }
    return swing;
}

} // namespace lubberline
