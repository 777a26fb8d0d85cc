// The page about the Earth's field and the sensor model.

#include <gmock/gmock.h>

#include <QRegularExpression>
#include <QXmlStreamReader>

#include "core/sensor/PoissonSmith.h"
#include "core/sensor/SensorReading.h"
#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"
#include "ui/report/swing/FieldPage.h"

namespace lubberline::test {

namespace {

const QString kTitle = QStringLiteral("Earth's field and sensor model");

SwingRecord stampedRecord(int points = 8)
{
    SwingRecord record = simulatedRecord(points);
    record.swing.field = FieldStamp{"WMM2025", {51.5544, 21.8936, 121}, "2026-11-20", {18857.7, 2349.7, 46785.2}};
    return record;
}

SensorRecord sensorNamed(const std::string& name)
{
    SensorRecord sensor;
    sensor.name = name;
    sensor.origin = ModelOrigin::IronBench;
    sensor.note = "of the tail";
    sensor.model.softIron(0, 2) = 0.021;
    sensor.model.hardIron_nT = {-620, 480, 350};
    sensor.model.circuits = {{"landing light", {14, -22, 6}, 10, true}};
    sensor.model.misalignment.yaw_rad = toRadians(1.5);
    return sensor;
}

ui::ReportInput reportWithSensor()
{
    auto input = reportOf(stampedRecord());
    input.sensors = {sensorNamed("newest model"), sensorNamed("older model")};
    return input;
}

} // namespace

TEST(ReportField, isLeftOutWhereThereIsNeitherFieldNorModel)
{
    EXPECT_FALSE(ui::fieldPageOf(reportOf(simulatedRecord(8))));
    EXPECT_FALSE(PdfProbe(reportOf(simulatedRecord(8))).text().contains(kTitle));
}

TEST(ReportField, tellsTheStampAndPoissonsCombinations)
{
    const auto input = reportOf(stampedRecord());
    const PdfProbe pdf(input);
    ASSERT_EQ(pdf.pages().size(), 3);
    const QString page = pdf.pages().last().simplified();
    for (const char* words :
        {"Earth's field and sensor model", "WMM2025 for 2026-11-20", "51.5544° N", "north +18857.7, east +2349.7, down +46785.2 nT",
            "H 19003.5 nT", "+67.89° (down +)", "+7.10° (east +)", "(c tan I + P/H) / λ", "(d + b) / 2λ"})
        EXPECT_TRUE(page.contains(QString::fromUtf8(words))) << words;
    const auto expected = ui::signedFigure(input.analysis.exact.of(Coefficient::B), 4);
    EXPECT_TRUE(page.contains(QString::fromUtf8("B (c tan I + P/H) / λ ") + expected)) << expected.toStdString();
    EXPECT_FALSE(page.contains("Sensor model of the compass"));
}

TEST(ReportField, listsWhatALevelSwingTellsAndWhatNot)
{
    const auto page = ui::fieldPageOf(reportOf(stampedRecord()));
    ASSERT_TRUE(page);
    EXPECT_GE(page->unknown.size(), 3);
    EXPECT_TRUE(page->unknown.join(' ').contains("c apart from P"));
    EXPECT_EQ(page->combinations.rows.size(), 5u);
    const auto few = ui::fieldPageOf(reportOf(stampedRecord(4))); // A, B and C only
    ASSERT_TRUE(few);
    ASSERT_EQ(few->unknown.size(), 1);
    EXPECT_TRUE(few->unknown.front().contains("do not tell all five"));
    EXPECT_EQ(few->combinations.rows[3].cells[2], ui::dash());
}

TEST(ReportField, saysWhenTheVariationStatedCannotBeRight)
{
    SwingRecord record = stampedRecord();
    record.swing.variation_deg = 6.5;
    EXPECT_FALSE(PdfProbe(reportOf(record)).flowingText().contains("to be looked at"));
    record.swing.variation_deg = -7.1;
    EXPECT_TRUE(PdfProbe(reportOf(record)).flowingText().contains("they differ by more than"));
}

TEST(ReportField, tellsTheNewestModelWithItsCoefficientsAndMap)
{
    const auto input = reportWithSensor();
    const auto smith = smithOf(input.sensors.front().model, input.record.swing.field->field.meridian());
    ASSERT_TRUE(smith);
    const QString text = PdfProbe(input).flowingText();
    for (const char* words : {"newest model · computed on the iron bench", "of the tail",
             "landing light, 10.0 A, on nT/A +14.00 −22.00 +6.00", "Hard iron P, Q, R nT −620.0 +480.0 +350.0",
             "Misalignment: roll, pitch, yaw ° 0.00 0.00 +1.50", "Deviation over heading and roll, modelled", "MODELLED"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words;
    EXPECT_FALSE(text.contains("older model"));
    EXPECT_TRUE(text.contains(QString::fromUtf8("λ = ") + ui::figure(smith->lambda, 4)));
    const auto page = ui::fieldPageOf(input);
    EXPECT_EQ(page->smith.rows[1].cells[1], ui::signedFigure(smith->exact.B, 4));
    EXPECT_TRUE(page->smith.rows[1].cells[3].contains("hard iron P"));
}

TEST(ReportField, theMapIsThatOfTheModelInTheSwingsField)
{
    const auto input = reportWithSensor();
    const auto page = ui::fieldPageOf(input);
    ASSERT_TRUE(page && page->map);
    EXPECT_FALSE(page->map->measured);
    EXPECT_EQ(page->map->limit_deg, 10.0);
    const DeviationMap& map = *page->map->map;
    ASSERT_EQ(map.request.x.axis, AttitudeAxis::Heading);
    ASSERT_EQ(map.request.y.axis, AttitudeAxis::Roll);
    const auto field = input.record.swing.field->field.meridian();
    for (const auto& [x, y] : {std::pair{0, 0}, {45, 60}, {120, 10}, {180, 120}}) {
        const Attitude attitude{MagneticHeading::fromDegrees(map.request.x.at_deg(x)), 0, toRadians(map.request.y.at_deg(y))};
        EXPECT_NEAR(
            map.deviation_rad[map.index(x, y)], readSensor(input.sensors.front().model, field, attitude).deviation->radians(), 1e-12);
    }
}

TEST(ReportField, aModelWithoutAFieldIsListedWithoutFigures)
{
    auto input = reportOf(simulatedRecord(8));
    input.sensors = {sensorNamed("newest model")};
    const auto page = ui::fieldPageOf(input);
    ASSERT_TRUE(page);
    EXPECT_TRUE(page->field.empty() && page->smith.rows.empty() && !page->map);
    const QString text = PdfProbe(input).flowingText();
    EXPECT_TRUE(text.contains("the swing keeps no field"));
    EXPECT_TRUE(text.contains("newest model"));
}

TEST(ReportField, aModelThatHasNoCoefficientsSaysWhy)
{
    auto input = reportWithSensor();
    input.sensors.front().model.softIron(0, 0) = -1.5;
    input.sensors.front().model.softIron(1, 1) = -1.5;
    const auto smith = smithOf(input.sensors.front().model, input.record.swing.field->field.meridian());
    ASSERT_FALSE(smith);
    const auto page = ui::fieldPageOf(input);
    EXPECT_TRUE(page->smith.rows.empty());
    EXPECT_EQ(page->sensor.back().value, QString::fromStdString(smith.error().message.english()));
    EXPECT_FALSE(PdfProbe(input).flowingText().contains(QRegularExpression("\\b(nan|inf)\\b", QRegularExpression::CaseInsensitiveOption)));
}

TEST(ReportField, standsInTheHtmlWithAFourthPlotAndFetchesNothing)
{
    const QTemporaryDir folder;
    ASSERT_TRUE(ui::writeReport(reportWithSensor(), folder.filePath("r.html")));
    QXmlStreamReader reader(PdfProbe(folder.filePath("r.html")).bytes());
    int plots = 0;
    QString text;
    while (!reader.atEnd()) {
        reader.readNext();
        plots += reader.isStartElement() && reader.name() == u"svg";
        if (reader.isCharacters())
            text += reader.text();
        if (reader.isStartElement())
            for (const auto& attribute : reader.attributes())
                if (attribute.name() == u"href" || attribute.name() == u"src") {
                    EXPECT_TRUE(attribute.value().startsWith(u'#') || attribute.value().startsWith(u"data:"))
                        << attribute.value().toString().toStdString();
                }
    }
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    EXPECT_EQ(plots, 4);
    EXPECT_TRUE(text.contains(kTitle));
    EXPECT_TRUE(text.contains("newest model"));
}

TEST(ReportField, theArchiveHasItWithoutTransparency)
{
    auto input = reportWithSensor();
    input.archive = true;
    const PdfProbe pdf(input);
    EXPECT_TRUE(pdf.text().contains("MODELLED"));
    for (const auto& [key, count] : pdf.suspiciousObjects())
        EXPECT_EQ(key, "image") << count; // the colours of the map; no transparency
}

TEST(ReportField, theHashIsThatOfTheAttachedRecordWithItsField)
{
    const auto input = reportWithSensor();
    SwingRecord without = input.record;
    without.swing.field.reset();
    EXPECT_NE(ui::dataHash(input.record), ui::dataHash(without));
    const PdfProbe pdf(input);
    const auto exchange = ui::exchangeInReport(pdf.path());
    ASSERT_TRUE(exchange);
    EXPECT_THAT(*exchange, testing::HasSubstr("\"model\": \"WMM2025\""));
}

} // namespace lubberline::test
