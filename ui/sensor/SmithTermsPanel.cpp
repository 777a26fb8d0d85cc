#include "ui/sensor/SmithTermsPanel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <array>

#include "core/angle/Angle.h"
#include "core/swing/IronSeparation.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum Column { Letter, Exact, Approximate, Terms, kColumns };

/// "soft iron c (dip)", or short "c": letters and circuits' names tell enough beside each other.
QString causeOf(const SmithTerm& term, bool inShort)
{
    const QString whole = toText(term.cause);
    if (inShort)
        for (const char* kind : {"soft iron ", "hard iron ", "soft constant ", "circuit "})
            if (whole.startsWith(QLatin1String(kind)))
                return whole.mid(static_cast<int>(qstrlen(kind))).remove(QStringLiteral(" (dip)"));
    return whole;
}

QString beginning(const QString& sentence) { return sentence.left(1).toUpper() + sentence.mid(1); }

QString termsOf(const PoissonSmith& smith, Coefficient coefficient, bool inShort)
{
    QStringList terms;
    for (const SmithTerm& term : smith.terms)
        if (term.coefficient == coefficient)
            terms += causeOf(term, inShort) + QChar::Nbsp + signedNumber(term.value, 4);
    return terms.isEmpty() ? QStringLiteral("—") : terms.join(QStringLiteral(" · "));
}

} // namespace

SmithTermsPanel::SmithTermsPanel(QWidget* parent)
    : QWidget(parent)
    , m_lambda(new QLabel)
    , m_table(new QTableWidget(static_cast<int>(kCoefficientCount), kColumns))
    , m_knowledge(new QListWidget)
{
    m_lambda->setObjectName(QStringLiteral("lambdaWords"));
    m_lambda->setWordWrap(true);
    m_lambda->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_lambda->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setObjectName(QStringLiteral("smithTerms"));
    m_table->setAccessibleName(tr("Coefficients and the terms that they come from"));
    m_table->setHorizontalHeaderLabels({QString(), tr("exact"), tr("approximate"), tr("comes from")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(true);
    for (const Coefficient coefficient : kCoefficients)
        for (int column = 0; column < kColumns; ++column) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment(Qt::AlignVCenter | (column == Exact || column == Approximate ? Qt::AlignRight : Qt::AlignLeft));
            m_table->setItem(static_cast<int>(indexOf(coefficient)), column, item);
        }
    m_knowledge->setObjectName(QStringLiteral("swingKnowledge"));
    m_knowledge->setAccessibleName(tr("What a level swing can tell and what it cannot"));
    m_knowledge->setWordWrap(true);
    m_knowledge->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* left = new QVBoxLayout;
    left->setSpacing(2);
    left->addWidget(m_lambda);
    left->addWidget(m_table, 1);
    auto* right = new QVBoxLayout;
    right->setSpacing(2);
    right->addWidget(new QLabel(tr("What a level swing here can tell")));
    right->addWidget(m_knowledge, 1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(left, 8);
    layout->addLayout(right, 5);
}

void SmithTermsPanel::show(const Result<PoissonSmith>& smith)
{
    m_table->setVisible(smith.ok());
    if (!smith) {
        m_lambda->setText(tr("No coefficients: %1.").arg(messageOf(smith.error())));
        return;
    }
    QString words
        = tr("λ = %1: a level compass is held by %2 % of H on the mean.").arg(smith->lambda, 0, 'f', 4).arg(100 * smith->lambda, 0, 'f', 1);
    if (!smith->approximate)
        words += QChar(' ') + beginning(toText(smith->whyNoApproximate)) + QChar('.');
    m_lambda->setText(inAngleStyle(words));
    showRows(*smith);
}

void SmithTermsPanel::showRows(const PoissonSmith& smith)
{
    const std::array exact{smith.exact.A, smith.exact.B, smith.exact.C, smith.exact.D, smith.exact.E};
    const ApproximateSmith approximate = smith.approximate.value_or(ApproximateSmith());
    const std::array approximate_rad{approximate.A_rad, approximate.B_rad, approximate.C_rad, approximate.D_rad, approximate.E_rad};
    for (const Coefficient coefficient : kCoefficients) {
        const std::size_t i = indexOf(coefficient);
        const int row = static_cast<int>(i);
        m_table->item(row, Letter)->setText(QString(QLatin1Char(letterOf(coefficient))));
        m_table->item(row, Exact)->setText(signedNumber(exact[i], 5));
        m_table->item(row, Approximate)->setText(smith.approximate ? shownAngle(toDegrees(approximate_rad[i]), 2) : QStringLiteral("—"));
        m_table->item(row, Terms)->setText(termsOf(smith, coefficient, true));
        m_table->item(row, Terms)->setToolTip(termsOf(smith, coefficient, false));
    }
    m_table->resizeRowsToContents();
}

void SmithTermsPanel::showKnowledge(const Result<PoissonSmith>& smith, const MeridianField& field)
{
    m_knowledge->clear();
    if (!smith)
        return;
    SwingAtPlace swing;
    swing.exact = smith->exact;
    swing.field = field;
    const auto list = whatSwingsTell(swing, std::nullopt);
    for (const Knowledge& one : list)
        m_knowledge->addItem((one.known ? QStringLiteral("✓ ") : QStringLiteral("✗ ")) + toText(one.what));
}

} // namespace lubberline::ui
