#include "app/CardSource.h"

#include <filesystem>

#include "app/SwingSource.h"
#include "core/record/RecordWords.h"

namespace lubberline::app {

namespace {

QString columnHeading(const Swing& swing, bool several)
{
    switch (swing.configuration.radio) {
    case RadioState::On: return "RADIO ON";
    case RadioState::Off: return "RADIO OFF";
    case RadioState::NotStated: break;
    }
    return several ? QString::fromStdString(swing.date.empty() ? std::string("DATE NOT STATED") : swing.date.text()) : QString("STEER");
}

std::string statedName(const std::string& text) { return text.empty() ? "not stated" : text; }

/// Why the second swing may not stand beside the first; empty: it may.
Message whyNotTogether(const SwingRecord& first, const SwingRecord& second, const std::string& firstFile)
{
    const auto differ = [](const std::string& a, const std::string& b) { return a != b; };
    if (differ(first.aircraft.registration, second.aircraft.registration) || differ(first.compass.name, second.compass.name)
        || differ(first.type.name, second.type.name))
        return {MARKED("app", "this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)"),
            statedName(second.aircraft.registration), statedName(second.compass.name), firstFile, statedName(first.aircraft.registration),
            statedName(first.compass.name)};
    if (first.swing.record == second.swing.record)
        return {MARKED("app", "this is the swing of %1 once more; expected another swing of the same compass"), firstFile};
    if (first.swing.stage != second.swing.stage)
        return {MARKED("app", "this swing is %1, that of %2 %3; expected two swings with the same adjustment"),
            std::string(fileWord(second.swing.stage)), firstFile, std::string(fileWord(first.swing.stage))};
    if (columnHeading(first.swing, true) == columnHeading(second.swing, true))
        return {
            MARKED("app", "the two columns could not be told apart (both %1); expected one swing with the radio on and one with it off"),
            columnHeading(first.swing, true).toStdString()};
    return {};
}

Result<void> checkNotTwice(const std::vector<std::string>& files)
{
    std::error_code none;
    if (files.size() > 1 && std::filesystem::equivalent(files[0], files[1], none))
        return Error{ErrorCode::Conflict,
            {MARKED("app", "this file is %1 once more; expected another swing of the same compass"), files[0]}, files[1]};
    return {};
}

} // namespace

Result<CardSheet> cardFromFiles(const std::vector<std::string>& files, const CardOptions& options)
{
    if (const auto twice = checkNotTwice(files); !twice)
        return twice.error();
    CardSheet sheet;
    for (const auto& file : files) {
        auto swing = swingFromCsv(file);
        if (!swing)
            return swing.error();
        const SwingRecord& record = swing->record;
        if (!sheet.input.columns.empty())
            if (const auto why = whyNotTogether(sheet.input.record(), record, files.front()); !why.empty())
                return Error{ErrorCode::Conflict, why, file};
        const auto analysis = analyseSwing(*swing);
        if (!analysis)
            return analysis.error();
        auto card = makeCard(*analysis, options);
        if (!card) {
            Error error = card.error();
            error.file = swing->source;
            return error;
        }
        sheet.input.columns.push_back({columnHeading(record.swing, files.size() > 1), std::move(*card), record, false, false});
        sheet.analyses.push_back(*analysis);
        sheet.warnings.insert(sheet.warnings.end(), swing->warnings.begin(), swing->warnings.end());
        sheet.warnings.insert(sheet.warnings.end(), analysis->warnings.begin(), analysis->warnings.end());
    }
    if (files.size() > 1 && sheet.input.record().aircraft.registration.empty())
        sheet.warnings.push_back(MARKED("app", "neither file names its aircraft: whether both swings are of one compass is not known"));
    return sheet;
}

} // namespace lubberline::app
