// What a screen reader and a keyboard find on every page: each control has a name and a role, Tab reaches each in reading order, the one
// that has the focus is seen, and what a colour says is said by a word or a shape besides.

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTableView>
#include <QTextEdit>
#include <QToolButton>

#include "tests/ui/window/EveryPage.h"
#include "ui/kit/Badge.h"
#include "ui/kit/DueBadge.h"
#include "ui/plots/base/Plot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Roles of what a person acts on.
bool isControl(QAccessible::Role role)
{
    switch (role) {
    case QAccessible::Button:
    case QAccessible::ButtonMenu:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::ComboBox:
    case QAccessible::EditableText:
    case QAccessible::SpinBox:
    case QAccessible::Slider:
    case QAccessible::Table:
    case QAccessible::Tree:
    case QAccessible::List: return true;
    default: return false;
    }
}

void walk(QAccessibleInterface* interface, const std::function<void(QAccessibleInterface&)>& look)
{
    if (!interface || !interface->isValid() || interface->state().invisible)
        return;
    look(*interface);
    const auto role = interface->role();
    if (role == QAccessible::Table || role == QAccessible::Tree || role == QAccessible::List || role == QAccessible::ComboBox
        || role == QAccessible::SpinBox)
        return; // what is inside is data
    for (int i = 0; i < interface->childCount(); ++i)
        walk(interface->child(i), look);
}

QString pathOf(const QObject* object)
{
    QStringList names;
    for (; object && names.size() < 4; object = object->parent())
        names.prepend(QStringLiteral("%1(%2)").arg(QString::fromLatin1(object->metaObject()->className()), object->objectName()));
    return names.join('/');
}

bool insidePlot(const QWidget* widget)
{
    for (const QWidget* above = widget ? widget->parentWidget() : nullptr; above; above = above->parentWidget())
        if (qobject_cast<const Plot*>(above))
            return true;
    return false;
}

QStringList namelessIn(QWidget& window)
{
    QStringList found;
    walk(QAccessible::queryAccessibleInterface(&window), [&](QAccessibleInterface& one) {
        const auto* widget = qobject_cast<const QWidget*>(one.object());
        if (widget && (!widget->isVisible() || widget->objectName().startsWith(QStringLiteral("qt_"))))
            return;
        if (qobject_cast<const QLabel*>(widget) || insidePlot(widget))
            return; // words that can be selected are no control; a plot is one, whatever it is drawn on
        const bool focusable = widget && widget->focusPolicy() != Qt::NoFocus && !widget->focusProxy() && widget->isEnabled()
            && !qobject_cast<const QScrollArea*>(widget);
        if (one.role() == QAccessible::NoRole && focusable)
            found += QStringLiteral("no role: ") + pathOf(widget);
        if ((isControl(one.role()) || focusable) && one.text(QAccessible::Name).trimmed().isEmpty() && widget
            && !qobject_cast<const QTabBar*>(widget))
            found += QStringLiteral("no name: ") + pathOf(widget);
    });
    return found;
}

bool acceptsTab(const QWidget& widget) { return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus); }

bool isActedOn(const QWidget& widget)
{
    return !widget.objectName().startsWith("qt_")
        && (qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QComboBox*>(&widget)
            || qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget)
            || qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget)
            || qobject_cast<const QTabBar*>(&widget) || qobject_cast<const QTextEdit*>(&widget) || qobject_cast<const Plot*>(&widget));
}

/// The fields of a form that Tab goes up by more than a line to: out of reading order.
QStringList jumpsIn(QWidget& page)
{
    QStringList found;
    const QWidget* before = nullptr;
    const QWidget* widget = &page;
    for (int guard = 0; guard < 2000; ++guard) {
        widget = widget->nextInFocusChain();
        if (widget == &page)
            break;
        if (!isActedOn(*widget) || !page.isAncestorOf(widget) || !acceptsTab(*widget) || widget->focusProxy())
            continue;
        if (before && before->parentWidget() == widget->parentWidget()) { // of one form
            const QPoint from = before->mapTo(&page, QPoint()), to = widget->mapTo(&page, QPoint());
            if (to.y() + widget->height() <= from.y() && to.x() < from.x() + before->width())
                found += pathOf(before) + QStringLiteral(" → ") + pathOf(widget);
        }
        before = widget;
    }
    return found;
}

} // namespace

class AccessibilityTest : public QObject {
    Q_OBJECT

private slots:
    void everyControlHasNameAndRole();
    void tabGoesInReadingOrder();
    void theFocusIsSeen();
    void noMeaningByColourAlone();
};

void AccessibilityTest::everyControlHasNameAndRole()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QStringList all;
    everyPage(open, fleet, [&](const QString& where) {
        for (const QString& one : namelessIn(open.window))
            if (const QString line = where.section(',', 0, 0) + QStringLiteral(": ") + one; !all.contains(line))
                all += line;
    });
    QVERIFY2(all.isEmpty(), qPrintable("\n" + all.join('\n')));
}

void AccessibilityTest::tabGoesInReadingOrder()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QStringList all;
    everyPage(open, fleet, [&](const QString& where) {
        for (const QString& one : jumpsIn(open.window.findChild<PageStack*>()->current()))
            if (const QString line = where.section(',', 0, 0) + QStringLiteral(": ") + one; !all.contains(line))
                all += line;
    });
    QVERIFY2(all.isEmpty(), qPrintable("\n" + all.join('\n')));
}

/// A control that has the focus does not look as without it.
void AccessibilityTest::theFocusIsSeen()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QStringList all;
    QSet<QString> seen; // of one class of page, each once
    const auto look = [&](const QString& where) {
        auto& page = open.window.findChild<PageStack*>()->current();
        for (auto* widget : page.findChildren<QWidget*>()) {
            const bool control = isActedOn(*widget) || widget->objectName() == "stationStrip";
            if (!control || seen.contains(pathOf(widget)) || !acceptsTab(*widget) || widget->focusProxy()
                || widget->visibleRegion().isEmpty())
                continue;
            seen.insert(pathOf(widget));
            page.setFocus();
            open.window.setFocus();
            const QImage without = widget->grab().toImage();
            widget->setFocus(Qt::TabFocusReason);
            if (QApplication::focusWidget() != widget)
                continue;
            if (widget->objectName() == "stationStrip")
                QTest::keyClick(widget, Qt::Key_Right);
            if (widget->grab().toImage() == without)
                all += where + QStringLiteral(": ") + pathOf(widget);
        }
    };
    everyPage(open, fleet, look);
    QVERIFY2(all.isEmpty(), qPrintable("\n" + all.join('\n')));
}

/// In grey each badge still has a shape of its own, and each has a word.
void AccessibilityTest::noMeaningByColourAlone()
{
    const auto shape = [](const QIcon& icon) { return icon.pixmap(32).toImage().convertToFormat(QImage::Format_Alpha8); };
    QStringList words;
    QList<QImage> shapes;
    const auto add = [&](const QString& word, const QIcon& icon) {
        QVERIFY(!word.isEmpty() && !words.contains(word));
        words += word;
        QVERIFY2(!shapes.contains(shape(icon)), qPrintable(word));
        shapes += shape(icon);
    };
    for (const Status status : {Status::NotKnown, Status::InLimits, Status::OutOfLimits})
        add(badgeWord(status), badgeIcon(status));
    words.clear();
    shapes.clear();
    for (const DueState state : {DueState::NotDue, DueState::DueSoon, DueState::Due, DueState::Overdue})
        add(dueWord(state), dueIcon(state));
    // What was typed and refused is marked by a word as well as by its colour.
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    auto& built = open.find<QLineEdit>("aircraftBuilt");
    built.setFocus();
    QTest::keyClicks(&built, "never");
    QTest::keyClick(&built, Qt::Key_Return);
    QVERIFY(!built.toolTip().isEmpty());
    QVERIFY2(QAccessible::queryAccessibleInterface(&built)->text(QAccessible::Description).contains(built.toolTip()),
        qPrintable(QAccessible::queryAccessibleInterface(&built)->text(QAccessible::Description)));
}

QTEST_MAIN(AccessibilityTest)
#include "AccessibilityTest.moc"
