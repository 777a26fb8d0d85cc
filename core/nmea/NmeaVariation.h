#pragma once
/// Which variation a log's true headings are made magnetic with, and how far it may be trusted; the date of a log, and why it may be
/// doubted.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/base/Result.h"
#include "core/nmea/NmeaLog.h"

namespace lubberline {

struct VariationOfLog {};   ///< what RMC or HDG say
struct VariationOfModel {}; ///< WMM or IGRF at the log's position and date
struct VariationFound {};   ///< the log's where it has one, else the model's
using NmeaVariation = std::variant<VariationFound, Variation, VariationOfLog, VariationOfModel>;

/// The day of a log. Receivers that miss the turn of the GPS week count (1024 weeks) are 19.6 years behind.
struct NmeaDate {
    Date date;    ///< empty: not told
    Date perhaps; ///< the day that it may mean; empty: nothing better is known
    std::vector<Message> doubts;
};
/// @param stated by the user; empty: the log's own. @param today of the user's clock; empty: not known, the future is not doubted.
[[nodiscard]] NmeaDate dateOfLog(const NmeaLog& log, Date stated, Date today);

struct ChosenVariation {
    Variation variation;
    std::string source;              ///< "stated", "log", "WMM2025 at 60.0°N 24.8°E on 2026-11-23"
    std::optional<double> model_deg; ///< the model's at the log's place and date; none: no place, no date, no model
    double standardError_deg = 0;
    std::vector<Message> warnings;
};
/// The log's and the stated one are held against the model: more than a degree apart is told. @param stated_deg how far the user trusts
/// the variation (a base that was surveyed, a magnetic storm), 0: not stated.
/// Errors: InvalidInput: none can be found; those of the field models.
Result<ChosenVariation> chooseVariation(const NmeaLog& log, const NmeaVariation& wanted, const NmeaDate& date, double stated_deg);

} // namespace lubberline
