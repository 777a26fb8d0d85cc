#pragma once
/// From swings to Poisson's parameters: what level swings can tell and what they cannot.
/// One place gives five numbers (𝔄…𝔈); swings of one compass where H and dip differ separate hard iron from vertical soft iron:
///   𝔅_i = (c/λ) tan I_i + (P/λ)/H_i,   ℭ_i = (f/λ) tan I_i + (Q/λ)/H_i                                     [P 7]

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/deviation/SmithFit.h"
#include "core/earth/EarthField.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// A level swing's exact coefficients where it was made.
struct SwingAtPlace {
    ExactSmith exact;
    ExactSmith standardError; ///< dimensionless; 0 everywhere: not known (the scatter of the swings is used then)
    MeridianField field;
    std::string label;                                          ///< site and date, for messages
    int degreesOfFreedom = 0;                                   ///< of the fit that the standard errors are from; 0: they are known well
    std::optional<Eigen::Matrix<double, 5, 5>> covariance = {}; ///< of the fit, A … E; none: the errors are independent
    double index_rad = 0; ///< of a compass that is far out as a whole: `exact` is of it mounted right, and it deviates by this more
    Message taken = {};   ///< what was taken from elsewhere because the readings do not tell it; empty: nothing
};

/// Whether the swing's own errors of B and C are known.
[[nodiscard]] bool errorsKnown(const SwingAtPlace& swing);

/// By how much standard errors of few degrees of freedom are widened before anything is concluded from them: by Student's
/// quantiles, so that one of them holds the truth in 68 % of the cases and three of them in 95 % at least. 1 for 0 (known
/// well); 1.20 for a swing of eight readings; 4.24 for one of six.
[[nodiscard]] double widening(int degreesOfFreedom);

struct Estimate {
    double value = 0, standardError = 0;
};

/// A sentence of the list "what a swing can tell".
struct Knowledge {
    bool known = false;
    Message what; ///< "(a − e)/2λ = 0.0123", "a and e each: only their difference acts on a level compass"
};

struct IronSeparation {
    Estimate c, f;              ///< vertical soft iron as a part of λ, dimensionless
    Estimate P_nT, Q_nT;        ///< hard iron as a part of λ [nT]
    double correlation = 0;     ///< between c and P (and f and Q), −1 … 1
    double conditionNumber = 0; ///< of the fields (tan I, 1/H), columns scaled: large when the places are alike
    Estimate A, D, E;           ///< 𝔄, 𝔇, 𝔈: the means of the swings, as they do not depend on place
    double chiSquare = 0;       ///< of B and C over the swings
    int degreesOfFreedom = 0;
    std::vector<Message> warnings; ///< places too alike; swings that contradict each other
};

/// Above this condition number the places are too alike: results come with a warning and wide errors.
inline constexpr double kAlikePlaces = 30.0;

/// Weighted by the swings' standard errors, widened for their degrees of freedom, where all are known.
/// Errors: InvalidInput (fewer than 2 swings; H 0), Numeric (places equal, or dip 0 at all: nothing can be separated; names
/// them).
Result<IronSeparation> separateIron(std::span<const SwingAtPlace> swings);

/// What one level swing (or several, when separation is given) tells and what it cannot tell.
[[nodiscard]] std::vector<Knowledge> whatSwingsTell(const SwingAtPlace& swing, const std::optional<IronSeparation>& separation);

/// The simplest models that a swing allows: every combination that it cannot tell is zero (λ = 1).
enum class Origin { HardIron, VerticalSoftIron };
/// 𝔅 and ℭ as all hard iron (P = 𝔅H) or all vertical soft iron (c = 𝔅/tan I). 𝔇 and 𝔈 as soft iron a = −e, b = d; 𝔄 as d = −b.
/// Errors: Numeric when the dip is 0 and the origin is vertical soft iron.
Result<SensorModel> modelOf(const ExactSmith& exact, const MeridianField& field, Origin origin);
/// With c, f, P, Q of a separation.
[[nodiscard]] SensorModel modelOf(const IronSeparation& separation);

} // namespace lubberline
