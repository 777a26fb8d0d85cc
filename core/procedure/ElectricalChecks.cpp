#include "core/procedure/ElectricalChecks.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

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
    double sum = 0.0;
    for (const auto& each : headings) {
        errors.push_back(wrap180(*each.indicated_deg - each.selected_deg));
        sum += errors.back();
    }
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
