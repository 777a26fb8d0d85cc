#include "core/deviation/Smith.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace lubberline {

namespace {

/// Roots of a continuous function of a heading over one turn, by scanning and bisection.
/// The functions that we solve have slopes of order one: a scan of 1° separates every pair of roots that a compass could tell.
constexpr int kScanSteps = 720;

std::vector<double> headingsWhere(const std::function<double(double)>& mismatch_rad)
{
    std::vector<double> roots_rad;
    const double step = 2 * kPi / kScanSteps;
    const double atNorth = mismatch_rad(0);
    double left = 0, atLeft = atNorth;
    for (int i = 1; i <= kScanSteps; ++i) {
        const double right = i * step;
        // The turn ends where it began, with the same figure: rounding neither loses a root at north nor finds it twice.
        const double atRight = i == kScanSteps ? atNorth : mismatch_rad(right);
        // A jump by a turn is the wrap at ±180°, not a root.
        if (atLeft == 0.0) {
            roots_rad.push_back(left);
        } else if (atLeft * atRight < 0 && std::abs(atLeft - atRight) < kPi) {
            double low = left, high = right, atLow = atLeft;
            while (high - low > 1e-15 * 8) {
                const double middle = 0.5 * (low + high);
                if (middle <= low || middle >= high)
                    break;
                const double atMiddle = mismatch_rad(middle);
                if ((atMiddle < 0) == (atLow < 0)) {
                    low = middle;
                    atLow = atMiddle;
                } else {
                    high = middle;
                }
            }
            roots_rad.push_back(0.5 * (low + high));
        }
        left = right;
        atLeft = atRight;
    }
    return roots_rad;
}

double wrap_rad(double angle_rad) { return std::remainder(angle_rad, 2 * kPi); }

std::string degreesText(double heading_rad)
{
    const double tenths = std::round(wrap360(toDegrees(heading_rad)) * 10.0);
    const int whole = static_cast<int>(tenths) % 3600;
    std::string digits = std::to_string(whole / 10);
    digits.insert(0, 3 - digits.size(), '0');
    return digits + "." + std::to_string(whole % 10) + "°";
}

/// `none` and `several`: what to say of the reading (%1) that no heading, or several (%2), would give.
Error foldError(Pattern none, Pattern several, double reading_deg, const std::vector<double>& roots_rad)
{
    if (roots_rad.empty())
        return {ErrorCode::Numeric, {none, degreesText(toRadians(reading_deg))}};
    std::string headings;
    for (const double root : roots_rad)
        headings += (headings.empty() ? "" : ", ") + degreesText(root);
    return {ErrorCode::Numeric, {several, degreesText(toRadians(reading_deg)), headings}};
}

Result<double> inverseSine(double argument, char letter)
{
    if (std::abs(argument) < 1.0)
        return std::asin(argument);
    return Error{ErrorCode::Numeric,
        {MARKED("core", "no approximate coefficient %1 exists: the sine that it would have is %2; expected one between -1 and 1"), letter,
            std::to_string(argument)}};
}

} // namespace

Deviation deviationAt(const ApproximateSmith& smith, CompassHeading compass)
{
    double sum_rad = 0;
    for (const Coefficient coefficient : kCoefficients)
        sum_rad += component_rad(smith, coefficient, compass);
    return Deviation::fromRadians(sum_rad);
}

double component_rad(const ApproximateSmith& smith, Coefficient which, CompassHeading compass)
{
    const double z = compass.radians() + smith.index_rad;
    switch (which) {
    case Coefficient::A: return smith.A_rad;
    case Coefficient::B: return smith.B_rad * std::sin(z);
    case Coefficient::C: return smith.C_rad * std::cos(z);
    case Coefficient::D: return smith.D_rad * std::sin(2 * z);
    case Coefficient::E: return smith.E_rad * std::cos(2 * z);
    }
    return 0;
}

Deviation deviationAt(const ExactSmith& smith, MagneticHeading magnetic)
{
    const double s1 = std::sin(magnetic.radians()), c1 = std::cos(magnetic.radians());
    const double s2 = 2 * s1 * c1, c2 = c1 * c1 - s1 * s1;
    const double numerator = smith.A + smith.B * s1 + smith.C * c1 + smith.D * s2 + smith.E * c2;
    const double denominator = 1 + smith.B * c1 - smith.C * s1 + smith.D * c2 - smith.E * s2;
    return Deviation::fromRadians(std::atan2(numerator, denominator));
}

Result<MagneticHeading> magneticHeadingFor(const ExactSmith& smith, CompassHeading compass)
{
    const auto roots_rad = headingsWhere([&](double psi_rad) {
        return wrap_rad(psi_rad - deviationAt(smith, MagneticHeading::fromRadians(psi_rad)).radians() - compass.radians());
    });
    if (roots_rad.size() != 1)
        return foldError(MARKED("core", "no magnetic heading gives the compass heading %1: the coefficients are too large"),
            MARKED("core", "the compass heading %1 belongs to several magnetic headings (%2): the deviation curve is folded; expected one"),
            compass.degrees(), roots_rad);
    return MagneticHeading::fromRadians(roots_rad.front());
}

Result<CompassHeading> compassHeadingFor(const ApproximateSmith& smith, MagneticHeading magnetic)
{
    const auto roots_rad = headingsWhere([&](double z_rad) {
        return wrap_rad(z_rad + deviationAt(smith, CompassHeading::fromRadians(z_rad)).radians() - magnetic.radians());
    });
    if (roots_rad.size() != 1)
        return foldError(MARKED("core", "no compass heading gives the magnetic heading %1: the coefficients are too large"),
            MARKED("core", "the magnetic heading %1 belongs to several compass headings (%2): the deviation curve is folded; expected one"),
            magnetic.degrees(), roots_rad);
    return CompassHeading::fromRadians(roots_rad.front());
}

Result<ApproximateSmith> toApproximate(const ExactSmith& exact)
{
    // sin D is 𝔇 itself, so [P 5] needs no iteration; with |𝔇| < 1 its divisors are above one half.
    const auto A = inverseSine(exact.A, 'A');
    const auto B = inverseSine(exact.B / (1 + 0.5 * exact.D), 'B');
    const auto C = inverseSine(exact.C / (1 - 0.5 * exact.D), 'C');
    const auto D = inverseSine(exact.D, 'D');
    const auto E = inverseSine(exact.E, 'E');
    for (const auto* each : {&D, &A, &B, &C, &E})
        if (!*each)
            return each->error();
    return ApproximateSmith{*A, *B, *C, *D, *E};
}

ExactSmith toExact(const ApproximateSmith& approximate)
{
    const double sinD = std::sin(approximate.D_rad);
    return {std::sin(approximate.A_rad), std::sin(approximate.B_rad) * (1 + 0.5 * sinD), std::sin(approximate.C_rad) * (1 - 0.5 * sinD),
        sinD, std::sin(approximate.E_rad)};
}

ApproximateSmith byHeadingAsRead(const ApproximateSmith& smith)
{
    const double s1 = std::sin(smith.index_rad), c1 = std::cos(smith.index_rad);
    const double s2 = std::sin(2 * smith.index_rad), c2 = std::cos(2 * smith.index_rad);
    return {smith.A_rad, smith.B_rad * c1 - smith.C_rad * s1, smith.B_rad * s1 + smith.C_rad * c1, smith.D_rad * c2 - smith.E_rad * s2,
        smith.D_rad * s2 + smith.E_rad * c2};
}

ApproximateSmith without(const ApproximateSmith& smith, CoefficientSet removed)
{
    const auto kept = [&](Coefficient c, double value) { return removed.test(indexOf(c)) ? 0.0 : value; };
    return {kept(Coefficient::A, smith.A_rad), kept(Coefficient::B, smith.B_rad), kept(Coefficient::C, smith.C_rad),
        kept(Coefficient::D, smith.D_rad), kept(Coefficient::E, smith.E_rad), smith.index_rad};
}

ExactSmith without(const ExactSmith& smith, CoefficientSet removed)
{
    const auto kept = [&](Coefficient c, double value) { return removed.test(indexOf(c)) ? 0.0 : value; };
    return {kept(Coefficient::A, smith.A), kept(Coefficient::B, smith.B), kept(Coefficient::C, smith.C), kept(Coefficient::D, smith.D),
        kept(Coefficient::E, smith.E)};
}

} // namespace lubberline
