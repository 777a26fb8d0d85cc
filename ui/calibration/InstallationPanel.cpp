#include "ui/calibration/InstallationPanel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/kit/Words.h"
#include "ui/report/forms/InstallationSheet.h"

namespace lubberline::ui {

namespace {

const QString kDistancesKey = QStringLiteral("sensorTests/distances_m");
enum DistanceColumn { kThing, kLeast, kMeasured, kVerdict, kDistanceColumns };

QTableWidgetItem* fixedCell(const QString& text)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    return item;
}

} // namespace

InstallationPanel::InstallationPanel(QSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_words(new QLabel)
    , m_table(new QTableWidget)
{
    m_words->setObjectName(QStringLiteral("installationWords"));
    m_words->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("installationTable"));
    m_table->setAccessibleName(tr("Distances of the flux gate"));
    m_table->setColumnCount(kDistanceColumns);
    m_table->setHorizontalHeaderLabels({tr("from"), tr("at least (m)"), tr("measured (m)"), tr("verdict")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    auto* clear = new QPushButton(tr("Clear the distances"));
    clear->setObjectName(QStringLiteral("installationClear"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_words);
    column->addWidget(m_table, 1);
    column->addWidget(clear, 0, Qt::AlignLeft);
    recall();
    judgeRows();
    connect(m_table, &QTableWidget::itemChanged, this, [this] {
        if (!m_filling)
            changed();
    });
    connect(clear, &QPushButton::clicked, this, [this] {
        m_settings.remove(kDistancesKey);
        recall();
        judgeRows();
    });
}

InstallationPanel::~InstallationPanel() { m_table->disconnect(this); }

std::vector<std::optional<double>> InstallationPanel::measured_m() const
{
    std::vector<std::optional<double>> measured;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const auto typed = typedNumber(m_table->item(row, kMeasured)->text());
        measured.push_back(typed && *typed >= 0 ? typed : std::nullopt);
    }
    return measured;
}

void InstallationPanel::recall()
{
    const QScopedValueRollback quiet(m_filling, true);
    const QStringList kept = m_settings.value(kDistancesKey).toStringList();
    const auto distances = installationDistances();
    m_table->setRowCount(static_cast<int>(distances.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const InstallationDistance& one = distances[static_cast<std::size_t>(row)];
        m_table->setItem(row, kThing, fixedCell(toText(Message(one.thing))));
        m_table->setItem(row, kLeast, fixedCell(plainNumber(one.least_m, 1)));
        m_table->setItem(row, kMeasured, new QTableWidgetItem(kept.value(row)));
        m_table->setItem(row, kVerdict, fixedCell({}));
    }
}

void InstallationPanel::changed()
{
    QStringList typed;
    for (int row = 0; row < m_table->rowCount(); ++row)
        typed += m_table->item(row, kMeasured)->text();
    m_settings.setValue(kDistancesKey, typed);
    judgeRows();
}

void InstallationPanel::judgeRows()
{
    const QScopedValueRollback quiet(m_filling, true);
    const auto measured = measured_m();
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString typed = m_table->item(row, kMeasured)->text().trimmed();
        const auto place = static_cast<std::size_t>(row);
        m_table->item(row, kVerdict)
            ->setText(measured[place] || typed.isEmpty() ? distanceVerdict(installationDistances()[place], measured[place])
                                                         : tr("no distance; expected metres, 0 or more"));
    }
    m_words->setText(distancesWords(measured));
}

} // namespace lubberline::ui
