#include "core/record/SwingDifferences.h"

#include <array>
#include <cstdio>

namespace lubberline {

namespace {

constexpr std::array kKinds{"check", "correction", "calibration", "air"};
constexpr std::array kStages{"as found", "as left"};
constexpr std::array kRadio{"not stated", "on", "off"};

std::string number(std::optional<double> value)
{
    if (!value)
        return {};
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", *value);
    return text;
}

template <class Heading>
std::string heading(const std::optional<Heading>& value)
{
    return value ? number(value->degrees()) : std::string();
}

std::string figures(const std::vector<double>& values)
{
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : " ") + number(value);
    return text;
}

class Differences {
public:
    void add(const std::string& what, const std::string& before, const std::string& after)
    {
        if (before != after)
            m_all.push_back({what, before, after});
    }
    std::vector<SwingDifference> take() { return std::move(m_all); }

private:
    std::vector<SwingDifference> m_all;
};

void compareParticulars(Differences& all, const Swing& before, const Swing& after)
{
    all.add("date", before.date, after.date);
    all.add("kind", kKinds[static_cast<std::size_t>(before.kind)], kKinds[static_cast<std::size_t>(after.kind)]);
    all.add("stage", kStages[static_cast<std::size_t>(before.stage)], kStages[static_cast<std::size_t>(after.stage)]);
    if (before.site != after.site)
        all.add("site", "another", "changed");
    all.add(
        "radio", kRadio[static_cast<std::size_t>(before.configuration.radio)], kRadio[static_cast<std::size_t>(after.configuration.radio)]);
    all.add("engines", before.configuration.engines, after.configuration.engines);
    all.add("electrics", before.configuration.electrics, after.configuration.electrics);
    all.add("configuration", before.configuration.other, after.configuration.other);
    all.add("datum", before.datum.instrument, after.datum.instrument);
    all.add("datum serial number", before.datum.serialNumber, after.datum.serialNumber);
    all.add("datum calibration due", before.datum.calibrationDue, after.datum.calibrationDue);
    all.add("datum read-out", before.datum.readOut, after.datum.readOut);
    all.add("datum reader", before.people.datumReader, after.people.datumReader);
    all.add("cockpit reader", before.people.cockpitReader, after.people.cockpitReader);
    all.add("adjuster", before.people.adjuster, after.people.adjuster);
    all.add("inspector", before.people.inspector, after.people.inspector);
    all.add("variation", number(before.variation_deg), number(after.variation_deg));
    all.add("index removed", number(before.indexRemoved_deg), number(after.indexRemoved_deg));
    all.add("procedure", before.procedure, after.procedure);
    all.add("start", before.startUtc, after.startUtc);
    all.add("end", before.endUtc, after.endUtc);
    all.add("site override", before.siteOverride, after.siteOverride);
    all.add("weather", before.weather, after.weather);
    all.add("work order", before.workOrder, after.workOrder);
    all.add("reason", before.reason, after.reason);
    all.add("note", before.note, after.note);
    all.add("field model", before.field ? before.field->model : std::string(), after.field ? after.field->model : std::string());
    if (before.field && after.field && before.field != after.field && before.field->model == after.field->model)
        all.add("field", "another place, day or value", "changed");
}

void compareReading(Differences& all, const std::string& which, const Reading& before, const Reading& after)
{
    all.add(which + ", nominal", number(before.nominal_deg), number(after.nominal_deg));
    all.add(which + ", magnetic", heading(before.magnetic), heading(after.magnetic));
    all.add(which + ", compass", heading(before.compass), heading(after.compass));
    all.add(which + ", true", heading(before.trueHeading), heading(after.trueHeading));
    all.add(which + ", time", before.timeUtc, after.timeUtc);
    all.add(which + ", pitch", number(before.pitch_deg), number(after.pitch_deg));
    all.add(which + ", roll", number(before.roll_deg), number(after.roll_deg));
    all.add(which + ", datum figures", figures(before.raw.datum_deg), figures(after.raw.datum_deg));
    all.add(which + ", astern figures", figures(before.raw.astern_deg), figures(after.raw.astern_deg));
    all.add(which + ", compass figures", figures(before.raw.compass_deg), figures(after.raw.compass_deg));
    all.add(which + ", excluded", before.exclusion ? before.exclusion->reason : std::string(),
        after.exclusion ? after.exclusion->reason : std::string());
    all.add(which + ", note", before.note, after.note);
}

} // namespace

std::vector<SwingDifference> differencesBetween(const Swing& before, const Swing& after)
{
    Differences all;
    compareParticulars(all, before, after);
    const std::size_t rows = std::max(before.readings.size(), after.readings.size());
    static const Reading kNone;
    for (std::size_t i = 0; i < rows; ++i)
        compareReading(all, "reading " + std::to_string(i + 1), i < before.readings.size() ? before.readings[i] : kNone,
            i < after.readings.size() ? after.readings[i] : kNone);
    return all.take();
}

} // namespace lubberline
