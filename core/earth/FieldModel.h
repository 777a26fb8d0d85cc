#pragma once
/// Spherical-harmonic models of the main field, summed by GeographicLib. Ours is the reading of the
/// published files (WMM and WMMHR `.COF`, IGRF coefficient tables), validity, uncertainty and cautions. WMM2025 (NOAA/BGS,
/// public domain) and IGRF-14 (IAGA V-MOD, CC BY 4.0, doi 10.5281/zenodo.14012302) are built in.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/base/Result.h"
#include "core/earth/EarthField.h"
#include "core/earth/FieldStamp.h"

namespace lubberline {

/// One standard deviation, as the model's report states it.
struct FieldUncertainty {
    double north_nT = 0, east_nT = 0, down_nT = 0, horizontal_nT = 0, total_nT = 0;
    double inclination_deg = 0;
    double declination_deg = 0; ///< grows where H is small
};

/// A model's answer.
struct FieldAnswer {
    std::string model;
    Place place;
    double year = 0; ///< decimal
    EarthField field;
    EarthField rate;                                         ///< X, Y, Z [nT a year]
    double horizontalRate_nT = 0, totalRate_nT = 0;          ///< a year
    double declinationRate_deg = 0, inclinationRate_deg = 0; ///< a year
    std::optional<FieldUncertainty> uncertainty;             ///< none where the model states none
    std::vector<Message> warnings;                           ///< caution: H < 6000 nT makes declination unreliable
};

/// Below, a compass tells nothing: refused (WMM2025 report: blackout zone).
inline constexpr double kBlackoutHorizontal_nT = 2000.0;
/// Below, a warning (caution zone).
inline constexpr double kCautionHorizontal_nT = 6000.0;

/// A loaded model; cheap to copy, may be used by several threads at once.
class FieldModel {
public:
    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] double firstYear() const; ///< decimal years, both ends are valid
    [[nodiscard]] double lastYear() const;
    [[nodiscard]] int degree() const;

    /// The field whatever H is: for maps of the world and for a bench that wants a place near a pole.
    /// Errors: InvalidInput (year outside the model's years: names them).
    Result<FieldAnswer> evaluate(const Place& place, double year) const;

    struct Data; ///< core/earth/FieldModelData.h: for the sources of this folder
    explicit FieldModel(std::shared_ptr<const Data> data);
    [[nodiscard]] const Data& data() const { return *m_data; }

private:
    std::shared_ptr<const Data> m_data;
};

/// Built in; made on first use.
FieldModel wmm2025();
FieldModel igrf14();

/// Reads a WMM or WMMHR `.COF` (header: epoch, name, date; five years) or an IGRF table (c/s deg ord …). Told apart by content.
/// Errors: Io; Format with the line: cut short, coefficients out of order, doubled or missing, not a number, no header.
Result<FieldModel> readFieldModel(const std::string& path);

/// "wmm2025", "igrf14" (case and hyphen do not matter), or the path of a coefficient file. Errors: as above; NotFound.
Result<FieldModel> fieldModelByName(const std::string& nameOrPath);

/// WMM where the year is inside its years, else IGRF-14. Errors: InvalidInput outside both: names the years.
Result<FieldModel> defaultFieldModel(double year);

/// evaluate(), refused where H < 2000 nT. Errors: those of evaluate(); Numeric in the blackout zone, with H.
Result<FieldAnswer> fieldForCompass(const FieldModel& model, const Place& place, double year);

/// A stated day → decimal year; it is taken at its beginning, as WMM's own programs do: year + (day of year − 1) / days of the year.
[[nodiscard]] double yearOf(Date day);
/// "2026-11-23" or "2026.9" → decimal year. Errors: InvalidInput (no such day; not a date).
Result<double> decimalYear(const std::string& text);

/// The field of a swing by the default model of its date (or by `model`). Errors: those of the above.
Result<FieldStamp> stampField(const Place& place, Date day);
Result<FieldStamp> stampField(const FieldModel& model, const Place& place, Date day);

} // namespace lubberline
