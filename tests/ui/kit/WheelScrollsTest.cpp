// A wheel that is turned over a page scrolls it, whatever comes to lie beneath the pointer: it changes no choice and no number.

#include <QtTest>

#include <QComboBox>
#include <QDateEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/kit/keys/WheelScrolls.h"

using namespace lubberline::ui;

class WheelScrollsTest : public QObject {
    Q_OBJECT

private slots:
    void thePageMovesAndNothingOnItChanges();
};

namespace {

void turnOver(QWidget& widget)
{
    const QPointF place = widget.rect().center();
    QWheelEvent wheel(place, widget.mapToGlobal(place), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&wheel); // as of a hand: Qt carries no other on to what stands around
    qApp->notify(&widget, &wheel);
}

} // namespace

void WheelScrollsTest::thePageMovesAndNothingOnItChanges()
{
    QObject program;
    new WheelScrolls(&program);
    QScrollArea area;
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    auto* choice = new QComboBox;
    choice->addItems({"ellipsoid", "attitude", "sphere"});
    auto* number = new QSpinBox;
    number->setValue(45);
    auto* day = new QDateEdit(QDate(2026, 5, 5));
    for (QWidget* widget : std::initializer_list<QWidget*>{choice, number, day})
        rows->addWidget(widget);
    page->setMinimumHeight(2000);
    area.setWidget(page);
    area.resize(300, 200);
    area.show();
    QVERIFY(QTest::qWaitForWindowExposed(&area));

    for (QWidget* widget : std::initializer_list<QWidget*>{choice, number, day}) {
        const int before = area.verticalScrollBar()->value();
        turnOver(*widget);
        QCOMPARE_GT(area.verticalScrollBar()->value(), before);
        QCOMPARE(widget->focusPolicy(), Qt::StrongFocus);
    }
    QCOMPARE(choice->currentText(), QString("ellipsoid"));
    QCOMPARE(number->value(), 45);
    QCOMPARE(day->date(), QDate(2026, 5, 5));

    choice->setFocus(); // chosen a moment ago
    turnOver(*choice);
    QCOMPARE(choice->currentText(), QString("ellipsoid"));
    QTest::keyClick(choice, Qt::Key_Down);
    QCOMPARE(choice->currentText(), QString("attitude"));
}

QTEST_MAIN(WheelScrollsTest)
#include "WheelScrollsTest.moc"
