#include <gmock/gmock.h>

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DataHash.h"

namespace lubberline::test {

namespace {

struct Parsed {
    QString error, text;
    QMap<QString, int> elements;
    QStringList ids, references; ///< what is fetched or pointed to
};

QByteArray htmlOf(const ui::ReportInput& input)
{
    const QTemporaryDir folder;
    EXPECT_TRUE(ui::writeReport(input, folder.filePath("r.html")).ok());
    return PdfProbe(folder.filePath("r.html")).bytes();
}

Parsed parse(const QByteArray& html)
{
    Parsed parsed;
    QXmlStreamReader reader(html);
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement()) {
            ++parsed.elements[reader.name().toString()];
            for (const auto& attribute : reader.attributes()) {
                if (attribute.name() == u"id")
                    parsed.ids += attribute.value().toString();
                if (attribute.name() == u"src" || attribute.name() == u"href")
                    parsed.references += attribute.value().toString();
            }
        } else if (reader.isCharacters()) {
            parsed.text += reader.text();
        }
    }
    if (reader.hasError())
        parsed.error = reader.errorString();
    return parsed;
}

} // namespace

/// Words, facts, tables and plots: nothing is left in decimals where the window shows minutes.
TEST(ReportHtml, writesAnglesAsTheWindowDoes)
{
    SwingRecord record = simulatedRecord(8);
    record.limits.emplace();
    record.limits->document = "SB 12";
    record.limits->maxDeviation_deg = 7.5;
    ui::showAnglesIn(AngleStyle::DegreesMinutes);
    const QString text = parse(htmlOf(reportOf(record))).text;
    ui::showAnglesIn(AngleStyle::DecimalDegrees);
    static const QRegularExpression decimals(QString::fromUtf8("[^\\n]*\\d\\.\\d+°[^\\n]*"));
    EXPECT_FALSE(decimals.match(text).hasMatch()) << decimals.match(text).captured().toStdString();
    EXPECT_TRUE(text.contains(QString::fromUtf8("7°30'")));
    EXPECT_TRUE(text.contains(QString::fromUtf8("° ′")));
    EXPECT_TRUE(parse(htmlOf(reportOf(record))).text.contains(QString::fromUtf8("7.5°")));
}

TEST(ReportHtml, isWellFormedWithThreePlotsInside)
{
    const Parsed html = parse(htmlOf(reportOf(simulatedRecord(8))));
    EXPECT_TRUE(html.error.isEmpty()) << html.error.toStdString();
    EXPECT_EQ(html.elements["svg"], 3);
    EXPECT_EQ(html.elements["table"], 4); // readings, coefficients, fits, signatures
    EXPECT_GT(html.elements["path"] + html.elements["polyline"], 50);
    EXPECT_EQ(html.elements["image"], 0); // vectors only
    EXPECT_EQ(html.elements["script"], 0);
    EXPECT_EQ(QSet<QString>(html.ids.begin(), html.ids.end()).size(), html.ids.size());
    for (const QString& reference : html.references)
        EXPECT_TRUE(reference.startsWith('#')) << reference.toStdString(); // nothing is fetched
}

TEST(ReportHtml, saysWhatThePdfSays)
{
    SwingRecord record = nga501Record();
    record.aircraft.demonstration = true;
    const auto input = reportOf(record);
    const QString text = parse(htmlOf(input)).text;
    for (const QString& words : {QString("FAIL"), QString("14 CFR 25.1327"), QString("+11.94"), QString("+12.00"),
             QString("DEMONSTRATION DATA"), ui::dataHash(record), QString("http://qwt.sf.net"), QString("Inspector"),
             QString::fromUtf8("magnetic heading − compass heading")})
        EXPECT_TRUE(text.contains(words)) << words.toStdString();
}

TEST(ReportHtml, takesAnyTextOfARecord)
{
    SwingRecord record = simulatedRecord(8);
    record.swing.note = "<script>alert(1)</script> & \"quotes\" \x01\x0b ]]> ąę";
    record.aircraft.registration = "A&B <1>";
    const Parsed html = parse(htmlOf(reportOf(record)));
    EXPECT_TRUE(html.error.isEmpty()) << html.error.toStdString();
    EXPECT_EQ(html.elements["script"], 0);
    EXPECT_TRUE(html.text.contains("<script>alert(1)</script>"));
    EXPECT_TRUE(html.text.contains("A&B <1>"));
}

} // namespace lubberline::test
