#pragma once
/// Least-squares fits of the Smith coefficients to readings, with an honest report.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/deviation/SerialCorrelation.h"
#include "core/deviation/Smith.h"

namespace lubberline {

/// Readings that lie on the curve to the last digit leave the rounding of the computer: covariances are never zero.
inline constexpr double kLeastScatter_rad = 1e-12;

/// What a fit found, for both kinds. Values are [rad] for the approximate and dimensionless for the exact coefficients.
/// A coefficient that the headings cannot tell has no value.
struct SmithFitReport {
    std::array<std::optional<double>, kCoefficientCount> value;
    std::array<std::optional<double>, kCoefficientCount> standardError;               ///< none without degrees of freedom
    Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();     ///< zero rows where there is no value
    Eigen::Matrix<double, 5, 5> unitCovariance = Eigen::Matrix<double, 5, 5>::Zero(); ///< (XᵀX)⁻¹, of readings with unit variance
    /// Of the standard errors, what all readings share (addShared()): in covariance and standardError, but stated, not estimated from a scatter.
    std::array<double, kCoefficientCount> shared{};
    /// Half width of the 95 % interval in standard errors of the scatter: Student's quantile of the degrees of freedom (of those that
    /// correlated readings are worth); none where no scatter could be measured.
    std::optional<double> intervalFactor;
    /// Of neighbouring readings, where it is more than chance: the covariance counts it (SerialCorrelation.h).
    std::optional<double> lagOneCorrelation;
    /// largeIndex_deg(): B to E are of the compass turned in its mount by it. It is in A of the approximate fit, not of the exact one.
    double index_rad = 0;
    int parameters = 0;         ///< 5; 4 (without D or E), 3 (A, B, C) or 0
    int rank = 0;               ///< numerical rank of the five-column design matrix
    int degreesOfFreedom = 0;   ///< readings − parameters
    double conditionNumber = 0; ///< of the design matrix of the parameters that were fitted (of five columns if none was)
    double rms_rad = 0;         ///< √(Σ residual² / N) over the readings
    double maxAbsResidual_rad = 0;
    std::optional<double> sigma_rad;  ///< √(Σ residual² / degrees of freedom)
    std::vector<double> residual_rad; ///< deviation read − deviation fitted, one for each reading; empty without fit
    std::vector<double> leverage;     ///< diagonal of the hat matrix
    [[nodiscard]] bool fitted() const { return parameters > 0; }
    [[nodiscard]] std::optional<double> of(Coefficient c) const { return value[indexOf(c)]; }
    /// Half width of the 95 % interval, in the unit of the value: √((intervalFactor × standard error by scatter)² + (1.96 × shared)²).
    [[nodiscard]] std::optional<double> interval95(Coefficient c) const;
};

struct ApproximateFit : SmithFitReport {
    /// Values [rad], zero for what could not be told: only meaningful when fitted().
    [[nodiscard]] ApproximateSmith smith() const;
};
struct ExactFit : SmithFitReport {
    /// Of the compass turned in its mount by index_rad: deviationAt() of the fit has the index in it.
    [[nodiscard]] ExactSmith smith() const;
};
/// δ by [P 3], with the index.
[[nodiscard]] Deviation deviationAt(const ExactFit& fit, MagneticHeading magnetic);

/// A deviation up to this is one of a compass that is mounted in its place.
inline constexpr double kLargeIndex_deg = 45.0;

/// A compass mounted by more than 45° out of place, or read from its other side: the mean of the deviations on the circle, to a whole
/// degree [deg], so that what is left is a deviation like any other. 0 for every other compass.
[[nodiscard]] double largeIndex_deg(std::span<const Observation> readings);

/// A fit cannot be surer than its readings, whose error is `error_rad` each: where they scatter less (a few whole degrees that happen to
/// lie on a curve), or where there are no more of them than coefficients, covariance and standard errors are those of readings with that
/// error, and intervals are not shorter than its normal ones. The scatter itself (sigma_rad) and the residuals stay as they were found.
void widenTo(SmithFitReport& fit, double error_rad);
/// Adds standard errors of A to E that all readings share, and that no scatter shows [rad]. A fit that knows no errors stays so.
void addShared(SmithFitReport& fit, const std::array<double, kCoefficientCount>& errors_rad);

/// What a fit is asked for besides its coefficients and residuals.
struct FitWishes {
    bool uncertainty = true; ///< false: no errors, intervals or correlation, which cost most of the time of a log
    Progress progress = {};  ///< told false, the fit ends without errors: it is to be thrown away
};

/// Fits [P 4] on compass headings by linear least squares.
/// What the headings cannot tell is left out (ToldCoefficients.h); where they cannot tell A, B and C nothing is fitted, and the report
/// says why by its numbers.
/// Errors: InvalidInput (fewer than 3 readings, or fewer than 3 distinct compass headings).
Result<ApproximateFit> fitApproximate(std::span<const Observation> readings, const FitWishes& wishes = {});

/// Fits sin δ = 𝔄 cos δ + 𝔅 sin ψ' + ℭ cos ψ' + 𝔇 sin(ψ+ψ') + 𝔈 cos(ψ+ψ'), which is [P 3] multiplied out with ψ = ψ' + δ,
/// linear in the five. Residuals are δ read − δ by [P 3] at the magnetic heading. Selection and errors as above.
Result<ExactFit> fitExact(std::span<const Observation> readings, const FitWishes& wishes = {});

/// Half width of the 95 % confidence band of the fitted curve at a compass heading [rad], put together as interval95();
/// none without degrees of freedom, or where it would be half a turn or more.
[[nodiscard]] std::optional<double> bandHalfWidth_rad(const ApproximateFit& fit, CompassHeading compass);

/// Externally studentised residuals, none for a reading where two degrees of freedom are missing.
[[nodiscard]] std::vector<std::optional<double>> studentisedResiduals(const SmithFitReport& fit);
/// How far a reading lies from the curve fitted to the others: e/(1 − h) with its residual e and leverage h [rad].
/// The fit must be fitted() and the leverage below 1.
[[nodiscard]] double deletedResidual_rad(const SmithFitReport& fit, std::size_t reading);

} // namespace lubberline
