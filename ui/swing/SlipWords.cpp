#include "ui/swing/SlipWords.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "core/angle/Circle.h"
#include "core/deviation/SlipWords.h"
#include "ui/kit/Words.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

namespace {

struct SlipWordsTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SlipWords)
};

QString figure(double heading_deg, AngleStyle style)
{
    return toText(formatHeading(heading_deg, style, heading_deg == std::round(heading_deg) ? 0 : 1));
}

/// Nobody types more readings by hand; logs of thousands are judged by their residuals.
constexpr std::size_t kMostJudged = 64;

QString percent(double probability)
{
    const long whole = std::lround(100 * probability);
    return SlipWordsTexts::tr("%1 %").arg(std::min(99L, whole));
}

QString candidateWords(const SlipCandidate& candidate, AngleStyle style)
{
    const QString meant = figure(candidate.meant_deg, style), chance = percent(candidate.probability);
    if (candidate.slip == Slip::WrongRow)
        return SlipWordsTexts::tr("Look again: most likely the wrong row, as it fits %1 (%2)").arg(meant, chance);
    const QString whose = candidate.figure == SlippedFigure::Datum
        ? SlipWordsTexts::tr("%1 in the magnetic heading").arg(toText(wordFor(candidate.slip)))
        : toText(wordFor(candidate.slip));
    return SlipWordsTexts::tr("Look again: most likely %1, %2 meant (%3)").arg(whose, meant, chance);
}

} // namespace

QString suspicionOf(const Analysis& analysis, std::size_t index, AngleStyle style)
{
    const auto& slips = analysis.slips.slips;
    const auto found = std::find_if(slips.begin(), slips.end(), [index](const auto& slip) { return slip.reading == index; });
    if (found == slips.end())
        return {};
    const AnalysedReading& reading = analysis.readings.at(index);
    const QString reads = SlipWordsTexts::tr("on %1 magnetic the compass reads %2.")
                              .arg(figure(reading.magnetic.degrees(), style), figure(reading.compass.degrees(), style));
    if (!found->orReadings.empty()) {
        QStringList places{figure(reading.magnetic.degrees(), style)};
        for (const auto other : found->orReadings)
            places += figure(analysis.readings.at(other).magnetic.degrees(), style);
        return SlipWordsTexts::tr(
            "one of the readings on %1 magnetic may be misread (%2); these readings cannot tell which: look at them again")
            .arg(places.join(SlipWordsTexts::tr(", ")), percent(found->probability));
    }
    const bool named = !found->candidates.empty() && found->candidates.front().slip != Slip::Unexplained;
    return reads + ' '
        + (named ? candidateWords(found->candidates.front(), style) : SlipWordsTexts::tr("Look again: no usual slip explains it"));
}

SlipJudgement judgeRow(const SwingEditor& editor, int row)
{
    const auto& readings = editor.readings();
    std::vector<Observation> others;
    std::vector<double> nominals;
    for (int i = 0; i < static_cast<int>(readings.size()); ++i) {
        if (i == row)
            continue;
        const Reading& other = readings[static_cast<std::size_t>(i)];
        if (other.used())
            others.push_back({*other.magnetic, *other.compass});
        if (other.nominal_deg)
            nominals.push_back(*other.nominal_deg);
    }
    SlipContext context;
    const auto& previous = editor.previousAnalysis();
    if (previous && previous->approximate.parameters == kCoefficientCount)
        context.expected = curveAfter(previous->approximate.smith());
    else if (editor.siblings())
        context.expected = *editor.siblings();
    context.earlier = others;
    context.resolution_deg = editor.record().compass.resolution_deg;
    const Reading& reading = readings[static_cast<std::size_t>(row)];
    context.nominal_deg = reading.nominal_deg;
    context.otherNominals_deg = nominals;
    return judgeReading({*reading.magnetic, *reading.compass}, context);
}

std::optional<int> likeliestSlip(const SwingEditor& editor)
{
    const auto& readings = editor.readings();
    std::optional<int> worst;
    double least = 1.0;
    if (readings.size() > kMostJudged)
        return worst;
    for (int row = 0; row < static_cast<int>(readings.size()); ++row) {
        if (!readings[static_cast<std::size_t>(row)].used())
            continue;
        const SlipJudgement judgement = judgeRow(editor, row);
        if (judgement.lookAgain() && judgement.probabilityAsRead < least) {
            least = judgement.probabilityAsRead;
            worst = row;
        }
    }
    return worst;
}

QString slipOfRow(const SwingEditor& editor, int row, AngleStyle style, SlipFigures figures)
{
    if (static_cast<std::size_t>(row) >= editor.readings().size())
        return {}; // a table that is losing its rows asks for their widths
    const Reading& reading = editor.readings()[static_cast<std::size_t>(row)];
    if (!reading.used() || editor.computing() || editor.readings().size() > kMostJudged)
        return {};
    const auto without = [&](const QString& sentence, const std::vector<SlipCandidate>& candidates, double unexplained) {
        if (figures == SlipFigures::Named || sentence.isEmpty())
            return sentence;
        const bool named
            = !candidates.empty() && candidates.front().slip != Slip::Unexplained && candidates.front().probability > unexplained;
        return named ? candidateWords(candidates.front(), style) : SlipWordsTexts::tr("Look again: no usual slip explains it");
    };
    const auto& analysis = editor.analysis();
    if (analysis && !analysis->slips.slips.empty()) { // the whole swing tells which it is
        const int index = editor.analysedIndex(row);
        for (const SlippedReading& slip : analysis->slips.slips)
            if (index >= 0 && slip.reading == static_cast<std::size_t>(index))
                return slip.orReadings.empty() ? without(suspicionOf(*analysis, slip.reading, style), slip.candidates, 0.0)
                                               : suspicionOf(*analysis, slip.reading, style);
        return {};
    }
    const SlipJudgement judgement = judgeRow(editor, row);
    return without(slipSentence(judgement, reading, style), judgement.candidates, judgement.probabilityUnexplained);
}

QString farFromNominal(const Reading& reading, AngleStyle style)
{
    if (!reading.magnetic || !reading.nominal_deg)
        return {};
    const double off_deg = std::abs(wrap180(reading.magnetic->degrees() - *reading.nominal_deg));
    if (off_deg <= kFarFromNominal_deg)
        return {};
    return SlipWordsTexts::tr("magnetic %1 is %2° off its nominal heading %3: is it this row's?")
        .arg(figure(reading.magnetic->degrees(), style), QString::number(std::lround(off_deg)), figure(*reading.nominal_deg, style));
}

QString slipSentence(const SlipJudgement& judgement, const Reading& reading, AngleStyle style)
{
    if (!judgement.lookAgain())
        return {};
    const QString reads
        = SlipWordsTexts::tr("on %1 magnetic the compass reads %2; %3 ± %4° is expected.")
              .arg(figure(reading.magnetic->degrees(), style), figure(reading.compass->degrees(), style),
                  toText(formatHeading(judgement.expected.degrees(), style, 0)), QString::number(judgement.expectedError_deg, 'f', 1));
    const bool named = !judgement.candidates.empty() && judgement.candidates.front().probability > judgement.probabilityUnexplained;
    return reads + ' '
        + (named ? candidateWords(judgement.candidates.front(), style) : SlipWordsTexts::tr("Look again: no usual slip explains it"));
}

} // namespace lubberline::ui
