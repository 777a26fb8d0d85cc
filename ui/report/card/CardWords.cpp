#include "ui/report/card/CardWords.h"

#include <algorithm>
#include <cmath>

#include "core/swing/CardRemarks.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

QString degreesOfLimit(double limit_deg) { return QString::number(limit_deg, 'g', 6) + QStringLiteral("°"); }

QString headingFigures(double heading_deg) { return threeDigits(qRound(heading_deg)); }

QString signatureOf(const Signature& one)
{
    const QString who = joined({printable(one.name), printable(one.licence), printable(one.timeUtc).left(10)});
    switch (one.role) {
    case SignatureRole::Performer: return Words::tr("Performed %1").arg(who);
    case SignatureRole::Inspector: return Words::tr("Inspected %1").arg(who);
    case SignatureRole::Authority: return Words::tr("Released %1").arg(who);
    }
    return {};
}

QString lettersOf(CoefficientSet removed)
{
    QStringList letters;
    for (const Coefficient c : kCoefficients)
        if (removed.test(indexOf(c)))
            letters += QChar::fromLatin1(letterOf(c));
    return letters.join(QStringLiteral(", "));
}

QString gapWords(const ReadingGap& gap)
{
    const QString arc = QStringLiteral("%1–%2").arg(headingFigures(gap.from.degrees()), headingFigures(gap.to.degrees()));
    return gap.widestBand_rad ? QStringLiteral("%1 (±%2°)").arg(arc, figure(toDegrees(*gap.widestBand_rad), 1)) : arc;
}

QString attitudeWords(const std::optional<SwungAttitude::Range>& range)
{
    if (!range)
        return notStated();
    const QString least = signedFigure(range->least_deg, attitudeDecimals(range->least_deg)),
                  most = signedFigure(range->most_deg, attitudeDecimals(range->most_deg));
    return least == most ? least + QStringLiteral("°") : Words::tr("%1 to %2°").arg(least, most);
}

/// What is complete is finished, and wants a signature; all else that is not signed is no card yet.
bool isDraft(const CardColumn& column) { return !column.isSigned() && column.record.swing.state != SwingState::Complete; }

} // namespace

QString cardBanner(const CardInput& input)
{
    QStringList marks;
    if (input.record().aircraft.demonstration)
        marks += Words::tr("DEMONSTRATION DATA");
    const auto mark = [&](auto applies, const QString& ofAll, const QString& ofSome) {
        QStringList those;
        for (const CardColumn& column : input.columns)
            if (applies(column))
                those += column.heading;
        if (those.size() == static_cast<qsizetype>(input.columns.size()))
            marks += ofAll;
        else if (!those.isEmpty())
            marks += ofSome.arg(those.join(QStringLiteral(", ")));
    };
    mark([](const CardColumn& column) { return column.outOfLimits(); }, Words::tr("OUT OF LIMITS"), Words::tr("%1: OUT OF LIMITS"));
    mark([](const CardColumn& column) { return column.card.index_deg != 0.0; }, Words::tr("OUT AS A WHOLE: LOOK AT ITS MOUNT"),
        Words::tr("%1: OUT AS A WHOLE, LOOK AT ITS MOUNT"));
    mark([](const CardColumn& column) { return isDraft(column); }, Words::tr("DRAFT — NOT SIGNED"), Words::tr("%1: DRAFT — NOT SIGNED"));
    mark([](const CardColumn& column) { return !column.isSigned() && !isDraft(column); }, Words::tr("NOT SIGNED"),
        Words::tr("%1: NOT SIGNED"));
    mark([](const CardColumn& column) { return column.superseded; }, Words::tr("AMENDED SINCE: NOT VALID"),
        Words::tr("%1: AMENDED SINCE, NOT VALID"));
    return joined(marks);
}

QString unsignedMark(const CardColumn& column)
{
    return column.isSigned() ? QString() : isDraft(column) ? Words::tr("DRAFT") : Words::tr("NOT SIGNED");
}

QString recordLine(const CardColumn& column)
{
    const Swing& swing = column.record.swing;
    const QString record = printable(swing.record).left(8);
    const QString revision = swing.revision > 1 ? Words::tr(" rev. %1").arg(swing.revision) : QString();
    return Words::tr("Record %1%2 · data %3 · %4")
        .arg(record.isEmpty() ? dash() : record, revision, dataHash(column.record).left(8),
            !column.isSigned()    ? unsignedMark(column)
                : column.verified ? Words::tr("signed")
                                  : Words::tr("signed, names not verified"));
}

QStringList signatureLinesOf(const CardColumn& column)
{
    const Swing& swing = column.record.swing;
    if (swing.state == SwingState::Signed && column.holds && column.card.options.removed.any())
        return {Words::tr("Not signed: figures without %1, which was taken out after what was signed")
                    .arg(lettersOf(column.card.options.removed))};
    if (swing.state == SwingState::Signed && !column.holds)
        return {swing.signatures.empty() ? Words::tr("Not signed: the record says signed, and nobody's signature is there")
                                         : Words::tr("Not signed: the record is not what was signed")};
    if (swing.state != SwingState::Signed)
        return {swing.state == SwingState::Draft ? Words::tr("Not signed: a draft")
                                                 : Words::tr("Not signed: complete, signatures are wanting")};
    QStringList lines;
    for (const SignatureRole role : {SignatureRole::Performer, SignatureRole::Inspector, SignatureRole::Authority}) {
        // Of several of one role the last stands: the others were given before a change.
        const auto one
            = std::find_if(swing.signatures.rbegin(), swing.signatures.rend(), [role](const Signature& each) { return each.role == role; });
        if (one != swing.signatures.rend())
            lines += signatureOf(*one);
    }
    if (!column.signedAs.isEmpty())
        lines += column.signedAs;
    return lines.isEmpty() ? QStringList{Words::tr("Signed before signatures were kept")} : lines;
}

QString qualityLine(const CardColumn& column)
{
    const Card& card = column.card;
    const QString method = card.options.source == CardSource::Fit ? Words::tr("By the exact fit") : Words::tr("By the nearest reading");
    return card.widestBand_rad ? Words::tr("%1, 95 % band ±%2°").arg(method, figure(bandInTenths_deg(*card.widestBand_rad), 1))
                               : Words::tr("%1, band not known").arg(method);
}

QString largestLine(const CardColumn& column)
{
    const auto there = [](const DeviationThere& one) {
        return Words::tr("%1° on %2 magnetic").arg(signedFigure(one.deviation.degrees(), 1), headingFigures(one.at.degrees()));
    };
    return Words::tr("Largest residual %1; largest reading %2").arg(there(column.card.largestResidual), there(column.card.largestReading));
}

QStringList shortRemarks(const CardColumn& column)
{
    const Card& card = column.card;
    const auto& limits = column.record.limits;
    QStringList remarks;
    if (std::any_of(card.rows.begin(), card.rows.end(), [&](const CardRow& row) { return overLimit(row, limits); }))
        remarks += Words::tr("! OVER THE LIMIT of %1").arg(degreesOfLimit(*limits->maxDeviation_deg));
    QStringList gaps;
    for (const auto& gap : card.gaps)
        gaps += gapWords(gap);
    if (!gaps.isEmpty())
        remarks += Words::tr("* nobody read between (compass) %1").arg(gaps.join(QStringLiteral(", ")));
    QStringList skipped;
    for (const auto& reading : column.record.swing.readings)
        if (reading.nominal_deg && !reading.complete())
            skipped += headingFigures(*reading.nominal_deg);
    if (!skipped.isEmpty())
        remarks += Words::tr("* not read on %1").arg(skipped.join(QStringLiteral(", ")));
    for (const auto& suspect : card.suspects)
        remarks += Words::tr("SUSPECT reading used, on %1").arg(headingFigures(suspect.at.degrees()));
    const SwungAttitude attitude = attitudeOf(column.record.swing);
    if (attitude.tilted)
        remarks += Words::tr("NOT LEVEL: pitch %1, roll %2").arg(attitudeWords(attitude.pitch), attitudeWords(attitude.roll));
    if (toDegrees(card.betweenRows_rad) > kBetweenRows_deg) {
        const QString off = Words::tr("Between rows up to %1° off").arg(figure(toDegrees(card.betweenRows_rad), 1));
        remarks += card.finerStep_deg > 0 ? Words::tr("%1: better every %2°").arg(off).arg(card.finerStep_deg) : off;
    }
    if (card.options.removed.any())
        remarks += Words::tr("Without %1, taken out after the swing").arg(lettersOf(card.options.removed));
    return remarks;
}

QString markOf(const CardRow& row, const CardColumn& column)
{
    return (row.unread || skippedNear(row, column.record.swing) ? QStringLiteral("*") : QString())
        + (overLimit(row, column.record.limits) ? QStringLiteral("!") : QString());
}

QString methodWords(const CardOptions& options)
{
    const QString source = options.source == CardSource::Fit ? Words::tr("deviation by the exact fit at each heading")
                                                             : Words::tr("deviation of the reading nearest to each heading");
    const QString removed = options.removed.any()
        ? Words::tr("; %1 taken out mechanically after the swing and not in these figures").arg(lettersOf(options.removed))
        : QString();
    return options.by == CardBy::Magnetic ? Words::tr("STEER = FOR − deviation, to whole degrees; %1%2").arg(source, removed)
                                          : Words::tr("MAGNETIC = COMPASS + deviation, to whole degrees; %1%2").arg(source, removed);
}

QString threeDigits(int heading_deg) { return QStringLiteral("%1").arg(heading_deg % 360, 3, 10, QChar('0')); }

} // namespace lubberline::ui
