#include "ui/bench/BenchResults.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/iron/Coercivity.h"
#include "core/sensor/PoissonSmith.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorFieldForm.h"
#include "ui/sensor/SmithTermsPanel.h"

namespace lubberline::ui {

namespace {

QString fieldText(double value_nT) { return signedNumber(value_nT, 1); }

/// "hard iron P, Q, R", the matrix, and what each circuit adds: (S, T, V) of all that are on, and per ampere.
QString totalText(const SensorModel& model)
{
    const auto& S = model.softIron;
    const auto& p = model.hardIron_nT;
    QString text
        = BenchResults::tr("hard iron P %1, Q %2, R %3 nT\nsoft iron S:").arg(fieldText(p.x()), fieldText(p.y()), fieldText(p.z()));
    for (int row = 0; row < 3; ++row)
        text += QStringLiteral("\n   %1  %2  %3").arg(signedNumber(S(row, 0), 5), signedNumber(S(row, 1), 5), signedNumber(S(row, 2), 5));
    for (const auto& circuit : model.circuits) {
        const Eigen::Vector3d field_nT = circuit.field_nT_per_A * circuit.current_A;
        text += BenchResults::tr("\n%1, %2 A, %3: S %4, T %5, V %6 nT")
                    .arg(toText(circuit.name))
                    .arg(circuit.current_A)
                    .arg(circuit.on ? BenchResults::tr("on") : BenchResults::tr("off"), fieldText(field_nT.x()), fieldText(field_nT.y()),
                        fieldText(field_nT.z()));
    }
    return text;
}

/// "120, between": what a shock may change; a dash where the coercivity is not known.
QString driftText(const PartEffect& effect)
{
    const auto drift_nT = mayDrift_nT(effect);
    return drift_nT ? QStringLiteral("%1, %2").arg(plainNumber(*drift_nT, 0), translated(nameOf(ironClassOf(*effect.coercivity_A_per_m))))
                    : QStringLiteral("–");
}

} // namespace

BenchResults::BenchResults(const Clock& clock, QWidget* parent) : QTabWidget(parent)
{
    setObjectName(QStringLiteral("benchResults"));
    addTab(buildShares(), tr("&Parts' shares"));
    addTab(buildCoefficients(clock), tr("&Coefficients"));
}

QWidget* BenchResults::buildShares()
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(4, 4, 4, 4);
    m_total = new QLabel;
    m_total->setObjectName(QStringLiteral("benchTotal"));
    m_total->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(m_total);
    const QStringList heads{
        tr("part"), tr("distance (m)"), tr("by"), tr("P (nT)"), tr("Q (nT)"), tr("R (nT)"), tr("c"), tr("f"), tr("may drift (nT)")};
    m_effects = new QTableWidget(0, static_cast<int>(heads.size()));
    m_effects->setObjectName(QStringLiteral("benchEffects"));
    m_effects->setAccessibleName(tr("Each part's share"));
    m_effects->setHorizontalHeaderLabels(heads);
    m_effects->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_effects->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
    layout->addWidget(m_effects, 1);
    return box;
}

QWidget* BenchResults::buildCoefficients(const Clock& clock)
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(4, 4, 4, 4);
    m_field = new SensorFieldForm(clock);
    m_smith = new SmithTermsPanel;
    layout->addWidget(m_field);
    layout->addWidget(m_smith, 1);
    connect(m_field, &SensorFieldForm::played, this, &BenchResults::showCoefficients);
    connect(m_field, &SensorFieldForm::changed, this, &BenchResults::showCoefficients);
    return box;
}

void BenchResults::showFieldOf(db::Stores& stores, CompassId compass)
{
    if (const auto sites = stores.sites.sites())
        m_field->setSites(*sites);
    const auto swings = stores.swings.swingsOf(compass);
    if (!swings || swings->empty())
        return;
    if (const auto newest = stores.swings.record(swings->front().id); newest && newest->swing.field)
        m_field->showTyped(newest->swing.field->field.meridian());
}

void BenchResults::show(const BenchModel& model)
{
    m_model = model.model;
    m_total->setText(totalText(model.model));
    showShares(model);
    showCoefficients();
}

void BenchResults::showShares(const BenchModel& model)
{
    m_effects->setRowCount(static_cast<int>(model.parts.size()));
    for (int row = 0; row < m_effects->rowCount(); ++row) {
        const PartEffect& effect = model.parts[static_cast<std::size_t>(row)];
        const QStringList cells{toText(effect.part), QString::number(effect.distance_m, 'f', 2),
            effect.dipole ? tr("dipole") : tr("tensor"), fieldText(effect.hardIron_nT.x()), fieldText(effect.hardIron_nT.y()),
            fieldText(effect.hardIron_nT.z()), signedNumber(effect.softIron(0, 2), 5), signedNumber(effect.softIron(1, 2), 5),
            driftText(effect)};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setTextAlignment(Qt::AlignVCenter | (column == 0 || column == 2 ? Qt::AlignLeft : Qt::AlignRight));
            m_effects->setItem(row, column, item);
        }
    }
    m_effects->resizeColumnsToContents();
}

void BenchResults::showCoefficients()
{
    if (!m_model)
        return;
    const auto& field = m_field->field();
    const auto smith = field ? smithOf(*m_model, *field) : Result<PoissonSmith>(field.error());
    m_smith->show(smith);
    if (field)
        m_smith->showKnowledge(smith, *field);
}

} // namespace lubberline::ui
