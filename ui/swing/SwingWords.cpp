#include "ui/swing/SwingWords.h"

#include <QCoreApplication>

#include <cmath>

#include "core/swing/Gaps.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct SwingWordsTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SwingWords)
};

QString place(MagneticHeading heading) { return toText(formatHeading(heading.degrees(), AngleStyle::DecimalDegrees, 0)); }

QString limitName(const LimitsProfile& limits)
{
    QStringList parts;
    for (const std::string& part : {limits.document, limits.issue})
        if (!part.empty())
            parts += toText(part);
    return parts.isEmpty() ? toText(limits.name) : parts.join(QStringLiteral(", "));
}

/// One limit: "Within 10°" or "Exceeds the 10° allowed".
QString against(double value_deg, std::optional<double> limit_deg, const QString& quantity)
{
    if (!limit_deg)
        return {};
    const QString limit = numberText(limit_deg);
    return value_deg <= *limit_deg
        ? SwingWordsTexts::tr("%1 within %2°").arg(quantity, limit)
        : SwingWordsTexts::tr("%1 %2° exceeds the %3° allowed").arg(quantity).arg(value_deg, 0, 'f', 1).arg(limit);
}

QString judgementSentence(const Summary& summary, const std::optional<LimitsProfile>& limits)
{
    const Judgement judgement = judge(summary, limits);
    if (judgement.partlyRead)
        return SwingWordsTexts::tr("NOT KNOWN: within limits where it was read, but over %1° of the circle nothing was read.")
            .arg(summary.unread_deg, 0, 'f', 0);
    if (judgement.verdict == Verdict::NotKnown)
        return SwingWordsTexts::tr("No limits are set for this compass: choose them on the aircraft's page (Ctrl+U).");
    QStringList parts;
    for (const QString& part : {against(judgement.maxAbsDeviation_deg, limits->maxDeviation_deg, SwingWordsTexts::tr("deviation")),
             against(judgement.spread_deg, limits->maxSpread_deg, SwingWordsTexts::tr("spread"))})
        if (!part.isEmpty())
            parts += part;
    const QString verdict
        = judgement.verdict == Verdict::InLimits ? SwingWordsTexts::tr("In limits") : SwingWordsTexts::tr("OUT OF LIMITS");
    return SwingWordsTexts::tr("%1: %2 (%3).").arg(verdict, parts.join(SwingWordsTexts::tr(", ")), limitName(*limits));
}

QString suspicionSentence(const Analysis& analysis)
{
    for (const AnalysedReading& reading : analysis.readings)
        if (reading.suspect)
            return SwingWordsTexts::tr(" A reading is suspect: look again before these figures are used.");
    return {};
}

/// In limits is what was read: of the rest nothing is known.
QString unreadSentence(const Analysis& analysis)
{
    QStringList arcs;
    for (const auto& gap : gapsOf(analysis))
        arcs += QStringLiteral("%1–%2").arg(toText(formatHeading(gap.from.degrees(), AngleStyle::DecimalDegrees, 0)),
            toText(formatHeading(gap.to.degrees(), AngleStyle::DecimalDegrees, 0)));
    return arcs.isEmpty() ? QString() : SwingWordsTexts::tr(" Not read: %1 (compass).").arg(arcs.join(QStringLiteral(", ")));
}

} // namespace

QString meaningOf(const Analysis& analysis, const std::optional<LimitsProfile>& limits, AngleStyle style)
{
    const Summary& summary = analysis.summary;
    return SwingWordsTexts::tr("Largest deviation %1 at %2 magnetic. ")
               .arg(toText(formatSignedAngle(toDegrees(summary.largestDeviation_rad), style)), place(summary.maxAbsDeviationAt))
        + judgementSentence(summary, limits) + suspicionSentence(analysis) + unreadSentence(analysis);
}

QString limitationsOf(const Analysis& analysis)
{
    QStringList lines;
    for (const auto& warning : analysis.warnings)
        lines += toText(warning);
    return lines.join('\n');
}

} // namespace lubberline::ui
