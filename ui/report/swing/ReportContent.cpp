#include "ui/report/swing/ReportContent.h"

#include <algorithm>
#include <memory>
#include <span>

#include "core/format/exchange/SignedContent.h"
#include "core/swing/CardRemarks.h"
#include "core/swing/Gaps.h"
#include "core/swing/SwingResult.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/JobTables.h"

namespace lubberline::ui {

namespace {

/// Without a trailing ".0": limits are printed as their documents print them.
QString shortDegrees(double angle_deg) { return QString::number(angle_deg, 'g', 6) + QStringLiteral("°"); }

std::shared_ptr<const Analysis> previousAnalysis(const ReportInput& input)
{
    if (!input.previous)
        return nullptr;
    SwingRecord before = input.record; // the same compass
    before.swing = *input.previous;
    auto analysis = resultOf(before, input.previousJob ? &input.previousJob->job : nullptr);
    return analysis ? std::make_shared<const Analysis>(std::move(*analysis)) : nullptr; // its own report says why there is none
}

SwingPicture pictureFor(const ReportInput& input)
{
    const QString label = input.previous ? printable(input.previous->date) : QString();
    return pictureOf(input.record, std::make_shared<const Analysis>(input.analysis), {}, previousAnalysis(input), label, input.angleStyle);
}

QString verdictWordOf(const Judgement& judgement)
{
    if (judgement.partlyRead)
        return Words::tr("NOT KNOWN");
    switch (judgement.verdict) {
    case Verdict::InLimits: return Words::tr("PASS");
    case Verdict::OutOfLimits: return Words::tr("FAIL");
    case Verdict::NotKnown: break;
    }
    return Words::tr("NO LIMIT SET");
}

QString sentenceFor(const ReportInput& input)
{
    const Summary& summary = input.analysis.summary;
    QString found
        = Words::tr("Largest deviation %1 at %2 magnetic; spread (maximum − minimum) %3°.")
              .arg(angleWords(toDegrees(summary.largestDeviation_rad), input.angleStyle),
                  headingWords(summary.maxAbsDeviationAt.degrees(), input.angleStyle), figure(toDegrees(summary.spread_rad()), 1));
    for (const auto& gap : gapsOf(input.analysis)) // the verdict is of what was read
        found += QStringLiteral(" %1.").arg(printable(wordsOf(gap)));
    if (const auto tilted = wordsOf(attitudeOf(input.record.swing)); !tilted.empty()) // limits are of level flight
        found += QStringLiteral(" %1.").arg(printable(tilted));
    const QString limits = input.record.limits ? limitWords(*input.record.limits) : QString();
    return limits.isEmpty() ? Words::tr("%1 No limit is set for this compass.").arg(found) : Words::tr("%1 Limit: %2").arg(found, limits);
}

/// What changed since last time, by coefficient and by heading: this curve less that one.
std::optional<Fact> changeFact(const ReportInput& input)
{
    const auto before = previousAnalysis(input);
    if (!before || before->exact.parameters != static_cast<int>(kCoefficientCount)
        || input.analysis.exact.parameters != static_cast<int>(kCoefficientCount))
        return {};
    QStringList coefficients, headings;
    for (const Coefficient c : kCoefficients)
        if (const auto now = input.analysis.approximate.of(c), then = before->approximate.of(c); now && then)
            coefficients += QStringLiteral("%1 %2").arg(QChar::fromLatin1(letterOf(c))).arg(signedFigure(toDegrees(*now - *then), 1));
    const ExactSmith now = input.analysis.exact.smith(), then = before->exact.smith();
    for (int heading = 0; heading < 360; heading += 45) {
        const auto at = MagneticHeading::fromDegrees(heading);
        headings += QStringLiteral("%1 %2")
                        .arg(heading, 3, 10, QChar('0'))
                        .arg(signedFigure(deviationAt(now, at).degrees() - deviationAt(then, at).degrees(), 1));
    }
    QString change = Words::tr("the deviation has changed by (°) %1; coefficients by (°) %2")
                         .arg(headings.join(QStringLiteral(", ")), coefficients.join(QStringLiteral(", ")));
    const QString words = configurationWords(input.record.swing.configuration),
                  wordsThen = configurationWords(input.previous->configuration);
    if (words != wordsThen) // a radio moves the curve, too
        change = Words::tr("%1; then it was swung otherwise: %2").arg(change, wordsThen.isEmpty() ? notStated() : wordsThen);
    return Fact{Words::tr("Since %1").arg(printable(input.previous->date)), change};
}

QStringList warningsOf(const Analysis& analysis)
{
    QStringList warnings;
    for (const auto& warning : analysis.warnings)
        warnings += printable(warning);
    return warnings;
}

QString roleWord(SignatureRole role)
{
    switch (role) {
    case SignatureRole::Performer: return Words::tr("Performed");
    case SignatureRole::Inspector: return Words::tr("Inspected");
    case SignatureRole::Authority: return Words::tr("Released");
    }
    return {};
}

SignatureState stateByHash(const SwingRecord& record, const std::optional<SwingJob>& job, std::size_t which)
{
    const Signature& one = record.swing.signatures[which];
    const std::span<const Signature> before(record.swing.signatures.data(), which);
    SignatureState state{hashOfText(signedContent(record, job, one, before)).toStdString() == one.hash};
    if (one.contents >= 3)
        state.since = changedSince(one.particulars, record);
    state.holds = state.holds && state.since.empty();
    if (one.key.empty())
        state.key.state = KeyState::NameOnly;
    return state;
}

QString keyWords(const KeyVerdict& key)
{
    return key.state == KeyState::NameOnly || key.words.empty() ? Words::tr("name not verified") : printable(key.words);
}

QString signWords(const Signature& one, const SignatureState& state)
{
    QStringList words;
    if (!state.holds)
        words += Words::tr("no longer holds: changed after it");
    else
        words += Words::tr("signed %1 · hash %2").arg(printable(one.timeUtc).mid(11, 5), printable(one.hash).left(12));
    if (state.holds)
        words += keyWords(state.key);
    words += signedAs(state);
    return joined(words);
}

/// Those that were given, and what is still wanted; where none is, lines for the people of the swing to sign by hand.
std::vector<SignatureLine> signatureLines(const ReportInput& input)
{
    const Swing& swing = input.record.swing;
    std::vector<SignatureLine> lines;
    std::optional<SwingJob> own;
    if (input.job && input.job->job.record == swing.job && input.job->swing == swing.id)
        own = input.job->job;
    for (std::size_t i = 0; i < swing.signatures.size(); ++i) {
        const Signature& one = swing.signatures[i];
        const SignatureState state = i < input.signatures.size() ? input.signatures[i] : stateByHash(input.record, own, i);
        lines.push_back({roleWord(one.role), joined({printable(one.name), printable(one.licence)}), printable(one.timeUtc).left(10),
            signWords(one, state)});
    }
    if (!lines.empty()) {
        for (const auto role : {SignatureRole::Performer, SignatureRole::Inspector}) // those that freeze a swing
            if (swing.state != SwingState::Signed
                && std::ranges::none_of(swing.signatures, [&](const Signature& one) { return one.role == role; }))
                lines.push_back({roleWord(role), {}, {}, {}});
        return lines;
    }
    const People& people = swing.people;
    return {{Words::tr("Datum reader"), printable(people.datumReader), {}, {}},
        {Words::tr("Cockpit reader"), printable(people.cockpitReader), {}, {}}, {Words::tr("Adjuster"), printable(people.adjuster), {}, {}},
        {Words::tr("Inspector"), printable(people.inspector), {}, {}}};
}

} // namespace

QString limitWords(const LimitsProfile& limits)
{
    QStringList bounds;
    if (limits.maxDeviation_deg)
        bounds += Words::tr("|deviation| ≤\u00a0%1").arg(shortDegrees(*limits.maxDeviation_deg));
    if (limits.maxSpread_deg)
        bounds += Words::tr("spread ≤\u00a0%1").arg(shortDegrees(*limits.maxSpread_deg));
    if (bounds.isEmpty())
        return {};
    const QString issue = labelled(Words::tr("issue"), printable(limits.issue));
    QStringList source{printable(limits.document), issue, printable(limits.scope)};
    source.removeAll(QString());
    return source.isEmpty() ? Words::tr("%1, no document named").arg(bounds.join(QStringLiteral(", ")))
                            : QStringLiteral("%1 (%2)").arg(bounds.join(QStringLiteral(", ")), source.join(QStringLiteral("; ")));
}

ReportContent contentOf(const ReportInput& input)
{
    const SwingRecord& record = input.record;
    ReportContent content;
    content.frame = frameFor(record, Words::tr("Compass swing report"), input.madeAtUtc);
    content.frame.credit = Words::tr("The plots are based in part on the work of the Qwt project (http://qwt.sf.net).");
    const Judgement judgement = judge(input.analysis.summary, record.limits);
    content.verdict = judgement.verdict;
    content.verdictWord = verdictWordOf(judgement);
    content.verdictSentence = sentenceFor(input);
    content.facts = factsOf(record, input.signaturesStand);
    if (auto change = changeFact(input))
        content.facts.push_back(std::move(*change));
    content.readings = readingsTable(input);
    content.coefficients = coefficientsTable(input.analysis);
    content.fits = fitsTable(input.analysis);
    content.warnings = warningsOf(input.analysis);
    content.picture = pictureFor(input);
    content.method = methodWords(input.analysis);
    if (!input.audit.head.isEmpty())
        content.method.push_back(
            {Words::tr("Audit trail"), Words::tr("head %1 after %2 entries").arg(input.audit.head).arg(input.audit.entries)});
    content.signatures = signatureLines(input);
    content.job = jobTables(input);
    content.field = fieldPageOf(input);
    return content;
}

} // namespace lubberline::ui
