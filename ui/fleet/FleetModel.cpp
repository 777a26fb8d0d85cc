#include "ui/fleet/FleetModel.h"

#include <algorithm>
#include <functional>

#include "ui/kit/Badge.h"
#include "ui/kit/DueBadge.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

struct FleetModel::Node {
    FleetItem item;
    QString name;
    QString detail; ///< tooltip
    Status status = Status::NotKnown;
    bool mayHaveChildren = false;
    bool draft = false;
    bool loaded = false;
    Node* parent = nullptr;
    int row = 0;
    std::vector<std::unique_ptr<Node>> children;
};

namespace {

QString swingName(const SwingRow& row)
{
    const QString date = row.date.empty() ? FleetModel::tr("no date") : toText(row.date);
    QString name = FleetModel::tr("%1 %2").arg(date, statedWord(row.stage)).trimmed();
    if (row.revision > 1)
        name += FleetModel::tr(", rev. %1").arg(row.revision);
    if (row.superseded)
        name += FleetModel::tr(", amended");
    return name;
}

/// What a branch calls its swings: those of one day and stage have their kind beside it, and of one kind the readings that they have.
std::vector<QString> swingNames(const std::vector<SwingRow>& rows)
{
    std::vector<QString> names;
    for (const SwingRow& row : rows)
        names.push_back(swingName(row));
    const auto tellApart = [&](auto&& words) {
        const std::vector<QString> before = names;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (std::count(before.begin(), before.end(), before[i]) > 1 && !words(rows[i]).isEmpty())
                names[i] += QStringLiteral(", ") + words(rows[i]);
    };
    tellApart([](const SwingRow& row) { return statedWord(row.kind); });
    tellApart([](const SwingRow& row) { return FleetModel::tr("readings: %1").arg(row.readings); });
    return names;
}

QString swingDetail(const SwingRow& row, db::SignedMark mark)
{
    QStringList stated{statedWord(row.kind), statedWord(row.stage), stateWords(row.state, mark)};
    stated.removeAll(QString());
    const QString what = FleetModel::tr("%1 · readings: %2").arg(stated.join(QStringLiteral(", "))).arg(row.readings);
    if (!row.maxAbsDeviation_deg)
        return what;
    return what + inAngleStyle(FleetModel::tr(" · largest deviation %1°").arg(*row.maxAbsDeviation_deg, 0, 'f', 1));
}

/// "in limits · □ due": what is not due needs no word.
QString badgeText(const QString& state, DueState due)
{
    return due == DueState::NotDue ? state : FleetModel::tr("%1 · %2 %3").arg(state, dueMark(due), dueWord(due));
}

} // namespace

FleetModel::FleetModel(db::Stores& stores, QObject* parent) : QAbstractItemModel(parent), m_stores(stores), m_root(std::make_unique<Node>())
{
    m_root->mayHaveChildren = true;
}

FleetModel::~FleetModel() = default;

FleetModel::Node* FleetModel::nodeOf(const QModelIndex& index) const
{
    return index.isValid() ? static_cast<Node*>(index.internalPointer()) : m_root.get();
}

QModelIndex FleetModel::indexOf(const Node* node, int column) const
{
    return node == m_root.get() ? QModelIndex() : createIndex(node->row, column, node);
}

QModelIndex FleetModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, nodeOf(parent)->children[static_cast<std::size_t>(row)].get());
}

QModelIndex FleetModel::parent(const QModelIndex& index) const { return index.isValid() ? indexOf(nodeOf(index)->parent) : QModelIndex(); }

int FleetModel::rowCount(const QModelIndex& parent) const
{
    return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent)->children.size());
}

bool FleetModel::hasChildren(const QModelIndex& parent) const
{
    if (parent.column() > 0)
        return false;
    const Node* node = nodeOf(parent);
    return node->loaded ? !node->children.empty() : node->mayHaveChildren;
}

bool FleetModel::canFetchMore(const QModelIndex& parent) const
{
    const Node* node = nodeOf(parent);
    return parent.column() <= 0 && !node->loaded && node->mayHaveChildren;
}

void FleetModel::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent))
        load(*nodeOf(parent));
}

Result<std::vector<std::unique_ptr<FleetModel::Node>>> FleetModel::ask(const Node& parent)
{
    std::vector<std::unique_ptr<Node>> nodes;
    const auto add = [&nodes](FleetItem item, const QString& name, const QString& detail, Status status, bool mayHaveChildren) {
        auto node = std::make_unique<Node>();
        node->item = item;
        node->name = name.isEmpty() ? tr("damaged") : name; // a name is never empty
        node->detail = detail;
        node->status = status;
        node->mayHaveChildren = mayHaveChildren;
        nodes.push_back(std::move(node));
        return nodes.back().get();
    };
    if (std::holds_alternative<std::monostate>(parent.item)) {
        const auto rows = m_stores.fleet.types();
        if (!rows)
            return rows.error();
        for (const TypeRow& row : *rows)
            add(row.id, toText(row.name), tr("aircraft: %1").arg(row.aircraft), row.status, row.aircraft > 0);
    } else if (const auto* type = std::get_if<AircraftTypeId>(&parent.item)) {
        const auto rows = m_stores.fleet.aircraftOf(*type);
        if (!rows)
            return rows.error();
        for (const AircraftRow& row : *rows)
            add(row.id, toText(row.registration), row.demonstration ? tr("demonstration data: invented") : QString(), row.status, true);
    } else if (const auto* aircraft = std::get_if<AircraftId>(&parent.item)) {
        const auto rows = m_stores.fleet.compassesOf(*aircraft);
        if (!rows)
            return rows.error();
        for (const CompassRow& row : *rows)
            add(row.id, toText(row.name), tr("swings: %1").arg(row.swings), row.status, row.swings > 0);
    } else if (const auto* compass = std::get_if<CompassId>(&parent.item)) {
        const auto rows = m_stores.swings.swingsOf(*compass);
        const auto marks = rows ? db::signedMarks(m_stores.database(), *rows) : rows.error();
        if (!marks)
            return marks.error();
        const std::vector<QString> names = swingNames(*rows);
        for (std::size_t i = 0; i < rows->size(); ++i) {
            const SwingRow& row = (*rows)[i];
            add(row.id, names[i] + guidedWords(row), swingDetail(row, (*marks)[i]), row.status, false)->draft
                = row.state == SwingState::Draft;
        }
    }
    return nodes;
}

/// Where a guided swing stands, or that it was abandoned.
QString FleetModel::guidedWords(const SwingRow& row)
{
    if (!row.guided && !row.abandoned)
        return {};
    if (row.abandoned)
        return tr(", guided, abandoned");
    const auto job = m_stores.jobs.jobOf(row.id);
    return job && *job ? tr(", guided, at %1").arg(standingWords((*job)->job)) : tr(", guided, in work");
}

void FleetModel::load(Node& parent)
{
    auto fresh = ask(parent);
    if (!fresh) {
        parent.loaded = true; // views would ask again at once, and fail again: refresh() tries anew
        emit failed(messageOf(fresh.error()));
        return;
    }
    parent.loaded = true;
    merge(parent, std::move(fresh.value()));
}

void FleetModel::removeMissing(Node& parent, const std::vector<std::unique_ptr<Node>>& fresh)
{
    for (int row = static_cast<int>(parent.children.size()) - 1; row >= 0; --row) {
        const FleetItem item = parent.children[static_cast<std::size_t>(row)]->item;
        if (std::any_of(fresh.begin(), fresh.end(), [&item](const auto& node) { return node->item == item; }))
            continue;
        beginRemoveRows(indexOf(&parent), row, row);
        parent.children.erase(parent.children.begin() + row);
        for (std::size_t i = static_cast<std::size_t>(row); i < parent.children.size(); ++i)
            parent.children[i]->row = static_cast<int>(i);
        endRemoveRows();
    }
}

void FleetModel::merge(Node& parent, std::vector<std::unique_ptr<Node>> fresh)
{
    auto& children = parent.children;
    const auto sameItem = [](const auto& a, const auto& b) { return a->item == b->item; };
    if (!std::equal(children.begin(), children.end(), fresh.begin(), fresh.end(), sameItem))
        removeMissing(parent, fresh);
    const auto renumber = [&children] {
        for (std::size_t i = 0; i < children.size(); ++i)
            children[i]->row = static_cast<int>(i);
    };
    if (children.empty() && !fresh.empty()) {
        beginInsertRows(indexOf(&parent), 0, static_cast<int>(fresh.size()) - 1);
        children = std::move(fresh);
        for (auto& child : children)
            child->parent = &parent;
        renumber();
        endInsertRows();
        return;
    }
    for (int row = 0; row < static_cast<int>(fresh.size()); ++row) {
        auto& wanted = fresh[static_cast<std::size_t>(row)];
        const auto found
            = std::find_if(children.begin() + row, children.end(), [&wanted](const auto& node) { return node->item == wanted->item; });
        if (found == children.end()) {
            wanted->parent = &parent;
            beginInsertRows(indexOf(&parent), row, row);
            children.insert(children.begin() + row, std::move(wanted));
            renumber();
            endInsertRows();
            continue;
        }
        if (const int from = static_cast<int>(found - children.begin()); from != row) {
            beginMoveRows(indexOf(&parent), from, from, indexOf(&parent), row);
            std::rotate(children.begin() + row, found, found + 1);
            renumber();
            endMoveRows();
        }
        Node& node = *children[static_cast<std::size_t>(row)];
        node.name = wanted->name;
        node.detail = wanted->detail;
        node.status = wanted->status;
        node.draft = wanted->draft;
        node.mayHaveChildren = wanted->mayHaveChildren;
        emit dataChanged(indexOf(&node, Name), indexOf(&node, Badge));
        if (node.loaded)
            load(node);
    }
}

void FleetModel::setDue(const std::vector<DueLine>& lines)
{
    m_dueTypes.clear();
    m_dueAircraft.clear();
    m_dueCompasses.clear();
    const auto raise = [](auto& states, auto id, DueState state) {
        auto& kept = states.emplace(id, DueState::NotDue).first->second;
        kept = std::max(kept, state);
    };
    for (const DueLine& line : lines) {
        raise(m_dueTypes, line.compass.type, line.answer.state);
        raise(m_dueAircraft, line.compass.aircraft, line.answer.state);
        raise(m_dueCompasses, line.compass.compass, line.answer.state);
    }
    const std::function<void(const Node&)> tell = [&](const Node& node) {
        if (node.children.empty())
            return;
        emit dataChanged(indexOf(node.children.front().get(), Badge), indexOf(node.children.back().get(), Badge));
        for (const auto& child : node.children)
            tell(*child);
    };
    tell(*m_root);
}

DueState FleetModel::dueOf(const FleetItem& item) const
{
    const auto in = [](const auto& states, auto id) {
        const auto found = states.find(id);
        return found == states.end() ? DueState::NotDue : found->second;
    };
    if (const auto* type = std::get_if<AircraftTypeId>(&item))
        return in(m_dueTypes, *type);
    if (const auto* aircraft = std::get_if<AircraftId>(&item))
        return in(m_dueAircraft, *aircraft);
    if (const auto* compass = std::get_if<CompassId>(&item))
        return in(m_dueCompasses, *compass);
    return DueState::NotDue;
}

void FleetModel::refresh()
{
    if (m_root->loaded)
        load(*m_root);
}

QVariant FleetModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Node& node = *nodeOf(index);
    const bool badge = index.column() == Badge;
    switch (role) {
    case Qt::DisplayRole:
        if (badge)
            return badgeText(node.draft ? tr("draft") : badgeWord(node.status), dueOf(node.item));
        return node.name;
    case Qt::DecorationRole: return badge ? QVariant(badgeIcon(node.status)) : QVariant();
    case Qt::ToolTipRole: { // names and badges are cut where the tree is narrow
        QStringList lines{node.name, node.detail, badgeMeaning(node.status)};
        lines.removeAll(QString());
        return lines.join(u'\n');
    }
    case Qt::AccessibleTextRole: return badge ? badgeMeaning(node.status) : node.name;
    default: return {};
    }
}

QVariant FleetModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == Name ? tr("Fleet") : tr("State");
}

FleetItem FleetModel::item(const QModelIndex& index) const { return nodeOf(index)->item; }

QModelIndex FleetModel::find(const std::vector<FleetItem>& path)
{
    Node* node = m_root.get();
    for (const FleetItem& item : path) {
        if (!node->loaded)
            load(*node);
        const auto found
            = std::find_if(node->children.begin(), node->children.end(), [&item](const auto& child) { return child->item == item; });
        if (found == node->children.end())
            break;
        node = found->get();
    }
    return indexOf(node);
}

} // namespace lubberline::ui
