#pragma once
/// Short ways to read and make what the format tests are about.

#include <sstream>
#include <string>
#include <vector>

#include "core/format/csv/SwingCsv.h"
#include "core/record/SensorRecord.h"

namespace lubberline::test {

inline const std::string kHeader = "magnetic_heading_deg,compass_heading_deg\n";

inline Result<SwingFile> readCsv(const std::string& text)
{
    std::istringstream stream(text);
    return readSwingCsv(stream, "swing.csv");
}

/// The magnetic headings, in order [deg].
inline std::vector<double> magnetic_deg(const SwingFile& file)
{
    std::vector<double> headings;
    for (const auto& reading : file.swing.readings)
        headings.push_back(reading.magnetic->degrees());
    return headings;
}

inline std::vector<double> compass_deg(const SwingFile& file)
{
    std::vector<double> headings;
    for (const auto& reading : file.swing.readings)
        headings.push_back(reading.compass->degrees());
    return headings;
}

/// One of each record, with every field stated.
inline SwingRecord wholeRecord()
{
    SwingRecord record;
    record.type = {AircraftTypeId{1}, "11111111-1111-4111-8111-111111111111", "PZL-130", "PZL", "a \"type\" note"};
    record.aircraft = {AircraftId{1}, "22222222-2222-4222-8222-222222222222", AircraftTypeId{1}, "SP-TST", "sn 7", "an operator", 1994,
        "note\nof two lines", true};
    record.compass = {CompassId{1}, "33333333-3333-4333-8333-333333333333", AircraftId{1}, "standby compass",
        CompassKind::RemoteUnstabilised, Compensator::Screws, "maker", "part", "serial", "fin", 0.5, LimitsProfileId{1}};
    record.site = Site{
        SiteId{1}, "44444444-4444-4444-8444-444444444444", "D\u0119blin", 51.55, 21.89, 117.0, 7.25, "certificate, 2026.0", "hard stand"};
    record.limits
        = LimitsProfile{LimitsProfileId{1}, "55555555-5555-4555-8555-555555555555", "ten", "14 CFR 25.1327", "issue", "scope", 10.0, 5.0};
    Swing& swing = record.swing;
    swing.id = SwingId{1};
    swing.record = "66666666-6666-4666-8666-666666666666";
    swing.compass = CompassId{1};
    swing.site = SiteId{1};
    swing.date = "2024-02-29";
    swing.kind = SwingKind::Calibration;
    swing.stage = SwingStage::AsLeft;
    swing.state = SwingState::Signed;
    swing.configuration = {RadioState::Off, "running", "pitot heat on", "doors closed"};
    swing.datum = {"theodolite", "T-1", "2027-01-31"};
    swing.people = {"A", "B", "C", "D"};
    swing.variation_deg = 7.25;
    swing.procedure = "8 points";
    swing.workOrder = "WO 1";
    swing.reason = "yearly";
    swing.note = "calm";
    Reading full;
    full.nominal_deg = 0.0;
    full.magnetic = MagneticHeading::fromDegrees(359.1);
    full.compass = CompassHeading::fromDegrees(2.7);
    full.trueHeading = TrueHeading::fromDegrees(6.35);
    full.pitch_deg = -1.5;
    full.roll_deg = 0.1;
    full.note = "gust; \"twice\", \xC5\xBC";
    full.exclusion = Exclusion{"door open"};
    full.extra = {{"temperature_C", "11,5"}, {"wind", "W 4"}};
    Reading plain;
    plain.magnetic = MagneticHeading::fromDegrees(0.1 + 0.2); // not a short number
    plain.compass = CompassHeading::fromDegrees(359.99999999999994);
    swing.readings = {full, plain};
    return record;
}

/// Figures with as many digits as a model gives, and one that no short decimal is.
inline FieldStamp wholeStamp() { return {"WMM2025", {51.55, 21.89, 117.0}, "2024-02-29", {18879.125, 2311.0625, 0.1 + 0.2}}; }

/// One that was entered, with a circuit, and one of an iron bench with a moving part.
inline std::vector<SensorRecord> wholeSensors()
{
    SensorRecord entered;
    entered.id = SensorModelId{1};
    entered.record = "88888888-8888-4888-8888-888888888888";
    entered.compass = CompassId{1};
    entered.name = "as entered";
    entered.note = "from the \"paper\"";
    entered.model.softIron << 0.01, 0.002, -0.003, 0.004, -0.02, 0.006, 0.007, 1.0 / 3.0, 0.009;
    entered.model.hardIron_nT = {850, -420, 0.1};
    entered.model.softConstant_nT = {1, 2, 3};
    entered.model.circuits = {{"landing light", {12.5, -3, 0}, 10, true}, {"pitot heat", {1, 0, 0}, 4, false}};
    entered.model.misalignment = {0.01, -0.02, 0.03};
    SensorRecord bench = entered;
    bench.id = SensorModelId{2};
    bench.record = "99999999-9999-4999-8999-999999999999";
    bench.name = "iron bench";
    bench.origin = ModelOrigin::IronBench;
    bench.bench = IronBench{{-2, 0, -1},
        {{"gear leg", Cylinder{0.08, 0.9}, 50, {0, 0, 0.1}, "gear",
             {{"retracted", {0, 0, 1}, 0, 0, 0}, {"extended", {0, 0, 1.5}, 0, 1.25, 0}}},
            {"box", Box{{0.1, 0.2, 0.3}}, 5, {0, 0, 0}, "", {{"", {1, 1, 1}, 0, 0, 0}}}},
        {{"heater", {WirePath{{{0, 0, 0}, {1, 0, 0}}}, CurrentLoop{{1, 0, 0}, {0, 0, 1}, 0.1, 3}}, 2, true}}};
    bench.benchStates = {{"gear", "extended"}};
    return {entered, bench};
}

} // namespace lubberline::test
