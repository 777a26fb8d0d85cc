#include "ui/kit/keys/ControlNames.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>

namespace lubberline::ui {

namespace {

bool wantsName(const QWidget& widget)
{
    if (widget.objectName().startsWith(QStringLiteral("qt_")) || !widget.accessibleName().isEmpty())
        return false;
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text().isEmpty();
    if (qobject_cast<const QScrollArea*>(&widget) || qobject_cast<const QTabBar*>(&widget) || qobject_cast<const QTabWidget*>(&widget))
        return false;
    return (widget.focusPolicy() & Qt::TabFocus) || qobject_cast<const QAbstractSlider*>(&widget)
        || qobject_cast<const QAbstractItemView*>(&widget);
}

QLabel* labelAt(const QLayoutItem* item)
{
    auto* label = item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
    return label && !label->text().isEmpty() ? label : nullptr;
}

/// In a box the one just before it, in a grid the one at its left, else above it.
QLabel* labelIn(QLayout& layout, QWidget& widget)
{
    const int index = layout.indexOf(&widget);
    if (index < 0)
        return nullptr;
    if (auto* grid = qobject_cast<QGridLayout*>(&layout)) {
        int row = 0, column = 0, rows = 0, columns = 0;
        grid->getItemPosition(index, &row, &column, &rows, &columns);
        QLabel* left = column > 0 ? labelAt(grid->itemAtPosition(row, column - 1)) : nullptr;
        return left || row == 0 ? left : labelAt(grid->itemAtPosition(row - 1, column));
    }
    return qobject_cast<QBoxLayout*>(&layout) && index > 0 ? labelAt(layout.itemAt(index - 1)) : nullptr;
}

QLabel* labelBefore(QLayout* layout, QWidget& widget)
{
    if (!layout)
        return nullptr;
    if (QLabel* label = labelIn(*layout, widget))
        return label;
    for (int i = 0; i < layout->count(); ++i)
        if (QLabel* label = labelBefore(layout->itemAt(i)->layout(), widget))
            return label;
    return nullptr;
}

bool isBuddy(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    if (!parent)
        return false;
    for (const auto* label : parent->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
        if (label->buddy() == &widget)
            return true;
    return qobject_cast<const QGroupBox*>(parent);
}

QString wordsOn(const QWidget& widget)
{
    QString words;
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        words = line->placeholderText();
    else if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget))
        words = text->placeholderText();
    return words.isEmpty() ? widget.toolTip().section('\n', 0, 0) : words;
}

} // namespace

namespace {

/// A table or a plot without words of its own is what its tab is called, else what its page is.
QString wordsAround(const QWidget& widget, const QWidget& page)
{
    for (const QWidget* inside = &widget; inside && inside != &page; inside = inside->parentWidget())
        if (const auto* stack = qobject_cast<const QStackedWidget*>(inside->parentWidget()))
            if (const auto* tabs = qobject_cast<const QTabWidget*>(stack->parentWidget()))
                return tabs->tabText(tabs->indexOf(const_cast<QWidget*>(inside))).remove('&');
    return page.windowTitle();
}

} // namespace

void nameControls(QWidget& page)
{
    for (auto* widget : page.findChildren<QWidget*>()) {
        const bool table = qobject_cast<const QAbstractItemView*>(widget); // which says no name of a label or a group by itself
        if (!wantsName(*widget) || (!table && isBuddy(*widget)))
            continue;
        QWidget* parent = widget->parentWidget();
        QLabel* label = parent ? labelBefore(parent->layout(), *widget) : nullptr;
        if (label && !label->buddy() && !table)
            label->setBuddy(widget);
        else if (label)
            widget->setAccessibleName(label->text());
        else
            widget->setAccessibleName(wordsOn(*widget).isEmpty() ? wordsAround(*widget, page) : wordsOn(*widget));
    }
}

} // namespace lubberline::ui
