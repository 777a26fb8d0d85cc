#include "core/deviation/ToldCoefficients.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/algebra/LeastSquares.h"
#include "core/algebra/Spectra.h"

namespace lubberline {

namespace {

/// D (3) or E (4) when the worst told direction is its own; −1 otherwise. Two fifths of it may leak into the others: compasses that deviate by 8°
/// read so far off the cardinals.
int ownDirection(const Eigen::MatrixXd& design)
{
    constexpr double kOwn = 0.92; // cosine of the angle between the direction and the coefficient's axis
    const Eigen::VectorXd worst = singularParts(design.rows() > 5 ? upperFactor(design) : design).V.col(4);
    for (const int column : {3, 4})
        if (std::abs(worst(column)) >= kOwn)
            return column;
    return -1;
}

} // namespace

ToldCoefficients toldBy(const Eigen::MatrixXd& design, int distinctHeadings)
{
    const auto n = design.rows();
    ToldCoefficients told;
    const Eigen::VectorXd sigma = singularValues(n >= 5 ? design : Eigen::MatrixXd(design.transpose()));
    const double tolerance = sigma(0) * std::numeric_limits<double>::epsilon() * static_cast<double>(std::max<Eigen::Index>(n, 5));
    told.rank = static_cast<int>((sigma.array() > tolerance).count());
    const double five = n >= 5 ? conditionNumber(sigma) : std::numeric_limits<double>::infinity();
    const auto accept = [&](std::vector<int> columns, double condition) {
        told.columns = std::move(columns);
        told.conditionNumber = condition;
        return told;
    };
    if (distinctHeadings >= 5 && five <= kConditionLimit)
        return accept({0, 1, 2, 3, 4}, five);
    if (distinctHeadings >= 4 && n >= 4) {
        if (const int without = ownDirection(design); without >= 0) {
            const std::vector<int> four = without == 3 ? std::vector{0, 1, 2, 4} : std::vector{0, 1, 2, 3};
            const double condition = conditionNumber(singularValues(design(Eigen::all, four)));
            if (condition <= kConditionLimit)
                return accept(four, condition);
        }
    }
    const double three = conditionNumber(singularValues(design.leftCols(3)));
    if (three <= kConditionLimit)
        return accept({0, 1, 2}, three);
    told.conditionNumber = std::min(five, std::numeric_limits<double>::max()); // what is reported must be a number
    return told;
}

} // namespace lubberline
