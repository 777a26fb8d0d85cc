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
