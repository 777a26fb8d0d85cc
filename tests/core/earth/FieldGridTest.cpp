#include <gtest/gtest.h>

#include "core/earth/FieldGrid.h"

namespace lubberline {
namespace {

TEST(FieldGrid, nodesAreTheModelsPoints)
{
    const FieldModel model = wmm2025();
    for (const auto element :
        {FieldElement::Declination, FieldElement::Inclination, FieldElement::Horizontal, FieldElement::Down, FieldElement::Total}) {
        const auto grid = fieldGrid(model, 2026.5, element, 15.0);
        ASSERT_TRUE(grid);
        EXPECT_EQ(grid->columns, 25);
        EXPECT_EQ(grid->rows, 13);
        ASSERT_EQ(grid->values.size(), 25u * 13u);
        const int row = 9, column = 13; // 45° N, 15° E
        EXPECT_DOUBLE_EQ(grid->latitudeAt_deg(row), 45.0);
        EXPECT_DOUBLE_EQ(grid->longitudeAt_deg(column), 15.0);
        const auto field = model.evaluate(*makePlace(45, 15), 2026.5)->field;
        const double expected = element == FieldElement::Declination ? field.variation().degrees()
            : element == FieldElement::Inclination                   ? toDegrees(field.inclination_rad())
            : element == FieldElement::Horizontal                    ? field.horizontal_nT()
            : element == FieldElement::Down                          ? field.down_nT
                                                                     : field.total_nT();
        EXPECT_NEAR(grid->values[static_cast<std::size_t>(row * 25 + column)], expected, 1e-6);
    }
}

TEST(FieldGrid, cancelAndYears)
{
    const FieldModel model = wmm2025();
    EXPECT_EQ(
        fieldGrid(model, 2026.5, FieldElement::Total, 2.0, [](double done) { return done < 0.5; }).error().code, ErrorCode::Cancelled);
    EXPECT_FALSE(fieldGrid(model, 2020.0, FieldElement::Total));
}

} // namespace
} // namespace lubberline
