#pragma once
/// The fleet as a tree: type → aircraft → compass → swings. The stores are asked for children only when a branch is opened, so that
/// a database of 100,000 swings opens as fast as an empty one.

#include <QAbstractItemModel>

#include <map>
#include <memory>
#include <vector>

#include "core/due/DueList.h"
#include "db/stores/Stores.h"
#include "ui/kit/Destination.h"

namespace lubberline::ui {

class FleetModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Name, Badge, kColumns };

    explicit FleetModel(db::Stores& stores, QObject* parent = nullptr);
    ~FleetModel() override;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return kColumns; }
    bool hasChildren(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    [[nodiscard]] FleetItem item(const QModelIndex& index) const;
    /// The place of an item, opening what is above it: `path` is type, aircraft, compass, swing, as far as known.
    [[nodiscard]] QModelIndex find(const std::vector<FleetItem>& path);

    /// What is due: shown besides the state, at parents the most urgent of their children.
    void setDue(const std::vector<DueLine>& lines);

public slots:
    /// Asks storage again for what was opened, and tells views only what differs.
    void refresh();

signals:
    void failed(const QString& message);

private:
    struct Node;
    [[nodiscard]] Node* nodeOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(const Node* node, int column = Name) const;
    [[nodiscard]] Result<std::vector<std::unique_ptr<Node>>> ask(const Node& parent);
    [[nodiscard]] QString guidedWords(const SwingRow& row);
    void load(Node& parent);
    void removeMissing(Node& parent, const std::vector<std::unique_ptr<Node>>& fresh);
    void merge(Node& parent, std::vector<std::unique_ptr<Node>> fresh);

    db::Stores& m_stores;
    [[nodiscard]] DueState dueOf(const FleetItem& item) const;
    std::unique_ptr<Node> m_root;
    std::map<AircraftTypeId, DueState> m_dueTypes;
    std::map<AircraftId, DueState> m_dueAircraft;
    std::map<CompassId, DueState> m_dueCompasses;
};

} // namespace lubberline::ui
