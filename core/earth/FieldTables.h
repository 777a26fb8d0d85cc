#pragma once
/// Gauss coefficients as tables, before GeographicLib evaluates them: of the built-in models and of files that a user loads.

#include <string>
#include <vector>

#include "core/base/Result.h"

namespace lubberline {

/// GeographicLib's largest magnetic model has 740.
inline constexpr int kMostDegree = 800;

/// Schmidt semi-normalised, [nT] or [nT a year].
struct Gauss {
    double g = 0, h = 0;
};

/// The coefficients of one epoch: degrees 1 … degree, orders 0 … n, at gaussIndex().
using GaussSet = std::vector<Gauss>;
[[nodiscard]] constexpr std::size_t gaussIndex(int n, int m) { return static_cast<std::size_t>(n * (n + 1) / 2 - 1 + m); }
[[nodiscard]] constexpr std::size_t gaussCount(int degree) { return gaussIndex(degree + 1, 0); }

/// Linear in time between the epochs; after the last one by `change`.
struct FieldTable {
    std::string name;
    double firstEpoch = 0, epochStep = 5.0;
    double lastYear = 0; ///< five years after the last epoch
    int degree = 0;
    std::vector<GaussSet> main; ///< one for each epoch
    GaussSet change;            ///< a year
};

[[nodiscard]] FieldTable emptyTable(const std::string& name, double firstEpoch, int epochs, int degree);
inline void setGauss(GaussSet& set, int n, int m, Gauss value) { set[gaussIndex(n, m)] = value; }

[[nodiscard]] FieldTable wmm2025Table();
[[nodiscard]] FieldTable igrf14Table();

/// Reads a WMM or WMMHR `.COF`, or an IGRF table, told apart by content. Errors: as those of readFieldModel().
Result<FieldTable> readFieldTable(const std::string& path);

} // namespace lubberline
