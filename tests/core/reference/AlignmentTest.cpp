// Error budgets of alignments, grid headings, tables of variation.

#include <gtest/gtest.h>

#include "core/reference/Alignment.h"
#include "core/reference/Grid.h"
#include "core/reference/VariationTable.h"

namespace lubberline {
namespace {

TEST(Alignment, budgetsAreOfTheBooksSize)
{
    EXPECT_NEAR(budgetOf(TransferGyro{}).total_deg(), 0.1, 0.02); // 0.1° (Kayton and Fried)
    TransferGyro late;
    late.minutes = 60;
    EXPECT_GT(budgetOf(late).total_deg(), 0.5);
    RunwayAlignment runway;
    EXPECT_LT(budgetOf(runway).total_deg(), 0.5);
    runway.wheelbase_m = 100; // over the length of a taxi
    EXPECT_LT(budgetOf(runway).total_deg(), 0.15);
    EXPECT_NEAR(budgetOf(SynchroTransmission{}).total_deg(), 0.2, 1e-12); // 0.2° twice, over √2
    EXPECT_NEAR(withVariation({{{MARKED("core", "setting"), 0.3}}}, 0.4).total_deg(), 0.5, 1e-12);
}

TEST(Grid, convergence)
{
    const Place north{85, 60, 0}, south{-85, 60, 0};
    EXPECT_EQ(convergence_deg(north), 60);
    EXPECT_EQ(convergence_deg(south), -60);
    // Along the meridian of Greenwich grid and true are one; on the other side of the pole north is grid south.
    EXPECT_EQ(gridHeading_deg(TrueHeading::fromDegrees(0), {85, 0, 0}), 0);
    EXPECT_EQ(gridHeading_deg(TrueHeading::fromDegrees(0), {85, -180, 0}), 180);
    // Straight over the pole the true heading turns round at once, the grid heading does not.
    EXPECT_EQ(gridHeading_deg(TrueHeading::fromDegrees(0), {89.9, 30, 0}), gridHeading_deg(TrueHeading::fromDegrees(180), {89.9, -150, 0}));
    EXPECT_EQ(grivation_deg(Variation::fromDegrees(-20), north), -80);
}

TEST(VariationTable, coarserIsWorse)
{
    const FieldModel model = wmm2025();
    const Place place{52.2, 20.9, 0};
    const auto fine = variationTableError(model, place, 2026.5, 1, TableReading::Between);
    const auto coarse = variationTableError(model, place, 2026.5, 5, TableReading::Between);
    const auto nearest = variationTableError(model, place, 2026.5, 5, TableReading::Nearest);
    ASSERT_TRUE(fine && coarse && nearest);
    EXPECT_LT(fine->largest_deg, 0.01);
    EXPECT_GT(coarse->largest_deg, fine->largest_deg);
    EXPECT_GT(nearest->largest_deg, 5 * coarse->largest_deg);
    EXPECT_LE(std::abs(coarse->error_deg), coarse->largest_deg);
    // Beside the magnetic pole no table of 5° helps.
    EXPECT_GT(variationTableError(model, {86, 139, 0}, 2026.5, 5, TableReading::Between)->largest_deg, 20);
    EXPECT_FALSE(variationTableError(model, place, 2026.5, 0, TableReading::Between));
    EXPECT_FALSE(variationTableError(model, place, 2040, 5, TableReading::Between));
    for (const double latitude : {-90.0, 90.0})
        EXPECT_TRUE(variationTableError(model, {latitude, 0, 0}, 2026.5, 7, TableReading::Between));
}

} // namespace
} // namespace lubberline
