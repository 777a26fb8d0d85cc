#pragma once
/// The words that files use for the choices of core/record, one list for all formats.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/record/Aircraft.h"
#include "core/record/Swing.h"

namespace lubberline {

/// The words of an enumeration, in the order of its values.
template <class Enum>
struct Words;

template <>
struct Words<SwingKind> { static constexpr std::array<std::string_view, 4> list{"check", "correction", "calibration", "air"}; };
template <>
struct Words<SwingStage> { static constexpr std::array<std::string_view, 2> list{"as found", "as left"}; };
template <>
struct Words<SwingState> { static constexpr std::array<std::string_view, 3> list{"draft", "complete", "signed"}; };
template <>
struct Words<RadioState> { static constexpr std::array<std::string_view, 3> list{"not stated", "on", "off"}; };
template <>
struct Words<CompassKind> { static constexpr std::array<std::string_view, 3> list{"direct reading", "remote unstabilised", "remote stabilised"}; };
template <>
struct Words<Compensator> { static constexpr std::array<std::string_view, 5> list{"unknown", "none", "screws", "magnets", "electronic"}; };

template <class Enum>
[[nodiscard]] std::string wordFor(Enum value)
{
    return std::string(Words<Enum>::list[static_cast<std::size_t>(value)]);
}

template <class Enum>
[[nodiscard]] std::optional<Enum> fromWord(std::string_view word)
{
    const auto& list = Words<Enum>::list;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i] == word)
            return static_cast<Enum>(i);
    return std::nullopt;
}

/// "check, correction, calibration or air": for messages.
template <class Enum>
[[nodiscard]] std::string allWords()
{
    std::string text;
    const auto& list = Words<Enum>::list;
    for (std::size_t i = 0; i < list.size(); ++i)
        text += (i == 0 ? "" : i + 1 == list.size() ? " or " : ", ") + std::string(list[i]);
    return text;
}

/// A date of the calendar as 2026-11-20, or empty (not stated).
[[nodiscard]] bool isDateOrEmpty(const std::string& text);

} // namespace lubberline
