#include "core/sensor/map/DeviationMap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sensor/map/VectorAtan2.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostPoints = 16'000'000;

/// Below this part of what acts at the sensor, the rounding of a polynomial (some 1e-16 of what acts) turns the compass by more
/// than 1e-13 rad: such points are computed plainly.
constexpr double kWeakPart = 4e-3;

/// Samples that determine a trigonometric polynomial of second degree.
constexpr int kSamples = 5;

double& angleOf(AttitudeAxis axis, double& heading_deg, double& pitch_deg, double& roll_deg)
{
    return axis == AttitudeAxis::Heading ? heading_deg : axis == AttitudeAxis::Pitch ? pitch_deg : roll_deg;
}

/// The attitude of a point of the map.
class Attitudes {
public:
    explicit Attitudes(const MapRequest& request)
        : m_x(request.x.axis)
        , m_y(request.y.axis)
        , m_held(heldAxis(request))
        , m_held_deg(request.held_deg)
    {
    }
    Attitude at(double x_deg, double y_deg) const
    {
        double heading_deg = 0, pitch_deg = 0, roll_deg = 0;
        angleOf(m_held, heading_deg, pitch_deg, roll_deg) = m_held_deg;
        angleOf(m_x, heading_deg, pitch_deg, roll_deg) = x_deg;
        angleOf(m_y, heading_deg, pitch_deg, roll_deg) = y_deg;
        return {MagneticHeading::fromDegrees(heading_deg), toRadians(pitch_deg), toRadians(roll_deg)};
    }

private:
    AttitudeAxis m_x, m_y, m_held;
    double m_held_deg;
};

void prepare(const MapRequest& request, DeviationMap& map)
{
    const std::size_t size = static_cast<std::size_t>(request.x.nodes) * static_cast<std::size_t>(request.y.nodes);
    map.request = request;
    map.deviation_rad.resize(size);
    map.defined.resize(size);
}

void setPoint(DeviationMap& map, std::size_t at, const SensorReading& reading)
{
    map.deviation_rad[at] = reading.deviation ? reading.deviation->radians() : 0.0;
    map.defined[at] = reading.deviation ? 1 : 0;
}

/// The cosine and the sine of an angle.
struct OnCircle {
    double c = 1, s = 0;
};
OnCircle onCircle(double angle_deg) { return {std::cos(toRadians(angle_deg)), std::sin(toRadians(angle_deg))}; }

/// Those of heading, pitch and roll.
struct Turned {
    OnCircle heading, pitch, roll;
    OnCircle& of(AttitudeAxis axis) { return axis == AttitudeAxis::Heading ? heading : axis == AttitudeAxis::Pitch ? pitch : roll; }
};

/// What [P 22] takes the arc tangent of, turned by the heading so that the angle is the deviation itself: no wrapping is
/// needed.
struct Sides {
    double sine = 0, cosine = 0;
};

Sides sidesOf(const SensorResponse& sensor, const MeridianField& field, const Turned& at)
{
    const auto& [heading, pitch, roll] = at;
    // Rx(φ) Ry(θ) Rz(ψ) · (H, 0, Z), written out
    const double north = field.horizontal_nT * heading.c, east = -field.horizontal_nT * heading.s;
    const double down = pitch.s * north + pitch.c * field.down_nT;
    const Eigen::Vector3d body(pitch.c * north - pitch.s * field.down_nT, roll.c * east + roll.s * down, roll.c * down - roll.s * east);
    const Eigen::Vector3d B = sensor.gain * body + sensor.offset_nT;
    const double left = B.z() * roll.s - B.y() * roll.c;
    const double ahead = B.x() * pitch.c + (B.y() * roll.s + B.z() * roll.c) * pitch.s;
    return {heading.s * ahead - heading.c * left, heading.c * ahead + heading.s * left};
}

/// (1, cos, sin, cos 2·, sin 2·) of an angle.
using Harmonics5 = std::array<double, kSamples>;
Harmonics5 harmonicsOf(OnCircle angle) { return {1.0, angle.c, angle.s, 1.0 - 2.0 * angle.s * angle.s, 2.0 * angle.s * angle.c}; }

/// Both sides are trigonometric polynomials of second degree in any of heading, pitch and roll: the field in body axes is of
/// first degree in each, and [P 22] multiplies it once more by their sine or cosine. Five times five samples tell all
/// coefficients.
class SidesPolynomial {
public:
    SidesPolynomial(const SensorResponse& sensor, const MeridianField& field, const MapRequest& request)
    {
        std::array<OnCircle, kSamples> samples;
        for (int k = 0; k < kSamples; ++k)
            samples[static_cast<std::size_t>(k)] = onCircle(360.0 * k / kSamples);
        Turned at;
        at.of(heldAxis(request)) = onCircle(request.held_deg);
        for (const OnCircle& y : samples)
            for (const OnCircle& x : samples) {
                at.of(request.x.axis) = x;
                at.of(request.y.axis) = y;
                add(sidesOf(sensor, field, at), harmonicsOf(x), harmonicsOf(y));
            }
    }

    /// With y held: a polynomial in x.
    [[nodiscard]] TrigonometricRow at(OnCircle y) const
    {
        TrigonometricRow row{};
        const Harmonics5 harmonics = harmonicsOf(y);
        Eigen::Map<Eigen::Matrix<double, 2 * kSamples, 1>>(row.sine)
            = m_sides * Eigen::Map<const Eigen::Matrix<double, kSamples, 1>>(harmonics.data());
        return row;
    }

private:
    void add(const Sides& sides, const Harmonics5& x, const Harmonics5& y)
    {
        for (Eigen::Index j = 0; j < kSamples; ++j)
            for (Eigen::Index i = 0; i < kSamples; ++i) {
                const double weight = (i == 0 ? 1.0 : 2.0) * (j == 0 ? 1.0 : 2.0) / (kSamples * kSamples);
                const double part = weight * x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
                m_sides(i, j) += part * sides.sine;
                m_sides(kSamples + i, j) += part * sides.cosine;
            }
    }
    Eigen::Matrix<double, 2 * kSamples, kSamples> m_sides
        = Eigen::Matrix<double, 2 * kSamples, kSamples>::Zero(); ///< harmonics of x of both, by harmonic of y
};

/// Cosines and sines at the nodes of an axis, with a multiple of eight of them, so that no vector is left half empty.
class Circle {
public:
    explicit Circle(const MapAxis& axis) : m_padded((static_cast<std::size_t>(axis.nodes) + 7) / 8 * 8), m_values(2 * m_padded)
    {
        for (std::size_t i = 0; i < m_padded; ++i) {
            const OnCircle node = onCircle(axis.at_deg(std::min(static_cast<int>(i), axis.nodes - 1)));
            m_values[i] = node.c;
            m_values[m_padded + i] = node.s;
        }
    }
    [[nodiscard]] std::size_t padded() const { return m_padded; }
    [[nodiscard]] const double* cosines() const { return m_values.data(); }
    [[nodiscard]] const double* sines() const { return &m_values[m_padded]; }
    [[nodiscard]] OnCircle at(int node) const { return {cosines()[node], sines()[node]}; }

private:
    std::size_t m_padded;
    std::vector<double> m_values;
};

/// An upper bound of what acts at the sensor anywhere.
double mostActing_nT(const SensorResponse& sensor, const MeridianField& field)
{
    return sensor.gain.norm() * field.total_nT() + sensor.offset_nT.norm();
}

/// Square of what is left for the compass at a node, as the fast way computes it.
double sizeAt(const TrigonometricRow& row, OnCircle node)
{
    const Harmonics5 x = harmonicsOf(node);
    double sine = 0, cosine = 0;
    for (std::size_t j = 0; j < kSamples; ++j) {
        sine += row.sine[j] * x[j];
        cosine += row.cosine[j] * x[j];
    }
    return sine * sine + cosine * cosine;
}

double wrapPi(double angle_rad)
{
    const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
    return wrapped <= -kPi ? kPi : wrapped;
}

} // namespace

AxisRange fullRange(AttitudeAxis axis)
{
    switch (axis) {
    case AttitudeAxis::Heading: return {0, 360};
    case AttitudeAxis::Pitch: return {-90, 90};
    case AttitudeAxis::Roll: break;
    }
    return {-180, 180};
}

AttitudeAxis heldAxis(const MapRequest& request)
{
    for (const auto axis : {AttitudeAxis::Heading, AttitudeAxis::Pitch})
        if (axis != request.x.axis && axis != request.y.axis)
            return axis;
    return AttitudeAxis::Roll;
}

Result<void> checkMapRequest(const MapRequest& request)
{
    if (request.x.axis == request.y.axis)
        return Error{ErrorCode::InvalidInput, MARKED("core", "both axes of the map are the same; expected two of heading, pitch and roll")};
    if (request.x.nodes < 2 || request.y.nodes < 2)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "a map has at least 2 x 2 points; asked for %1 x %2"), request.x.nodes, request.y.nodes}};
    const auto points = static_cast<std::size_t>(request.x.nodes) * static_cast<std::size_t>(request.y.nodes);
    if (points > kMostPoints)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "a map of %1 x %2 has %3 points and takes %4 MiB; expected at most %5 points"), request.x.nodes,
                request.y.nodes, points, points * (sizeof(double) + 1) >> 20, kMostPoints}};
    return {};
}

void computeMapPlainly(const SensorResponse& sensor, const MeridianField& field, const MapRequest& request, DeviationMap& map)
{
    prepare(request, map);
    const Attitudes attitudes(request);
    for (int y = 0; y < request.y.nodes; ++y)
        for (int x = 0; x < request.x.nodes; ++x)
            setPoint(map, map.index(x, y), readSensor(sensor, field, attitudes.at(request.x.at_deg(x), request.y.at_deg(y))));
}

void computeMap(const SensorResponse& sensor, const MeridianField& field, const MapRequest& request, DeviationMap& map)
{
    prepare(request, map);
    std::fill(map.defined.begin(), map.defined.end(), std::uint8_t{1});
    const Attitudes attitudes(request);
    const SidesPolynomial sides(sensor, field, request);
    const Circle xCircle(request.x), yCircle(request.y);
    const double weak_nT = kWeakPart * mostActing_nT(sensor, field), weak2 = weak_nT * weak_nT;
    const auto columns = static_cast<std::size_t>(request.x.nodes);
    for (int y = 0; y < request.y.nodes; ++y) {
        const TrigonometricRow row = sides.at(yCircle.at(y));
        double* deviation = &map.deviation_rad[map.index(0, y)];
        // What is computed beyond a row is overwritten by the next one.
        const bool last = static_cast<std::size_t>(request.y.nodes - 1 - y) * columns < xCircle.padded() - columns;
        const double least = vectorAngles(row, xCircle.cosines(), xCircle.sines(), deviation, last ? columns : xCircle.padded());
        if (least > weak2) // asked this way round, a field that is not finite is computed plainly, too
            continue;
        for (int x = 0; x < request.x.nodes; ++x)
            if (!(sizeAt(row, xCircle.at(x)) > weak2))
                setPoint(map, map.index(x, y), readSensor(sensor, field, attitudes.at(request.x.at_deg(x), request.y.at_deg(y))));
    }
}

DeviationMap differenceOf(const DeviationMap& a, const DeviationMap& b)
{
    LUBBERLINE_EXPECT(a.deviation_rad.size() == b.deviation_rad.size(), "maps that are compared have the same nodes");
    DeviationMap difference = b;
    for (std::size_t i = 0; i < b.deviation_rad.size(); ++i) {
        difference.defined[i] = a.defined[i] && b.defined[i] ? 1 : 0;
        difference.deviation_rad[i] = difference.defined[i] ? wrapPi(b.deviation_rad[i] - a.deviation_rad[i]) : 0.0;
    }
    return difference;
}

} // namespace lubberline
