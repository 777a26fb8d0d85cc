// Parts of a page in the room that there is: lines that go on beneath, columns that stand above each other, headings in lines, texts in tips.

#include <QtTest>

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QToolTip>
#include <QVBoxLayout>

#include "ui/kit/Page.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/kit/fit/TableFit.h"

using namespace lubberline::ui;

class FitTest : public QObject {
    Q_OBJECT

private slots:
    void aLineGoesOnBeneath();
    void whatExpandsTakesTheRest();
    void columnsStandAboveEachOtherWhereTheyMust();
    void headingsStandInLines();
    void theRoomIsSharedAndTextsGiveWay();
    void headingsAreWholeWhateverComesFirst();
    void wordsOfCellsGoOnBeneathAndNoneIsBroken();
    void aChoiceIsAsWideAsItsWords();
    void aChoiceSaysItsWholeTextAsATip();
    void aTitleThatWouldBecomeAColumnStandsAboveItsButtons();
};

namespace {

QPushButton* buttonOf(QLayout& layout, int width)
{
    auto* button = new QPushButton;
    button->setFixedSize(width, 20);
    layout.addWidget(button);
    return button;
}

} // namespace

void FitTest::aLineGoesOnBeneath()
{
    QWidget widget;
    auto* line = new FlowLayout(&widget);
    const auto* first = buttonOf(*line, 100);
    const auto* second = buttonOf(*line, 100);
    auto* hidden = buttonOf(*line, 500);
    hidden->hide();
    const auto* third = buttonOf(*line, 100);
    widget.resize(320, 100);
    widget.show();
    QCOMPARE(line->minimumSize(), QSize(100, 20));
    QCOMPARE(third->y(), first->y());
    QVERIFY(second->x() > first->geometry().right() && third->x() > second->geometry().right());
    widget.resize(220, 100);
    QCOMPARE(second->y(), first->y());
    QVERIFY(third->y() > first->geometry().bottom());
    QCOMPARE(third->x(), first->x());
    QVERIFY(line->heightForWidth(220) > line->heightForWidth(320));
    QCOMPARE(line->heightForWidth(320), 20);
}

void FitTest::whatExpandsTakesTheRest()
{
    QWidget widget;
    auto* line = new FlowLayout(&widget);
    const auto* first = buttonOf(*line, 100);
    auto* edit = new QLineEdit;
    line->addWidget(edit);
    widget.resize(500, 60);
    widget.show();
    QCOMPARE(first->width(), 100);
    QCOMPARE(edit->geometry().right(), 499);
}

void FitTest::columnsStandAboveEachOtherWhereTheyMust()
{
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    for (int i = 0; i < 8; ++i)
        form->addRow("A label", new QLineEdit);
    auto* plot = new QWidget;
    plot->setMinimumWidth(300);
    QWidget page;
    auto* layout = new QVBoxLayout(&page);
    layout->setContentsMargins(0, 0, 0, 0);
    auto& both = *new SideBySide;
    layout->addWidget(&both);
    auto* panel = new SidePanel(fields);
    both.addWidget(panel);
    both.addWidget(plot);
    page.resize(900, 600);
    page.show();
    QCoreApplication::processEvents();
    QCOMPARE(both.orientation(), Qt::Horizontal);
    QVERIFY(both.minimumSizeHint().width() <= 300);
    page.resize(340, 900);
    QCoreApplication::processEvents();
    QCOMPARE(both.orientation(), Qt::Vertical);
    QVERIFY(plot->y() > panel->geometry().bottom());
    QVERIFY(panel->height() >= fields->minimumSizeHint().height());
    QVERIFY(plot->height() >= 260);
    page.resize(900, 600);
    QCoreApplication::processEvents();
    QCOMPARE(both.orientation(), Qt::Horizontal);
    QCOMPARE(plot->minimumHeight(), 0);
}

void FitTest::headingsStandInLines()
{
    QTableWidget table(2, 2);
    table.setHorizontalHeaderLabels({"N", "one standard deviation of it (°)"});
    const int before = table.horizontalHeader()->sectionSizeHint(1), height = table.horizontalHeader()->sizeHint().height();
    table.setColumnHidden(0, true);
    wrapHeadings(table);
    QVERIFY(table.isColumnHidden(0));
    QVERIFY(2 * table.horizontalHeader()->sectionSizeHint(1) < before + 60);
    QVERIFY(table.horizontalHeader()->sizeHint().height() > 1.7 * height);
    QCOMPARE(table.horizontalHeaderItem(1)->text(), QString("one standard deviation of it (°)")); // its words are as they were
}

void FitTest::theRoomIsSharedAndTextsGiveWay()
{
    QTableWidget table(1, 3);
    table.setHorizontalHeaderLabels({"a", "b", "c"});
    table.verticalHeader()->hide();
    table.setItem(0, 0, new QTableWidgetItem("−12.25"));
    table.setItem(0, 1, new QTableWidgetItem(QString(80, 'w')));
    table.setItem(0, 2, new QTableWidgetItem("1"));
    fitColumns(table);
    table.resize(400, 120);
    table.show();
    const auto wants = [&table](int column) { return static_cast<QAbstractItemView&>(table).sizeHintForColumn(column); };
    const auto sum = [&table] { return table.columnWidth(0) + table.columnWidth(1) + table.columnWidth(2); };
    QCOMPARE(sum(), table.viewport()->width());
    QVERIFY(table.columnWidth(0) > wants(0) && table.columnWidth(2) > wants(2));
    QVERIFY(table.columnWidth(1) < wants(1));
    table.resize(2000, 120);
    QCOMPARE(sum(), table.viewport()->width());
    QVERIFY(table.columnWidth(1) > wants(1));
    table.item(0, 2)->setText("a word that comes later");
    QTRY_VERIFY(table.columnWidth(2) > wants(2));
}

/// A table that is shown with its page, as narrow as its page is: no heading of it is cut, at once and when its words come later.
void FitTest::headingsAreWholeWhateverComesFirst()
{
    QWidget page;
    QVBoxLayout layout(&page);
    QTableWidget table(1, 4);
    table.setHorizontalHeaderLabels({"Largest (°)", "A (°)", "approximate", "comes from"});
    table.horizontalHeader()->setStretchLastSection(true);
    layout.addWidget(&table);
    fitControls(page);
    page.resize(200, 100);
    page.show();
    const auto whole = [&table] {
        for (int column = 0; column < table.columnCount(); ++column)
            if (table.columnWidth(column) < table.horizontalHeader()->sectionSizeHint(column))
                return false;
        return true;
    };
    QTRY_VERIFY(whole());
    table.horizontalHeaderItem(1)->setText("coefficient");
    QTRY_VERIFY(whole());
    QFont larger = table.font();
    larger.setPointSizeF(2 * larger.pointSizeF());
    table.setFont(larger);
    QTRY_VERIFY(whole());
}

/// Beneath its label where it must, and also when its words come after the page was laid out.
void FitTest::wordsOfCellsGoOnBeneathAndNoneIsBroken()
{
    QTableWidget table(40, 3);
    table.setHorizontalHeaderLabels({"State", "Compass", "Why"});
    table.verticalHeader()->hide();
    for (int row = 0; row < table.rowCount(); ++row) {
        table.setItem(row, 0, new QTableWidgetItem(QIcon(QPixmap(16, 16)), "wkrótce wymagany"));
        table.setItem(row, 1, new QTableWidgetItem("No. 1 flux valve of the left wing tip"));
        table.setItem(row, 2, new QTableWidgetItem("z prawdopodobieństwem 24 % poza granicami przed 2028-03-13"));
    }
    fitColumns(table);
    table.resize(table.fontMetrics().horizontalAdvance(QString(55, 'x')), 400);
    table.show();
    QVERIFY(QTest::qWaitForWindowExposed(&table));
    const auto wholeFrom = [&table](int from, int rows) {
        const auto& view = static_cast<const QAbstractItemView&>(table);
        for (int row = from; row < from + rows; ++row) {
            QCOMPARE_GE(table.rowHeight(row), view.sizeHintForRow(row));
            QCOMPARE_GT(table.rowHeight(row), 2 * table.fontMetrics().height());
        }
    };
    const int margins = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
    QCOMPARE_GE(table.columnWidth(0), 16 + margins + table.fontMetrics().horizontalAdvance("wymagany") + margins);
    QCOMPARE_GE(table.columnWidth(2), table.fontMetrics().horizontalAdvance("prawdopodobieństwem") + margins);
    wholeFrom(0, 5);
    table.setCurrentCell(39, 0); // those that come into sight later, too
    QTRY_VERIFY(table.viewport()->rect().contains(table.visualItemRect(table.item(39, 0))));
    wholeFrom(table.rowAt(0), 40 - table.rowAt(0));
    table.scrollToTop();
    table.resize(table.fontMetrics().horizontalAdvance(QString(200, 'x')), 400);
    QCoreApplication::processEvents();
    QCOMPARE(table.rowHeight(0), table.verticalHeader()->defaultSectionSize()); // where there is room they are as they were
}

void FitTest::aChoiceIsAsWideAsItsWords()
{
    QWidget page;
    auto* form = new QFormLayout(&page);
    auto* box = new QComboBox;
    box->addItem("a");
    auto* label = new QLabel("A label that is long enough:");
    form->addRow(label, box);
    fitControls(page);
    page.resize(300, 80);
    page.show();
    QTRY_VERIFY(box->x() > label->geometry().right());
    const QString words = "ellipsoid, the field's size";
    box->addItem(words);
    box->setCurrentIndex(1);
    QTRY_VERIFY(box->width() > box->fontMetrics().horizontalAdvance(words));
    QTRY_VERIFY(box->y() > label->geometry().bottom());
    box->removeItem(1);
    QTRY_VERIFY(box->minimumWidth() < box->fontMetrics().horizontalAdvance(words));
}

void FitTest::aChoiceSaysItsWholeTextAsATip()
{
    QWidget page;
    auto* form = new QFormLayout(&page);
    auto* box = new QComboBox;
    box->addItem(QString(60, 'w'));
    box->setToolTip("what it is for");
    form->addRow("Choice:", box);
    fitControls(page);
    QCOMPARE(form->rowWrapPolicy(), QFormLayout::WrapLongRows);
    page.resize(260, 60);
    page.show();
    QVERIFY(box->sizeHint().width() > 500);
    QVERIFY(page.minimumSizeHint().width() < 500); // no name makes a page wider than that
    QHelpEvent help(QEvent::ToolTip, {5, 5}, box->mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(box, &help);
    QCOMPARE(QToolTip::text(), QString(60, 'w') + "\nwhat it is for");
}

namespace {

struct TitledPage final : Page {
    QPushButton *first = new QPushButton("the first of two buttons"), *second = new QPushButton("the second of two buttons");
    TitledPage()
    {
        head().addWidget(first);
        head().addWidget(second);
        setTitle("PZL-130 · 094 · standby compass · 2026-03-12 check swing, as left");
    }
    const QLabel& line() { return titleLine(); }
};

} // namespace

void FitTest::aTitleThatWouldBecomeAColumnStandsAboveItsButtons()
{
    TitledPage page;
    page.resize(1200, 300);
    page.show();
    QCoreApplication::processEvents();
    QVERIFY(page.line().geometry().right() < page.first->x()); // beside
    page.resize(page.minimumSizeHint().width() + 40, 300);
    QCoreApplication::processEvents();
    QVERIFY(page.line().geometry().bottom() < page.first->y());
    QCOMPARE(page.first->y(), page.second->y());
    QVERIFY(page.first->geometry().right() < page.second->x());
    QVERIFY(page.rect().contains(page.second->geometry()));
    QVERIFY(page.line().height() < 4 * page.line().fontMetrics().lineSpacing());
    page.resize(1200, 300);
    QCoreApplication::processEvents();
    QVERIFY(page.line().geometry().right() < page.first->x());
}

QTEST_MAIN(FitTest)
#include "FitTest.moc"
