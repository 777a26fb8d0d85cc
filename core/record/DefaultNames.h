#pragma once
/// What records are called until somebody names them. Names are stored, printed and exchanged: they are not of the language of the window
/// in which a record happened to be made.

#include <algorithm>
#include <string>
#include <string_view>

namespace lubberline {

inline constexpr std::string_view kNewBase = "New base", kNewInstrument = "New instrument", kNewModel = "model", kBenchModel = "iron bench",
                                  kNewCircuit = "circuit", kNewPart = "part";

/// The name, or with the first number from 2 on that no record has. @param nameOf of a record.
template <class Records, class NameOf>
[[nodiscard]] std::string freeName(std::string_view name, const Records& records, NameOf nameOf)
{
    std::string free(name);
    for (int number = 2; std::any_of(records.begin(), records.end(), [&](const auto& one) { return nameOf(one) == free; }); ++number)
        free = std::string(name) + ' ' + std::to_string(number);
    return free;
}

} // namespace lubberline
