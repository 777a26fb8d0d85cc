#pragma once
/// What a guided swing was planned to be; its stations: core/procedure/Plan.h.

#include <string>
#include <vector>

namespace lubberline {

enum class ProcedureKind { Coefficient, HalfError, IndexFirst, FluxValve, CheckOnly };

/// Which control is turned.
enum class Control {
    NorthSouth, ///< the N–S screw or magnets: removes C
    EastWest,   ///< the E–W screw or magnets: removes B
    Index,      ///< the compass or detector in its mount: removes A
};

/// How much of what is read is taken out.
enum class HowMuch { CoefficientPart, All, Half };

struct Turn {
    Control control = Control::NorthSouth;
    HowMuch removal = HowMuch::CoefficientPart;
    friend bool operator==(const Turn&, const Turn&) = default;
};

struct PlanOptions {
    ProcedureKind kind = ProcedureKind::Coefficient;
    int checkPoints = 8;                     ///< 8, 12 or 24
    std::vector<std::string> configurations; ///< further ones to be read, in words: "radio on"
    friend bool operator==(const PlanOptions&, const PlanOptions&) = default;
};

} // namespace lubberline
