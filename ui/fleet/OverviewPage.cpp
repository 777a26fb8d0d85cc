#include "ui/fleet/OverviewPage.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "ui/kit/Badge.h"
#include "ui/kit/Theme.h"
#include "ui/kit/Words.h"

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

QTableWidgetItem* fixedItem(const QString& text)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    return item;
}

} // namespace

OverviewPage::OverviewPage(db::Stores& stores, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_counts(largeLabel(QStringLiteral("overviewCounts"), 1.1))
    , m_listTitle(largeLabel(QStringLiteral("overviewListTitle"), 1.1))
    , m_list(new QTableWidget(0, 3))
{
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

    auto* hint
        = new QLabel(tr("Choose an aircraft in the tree at the left, open its compass, and pick a swing. "
                        "The state of an aircraft is that of the newest swing of its compasses, held against the limits set for each."));
    hint->setWordWrap(true);
    setTitle(tr("Fleet"));
    body().addWidget(m_counts);
    body().addLayout(buttons);
    body().addWidget(hint);
    body().addSpacing(8);
    body().addWidget(m_listTitle);
    body().addWidget(m_list, 1);
    setFocusProxy(m_list);
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
    if (found != types->end())
        fillType(*found);
    else
        fillFleet(*types);
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
    m_list->setItem(row, 0, fixedItem(toText(aircraft.registration)));
    m_list->setItem(row, 1, fixedItem(toText(type.name)));
    auto* state = fixedItem(badgeWord(aircraft.status));
    state->setIcon(badgeIcon(aircraft.status));
    state->setToolTip(badgeMeaning(aircraft.status));
    m_list->setItem(row, 2, state);
    m_listed.push_back(aircraft.id);
}

} // namespace lubberline::ui
