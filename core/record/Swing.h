#pragma once
/// A swing as it was recorded: raw readings are the truth and are kept for ever; results are recomputed from them.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/earth/FieldStamp.h"
#include "core/record/Id.h"
#include "core/record/RawFigures.h"
#include "core/record/SharedErrors.h"
#include "core/record/Signature.h"

namespace lubberline {

enum class SwingKind { Check, Correction, Calibration, Air, NotStated };
enum class SwingStage { AsFound, AsLeft, NotStated };
/// draft → complete → signed; what is signed is frozen.
enum class SwingState { Draft, Complete, Signed };

/// Why a reading is left out of the results; it stays on the record.
struct Exclusion {
    std::string reason; ///< never empty
    friend bool operator==(const Exclusion&, const Exclusion&) = default;
};

/// One row of a swing. Both headings are kept as read; deviation is derived.
struct Reading {
    ReadingId id;
    std::optional<double> nominal_deg;       ///< the heading that the crew turned to, magnetic [deg]
    std::optional<MagneticHeading> magnetic; ///< the datum's reading; empty while it is being entered
    std::optional<CompassHeading> compass;   ///< the compass's reading; empty while it is being entered
    std::optional<TrueHeading> trueHeading;  ///< as read, where the datum was true; magnetic is then computed from it
    std::optional<double> pitch_deg;         ///< nose up positive
    std::optional<double> roll_deg;          ///< starboard wing down positive
    RawFigures raw;                          ///< what the headings are the means of, where more than one figure was read
    std::string timeUtc;                     ///< ISO 8601; empty: not stated
    std::string note;
    std::optional<Exclusion> exclusion;
    std::vector<std::pair<std::string, std::string>> extra; ///< unknown columns of the file it came from, kept

    [[nodiscard]] bool complete() const { return magnetic && compass; }
    [[nodiscard]] bool used() const { return complete() && !exclusion; }
    friend bool operator==(const Reading&, const Reading&) = default;
};

/// Whether radio receivers were on: a card has a column for each (14 CFR 25.1547).
enum class RadioState { NotStated, On, Off };

/// The state of the aircraft while it was swung.
struct Configuration {
    RadioState radio = RadioState::NotStated;
    std::string engines;   ///< "running, 1500 rpm"
    std::string electrics; ///< loads on and off
    std::string other;     ///< gear, flaps, doors, stores, attitude
    friend bool operator==(const Configuration&, const Configuration&) = default;
};

/// The instrument that gave the magnetic headings.
struct Datum {
    std::string instrument;
    std::string serialNumber;
    Date calibrationDue;      ///< empty: none stated
    std::string readOut = {}; ///< how its figures were taken, in words: "from ahead, reciprocal; zero +0.3°"
    friend bool operator==(const Datum&, const Datum&) = default;
};

struct People {
    std::string datumReader;
    std::string cockpitReader;
    std::string adjuster;
    std::string inspector;
    friend bool operator==(const People&, const People&) = default;
};

struct Swing {
    SwingId id;
    RecordId record = {};
    CompassId compass;
    SiteId site; ///< not valid: not stated
    Date date;   ///< UTC
    SwingKind kind = SwingKind::Check;
    SwingStage stage = SwingStage::AsFound;
    SwingState state = SwingState::Draft;
    Configuration configuration;
    Datum datum;
    People people;
    std::optional<double> variation_deg;    ///< used to make magnetic of true headings; east positive
    std::optional<double> indexRemoved_deg; ///< A taken out by turning the compass in its mount after these readings; east positive
    SharedErrors sharedErrors;              ///< of datum, variation, delay and wind
    std::string procedure;
    std::string startUtc, endUtc; ///< ISO 8601; empty: not stated
    std::string siteOverride;     ///< why it was swung there although the site or the datum was out of date; empty: it was not
    std::string weather;          ///< wind, temperature, magnetic activity
    RecordId job;                 ///< the guided swing that made it (core/record/SwingJob.h); empty: none
    RecordId supersedes;          ///< the signed swing that this one amends; empty: none
    std::string amendment;        ///< why; never empty where it supersedes
    int revision = 1;
    std::string workOrder;
    std::string reason;
    std::string note;
    std::optional<FieldStamp> field;   ///< the Earth's field that it was computed with; none: not stated
    std::vector<Signature> signatures; ///< in the order in which they were given
    std::vector<Reading> readings;     ///< in the order in which they were entered
    friend bool operator==(const Swing&, const Swing&) = default;
};

/// The indices of the readings that results are computed from: complete and not excluded.
[[nodiscard]] std::vector<std::size_t> usedReadings(const Swing& swing);

/// A swing of more readings than this is refused: it is not a swing, and memory must not be taken for it.
inline constexpr std::size_t kMaxReadings = 1'000'000;

} // namespace lubberline
