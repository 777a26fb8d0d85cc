#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QFile>

#include "core/format/exchange/Exchange.h"
#include "tests/ui/report/page/PdfProbe.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/report/page/DataHash.h"

namespace lubberline::test {

namespace {

QString fileWith(const QTemporaryDir& folder, const QString& name, const QByteArray& bytes)
{
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return file.fileName();
}

} // namespace

TEST(ReportAttachment, isTheExchangeFileByteForByteAndReadsBack)
{
    for (const int points : {4, 8, 36}) {
        SwingRecord record = simulatedRecord(points);
        record.swing.readings[1].exclusion = Exclusion{"a \"reason\" with ąę and −"};
        const PdfProbe pdf(reportOf(record));
        const auto exchange = ui::exchangeInReport(pdf.path());
        ASSERT_TRUE(exchange.ok()) << describe(exchange.error());
        EXPECT_EQ(*exchange, writeExchange(toFleet(record)));
        const auto fleet = readExchange(*exchange, "report.pdf");
        ASSERT_TRUE(fleet.ok()) << describe(fleet.error());
        EXPECT_EQ(*fleet, toFleet(record));
    }
}

TEST(ReportAttachment, aBitThatTurnedOverIsSeen)
{
    const PdfProbe pdf(reportOf(simulatedRecord(8)));
    QFile file(pdf.path());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    const auto whole = ui::exchangeInPdf(bytes.toStdString(), "report.pdf");
    ASSERT_TRUE(whole);
    const auto named = bytes.indexOf("/EF <</F ") + 9; // the number of the object that holds it
    const QByteArray object = "\n" + bytes.mid(named, bytes.indexOf(' ', named) - named) + " 0 obj";
    const auto begin = bytes.indexOf("stream", bytes.indexOf(object)), end = bytes.indexOf("endstream", begin);
    ASSERT_GT(end - begin, 300);
    int refused = 0;
    for (auto at = begin + 7; at < end; ++at) {
        QByteArray damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        const auto read = ui::exchangeInPdf(damaged.toStdString(), "report.pdf");
        if (!read)
            ++refused;
        else
            EXPECT_EQ(*read, *whole) << at;
    }
    EXPECT_GT(refused, end - begin - 20); // a bit of the line's end in front of "endstream" changes nothing
}

TEST(ReportAttachment, hasThePrintedHash)
{
    const auto input = reportOf(simulatedRecord(8));
    const auto exchange = ui::exchangeInReport(PdfProbe(input).path());
    ASSERT_TRUE(exchange.ok());
    const QByteArray digest = QCryptographicHash::hash(QByteArray::fromStdString(*exchange), QCryptographicHash::Sha256).toHex();
    EXPECT_EQ(QString::fromLatin1(digest), ui::dataHash(input.record));
    EXPECT_EQ(digest.size(), 64);
}

TEST(DataHash, changesWithEveryFigureAndWithNothingElse)
{
    const SwingRecord record = simulatedRecord(8);
    const QString hash = ui::dataHash(record);
    EXPECT_EQ(ui::dataHash(record), hash);
    for (std::size_t i = 0; i < record.swing.readings.size(); ++i) {
        SwingRecord changed = record;
        changed.swing.readings[i].compass = CompassHeading::fromDegrees(changed.swing.readings[i].compass->degrees() + 1e-9);
        EXPECT_NE(ui::dataHash(changed), hash) << i;
        changed = record;
        changed.swing.readings[i].magnetic = MagneticHeading::fromDegrees(changed.swing.readings[i].magnetic->degrees() + 0.1);
        EXPECT_NE(ui::dataHash(changed), hash) << i;
        changed = record;
        changed.swing.readings[i].exclusion = Exclusion{"why"};
        EXPECT_NE(ui::dataHash(changed), hash) << i;
    }
    SwingRecord stored = record; // the rows of a database are no data
    stored.swing.id.value = 4711;
    stored.aircraft.id.value = 12;
    stored.swing.readings[0].id.value = 99;
    EXPECT_EQ(ui::dataHash(stored), hash);
}

TEST(ReportAttachment, refusesWhatIsNoReportAndSaysWhy)
{
    const QTemporaryDir folder;
    const auto codeOf = [](const QString& path) { return ui::exchangeInReport(path).error().code; };
    EXPECT_EQ(codeOf(folder.filePath("missing.pdf")), ErrorCode::Io);
    EXPECT_EQ(codeOf(folder.path()), ErrorCode::Io);
    EXPECT_EQ(codeOf(fileWith(folder, "empty.pdf", {})), ErrorCode::Format);
    EXPECT_EQ(codeOf(fileWith(folder, "text.pdf", "magnetic_heading_deg,compass_heading_deg\n0,1\n")), ErrorCode::Format);
    EXPECT_EQ(codeOf(fileWith(folder, "head.pdf", "%PDF-1.6\nnothing else")), ErrorCode::Format);
    const auto error = ui::exchangeInReport(folder.filePath("text.pdf")).error();
    EXPECT_NE(error.message.english().find("not a PDF"), std::string::npos);
    EXPECT_EQ(error.file, folder.filePath("text.pdf").toStdString());
}

TEST(ReportAttachment, aTruncatedReportIsAnErrorOrWhole)
{
    const auto input = reportOf(simulatedRecord(8));
    const QByteArray whole = PdfProbe(input).bytes();
    const QTemporaryDir folder;
    for (const int part : {1, 2, 4, 8, 9}) {
        const auto exchange = ui::exchangeInReport(fileWith(folder, "cut.pdf", whole.left(whole.size() * part / 10)));
        if (exchange.ok())
            EXPECT_EQ(*exchange, writeExchange(toFleet(input.record))) << part;
        else
            EXPECT_EQ(exchange.error().code, ErrorCode::Format) << part;
    }
}

TEST(ReportAttachment, aCardCarriesNone)
{
    const PdfProbe card(cardOf(simulatedRecord(12), {}));
    const auto exchange = ui::exchangeInReport(card.path());
    ASSERT_FALSE(exchange.ok());
    EXPECT_EQ(exchange.error().code, ErrorCode::Format);
    EXPECT_NE(exchange.error().message.english().find("no exchange data"), std::string::npos);
}

} // namespace lubberline::test
