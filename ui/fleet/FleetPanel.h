#pragma once
/// The left dock: a search line over the fleet tree. While words are typed, what was found takes the tree's place.

#include <QWidget>

#include "ui/fleet/FleetModel.h"

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QToolButton;
class QTimer;
class QTreeView;

namespace lubberline::ui {

class FleetPanel : public QWidget {
    Q_OBJECT

public:
    explicit FleetPanel(db::Stores& stores, QWidget* parent = nullptr);

    /// Fills the first level: called after the window's first paint.
    void populate();
    /// Marks what the page shows, without emitting itemChosen().
    void select(const std::vector<FleetItem>& path);
    [[nodiscard]] QStringList openBranches() const; ///< as setOpenBranches() takes them
    [[nodiscard]] int wantedWidth() const;          ///< that shows names and states of what is open whole
    void setOpenBranches(const QStringList& branches);
    void focusSearch();
    void focusTree();
    void showDue(const std::vector<DueLine>& lines, int due);

signals:
    void itemChosen(const lubberline::ui::FleetItem& item);
    void itemOpened(); ///< Enter or double click on the chosen item: the page is wanted
    void dueWanted();  ///< the list of what is due
    void branchesChanged();
    void failed(const QString& message);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void refresh();
    void buildTree();
    void buildSearch();
    void search();
    void chooseHit(int row);
    void markHit();

    db::Stores& m_stores;
    FleetModel* m_model;
    QLineEdit* m_words;
    QStackedWidget* m_stack;
    QTreeView* m_tree;
    QListWidget* m_hits;
    QToolButton* m_due;
    QTimer* m_searchSoon;
    QTimer* m_refreshSoon;
    std::vector<FleetItem> m_hitItems;
    FleetItem m_selected; ///< that is shown
    bool m_selecting = false;
};

} // namespace lubberline::ui
