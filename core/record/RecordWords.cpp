#include "core/record/RecordWords.h"

#include <algorithm>
#include <array>

namespace lubberline {

namespace {

/// In the order of the enumeration.
template <class Choice>
struct Words;
template <>
struct Words<SwingKind> {
    static constexpr std::array<std::string_view, 4> list{"check", "correction", "calibration", "air"};
};
template <>
struct Words<SwingStage> {
    static constexpr std::array<std::string_view, 2> list{"as_found", "as_left"};
};
template <>
struct Words<SwingState> {
    static constexpr std::array<std::string_view, 3> list{"draft", "complete", "signed"};
};
template <>
struct Words<RadioState> {
    static constexpr std::array<std::string_view, 3> list{"not_stated", "on", "off"};
};
template <>
struct Words<CompassKind> {
    static constexpr std::array<std::string_view, 3> list{"direct_reading", "remote_unstabilised", "remote_stabilised"};
};
template <>
struct Words<Compensator> {
    static constexpr std::array<std::string_view, 5> list{"unknown", "none", "screws", "magnets", "electronic"};
};
template <>
struct Words<ModelOrigin> {
    static constexpr std::array<std::string_view, 4> list{"entered", "loaded", "estimated_from_swings", "iron_bench"};
};
template <>
struct Words<SignatureRole> {
    static constexpr std::array<std::string_view, 3> list{"performer", "inspector", "authority"};
};
template <>
struct Words<DatumKind> {
    static constexpr std::array<std::string_view, 9> list{"rose_line", "sighting_compass", "theodolite", "digital_compass", "transfer_gyro",
        "astrocompass", "runway", "inertial", "electrical_calibrator"};
};
template <>
struct Words<SightingDirection> {
    static constexpr std::array<std::string_view, 2> list{"direct", "reciprocal"};
};
template <>
struct Words<SiteClass> {
    static constexpr std::array<std::string_view, 3> list{"none", "class_1", "class_2"};
};

template <class Choice>
std::string_view wordOf(Choice choice)
{
    return Words<Choice>::list.at(static_cast<std::size_t>(choice));
}

char plain(char c)
{
    if (c >= 'A' && c <= 'Z')
        return static_cast<char>(c - 'A' + 'a');
    return c == ' ' || c == '-' ? '_' : c;
}

} // namespace

std::string_view fileWord(SwingKind kind) { return wordOf(kind); }
std::string_view fileWord(SwingStage stage) { return wordOf(stage); }
std::string_view fileWord(SwingState state) { return wordOf(state); }
std::string_view fileWord(RadioState radio) { return wordOf(radio); }
std::string_view fileWord(CompassKind kind) { return wordOf(kind); }
std::string_view fileWord(Compensator compensator) { return wordOf(compensator); }
std::string_view fileWord(ModelOrigin origin) { return wordOf(origin); }
std::string_view fileWord(SignatureRole role) { return wordOf(role); }
std::string_view fileWord(DatumKind kind) { return wordOf(kind); }
std::string_view fileWord(SightingDirection direction) { return wordOf(direction); }
std::string_view fileWord(SiteClass siteClass) { return wordOf(siteClass); }

template <class Choice>
std::optional<Choice> choiceOf(std::string_view word)
{
    std::string wanted(word);
    std::transform(wanted.begin(), wanted.end(), wanted.begin(), plain);
    const auto& list = Words<Choice>::list;
    const auto found = std::find(list.begin(), list.end(), wanted);
    return found == list.end() ? std::nullopt : std::optional(static_cast<Choice>(found - list.begin()));
}

template <class Choice>
std::string allowedWords()
{
    std::string text;
    const auto& list = Words<Choice>::list;
    for (std::size_t i = 0; i < list.size(); ++i)
        text += std::string(i == 0 ? "" : i + 1 == list.size() ? " or " : ", ") + std::string(list[i]);
    return text;
}

template std::optional<SwingKind> choiceOf(std::string_view);
template std::optional<SwingStage> choiceOf(std::string_view);
template std::optional<SwingState> choiceOf(std::string_view);
template std::optional<RadioState> choiceOf(std::string_view);
template std::optional<CompassKind> choiceOf(std::string_view);
template std::optional<Compensator> choiceOf(std::string_view);
template std::optional<ModelOrigin> choiceOf(std::string_view);
template std::optional<SignatureRole> choiceOf(std::string_view);
template std::optional<DatumKind> choiceOf(std::string_view);
template std::optional<SightingDirection> choiceOf(std::string_view);
template std::optional<SiteClass> choiceOf(std::string_view);
template std::string allowedWords<SwingKind>();
template std::string allowedWords<SwingStage>();
template std::string allowedWords<SwingState>();
template std::string allowedWords<RadioState>();
template std::string allowedWords<CompassKind>();
template std::string allowedWords<Compensator>();
template std::string allowedWords<ModelOrigin>();
template std::string allowedWords<SignatureRole>();
template std::string allowedWords<DatumKind>();
template std::string allowedWords<SightingDirection>();
template std::string allowedWords<SiteClass>();

} // namespace lubberline
