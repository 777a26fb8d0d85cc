#include "core/iron/BenchCheck.h"

#include <algorithm>

#include "core/iron/BenchModel.h"
#include "core/iron/ShapeGeometry.h"

namespace lubberline {

namespace {

using Groups = std::vector<std::pair<std::string, std::vector<std::string>>>;

Error wrong(const Message& what, const Message& why) { return {ErrorCode::InvalidInput, {MARKED("core", "%1: %2"), what, why}}; }

bool within(const Eigen::Vector3d& place_m) { return place_m.allFinite() && place_m.lpNorm<Eigen::Infinity>() <= kBenchReach_m; }

std::string listed(const std::vector<std::string>& words)
{
    std::string text;
    for (const auto& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

Result<void> checkPlacements(const Message& what, const FerrousPart& part)
{
    if (part.group.empty() && (part.placements.size() != 1 || !part.placements.front().state.empty()))
        return wrong(what, MARKED("core", "has no group; expected one placement without a state"));
    std::vector<std::string> states;
    for (const auto& placement : part.placements) {
        if (!within(placement.centre_m))
            return wrong(what, MARKED("core", "its centre must be within 1000 m of the datum"));
        if (!std::isfinite(placement.roll_rad + placement.pitch_rad + placement.yaw_rad))
            return wrong(what, MARKED("core", "its roll, pitch and yaw must be finite"));
        if (!part.group.empty() && placement.state.empty())
            return wrong(what, {MARKED("core", "each placement in the group “%1” names its state"), part.group});
        if (std::find(states.begin(), states.end(), placement.state) != states.end())
            return wrong(what, {MARKED("core", "the state “%1” is there twice"), placement.state});
        states.push_back(placement.state);
    }
    return {};
}

Message whatIsWrong(const CurrentLoop& loop)
{
    if (!within(loop.centre_m))
        return MARKED("core", "the loop's centre must be within 1000 m of the datum");
    if (!loop.normal.allFinite() || !(loop.normal.norm() > 1e-9))
        return MARKED("core", "the loop's normal has no direction");
    if (!(loop.diameter_m > 0 && loop.diameter_m <= kBenchReach_m))
        return MARKED("core", "the loop's diameter must be above 0 m and at most 1000 m");
    return loop.turns >= 1 ? Message() : MARKED("core", "a loop has one turn or more");
}

Message whatIsWrong(const WirePath& path)
{
    if (path.points_m.size() < 2)
        return MARKED("core", "a wire goes through two points or more");
    for (const auto& point_m : path.points_m)
        if (!within(point_m))
            return MARKED("core", "the points of a wire must be within 1000 m of the datum");
    return {};
}

/// The state that the group is in: the chosen one, or its first.
const std::string& stateOf(const Groups& groups, const BenchStates& states, const std::string& group)
{
    if (const auto chosen = states.find(group); chosen != states.end())
        return chosen->second;
    return std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == group; })->second.front();
}

Result<void> checkStates(const Groups& groups, const BenchStates& states)
{
    for (const auto& [group, state] : states) {
        const auto found = std::find_if(groups.begin(), groups.end(), [&name = group](const auto& one) { return one.first == name; });
        if (found == groups.end()) {
            std::vector<std::string> names;
            for (const auto& one : groups)
                names.push_back(one.first);
            return wrong({MARKED("core", "state %1=%2"), group, state},
                {MARKED("core", "there is no such group; expected %1"),
                    names.empty() ? Message(MARKED("core", "none")) : Message::verbatim(listed(names))});
        }
        if (std::find(found->second.begin(), found->second.end(), state) == found->second.end())
            return wrong({MARKED("core", "state %1=%2"), group, state},
                {MARKED("core", "there is no such state; expected %1"), listed(found->second)});
    }
    return {};
}

} // namespace

Groups groupsOf(const IronBench& bench)
{
    Groups groups;
    for (const auto& part : bench.parts) {
        if (part.group.empty())
            continue;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == part.group; });
        if (group == groups.end())
            group = groups.insert(groups.end(), {part.group, {}});
        for (const auto& placement : part.placements)
            if (std::find(group->second.begin(), group->second.end(), placement.state) == group->second.end())
                group->second.push_back(placement.state);
    }
    return groups;
}

Result<void> checkPart(const FerrousPart& part)
{
    const Message what{MARKED("core", "part “%1”"), part.name};
    if (part.name.empty())
        return wrong(MARKED("core", "a part"), MARKED("core", "has no name"));
    const Eigen::Vector3d size_m = sizeOf(part.shape);
    if (!size_m.allFinite() || size_m.minCoeff() <= 0 || size_m.maxCoeff() > kBenchReach_m)
        return wrong(what, MARKED("core", "its sizes must be above 0 m and at most 1000 m"));
    if (size_m.maxCoeff() > kMostSlender * size_m.minCoeff())
        return wrong(what, MARKED("core", "it is more than 10,000 times as long as it is thick"));
    if (!(part.susceptibility >= 0 && part.susceptibility <= 1e9))
        return wrong(what, MARKED("core", "its susceptibility must be 0 or more (SI)"));
    if (!part.remanence_T.allFinite() || part.remanence_T.lpNorm<Eigen::Infinity>() > 10)
        return wrong(what, MARKED("core", "its remanence must be at most 10 T"));
    if (part.placements.empty())
        return wrong(what, MARKED("core", "it is nowhere; expected a placement"));
    return checkPlacements(what, part);
}

Result<void> checkCircuit(const BenchCircuit& circuit)
{
    const Message what{MARKED("core", "circuit “%1”"), circuit.name};
    if (circuit.name.empty())
        return wrong(MARKED("core", "a circuit"), MARKED("core", "has no name"));
    if (circuit.conductors.empty())
        return wrong(what, MARKED("core", "has no loop and no wire"));
    if (!(std::abs(circuit.current_A) <= 1e6))
        return wrong(what, MARKED("core", "its current must be at most 1,000,000 A"));
    for (const auto& conductor : circuit.conductors)
        if (const auto why = std::visit([](const auto& one) { return whatIsWrong(one); }, conductor); !why.empty())
            return wrong(what, why);
    return {};
}

Result<void> checkBench(const IronBench& bench)
{
    if (!within(bench.sensor_m))
        return wrong(MARKED("core", "sensor"), MARKED("core", "it must be within 1000 m of the datum"));
    for (const auto& circuit : bench.circuits)
        if (const auto checked = checkCircuit(circuit); !checked)
            return checked.error();
    for (const auto& part : bench.parts)
        if (const auto checked = checkPart(part); !checked)
            return checked.error();
    const auto groups = groupsOf(bench);
    for (const auto& part : bench.parts)
        for (const auto& [group, states] : groups)
            if (group == part.group && part.placements.size() != states.size())
                return wrong({MARKED("core", "part “%1”"), part.name},
                    {MARKED("core", "the group “%1” has the states %2; expected a placement for each"), group, listed(states)});
    return {};
}

Result<std::vector<Placement>> placementsIn(const IronBench& bench, const BenchStates& states)
{
    const auto groups = groupsOf(bench);
    if (const auto checked = checkStates(groups, states); !checked)
        return checked.error();
    std::vector<Placement> placements;
    for (const auto& part : bench.parts) {
        if (part.group.empty()) {
            placements.push_back(part.placements.front());
            continue;
        }
        const auto& state = stateOf(groups, states, part.group);
        placements.push_back(
            *std::find_if(part.placements.begin(), part.placements.end(), [&](const auto& one) { return one.state == state; }));
    }
    return placements;
}

} // namespace lubberline
