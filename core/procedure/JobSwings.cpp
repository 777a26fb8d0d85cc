// What the events of a guided swing make of its readings.

#include <algorithm>
#include <cmath>
#include <map>

#include "core/procedure/JobState.h"

#include "core/base/Number.h"
#include "core/record/Completeness.h"

namespace lubberline {

namespace {

/// The reading that counts is the last one that was taken there: with its figures as they were read, and when.
void addRaw(Reading& reading, const SwingJob& job, std::size_t station)
{
    for (auto event = job.events.rbegin(); event != job.events.rend(); ++event)
        if (const auto* taken = std::get_if<job::ReadingTaken>(&event->what); taken && taken->station == static_cast<int>(station)) {
            reading.raw = taken->raw;
            reading.timeUtc = event->timeUtc;
            reading.note = taken->note;
            if (reading.compass && std::abs(wrap180(reading.compass->degrees() - taken->compass_deg)) > 1e-9)
                reading.note += (reading.note.empty() ? "" : "; ")
                    + ("read after the compass was turned in its mount, by "
                        + signedFigureText(wrap180(taken->compass_deg - reading.compass->degrees()), 1) + "° more than it says here");
            return;
        }
}

Reading toReading(const SwingJob& job, const JobState& state, std::size_t place)
{
    const StationState& station = state.stations[place];
    Reading reading;
    reading.nominal_deg = station.station.nominal_deg;
    if (station.reading) {
        reading.magnetic = station.reading->magnetic;
        reading.compass = station.reading->compass;
        addRaw(reading, job, place);
    }
    if (!station.skipped.empty())
        reading.note = "skipped: " + station.skipped;
    return reading;
}

/// Where the instrument was changed on the way, every one that was used is named, with its headings.
template <class Wanted>
void nameDatums(Swing& swing, const SwingJob& job, const JobState& state, Wanted wanted)
{
    const DatumInstrument* datum = &job.datum;
    std::map<int, const DatumInstrument*> usedAt; // of the reading that counts
    for (const JobEvent& event : job.events) {
        if (const auto* changed = std::get_if<job::DatumChanged>(&event.what))
            datum = &changed->datum;
        else if (const auto* taken = std::get_if<job::ReadingTaken>(&event.what))
            usedAt[taken->station] = datum;
    }
    std::vector<std::pair<const DatumInstrument*, std::string>> used; // each once, with its headings
    for (const auto& [place, instrument] : usedAt) {
        const Station& station = state.stations[static_cast<std::size_t>(place)].station;
        if (!wanted(station))
            continue;
        const auto found
            = std::find_if(used.begin(), used.end(), [&, one = instrument](const auto& other) { return *other.first == *one; });
        const std::string heading = figureText(station.nominal_deg, 0) + "°";
        if (found == used.end())
            used.emplace_back(instrument, heading);
        else
            found->second += ", " + heading;
    }
    if (used.empty() || (used.size() == 1 && *used.front().first == job.datum))
        return;
    swing.datum = {};
    for (const auto& [instrument, headings] : used) {
        const std::string where = used.size() > 1 ? " (" + headings + ")" : std::string();
        const auto join = [](std::string& all, const std::string& more) { all += (all.empty() || more.empty() ? "" : "; ") + more; };
        join(swing.datum.instrument, instrument->name + where);
        join(swing.datum.serialNumber, instrument->serialNumber);
        if (!instrument->calibrationDue.empty()
            && (swing.datum.calibrationDue.empty() || instrument->calibrationDue < swing.datum.calibrationDue))
            swing.datum.calibrationDue = instrument->calibrationDue;
    }
    swing.datum.readOut = job.particulars.datum.readOut;
}

/// Whether turning this control changes what the compass reads on a heading.
bool actsOn(Control control, double nominal_deg)
{
    const double heading = toRadians(nominal_deg);
    if (control == Control::Index)
        return true;
    return std::abs(control == Control::NorthSouth ? std::cos(heading) : std::sin(heading)) > 0.01;
}

/// "radio on", "Radio off, lights on": the card has a column for each state.
RadioState radioIn(std::string words, RadioState otherwise)
{
    std::transform(
        words.begin(), words.end(), words.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (words.find("radio on") != std::string::npos || words.find("radios on") != std::string::npos)
        return RadioState::On;
    return words.find("radio off") != std::string::npos || words.find("radios off") != std::string::npos ? RadioState::Off : otherwise;
}

/// The particulars without what the job itself made of them: those of a finished swing state the index that was taken out at
/// its end.
Swing bare(const SwingJob& job)
{
    Swing swing = job.particulars;
    swing.indexRemoved_deg.reset();
    swing.readings.clear();
    swing.signatures.clear();
    return swing;
}

} // namespace

Swing asFoundSwing(const SwingJob& job, const JobState& state)
{
    Swing swing = bare(job);
    swing.kind = SwingKind::Correction;
    swing.stage = SwingStage::AsFound;
    std::vector<Control> turned; // at the stations before this one
    for (std::size_t place = 0; place < state.stations.size(); ++place) {
        const auto& station = state.stations[place];
        if (station.station.phase != StationPhase::AsFound)
            break;
        const auto acts = [&](Control control) { return actsOn(control, station.station.nominal_deg); };
        if (std::none_of(turned.begin(), turned.end(), acts))
            swing.readings.push_back(toReading(job, state, place));
        for (const auto& correction : station.station.corrections)
            turned.push_back(correction.control);
    }
    return swing;
}

Swing asLeftSwing(const SwingJob& job, const JobState& state, int configuration)
{
    Swing swing = bare(job);
    swing.kind = SwingKind::Check;
    swing.stage = job.plan.kind == ProcedureKind::CheckOnly ? SwingStage::AsFound : SwingStage::AsLeft;
    if (configuration > 0) {
        swing.configuration.other = job.plan.configurations[static_cast<std::size_t>(configuration) - 1];
        swing.configuration.radio = radioIn(swing.configuration.other, swing.configuration.radio);
    }
    if (configuration == 0)
        swing.indexRemoved_deg = state.indexRemoved_deg;
    nameDatums(swing, job, state, [&](const Station& station) {
        return station.phase == (configuration > 0 ? StationPhase::Configuration : StationPhase::Check)
            && station.configuration == configuration;
    });
    for (std::size_t place = 0; place < state.stations.size(); ++place) {
        const auto& station = state.stations[place];
        const bool wanted = station.station.phase == (configuration > 0 ? StationPhase::Configuration : StationPhase::Check)
            && station.station.configuration == configuration;
        if (wanted)
            swing.readings.push_back(toReading(job, state, place));
    }
    return swing;
}

std::vector<Swing> furtherSwings(const SwingJob& job, const JobState& state, const Swing& main, Date today)
{
    std::vector<Swing> others;
    const auto add = [&](Swing swing) {
        swing.id = {};
        swing.record.clear();
        swing.startUtc = main.startUtc;
        swing.endUtc = main.endUtc;
        if (missingIn(swing, today).empty())
            swing.state = SwingState::Complete; // nothing is added to it any more
        others.push_back(std::move(swing));
    };
    if (job.plan.kind != ProcedureKind::CheckOnly)
        add(asFoundSwing(job, state));
    for (int configuration = 1; configuration <= static_cast<int>(job.plan.configurations.size()); ++configuration)
        add(asLeftSwing(job, state, configuration));
    return others;
}

std::vector<ResidualRow> residualsOf(const JobState& state, int configuration)
{
    std::vector<ResidualRow> rows;
    const double removed = configuration == 0 ? state.indexRemoved_deg.value_or(0.0) : 0.0;
    for (const auto& station : state.stations) {
        const bool wanted = station.station.phase != StationPhase::AsFound && station.station.phase != StationPhase::Correct
            && station.station.configuration == configuration;
        if (!wanted || !station.reading || station.voided)
            continue;
        const double read = deviationOf(station.reading->magnetic, station.reading->compass).degrees(), residual = wrap180(read - removed);
        rows.push_back({station.station.nominal_deg, read, residual, wrap360(station.station.nominal_deg - residual)});
    }
    return rows;
}

} // namespace lubberline
