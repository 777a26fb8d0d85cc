#include "ui/swing/CoefficientsPanel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "ui/kit/Words.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/swing/SwingWords.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum Column { Approximate, ApproximateError, Exact, ExactError, Rule, kColumns };

/// What the 95 % interval of a coefficient is made of.
QString howWide(const SmithFitReport& fit, std::size_t coefficient, double scale, int decimals)
{
    const double whole = *fit.standardError[coefficient], shared = fit.shared[coefficient];
    const auto figure = [&](double value) { return QString::number(value * scale, 'f', decimals); };
    const QString factor = QString::number(*fit.intervalFactor, 'f', 2);
    if (shared == 0.0)
        return CoefficientsPanel::tr("95 % interval (Student): %1 standard errors of %2").arg(factor, figure(whole));
    return CoefficientsPanel::tr("95 % interval: %1 standard errors of %2 by the scatter (Student), and 1.96 of %3 that all readings share")
        .arg(factor, figure(std::sqrt(std::max(0.0, whole * whole - shared * shared))), figure(shared));
}

} // namespace

CoefficientsPanel::CoefficientsPanel(QWidget* parent)
    : QWidget(parent)
    , m_table(new QTableWidget(static_cast<int>(kCoefficientCount), kColumns))
    , m_summary(new QLabel)
    , m_limitations(new QLabel)
{
    m_table->setObjectName(QStringLiteral("coefficients"));
    m_table->setAccessibleName(tr("Coefficients"));
    wrapHeadings(*m_table); // before its height is asked
    m_table->setHorizontalHeaderLabels({tr("Approx. (°)"), tr("95 % ±"), tr("Exact"), tr("95 % ±"), tr("Rule (°)")});
    m_table->setVerticalHeaderLabels({"A", "B", "C", "D", "E"});
    const QString tips[] = {tr("Least squares of δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′ on compass headings"),
        tr("Half of the 95 % interval"), tr("Exact Smith coefficients, dimensionless, on magnetic headings"),
        tr("Half of the 95 % interval"), tr("The classical rule for 8 or 4 points")};
    for (int column = 0; column < kColumns; ++column)
        m_table->horizontalHeaderItem(column)->setToolTip(tips[column]);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
    m_table->verticalHeader()->setDefaultAlignment(Qt::AlignCenter);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setFixedHeight(heightOfRows(*m_table, m_table->rowCount())
        + m_table->horizontalScrollBar()->sizeHint().height()); // where it is narrow it scrolls, and hides no row
    m_table->setToolTip(tr("A click or Enter on a number opens where it comes from"));
    m_table->installEventFilter(this);
    connect(m_table, &QTableWidget::cellClicked, this, &CoefficientsPanel::askFor);
    m_summary->setObjectName(QStringLiteral("fitSummary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_limitations->setObjectName(QStringLiteral("limitations"));
    m_limitations->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(m_table);
    layout->addWidget(m_summary);
    layout->addWidget(m_limitations);
}

void CoefficientsPanel::askFor(int row, int column)
{
    const auto kind = column <= ApproximateError ? CoefficientPlace::Kind::Approximate
        : column <= ExactError                   ? CoefficientPlace::Kind::Exact
                                                 : CoefficientPlace::Kind::Rule;
    if (row >= 0)
        emit derivationWanted({kind, kCoefficients[static_cast<std::size_t>(row)]});
}

bool CoefficientsPanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_table && event->type() == QEvent::KeyPress)
        if (const int key = static_cast<QKeyEvent*>(event)->key(); key == Qt::Key_Return || key == Qt::Key_Enter) {
            askFor(m_table->currentRow(), m_table->currentColumn());
            return true;
        }
    return QWidget::eventFilter(object, event);
}

void CoefficientsPanel::setCell(int row, int column, const QString& text, const QString& whyNone)
{
    QTableWidgetItem* item = m_table->item(row, column);
    if (!item) {
        item = new QTableWidgetItem;
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->setItem(row, column, item);
    }
    item->setText(text.isEmpty() ? QStringLiteral("—") : text);
    item->setToolTip(text.isEmpty() ? whyNone : QString());
}

void CoefficientsPanel::showFit(const SmithFitReport& fit, int column, double scale, int decimals, const QString& whyNone)
{
    const QString whyNoInterval = fit.fitted() ? tr("No interval: there are no more readings than coefficients") : whyNone;
    const bool degrees = column == Approximate;
    const auto valueText = [&](double value) { return degrees ? shownFigure(value, decimals) : signedNumber(value, decimals); };
    const auto spreadText = [&](double value) {
        return degrees && shownAngles() == AngleStyle::DegreesMinutes ? shownSize(value, decimals) : plainNumber(value, decimals);
    };
    for (const Coefficient coefficient : kCoefficients) {
        const auto i = indexOf(coefficient);
        const auto value = fit.value[i], interval = fit.interval95(coefficient);
        setCell(static_cast<int>(i), column, value ? valueText(*value * scale) : QString(), whyNone);
        setCell(static_cast<int>(i), column + 1, interval ? spreadText(*interval * scale) : QString(), value ? whyNoInterval : whyNone);
        if (interval)
            m_table->item(static_cast<int>(i), column + 1)->setToolTip(howWide(fit, i, scale, decimals));
    }
}

void CoefficientsPanel::showPointRules(const std::optional<PointRules>& rules)
{
    m_table->horizontalHeaderItem(Rule)->setText(rules ? tr("%1-point (°)").arg(rules->points) : tr("Rule (°)"));
    std::array<std::optional<double>, kCoefficientCount> values_rad;
    if (rules)
        values_rad = {rules->A_rad, rules->B_rad, rules->C_rad, rules->D_rad, rules->E_rad};
    const QString why = rules ? tr("Four points cannot tell D") : tr("The rule needs readings near N, E, S and W");
    for (std::size_t i = 0; i < kCoefficientCount; ++i)
        setCell(static_cast<int>(i), Rule, values_rad[i] ? shownFigure(toDegrees(*values_rad[i]), 2) : QString(), why);
}

void CoefficientsPanel::show(const std::shared_ptr<const Analysis>& analysis, const QString& whyNone)
{
    if (!analysis) {
        for (int row = 0; row < m_table->rowCount(); ++row)
            for (int column = 0; column < kColumns; ++column)
                setCell(row, column, {}, whyNone);
        m_summary->setText(whyNone);
        m_limitations->clear();
        m_limitations->setVisible(false);
        return;
    }
    const QString limitations = limitationsOf(*analysis);
    const QString why = limitations.isEmpty() ? tr("These headings cannot tell it") : limitations;
    showFit(analysis->approximate, Approximate, kDegreesPerRadian, 2, why);
    showFit(analysis->exact, Exact, 1.0, 4, why);
    showPointRules(analysis->pointRules);
    QStringList parts{tr("N = %1").arg(analysis->readings.size())};
    if (analysis->approximate.fitted())
        parts += {tr("rms residual %1° (exact %2°)")
                      .arg(toDegrees(analysis->approximate.rms_rad), 0, 'f', 2)
                      .arg(toDegrees(analysis->exact.rms_rad), 0, 'f', 2),
            tr("degrees of freedom %1").arg(analysis->approximate.degreesOfFreedom)};
    if (std::isfinite(analysis->approximate.conditionNumber))
        parts += tr("condition %1").arg(analysis->approximate.conditionNumber, 0, 'f', 1);
    m_summary->setText(inAngleStyle(parts.join(QStringLiteral(" · "))));
    m_limitations->setText(inAngleStyle(limitations));
    m_limitations->setVisible(!limitations.isEmpty());
}

} // namespace lubberline::ui
