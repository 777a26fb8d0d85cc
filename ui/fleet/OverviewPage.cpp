#include "ui/fleet/OverviewPage.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

#include "ui/kit/Badge.h"
#include "ui/kit/DueBadge.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/TableEntry.h"
#include "ui/kit/Theme.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

QLabel* largeLabel(const QString& name, double scale)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    label->setFont(font);
    label->setWordWrap(true);
    return label;
}

QTableWidgetItem* fixedAngleCell(const QString& text) { return fixedCell(inAngleStyle(text)); }

} // namespace

OverviewPage::OverviewPage(db::Stores& stores, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_counts(largeLabel(QStringLiteral("overviewCounts"), 1.1))
    , m_listTitle(largeLabel(QStringLiteral("overviewListTitle"), 1.1))
    , m_today(new QTableWidget(0, 3))
    , m_hint(new QLabel)
    , m_list(new QTableWidget(0, 3))
{
    m_today->setObjectName(QStringLiteral("overviewToday"));
    m_today->setAccessibleName(tr("What needs a hand today"));
    m_today->setHorizontalHeaderLabels({tr("Today"), tr("Compass"), tr("Why")});
    m_today->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_today->horizontalHeader()->setStretchLastSection(true);
    m_today->verticalHeader()->hide();
    m_today->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // a long reason wraps
    m_today->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_today->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_today->setSelectionMode(QAbstractItemView::SingleSelection);
    m_today->setTabKeyNavigation(false);
    const auto goThere = [this](int row) {
        const FleetItem place = m_places.at(static_cast<std::size_t>(row));
        if (std::holds_alternative<std::monostate>(place))
            emit dueWanted();
        else
            emit placeWanted(place);
    };
    connect(m_today, &QTableWidget::cellActivated, this, goThere);
    connect(m_today, &QTableWidget::cellClicked, this, goThere);
    m_list->setObjectName(QStringLiteral("overviewList"));
    m_list->setHorizontalHeaderLabels({tr("Aircraft"), tr("Type"), tr("State")});
    m_list->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_list->verticalHeader()->hide();
    m_list->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->setTabKeyNavigation(false);
    connect(
        m_list, &QTableWidget::cellActivated, this, [this](int row) { emit aircraftChosen(m_listed.at(static_cast<std::size_t>(row))); });
    connect(m_list, &QTableWidget::cellClicked, this, [this](int row) { emit aircraftChosen(m_listed.at(static_cast<std::size_t>(row))); });

    auto* newSwing = new QPushButton(icon("swing"), tr("Start a new swing"));
    auto* import = new QPushButton(icon("import"), tr("Import a file"));
    connect(newSwing, &QPushButton::clicked, this, &OverviewPage::newSwingWanted);
    connect(import, &QPushButton::clicked, this, &OverviewPage::importWanted);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(newSwing);
    buttons->addWidget(import);
    buttons->addStretch();

    m_hint->setText(tr("Choose an aircraft in the tree at the left, open its compass, and pick a swing. "
                       "The state of an aircraft is that of the newest swing of its compasses, held against the limits set for each."));
    m_hint->setWordWrap(true);
    setTitle(tr("Fleet"));
    body().addWidget(m_counts);
    body().addLayout(buttons);
    body().addWidget(m_today, 2);
    body().addWidget(m_listTitle);
    body().addWidget(m_list, 1);
    body().addWidget(m_hint);
    body().addStretch();
    setFocusProxy(m_today);
}

void OverviewPage::showFleet()
{
    m_type = {};
    refresh();
}

void OverviewPage::showType(AircraftTypeId type)
{
    m_type = type;
    refresh();
}

void OverviewPage::refresh()
{
    m_list->setRowCount(0);
    m_listed.clear();
    const auto types = m_stores.fleet.types();
    if (!types) {
        emit failed(messageOf(types.error()));
        return;
    }
    const auto found = std::find_if(types->begin(), types->end(), [this](const TypeRow& row) { return row.id == m_type; });
    fillToday();
    if (found != types->end())
        fillType(*found);
    else
        fillFleet(*types);
}

void OverviewPage::setDue(const std::vector<DueLine>& lines)
{
    m_due.clear();
    std::copy_if(
        lines.begin(), lines.end(), std::back_inserter(m_due), [](const DueLine& line) { return line.answer.state >= DueState::Due; });
    fillToday();
}

void OverviewPage::addToday(const QString& what, const QIcon& icon, const QString& which, const QString& why, const FleetItem& place)
{
    const int row = m_today->rowCount();
    m_today->insertRow(row);
    auto* first = fixedAngleCell(what);
    first->setIcon(icon);
    m_today->setItem(row, 0, first);
    m_today->setItem(row, 1, fixedAngleCell(which));
    m_today->setItem(row, 2, fixedAngleCell(why));
    m_today->item(row, 2)->setToolTip(why);
    m_places.push_back(place);
}

void OverviewPage::addDue()
{
    constexpr std::size_t kMost = 8;
    for (std::size_t i = 0; i < std::min(m_due.size(), kMost); ++i) {
        const DueLine& line = m_due[i];
        addToday(dueWord(line.answer.state), dueIcon(line.answer.state),
            QStringLiteral("%1 · %2").arg(toText(line.compass.registration), toText(line.compass.compassName)),
            toText(line.answer.flags.front().reason), line.compass.compass);
    }
    if (m_due.size() > kMost)
        addToday(tr("due"), dueIcon(DueState::Due), tr("and %n more", nullptr, static_cast<int>(m_due.size() - kMost)),
            tr("the whole list"), {});
}

/// Guided swings that stand half-way, what is due, what was swung last.
void OverviewPage::fillToday()
{
    m_today->setRowCount(0);
    m_places.clear();
    m_today->setVisible(!m_type.valid());
    if (m_type.valid())
        return;
    const auto open = openSwings(m_stores);
    constexpr int kNewest = 6;
    const auto newest = m_stores.swings.newest(kNewest);
    if (!open || !newest) {
        emit failed(messageOf(open ? newest.error() : open.error()));
        return;
    }
    for (const OpenSwing& one : *open)
        addToday(tr("go on"), icon("guided"), one.whose, one.words, one.swing);
    addDue();
    for (const NewestSwing& one : *newest)
        addToday(tr("swung"), badgeIcon(one.row.status), QStringLiteral("%1 · %2").arg(toText(one.registration), toText(one.compass)),
            QStringLiteral("%1, %2, %3")
                .arg(one.row.date.empty() ? tr("no date") : toText(one.row.date),
                    stateWords(one.row.state, db::signedMark(m_stores.database(), one.row.id, one.row.state)), badgeWord(one.row.status)),
            one.row.id);
    if (m_today->rowCount() > 0 && m_today->currentRow() < 0)
        m_today->setCurrentCell(0, 0);
}

void OverviewPage::fillFleet(const std::vector<TypeRow>& types)
{
    setTitle(tr("Fleet"));
    const auto totals = m_stores.fleet.totals();
    if (!totals) {
        emit failed(messageOf(totals.error()));
        return;
    }
    m_counts->setText(tr("types: %1 · aircraft: %2 · compasses: %3 · swings: %4")
                          .arg(totals->types)
                          .arg(totals->aircraft)
                          .arg(totals->compasses)
                          .arg(totals->swings));
    for (const TypeRow& type : types) {
        if (type.status != Status::OutOfLimits)
            continue;
        const auto aircraft = m_stores.fleet.aircraftOf(type.id);
        if (!aircraft) {
            emit failed(messageOf(aircraft.error()));
            return;
        }
        for (const AircraftRow& row : *aircraft)
            if (row.status == Status::OutOfLimits)
                add(type, row);
    }
    m_listTitle->setText(m_listed.empty() ? tr("No aircraft is out of limits.") : tr("Out of limits: %1 aircraft").arg(m_listed.size()));
    m_list->setVisible(!m_listed.empty());
}

void OverviewPage::fillType(const TypeRow& type)
{
    setTitle(toText(type.name));
    m_counts->setText(tr("aircraft: %1").arg(type.aircraft));
    m_listTitle->setText(tr("All aircraft of this type"));
    const auto aircraft = m_stores.fleet.aircraftOf(type.id);
    if (!aircraft) {
        emit failed(messageOf(aircraft.error()));
        return;
    }
    for (const AircraftRow& row : *aircraft)
        add(type, row);
    m_list->setVisible(true);
}

void OverviewPage::add(const TypeRow& type, const AircraftRow& aircraft)
{
    const int row = m_list->rowCount();
    m_list->insertRow(row);
    m_list->setItem(row, 0, fixedAngleCell(toText(aircraft.registration)));
    m_list->setItem(row, 1, fixedAngleCell(toText(type.name)));
    auto* state = fixedAngleCell(badgeWord(aircraft.status));
    state->setIcon(badgeIcon(aircraft.status));
    state->setToolTip(badgeMeaning(aircraft.status));
    m_list->setItem(row, 2, state);
    m_listed.push_back(aircraft.id);
}

} // namespace lubberline::ui
