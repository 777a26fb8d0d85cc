#include "core/record/RecordWords.h"

#include <algorithm>
#include <array>

namespace lubberline {

namespace {

/// In the order of the enumeration: of files, and for people.
template <class Choice>
struct Words;
template <>
struct Words<SwingKind> {
    static constexpr std::array<std::string_view, 5> list{"check", "correction", "calibration", "air", "not_stated"};
    static constexpr std::array shown{MARKED("core", "check swing"), MARKED("core", "correction swing"),
        MARKED("core", "calibration swing"), MARKED("core", "air swing"), MARKED("core", "not stated")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<SwingStage> {
    static constexpr std::array<std::string_view, 3> list{"as_found", "as_left", "not_stated"};
    static constexpr std::array shown{MARKED("core", "as found"), MARKED("core", "as left"), MARKED("core", "not stated")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<SwingState> {
    static constexpr std::array<std::string_view, 3> list{"draft", "complete", "signed"};
    static constexpr std::array shown{MARKED("core", "draft"), MARKED("core", "complete"), MARKED("core", "signed")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<RadioState> {
    static constexpr std::array<std::string_view, 3> list{"not_stated", "on", "off"};
    static constexpr std::array shown{MARKED("core", "not stated"), MARKED("core", "on"), MARKED("core", "off")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<CompassKind> {
    static constexpr std::array<std::string_view, 4> list{"direct_reading", "remote_unstabilised", "remote_stabilised", "not_stated"};
    static constexpr std::array shown{MARKED("core", "direct reading"), MARKED("core", "remote, not stabilised"),
        MARKED("core", "remote, gyro-stabilised"), MARKED("core", "not stated")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<Compensator> {
    static constexpr std::array<std::string_view, 5> list{"unknown", "none", "screws", "magnets", "electronic"};
    static constexpr std::array shown{MARKED("core", "not known"), MARKED("core", "none"), MARKED("core", "screws"),
        MARKED("core", "magnets"), MARKED("core", "electronic")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<ModelOrigin> {
    static constexpr std::array<std::string_view, 4> list{"entered", "loaded", "estimated_from_swings", "iron_bench"};
    static constexpr std::array shown{MARKED("core", "entered by hand"), MARKED("core", "loaded from a file"),
        MARKED("core", "estimated from swings"), MARKED("core", "computed on the iron bench")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<SignatureRole> {
    static constexpr std::array<std::string_view, 3> list{"performer", "inspector", "authority"};
    static constexpr std::array shown{
        MARKED("core", "swung and adjusted by"), MARKED("core", "inspected by"), MARKED("core", "released by")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<DatumKind> {
    static constexpr std::array<std::string_view, 10> list{"rose_line", "sighting_compass", "theodolite", "digital_compass",
        "transfer_gyro", "astrocompass", "runway", "inertial", "electrical_calibrator", "shadow_pin"};
    static constexpr std::array shown{MARKED("core", "painted rose line"), MARKED("core", "sighting compass"), MARKED("core", "theodolite"),
        MARKED("core", "digital compass on the aircraft"), MARKED("core", "transfer gyro"), MARKED("core", "astrocompass"),
        MARKED("core", "runway direction"), MARKED("core", "INS or GPS"), MARKED("core", "electrical calibrator"),
        MARKED("core", "shadow pin (the sun)")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<SightingDirection> {
    static constexpr std::array<std::string_view, 2> list{"direct", "reciprocal"};
    static constexpr std::array shown{MARKED("core", "the aircraft's heading"), MARKED("core", "its reciprocal")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<SiteClass> {
    static constexpr std::array<std::string_view, 3> list{"none", "class_1", "class_2"};
    static constexpr std::array shown{MARKED("core", "no class"), MARKED("core", "class 1"), MARKED("core", "class 2")};
    static_assert(shown.size() == list.size());
};

template <>
struct Words<DueCause> {
    static constexpr std::array<std::string_view, kDueCauses> list{"other", "parts_replaced", "engine_change", "modification",
        "electrical_change", "lightning", "electrical_storm", "hard_landing", "magnetic_cargo", "moved", "parked_over_a_year",
        "accuracy_suspected"};
    static constexpr std::array shown{MARKED("core", "something else"), MARKED("core", "ferrous parts or compass replaced"),
        MARKED("core", "engine change"), MARKED("core", "cockpit or avionics modified"), MARKED("core", "electrical system changed"),
        MARKED("core", "lightning strike"), MARKED("core", "severe electrical storm"), MARKED("core", "hard landing or shock"),
        MARKED("core", "magnetic cargo"), MARKED("core", "moved to a very different field"),
        MARKED("core", "parked on one heading over a year"), MARKED("core", "accuracy suspected")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<ProcedureKind> {
    static constexpr std::array<std::string_view, 5> list{"coefficient", "half_error", "index_first", "flux_valve", "check_only"};
    static constexpr std::array shown{MARKED("core", "Coefficient method"), MARKED("core", "Half-error method"),
        MARKED("core", "Index first"), MARKED("core", "Flux valve"), MARKED("core", "Check only")};
    static_assert(shown.size() == list.size());
};
template <>
struct Words<Control> {
    static constexpr std::array<std::string_view, 3> list{"north_south", "east_west", "index"};
    static constexpr std::array shown{MARKED("core", "N–S screw"), MARKED("core", "E–W screw"), MARKED("core", "compass in its mount")};
    static_assert(shown.size() == list.size());
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
std::string_view fileWord(DueCause cause) { return wordOf(cause); }
std::string_view fileWord(ProcedureKind kind) { return wordOf(kind); }
std::string_view fileWord(Control control) { return wordOf(control); }

template <class Choice>
std::span<const Pattern> shownWords()
{
    return Words<Choice>::shown;
}

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
template std::optional<DueCause> choiceOf(std::string_view);
template std::optional<ProcedureKind> choiceOf(std::string_view);
template std::optional<Control> choiceOf(std::string_view);
template std::span<const Pattern> shownWords<SwingKind>();
template std::span<const Pattern> shownWords<SwingStage>();
template std::span<const Pattern> shownWords<SwingState>();
template std::span<const Pattern> shownWords<RadioState>();
template std::span<const Pattern> shownWords<CompassKind>();
template std::span<const Pattern> shownWords<Compensator>();
template std::span<const Pattern> shownWords<ModelOrigin>();
template std::span<const Pattern> shownWords<SignatureRole>();
template std::span<const Pattern> shownWords<DatumKind>();
template std::span<const Pattern> shownWords<SightingDirection>();
template std::span<const Pattern> shownWords<SiteClass>();
template std::span<const Pattern> shownWords<DueCause>();
template std::span<const Pattern> shownWords<ProcedureKind>();
template std::span<const Pattern> shownWords<Control>();
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
template std::string allowedWords<DueCause>();
template std::string allowedWords<ProcedureKind>();
template std::string allowedWords<Control>();

} // namespace lubberline
