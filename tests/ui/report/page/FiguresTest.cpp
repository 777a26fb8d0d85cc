#include <gtest/gtest.h>

#include <limits>

#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/Figures.h"

namespace lubberline::test {

TEST(Figures, haveOneSignAndNoNegativeZero)
{
    EXPECT_EQ(ui::signedFigure(3.25, 2), "+3.25");
    EXPECT_EQ(ui::signedFigure(-0.5, 2), QString::fromUtf8("−0.50"));
    EXPECT_EQ(ui::signedFigure(0.0, 1), "0.0");
    EXPECT_EQ(ui::signedFigure(-0.0, 1), "0.0");
    EXPECT_EQ(ui::signedFigure(-0.004, 2), "0.00");
    EXPECT_EQ(ui::signedFigure(0.004, 2), "0.00");
    EXPECT_EQ(ui::figure(-0.001, 1), "0.0");
}

TEST(Figures, whatIsMissingOrNotFiniteIsADash)
{
    EXPECT_EQ(ui::signedFigure({}, 2), ui::dash());
    EXPECT_EQ(ui::figure(std::numeric_limits<double>::quiet_NaN(), 2), ui::dash());
    EXPECT_EQ(ui::signedFigure(std::numeric_limits<double>::infinity(), 2), ui::dash());
}

TEST(AngleFigures, showWhatWasReadWithTheDecimalsOfTheReadings)
{
    SwingRecord record = worksheetRecord(kWorksheet[0]);
    EXPECT_EQ(ui::AngleFigures(AngleStyle::DecimalDegrees, record.swing).heading(317.0), "317.0");
    record.swing.readings[0].compass = CompassHeading::fromDegrees(316.25);
    EXPECT_EQ(ui::AngleFigures(AngleStyle::DecimalDegrees, record.swing).heading(47.0), "047.00");
    EXPECT_EQ(ui::AngleFigures(AngleStyle::DecimalDegrees, record.swing).angle(-3.0), QString::fromUtf8("−3.00"));
    record.swing.readings[0].compass = CompassHeading::fromDegrees(1.0 / 3.0);
    EXPECT_EQ(ui::AngleFigures(AngleStyle::DecimalDegrees, record.swing).decimals(), 3);
}

TEST(AngleFigures, keepTheSignsOfDegreesAndMinutes)
{
    const ui::AngleFigures figures(AngleStyle::DegreesMinutes, worksheetRecord(kWorksheet[0]).swing);
    EXPECT_TRUE(figures.heading(47.5).startsWith(QString::fromUtf8("047°30")));
    EXPECT_TRUE(figures.angle(-3.25).endsWith("W"));
    EXPECT_EQ(figures.heading({}), ui::dash());
}

} // namespace lubberline::test
