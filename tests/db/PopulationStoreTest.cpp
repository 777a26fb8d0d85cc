// Swings as columns: what is taken, what is left out and counted, and that others may write meanwhile.

#include <gmock/gmock.h>

#include "db/stores/PopulationStore.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

class PopulationStore : public testing::Test {
protected:
    SwingId add(Date date, SwingState state = SwingState::Complete)
    {
        Swing swing = swingOf(m_stored, date);
        swing.state = state;
        return *save(db::SwingStore(m_database), swing);
    }
    db::Database m_database = inMemory();
    Stored m_stored = store(m_database);
    db::PopulationStore m_population{m_database};
};

TEST_F(PopulationStore, readsTheColumnsOfWhatCounts)
{
    add("2025-05-01");
    Swing swing = swingOf(m_stored, "2024-05-01");
    swing.state = SwingState::Complete;
    swing.stage = SwingStage::AsLeft;
    swing.configuration.radio = RadioState::On;
    swing.people.datumReader = "Ada";
    swing.readings[2].exclusion = Exclusion{"misread"};
    swing.readings[3].compass.reset();
    const auto left = *save(db::SwingStore(m_database), swing);
    Event event;
    event.aircraft = m_stored.aircraft;
    event.date = "2024-12-24";
    event.kind = "struck by lightning";
    ASSERT_TRUE(save(db::FleetStore(m_database), event));

    const auto fleet = m_population.columns({});
    ASSERT_TRUE(fleet);
    ASSERT_EQ(fleet->swings.size(), 2u);
    const auto& first = fleet->swings[0];
    EXPECT_EQ(first.id, left);
    EXPECT_EQ(dateOfDay(first.day), "2024-05-01");
    EXPECT_EQ(first.stage, SwingStage::AsLeft);
    EXPECT_EQ(first.radio, RadioState::On);
    EXPECT_EQ(fleet->crews.at(static_cast<std::size_t>(first.crew)), "Ada");
    EXPECT_EQ(fleet->sites.at(static_cast<std::size_t>(first.site)), "Deblin");
    EXPECT_EQ(first.count, 6u); // neither the excluded nor the incomplete one
    EXPECT_EQ(fleet->swings[1].count, 8u);
    EXPECT_EQ(fleet->swings[1].crew, -1);
    EXPECT_THAT(fleet->magneticOf(fleet->swings[1]), testing::ElementsAre(0, 47, 93, 135, 179, 225, 273, 317));
    ASSERT_EQ(fleet->compasses.size(), 1u);
    EXPECT_EQ(fleet->compasses[0].type, "Su-22");
    EXPECT_EQ(fleet->compasses[0].limit_deg, 10.0);
    EXPECT_NEAR(fleet->compasses[0].readingError_deg, 1 / std::sqrt(12.0), 1e-9);
    ASSERT_EQ(fleet->compasses[0].events.size(), 1u);
    EXPECT_EQ(fleet->compasses[0].events[0].text, "struck by lightning");
    EXPECT_THAT(fleet->leftOut, testing::IsEmpty());
}

TEST_F(PopulationStore, draftsAndSupersededAreLeftOutAndCounted)
{
    add("2025-05-01", SwingState::Draft);
    const auto old = add("2025-06-01");
    Swing amended = swingOf(m_stored, "2025-06-01");
    amended.supersedes = *db::SwingStore(m_database).recordOf(old);
    amended.amendment = "typing error";
    amended.state = SwingState::Draft;
    const auto revision = *save(db::SwingStore(m_database), amended);
    auto fleet = m_population.columns({});
    ASSERT_TRUE(fleet);
    ASSERT_EQ(fleet->swings.size(), 1u); // while the amendment is a draft, what it amends stands
    EXPECT_EQ(fleet->swings[0].id, old);
    EXPECT_EQ(fleet->leftOut, (std::vector<SwingsLeftOut>{{"draft", 2}}));
    Swing complete = *db::SwingStore(m_database).swing(revision);
    complete.state = SwingState::Complete;
    ASSERT_TRUE(save(db::SwingStore(m_database), complete));
    fleet = m_population.columns({});
    ASSERT_EQ(fleet->swings.size(), 1u);
    EXPECT_EQ(fleet->swings[0].id, revision);
    EXPECT_EQ(fleet->leftOut, (std::vector<SwingsLeftOut>{{"draft", 1}, {"superseded", 1}}));
}

TEST_F(PopulationStore, selectsByEachOfItsParts)
{
    add("2023-05-01");
    add("2024-05-01");
    add("2025-05-01");
    const auto count = [&](const FleetSelection& selection) { return m_population.columns(selection)->swings.size(); };
    EXPECT_EQ(count({.from = "2024-05-01", .to = "2024-12-31"}), 1u);
    EXPECT_EQ(count({.type = "Su-22", .site = "Deblin", .compass = "standby compass", .aircraft = "3713"}), 3u);
    EXPECT_EQ(count({.radio = RadioState::On}), 0u);
    EXPECT_EQ(count({.base = "Deblin"}), 0u); // it is not stated where it is based
    const auto unknown = m_population.columns({.type = "Su-23"});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
    EXPECT_THAT(describe(unknown.error()), testing::HasSubstr("aircraft type 'Su-23'"));
    EXPECT_EQ(m_population.columns({}, {}, 2)->swings.size(), 2u);
}

TEST_F(PopulationStore, aReadingThatWasPutInLaterBelongsToItsSwing)
{
    const auto first = add("2023-05-01", SwingState::Draft);
    add("2024-05-01");
    db::SwingStore swings(m_database);
    ASSERT_TRUE(swings.insertReading(first, 8, reading(20, 19)));
    Swing complete = *swings.swing(first);
    complete.state = SwingState::Complete;
    ASSERT_TRUE(save(swings, complete));
    const auto fleet = m_population.columns({});
    ASSERT_TRUE(fleet);
    EXPECT_EQ(fleet->swings[0].count, 9u);
    EXPECT_EQ(fleet->swings[1].count, 8u);
    EXPECT_EQ(fleet->magneticOf(fleet->swings[0])[1], 20);
    EXPECT_EQ(fleet->magnetic_deg.size(), 17u);
}

TEST_F(PopulationStore, theNextDateIsThatOfTheTypesRule)
{
    add("2024-02-29");
    EXPECT_FALSE(m_population.columns({})->compasses[0].due_day);
    DueRule rule;
    rule.name = "ours";
    rule.months = 12;
    ASSERT_TRUE(save(db::DueStore(m_database), rule));
    EXPECT_EQ(dateOfDay(*m_population.columns({})->compasses[0].due_day), "2025-02-28");
}

TEST_F(PopulationStore, cancelsAndIsNoWorseForIt)
{
    for (int i = 0; i < 3; ++i)
        add("2023-05-01");
    const auto cancelled = m_population.columns({}, [](double) { return false; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(m_population.columns({})->swings.size(), 3u);
}

} // namespace lubberline::test
