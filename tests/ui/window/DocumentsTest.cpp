// Documents are painted on a worker: the window goes on meanwhile, and can cancel or be closed.

#include <QPrinter>
#include <QTest>

#include "tests/ui/window/Fixture.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// A log's worth of readings: some fifty pages.
std::vector<std::pair<double, double>> longSwing()
{
    std::vector<std::pair<double, double>> readings;
    for (int i = 0; i < 3000; ++i) {
        const double compass_deg = wrap360(0.7 * i);
        readings.emplace_back(wrap360(compass_deg + 1 + 3 * std::sin(toRadians(compass_deg))), compass_deg);
    }
    return readings;
}

struct LongReport {
    SmallFleet fleet;
    SwingId swing = fleet.addSwing("2026-11-22", longSwing());
    std::unique_ptr<OpenWindow> open = std::make_unique<OpenWindow>(fleet.stores);
    QString path = open->folder.filePath("long.pdf");

    /// Until it is being written.
    void begin()
    {
        open->window.go(swing);
        dynamic_cast<SwingPage&>(open->window.findChild<PageStack*>()->current()).editor().settle();
        open->dialogs.answer = path;
        open->find<QAction>("report").trigger();
        for (auto* documents : open->window.findChildren<Gathering*>())
            documents->finish();
        QVERIFY(open->find<QWidget>("progressStrip").isVisible());
        QVERIFY(!QFile::exists(path));
    }
};

} // namespace

class DocumentsTest : public QObject {
    Q_OBJECT

private slots:
    void theWindowGoesOnWhileAReportIsPainted();
    void cancelledNothingIsLeft();
    void aWindowThatIsClosedMeanwhileLeavesNoHalfFile();
    void everyOutputOfAPageIsWritten();
    void aPreviewCanBeCancelledBetweenPages();
};

void DocumentsTest::theWindowGoesOnWhileAReportIsPainted()
{
    LongReport report;
    report.begin();
    report.open->window.go(report.fleet.aircraft); // another page, and back
    QApplication::processEvents();
    QVERIFY(report.open->find<QWidget>("progressStrip").isVisible());
    report.open->window.go(report.swing);
    report.open->finishWriting();
    QVERIFY(QFileInfo(report.path).size() > 100'000);
    QVERIFY2(report.open->window.messages().shown().contains(report.path), qPrintable(report.open->window.messages().shown()));
    report.open->find<QPushButton>("answerMessage").click();
    QCOMPARE(report.open->dialogs.openedOutside, report.path);
}

void DocumentsTest::cancelledNothingIsLeft()
{
    LongReport report;
    report.begin();
    report.open->find<QPushButton>("cancelJob").click();
    report.open->finishWriting();
    QVERIFY(!QFile::exists(report.path));
    QCOMPARE(report.open->window.messages().shown(), QStringLiteral("Cancelled: nothing was changed."));
}

void DocumentsTest::aWindowThatIsClosedMeanwhileLeavesNoHalfFile()
{
    for (int turns = 0; turns < 4; ++turns) { // while pages are laid out, while charts are drawn, while pages are painted
        LongReport report;
        report.begin();
        for (int i = 0; i < 40 * turns; ++i)
            QTest::qWait(1);
        const bool written = QFile::exists(report.path);
        report.open.reset(); // with its folder; it must not wait for ever, nor end before its worker
        QVERIFY(!written || turns > 0);
    }
}

void DocumentsTest::everyOutputOfAPageIsWritten()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-22", eightPoints());
    OpenWindow open(fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    int written = 0;
    for (const PageDescription& page : stack->descriptions()) {
        for (const Command& output : page.outputs) {
            if (!stack->show(Destination{page.id, fleet.compass}))
                QVERIFY2(static_cast<bool>(stack->show(Destination{page.id, swing})), qPrintable(page.id));
            if (auto* shown = dynamic_cast<SwingPage*>(&stack->current())) {
                open.window.go(swing);
                shown->editor().settle();
            }
            auto& action = open.find<QAction>(qPrintable(output.name));
            if (!action.isEnabled() || output.name.contains("print", Qt::CaseInsensitive))
                continue;
            const QString path = open.folder.filePath(page.id + "-" + output.name + ".pdf");
            open.dialogs.answer = path;
            open.dialogs.suggested.clear();
            open.window.messages().clear();
            open.trigger(qPrintable(output.name));
            if (open.dialogs.suggested.isEmpty() || !open.dialogs.suggested.endsWith(".pdf"))
                continue; // it says why not, or is no document
            QVERIFY2(QFileInfo(path).size() > 1000, qPrintable(path + ": " + open.window.messages().shown()));
            QVERIFY2(open.window.messages().shown().contains(path), qPrintable(open.window.messages().shown()));
            ++written;
        }
    }
    QVERIFY2(written >= 8, qPrintable(QString::number(written)));
}

void DocumentsTest::aPreviewCanBeCancelledBetweenPages()
{
    LongReport report;
    auto& open = *report.open;
    open.window.go(report.swing);
    dynamic_cast<SwingPage&>(open.window.findChild<PageStack*>()->current()).editor().settle();
    int pages = 0;
    open.dialogs.patience = [&pages](double) { return ++pages < 3; };
    open.dialogs.onPreview = [&](const std::function<void(QPrinter&)>& paint) {
        QPrinter printer;
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(report.path);
        paint(printer);
    };
    open.trigger("print");
    QCOMPARE(open.dialogs.previews, 1);
    QCOMPARE(pages, 3);
    QCOMPARE(open.window.messages().shown(), QString()); // who cancels knows it
}

QTEST_MAIN(DocumentsTest)
#include "DocumentsTest.moc"
