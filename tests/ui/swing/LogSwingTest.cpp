// A swing from a log: its page is there at once, its results come from a worker, and nothing leaves the page before they are its own.

#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>

#include "tests/ui/window/Fixture.h"
#include "ui/plots/base/Plot.h"
#include "ui/swing/PlotTabs.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

constexpr int kReadings = 2500;

std::vector<std::pair<double, double>> logOf(int readings)
{
    std::vector<std::pair<double, double>> log;
    for (int i = 0; i < readings; ++i) {
        const double heading_deg = std::fmod(0.733 * i, 360.0);
        log.emplace_back(heading_deg, std::fmod(heading_deg + 3 * std::sin(toRadians(heading_deg)) + 0.4 * std::sin(7.0 * i) + 360, 360.0));
    }
    return log;
}

} // namespace

class LogSwingTest : public QObject {
    Q_OBJECT

private slots:
    void thePageIsThereBeforeItsResults();
    void aFigureLeavesTheResultsOfBeforeUntilTheNewOnesAreThere();
    void aPlotLeavesWithItsOwnCurves();
    void nobodySignsWhatIsBeingComputed();
    void leavingEndsTheWork();
    void whoLeavesALogLeavesItsResults();
    void theSwingBeforeIsComputedBesides();

private:
    static SwingEditor& editorOf(OpenWindow& open) { return open.window.findChild<SwingPage*>()->editor(); }
    static void type(OpenWindow& open, int row, const char* figure)
    {
        open.table().goTo(row, ReadingColumn::Compass);
        open.type(figure);
        open.press(Qt::Key_Return);
    }
};

void LogSwingTest::thePageIsThereBeforeItsResults()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", logOf(kReadings));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    auto& editor = editorOf(open);
    QVERIFY(editor.computing());
    QVERIFY(!editor.analysis());
    QCOMPARE(open.table().model()->rowCount(), kReadings + 1);
    QVERIFY2(open.label("meaning").contains("being computed"), qPrintable(open.label("meaning")));
    QVERIFY(open.find<QProgressBar>("computing").isVisible());
    QTRY_VERIFY(!editor.computing());
    QCOMPARE(static_cast<int>(editor.analysis()->readings.size()), kReadings);
    QVERIFY(!open.find<QProgressBar>("computing").isVisible());
    QVERIFY2(!open.label("meaning").contains("computed"), qPrintable(open.label("meaning")));
}

void LogSwingTest::aFigureLeavesTheResultsOfBeforeUntilTheNewOnesAreThere()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", logOf(kReadings));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    auto& editor = editorOf(open);
    editor.settle();
    const auto before = editor.analysis();
    QVERIFY(before && editor.analysed(3) && editor.analysed(4));
    type(open, 3, "92.5");
    QVERIFY(editor.computing());
    QCOMPARE(editor.analysis(), before);
    QVERIFY(!editor.analysed(3)); // it is of another figure
    QVERIFY(editor.analysed(4));
    QVERIFY(!open.find<QWidget>("coefficients").isEnabled());
    QVERIFY2(open.label("meaning").startsWith("Being computed anew"), qPrintable(open.label("meaning")));
    QCOMPARE(editor.record(), *fleet.stores.swings.record(id)); // one row was read, and it is the stored one
    editor.settle();
    const auto whole = fleet.stores.results.resultOf(id);
    QVERIFY(whole && editor.analysis() != before);
    QCOMPARE(editor.analysis()->approximate.value, whole->approximate.value);
    QCOMPARE(editor.analysis()->exact.standardError, whole->exact.standardError);
    QVERIFY(editor.analysed(3)->suspect);
    QVERIFY(open.find<QWidget>("coefficients").isEnabled());
    // What is kept beside the swing is of the new figure, too, and undoing goes the same way.
    const auto rows = fleet.stores.swings.swingsOf(fleet.compass);
    const auto row = std::find_if(rows->begin(), rows->end(), [id](const SwingRow& one) { return one.id == id; });
    QCOMPARE(*row->coefficient_deg[1], toDegrees(*whole->approximate.value[1]));
    QVERIFY(fleet.stores.results.behind(id) && *fleet.stores.results.behind(id) == 0);
    open.trigger("undo");
    QVERIFY(editor.computing());
    QCOMPARE(*fleet.stores.results.behind(id), 1);
    editor.settle();
    QCOMPARE(editor.analysis()->approximate.value, before->approximate.value);
}

void LogSwingTest::aPlotLeavesWithItsOwnCurves()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", logOf(kReadings));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    auto& editor = editorOf(open);
    QVERIFY(editor.computing());
    open.window.findChild<SwingPage*>()->plot()->copyToClipboard();
    QVERIFY(!editor.computing());
    QVERIFY(editor.analysis());
}

void LogSwingTest::nobodySignsWhatIsBeingComputed()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", logOf(kReadings));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QSignalSpy computed(&editorOf(open), &SwingEditor::computed);
    open.trigger("complete"); // waits for them
    QVERIFY(computed.count() > 0);
    QCOMPARE(fleet.stores.swings.swing(id)->state, SwingState::Complete);
    QVERIFY(fleet.stores.signing.reopen(id, "a figure was misread"));
    editorOf(open).settle();
    open.trigger("signSwing");
    QVERIFY(open.find<QPushButton>("changeState").isEnabled());
    type(open, 5, "77");
    QVERIFY(!open.find<QPushButton>("changeState").isEnabled());
    QVERIFY(!open.find<QPushButton>("signButton").isEnabled());
    editorOf(open).settle();
    QVERIFY(open.find<QPushButton>("changeState").isEnabled());
}

void LogSwingTest::leavingEndsTheWork()
{
    SmallFleet fleet;
    const SwingId one = fleet.addSwing("2026-11-21", logOf(kReadings)),
                  other = fleet.addSwing("2026-11-22", {{0, 1}, {120, 121}, {240, 239}});
    OpenWindow open(fleet.stores);
    for (int i = 0; i < 3; ++i) {
        open.window.go(one);
        QVERIFY(editorOf(open).computing());
        open.window.go(other);
        QVERIFY(!editorOf(open).computing());
        QCOMPARE(static_cast<int>(editorOf(open).analysis()->readings.size()), 3);
    }
    QTest::qWait(50);
    QCOMPARE(static_cast<int>(editorOf(open).analysis()->readings.size()), 3);
}

void LogSwingTest::whoLeavesALogLeavesItsResults()
{
    SmallFleet fleet;
    const SwingId one = fleet.addSwing("2026-11-21", logOf(kReadings)),
                  other = fleet.addSwing("2026-11-22", {{0, 1}, {120, 121}, {240, 239}});
    const auto kept = [&] {
        const auto rows = fleet.stores.swings.swingsOf(fleet.compass);
        return std::find_if(rows->begin(), rows->end(), [one](const SwingRow& row) { return row.id == one; })->coefficient_deg[1];
    };
    const auto wanted = [&] { return toDegrees(*fleet.stores.results.resultOf(one)->approximate.value[1]); };
    {
        OpenWindow open(fleet.stores);
        open.window.go(one);
        editorOf(open).settle();
        type(open, 3, "92.5");
        QVERIFY(editorOf(open).computing());
        QVERIFY(!kept()); // nothing rather than what is not true any more
        open.window.go(other);
        QTRY_VERIFY(kept());
        QVERIFY(std::abs(*kept() - wanted()) < 1e-9);
        open.window.go(one);
        editorOf(open).settle();
        type(open, 3, "40");
        QVERIFY(!kept());
    } // the window is closed while it computes
    QVERIFY(kept());
    QVERIFY(std::abs(*kept() - wanted()) < 1e-9);
}

void LogSwingTest::theSwingBeforeIsComputedBesides()
{
    SmallFleet fleet;
    fleet.addSwing("2026-11-21", logOf(kReadings));
    const SwingId now = fleet.addSwing("2026-11-22", {{0, 1}, {120, 121}, {240, 239}});
    OpenWindow open(fleet.stores);
    open.window.go(now);
    QVERIFY(!editorOf(open).computing());
    QCOMPARE(editorOf(open).previous()->date, Date("2026-11-21"));
    QTRY_VERIFY(editorOf(open).previousAnalysis());
    QCOMPARE(static_cast<int>(editorOf(open).previousAnalysis()->readings.size()), kReadings);
}

QTEST_MAIN(LogSwingTest)
#include "LogSwingTest.moc"
