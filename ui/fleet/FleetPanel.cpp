#include "ui/fleet/FleetPanel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

#include "ui/kit/DueBadge.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

/// Both columns are always in sight: a badge keeps its sign however long a name is, a name as much as is left beside it, and what is cut is in
/// the tool tip. A tree that scrolls sideways hides which aircraft are out of limits.
class TreeColumns final : public QObject {
public:
    explicit TreeColumns(QTreeView& tree) : QObject(&tree), m_tree(tree)
    {
        tree.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        tree.header()->setSectionResizeMode(QHeaderView::Fixed);
        tree.header()->setMinimumSectionSize(1);
        tree.viewport()->installEventFilter(this);
        m_soon.setSingleShot(true);
        connect(&m_soon, &QTimer::timeout, this, &TreeColumns::fit);
        const auto soon = [this] { m_soon.start(); };
        connect(&tree, &QTreeView::expanded, this, soon);
        connect(&tree, &QTreeView::collapsed, this, soon);
        connect(tree.verticalScrollBar(), &QScrollBar::valueChanged, this, soon);
        connect(tree.model(), &QAbstractItemModel::dataChanged, this, soon);
        connect(tree.model(), &QAbstractItemModel::rowsInserted, this, soon);
        connect(tree.model(), &QAbstractItemModel::rowsRemoved, this, soon);
        connect(tree.model(), &QAbstractItemModel::modelReset, this, soon);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Show || event->type() == QEvent::FontChange)
            fit();
        return false;
    }

private:
    void fit()
    {
        constexpr int kLeastWord = 5; // letters of a badge beside its sign
        const auto& view = static_cast<const QAbstractItemView&>(m_tree);
        const int room = m_tree.viewport()->width(), name = view.sizeHintForColumn(FleetModel::Name) + 1,
                  badge = view.sizeHintForColumn(FleetModel::Badge) + 1;
        const int sign = m_tree.iconSize().width() > 0 ? m_tree.iconSize().width() : m_tree.style()->pixelMetric(QStyle::PM_SmallIconSize);
        const int least = std::min(badge, sign + kLeastWord * m_tree.fontMetrics().averageCharWidth() + 12);
        const int ofName = std::max(0, std::min(name, room - least));
        m_tree.header()->resizeSection(FleetModel::Name, std::max(ofName, room - badge));
        m_tree.header()->resizeSection(FleetModel::Badge, room - m_tree.header()->sectionSize(FleetModel::Name));
    }

    QTreeView& m_tree;
    QTimer m_soon;
};

constexpr int kSearchDelay_ms = 120;  // a word is searched for once, not letter by letter
constexpr int kRefreshDelay_ms = 250; // badges may lag behind typing; typing may not lag behind badges
constexpr int kMaxHits = 100;

FleetItem itemOf(const SearchHit& hit)
{
    if (hit.swing.valid())
        return hit.swing;
    if (hit.compass.valid())
        return hit.compass;
    return hit.aircraft;
}

} // namespace

FleetPanel::FleetPanel(db::Stores& stores, QWidget* parent)
    : QWidget(parent)
    , m_stores(stores)
    , m_model(new FleetModel(stores, this))
    , m_words(new QLineEdit)
    , m_stack(new QStackedWidget)
    , m_tree(new QTreeView)
    , m_hits(new QListWidget)
    , m_due(new QToolButton)
    , m_searchSoon(new QTimer(this))
    , m_refreshSoon(new QTimer(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 0, 4);
    layout->addWidget(m_words);
    layout->addWidget(m_stack);
    layout->addWidget(m_due);
    m_due->setObjectName(QStringLiteral("dueButton"));
    m_due->setAutoRaise(true);
    m_due->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_due->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_due->setFocusPolicy(Qt::StrongFocus); // reached by Tab, too
    m_due->setText(tr("Due"));
    connect(m_due, &QToolButton::clicked, this, &FleetPanel::dueWanted);
    buildTree();
    buildSearch();
    m_refreshSoon->setSingleShot(true);
    m_refreshSoon->setInterval(kRefreshDelay_ms);
    connect(m_refreshSoon, &QTimer::timeout, this, &FleetPanel::refresh);
    const auto refreshSoon = [this] { m_refreshSoon->start(); };
    connect(&stores.changes(), &db::Changes::swingChanged, this, refreshSoon);
    connect(&stores.changes(), &db::Changes::aircraftChanged, this, refreshSoon);
    connect(&stores.changes(), &db::Changes::fleetChanged, this, &FleetPanel::refresh);
    connect(m_model, &FleetModel::failed, this, &FleetPanel::failed);
}

/// Where the chosen item is no more the view marks its neighbour: nobody has chosen that.
void FleetPanel::refresh()
{
    const bool before = std::exchange(m_selecting, true);
    m_model->refresh();
    m_selecting = before;
    if (m_stack->currentWidget() == m_hits) { // what came is found, too, and what went no more
        const int scrolled = m_hits->verticalScrollBar()->value();
        search();
        m_hits->verticalScrollBar()->setValue(scrolled);
    }
}

void FleetPanel::showDue(const std::vector<DueLine>& lines, int due)
{
    m_model->setDue(lines);
    m_due->setText(tr("Due (%1)").arg(due));
    m_due->setIcon(dueIcon(due > 0 ? lines.front().answer.state : DueState::NotDue));
}

void FleetPanel::buildTree()
{
    m_tree->setObjectName(QStringLiteral("fleetTree"));
    m_tree->setAccessibleName(tr("Fleet"));
    m_tree->setUniformRowHeights(true);
    m_tree->setHeaderHidden(true);
    m_tree->setIndentation(12);
    m_tree->setTextElideMode(Qt::ElideNone); // what is cut may be what tells one swing from the other: the tree scrolls
    m_tree->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    // The chosen item shows its page again, too: by Enter, by a double click, by a click.
    connect(m_tree, &QTreeView::activated, this, [this](const QModelIndex& index) {
        emit itemChosen(m_model->item(index));
        emit itemOpened();
    });
    connect(m_tree, &QTreeView::clicked, this, [this](const QModelIndex& index) { emit itemChosen(m_model->item(index)); });
    connect(m_tree, &QTreeView::expanded, this, &FleetPanel::branchesChanged);
    connect(m_tree, &QTreeView::collapsed, this, &FleetPanel::branchesChanged);
    m_stack->addWidget(m_tree);
}

void FleetPanel::buildSearch()
{
    m_words->setObjectName(QStringLiteral("searchLine"));
    m_words->setAccessibleName(tr("Search everything"));
    m_words->setPlaceholderText(tr("Search everything (Ctrl+F)"));
    m_words->setClearButtonEnabled(true);
    m_words->installEventFilter(this);
    m_hits->setObjectName(QStringLiteral("searchHits"));
    m_hits->setAccessibleName(tr("Found"));
    m_hits->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_hits->setTextElideMode(Qt::ElideNone);
    m_hits->setWordWrap(true); // what tells one swing from the next stands at the end
    m_hits->setResizeMode(QListView::Adjust);
    m_hits->setAlternatingRowColors(true);
    m_hits->installEventFilter(this);
    m_stack->addWidget(m_hits);
    m_searchSoon->setSingleShot(true);
    m_searchSoon->setInterval(kSearchDelay_ms);
    connect(m_words, &QLineEdit::textChanged, m_searchSoon, qOverload<>(&QTimer::start));
    connect(m_words, &QLineEdit::returnPressed, this, [this] {
        search();
        chooseHit(0);
    });
    connect(m_searchSoon, &QTimer::timeout, this, &FleetPanel::search);
    connect(m_hits, &QListWidget::itemActivated, this, [this] { chooseHit(m_hits->currentRow()); });
    connect(m_hits, &QListWidget::itemClicked, this, [this] { chooseHit(m_hits->currentRow()); });
}

void FleetPanel::populate()
{
    if (m_tree->model())
        return;
    m_tree->setModel(m_model); // asks storage for the first level
    m_model->fetchMore({});
    m_tree->header()->setStretchLastSection(false);
    new TreeColumns(*m_tree);
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        // A view that gets the focus makes its first item the current one, and selects nothing: nobody has chosen that.
        if (!m_selecting && current.isValid() && m_tree->selectionModel()->isSelected(current))
            emit itemChosen(m_model->item(current));
    });
}

void FleetPanel::select(const std::vector<FleetItem>& path)
{
    m_selected = path.empty() ? FleetItem() : path.back();
    markHit();
    if (!m_tree->model())
        return;
    m_selecting = true;
    m_tree->setCurrentIndex(m_model->find(path));
    m_selecting = false;
}

namespace {

QString branchText(const FleetItem& item)
{
    return std::visit(
        [&](const auto& id) {
            if constexpr (requires { id.value; })
                return QStringLiteral("%1:%2").arg(item.index()).arg(id.value);
            else
                return QString();
        },
        item);
}

std::optional<FleetItem> branchFrom(const QString& text)
{
    const auto id = text.section(':', 1).toLongLong();
    switch (text.section(':', 0, 0).toInt()) {
    case 1: return FleetItem(AircraftTypeId{id});
    case 2: return FleetItem(AircraftId{id});
    case 3: return FleetItem(CompassId{id});
    default: return {};
    }
}

} // namespace

QStringList FleetPanel::openBranches() const
{
    QStringList open;
    if (!m_tree->model())
        return open;
    std::vector<QModelIndex> left{QModelIndex()};
    while (!left.empty()) {
        const QModelIndex parent = left.back();
        left.pop_back();
        for (int row = 0; row < m_model->rowCount(parent); ++row) {
            const QModelIndex child = m_model->index(row, 0, parent);
            if (!m_tree->isExpanded(child))
                continue;
            QStringList path;
            for (QModelIndex above = child; above.isValid(); above = above.parent())
                path.prepend(branchText(m_model->item(above)));
            open += path.join('/');
            left.push_back(child);
        }
    }
    return open;
}

int FleetPanel::wantedWidth() const
{
    const auto& view = static_cast<const QAbstractItemView&>(*m_tree);
    int width = m_tree->verticalScrollBar()->sizeHint().width() + 2 * m_tree->frameWidth() + (this->width() - m_tree->width());
    for (int column = 0; m_tree->model() && column < m_model->columnCount({}); ++column)
        width += view.sizeHintForColumn(column) + 1;
    return width;
}

void FleetPanel::setOpenBranches(const QStringList& branches)
{
    if (!m_tree->model())
        return;
    for (const QString& branch : branches) {
        std::vector<FleetItem> path;
        for (const QString& part : branch.split('/'))
            if (const auto item = branchFrom(part))
                path.push_back(*item);
        if (const QModelIndex found = m_model->find(path); found.isValid() && !path.empty() && m_model->item(found) == path.back())
            m_tree->expand(found);
    }
}

void FleetPanel::search()
{
    m_searchSoon->stop();
    const QString words = m_words->text().trimmed();
    m_stack->setCurrentIndex(words.isEmpty() ? 0 : 1);
    m_hits->clear();
    m_hitItems.clear();
    if (words.isEmpty())
        return;
    const auto hits = m_stores.fleet.search(words.toStdString(), kMaxHits);
    if (!hits) {
        emit failed(messageOf(hits.error()));
        return;
    }
    for (const SearchHit& hit : *hits) {
        m_hits->addItem(toText(hit.text));
        m_hits->item(m_hits->count() - 1)->setToolTip(toText(hit.text));
        m_hitItems.push_back(itemOf(hit));
    }
    if (hits->empty()) {
        auto* nothing = new QListWidgetItem(tr("Nothing found"), m_hits);
        nothing->setFlags(Qt::NoItemFlags);
    }
    markHit();
}

/// What is found is marked while it is the one that is shown.
void FleetPanel::markHit()
{
    const auto found = std::find(m_hitItems.begin(), m_hitItems.end(), m_selected);
    m_hits->setCurrentRow(found == m_hitItems.end() ? -1 : static_cast<int>(found - m_hitItems.begin()));
}

void FleetPanel::chooseHit(int row)
{
    if (row < 0 || row >= static_cast<int>(m_hitItems.size()))
        return;
    m_hits->setCurrentRow(row);
    emit itemChosen(m_hitItems[static_cast<std::size_t>(row)]);
}

bool FleetPanel::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(object, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
        m_words->clear();
        search();
        focusTree();
        return true;
    }
    if (object == m_words && key == Qt::Key_Down) {
        search();
        m_stack->currentWidget()->setFocus();
        return true;
    }
    return QWidget::eventFilter(object, event);
}

void FleetPanel::focusSearch()
{
    m_words->setFocus(Qt::ShortcutFocusReason);
    m_words->selectAll();
}

void FleetPanel::focusTree() { m_tree->setFocus(Qt::ShortcutFocusReason); }

} // namespace lubberline::ui
