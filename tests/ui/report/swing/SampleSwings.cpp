#include "tests/ui/report/swing/SampleSwings.h"

#include <cmath>
#include <random>

#include "core/deviation/Smith.h"
#include "core/swing/Observations.h"

namespace lubberline::test {

namespace {

Reading reading(double magnetic_deg, double compass_deg)
{
    Reading r;
    r.magnetic = MagneticHeading::fromDegrees(magnetic_deg);
    r.compass = CompassHeading::fromDegrees(compass_deg);
    return r;
}

Site sampleSite()
{
    Site site;
    site.record = recordIdFor("site");
    site.name = "Compass base 2, Dęblin";
    site.latitude_deg = 51.5544;
    site.longitude_deg = 21.8936;
    site.elevation_m = 121;
    site.variation_deg = 6.25;
    site.variationSource = "WMM2025, 2026.9";
    return site;
}

LimitsProfile transportLimits()
{
    LimitsProfile limits;
    limits.record = recordIdFor("limits");
    limits.name = "Transport aeroplanes";
    limits.document = "14 CFR 25.1327";
    limits.issue = "2026";
    limits.scope = "after compensation, level flight, any heading";
    limits.maxDeviation_deg = 10;
    return limits;
}

} // namespace

const std::array<WorksheetSwing, 3> kWorksheet{{
    {{{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}}, 3, {1, 43, 89, 137, 181, 223, 269, 317}},
    {{{318, 316}, {1, 0}, {49, 47}, {92, 89}, {137, 135}, {182, 181}, {229, 227}, {276, 273}}, 2, {1, 45, 89, 135, 181, 225, 269, 315}},
    {{{317, 316}, {0, 358}, {48, 47}, {89, 89}, {136, 135}, {183, 181}, {224, 223}, {270, 270}}, 1, {359, 45, 91, 135, 179, 225, 271, 315}},
}};

const std::array<double, 8> kNga501Deviation_deg{10.5, 20.0, 11.5, -1.2, -5.5, -8.0, -12.5, -6.8};

SwingRecord emptyRecord()
{
    SwingRecord record;
    record.type.record = recordIdFor("type");
    record.type.name = "Su-22";
    record.type.maker = "Sukhoi";
    record.aircraft.record = recordIdFor("aircraft");
    record.aircraft.registration = "SP-XYZ";
    record.aircraft.serialNumber = "37130";
    record.aircraft.operatorName = "Repair plant No. 2";
    record.aircraft.builtYear = 1985;
    record.compass.record = recordIdFor("compass");
    record.compass.name = "standby compass";
    record.compass.maker = "SIRS";
    record.compass.partNumber = "NV2C-2420-3";
    record.compass.serialNumber = "20117";
    record.compass.location = "windscreen frame";
    record.compass.compensator = Compensator::Screws;
    record.swing.record = "0f3c1d52-77b1-5a90-8c55-6d2c6f2a9d10";
    record.swing.date = "2026-11-20";
    record.swing.state = SwingState::Complete;
    record.swing.configuration = {RadioState::On, "running, 1500 rpm", "normal loads on, windscreen heat off", "flaps up, doors closed"};
    record.swing.datum = {"landing compass", "LC-0441", "2027-03-01"};
    record.swing.people = {"A. Nowak", "B. Zielińska", "C. Wójcik", "D. Kamiński"};
    record.swing.procedure = "MM 34-20-01";
    record.swing.workOrder = "WO 26/1187";
    record.swing.reason = "yearly check";
    record.site = sampleSite();
    record.limits = transportLimits();
    return record;
}

SwingRecord worksheetRecord(const WorksheetSwing& swing)
{
    SwingRecord record = emptyRecord();
    for (const auto& [magnetic_deg, compass_deg] : swing.readings_deg)
        record.swing.readings.push_back(reading(magnetic_deg, compass_deg));
    return record;
}

SwingRecord nga501Record()
{
    SwingRecord record = emptyRecord();
    for (std::size_t i = 0; i < kNga501Deviation_deg.size(); ++i) {
        const double compass_deg = 45.0 * static_cast<double>(i);
        record.swing.readings.push_back(reading(compass_deg + kNga501Deviation_deg[i], compass_deg));
    }
    return record;
}

SwingRecord simulatedRecord(int points, double scale)
{
    SwingRecord record = emptyRecord();
    std::minstd_rand bits(static_cast<unsigned>(points)); // the same on every machine; the distribution is our own
    const ApproximateSmith smith{
        toRadians(0.4 * scale), toRadians(2.6 * scale), toRadians(-1.8 * scale), toRadians(0.9 * scale), toRadians(-0.3 * scale)};
    for (int i = 0; i < points; ++i) {
        const double nominal_deg = 360.0 * i / points;
        const auto compass = compassHeadingFor(smith, MagneticHeading::fromDegrees(nominal_deg));
        const double noise_deg = (static_cast<double>(bits() % 1000) / 1000.0 - 0.5) * 0.8;
        Reading r = reading(nominal_deg, std::round((compass.value().degrees() + noise_deg) * 10) / 10);
        r.nominal_deg = nominal_deg;
        record.swing.readings.push_back(r);
    }
    return record;
}

ui::ReportInput reportOf(const SwingRecord& record)
{
    ui::ReportInput input;
    input.record = record;
    input.analysis = analyse(observationsOf(record.swing)).value();
    input.madeAtUtc = "2026-11-23T06:00:00Z";
    return input;
}

ui::CardInput cardOf(const SwingRecord& record, const CardOptions& options, const QString& heading)
{
    ui::CardInput input;
    input.columns = {{heading, makeCard(analyse(observationsOf(record.swing)).value(), options).value(), record, true, false}};
    input.madeAtUtc = "2026-11-23T06:00:00Z";
    return input;
}

} // namespace lubberline::test
