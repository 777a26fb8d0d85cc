// What can be ticked or filled in is seen in both themes: its outline stands apart from the window around it.

#include <QtTest>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QRadioButton>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOption>
#include <QTableWidget>

#include <cmath>

#include "ui/kit/Theme.h"

using namespace lubberline::ui;

namespace {

/// Of WCAG 2.1: relative luminance, and how far two of them are apart.
double luminance(QRgb colour)
{
    const auto linear = [](int part) {
        const double share = part / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

double contrast(QRgb one, QRgb other)
{
    const double a = luminance(one), b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// The best contrast to the window on the way from left to the middle of `rect`.
double seen(QWidget& widget, const QRect& rect)
{
    const QImage image = widget.grab().toImage();
    const QRgb ground = widget.palette().color(QPalette::Window).rgb();
    double best = 1;
    for (int x = rect.left(); x < rect.left() + 4; ++x)
        best = std::max(best, contrast(ground, image.pixel(x, rect.center().y())));
    return best;
}

QRect indicatorOf(const QAbstractButton& button, QStyle::SubElement which)
{
    QStyleOptionButton option;
    option.initFrom(&button);
    return button.style()->subElementRect(which, &option, &button);
}

} // namespace

class ThemeTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsTickedOrFilledInIsSeenInTheDark();
    void theOtherWayIsAsItWas();
};

void ThemeTest::whatIsTickedOrFilledInIsSeenInTheDark()
{
    applyTheme(true);
    QWidget window;
    auto* row = new QHBoxLayout(&window);
    auto* elsewhere = new QPushButton("focus");
    auto* check = new QCheckBox("check");
    auto* radio = new QRadioButton("radio");
    auto* line = new QLineEdit;
    auto* number = new QDoubleSpinBox;
    auto* choice = new QComboBox;
    for (QWidget* widget : std::initializer_list<QWidget*>{elsewhere, check, radio, line, number, choice})
        row->addWidget(widget);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    elsewhere->setFocus();
    QCOMPARE_GE(seen(*check, indicatorOf(*check, QStyle::SE_CheckBoxIndicator)), 3.0);
    QCOMPARE_GE(seen(*radio, indicatorOf(*radio, QStyle::SE_RadioButtonIndicator)), 3.0);
    QCOMPARE_GE(seen(*line, line->rect()), 3.0);
    QCOMPARE_GE(seen(*number, number->rect()), 3.0);
    QCOMPARE_GE(seen(*choice, choice->rect()), 3.0);

    line->setFocus(); // and the one that has the keys is told from the others
    QVERIFY(line->grab().toImage().pixel(0, line->height() / 2) != number->grab().toImage().pixel(0, number->height() / 2));

    QTableWidget table(2, 2); // where the next cell is
    table.horizontalHeader()->hide();
    table.verticalHeader()->hide();
    table.show();
    QVERIFY(QTest::qWaitForWindowExposed(&table));
    const QImage cells = table.viewport()->grab().toImage();
    const QRgb base = table.palette().color(QPalette::Base).rgb();
    QCOMPARE_GE(contrast(base, cells.pixel(table.columnWidth(0) - 1, 5)), 1.5);
}

void ThemeTest::theOtherWayIsAsItWas()
{
    applyTheme(false);
    QCheckBox check("check");
    check.show();
    QVERIFY(QTest::qWaitForWindowExposed(&check));
    const QRect box = indicatorOf(check, QStyle::SE_CheckBoxIndicator);
    QCOMPARE_GE(seen(check, box), 1.5); // Fusion's own
    QCOMPARE_LE(seen(check, box), 3.0);
}

QTEST_MAIN(ThemeTest)
#include "ThemeTest.moc"
