#include "ui/swing/DerivationPanel.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QTextBrowser>
#include <QToolButton>

#include <cmath>

#include "core/angle/PrintedHeading.h"
#include "core/deviation/Derivation.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDerivationHeight_px = 230, kCloseSide_px = 24;
constexpr std::size_t kMostTerms = 400; // a log has thousands: its sum stands, its rows do not

using CoefficientKind = CoefficientPlace::Kind;

QString formulaOf(CoefficientPlace place, int points)
{
    if (place.kind == CoefficientKind::Approximate)
        return DerivationPanel::tr(
            "δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′, by least squares over all readings (δ = magnetic − compass, ψ′ compass heading)");
    if (place.kind == CoefficientKind::Exact)
        return DerivationPanel::tr(
            "sin δ = 𝔄 cos δ + 𝔅 sin ψ′ + ℭ cos ψ′ + 𝔇 sin(ψ + ψ′) + 𝔈 cos(ψ + ψ′), Smith's exact equation, by least squares over all readings (ψ magnetic heading)");
    switch (place.coefficient) {
    case Coefficient::A:
        return points == 8 ? QStringLiteral("A = (δN + δNE + δE + δSE + δS + δSW + δW + δNW) / 8")
                           : QStringLiteral("A = (δN + δE + δS + δW) / 4");
    case Coefficient::B: return QStringLiteral("B = (δE − δW) / 2");
    case Coefficient::C: return QStringLiteral("C = (δN − δS) / 2");
    case Coefficient::D: return QStringLiteral("D = ((δNE + δSW) − (δSE + δNW)) / 4");
    case Coefficient::E: return QStringLiteral("E = ((δN + δS) − (δE + δW)) / 4");
    }
    return {};
}

std::optional<Derivation> derivedBy(const Analysis& analysis, CoefficientPlace place)
{
    std::vector<Observation> readings;
    for (const AnalysedReading& reading : analysis.readings)
        readings.push_back({reading.magnetic, reading.compass});
    switch (place.kind) {
    case CoefficientKind::Approximate: return derivationOf(readings, analysis.approximate, place.coefficient);
    case CoefficientKind::Exact: return derivationOf(readings, analysis.exact, place.coefficient);
    case CoefficientKind::Rule: return analysis.pointRules ? derivationOf(readings, *analysis.pointRules, place.coefficient) : std::nullopt;
    }
    return {};
}

QString derivationRow(const QStringList& texts, const char* tag)
{
    QString html = QStringLiteral("<tr>");
    for (const QString& text : texts)
        html += QStringLiteral("<%1 align='right' style='padding-left: 14px'>%2</%1>").arg(QLatin1String(tag), text);
    return html + QStringLiteral("</tr>");
}

QString derivationTable(const Analysis& analysis, const Derivation& derivation, CoefficientPlace place)
{
    const bool exact = place.kind == CoefficientKind::Exact;
    const double scale = exact ? 1.0 : kDegreesPerRadian;
    const int decimals = exact ? 5 : 3;
    QString html = QStringLiteral("<table>")
        + derivationRow(
            {DerivationPanel::tr("magnetic ψ"), DerivationPanel::tr("compass ψ′"),
                exact ? QStringLiteral("y = sin δ") : QStringLiteral("y = δ"), DerivationPanel::tr("weight w"), QStringLiteral("w·y")},
            "th");
    for (std::size_t i = 0; i < derivation.terms.size() && i < kMostTerms; ++i) {
        const DerivationTerm& term = derivation.terms[i];
        const AnalysedReading& reading = analysis.readings[term.reading];
        html += derivationRow({QString::number(printedHeading_deg(reading.magnetic.degrees(), 1), 'f', 1) + u'°',
                                  QString::number(printedHeading_deg(reading.compass.degrees(), 1), 'f', 1) + u'°',
                                  signedNumber(term.quantity * scale, decimals), signedNumber(term.weight, 4),
                                  signedNumber(term.product() * scale, decimals)},
            "td");
    }
    html += derivationRow(
        {DerivationPanel::tr("sum"), {}, {}, {}, QStringLiteral("<b>%1</b>").arg(signedNumber(derivation.sum * scale, decimals))}, "td");
    return html + QStringLiteral("</table>");
}

QString intervalWords(const SmithFitReport& fit, CoefficientPlace place)
{
    const bool exact = place.kind == CoefficientKind::Exact;
    const double scale = exact ? 1.0 : kDegreesPerRadian;
    const int decimals = exact ? 5 : 3;
    const auto interval = fit.interval95(place.coefficient), error = fit.standardError[indexOf(place.coefficient)];
    if (!interval || !fit.sigma_rad)
        return DerivationPanel::tr("No interval: there are no more readings than coefficients.");
    const double shared = fit.shared[indexOf(place.coefficient)], byScatter = std::sqrt(std::max(0.0, *error * *error - shared * shared));
    const QString scatter
        = DerivationPanel::tr("the standard error follows from the scatter of the readings, s = √(Σ residual² / %1) = %2°.")
              .arg(fit.degreesOfFreedom)
              .arg(toDegrees(*fit.sigma_rad), 0, 'f', 3);
    const auto figure = [&](double value) { return QString::number(value * scale, 'f', decimals); };
    const QString factor = QString::number(*fit.intervalFactor, 'f', 2);
    if (shared == 0.0)
        return DerivationPanel::tr("95 % ± %1 = %2 × %3: Student's factor for %4 degrees of freedom times the standard error; ")
                   .arg(figure(*interval), factor, figure(*error), QString::number(fit.degreesOfFreedom))
            + scatter;
    return DerivationPanel::tr(
               "95 % ± %1 = √((%2 × %3)² + (1.96 × %4)²): Student's factor for %5 degrees of freedom times the standard error "
               "by the scatter, and 1.96 of the error that all readings share, which is stated; ")
               .arg(figure(*interval), factor, figure(byScatter), figure(shared), QString::number(fit.degreesOfFreedom))
        + scatter;
}

} // namespace

QString derivationHtml(const Analysis& analysis, CoefficientPlace place)
{
    const QString kinds[] = {DerivationPanel::tr("approximate"), DerivationPanel::tr("exact"), DerivationPanel::tr("point rule")};
    const QChar letter = QLatin1Char(letterOf(place.coefficient));
    const auto derivation = derivedBy(analysis, place);
    if (!derivation)
        return QStringLiteral("<p>%1</p>")
            .arg(DerivationPanel::tr("%1 (%2): these headings cannot tell it.").arg(letter).arg(kinds[static_cast<int>(place.kind)]));
    const bool exact = place.kind == CoefficientKind::Exact;
    const QString value = exact ? signedNumber(derivation->sum, 4) : signedNumber(toDegrees(derivation->sum), 2) + u'°';
    QString html
        = QStringLiteral("<p><b>%1 (%2) = %3</b></p><p>%4</p>")
              .arg(letter)
              .arg(kinds[static_cast<int>(place.kind)], value, formulaOf(place, analysis.pointRules ? analysis.pointRules->points : 8));
    if (place.kind != CoefficientKind::Rule)
        html += QStringLiteral("<p>%1</p>")
                    .arg(DerivationPanel::tr("Solved for %1 that is a sum over the readings, Σ w·y: what each of them adds.").arg(letter));
    html += derivationTable(analysis, *derivation, place);
    if (place.kind == CoefficientKind::Approximate)
        html += QStringLiteral("<p>%1</p>").arg(intervalWords(analysis.approximate, place));
    if (exact)
        html += QStringLiteral("<p>%1</p>").arg(intervalWords(analysis.exact, place));
    return html;
}

DerivationPanel::DerivationPanel(QWidget* parent) : QFrame(parent), m_text(new QTextBrowser)
{
    setObjectName(QStringLiteral("derivation"));
    setFrameShape(QFrame::StyledPanel);
    setFixedHeight(kDerivationHeight_px);
    m_text->setObjectName(QStringLiteral("derivationText"));
    m_text->setAccessibleName(tr("Where the number comes from"));
    m_text->setFrameShape(QFrame::NoFrame);
    auto* dismiss = new QToolButton;
    dismiss->setObjectName(QStringLiteral("closeDerivation"));
    dismiss->setText(QStringLiteral("✕"));
    dismiss->setAutoRaise(true);
    dismiss->setFixedSize(kCloseSide_px, kCloseSide_px);
    dismiss->setToolTip(tr("Close (Esc)"));
    dismiss->setAccessibleName(tr("Close"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 4, 4, 4);
    row->addWidget(m_text, 1);
    row->addWidget(dismiss, 0, Qt::AlignTop);
    setFocusProxy(m_text);
    connect(dismiss, &QToolButton::clicked, this, &DerivationPanel::close);
}

void DerivationPanel::show(const std::shared_ptr<const Analysis>& analysis, CoefficientPlace place)
{
    m_place = place;
    refresh(analysis);
}

void DerivationPanel::refresh(const std::shared_ptr<const Analysis>& analysis)
{
    setVisible(analysis != nullptr);
    if (analysis)
        m_text->setHtml(derivationHtml(*analysis, m_place));
}

void DerivationPanel::close()
{
    hide();
    emit closed();
}

void DerivationPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QFrame::keyPressEvent(event);
}

} // namespace lubberline::ui
