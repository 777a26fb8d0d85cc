#pragma once
/// A page without its window, typed on as a person types.

#include <QLineEdit>
#include <QTableWidget>
#include <QTest>

#include <string>

#include "core/base/Date.h"

namespace lubberline::ui {

inline constexpr Date kToday = "2026-11-23";

template <class Widget>
Widget& in(QWidget& page, const char* name)
{
    auto* widget = page.findChild<Widget*>(QString::fromLatin1(name));
    if (!widget)
        qFatal("there is no widget named %s", name);
    return *widget;
}

inline void type(QLineEdit& line, const QString& text)
{
    line.setFocus();
    line.selectAll();
    QTest::keyClicks(&line, text);
    QTest::keyClick(&line, Qt::Key_Return);
}

inline void typeCell(QTableWidget& table, int row, int column, const QString& text)
{
    table.item(row, column)->setText(text);
    QCoreApplication::processEvents();
}

} // namespace lubberline::ui
