#include "app/CardSource.h"

#include "app/SwingSource.h"

namespace lubberline::app {

namespace {

QString columnHeading(const Swing& swing, bool several)
{
    switch (swing.configuration.radio) {
    case RadioState::On: return "RADIO ON";
    case RadioState::Off: return "RADIO OFF";
    case RadioState::NotStated: break;
    }
    return several ? "STEER " + QString::fromStdString(swing.date.text()) : QString("STEER");
}

} // namespace

Result<CardSheet> cardFromFiles(const std::vector<std::string>& files, const CardOptions& options)
{
    CardSheet sheet;
    for (const auto& file : files) {
        auto swing = swingFromCsv(file);
        if (!swing)
            return swing.error();
        const auto analysis = analyseSwing(*swing);
        if (!analysis)
            return analysis.error();
        auto card = makeCard(*analysis, options);
        if (!card) {
            Error error = card.error();
            error.file = swing->source;
            return error;
        }
        const SwingRecord& record = swing->record;
        if (sheet.input.columns.empty()) {
            sheet.input.record = record;
            sheet.input.options = options;
        }
        const SwingRecord& first = sheet.input.record;
        if (record.aircraft.registration != first.aircraft.registration || record.compass.name != first.compass.name)
            return Error{ErrorCode::Conflict,
                {MARKED("app", "this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)"), record.aircraft.registration,
                    record.compass.name, files.front(), first.aircraft.registration, first.compass.name},
                file};
        sheet.input.columns.push_back({columnHeading(record.swing, files.size() > 1), std::move(*card)});
        sheet.warnings.insert(sheet.warnings.end(), swing->warnings.begin(), swing->warnings.end());
        sheet.warnings.insert(sheet.warnings.end(), analysis->warnings.begin(), analysis->warnings.end());
    }
    return sheet;
}

} // namespace lubberline::app
