#include "core/format/csv/SensorLogColumns.h"

#include <algorithm>
#include <set>

#include "core/base/FileText.h"
#include "core/base/Middle.h"
#include "core/base/Number.h"

namespace lubberline::csv {

namespace {

constexpr std::array<std::string_view, 7> kKeys{"time", "bx", "by", "bz", "heading", "pitch", "roll"};

/// What a unit is called in headers; µ is written by either of its two code points.
std::optional<FieldUnit> unitOf(std::string_view word)
{
    static const std::map<std::string, FieldUnit, std::less<>> kWords{{"nt", FieldUnit::Nanotesla}, {"ut", FieldUnit::Microtesla},
        {"\u00B5t", FieldUnit::Microtesla}, {"\u03BCt", FieldUnit::Microtesla}, {"mg", FieldUnit::Milligauss},
        {"mgauss", FieldUnit::Milligauss}, {"milligauss", FieldUnit::Milligauss}, {"g", FieldUnit::Gauss}, {"gauss", FieldUnit::Gauss},
        {"microtesla", FieldUnit::Microtesla}, {"nanotesla", FieldUnit::Nanotesla}, {"counts", FieldUnit::Counts},
        {"raw", FieldUnit::Counts}, {"lsb", FieldUnit::Counts}};
    const auto found = kWords.find(word);
    return found == kWords.end() ? std::nullopt : std::optional(found->second);
}

struct Words {
    std::string base; ///< small letters, without the unit, without what parts words
    std::string unit;
};

/// "Magnetic Field x (µT)" → "magneticfieldx", "µt"; "bx_nT" → "bx", "nt".
Words wordsOf(std::string_view name)
{
    std::string small = inSmallLetters(trimmed(name));
    Words words;
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}})
        if (const auto at = small.find(open); at != std::string::npos && small.ends_with(close)) {
            words.unit = small.substr(at + 1, small.size() - at - 2);
            small.erase(at);
        }
    if (words.unit.empty())
        if (const auto at = small.find_last_of("_ "); at != std::string::npos && at + 1 < small.size()) {
            const std::string last = small.substr(at + 1);
            if (unitOf(last) || last == "deg" || last == "degrees" || last == "s" || last == "ms" || last == "us" || last == "ns") {
                words.unit = last;
                small.erase(at);
            }
        }
    std::erase_if(small, [](char c) { return c == '_' || c == ' ' || c == '.' || c == '-'; });
    words.base = std::move(small);
    return words;
}

std::optional<LogRole> roleOf(const Words& words)
{
    static const std::set<std::string, std::less<>> kTime{"time", "t", "times", "timestamp", "secondselapsed", "seconds", "elapsed",
        "timesincestart", "timesincestartin", "zeit", "czas"}; // telephones head their columns in their owner's language, too
    static const std::set<std::string, std::less<>> kHeading{"heading", "magneticheading", "yaw", "referenceheading", "psi"};
    if (kTime.contains(words.base))
        return LogRole::Time;
    if (kHeading.contains(words.base))
        return LogRole::Heading;
    if (words.base == "pitch")
        return LogRole::Pitch;
    if (words.base == "roll" || words.base == "bank")
        return LogRole::Roll;
    static const std::set<std::string, std::less<>> kBefore{"", "b", "m", "mag", "magnetometer", "magneticfield", "field", "rawmag",
        "magraw", "h", "calibratedmag", "uncalibratedmag", "magx", "compass", "magnetfeld", "polemagnetyczne"};
    if (words.base.empty())
        return {};
    const char axis = words.base.back();
    if (axis >= 'x' && axis <= 'z' && kBefore.contains(std::string_view(words.base).substr(0, words.base.size() - 1)))
        return static_cast<LogRole>(static_cast<int>(LogRole::X) + (axis - 'x'));
    return {};
}

/// The range of |B| on the Earth's surface, 22 000 … 67 000 nT, in each unit: no two overlap.
std::optional<FieldUnit> unitBySize(double size)
{
    for (const FieldUnit unit : {FieldUnit::Microtesla, FieldUnit::Milligauss, FieldUnit::Gauss, FieldUnit::Nanotesla})
        if (const double size_nT = size * nanoteslaPer(unit); size_nT >= 22000 && size_nT <= 67000)
            return unit;
    return {};
}

double medianSize(const SensorLog& log)
{
    std::vector<double> sizes;
    const std::size_t step = std::max<std::size_t>(1, log.size() / 20000);
    for (std::size_t row = 0; row < log.size(); row += step)
        if (log.hasField(row))
            sizes.push_back(log.at(row).norm());
    if (sizes.empty())
        return 0;
    return middleOf(std::move(sizes));
}

bool wholeNumbers(const SensorLog& log)
{
    for (std::size_t row = 0; row < std::min<std::size_t>(log.size(), 2000); ++row)
        for (const auto& axis : log.field)
            if (std::isfinite(axis[row]) && axis[row] != std::round(axis[row]))
                return false;
    return true;
}

std::string sizeText(double size) { return figureText(size, size < 10 ? 3 : size < 1000 ? 1 : 0); }

} // namespace

std::string_view keyOf(LogRole role) { return kKeys[static_cast<std::size_t>(role)]; }

std::optional<std::size_t> LogHeader::place(LogRole role) const
{
    const auto found = std::find(roles.begin(), roles.end(), role);
    return found == roles.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - roles.begin()));
}

Result<LogHeader> logHeaderOf(const std::vector<std::string>& names, const SensorLogOptions& options)
{
    LogHeader header;
    header.names = names;
    header.keys = names;
    header.roles.assign(names.size(), LogRole::Other);
    std::array<std::optional<std::string>, 7> takenBy;
    std::map<std::string, FieldUnit> units;
    const auto take = [&](std::size_t column, LogRole role) -> Result<void> {
        auto& other = takenBy[static_cast<std::size_t>(role)];
        if (other)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "two columns are %1: %2 and %3; expected one"), keyOf(role), inQuotes(*other), inQuotes(names[column])}};
        other = names[column];
        header.roles[column] = role;
        const Words words = wordsOf(names[column]);
        if (role == LogRole::Time)
            header.timeUnitNamed = !words.unit.empty() || words.base == "seconds" || words.base == "secondselapsed";
        if (role == LogRole::Time && words.unit == "ms")
            header.perSecond = 1e3;
        if (role == LogRole::Time && (words.unit == "us" || words.unit == "\u00B5s"))
            header.perSecond = 1e6;
        if (role == LogRole::Time && words.unit == "ns")
            header.perSecond = 1e9;
        if (role < LogRole::X || role > LogRole::Z)
            return {};
        header.ourNames = header.ourNames || words.base.starts_with('b');
        units.emplace(words.unit, unitOf(words.unit).value_or(FieldUnit::Counts));
        if (const auto unit = unitOf(words.unit))
            header.unit = unit;
        return {};
    };
    for (const auto& [key, wanted] : options.columns) {
        const auto role = std::find(kKeys.begin(), kKeys.end(), key);
        const auto column = std::find(names.begin(), names.end(), wanted);
        if (column == names.end())
            return Error{ErrorCode::InvalidInput, {MARKED("core", "there is no column %1 for %2"), inQuotes(wanted), key}};
        if (role == kKeys.end())
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "%1 is nothing that a column can be; expected time, bx, by, bz, heading, pitch or roll"), inQuotes(key)}};
        if (auto taken = take(static_cast<std::size_t>(column - names.begin()), static_cast<LogRole>(role - kKeys.begin())); !taken)
            return taken.error();
    }
    // Our own names come first: a file may have bx_nT and x both.
    for (const bool ours : {true, false})
        for (std::size_t column = 0; column < names.size(); ++column) {
            if (header.roles[column] != LogRole::Other)
                continue;
            constexpr std::string_view kCurrent = "current_a:";
            if (inSmallLetters(names[column]).starts_with(kCurrent)) {
                header.roles[column] = LogRole::Current;
                header.keys[column] = std::string(trimmed(std::string_view(names[column]).substr(kCurrent.size())));
                continue;
            }
            const Words words = wordsOf(names[column]);
            const auto role = roleOf(words);
            const bool ourName = role && words.base == keyOf(*role);
            if (!role || ourName != ours || (!ours && takenBy[static_cast<std::size_t>(*role)]))
                continue;
            if (auto taken = take(column, *role); !taken)
                return taken.error();
        }
    for (const LogRole axis : {LogRole::X, LogRole::Y, LogRole::Z})
        if (!header.place(axis))
            return Error{ErrorCode::InvalidInput,
                {MARKED(
                     "core", "has no column %1; expected bx_nT, by_nT, bz_nT (or _uT, _mG, _G, or no unit for counts), or say which it is"),
                    keyOf(axis)}};
    if (units.size() > 1 && !options.unit)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "the axes are in different units: %1, %2, %3; expected one"), inQuotes(names[*header.place(LogRole::X)]),
                inQuotes(names[*header.place(LogRole::Y)]), inQuotes(names[*header.place(LogRole::Z)])}};
    return header;
}

void takeTime(SensorLog& log, const LogHeader& header)
{
    if (header.timeUnitNamed || log.time_s.size() < 2)
        return;
    std::vector<double> steps;
    for (std::size_t row = 1; row < std::min<std::size_t>(log.time_s.size(), 20000); ++row)
        if (log.time_s[row] > log.time_s[row - 1])
            steps.push_back(log.time_s[row] - log.time_s[row - 1]);
    if (steps.empty())
        return;
    const double step = middleOf(std::move(steps)), first = log.time_s.front();
    // Clocks that count from 1970 in ms and us; else no sensor is read once in a quarter of an hour, or of eleven days.
    const bool milliseconds = first > 1e12 && first < 1e13 && step<1e5, microseconds = first> 1e15 && first < 1e16 && step < 5e6;
    const double perSecond = milliseconds ? 1e3 : microseconds ? 1e6 : step > 1e6 ? 1e9 : step > 1e3 ? 1e6 : 1.0;
    if (perSecond == 1.0)
        return;
    const double zero = first / perSecond > 1e8 ? first : 0.0;
    for (double& time : log.time_s)
        time = (time - zero) / perSecond;
    log.warnings.push_back(
        {zero != 0 ? MARKED("core", "the time column names no unit; its steps of %1 are taken for %2, counted from the first row")
                   : MARKED("core", "the time column names no unit; its steps of %1 are taken for %2"),
            figureText(step, 0),
            std::string(perSecond == 1e9 ? "ns"
                    : perSecond == 1e6   ? "us"
                                         : "ms")});
}

void takeUnit(SensorLog& log, const LogHeader& header, const SensorLogOptions& options)
{
    const double size = medianSize(log);
    const auto likely = unitBySize(size);
    if (options.unit) {
        log.unit = *options.unit;
        log.unitReason = {MARKED("core", "as chosen")};
    } else if (header.unit) {
        log.unit = *header.unit;
        log.unitReason = {MARKED("core", "the column names say so")};
    } else if (!header.ourNames && likely && !wholeNumbers(log)) {
        log.unit = *likely;
        log.unitReason = {MARKED("core", "the field's size, %1, lies where the Earth's field does in %2"), sizeText(size), nameOf(*likely)};
        log.warnings.push_back(
            {MARKED("core", "the columns name no unit; taken for %1: the field's size, %2, lies where the Earth's field does in that unit"),
                nameOf(*likely), sizeText(size)});
    } else {
        log.unit = FieldUnit::Counts;
        log.unitReason = {MARKED("core", "the columns name no unit: raw counts")};
        if (likely)
            log.warnings.push_back(
                {MARKED("core",
                     "the columns name no unit and are taken for raw counts; their size, %1, would fit %2: choose that unit if it is"),
                    sizeText(size), nameOf(*likely)});
    }
    if (log.unit != FieldUnit::Counts && size > 0) {
        const double size_nT = size * nanoteslaPer(log.unit);
        if ((size_nT < 5000 || size_nT > 200000) && likely && *likely != log.unit)
            log.warnings.push_back({MARKED("core", "the field's size is %1 %2, which is no field of the Earth; it would be one in %3"),
                sizeText(size), nameOf(log.unit), nameOf(*likely)});
    }
    if (const double factor = nanoteslaPer(log.unit); factor != 1.0)
        for (auto& axis : log.field)
            for (auto& value : axis)
                value *= factor;
}

} // namespace lubberline::csv
