#include "core/swing/Card.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/angle/AngleText.h"
#include "core/swing/CardCurve.h"
#include "core/swing/CompassAtFault.h"

namespace lubberline {

namespace {

Error cannotTell(const Message& what)
{
    return {ErrorCode::Numeric, {MARKED("core", "%1 cannot be told from these headings; expected readings all around the compass"), what}};
}

/// The approximate coefficients that are taken out when the card is made of readings: the worksheet takes those of the point
/// rules.
Result<ApproximateSmith> removedFromReadings(const Analysis& analysis, CoefficientSet removed)
{
    ApproximateSmith smith;
    smith.index_rad = analysis.approximate.index_rad;
    const std::array<double*, kCoefficientCount> field{&smith.A_rad, &smith.B_rad, &smith.C_rad, &smith.D_rad, &smith.E_rad};
    for (const Coefficient coefficient : kCoefficients) {
        if (!removed.test(indexOf(coefficient)))
            continue;
        std::optional<double> value = analysis.approximate.of(coefficient);
        if (analysis.pointRules) {
            const auto& rules = *analysis.pointRules;
            const std::array<std::optional<double>, kCoefficientCount> byRule{
                rules.A_rad, rules.B_rad, rules.C_rad, rules.D_rad, rules.E_rad};
            if (byRule[indexOf(coefficient)])
                value = byRule[indexOf(coefficient)];
        }
        if (!value)
            return cannotTell({MARKED("core", "coefficient %1"), letterOf(coefficient)});
        *field[indexOf(coefficient)] = *value;
    }
    return smith;
}

/// Figures read are decimal: what rounding in radians left of 1.0000000000000002 is cut, so that a steer of 43 is 43.
double clean_deg(double angle_deg) { return std::round(angle_deg * 1e10) / 1e10; }

/// A reading as the compass stands after what was removed.
struct LeftReading {
    MagneticHeading magnetic;
    CompassHeading compass; ///< what it would read now
    Deviation deviation;
};

/// The curve of the exact fit, and that curve without what was removed; null without a fit.
struct Curves {
    CardCurve::DeviationAt asRead, asLeft;
};

Result<Curves> curvesOf(const Analysis& analysis, CoefficientSet removed)
{
    if (!analysis.exact.fitted())
        return Curves{};
    const bool removeA = removed.test(indexOf(Coefficient::A));
    if (removeA && !analysis.approximate.of(Coefficient::A))
        return cannotTell({MARKED("core", "coefficient %1"), 'A'});
    // A is a turn of the compass in its mount, an angle; the others are fields at the sensor.
    const double turn_rad = removeA ? *analysis.approximate.of(Coefficient::A) : 0.0;
    removed.reset(indexOf(Coefficient::A));
    const ExactSmith smith = analysis.exact.smith(), left = without(smith, removed);
    const double index_rad = analysis.exact.index_rad;
    const auto turned = [](const ExactSmith& curve, MagneticHeading at, double by_rad) {
        return Deviation::fromDegrees(deviationAt(curve, at).degrees() + toDegrees(by_rad));
    };
    return Curves{[smith, index_rad, turned](MagneticHeading at) { return turned(smith, at, index_rad); },
        [left, index_rad, turn_rad, turned](MagneticHeading at) { return turned(left, at, index_rad - turn_rad); }};
}

Result<std::vector<LeftReading>> leftReadings(const Analysis& analysis, const CardOptions& options, const Curves& curves)
{
    std::vector<LeftReading> left;
    const auto add = [&left](const AnalysedReading& reading, double taken_deg) {
        const auto deviation = Deviation::fromDegrees(clean_deg(reading.deviation.degrees() - taken_deg));
        left.push_back({reading.magnetic, toCompass(reading.magnetic, deviation), deviation});
    };
    if (options.source == CardSource::Fit) {
        for (const auto& reading : analysis.readings)
            add(reading, wrap180(curves.asRead(reading.magnetic).degrees() - curves.asLeft(reading.magnetic).degrees()));
        return left;
    }
    const auto removed = removedFromReadings(analysis, options.removed);
    if (!removed)
        return removed.error();
    for (const auto& reading : analysis.readings)
        add(reading, deviationAt(*removed, reading.compass).degrees());
    return left;
}

/// Its place among the readings. Of two equally near the one of the smaller heading, whatever the order of the readings.
std::size_t nearestReading(const std::vector<LeftReading>& readings, double heading_deg, CardBy by)
{
    const auto key = [&](const LeftReading& reading) {
        const double here_deg = by == CardBy::Magnetic ? reading.magnetic.degrees() : reading.compass.degrees();
        return std::pair(std::abs(wrap180(here_deg - heading_deg)), here_deg);
    };
    const auto nearest
        = std::min_element(readings.begin(), readings.end(), [&](const LeftReading& a, const LeftReading& b) { return key(a) < key(b); });
    return static_cast<std::size_t>(nearest - readings.begin());
}

/// Everything that rows are made of.
struct CardWork {
    const Analysis& analysis;
    const CardOptions& options;
    Curves curves;
    std::optional<CardCurve> curve; ///< as left; none without a fit
    std::vector<LeftReading> readings;
    std::vector<ReadingGap> gaps;

    [[nodiscard]] bool unread(MagneticHeading heading) const
    {
        return std::any_of(gaps.begin(), gaps.end(), [heading](const ReadingGap& gap) { return gap.holds(heading); });
    }
    [[nodiscard]] std::optional<double> bandOfCurve_rad(MagneticHeading heading) const
    {
        const auto& fit = analysis.approximate;
        if (!curve || fit.parameters < static_cast<int>(kCoefficientCount)) // D and E may be anything
            return {};
        return bandHalfWidth_rad(fit, toCompass(heading, curves.asRead(heading)));
    }
    /// One reading is as sure as the fit is at it, over the root of its leverage; and the curve goes on from it to the row.
    [[nodiscard]] std::optional<double> bandOfReading_rad(std::size_t place, MagneticHeading row) const
    {
        const AnalysedReading& reading = analysis.readings[place];
        const auto atReading = bandHalfWidth_rad(analysis.approximate, reading.compass);
        const auto there = bandOfCurve_rad(row);
        if (!atReading || !there || !(analysis.approximate.leverage[place] > 0))
            return {};
        const double further_rad
            = std::abs(toRadians(wrap180(curve->deviationAt(row).degrees() - curve->deviationAt(reading.magnetic).degrees())));
        return *atReading / std::sqrt(analysis.approximate.leverage[place]) + further_rad + (unread(row) ? *there : 0.0);
    }
};

CardRow rowOfFit(const CardWork& work, double heading_deg)
{
    const auto magnetic = work.options.by == CardBy::Magnetic ? MagneticHeading::fromDegrees(heading_deg)
                                                              : work.curve->magneticAt(CompassHeading::fromDegrees(heading_deg));
    const Deviation residual = work.curve->deviationAt(magnetic);
    const auto steer = work.options.by == CardBy::Magnetic ? toCompass(magnetic, residual) : CompassHeading::fromDegrees(heading_deg);
    return {magnetic, steer, residual, work.bandOfCurve_rad(magnetic), work.unread(magnetic)};
}

CardRow rowOfReading(const CardWork& work, double heading_deg)
{
    const std::size_t place = nearestReading(work.readings, heading_deg, work.options.by);
    const Deviation residual = work.readings[place].deviation;
    CardRow row;
    row.residual = residual;
    if (work.options.by == CardBy::Magnetic) {
        row.magnetic = MagneticHeading::fromDegrees(heading_deg);
        row.steer = toCompass(row.magnetic, residual);
    } else {
        row.steer = CompassHeading::fromDegrees(heading_deg);
        row.magnetic = toMagnetic(row.steer, residual);
    }
    row.band_rad = work.bandOfReading_rad(place, row.magnetic);
    row.unread = work.unread(row.magnetic);
    return row;
}

std::vector<CardRow> rowsOf(const CardWork& work, int step_deg)
{
    std::vector<CardRow> rows;
    for (int heading_deg = 0; heading_deg < 360; heading_deg += step_deg)
        rows.push_back(work.options.source == CardSource::Fit ? rowOfFit(work, heading_deg) : rowOfReading(work, heading_deg));
    return rows;
}

double evenHeading(const CardRow& row, CardBy by) { return by == CardBy::Magnetic ? row.magnetic.degrees() : row.steer.degrees(); }
double otherHeading(const CardRow& row, CardBy by) { return by == CardBy::Magnetic ? row.steer.degrees() : row.magnetic.degrees(); }

double interpolated_deg(const std::vector<CardRow>& rows, CardBy by, double heading_deg)
{
    const double step_deg = 360.0 / static_cast<double>(rows.size()), place = wrap360(heading_deg) / step_deg;
    const auto before = static_cast<std::size_t>(place) % rows.size();
    const double here_deg = otherHeading(rows[before], by), next_deg = otherHeading(rows[(before + 1) % rows.size()], by);
    return wrap360(here_deg + (place - std::floor(place)) * wrap360(next_deg - here_deg));
}

/// The most by which interpolation is off the curve, and off the readings where the rows are made of them; with its heading.
std::pair<double, double> worstBetween(const CardWork& work, const std::vector<CardRow>& rows)
{
    std::pair<double, double> worst{0, 0};
    const CardBy by = work.options.by;
    const auto hold = [&](double heading_deg, double is_deg, const std::vector<CardRow>& against) {
        const double off_deg = std::abs(wrap180(interpolated_deg(against, by, heading_deg) - is_deg));
        if (off_deg > worst.first)
            worst = {off_deg, heading_deg};
    };
    if (work.curve) {
        CardOptions ofCurve = work.options;
        ofCurve.source = CardSource::Fit;
        const CardWork curve{work.analysis, ofCurve, work.curves, work.curve, {}, work.gaps};
        const auto curveRows = work.options.source == CardSource::Fit ? rows : rowsOf(curve, static_cast<int>(360 / rows.size()));
        for (int heading_deg = 0; heading_deg < 360; ++heading_deg)
            hold(heading_deg,
                by == CardBy::Magnetic ? work.curve->compassAt(MagneticHeading::fromDegrees(heading_deg)).degrees()
                                       : work.curve->magneticAt(CompassHeading::fromDegrees(heading_deg)).degrees(),
                curveRows);
    }
    if (work.options.source == CardSource::Readings)
        for (const auto& reading : work.readings)
            by == CardBy::Magnetic ? hold(reading.magnetic.degrees(), reading.compass.degrees(), rows)
                                   : hold(reading.compass.degrees(), reading.magnetic.degrees(), rows);
    return worst;
}

/// How well the card does between its rows, and which one would do better.
void judgeBetween(Card& card, const CardWork& work)
{
    const auto worst = worstBetween(work, card.rows);
    card.betweenRows_rad = toRadians(worst.first);
    card.betweenRowsAt_deg = worst.second;
    if (worst.first <= kBetweenRows_deg)
        return;
    double least_deg = worst.first;
    for (auto step = kCardSteps_deg.rbegin(); step != kCardSteps_deg.rend(); ++step) {
        if (*step >= card.options.step_deg)
            continue;
        const auto rows = rowsOf(work, *step);
        const auto finer_deg = worstBetween(work, rows).first;
        if (finer_deg >= least_deg || !checkRising(rows, card.options.by))
            continue;
        card.finerStep_deg = *step;
        card.finerBetweenRows_rad = toRadians(least_deg = finer_deg);
        if (finer_deg <= kBetweenRows_deg)
            return;
    }
}

void takeLargest(DeviationThere& largest, Deviation deviation, MagneticHeading at, bool first)
{
    if (first || std::abs(deviation.degrees()) > std::abs(largest.deviation.degrees()))
        largest = {deviation, at};
}

void judgeRows(Card& card, const CardWork& work)
{
    bool known = true;
    for (std::size_t i = 0; i < card.rows.size(); ++i) {
        const CardRow& row = card.rows[i];
        takeLargest(card.largestResidual, row.residual, row.magnetic, i == 0);
        known = known && row.band_rad;
        card.widestBand_rad = std::max(card.widestBand_rad.value_or(0.0), row.band_rad.value_or(0.0));
        if (card.options.source == CardSource::Readings) {
            const auto& nearest = work.readings[nearestReading(work.readings, evenHeading(row, card.options.by), card.options.by)];
            const double there_deg = card.options.by == CardBy::Magnetic ? nearest.magnetic.degrees() : nearest.compass.degrees();
            card.farthestReading_deg = std::max(card.farthestReading_deg, std::abs(wrap180(there_deg - evenHeading(row, card.options.by))));
        }
    }
    card.residualMaxAbs_rad = std::abs(card.largestResidual.deviation.radians());
    if (card.options.source == CardSource::Fit)
        for (int heading_deg = 0; known && heading_deg < 360; ++heading_deg) {
            const auto band = work.bandOfCurve_rad(MagneticHeading::fromDegrees(heading_deg));
            known = band.has_value();
            card.widestBand_rad = std::max(*card.widestBand_rad, band.value_or(0.0));
        }
    if (!known)
        card.widestBand_rad.reset();
}

void judgeReadings(Card& card, const CardWork& work)
{
    for (std::size_t i = 0; i < work.readings.size(); ++i) {
        takeLargest(card.largestReading, work.readings[i].deviation, work.readings[i].magnetic, i == 0);
        const AnalysedReading& reading = work.analysis.readings[i];
        if (!reading.suspect)
            continue;
        const auto& fit = work.analysis.approximate;
        const bool others = fit.fitted() && 1.0 - fit.leverage[i] > 1e-9; // else the curve goes through it whatever it says
        const double off_rad = others ? deletedResidual_rad(fit, i) : 0.0;
        card.suspects.push_back({Deviation::fromRadians(off_rad), reading.magnetic});
    }
    card.largestMisfit_rad = work.analysis.exact.fitted() ? work.analysis.exact.maxAbsResidual_rad : 0.0;
}

Result<CardWork> workOf(const Analysis& analysis, const CardOptions& options)
{
    auto curves = curvesOf(analysis, options.removed);
    if (!curves)
        return curves.error();
    if (options.source == CardSource::Fit && !curves->asLeft)
        return cannotTell(MARKED("core", "the deviation curve"));
    CardWork work{analysis, options, *curves, {}, {}, gapsOf(analysis)};
    if (curves->asLeft) {
        auto curve = CardCurve::of(curves->asLeft);
        if (!curve)
            return curve.error();
        work.curve = std::move(curve.value());
    }
    auto readings = leftReadings(analysis, options, *curves);
    if (!readings)
        return readings.error();
    work.readings = std::move(readings.value());
    return work;
}

BetweenRows between(const CardWork& work, const std::vector<CardRow>& rows, double heading_deg)
{
    BetweenRows between{interpolated_deg(rows, work.options.by, heading_deg), {}};
    if (work.curve)
        between.curve_deg = work.options.by == CardBy::Magnetic
            ? work.curve->compassAt(MagneticHeading::fromDegrees(heading_deg)).degrees()
            : work.curve->magneticAt(CompassHeading::fromDegrees(heading_deg)).degrees();
    return between;
}

int wholeDegrees(double heading_deg) { return static_cast<int>(std::floor(heading_deg + 0.5)) % 360; }

std::string cardHeading(double heading_deg) { return formatHeading(wholeDegrees(heading_deg), AngleStyle::DecimalDegrees, 0); }

} // namespace

int CardRow::steerRounded_deg() const { return wholeDegrees(steer.degrees()); }
int CardRow::magneticRounded_deg() const { return wholeDegrees(magnetic.degrees()); }

Result<void> checkRising(std::span<const CardRow> rows, CardBy by)
{
    double around_deg = 0;
    std::size_t widest = 0;
    std::optional<std::size_t> stops;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double here_deg = otherHeading(rows[i], by), next_deg = otherHeading(rows[(i + 1) % rows.size()], by);
        const double rise_deg = wrap180(next_deg - here_deg);
        around_deg += rise_deg;
        if (rise_deg > wrap180(otherHeading(rows[(widest + 1) % rows.size()], by) - otherHeading(rows[widest], by)))
            widest = i;
        if (!stops && (rise_deg <= 0 || wholeDegrees(here_deg) == wholeDegrees(next_deg)))
            stops = i;
    }
    if (!stops && std::abs(around_deg - 360.0) > 1e-6)
        stops = widest;
    if (!stops)
        return {};
    const CardRow &here = rows[*stops], &next = rows[(*stops + 1) % rows.size()];
    const auto pattern = by == CardBy::Magnetic
        ? MARKED("core",
            "no card: STEER does not rise with FOR: it is %2 for %1 and %4 for %3, so that one reading stands for more than one heading; "
            "expected a compass that rises all the way around")
        : MARKED("core",
            "no card: the magnetic heading does not rise with the compass's: it is %2 for %1 and %4 for %3; expected a compass that rises "
            "all the way around");
    return Error{ErrorCode::Numeric,
        {pattern, cardHeading(evenHeading(here, by)), cardHeading(otherHeading(here, by)), cardHeading(evenHeading(next, by)),
            cardHeading(otherHeading(next, by))}};
}

Result<Card> makeCard(const Analysis& analysis, const CardOptions& options)
{
    if (std::find(kCardSteps_deg.begin(), kCardSteps_deg.end(), options.step_deg) == kCardSteps_deg.end())
        return Error{ErrorCode::InvalidInput, {MARKED("core", "a card has steps of 10°, 15°, 30° or 45°, not %1°"), options.step_deg}};
    if (auto fault = faultOf(analysis.approximate, analysis.exact)) // one reading that is far astray, named as a slip
        return *std::move(fault);
    const auto work = workOf(analysis, options);
    if (!work)
        return work.error();
    Card card;
    card.options = options;
    card.gaps = work->gaps;
    card.index_deg = options.removed.test(indexOf(Coefficient::A)) ? 0.0 : toDegrees(analysis.approximate.index_rad);
    card.rows = rowsOf(*work, options.step_deg);
    if (const auto rising = checkRising(card.rows, options.by); !rising)
        return rising.error();
    if (options.removed.none()) { // a smooth curve through readings that fold may rise all the same
        std::vector<Observation> read;
        for (const AnalysedReading& reading : analysis.readings)
            read.push_back({reading.magnetic, reading.compass});
        if (const auto fold = foldOf(read))
            return Error{ErrorCode::Numeric, foldWords(*fold)};
    }
    for (auto& row : card.rows)
        row.halfway = between(*work, card.rows, evenHeading(row, options.by) + options.step_deg / 2.0);
    judgeRows(card, *work);
    judgeReadings(card, *work);
    judgeBetween(card, *work);
    return card;
}

Result<BetweenRows> betweenRows(const Analysis& analysis, const Card& card, double heading_deg)
{
    const auto work = workOf(analysis, card.options);
    if (!work)
        return work.error();
    return between(*work, card.rows, heading_deg);
}

} // namespace lubberline
