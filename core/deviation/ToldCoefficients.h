#pragma once
/// Which of the five coefficients a set of headings can tell, from the design matrix (columns 1, sin, cos, sin 2, cos 2 or their like).

#include <vector>

#include <Eigen/Core>

namespace lubberline {

/// A design matrix is accepted up to this condition number: a reading error may then be blown up some five to ten times in a
/// coefficient. Half a circle of readings (15) is just accepted for all five, a quarter (16) for A, B and C.
inline constexpr double kConditionLimit = 20.0;

struct ToldCoefficients {
    std::vector<int> columns;   ///< of A…E, 0…4: all; all but D or E; A, B, C; none
    int rank = 0;               ///< numerical rank of the five columns
    double conditionNumber = 0; ///< of the columns named (of all five where none is); a number even where the rank is short
};

/// Where one direction alone cannot be told and it is D's or E's own (readings on the four cardinals: sin 2ψ' vanishes there; on the
/// four intercardinals: cos 2ψ'), only that one is left out: it leaves the others as they are.
[[nodiscard]] ToldCoefficients toldBy(const Eigen::MatrixXd& design, int distinctHeadings);

} // namespace lubberline
