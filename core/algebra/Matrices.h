#pragma once
/// What the functions of this folder take: any matrix or vector of doubles of any size, without a copy where it lies column by column.

#include <Eigen/Core>

namespace lubberline {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

} // namespace lubberline
