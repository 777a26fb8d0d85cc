#pragma once
/// The JSON of `check` and `compare` (the contract of the command line): every key carries its unit.

#include <span>
#include <string>

#include "core/check/CheckHeadings.h"
#include "core/check/TwoCompasses.h"

namespace lubberline {

/// What to read, of a compass with so many swings on record. No newline at the end.
[[nodiscard]] std::string toJson(const CompassBelief& belief, std::size_t swings, const ChosenHeadings& chosen, const CheckOptions& options,
    const std::vector<Message>& warnings);
/// The same with what was read and the verdict.
[[nodiscard]] std::string toJson(const CompassBelief& belief, std::size_t swings, const ChosenHeadings& chosen, const CheckOptions& options,
    std::span<const Observation> readings, const CheckVerdict& verdict);
[[nodiscard]] std::string toJson(const PairVerdict& verdict);

} // namespace lubberline
