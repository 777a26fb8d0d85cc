#pragma once
/// Years of swings of a selection as columns: what the fleet's statistics read. No records, no database: a swing is a row, its
/// readings are a range of two columns. Angles in degrees, as they were read; days count from 1970-01-01.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/record/Aircraft.h"
#include "core/record/Swing.h"

namespace lubberline {

struct FleetEvent {
    int day = 0;
    std::string text; ///< in the crew's words
    friend auto operator<=>(const FleetEvent&, const FleetEvent&) = default;
};

/// A compass system on its aircraft.
struct FleetCompass {
    std::string type, aircraft, compass; ///< names; together they are one of a kind
    CompassId id = {};                   ///< where a click goes; no result depends on it
    CompassKind kind = CompassKind::DirectReading;
    std::optional<double> limit_deg; ///< the largest |deviation| allowed; none: not known
    double readingError_deg = 0;     ///< standard uncertainty of one deviation read (core/swing/ReadingError.h)
    std::optional<int> due_day;      ///< when it is to be swung next; none: no rule says
    std::vector<FleetEvent> events;  ///< of the aircraft, by day
};

struct FleetSwing {
    std::int32_t compass = 0;          ///< of FleetSwings::compasses
    std::int32_t site = -1, crew = -1; ///< of FleetSwings::sites and crews; -1: not stated
    std::int32_t day = 0;
    SwingStage stage = SwingStage::AsFound;
    RadioState radio = RadioState::NotStated;
    SwingId id = {}; ///< where a click goes; no result depends on it
    std::uint32_t first = 0, count = 0;
};

struct SwingsLeftOut {
    std::string reason; ///< "draft", "superseded", …: a code
    std::int64_t swings = 0;
    friend bool operator==(const SwingsLeftOut&, const SwingsLeftOut&) = default;
};

struct FleetSwings {
    std::vector<FleetCompass> compasses;
    std::vector<std::string> sites, crews;
    std::vector<FleetSwing> swings;
    std::vector<double> magnetic_deg, compass_deg; ///< of the readings that are used
    std::vector<SwingsLeftOut> leftOut;            ///< what the selection did not take, counted

    [[nodiscard]] std::span<const double> magneticOf(const FleetSwing& swing) const
    {
        return {magnetic_deg.data() + swing.first, swing.count};
    }
    [[nodiscard]] std::span<const double> compassOf(const FleetSwing& swing) const
    {
        return {compass_deg.data() + swing.first, swing.count};
    }
};

/// Brings rows into the order of their contents: compasses by name, swings by compass, day, stage, radio and what was read,
/// readings by heading. The same records give the same columns, so the same sums to the last digit, in whatever order and with
/// whatever ids they were stored.
void putInOrder(FleetSwings& fleet);

/// Days since 1970-01-01 of an ISO 8601 date; none when it is no date.
[[nodiscard]] std::optional<int> dayOfDate(std::string_view date);
[[nodiscard]] std::string dateOfDay(int day);

inline constexpr double kDaysPerYear = 365.25;

} // namespace lubberline
