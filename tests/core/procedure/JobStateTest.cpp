// Guided swings played event by event: the published worksheets, the other procedures, and what a crew does wrong.
// "Worksheet n": Compass Compensation Worksheet, examples Q1–Q3 (to CAP 562); all figures of the sheets, convention magnetic −
// compass.

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "core/procedure/JobState.h"

namespace lubberline {
namespace {

struct Pair {
    double magnetic_deg, compass_deg;
};

/// A crew with a clipboard.
class Crew {
public:
    explicit Crew(PlanOptions plan = {})
    {
        m_job.plan = std::move(plan);
        m_job.checklist = {"tools"};
        tell(job::Ticked{"tools"});
        tell(job::Prepared{});
    }
    void tell(job::What what) { m_job.events.push_back({"2026-11-23T10:00:00Z", std::move(what)}); }
    JobState state() const
    {
        auto state = stateOf(m_job);
        EXPECT_TRUE(state) << (state ? "" : state.error().message.english());
        return state ? std::move(state.value()) : JobState{};
    }
    std::string refusal() const
    {
        const auto state = stateOf(m_job);
        return state ? std::string() : state.error().message.english();
    }
    void read(Pair pair)
    {
        const int station = state().current;
        tell(job::ReadingTaken{station, {}, pair.magnetic_deg, pair.compass_deg, {}});
    }
    /// Makes the compass read what it is to read.
    MakeCompassRead obey()
    {
        const auto now = state();
        EXPECT_TRUE(now.turn) << now.whyNoTurn.english();
        if (!now.turn)
            return {};
        if (now.phase == JobPhase::Index)
            tell(job::IndexRemoved{now.turn->compassReads_deg, now.turn->makeCompassRead_deg, now.turn->makeCompassRead_deg});
        else
            tell(job::Adjusted{now.current, now.turn->control, now.turn->compassReads_deg, now.turn->makeCompassRead_deg,
                now.turn->makeCompassRead_deg, {}});
        return *now.turn;
    }
    void skip(const char* reason) { tell(job::StationSkipped{state().current, reason}); }
    SwingJob& sheet() { return m_job; }

private:
    SwingJob m_job;
};

struct Worksheet {
    const char* name;
    std::array<Pair, 4> correction; ///< N, E, S, W
    double C_deg, B_deg, onSouth_deg, onWest_deg;
    std::array<Pair, 8> check; ///< NW, N, NE, E, SE, S, SW, W
    double A_deg;
    std::array<double, 8> steer; ///< for 000, 045 … 315
};

const std::array kWorksheets{
    Worksheet{"Q1", {{{359, 3}, {91, 85}, {178, 170}, {267, 265}}}, -6, +2, 176, 263,
        {{{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}}}, 3,
        {1, 43, 89, 137, 181, 223, 269, 317}},
    Worksheet{"Q2", {{{355, 358}, {92, 92}, {184, 183}, {272, 266}}}, -2, -3, 185, 269,
        {{{318, 316}, {1, 0}, {49, 47}, {92, 89}, {137, 135}, {182, 181}, {229, 227}, {276, 273}}}, 2,
        {1, 45, 89, 135, 181, 225, 269, 315}},
    Worksheet{"Q3", {{{2, 355}, {88, 84}, {182, 185}, {268, 272}}}, 5, 4, 180, 268,
        {{{317, 316}, {0, 358}, {48, 47}, {89, 89}, {136, 135}, {183, 181}, {224, 223}, {270, 270}}}, 1,
        {359, 45, 91, 135, 179, 225, 271, 315}},
};

TEST(GuidedSwing, theWorksheetsStepByStep)
{
    for (const auto& sheet : kWorksheets) {
        SCOPED_TRACE(sheet.name);
        Crew crew;
        EXPECT_EQ(crew.state().stations.size(), 12u);
        crew.read(sheet.correction[0]);
        crew.read(sheet.correction[1]);
        EXPECT_DOUBLE_EQ(crew.state().stations[crew.state().current].station.nominal_deg, 180.0);
        crew.read(sheet.correction[2]);
        const auto onSouth = crew.obey();
        EXPECT_EQ(onSouth.control, Control::NorthSouth);
        EXPECT_DOUBLE_EQ(onSouth.coefficient_deg, sheet.C_deg);
        EXPECT_DOUBLE_EQ(onSouth.makeCompassRead_deg, sheet.onSouth_deg);
        crew.read(sheet.correction[3]);
        const auto onWest = crew.obey();
        EXPECT_EQ(onWest.control, Control::EastWest);
        EXPECT_DOUBLE_EQ(onWest.coefficient_deg, sheet.B_deg);
        EXPECT_DOUBLE_EQ(onWest.makeCompassRead_deg, sheet.onWest_deg);
        for (const auto& pair : sheet.check)
            crew.read(pair);
        EXPECT_EQ(crew.state().phase, JobPhase::Index);
        const auto index = crew.obey();
        EXPECT_DOUBLE_EQ(index.coefficient_deg, sheet.A_deg);
        EXPECT_DOUBLE_EQ(index.makeCompassRead_deg, wrap360(sheet.check[7].compass_deg + sheet.A_deg));
        const auto state = crew.state();
        EXPECT_EQ(state.phase, JobPhase::Review);
        for (const auto& row : residualsOf(state))
            EXPECT_DOUBLE_EQ(row.steer_deg, sheet.steer[static_cast<std::size_t>(row.nominal_deg / 45)]) << row.nominal_deg;
        crew.tell(job::Accepted{"inspector", {}});
        EXPECT_EQ(crew.state().phase, JobPhase::Card);
    }
}

TEST(GuidedSwing, checkHeadingsGoOnFromTheLastCorrection)
{
    const auto nominals = [](const PlanOptions& options) {
        std::vector<double> all;
        for (const auto& station : planOf(options))
            all.push_back(station.nominal_deg);
        return all;
    };
    EXPECT_EQ(nominals({}), (std::vector<double>{0, 90, 180, 270, 315, 0, 45, 90, 135, 180, 225, 270}));
    EXPECT_EQ(nominals({ProcedureKind::CheckOnly, 8, {}}), (std::vector<double>{0, 45, 90, 135, 180, 225, 270, 315}));
    EXPECT_EQ(nominals({ProcedureKind::CheckOnly, 12, {"radio on"}}).size(), 24u);
    EXPECT_EQ(nominals({ProcedureKind::HalfError, 24, {}}).size(), 28u);
}

/// Barfield 56-101-01200: all of it on N and E, half of it on S and W; what remains is A alone.
TEST(GuidedSwing, halfErrorLeavesTheIndexAlone)
{
    const double A = 1.5, B = 4.0, C = -6.0;
    double ns = 0, ew = 0; // what the screws have taken out of C and B
    const auto compass = [&](double heading) {
        return wrap360(
            heading - (A + (B - ew) * std::round(std::sin(toRadians(heading))) + (C - ns) * std::round(std::cos(toRadians(heading)))));
    };
    Crew crew({ProcedureKind::HalfError, 8, {}});
    for (const double heading : {0.0, 90.0, 180.0, 270.0}) {
        crew.read({heading, compass(heading)});
        const auto turn = crew.obey();
        const double turned = wrap180(turn.makeCompassRead_deg - turn.compassReads_deg);
        (turn.control == Control::NorthSouth ? ns : ew) += turned * (heading < 135 ? 1 : -1);
        EXPECT_NEAR(wrap180(compass(heading) - turn.makeCompassRead_deg), 0.0, 1e-9);
    }
    EXPECT_NEAR(ns, C, 1e-9);
    EXPECT_NEAR(ew, B, 1e-9);
    // As found: N and E only; the screws had been turned when S and W were read.
    EXPECT_EQ(asFoundSwing(crew.sheet(), crew.state()).readings.size(), 2u);
}

/// Duncan Aviation (MIL-STD-765A practice), errors indicated − actual: N 006, E 090, S 175, W 276 give +5.5, −3 and index
/// +1.75.
TEST(GuidedSwing, fluxValve)
{
    Crew crew({ProcedureKind::FluxValve, 8, {}});
    for (const Pair pair : {Pair{0, 6}, Pair{90, 90}, Pair{180, 175}, Pair{270, 276}})
        crew.read(pair);
    const auto index = crew.obey();
    EXPECT_EQ(index.control, Control::Index);
    EXPECT_DOUBLE_EQ(index.coefficient_deg, -1.75); // ours has the other sign
    EXPECT_DOUBLE_EQ(index.makeCompassRead_deg, 274.25);
    crew.read({0, 4.25});
    const auto north = crew.obey();
    EXPECT_DOUBLE_EQ(north.coefficient_deg, -5.5);
    EXPECT_DOUBLE_EQ(north.makeCompassRead_deg, wrap360(4.25 - 5.5));
    crew.read({90, 88.25});
    const auto east = crew.obey();
    EXPECT_EQ(east.control, Control::EastWest);
    EXPECT_DOUBLE_EQ(east.coefficient_deg, 3.0);
    EXPECT_DOUBLE_EQ(east.makeCompassRead_deg, 91.25);
    EXPECT_EQ(asFoundSwing(crew.sheet(), crew.state()).readings.size(), 4u);
    for (int i = 0; i < 8; ++i)
        crew.read({i * 45.0, i * 45.0});
    EXPECT_EQ(crew.state().phase, JobPhase::Review); // its index has been removed before
}

/// TM 1-1500-204-23-4: N 008, E 086, S 176, W 278; C and B of 6 each; its own table goes 008 → 002 on N and to 092 on E.
TEST(GuidedSwing, theArmysExampleTurnsTheRightWay)
{
    Crew crew({ProcedureKind::IndexFirst, 8, {}});
    for (const Pair pair : {Pair{0, 8}, Pair{90, 86}, Pair{180, 176}, Pair{270, 278}})
        crew.read(pair);
    EXPECT_DOUBLE_EQ(crew.state().turn->coefficient_deg, -2.0);
    crew.tell(job::NotAdjusted{3, Control::Index, "mount is riveted"});
    const auto west = crew.obey();
    EXPECT_DOUBLE_EQ(west.coefficient_deg, 6.0);
    EXPECT_DOUBLE_EQ(west.makeCompassRead_deg, 272.0); // on E it would be 092
    crew.read({0, 8});
    EXPECT_DOUBLE_EQ(crew.obey().makeCompassRead_deg, 2.0);
}

TEST(GuidedSwing, turningAControlAfterTheCheckSwingVoidsIt)
{
    const auto& sheet = kWorksheets[0];
    Crew crew;
    for (int i = 0; i < 4; ++i) {
        crew.read(sheet.correction[i]);
        if (i >= 2)
            crew.obey();
    }
    for (const auto& pair : sheet.check)
        crew.read(pair);
    crew.obey();
    crew.tell(job::Adjusted{11, Control::NorthSouth, 269, 268, 268, "half a turn"});
    const auto state = crew.state();
    EXPECT_EQ(state.phase, JobPhase::Stations);
    EXPECT_EQ(state.current, 4);
    EXPECT_FALSE(state.indexRemoved_deg);
    ASSERT_EQ(state.notes.size(), 1u);
    EXPECT_NE(state.notes[0].english().find("after 8 readings"), std::string::npos) << state.notes[0].english();
    EXPECT_TRUE(residualsOf(state).empty());
    for (const auto& pair : sheet.check)
        crew.read(pair);
    EXPECT_EQ(crew.state().phase, JobPhase::Index);
}

TEST(GuidedSwing, anUnreachableHeadingIsSkippedWithAReason)
{
    const auto& sheet = kWorksheets[0];
    Crew crew;
    crew.read(sheet.correction[0]);
    crew.skip("fence");
    crew.read(sheet.correction[2]);
    EXPECT_DOUBLE_EQ(crew.obey().makeCompassRead_deg, 176.0); // C needs N and S only
    crew.read(sheet.correction[3]);
    EXPECT_FALSE(crew.state().turn);
    EXPECT_NE(crew.state().whyNoTurn.english().find("cardinal"), std::string::npos);
    crew.tell(job::NotAdjusted{3, Control::EastWest, "east could not be reached"});
    for (std::size_t i = 0; i < 8; ++i) {
        if (i == 3)
            crew.skip("fence");
        else
            crew.read(sheet.check[i]);
    }
    // A then comes from the fit of the other seven.
    ASSERT_TRUE(crew.state().index_deg);
    EXPECT_NEAR(*crew.state().index_deg, 2.5, 1.0);
    EXPECT_EQ(asLeftSwing(crew.sheet(), crew.state()).readings.size(), 8u);
    EXPECT_EQ(asLeftSwing(crew.sheet(), crew.state()).readings[3].note, "skipped: fence");
}

TEST(GuidedSwing, furtherConfigurationsAreReadAfterTheIndex)
{
    Crew crew({ProcedureKind::Coefficient, 8, {"radio on"}});
    const auto& sheet = kWorksheets[0];
    for (int i = 0; i < 4; ++i) {
        crew.read(sheet.correction[i]);
        if (i >= 2)
            crew.obey();
    }
    for (const auto& pair : sheet.check)
        crew.read(pair);
    EXPECT_EQ(crew.state().phase, JobPhase::Index);
    crew.obey();
    EXPECT_EQ(crew.state().phase, JobPhase::Stations);
    for (int i = 0; i < 8; ++i)
        crew.read({wrap360(315.0 + i * 45), wrap360(314.0 + i * 45)});
    const auto state = crew.state();
    EXPECT_EQ(state.phase, JobPhase::Review);
    for (const auto& row : residualsOf(state, 1))
        EXPECT_DOUBLE_EQ(row.residual_deg, 1.0);
    EXPECT_EQ(asLeftSwing(crew.sheet(), state, 1).configuration.other, "radio on");
    EXPECT_DOUBLE_EQ(*asLeftSwing(crew.sheet(), state).indexRemoved_deg, 3.0);
}

TEST(GuidedSwing, stepsThatCannotHaveHappenedAreRefused)
{
    const auto refused = [](const std::function<void(Crew&)>& play, const char* words) {
        Crew crew;
        play(crew);
        EXPECT_NE(crew.refusal().find(words), std::string::npos) << crew.refusal();
    };
    refused([](Crew& crew) { crew.tell(job::ReadingTaken{12, {}, 0, 0, {}}); }, "no station 13");
    refused(
        [](Crew& crew) {
            crew.read({0, 1});
            crew.tell(job::ReadingTaken{0, {}, 0, 0, {}});
        },
        "not put aside");
    refused([](Crew& crew) { crew.tell(job::ReadingRejected{0, "slip"}); }, "no reading");
    refused([](Crew& crew) { crew.tell(job::StationSkipped{0, ""}); }, "with a reason");
    refused([](Crew& crew) { crew.tell(job::Adjusted{}); }, "was read");
    refused([](Crew& crew) { crew.tell(job::IndexRemoved{}); }, "not complete");
    refused([](Crew& crew) { crew.tell(job::Accepted{}); }, "not complete");
    refused([](Crew& crew) { crew.tell(job::Mended{"nothing"}); }, "no fault");
    refused([](Crew& crew) { crew.tell(job::Ticked{"coffee"}); }, "not on the checklist");
    refused(
        [](Crew& crew) {
            crew.tell(job::Abandoned{"rain"});
            crew.tell(job::Prepared{});
        },
        "abandoned");
    refused(
        [](Crew& crew) {
            crew.tell(job::Faulted{"magnetised longeron"});
            crew.tell(job::ReadingTaken{});
        },
        "not mended");
    SwingJob unprepared;
    unprepared.checklist = {"tools"};
    unprepared.events.push_back({"", job::Prepared{}});
    EXPECT_FALSE(stateOf(unprepared));
    unprepared.events = {{"", job::ReadingTaken{}}};
    EXPECT_FALSE(stateOf(unprepared));
}

/// The state at any moment of a swing is that of its events so far: a kill loses nothing that was written.
TEST(GuidedSwing, everyBeginningOfAJobIsAJob)
{
    Crew crew;
    const auto& sheet = kWorksheets[1];
    for (int i = 0; i < 4; ++i) {
        crew.read(sheet.correction[i]);
        if (i >= 2)
            crew.obey();
    }
    for (const auto& pair : sheet.check)
        crew.read(pair);
    SwingJob part = crew.sheet();
    int last = crew.state().done();
    while (!part.events.empty()) {
        part.events.pop_back();
        const auto state = stateOf(part);
        ASSERT_TRUE(state);
        EXPECT_LE(state->done(), last);
        last = state->done();
    }
}

} // namespace
TEST(Plan, aStationReachesHalfwayToTheNextCheckPoint)
{
    for (const auto& [points, reach_deg] : {std::pair{8, 22.5}, {12, 15.0}, {24, 7.5}}) {
        PlanOptions options;
        options.checkPoints = points;
        EXPECT_DOUBLE_EQ(reachOfStation_deg(options), reach_deg);
    }
}

} // namespace lubberline
