#pragma once
/// The exponential of a matrix: what a linear system makes of its state in a step of time.

#include "core/algebra/Matrices.h"

namespace lubberline {

[[nodiscard]] Eigen::MatrixXd exponential(const MatrixView& matrix);

} // namespace lubberline
