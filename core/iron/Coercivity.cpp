#include "core/iron/Coercivity.h"

#include <Eigen/SVD>

#include "core/base/Number.h"
#include "core/iron/BenchModel.h"

namespace lubberline {

IronClass ironClassOf(double coercivity_A_per_m)
{
    return coercivity_A_per_m < kSoftBelow_A_per_m ? IronClass::Soft
        : coercivity_A_per_m > kHardAbove_A_per_m  ? IronClass::Hard
                                                   : IronClass::Between;
}

Pattern nameOf(IronClass iron)
{
    switch (iron) {
    case IronClass::Soft: return MARKED("core", "soft");
    case IronClass::Between: return MARKED("core", "between");
    case IronClass::Hard: break;
    }
    return MARKED("core", "hard");
}

std::optional<double> mayDrift_nT(const PartEffect& effect)
{
    if (!effect.coercivity_A_per_m)
        return {};
    switch (ironClassOf(*effect.coercivity_A_per_m)) {
    case IronClass::Soft: return effect.hardIron_nT.norm();
    case IronClass::Between: {
        const double largest = Eigen::JacobiSVD<Eigen::Matrix3d>(effect.softIron).singularValues()[0];
        return effect.hardIron_nT.norm() + largest * kShockField_nT;
    }
    case IronClass::Hard: break;
    }
    return 0.0;
}

Message driftWarning(const PartEffect& effect)
{
    const auto drift_nT = mayDrift_nT(effect);
    if (!drift_nT || *drift_nT < 1)
        return {};
    const std::string coercivity = figureText(*effect.coercivity_A_per_m, 0);
    if (ironClassOf(*effect.coercivity_A_per_m) == IronClass::Soft)
        return {MARKED("core",
                    "part “%1” is soft (%2 A/m): it keeps no magnetism for long, and up to %3 nT of its hard iron may go with a shock"),
            effect.part, coercivity, figureText(*drift_nT, 0)};
    return {
        MARKED("core",
            "part “%1” is between soft and hard (%2 A/m): after a shock, under stress or after a strong current up to %3 nT may change; "
            "swing again then"),
        effect.part, coercivity, figureText(*drift_nT, 0)};
}

} // namespace lubberline
