#include "ui/guided/GuidedPrepare.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/guided/BigWidgets.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr std::array kHeadings_deg{0.0, 90.0, 180.0, 270.0};
enum CheckColumn { Off, On, Change };
constexpr int kRowHeight_px = 31, kList_px = 18;

} // namespace

GuidedPrepare::GuidedPrepare(GuidedJob& job, QWidget* parent)
    : QWidget(parent)
    , m_job(job)
    , m_list(new QVBoxLayout)
    , m_load(new QLineEdit(tr("engines and electrics")))
    , m_table(new QTableWidget(static_cast<int>(kHeadings_deg.size()), 3))
    , m_message(bigLabel("prepareMessage", kTitle_px))
    , m_go(bigButton(tr("Prepared: to the first heading (Enter)"), "prepared"))
{
    m_load->setObjectName(QStringLiteral("interferenceLoad"));
    m_load->setFont(bigFont(font(), kList_px));
    m_table->setObjectName(QStringLiteral("interference"));
    wrapHeadings(*m_table);
    m_table->setHorizontalHeaderLabels({tr("compass, off"), tr("compass, on"), tr("change")});
    QStringList rows;
    for (const double heading : kHeadings_deg)
        rows += stationHeading(heading);
    m_table->setVerticalHeaderLabels(rows);
    m_table->setFont(bigFont(font(), kList_px));
    m_table->verticalHeader()->setDefaultSectionSize(kRowHeight_px);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setFixedHeight(heightOfRows(*m_table, m_table->rowCount()));
    m_table->setTabKeyNavigation(true);
    auto* title = bigLabel("interferenceTitle", kTitle_px, true);
    title->setText(tr("Interference check, with"));
    m_list->setSpacing(0);
    auto* column = new QVBoxLayout(this);
    column->addLayout(m_list);
    auto* head = new QHBoxLayout;
    head->addWidget(title);
    head->addWidget(m_load, 1);
    title->setWordWrap(false);
    column->addLayout(head);
    column->addWidget(m_table);
    column->addWidget(m_message);
    column->addStretch();
    column->addWidget(m_go, 0, Qt::AlignLeft);
    connect(m_table, &QTableWidget::cellChanged, this, [this](int row, int) { takeInterference(row); });
    connect(m_go, &QPushButton::clicked, this, &GuidedPrepare::goOn);
}

void GuidedPrepare::refresh()
{
    if (m_listed != m_job.job().checklist)
        rebuildList();
    const auto& open = m_job.state().openItems;
    for (int i = 0; i < m_list->count(); ++i) {
        auto* box = qobject_cast<QCheckBox*>(m_list->itemAt(i)->widget());
        const QSignalBlocker quiet(box);
        box->setChecked(std::find(open.begin(), open.end(), m_listed[static_cast<std::size_t>(i)]) == open.end());
    }
    m_go->setEnabled(open.empty());
    m_go->setToolTip(open.empty() ? QString() : tr("Every point of the checklist is ticked first"));
    showInterference();
}

void GuidedPrepare::rebuildList()
{
    while (QLayoutItem* item = m_list->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_listed = m_job.job().checklist;
    for (const auto& item : m_listed) {
        auto* box = new QCheckBox(inLines(toText(item).replace('&', QStringLiteral("&&"))));
        box->setObjectName(QStringLiteral("check%1").arg(m_list->count()));
        box->setFont(bigFont(box->font(), kList_px));
        box->setMinimumHeight(32);
        connect(box, &QCheckBox::toggled, this, [this, item, box](bool done) {
            tell(job::Ticked{item, done});
            if (done)
                focusField(); // Space goes down the list
        });
        m_list->addWidget(box);
    }
}

/// The last figures of each heading; a change is off → on.
void GuidedPrepare::showInterference()
{
    m_filling = true;
    double largest = 0;
    for (int row = 0; row < m_table->rowCount(); ++row)
        for (const auto& event : m_job.job().events)
            if (const auto* read = std::get_if<job::InterferenceRead>(&event.what);
                read && read->heading_deg == kHeadings_deg[static_cast<std::size_t>(row)]) {
                const double change = wrap180(read->on_deg - read->off_deg);
                m_table->setItem(row, Off, new QTableWidgetItem(figureText(read->off_deg)));
                m_table->setItem(row, On, new QTableWidgetItem(figureText(read->on_deg)));
                m_table->setItem(row, Change, new QTableWidgetItem(inAngleStyle(signedNumber(change, 1) + QStringLiteral("°"))));
                largest = std::max(largest, std::abs(change));
            }
    m_filling = false;
    m_message->setText(largest > 0
            ? inAngleStyle(
                tr("The compass changes by up to %1° with %2: a significant difference is cured first. No limit is sourced; you decide.")
                    .arg(largest, 0, 'f', 1)
                    .arg(m_load->text()))
            : QString());
}

void GuidedPrepare::takeInterference(int row)
{
    if (m_filling)
        return;
    const auto figure = [&](int column) -> std::optional<double> {
        const auto* item = m_table->item(row, column);
        const auto figures = parseFigures(item ? item->text() : QString());
        return figures && figures->size() == 1 ? std::optional(figures->front()) : std::nullopt;
    };
    const auto off = figure(Off), on = figure(On);
    if (off && on)
        tell(job::InterferenceRead{kHeadings_deg[static_cast<std::size_t>(row)], m_load->text().trimmed().toStdString(), *off, *on});
}

void GuidedPrepare::goOn() { tell(job::Prepared{}); }

void GuidedPrepare::tell(job::What what)
{
    if (const auto told = m_job.tell(std::move(what)); !told)
        emit failed(messageOf(told.error()));
}

void GuidedPrepare::focusField()
{
    for (int i = 0; i < m_list->count(); ++i)
        if (auto* box = qobject_cast<QCheckBox*>(m_list->itemAt(i)->widget()); !box->isChecked()) {
            box->setFocus(Qt::OtherFocusReason);
            return;
        }
    m_go->setFocus(Qt::OtherFocusReason);
}

} // namespace lubberline::ui
