#pragma once
/// Where the window stands, how wide its tree is and which of its branches are open: kept soon after each change, so that a program that
/// was ended from outside finds them again, too.

#include <QObject>

class QMainWindow;
class QRect;
class QSettings;
class QTimer;

namespace lubberline::ui {

class FleetPanel;

class Placement : public QObject {
    Q_OBJECT

public:
    /// @param tree  in a dock of the window
    /// @param database  whose branches they are: its file
    Placement(QMainWindow& window, FleetPanel& tree, QSettings& settings, const QString& database);

    /// As it was left, and never larger than the screen it is on now, nor outside it.
    void restore();
    void restoreTree(); ///< once it is filled; before, what was kept of it stays
    void keep();        ///< at once

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void bringInto(const QRect& room, const QRect& place);
    void bringOnScreen();

    QMainWindow& m_window;
    FleetPanel& m_tree;
    QSettings& m_settings;
    QString m_branches; ///< the key of those of this database
    QTimer* m_soon;
    bool m_treeFilled = false;
};

} // namespace lubberline::ui
