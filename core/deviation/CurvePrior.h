#pragma once
/// How compasses of aircraft deviate, before any reading: what the search for slips holds readings against.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/deviation/SlipCheck.h"

namespace lubberline {

using Row5 = Eigen::Matrix<double, 5, 1>;

/// The two forms of Smith's formula, both linear in their coefficients. A large deviation is written otherwise by each; a reading that
/// either of them explains is no slip.
enum class Form { Exact, Approximate };

/// Of the coefficients of one form, without the index, which is taken out.
struct CurvePrior {
    Row5 mean, precision;
    double log = 0; ///< of its share, and of the determinant of its precision to the half
};

/// Heavy tails: four of five compasses deviate as those of light aircraft do, the fifth by much more (structure of steel, a compass that
/// nobody compensated), so that a large coefficient costs a curve little more than a slip costs a reading. With a history four of
/// five swings are as it lets expect.
[[nodiscard]] std::vector<CurvePrior> curvePriors(Form form, const std::optional<ExpectedCurve>& history);

} // namespace lubberline
