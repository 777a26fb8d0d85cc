#include "core/algebra/Exponential.h"

#include <unsupported/Eigen/MatrixFunctions>

namespace lubberline {

Eigen::MatrixXd exponential(const MatrixView& matrix) { return Eigen::MatrixXd(matrix).exp(); }

} // namespace lubberline
