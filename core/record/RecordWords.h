#pragma once
/// The words for the choices of core/record, one table for each: those by which files name them (one vocabulary for CSV and exchange
/// JSON), and those that people read, which can be translated. What is stored and signed are never the latter.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/Message.h"
#include "core/record/Aircraft.h"
#include "core/record/DatumInstrument.h"
#include "core/record/SensorRecord.h"
#include "core/record/Site.h"
#include "core/record/Swing.h"
#include "core/record/SwingPlan.h"

namespace lubberline {

[[nodiscard]] std::string_view fileWord(SwingKind kind);          ///< check, correction, calibration, air
[[nodiscard]] std::string_view fileWord(SwingStage stage);        ///< as_found, as_left
[[nodiscard]] std::string_view fileWord(SwingState state);        ///< draft, complete, signed
[[nodiscard]] std::string_view fileWord(RadioState radio);        ///< not_stated, on, off
[[nodiscard]] std::string_view fileWord(CompassKind kind);        ///< direct_reading, remote_unstabilised, remote_stabilised
[[nodiscard]] std::string_view fileWord(Compensator compensator); ///< unknown, none, screws, magnets, electronic
[[nodiscard]] std::string_view fileWord(ModelOrigin origin);      ///< entered, loaded, estimated_from_swings, iron_bench
[[nodiscard]] std::string_view fileWord(SignatureRole role);      ///< performer, inspector, authority
[[nodiscard]] std::string_view fileWord(DatumKind kind); ///< rose_line, sighting_compass, theodolite, digital_compass, transfer_gyro, …
[[nodiscard]] std::string_view fileWord(SightingDirection direction); ///< direct, reciprocal
[[nodiscard]] std::string_view fileWord(SiteClass siteClass);         ///< none, class_1, class_2
[[nodiscard]] std::string_view fileWord(DueCause cause);              ///< other, parts_replaced, engine_change, …
[[nodiscard]] std::string_view fileWord(ProcedureKind kind);          ///< coefficient, half_error, index_first, flux_valve, check_only
[[nodiscard]] std::string_view fileWord(Control control);             ///< north_south, east_west, index

/// @return the choice that has this word. Capitals, and a space or hyphen for the underscore, are taken too ("as found").
template <class Choice>
[[nodiscard]] std::optional<Choice> choiceOf(std::string_view word);

/// What people read, in the order of the enumeration: "check swing", "correction swing", …
template <class Choice>
[[nodiscard]] std::span<const Pattern> shownWords();
template <class Choice>
[[nodiscard]] Pattern shownWord(Choice choice)
{
    return shownWords<Choice>()[static_cast<std::size_t>(choice)];
}

/// "check, correction, calibration or air": for messages.
template <class Choice>
[[nodiscard]] std::string allowedWords();

} // namespace lubberline
