#include "ui/kit/keys/FocusEdit.h"

#include <QAbstractItemView>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMetaMethod>

#include <map>

#include "ui/kit/ClipboardRows.h"

namespace lubberline::ui {

namespace {

const char* methodOf(EditVerb verb)
{
    switch (verb) {
    case EditVerb::Cut: return "cut()";
    case EditVerb::Copy: return "copy()";
    case EditVerb::Paste: return "paste()";
    case EditVerb::SelectAll: return "selectAll()";
    }
    return "";
}

void copyCells(const QAbstractItemView& view)
{
    if (!view.selectionModel())
        return;
    std::map<std::pair<int, int>, QString> cells; // a tree's branches follow one another by their rows
    for (const QModelIndex& cell : view.selectionModel()->selectedIndexes())
        cells[{cell.row(), cell.column()}] = cell.data().toString();
    CellRows rows;
    int last = -1;
    for (const auto& [place, text] : cells) {
        if (place.first != last)
            rows.emplace_back();
        last = place.first;
        rows.back().push_back(text.toStdString());
    }
    if (!rows.empty())
        putRowsOnClipboard(clipboardText(rows));
}

} // namespace

void editIn(QWidget* focused, EditVerb verb)
{
    if (auto* box = qobject_cast<QComboBox*>(focused))
        focused = box->lineEdit();
    if (!focused)
        return;
    const QMetaObject* type = focused->metaObject();
    if (const int method = type->indexOfMethod(methodOf(verb)); method >= 0)
        type->method(method).invoke(focused, Qt::DirectConnection);
    else if (const auto* view = qobject_cast<QAbstractItemView*>(focused); view && verb == EditVerb::Copy)
        copyCells(*view);
    else if (const auto* label = qobject_cast<QLabel*>(focused); label && verb == EditVerb::Copy && label->hasSelectedText())
        QGuiApplication::clipboard()->setText(label->selectedText());
}

} // namespace lubberline::ui
