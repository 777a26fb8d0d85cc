#pragma once

#include "ui/kit/TableEntry.h"

namespace lubberline::ui {

/// Edits a cell in a plain line; Enter stores it and says so. A cell whose text was not stored has a red frame and that text, struck out,
/// beside the value that is stored; a suspect or placeholder one its own look.
class ReadingDelegate : public KeepsTyped {
    Q_OBJECT

public:
    using KeepsTyped::KeepsTyped;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool eventFilter(QObject* object, QEvent* event) override;

signals:
    void escaped(); ///< Escape ended an edit: nothing of it stands
    void entered(); ///< Enter ended an edit; what was typed is stored or refused by now

private:
    void paintRefused(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
};

} // namespace lubberline::ui
