#include "core/record/SwingDifferences.h"

#include <cstdio>

#include "core/record/RecordWords.h"

namespace lubberline {

namespace {

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
    void add(const Message& what, const std::string& before, const std::string& after)
    {
        add(what, Message::verbatim(before), Message::verbatim(after));
    }
    void add(const Message& what, Date before, Date after) { add(what, before.text(), after.text()); }
    template <class Choice>
    requires std::is_enum_v<Choice>
    void add(const Message& what, Choice before, Choice after) { add(what, Message(shownWord(before)), Message(shownWord(after))); }
    void add(const Message& what, const Message& before, const Message& after)
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
    all.add(MARKED("core", "date"), before.date, after.date);
    all.add(MARKED("core", "kind"), before.kind, after.kind);
    all.add(MARKED("core", "stage"), before.stage, after.stage);
    if (before.site != after.site)
        all.add(MARKED("core", "site"), Message(MARKED("core", "another")), MARKED("core", "changed"));
    all.add(MARKED("core", "radio"), before.configuration.radio, after.configuration.radio);
    all.add(MARKED("core", "engines"), before.configuration.engines, after.configuration.engines);
    all.add(MARKED("core", "electrics"), before.configuration.electrics, after.configuration.electrics);
    all.add(MARKED("core", "configuration"), before.configuration.other, after.configuration.other);
    all.add(MARKED("core", "datum"), before.datum.instrument, after.datum.instrument);
    all.add(MARKED("core", "datum serial number"), before.datum.serialNumber, after.datum.serialNumber);
    all.add(MARKED("core", "datum calibration due"), before.datum.calibrationDue, after.datum.calibrationDue);
    all.add(MARKED("core", "datum read-out"), before.datum.readOut, after.datum.readOut);
    all.add(MARKED("core", "datum reader"), before.people.datumReader, after.people.datumReader);
    all.add(MARKED("core", "cockpit reader"), before.people.cockpitReader, after.people.cockpitReader);
    all.add(MARKED("core", "adjuster"), before.people.adjuster, after.people.adjuster);
    all.add(MARKED("core", "inspector"), before.people.inspector, after.people.inspector);
    all.add(MARKED("core", "variation"), number(before.variation_deg), number(after.variation_deg));
    all.add(MARKED("core", "index removed"), number(before.indexRemoved_deg), number(after.indexRemoved_deg));
    all.add(MARKED("core", "errors that readings share"), textOf(before.sharedErrors), textOf(after.sharedErrors));
    all.add(MARKED("core", "procedure"), before.procedure, after.procedure);
    all.add(MARKED("core", "start"), before.startUtc, after.startUtc);
    all.add(MARKED("core", "end"), before.endUtc, after.endUtc);
    all.add(MARKED("core", "site override"), before.siteOverride, after.siteOverride);
    all.add(MARKED("core", "weather"), before.weather, after.weather);
    all.add(MARKED("core", "work order"), before.workOrder, after.workOrder);
    all.add(MARKED("core", "reason"), before.reason, after.reason);
    all.add(MARKED("core", "note"), before.note, after.note);
    all.add(MARKED("core", "field model"), before.field ? before.field->model : std::string(),
        after.field ? after.field->model : std::string());
    if (before.field && after.field && before.field != after.field && before.field->model == after.field->model)
        all.add(MARKED("core", "field"), Message(MARKED("core", "another place, day or value")), MARKED("core", "changed"));
}

void compareReading(Differences& all, std::size_t which, const Reading& before, const Reading& after)
{
    all.add({MARKED("core", "reading %1, nominal"), which}, number(before.nominal_deg), number(after.nominal_deg));
    all.add({MARKED("core", "reading %1, magnetic"), which}, heading(before.magnetic), heading(after.magnetic));
    all.add({MARKED("core", "reading %1, compass"), which}, heading(before.compass), heading(after.compass));
    all.add({MARKED("core", "reading %1, true"), which}, heading(before.trueHeading), heading(after.trueHeading));
    all.add({MARKED("core", "reading %1, time"), which}, before.timeUtc, after.timeUtc);
    all.add({MARKED("core", "reading %1, pitch"), which}, number(before.pitch_deg), number(after.pitch_deg));
    all.add({MARKED("core", "reading %1, roll"), which}, number(before.roll_deg), number(after.roll_deg));
    all.add({MARKED("core", "reading %1, datum figures"), which}, figures(before.raw.datum_deg), figures(after.raw.datum_deg));
    all.add({MARKED("core", "reading %1, astern figures"), which}, figures(before.raw.astern_deg), figures(after.raw.astern_deg));
    all.add({MARKED("core", "reading %1, compass figures"), which}, figures(before.raw.compass_deg), figures(after.raw.compass_deg));
    all.add({MARKED("core", "reading %1, excluded"), which}, before.exclusion ? before.exclusion->reason : std::string(),
        after.exclusion ? after.exclusion->reason : std::string());
    all.add({MARKED("core", "reading %1, note"), which}, before.note, after.note);
}

} // namespace

std::vector<SwingDifference> differencesBetween(const Swing& before, const Swing& after)
{
    Differences all;
    compareParticulars(all, before, after);
    const std::size_t rows = std::max(before.readings.size(), after.readings.size());
    static const Reading kNone;
    for (std::size_t i = 0; i < rows; ++i)
        compareReading(
            all, i + 1, i < before.readings.size() ? before.readings[i] : kNone, i < after.readings.size() ? after.readings[i] : kNone);
    return all.take();
}

} // namespace lubberline
