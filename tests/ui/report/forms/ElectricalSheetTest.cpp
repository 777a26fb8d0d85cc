// The record of an electrical swing on paper: its figures, its tests, what is open, and its sign.

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "core/procedure/ElectricalChecks.h"
#include "tests/ui/report/page/PdfProbe.h"
#include "ui/report/forms/ElectricalSheet.h"

namespace lubberline::test {

/// TM 11-4920-292-15, p. 190: pairs must agree within 0.2°; here 90 and 270 differ by 0.3°.
TEST(ElectricalSheet, printsItsFiguresTestsAndWhatIsOpen)
{
    ui::ElectricalSheet sheet;
    sheet.swing.record = "0f3c1d52-77b1-5a90-8c55-6d2c6f2a9d10";
    sheet.swing.date = "2026-11-20";
    sheet.swing.line = "line 2";
    sheet.swing.calibrator = "MC-2";
    sheet.swing.E1 = {12.5, 12.7};
    sheet.swing.before.indicated_deg = {0.2, 90.4, 180.6, 269.3};
    sheet.swing.after.indicated_deg = {0.3, 90.1, 180.4, 270.4};
    sheet.swing.headings = everyFifteenDegrees();
    sheet.swing.headings[1].indicated_deg = 15.5;
    sheet.swing.by = "Ada";
    sheet.aircraft.registration = "3713";
    sheet.compass.name = "No. 1";
    sheet.madeAtUtc = "2026-11-23T06:00:00Z";
    const QTemporaryDir folder;
    ASSERT_TRUE(ui::writeElectricalSheet(sheet, folder.filePath("e.pdf")));
    const PdfProbe probe(folder.filePath("e.pdf"));
    const QString text = probe.flowingText();
    for (const char* words :
        {"Electrical swing: record", "3713", "No. 1", "2026-11-20", "MC-2", "normal 12.5 V, reversed 12.7 V, mean 12.6 V", "+0.40",
            "DO NOT AGREE within 0.2°", "015 15.50 +0.50", "NOT FINISHED: OPEN POINTS", "E1 and E2 are not both nulled",
            "error = indicated − selected", "Performer Ada", "Inspector", "page 1 of"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words;
    EXPECT_TRUE(text.contains("Sensor sheet not stated"));
    EXPECT_EQ(ui::writeElectricalSheet(sheet, folder.filePath("e.txt")).error().code, ErrorCode::InvalidInput);
}

} // namespace lubberline::test
