#include "core/check/History.h"

#include <algorithm>

#include "core/angle/Angle.h"
#include "core/earth/FieldModel.h"
#include "core/swing/SwingResult.h"

namespace lubberline {

std::optional<PastSwing> pastSwing(const SwingRecord& record)
{
    if (record.swing.date.empty())
        return {};
    const auto result = resultOf(record);
    if (!result || !result->approximate.fitted())
        return {};
    PastSwing past;
    past.year = yearOf(record.swing.date);
    past.afterCorrection = record.swing.stage == SwingStage::AsLeft || record.swing.kind == SwingKind::Correction;
    for (const Coefficient c : kCoefficients) {
        const std::size_t i = indexOf(c);
        if (const auto value = result->approximate.of(c))
            past.value_deg[i] = toDegrees(*value);
        past.standardError_deg[i] = toDegrees(result->approximate.standardError[i].value_or(0));
    }
    return past;
}

bool isSameSwing(const SwingRecord& one, const SwingRecord& other)
{
    const auto sameReading = [](const Reading& a, const Reading& b) { return a.magnetic == b.magnetic && a.compass == b.compass; };
    const auto &first = one.swing, &second = other.swing;
    return !first.readings.empty() && first.date == second.date && first.configuration == second.configuration
        && std::equal(first.readings.begin(), first.readings.end(), second.readings.begin(), second.readings.end(), sameReading);
}

bool isOfAnotherCompass(const SwingRecord& one, const SwingRecord& other)
{
    const auto differ = [](const std::string& a, const std::string& b) { return !a.empty() && !b.empty() && a != b; };
    return differ(one.aircraft.registration, other.aircraft.registration) || differ(one.compass.name, other.compass.name);
}

namespace {

std::string statedName(const std::string& text) { return text.empty() ? "not stated" : text; }

} // namespace

Result<void> checkHistory(std::span<const SourcedRecord> history)
{
    for (auto further = history.begin(); further != history.end(); ++further)
        for (auto before = history.begin(); before != further; ++before) {
            if (isSameSwing(before->record, further->record))
                return Error{ErrorCode::Conflict,
                    {MARKED("core", "this is the swing of %1 once more; expected each swing once"), before->source}, further->source};
            if (isOfAnotherCompass(before->record, further->record))
                return Error{ErrorCode::Conflict,
                    {MARKED("core", "this swing is of %1, %2; expected the aircraft and compass of %3 (%4, %5)"),
                        statedName(further->record.aircraft.registration), statedName(further->record.compass.name), before->source,
                        statedName(before->record.aircraft.registration), statedName(before->record.compass.name)},
                    further->source};
        }
    return {};
}

Result<void> checkTwoCompasses(std::span<const SourcedRecord> first, std::span<const SourcedRecord> second)
{
    for (const SourcedRecord& other : second)
        for (const SourcedRecord& one : first) {
            if (isSameSwing(one.record, other.record))
                return Error{ErrorCode::Conflict,
                    {MARKED("core", "this is the swing of %1 once more, which is the first compass's; expected one of the second"),
                        one.source},
                    other.source};
            const auto &aircraft = one.record.aircraft.registration, &others = other.record.aircraft.registration;
            if (!aircraft.empty() && !others.empty() && aircraft != others)
                return Error{ErrorCode::Conflict,
                    {MARKED("core", "this swing is of %1, that of %2 of %3; expected two compasses of one aircraft"), others, one.source,
                        aircraft},
                    other.source};
            if (!aircraft.empty() && aircraft == others && !one.record.compass.name.empty()
                && one.record.compass.name == other.record.compass.name)
                return Error{ErrorCode::Conflict,
                    {MARKED("core", "this swing is of %1, %2, as that of %3 is; expected another compass of the aircraft"), aircraft,
                        one.record.compass.name, one.source},
                    other.source};
        }
    return {};
}

std::vector<Message> doubtsOfHistory(std::span<const SourcedRecord> history)
{
    const auto states
        = [](const SourcedRecord& one) { return !one.record.aircraft.registration.empty() && !one.record.compass.name.empty(); };
    std::vector<Message> doubts;
    if (std::none_of(history.begin(), history.end(), states))
        return doubts;
    for (const SourcedRecord& one : history)
        if (!states(one))
            doubts.push_back(
                {MARKED("core", "%1 does not say of which aircraft and compass it is: whether it is of the same one is not known"),
                    one.source});
    return doubts;
}

std::vector<PastSwing> historyOf(std::span<const SwingRecord> records)
{
    std::vector<PastSwing> history;
    for (const SwingRecord& record : records)
        if (auto past = pastSwing(record))
            history.push_back(*past);
    std::stable_sort(history.begin(), history.end(), [](const PastSwing& a, const PastSwing& b) { return a.year < b.year; });
    return history;
}

} // namespace lubberline
