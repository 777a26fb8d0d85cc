#include <gtest/gtest.h>

#include "core/format/exchange/JobJson.h"

namespace lubberline {
namespace {

std::vector<JobEvent> everyEvent()
{
    const std::string time = "2026-11-23T10:00:00Z";
    return {{time, job::Ticked{"non-magnetic tools", false}}, {time, job::InterferenceRead{90, "generator", 88.5, 89}},
        {time, job::Prepared{"cold"}}, {time, job::ReadingTaken{3, {{178, 178.5}, {358}, {170.5}}, 178.125, 170.5, "gusty"}},
        {time, job::ReadingRejected{3, "slip"}}, {time, job::StationSkipped{4, "fence"}},
        {time, job::Adjusted{2, Control::NorthSouth, 170, 176, 176, "half a turn"}},
        {time, job::NotAdjusted{3, Control::EastWest, "at its stop"}}, {time, job::IndexRemoved{269, 272, 272}},
        {time, job::IndexLeft{"riveted"}}, {time, job::Accepted{"inspector", "well"}}, {time, job::Faulted{"magnetised"}},
        {time, job::Mended{"degaussed"}}, {time, job::Abandoned{"rain"}},
        {time,
            job::DatumChanged{
                {{}, "theodolite", DatumKind::Theodolite, "Wild", "12", "2027-03-01", SightingDirection::Reciprocal, true, 1.5, 0.1, {}}}}};
}

TEST(JobJson, everyEventReadsBackEqualFromOneLine)
{
    for (const auto& event : everyEvent()) {
        const std::string text = writeJobEvent(event);
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        const auto read = readJobEvent(text, "event");
        ASSERT_TRUE(read) << read.error().message.english();
        EXPECT_EQ(*read, event) << text;
    }
}

TEST(JobJson, planReadsBackEqual)
{
    SwingJob job;
    job.plan = {ProcedureKind::FluxValve, 24, {"radio on", "pitot heat on"}};
    job.checklist = {"a", "b"};
    job.resolution_deg = 0.5;
    const auto read = readJobPlan(writeJobPlan(job), "plan");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(*read, job);
}

TEST(JobJson, faultsNameTheirKey)
{
    const auto says = [](const char* text, const char* words) {
        const auto read = readJobEvent(text, "event");
        ASSERT_FALSE(read) << text;
        EXPECT_NE(read.error().message.english().find(words), std::string::npos) << read.error().message.english();
    };
    says("", "empty");
    says("{}", "what");
    says(R"({"time_utc":"","what":"danced"})", "danced");
    says(R"({"time_utc":"","what":"adjusted","station":1,"control":"up","before_deg":1,"target_deg":1,"after_deg":1})", "control");
    says(
        R"({"time_utc":"","what":"reading_taken","station":1,"magnetic_heading_deg":370,"compass_heading_deg":1})", "magnetic_heading_deg");
    says(R"({"time_utc":"","what":"station_skipped","station":1})", "reason");
    says(R"({"time_utc":"","what":"prepared","colour":1})", "colour");
    EXPECT_FALSE(readJobPlan(R"({"procedure":"coefficient","check_points":9,"resolution_deg":1})", "plan"));
}

} // namespace
} // namespace lubberline
