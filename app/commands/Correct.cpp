#include <cmath>
#include <utility>

#include "app/Console.h"
#include "app/SwingSource.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/format/results/AnalysisJson.h"
#include "core/swing/Observations.h"

namespace lubberline::app {

namespace {

struct CorrectArguments {
    std::string file;
    bool json = false;
};

/// What must be known before a screw is turned: all that `analyse` would say of the readings, and a term that no corrector takes.
std::vector<Message> doubtsOf(const Analysis& analysis, const Correction& correction)
{
    std::vector<Message> doubts = analysis.warnings;
    for (const auto& slip : analysis.slips.slips)
        doubts.push_back({MARKED("app", "the reading on %1° looks misread: read it again before a screw is turned"),
            figureText(printedHeading_deg(analysis.readings[slip.reading].magnetic.degrees(), 0), 0)});
    // A slip on one of N, E, S and W alone makes a quarter of itself E, and soft iron makes no such E.
    constexpr double kMostE_deg = 3.5;
    const double E_deg = analysis.pointRules ? toDegrees(analysis.pointRules->E_rad) : 0.0;
    if (std::abs(E_deg) > kMostE_deg)
        doubts.push_back(
            {MARKED("app",
                 "E is %1°, more than soft iron makes: one of the readings is likely misread, by some %2°; read them again before a screw is turned"),
                signedFigureText(E_deg, 1), figureText(4.0 * std::abs(E_deg), 0)});
    constexpr double kMostOfACorrector_deg = 25.0;
    for (const auto& [letter, term_rad] : {std::pair('B', correction.B_rad), std::pair('C', correction.C_rad)})
        if (const double term_deg = toDegrees(term_rad); std::abs(term_deg) > kMostOfACorrector_deg)
            doubts.push_back(
                {MARKED("app",
                     "%1 is %2°, more than a corrector takes (some %3°): look for what is magnetised, or misread, before a screw is turned"),
                    letter, signedFigureText(term_deg, 1), figureText(kMostOfACorrector_deg, 0)});
    return doubts;
}

int correctCommand(const CorrectArguments& options)
{
    const auto swing = swingFromCsv(options.file);
    if (!swing)
        return fail(swing.error());
    const auto analysis = analyseSwing(*swing);
    if (!analysis) // of a compass that is stuck, backwards or does not follow no figure is right
        return fail(analysis.error());
    const auto correction = correctionSteps(observationsOf(swing->record.swing));
    if (!correction) {
        Error error = correction.error();
        error.file = swing->source;
        return fail(error);
    }
    std::vector<Message> warnings = swing->warnings;
    const auto doubts = doubtsOf(*analysis, *correction);
    warnings.insert(warnings.end(), doubts.begin(), doubts.end());
    warn(warnings);
    if (options.json)
        put("%s\n", toJson(*correction, warnings).c_str());
    else
        putText(tableOf(*correction));
    return kDone;
}

} // namespace

void addCorrect(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CorrectArguments>();
    auto* command = app.add_subcommand("correct", "what to make the compass read on the cardinals (correction swing)");
    addInputOption(*command, invocation, "SWING.csv", options->file, "a Swing CSV with N, E, S and W among its readings")->required();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &invocation] { invocation.action = [options] { return correctCommand(*options); }; });
}

} // namespace lubberline::app
