// Readings between the table and a spreadsheet: copied, cut and pasted, as a column or a block; all or nothing, one step of undo.

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include "tests/ui/window/Fixture.h"

using namespace lubberline;
using namespace lubberline::ui;

class ReadingsClipboardTest : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void aBlockIsPastedInOneStep();
    void whatSpreadsheetsPutThere_data();
    void whatSpreadsheetsPutThere();
    void aTableOfALetterIsPasted();
    void copiedRowsAreATableInALetter();
    void aNoteMayHaveASemicolon();
    void aColumnIsPastedIntoRowsThatAreThere();
    void headingsSayWhichColumnIsWhich();
    void aRefusedCellIsToldAndNothingIsPasted_data();
    void aRefusedCellIsToldAndNothingIsPasted();
    void copiedBlocksComeBack();
    void copiedWithHeadingsAndTheDesktopsDecimalSign();
    void cutEmptiesInOneStep();
    void northListedTwiceCountsOnce();
    void notesNeverBeginAFormula();
    void whatIsFrozenIsOnlyCopied();

private:
    static std::vector<Reading> stored(SmallFleet& fleet, SwingId swing) { return fleet.stores.swings.swing(swing)->readings; }
    static void paste(OpenWindow& open, const QString& text, int row, ReadingColumn column)
    {
        QGuiApplication::clipboard()->setText(text);
        open.table().goTo(row, column);
        open.trigger("pasteReadings");
    }
    static QString copy(
        OpenWindow& open, int firstRow, ReadingColumn first, int lastRow, ReadingColumn last, const char* action = "copyReadings")
    {
        QGuiApplication::clipboard()->clear();
        const QAbstractItemModel& model = *open.table().model();
        open.table().selectionModel()->select(
            {model.index(firstRow, int(first)), model.index(lastRow, int(last))}, QItemSelectionModel::ClearAndSelect);
        open.trigger(action);
        return QGuiApplication::clipboard()->text();
    }
    static QStringList messages(OpenWindow& open)
    {
        QStringList texts;
        for (const QLabel* label : open.window.findChildren<QLabel*>())
            texts += label->text();
        return texts;
    }
};

void ReadingsClipboardTest::aBlockIsPastedInOneStep()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    QAbstractItemModelTester tester(open.table().model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    paste(open, "0\t358\n45\t42,5\n090\u00B0\t84\u00B030\u2032\nN 45 W\t318\n", 0, ReadingColumn::Magnetic);
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 4u);
    const double expected_deg[][2] = {{0, 358}, {45, 42.5}, {90, 84.5}, {315, 318}};
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(readings[i].magnetic->degrees(), expected_deg[i][0]);
        QCOMPARE(readings[i].compass->degrees(), expected_deg[i][1]);
    }
    open.trigger("undo");
    QVERIFY(stored(fleet, fleet.swing).empty());
    open.trigger("redo");
    QCOMPARE(stored(fleet, fleet.swing).size(), 4u);
    open.trigger("undo");
    QVERIFY(!open.find<QAction>("undo").isEnabled());
}

void ReadingsClipboardTest::whatSpreadsheetsPutThere_data()
{
    QTest::addColumn<QString>("text");
    QTest::newRow("LibreOffice") << "0\t358\n90\t84,5\n";
    QTest::newRow("Excel") << "0\t358\r\n90\t84,5\r\n";
    QTest::newRow("Google Sheets") << "0\t358\n90\t84.5";
    QTest::newRow("old line ends") << "0\t358\r90\t84.5\r";
    QTest::newRow("no-break spaces") << "0\u00A0\t\u202F358\n90\t84,5\u00A0\u00B0\n";
    QTest::newRow("empty rows behind") << "0\t358\n90\t84.5\n\t\n\t\n";
    QTest::newRow("headings") << "Magnetic\tCompass\n0\t358\n90\t84.5\n";
    QTest::newRow("headings of the Swing CSV") << "compass_heading_deg\tMAGNETIC_HEADING_DEG\n358\t0\n84.5\t90\n";
    QTest::newRow("deviations") << "Magnetic heading (\u00B0)\tDeviation\n0\t2 E\n90\t5\u00B030' E\n";
    QTest::newRow("semicolons and decimal commas") << "0;358\n90;84,5\n";
    QTest::newRow("semicolons and headings") << "Magnetic;Compass\r\n0;358\r\n90;84,5\r\n";
    QTest::newRow("a row between that is empty") << "0\t358\n\t\n90\t84.5\n";
}

void ReadingsClipboardTest::whatSpreadsheetsPutThere()
{
    QFETCH(QString, text);
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, text, 0, ReadingColumn::Magnetic);
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 2u);
    QCOMPARE(readings[0].magnetic->degrees(), 0.0);
    QCOMPARE(readings[0].compass->degrees(), 358.0);
    QCOMPARE(readings[1].magnetic->degrees(), 90.0);
    QCOMPARE(readings[1].compass->degrees(), 84.5);
}

/// A mail puts a table there as HTML, its text with a line for each cell; what it names elsewhere is not fetched.
void ReadingsClipboardTest::aTableOfALetterIsPasted()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    auto* data = new QMimeData;
    data->setText("Magnetic\nCompass\n0\n358\n90\n84,5\n");
    data->setHtml("<html><head><link rel='stylesheet' href='file:///etc/passwd'></head><body><p>As read:</p><table border=1>"
                  "<tr><th>Magnetic</th><th>Compass</th></tr><tr><td> 0 </td><td><p><b>358</b></p></td></tr>"
                  "<tr><td>90</td><td>84,5</td></tr></table></body></html>");
    QGuiApplication::clipboard()->setMimeData(data);
    open.table().goTo(0, ReadingColumn::Magnetic);
    open.trigger("pasteReadings");
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 2u);
    QCOMPARE(readings[0].compass->degrees(), 358.0);
    QCOMPARE(readings[1].magnetic->degrees(), 90.0);
    QCOMPARE(readings[1].compass->degrees(), 84.5);
}

void ReadingsClipboardTest::copiedRowsAreATableInALetter()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, "0\t358\n90\t84.5\n", 0, ReadingColumn::Magnetic);
    const QString text = copy(open, 0, ReadingColumn::Magnetic, 1, ReadingColumn::Compass);
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    QCOMPARE(data->text(), text);
    QCOMPARE(data->html().count("<tr>"), 2);
    QCOMPARE(data->html().count("<td>"), 4);
    QVERIFY(data->html().contains("<td>84.5"));
    auto* onlyHtml = new QMimeData; // and back
    onlyHtml->setHtml(data->html());
    QGuiApplication::clipboard()->setMimeData(onlyHtml);
    open.table().goTo(2, ReadingColumn::Magnetic);
    open.trigger("pasteReadings");
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 4u);
    QCOMPARE(readings[3].compass->degrees(), 84.5);
}

void ReadingsClipboardTest::aNoteMayHaveASemicolon()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, "0\t358\n90\t84.5\n", 0, ReadingColumn::Magnetic);
    paste(open, "gusts; turned twice", 0, ReadingColumn::Note);
    QCOMPARE(stored(fleet, fleet.swing)[0].note, std::string("gusts; turned twice"));
}

void ReadingsClipboardTest::aColumnIsPastedIntoRowsThatAreThere()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    open.trigger("layout8");
    paste(open, "0\n45\n90\n135\n180\n225\n270\n315", 0, ReadingColumn::Magnetic);
    paste(open, "358\n42\n84\n131\n182\n229\n275\n318", 0, ReadingColumn::Compass);
    auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 8u);
    QCOMPARE(readings[3].nominal_deg, std::optional(135.0));
    QCOMPARE(readings[3].compass->degrees(), 131.0);
    paste(open, "2 W\n\n3,5 W", 1, ReadingColumn::Deviation);
    readings = stored(fleet, fleet.swing);
    QCOMPARE(readings[1].compass->degrees(), 47.0);
    QVERIFY(!readings[2].compass); // an empty cell empties
    QCOMPARE(readings[3].compass->degrees(), 138.5);
    open.trigger("undo");
    QCOMPARE(stored(fleet, fleet.swing)[2].compass->degrees(), 84.0);
    QCOMPARE(stored(fleet, fleet.swing)[1].compass->degrees(), 42.0);
}

void ReadingsClipboardTest::headingsSayWhichColumnIsWhich()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, "Note\tCompass\tNominal\tMagnetic\ngust\t358\t000\t000.5\n", 0, ReadingColumn::Deviation);
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 1u);
    QCOMPARE(readings[0].note, std::string("gust"));
    QCOMPARE(readings[0].magnetic->degrees(), 0.5);
    QCOMPARE(readings[0].nominal_deg, std::optional(0.0));
    paste(open, "Compass\nsecond line", 0, ReadingColumn::Note); // a note that is a word
    QCOMPARE(stored(fleet, fleet.swing)[0].note, std::string("Compass"));
}

void ReadingsClipboardTest::aRefusedCellIsToldAndNothingIsPasted_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("column");
    QTest::addColumn<QStringList>("says");
    const int magnetic = int(ReadingColumn::Magnetic);
    QTest::newRow("no heading") << "0\t358\n45\tforty\n90\t84\n" << magnetic << QStringList{"row 2", "Compass", "\"forty\""};
    QTest::newRow("cannot be seen") << "0\t358\u200B\n" << magnetic << QStringList{"row 1", "[U+200B]"};
    QTest::newRow("out of range") << "0\t358\n400\t42\n" << magnetic << QStringList{"row 2", "Magnetic", "0 to 360"};
    QTest::newRow("too wide") << "0\t358\t2\t0\t\t\t\tx\n" << magnetic << QStringList{"8 columns", "headings"};
    QTest::newRow("contradiction") << "Magnetic\tCompass\tDeviation\n0\t358\t2\n45\t42\t-3\n"
                                   << magnetic << QStringList{"row 2", "Deviation", "contradicts"};
    QTest::newRow("note in a computed column") << "0\t358\t2\tcalm\n" << magnetic << QStringList{"Residual", "computed", "\"calm\""};
    QTest::newRow("no such heading") << "Magnetic\tWind\n0\t3\n" << magnetic << QStringList{"\"Wind\"", "Nominal, Magnetic"};
    QTest::newRow("heading twice") << "Magnetic\tMagnetic\n0\t3\n" << magnetic << QStringList{"Magnetic", "twice"};
    QTest::newRow("deviation alone") << "2 W\n" << int(ReadingColumn::Deviation) << QStringList{"row 1", "magnetic heading first"};
    QTest::newRow("true without variation") << "274T\t280\n" << magnetic << QStringList{"row 1", "variation"};
    QTest::newRow("open quote") << "0\t\"358\n" << magnetic << QStringList{"not closed"};
    QTest::newRow("nothing") << " \n\n" << magnetic << QStringList{"no text"};
}

void ReadingsClipboardTest::aRefusedCellIsToldAndNothingIsPasted()
{
    QFETCH(QString, text);
    QFETCH(int, column);
    QFETCH(QStringList, says);
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, text, 0, static_cast<ReadingColumn>(column));
    QVERIFY(stored(fleet, fleet.swing).empty());
    QVERIFY(!open.find<QAction>("undo").isEnabled());
    const QStringList told = messages(open).filter("Nothing was pasted");
    QCOMPARE(told.size(), 1);
    for (const QString& words : says)
        QVERIFY2(told.front().contains(words), qPrintable(told.front()));
}

void ReadingsClipboardTest::copiedBlocksComeBack()
{
    SmallFleet fleet;
    const SwingId from = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(from);
    const QString whole = copy(open, 0, ReadingColumn::Nominal, 8, ReadingColumn::Note); // the empty row is none
    QCOMPARE(whole.count('\n'), 8);
    QCOMPARE(whole.section('\n', 0, 0).count('\t'), 6);
    open.window.go(fleet.swing);
    paste(open, whole, 0, ReadingColumn::Nominal);
    const auto before = stored(fleet, from), after = stored(fleet, fleet.swing);
    QCOMPARE(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        QVERIFY(std::abs(after[i].magnetic->degrees() - before[i].magnetic->degrees()) < 1e-9); // without the noise of binary fractions
        QCOMPARE(after[i].compass, before[i].compass);
        QVERIFY(!after[i].nominal_deg);
    }
    QCOMPARE(copy(open, 1, ReadingColumn::Compass, 1, ReadingColumn::Compass), QStringLiteral("45\n"));
}

void ReadingsClipboardTest::copiedWithHeadingsAndTheDesktopsDecimalSign()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", {{0.5, 358.25}, {90, 84}});
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QLocale::setDefault(QLocale(QLocale::Polish));
    const QString text = copy(open, 0, ReadingColumn::Magnetic, 1, ReadingColumn::Deviation, "copyReadingsWithHeadings");
    QCOMPARE(text, QStringLiteral("Magnetic\tCompass\tDeviation\n0,5\t358,25\t2,25\n90\t84\t6\n"));
    open.window.go(fleet.swing);
    paste(open, text, 0, ReadingColumn::Note); // the headings know where
    QCOMPARE(stored(fleet, fleet.swing)[0].compass->degrees(), 358.25);
}

void ReadingsClipboardTest::cutEmptiesInOneStep()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", {{0, 358}, {45, 42}, {90, 84}});
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QCOMPARE(copy(open, 0, ReadingColumn::Compass, 1, ReadingColumn::Compass, "cutReadings"), QStringLiteral("358\n42\n"));
    QVERIFY(!stored(fleet, swing)[0].compass);
    QVERIFY(!stored(fleet, swing)[1].compass);
    QCOMPARE(stored(fleet, swing)[2].compass->degrees(), 84.0);
    open.trigger("undo");
    QCOMPARE(stored(fleet, swing)[0].compass->degrees(), 358.0);
    QCOMPARE(stored(fleet, swing)[1].compass->degrees(), 42.0);
    QVERIFY(!open.find<QAction>("undo").isEnabled());
    copy(open, 1, ReadingColumn::Magnetic, 2, ReadingColumn::Compass);
    open.press(Qt::Key_Delete); // all that is chosen, too
    QVERIFY(!stored(fleet, swing)[1].magnetic);
    QVERIFY(!stored(fleet, swing)[2].compass);
    open.trigger("undo");
    QCOMPARE(stored(fleet, swing)[2].compass->degrees(), 84.0);
}

void ReadingsClipboardTest::northListedTwiceCountsOnce()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    paste(open, "000\t358\n090\t84\n180\t182\n360\t358\n", 0, ReadingColumn::Magnetic);
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings.size(), 4u);
    QVERIFY(readings[0].used());
    QVERIFY(!readings[3].used());
    open.trigger("undo");
    paste(open, "000\t358\n360\t2\n", 0, ReadingColumn::Magnetic);
    for (const auto& reading : stored(fleet, fleet.swing))
        QVERIFY(reading.used());
}

void ReadingsClipboardTest::notesNeverBeginAFormula()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    const QString text = "Magnetic\tNote\n0\t'=1+1\n45\t\"two\nlines\"\n90\tplain \"quotes\"\n";
    paste(open, text, 0, ReadingColumn::Magnetic);
    const auto readings = stored(fleet, fleet.swing);
    QCOMPARE(readings[0].note, std::string("=1+1"));
    QCOMPARE(readings[1].note, std::string("two\nlines"));
    QCOMPARE(readings[2].note, std::string("plain \"quotes\""));
    QCOMPARE(copy(open, 0, ReadingColumn::Note, 2, ReadingColumn::Note), QStringLiteral("'=1+1\n\"two\nlines\"\nplain \"quotes\"\n"));
}

void ReadingsClipboardTest::whatIsFrozenIsOnlyCopied()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    QVERIFY(fleet.stores.signing.complete(swing));
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QVERIFY(!copy(open, 0, ReadingColumn::Magnetic, 1, ReadingColumn::Compass, "cutReadings").isEmpty());
    QVERIFY(stored(fleet, swing)[0].magnetic);
    paste(open, "1\t2\n", 0, ReadingColumn::Magnetic);
    QVERIFY(!messages(open).filter("complete. To change a reading").isEmpty());
    QCOMPARE(stored(fleet, swing)[0].magnetic->degrees(), MagneticHeading::fromDegrees(eightPoints()[0].first).degrees());
}

QTEST_MAIN(ReadingsClipboardTest)
#include "ReadingsClipboardTest.moc"
