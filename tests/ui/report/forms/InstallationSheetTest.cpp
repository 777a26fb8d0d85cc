// Where a sensor may stand, on paper: the figures and the verdicts as they were computed.

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "tests/ui/report/page/PdfProbe.h"
#include "ui/report/forms/InstallationSheet.h"

namespace lubberline::test {

namespace {

QString printed(ui::ReferenceSheet sheet)
{
    sheet.madeAtUtc = "2026-11-27T06:00:00Z";
    const QTemporaryDir folder;
    const QString path = folder.filePath("s.pdf");
    EXPECT_TRUE(ui::writeReferenceSheet(sheet, path));
    return PdfProbe(path).flowingText();
}

void expectWords(const QString& text, std::initializer_list<const char*> all)
{
    for (const char* words : all)
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << "\nin " << text.toStdString();
}

} // namespace

TEST(InstallationSheet, printsASourceOfStrayField)
{
    DipoleSource source;
    source.at_m = {0.25, -1.5, 0};
    source.atError_m = {0.004, 0.006, 0.011};
    source.moment_A_m2 = {3, 0, -4}; // of 5 A m²
    source.momentError_A_m2 = 0.125;
    source.uniform_nT = {18000, -250, 44000};
    source.rms_nT = 12.34;
    source.nearest_m = 0.75;
    expectWords(printed(ui::dipoleSheet(source, 24, "hangar.csv")),
        {"Source of a stray field", "hangar.csv", "from 24 readings; 12.3 nT rms", "0.75 m from the source",
            "place (m) +0.250 −1.500 0.000", "its standard error (m) 0.004 0.006 0.011", "moment (A m²) +3.000 0.000 −4.000",
            "uniform field (nT) +18000 −250 +44000", "Size of the moment: 5.000 ± 0.125 A m²", "Performer", "Inspector"});
}

TEST(InstallationSheet, printsASiteCheckWithItsVerdict)
{
    BothWays both;
    both.difference_deg = {1.6, 0.1, -0.2};
    both.standardError_deg = {0.05, 0.07, 0.08};
    both.largest_deg = 1.82;
    both.residual_deg = 0.11;
    both.limit_deg = 1;
    expectWords(printed(ui::siteCheckSheet(both, "cw.csv, ccw.csv")),
        {"Site check", "cw.csv, ccw.csv", "The largest difference, 1.82°, is MORE THAN 1.00°", "0.11° rms are left", "constant +1.60 0.05",
            "with cos of heading −0.20 0.08"});
    both.limit_deg = 2;
    both.passes = true;
    expectWords(printed(ui::siteCheckSheet(both, "cw.csv, ccw.csv")), {"The largest difference, 1.82°, is within 2.00°"});
}

/// Garmin asks 3.0 m of motors, 2.5 m of heavy iron.
TEST(InstallationSheet, printsWhatWasLookedAt)
{
    expectWords(printed(ui::distancesSheet({3.0, 2.1})),
        {"1 of 6 distances are too small; 2 were looked at", "3.00 kept", "TOO NEAR by 0.40 m", "not looked at"});
}

} // namespace lubberline::test
