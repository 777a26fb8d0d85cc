#pragma once

#include <QTableWidget>

namespace lubberline::ui {

/// A table that a block from a spreadsheet can be pasted into: by its key, and from the menu Edit.
class PasteTable : public QTableWidget {
    Q_OBJECT

public:
    using QTableWidget::QTableWidget;

public slots:
    void paste() { emit pasteWanted(); }

signals:
    void pasteWanted();

protected:
    bool event(QEvent* event) override; ///< the key comes here, and not as the shortcut of a menu
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace lubberline::ui
