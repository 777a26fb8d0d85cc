#include "core/swing/IronSeparation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "core/algebra/LeastSquares.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

/// Beyond this, the places are equal but for rounding.
constexpr double kSamePlaces = 1000.0;
/// No aircraft has vertical soft iron beyond this part of lambda: what is not known within it is not known.
constexpr double kMostVerticalIron = 0.3;
/// Swings that contradict each other more than one set in a hundred would by chance.
constexpr double kContradiction = 0.99;

std::string withError(double value, double error, int decimals)
{
    return error > 0 ? signedFigureText(value, decimals) + " (s.e. " + figureText(error, decimals) + ")"
                     : signedFigureText(value, decimals);
}

/// (vertical soft iron, hard iron as a part of the mean H) of one coefficient over the swings.
struct PairFit {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double chiSquare = 0;
};

double widened(const SwingAtPlace& swing, double ExactSmith::*coefficient)
{
    return swing.standardError.*coefficient * widening(swing.degreesOfFreedom);
}

class Separation {
public:
    explicit Separation(std::span<const SwingAtPlace> swings) : m_swings(swings)
    {
        m_errorsKnown = std::all_of(swings.begin(), swings.end(), errorsKnown);
    }
    Result<IronSeparation> make();

private:
    void makeDesign();
    Result<double> likeness() const; ///< condition number of the fields alone: how much the readings are worth does not make places alike
    PairFit fit(double ExactSmith::*coefficient) const;
    Estimate mean(double ExactSmith::*coefficient) const;
    void warn(IronSeparation& separation) const;
    std::string places() const;

    std::span<const SwingAtPlace> m_swings;
    Eigen::MatrixXd m_design; ///< (tan I, mean H/H) a swing
    double m_meanH = 0;
    bool m_errorsKnown = false;
};

std::string Separation::places() const
{
    std::string names;
    for (const auto& swing : m_swings)
        names += (names.empty() ? "" : ", ") + swing.label;
    return names;
}

void Separation::makeDesign()
{
    m_design.resize(static_cast<Eigen::Index>(m_swings.size()), 2);
    for (const auto& swing : m_swings)
        m_meanH += swing.field.horizontal_nT / static_cast<double>(m_swings.size());
    for (std::size_t i = 0; i < m_swings.size(); ++i) {
        const MeridianField& field = m_swings[i].field;
        m_design.row(static_cast<Eigen::Index>(i)) << field.down_nT / field.horizontal_nT, m_meanH / field.horizontal_nT;
    }
}

Result<double> Separation::likeness() const
{
    const Eigen::RowVector2d length = m_design.colwise().norm();
    if (length.minCoeff() == 0.0) // dip 0 everywhere: vertical soft iron shows nowhere
        return Error{ErrorCode::Numeric,
            {MARKED("core", "the dip is 0 at every place (%1): vertical soft iron shows nowhere and cannot be told"), places()}};
    const Eigen::MatrixXd scaled = m_design * length.cwiseInverse().asDiagonal();
    const double condition = conditionNumber(singularValues(scaled));
    if (!(condition <= kSamePlaces))
        return Error{ErrorCode::Numeric,
            {MARKED("core",
                 "the field is the same at all places (%1): hard iron and vertical soft iron cannot be told apart; expected swings where H and dip differ"),
                places()}};
    return condition;
}

PairFit Separation::fit(double ExactSmith::*coefficient) const
{
    const auto count = static_cast<Eigen::Index>(m_swings.size());
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(count), observed(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto& swing = m_swings[static_cast<std::size_t>(i)];
        if (m_errorsKnown)
            weight(i) = 1.0 / widened(swing, coefficient);
        observed(i) = weight(i) * (swing.exact.*coefficient);
    }
    const Eigen::MatrixXd design = weight.asDiagonal() * m_design;
    const LeastSquares solved = solveLeastSquares(design, observed);
    PairFit fit;
    fit.value = solved.solution;
    fit.chiSquare = (observed - design * solved.solution).squaredNorm();
    if (m_errorsKnown)
        fit.covariance = solved.inverseNormal;
    else if (count > 2)
        fit.covariance
            = solved.inverseNormal * (fit.chiSquare / static_cast<double>(count - 2) * std::pow(widening(static_cast<int>(count) - 2), 2));
    return fit;
}

Estimate Separation::mean(double ExactSmith::*coefficient) const
{
    double weights = 0, sum = 0;
    const bool known
        = std::all_of(m_swings.begin(), m_swings.end(), [&](const auto& swing) { return swing.standardError.*coefficient > 0; });
    for (const auto& swing : m_swings) {
        const double weight = known ? std::pow(widened(swing, coefficient), -2) : 1.0;
        weights += weight;
        sum += weight * (swing.exact.*coefficient);
    }
    Estimate estimate{sum / weights, known ? 1.0 / std::sqrt(weights) : 0.0};
    if (!known && m_swings.size() > 1) {
        double squares = 0;
        for (const auto& swing : m_swings)
            squares += std::pow(swing.exact.*coefficient - estimate.value, 2);
        const auto count = static_cast<int>(m_swings.size());
        estimate.standardError = std::sqrt(squares / (count - 1) / count) * widening(count - 1);
    }
    return estimate;
}

void Separation::warn(IronSeparation& separation) const
{
    if (separation.conditionNumber > kAlikePlaces)
        separation.warnings.push_back(
            {MARKED("core", "the fields at %1 are too alike: hard iron and vertical soft iron are told apart only roughly"), places()});
    if (!m_errorsKnown && m_swings.size() == 2)
        separation.warnings.push_back(
            MARKED("core", "the swings' own errors are not known, and two swings have no scatter: no errors can be stated"));
    if (m_errorsKnown && separation.degreesOfFreedom > 0
        && separation.chiSquare > boost::math::quantile(boost::math::chi_squared(separation.degreesOfFreedom), kContradiction))
        separation.warnings.push_back(MARKED(
            "core", "the swings contradict each other beyond their errors: something was changed between them, or a swing is wrong"));
}

Result<IronSeparation> Separation::make()
{
    if (m_swings.size() < 2)
        return Error{ErrorCode::InvalidInput,
            MARKED(
                "core", "one swing cannot tell hard iron from vertical soft iron; expected swings of the compass at two places at least")};
    for (const auto& swing : m_swings)
        if (!(swing.field.horizontal_nT > 0) || !std::isfinite(swing.field.down_nT))
            return Error{
                ErrorCode::InvalidInput, {MARKED("core", "the field of %1 is not known; expected H above 0 and the dip"), swing.label}};
    makeDesign();
    const auto condition = likeness();
    if (!condition)
        return condition.error();
    const PairFit B = fit(&ExactSmith::B), C = fit(&ExactSmith::C);
    IronSeparation separation;
    const auto error = [](const PairFit& pair, int i) { return std::sqrt(std::max(0.0, pair.covariance(i, i))); };
    separation.c = {B.value(0), error(B, 0)};
    separation.f = {C.value(0), error(C, 0)};
    separation.P_nT = {B.value(1) * m_meanH, error(B, 1) * m_meanH};
    separation.Q_nT = {C.value(1) * m_meanH, error(C, 1) * m_meanH};
    const double product = error(B, 0) * error(B, 1);
    separation.correlation = product > 0 ? B.covariance(0, 1) / product : 0.0;
    separation.conditionNumber = *condition;
    separation.A = mean(&ExactSmith::A);
    separation.D = mean(&ExactSmith::D);
    separation.E = mean(&ExactSmith::E);
    separation.chiSquare = m_errorsKnown ? B.chiSquare + C.chiSquare : 0.0;
    separation.degreesOfFreedom = 2 * (static_cast<int>(m_swings.size()) - 2);
    warn(separation);
    return separation;
}

SensorModel levelModel(double A, double D, double E)
{
    SensorModel model; // lambda = 1
    model.softIron(0, 0) = D;
    model.softIron(1, 1) = -D;
    model.softIron(0, 1) = E - A;
    model.softIron(1, 0) = E + A;
    return model;
}

} // namespace

bool errorsKnown(const SwingAtPlace& swing) { return swing.standardError.B > 0 && swing.standardError.C > 0; }

double widening(int degreesOfFreedom)
{
    LUBBERLINE_EXPECT(degreesOfFreedom >= 0, "degrees of freedom are not negative");
    if (degreesOfFreedom == 0)
        return 1.0;
    constexpr double kOneError = 0.841345,
                     kNineteenOfTwenty = 0.975; // one-sided: the normal distribution's 68.3 % within 1; 95 %
    const boost::math::students_t student(degreesOfFreedom);
    return std::max(boost::math::quantile(student, kOneError), boost::math::quantile(student, kNineteenOfTwenty) / 3);
}

Result<IronSeparation> separateIron(std::span<const SwingAtPlace> swings) { return Separation(swings).make(); }

std::vector<Knowledge> whatSwingsTell(const SwingAtPlace& swing, const std::optional<IronSeparation>& separation)
{
    const ExactSmith& value = swing.exact;
    const ExactSmith& error = swing.standardError;
    std::vector<Knowledge> list{
        {true, {MARKED("core", "(d \u2212 b)/2\u03bb = A = %1 (with the turn of the mount)"), withError(value.A, error.A, 4)}},
        {true, {MARKED("core", "(a \u2212 e)/2\u03bb = D = %1"), withError(value.D, error.D, 4)}},
        {true, {MARKED("core", "(d + b)/2\u03bb = E = %1"), withError(value.E, error.E, 4)}},
        {true, {MARKED("core", "(c tan I + P/H)/\u03bb = B = %1"), withError(value.B, error.B, 4)}},
        {true, {MARKED("core", "(f tan I + Q/H)/\u03bb = C = %1"), withError(value.C, error.C, 4)}},
    };
    if (separation && std::max(separation->c.standardError, separation->f.standardError) > kMostVerticalIron) {
        list.push_back({false,
            {MARKED(
                 "core", "c apart from P, f apart from Q: the places are too alike, c/\u03bb would be known within a standard error of %1"),
                figureText(separation->c.standardError, 1)}});
    } else if (separation) {
        list.push_back({true,
            {MARKED("core", "vertical soft iron: c/\u03bb = %1, f/\u03bb = %2"),
                withError(separation->c.value, separation->c.standardError, 4),
                withError(separation->f.value, separation->f.standardError, 4)}});
        list.push_back({true,
            {MARKED("core", "hard iron: P/\u03bb = %1 nT, Q/\u03bb = %2 nT"),
                withError(separation->P_nT.value, separation->P_nT.standardError, 0),
                withError(separation->Q_nT.value, separation->Q_nT.standardError, 0)}});
    } else {
        list.push_back({false,
            MARKED("core", "c apart from P, f apart from Q: one place gives their sum; a swing where H and dip differ tells them apart")});
    }
    list.push_back({false, MARKED("core", "\u03bb, the directive force: a compass shows directions, not sizes")});
    list.push_back({false, MARKED("core", "a and e each, b and d each: on a level heading only a \u2212 e, d + b and d \u2212 b act")});
    list.push_back({false, MARKED("core", "g, h, k and R: they act in pitch and roll only")});
    list.push_back({false, MARKED("core", "the turn of the mount apart from (d \u2212 b)/2\u03bb, and its tilt")});
    list.push_back({false, MARKED("core", "soft-iron constants and currents apart from hard iron: both are constant in body axes")});
    return list;
}

Result<SensorModel> modelOf(const ExactSmith& exact, const MeridianField& field, Origin origin)
{
    SensorModel model = levelModel(exact.A, exact.D, exact.E);
    if (origin == Origin::HardIron) {
        model.hardIron_nT.x() = exact.B * field.horizontal_nT;
        model.hardIron_nT.y() = exact.C * field.horizontal_nT;
        return model;
    }
    if (field.down_nT == 0.0)
        return Error{ErrorCode::Numeric, MARKED("core", "the dip is 0 there: vertical soft iron cannot have made B and C")};
    model.softIron(0, 2) = exact.B * field.horizontal_nT / field.down_nT;
    model.softIron(1, 2) = exact.C * field.horizontal_nT / field.down_nT;
    return model;
}

SensorModel modelOf(const IronSeparation& separation)
{
    SensorModel model = levelModel(separation.A.value, separation.D.value, separation.E.value);
    model.softIron(0, 2) = separation.c.value;
    model.softIron(1, 2) = separation.f.value;
    model.hardIron_nT.x() = separation.P_nT.value;
    model.hardIron_nT.y() = separation.Q_nT.value;
    return model;
}

} // namespace lubberline
