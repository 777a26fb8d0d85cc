#include "core/format/csv/InflightCsv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/angle/Angle.h"
#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/FigureCsv.h"
#include "core/inflight/WindVector.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostLegs = 10'000;
constexpr std::array kLegSpeeds{UnitSuffix{"_kt", 1}, UnitSuffix{"_m_s", 3600.0 / 1852.0}, UnitSuffix{"_km_h", 1000.0 / 1852.0}};
constexpr std::array<std::string_view, 5> kLegsKnown{"track_deg", "ground_speed", "compass_heading_deg", "leg", "variation_deg"};
constexpr std::array<std::string_view, 6> kContinuousKnown{
    "time_s", "compass_heading_deg", "reference_heading_deg", "deviation_deg", "leg", "current_a:"};

/// Cells of a row by their columns, with the error of the first that is none.
class FigureRow {
public:
    explicit FigureRow(const FigureCsv& csv) : m_csv(csv) {}
    /// NaN where the column or the figure is missing.
    double figure(const std::optional<std::size_t>& place)
    {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (place && !m_csv.figure(*place, value) && !m_error)
            m_error = m_csv.noFigure(*place);
        return value;
    }
    double required(const std::optional<std::size_t>& place, double least, double most, const Message& expected)
    {
        const double value = figure(place);
        if (!m_error && !(value >= least && value <= most))
            m_error
                = m_csv.here({MARKED("core", "%1 is %2; expected %3"), m_csv.columns()[*place], inQuotes(m_csv.cell(*place)), expected});
        return value;
    }
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    const FigureCsv& m_csv;
    std::optional<Error> m_error;
};

Error columnMissing(const FigureCsv& csv, std::string_view name, const Message& expected)
{
    return csv.here({MARKED("core", "there is no column %1; expected %2"), inQuotes(name), expected});
}

/// Sums of one leg, in the order in which legs come first.
struct LegSums {
    Leg leg;
    Eigen::Vector2d ground = Eigen::Vector2d::Zero(), compass = Eigen::Vector2d::Zero();
    double variation_deg = 0, onlyCompass_deg = 0;
    int rows = 0, compasses = 0, variations = 0;
};

} // namespace

Result<LegsFile> readLegsCsv(std::istream& input, const std::string& name, const Progress& progress)
{
    const Message expected
        = MARKED("core", "track_deg and ground_speed_kt, and leg, compass_heading_deg and variation_deg where they are known");
    FigureCsv csv(input, name, MARKED("core", "a Legs CSV: track_deg, ground_speed_kt, a leg or a part of one a row"), progress);
    if (const auto header = csv.readHeader(kLegsKnown); !header)
        return header.error();
    const auto speed = csv.column("ground_speed", kLegSpeeds);
    if (!speed)
        return speed.error();
    const auto track = csv.column("track_deg"), compass = csv.column("compass_heading_deg"), variation = csv.column("variation_deg"),
               leg = csv.column("leg");
    if (!track)
        return columnMissing(csv, "track_deg", expected);
    if (!*speed)
        return columnMissing(csv, "ground_speed_kt", expected);
    std::vector<LegSums> sums;
    std::map<std::string, std::size_t, std::less<>> places;
    for (;;) {
        const auto more = csv.next();
        if (!more)
            return more.error();
        if (!*more)
            break;
        FigureRow row(csv);
        const double track_deg = row.required(track, -180, 360, MARKED("core", "0 to 360"));
        const double speed_kt = (*speed)->factor * row.required((*speed)->place, 0, 3000, MARKED("core", "a speed over ground"));
        const double compass_deg = row.figure(compass), variation_deg = row.figure(variation);
        if (row.error())
            return *row.error();
        if (leg && !csv.isName(*leg))
            return csv.noName(*leg);
        const std::string legName = leg ? std::string(csv.cell(*leg)) : std::to_string(sums.size() + 1);
        const auto [place, isNew] = places.try_emplace(legName, sums.size());
        if (isNew && sums.size() == kMostLegs)
            return csv.here(
                {MARKED("core", "there are more than %1 legs; expected a column leg that says which rows belong together"), kMostLegs});
        if (isNew)
            sums.emplace_back().leg.name = legName;
        LegSums& one = sums[place->second];
        one.ground += velocityOf(track_deg, speed_kt);
        ++one.rows;
        if (std::isfinite(compass_deg)) {
            one.compass += velocityOf(compass_deg, 1.0);
            one.onlyCompass_deg = compass_deg;
            ++one.compasses;
        }
        if (std::isfinite(variation_deg)) {
            one.variation_deg += variation_deg;
            ++one.variations;
        }
    }
    LegsFile file;
    for (auto& one : sums) {
        const Eigen::Vector2d ground = one.ground / one.rows;
        one.leg.track_deg = directionOf_deg(ground);
        one.leg.groundSpeed_kt = ground.norm();
        one.leg.samples = one.rows;
        if (one.compasses > 0)
            one.leg.compassHeading_deg = one.compasses > 1 ? directionOf_deg(one.compass) : wrap360(one.onlyCompass_deg); // as it was read
        if (one.variations > 0)
            one.leg.variation_deg = one.variation_deg / one.variations;
        file.legs.push_back(std::move(one.leg));
    }
    return file;
}

Result<LegsFile> readLegsCsvFile(const std::string& path, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "a Legs CSV"));
    return file ? readLegsCsv(**file, nameOfInput(path), progress) : Result<LegsFile>(file.error());
}

Result<ContinuousFile> readContinuousCsv(std::istream& input, const std::string& name, ContinuousOptions options, const Progress& progress)
{
    const Message expected = MARKED("core", "time_s, compass_heading_deg, and reference_heading_deg (magnetic) or deviation_deg");
    FigureCsv csv(input, name, MARKED("core", "a log: time_s, compass_heading_deg, and reference_heading_deg or deviation_deg"), progress);
    if (const auto header = csv.readHeader(kContinuousKnown); !header)
        return header.error();
    const auto time = csv.column("time_s"), compass = csv.column("compass_heading_deg"), reference = csv.column("reference_heading_deg"),
               deviation = csv.column("deviation_deg"), error = csv.column("reference_error_deg"), leg = csv.column("leg");
    for (const auto& [place, column] : {std::pair{time, "time_s"}, {compass, "compass_heading_deg"}})
        if (!place)
            return columnMissing(csv, column, expected);
    if (!reference && !deviation)
        return columnMissing(csv, "reference_heading_deg", expected);
    std::vector<std::optional<std::size_t>> currents;
    options.loads.clear();
    constexpr std::string_view kCurrent = "current_a:";
    for (std::size_t i = 0; i < csv.columns().size(); ++i)
        if (csv.columns()[i].starts_with(kCurrent)) {
            currents.emplace_back(i);
            options.loads.push_back(csv.columns()[i].substr(kCurrent.size()));
        }
    const bool whole = options.wholeModelOver_nT.has_value();
    const auto pitch = csv.column("pitch_deg"), roll = csv.column("roll_deg"), horizontal = csv.column("horizontal_nt"),
               dip = csv.column("dip_deg");
    if (whole)
        for (const auto& [place, column] :
            {std::pair{pitch, "pitch_deg"}, {roll, "roll_deg"}, {horizontal, "horizontal_nT"}, {dip, "dip_deg"}})
            if (!place)
                return columnMissing(
                    csv, column, MARKED("core", "pitch_deg, roll_deg, horizontal_nT and dip_deg for the whole sensor model"));
    const auto kMostLoads = static_cast<std::size_t>((kMostStates - coreStates(whole)) / 2);
    if (currents.size() > kMostLoads)
        return csv.here({MARKED("core", "there are %1 loads; expected %2 at most"), currents.size(), kMostLoads});
    if (options.start && options.start->loads.empty() && !options.loads.empty())
        options.start = withLoads(*options.start, options.loads);
    if (options.start && options.start->loads != options.loads)
        return csv.here(
            MARKED("core", "the state that was kept has other electrical loads than this log; expected the same current_A columns"));
    if (options.start && options.start->horizontal_nT.has_value() != whole)
        return csv.wholeFile(
            MARKED("core", "is to go on from a state of another kind; expected both A to E, or both the whole sensor model"));
    std::optional<ContinuousSwing> swing; // P, Q and R of a whole model are counted over the H of the first row, or of the state before
    if (whole && options.start)
        options.wholeModelOver_nT = options.start->horizontal_nT;
    const bool overFirst = whole && !options.start;
    ContinuousFile file;
    double last_s = -std::numeric_limits<double>::infinity();
    std::int64_t missing = 0, rows = 0;
    std::size_t legs = 0;
    std::string lastLeg;
    for (;;) {
        const auto more = csv.next();
        if (!more)
            return more.error();
        if (!*more)
            break;
        ++rows;
        FigureRow row(csv);
        ContinuousSample sample;
        sample.time_s = row.required(time, -1e15, 1e15, MARKED("core", "seconds"));
        sample.compassHeading_deg = row.figure(compass);
        const double reference_deg = row.figure(reference), deviation_deg = row.figure(deviation), error_deg = row.figure(error);
        for (const auto& place : currents) {
            const double current = row.figure(place);
            sample.current_A.push_back(std::isfinite(current) ? current : 0.0);
        }
        if (whole) {
            sample.at.pitch_deg = row.figure(pitch);
            sample.at.roll_deg = row.figure(roll);
            const double horizontal_nT = row.figure(horizontal), dip_deg = row.figure(dip);
            sample.at.field = MeridianField::fromDip(horizontal_nT, toRadians(dip_deg));
            const bool known = std::isfinite(sample.at.pitch_deg + sample.at.roll_deg + horizontal_nT + dip_deg);
            if (!row.error() && known && (std::abs(sample.at.pitch_deg) > 90 || std::abs(sample.at.roll_deg) > 180))
                return csv.here(MARKED("core", "pitch_deg or roll_deg is out of range; expected -90 to 90, and -180 to 180"));
            if (!row.error() && known && (!(horizontal_nT >= 500 && horizontal_nT <= 50'000) || std::abs(dip_deg) > 89))
                return csv.here(MARKED("core", "horizontal_nT or dip_deg is out of range; expected 500 to 50000 nT, and -89 to 89"));
            if (!known)
                sample.compassHeading_deg = std::numeric_limits<double>::quiet_NaN();
        }
        if (row.error())
            return *row.error();
        if (sample.time_s < last_s)
            return csv.here({MARKED("core", "time_s goes back to %1; expected times in order"), inQuotes(csv.cell(*time))});
        last_s = sample.time_s;
        if (!std::isfinite(sample.compassHeading_deg) || (!std::isfinite(reference_deg) && !std::isfinite(deviation_deg))) {
            ++missing;
            continue;
        }
        for (const double heading : {sample.compassHeading_deg, reference_deg})
            if (heading < -180 || heading > 360)
                return csv.here(MARKED("core", "a heading is outside 0 to 360; expected degrees"));
        if (error_deg <= 0)
            return csv.here(MARKED("core", "reference_error_deg is not above 0; expected a standard deviation"));
        sample.deviation_deg = std::isfinite(deviation_deg) ? wrap180(deviation_deg) : wrap180(reference_deg - sample.compassHeading_deg);
        if (std::isfinite(error_deg))
            sample.referenceError_deg = error_deg;
        if (leg && !csv.isName(*leg))
            return csv.noName(*leg);
        if (leg && (legs == 0 || lastLeg != csv.cell(*leg))) {
            if (++legs > kMostLegs)
                return csv.here({MARKED("core", "there are more than %1 legs; expected those of a flight, each of many rows"), kMostLegs});
            lastLeg = csv.cell(*leg);
        }
        if (leg)
            sample.leg = lastLeg;
        if (!swing) {
            if (overFirst)
                options.wholeModelOver_nT = sample.at.field.horizontal_nT;
            swing.emplace(options);
        }
        swing->add(sample);
    }
    if (!swing)
        return csv.wholeFile(MARKED("core", "holds no pair of headings; expected a compass and a reference heading a row"));
    file.result = swing->finish();
    switch (takenBefore(file.result.log, options.start ? options.start->logs : std::vector<TakenLog>())) {
    case TakenBefore::Nothing: break;
    case TakenBefore::Whole:
        return Error{ErrorCode::InvalidInput,
            MARKED("core", "is in the state already, and would count twice; expected a log that was not taken yet"), name};
    case TakenBefore::Beginning:
        file.warnings.push_back(
            MARKED("core", "it begins with the readings of a log that is in the state already: what both of them hold counts twice"));
        break;
    case TakenBefore::Time:
        file.warnings.push_back(
            MARKED("core", "it overlaps in time with a log that is in the state already: what both of them hold counts twice"));
        break;
    }
    if (missing > 0)
        file.warnings.push_back({whole ? MARKED_N("core", "%n row(s) without headings, attitude or field passed over")
                                       : MARKED_N("core", "%n row(s) without a compass or reference heading passed over"),
            missing});
    file.warnings.insert(file.warnings.end(), file.result.warnings.begin(), file.result.warnings.end());
    return file;
}

Result<ContinuousFile> readContinuousCsvFile(const std::string& path, ContinuousOptions options, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "a log of headings"));
    return file ? readContinuousCsv(**file, nameOfInput(path), std::move(options), progress) : Result<ContinuousFile>(file.error());
}

} // namespace lubberline
