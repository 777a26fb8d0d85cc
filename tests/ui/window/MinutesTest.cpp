// Where degrees and minutes are chosen, no page writes an angle with decimals: in its words, its tables, its plots or at the pointer.

#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QTableWidget>

#include "tests/ui/window/EveryPage.h"
#include "ui/plots/base/Plot.h"
#include "ui/text/AngleWords.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// What is typed is typed as before: fields and what may be edited are left out.
QStringList decimalsIn(QWidget& page)
{
    static const QRegularExpression decimal(QStringLiteral("\\d\\.\\d+°(?!\\s?/)"));
    QStringList found;
    const auto look = [&](const QString& text, const QWidget& of) {
        if (const auto match = decimal.match(text); match.hasMatch())
            found += QStringLiteral("%1(%2): %3").arg(of.metaObject()->className(), of.objectName(), text.simplified());
    };
    for (const auto* label : page.findChildren<QLabel*>())
        if (label->isVisible())
            look(label->text(), *label);
    for (const auto* list : page.findChildren<QListWidget*>())
        for (int row = 0; list->isVisible() && row < list->count(); ++row)
            look(list->item(row)->text(), *list);
    for (const auto* table : page.findChildren<QTableWidget*>())
        for (int row = 0; table->isVisible() && row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                if (const auto* item = table->item(row, column)) {
                    look(item->text(), *table);
                    const bool typed = (item->flags() & Qt::ItemIsEditable) && table->editTriggers() != QAbstractItemView::NoEditTriggers;
                    const auto* head = table->horizontalHeaderItem(column);
                    if (!typed && head && head->text().contains("(°)"))
                        look(item->text() + u'°', *table);
                }
    return found;
}

/// What each plot says at places of it.
QStringList saidBy(QWidget& page)
{
    static const QRegularExpression decimal(QStringLiteral("\\d\\.\\d+°(?!\\s?/)"));
    QStringList found;
    for (auto* plot : page.findChildren<Plot*>()) {
        if (!plot->isVisible())
            continue;
        const auto hears = QObject::connect(plot, &Plot::readOut, plot, [&](const QString& text) {
            if (decimal.match(text).hasMatch())
                found += QStringLiteral("%1: %2").arg(plot->name(), text);
        });
        for (auto* canvas : plot->findChildren<QWidget*>())
            for (const double part : {0.3, 0.5, 0.8})
                if (canvas->isVisible() && !canvas->rect().isEmpty())
                    QTest::mouseMove(canvas, QPoint(int(part * canvas->width()), int(part * canvas->height())));
        QObject::disconnect(hears);
    }
    return found;
}

} // namespace

class MinutesTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { showAnglesIn(AngleStyle::DecimalDegrees); }
    void everyPageFollows();
    void aPageFollowsWhileItIsSeen();
};

void MinutesTest::everyPageFollows()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.find<QAction>("minutes").setChecked(true);
    QStringList all;
    everyPage(open, fleet, [&](const QString& where) {
        auto& page = open.window.findChild<PageStack*>()->current();
        for (const QString& one : decimalsIn(page) + saidBy(page))
            if (const QString line = where.section(',', 0, 0) + QStringLiteral(": ") + one; !all.contains(line))
                all += line;
    });
    QVERIFY2(all.isEmpty(), qPrintable("\n" + all.join('\n')));
}

void MinutesTest::aPageFollowsWhileItIsSeen()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QCOMPARE(open.find<QTableWidget>("coefficients").item(0, 0)->text(), QString("+1.00"));
    open.find<QAction>("minutes").setChecked(true);
    QCOMPARE(open.find<QTableWidget>("coefficients").item(0, 0)->text(), QString("1°00'E"));
    open.find<QAction>("minutes").setChecked(false);
    QCOMPARE(open.find<QTableWidget>("coefficients").item(0, 0)->text(), QString("+1.00"));
}

QTEST_MAIN(MinutesTest)
#include "MinutesTest.moc"
