#pragma once
/// Tables and lists of a document, before anybody decided how they are set.

#include <QString>
#include <QStringList>

#include <vector>

namespace lubberline::ui {

/// A name and what it says: one line of a list.
struct Fact {
    QString name;
    QString value;
};

struct TableColumn {
    enum class Align { Left, Point }; ///< Point: the decimal points stand under each other
    QString head;                     ///< what it is
    QString argument;                 ///< of what, by what rule; may be empty
    QString unit;                     ///< empty for words
    double width_mm = 20;
    Align align = Align::Point;
};

struct TableRow {
    enum class Look { Plain, Faint, Marked }; ///< Faint: left out of the results; Marked: to be looked at
    QStringList cells;
    Look look = Look::Plain;
};

struct Table {
    QString title;
    std::vector<TableColumn> columns;
    std::vector<TableRow> rows;
};

/// Columns of degrees as the window shows angles.
[[nodiscard]] Table inAngleStyle(Table table);

} // namespace lubberline::ui
