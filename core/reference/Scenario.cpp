#include "core/reference/Scenario.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/base/Number.h"

namespace lubberline {

namespace {

Error notAbove0(Pattern what, double value)
{
    return {ErrorCode::InvalidInput, {MARKED("core", "%1 is %2; expected more than 0"), what, shortestNumber(value)}};
}

Result<void> allAbove0(std::initializer_list<std::pair<Pattern, double>> figures)
{
    for (const auto& [what, value] : figures)
        if (!(value > 0))
            return notAbove0(what, value);
    return {};
}

Result<void> checkVertical(const VerticalGyro& vertical)
{
    const bool damped = vertical.loop == LoopKind::Damped || vertical.loop == LoopKind::Third;
    const bool integral = vertical.loop == LoopKind::Integral || vertical.loop == LoopKind::Third;
    return allAbove0({{MARKED("core", "the levelling time constant (tau1_s)"), vertical.tau1_s},
        {MARKED("core", "the damping time constant (tau2_s)"), damped ? vertical.tau2_s : 1},
        {MARKED("core", "the integral time constant (tau3_s)"), integral ? vertical.tau3_s : 1},
        {MARKED("core", "the levelling rate limit"), vertical.rateLimit_deg_min.value_or(1)},
        {MARKED("core", "the levelling rate limit"), vertical.reverseLimit_deg_min.value_or(1)},
        {MARKED("core", "the cut-off"), vertical.cutoff_deg.value_or(1)},
        {MARKED("core", "the time constant of fast levelling"), vertical.fastUntil_s > 0 ? vertical.fastTau1_s : 1}});
}

Result<void> checkGyro(const HeadingGyro& gyro)
{
    return allAbove0({{MARKED("core", "the slaving time constant"), gyro.slavingTau_s.value_or(1)},
        {MARKED("core", "the slaving rate"), gyro.slavingRate_deg_min.value_or(1)},
        {MARKED("core", "the fast slaving rate"), gyro.fastAbove_deg ? gyro.fastRate_deg_min : 1}});
}

} // namespace

Result<void> checkScenario(const Scenario& scenario)
{
    if (auto fine = allAbove0({{MARKED("core", "the step"), scenario.step_s}}); !fine)
        return fine;
    if (!(scenario.duration_s >= 0))
        return Error{ErrorCode::InvalidInput, MARKED("core", "the duration is negative; expected 0 s or more")};
    if (scenario.duration_s / scenario.step_s > kMostSteps)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 s in steps of %2 s are more than 2000000 steps; expected a wider step"),
                shortestNumber(scenario.duration_s), shortestNumber(scenario.step_s)}};
    for (const Manoeuvre& manoeuvre : scenario.manoeuvres)
        if (!(manoeuvre.to_s > manoeuvre.from_s))
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "a manoeuvre from %1 s to %2 s ends before it begins; expected to_s after from_s"),
                    shortestNumber(manoeuvre.from_s), shortestNumber(manoeuvre.to_s)}};
    if (scenario.gusts)
        if (auto fine = allAbove0({{MARKED("core", "the period of the gusts"), scenario.gusts->period_s}}); !fine)
            return fine;
    if (scenario.vertical)
        if (auto fine = checkVertical(*scenario.vertical); !fine)
            return fine;
    if (scenario.gyro)
        if (auto fine = checkGyro(*scenario.gyro); !fine)
            return fine;
    if (scenario.compass.card)
        if (auto fine = allAbove0({{MARKED("core", "the period of the card"), scenario.compass.card->period_s}}); !fine)
            return fine;
    if (scenario.compass.model && !(scenario.compass.horizontal_nT > 0))
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "the compass's model stands in no horizontal field; expected its field with H above 0")};
    return {};
}

} // namespace lubberline
