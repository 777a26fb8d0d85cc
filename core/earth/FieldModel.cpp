#include "core/earth/FieldModel.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <GeographicLib/MagneticModel.hpp>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/earth/FieldModelData.h"
#include "core/earth/FieldTables.h"

namespace lubberline {

namespace {

/// Constants of a model's report; the declination's grows as H shrinks.
struct StatedUncertainty {
    const char* model;
    FieldUncertainty at;
    double declinationFloor_deg, declinationByHorizontal_degnT;
};
constexpr std::array kStated{
    StatedUncertainty{"WMM2025", {137, 89, 141, 133, 138, 0.20, 0}, 0.26, 5417}, // WMM2025 technical report, section 3.4
    StatedUncertainty{"WMM2020", {131, 94, 157, 128, 148, 0.21, 0}, 0.26, 5625}, // WMM2020 technical report, section 3.4
};

std::optional<FieldUncertainty> uncertaintyOf(const std::string& model, double horizontal_nT)
{
    for (const auto& stated : kStated) {
        if (model != stated.model)
            continue;
        FieldUncertainty uncertainty = stated.at;
        const double byHorizontal = horizontal_nT > 0.0 ? stated.declinationByHorizontal_degnT / horizontal_nT : 180.0;
        uncertainty.declination_deg = std::min(180.0, std::hypot(stated.declinationFloor_deg, byHorizontal));
        return uncertainty;
    }
    return {};
}

/// "2025", "2026.9".
std::string yearText(double year) { return std::isfinite(year) ? shortestNumber(std::round(year * 1e4) / 1e4) : "not a number"; }

Error outside(const std::string& model, double firstYear, double lastYear, double year)
{
    return {ErrorCode::InvalidInput,
        {MARKED("core", "%1 is valid from %2 to %3, and the date is %4"), model, yearText(firstYear), yearText(lastYear), yearText(year)}};
}

FieldModel modelOf(const FieldTable& table) { return FieldModel(std::make_shared<const FieldModel::Data>(table)); }

void warnOfSmallHorizontal(FieldAnswer& answer, double horizontal_nT)
{
    if (horizontal_nT >= kCautionHorizontal_nT)
        return;
    answer.warnings.push_back(horizontal_nT < kBlackoutHorizontal_nT
            ? MARKED("core", "blackout zone: H is below 2000 nT, a compass is not to be used")
            : MARKED("core", "caution zone: H is below 6000 nT, declination and compasses are unreliable"));
}

/// "2026.9"; text with two hyphens is a date.
Result<double> decimalYearNumber(const std::string& text)
{
    const FileNumber number = readNumber(text);
    if (number.fault != NumberFault::None || number.value < 1000.0 || number.value >= 10000.0)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "%1 is no date; expected YYYY-MM-DD, or a year as 2026.5"), inQuotes(text)}};
    return number.value;
}

} // namespace

FieldModel::FieldModel(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}
const std::string& FieldModel::name() const { return m_data->name; }
double FieldModel::firstYear() const { return m_data->firstYear; }
double FieldModel::lastYear() const { return m_data->lastYear; }
int FieldModel::degree() const { return m_data->degree; }

Result<FieldAnswer> FieldModel::evaluate(const Place& place, double year) const
{
    if (!std::isfinite(year) || year < firstYear() || year > lastYear())
        return outside(name(), firstYear(), lastYear(), year);
    const auto [field, rate] = m_data->model.at(year, place);
    double horizontal = 0, total = 0, declination = 0, inclination = 0;
    FieldAnswer answer;
    GeographicLib::MagneticModel::FieldComponents(field.east_nT, field.north_nT, -field.down_nT, rate.east_nT, rate.north_nT, -rate.down_nT,
        horizontal, total, declination, inclination, answer.horizontalRate_nT, answer.totalRate_nT, answer.declinationRate_deg,
        answer.inclinationRate_deg);
    answer.model = name();
    answer.place = place;
    answer.year = year;
    answer.field = field;
    answer.rate = rate;
    answer.uncertainty = uncertaintyOf(name(), horizontal);
    warnOfSmallHorizontal(answer, horizontal);
    return answer;
}

FieldModel wmm2025()
{
    static const FieldModel model = modelOf(wmm2025Table());
    return model;
}

FieldModel igrf14()
{
    static const FieldModel model = modelOf(igrf14Table());
    return model;
}

Result<FieldModel> readFieldModel(const std::string& path)
{
    const auto table = readFieldTable(path);
    if (!table)
        return table.error();
    return modelOf(*table);
}

Result<FieldModel> fieldModelByName(const std::string& nameOrPath)
{
    std::string plain;
    for (const char c : nameOrPath)
        if (c != '-' && c != '_' && c != ' ')
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (plain == "wmm2025" || plain == "wmm")
        return wmm2025();
    if (plain == "igrf14" || plain == "igrf")
        return igrf14();
    return readFieldModel(nameOrPath);
}

Result<FieldModel> defaultFieldModel(double year)
{
    const FieldModel newest = wmm2025(), older = igrf14();
    for (const FieldModel& model : {newest, older})
        if (year >= model.firstYear() && year <= model.lastYear())
            return model;
    return Error{ErrorCode::InvalidInput,
        {MARKED("core", "%1 is valid from %2 to %3 and %4 from %5 to %6; the date is %7"), newest.name(), yearText(newest.firstYear()),
            yearText(newest.lastYear()), older.name(), yearText(older.firstYear()), yearText(older.lastYear()), yearText(year)}};
}

Result<FieldAnswer> fieldForCompass(const FieldModel& model, const Place& place, double year)
{
    auto answer = model.evaluate(place, year);
    if (!answer)
        return answer;
    const double horizontal = answer->field.horizontal_nT();
    if (horizontal < kBlackoutHorizontal_nT)
        return Error{ErrorCode::Numeric,
            {MARKED("core", "H is %1 nT there, below 2000 nT (blackout zone): a compass tells nothing"), std::lround(horizontal)}};
    return answer;
}

double yearOf(Date day)
{
    using namespace std::chrono;
    const auto first = [](year one) { return sys_days(one / January / 1); };
    const year_month_day date = day.day();
    const auto days = (first(date.year() + years(1)) - first(date.year())).count();
    return static_cast<int>(date.year()) + static_cast<double>((sys_days(date) - first(date.year())).count()) / static_cast<double>(days);
}

Result<double> decimalYear(const std::string& text)
{
    if (std::count(text.begin(), text.end(), '-') != 2)
        return decimalYearNumber(text);
    const auto day = Date::read(text);
    if (!day)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "%1 is no day of the calendar; expected YYYY-MM-DD"), inQuotes(text)}};
    return yearOf(*day);
}

Result<FieldStamp> stampField(const FieldModel& model, const Place& place, Date day)
{
    const auto answer = fieldForCompass(model, place, yearOf(day));
    if (!answer)
        return answer.error();
    return FieldStamp{answer->model, place, day, answer->field};
}

Result<FieldStamp> stampField(const Place& place, Date day)
{
    const auto model = defaultFieldModel(yearOf(day));
    return model ? stampField(*model, place, day) : Result<FieldStamp>(model.error());
}

} // namespace lubberline
