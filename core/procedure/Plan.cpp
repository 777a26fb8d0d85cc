#include "core/procedure/Plan.h"

#include "core/angle/Angle.h"
#include "core/base/Contract.h"

namespace lubberline {

namespace {

constexpr Turn kNorthSouthPart{Control::NorthSouth, HowMuch::CoefficientPart};
constexpr Turn kEastWestPart{Control::EastWest, HowMuch::CoefficientPart};
constexpr Turn kIndex{Control::Index, HowMuch::CoefficientPart};

Station asFound(double nominal_deg, std::vector<Turn> corrections = {})
{
    return {StationPhase::AsFound, nominal_deg, std::move(corrections), 0};
}

std::vector<Station> correctionStations(ProcedureKind kind)
{
    switch (kind) {
    case ProcedureKind::Coefficient: return {asFound(0), asFound(90), asFound(180, {kNorthSouthPart}), asFound(270, {kEastWestPart})};
    case ProcedureKind::HalfError:
        return {asFound(0, {{Control::NorthSouth, HowMuch::All}}), asFound(90, {{Control::EastWest, HowMuch::All}}),
            asFound(180, {{Control::NorthSouth, HowMuch::Half}}), asFound(270, {{Control::EastWest, HowMuch::Half}})};
    case ProcedureKind::IndexFirst:
        return {
            asFound(0), asFound(90), asFound(180), asFound(270, {kIndex, kEastWestPart}), {StationPhase::Correct, 0, {kNorthSouthPart}, 0}};
    case ProcedureKind::FluxValve:
        return {asFound(0), asFound(90), asFound(180), asFound(270, {kIndex}), {StationPhase::Correct, 0, {kNorthSouthPart}, 0},
            {StationPhase::Correct, 90, {kEastWestPart}, 0}};
    case ProcedureKind::CheckOnly: return {};
    }
    return {};
}

} // namespace

std::vector<Station> planOf(const PlanOptions& options)
{
    LUBBERLINE_EXPECT(
        options.checkPoints == 8 || options.checkPoints == 12 || options.checkPoints == 24, "a check swing has 8, 12 or 24 points");
    std::vector<Station> plan = correctionStations(options.kind);
    const double step = 360.0 / options.checkPoints;
    const double last = plan.empty() ? 360.0 - step : plan.back().nominal_deg; // check only: begins on north
    const int configurations = static_cast<int>(options.configurations.size());
    for (int configuration = 0; configuration <= configurations; ++configuration)
        for (int point = 1; point <= options.checkPoints; ++point)
            plan.push_back(
                {configuration == 0 ? StationPhase::Check : StationPhase::Configuration, wrap360(last + point * step), {}, configuration});
    return plan;
}

bool indexAfterCheck(ProcedureKind kind) { return kind == ProcedureKind::Coefficient || kind == ProcedureKind::HalfError; }

double reachOfStation_deg(const PlanOptions& options) { return 180.0 / options.checkPoints; }

} // namespace lubberline
