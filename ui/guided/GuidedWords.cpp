#include "ui/guided/GuidedWords.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/procedure/SkipCost.h"
#include "ui/guided/GuidedJob.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::GuidedWords)
};

QString phaseWord(const GuidedJob& job)
{
    switch (job.state().phase) {
    case JobPhase::Prepare: return Words::tr("Preparation");
    case JobPhase::Index: return Words::tr("Index");
    case JobPhase::Review: return Words::tr("Review");
    case JobPhase::Card: return Words::tr("Finished");
    case JobPhase::Fault: return Words::tr("Fault");
    case JobPhase::Abandoned: return Words::tr("Abandoned");
    case JobPhase::Stations: break;
    }
    const Station& station = job.station()->station;
    switch (station.phase) {
    case StationPhase::AsFound: return station.corrections.empty() ? Words::tr("As found") : Words::tr("Correction");
    case StationPhase::Correct: return Words::tr("Correction");
    case StationPhase::Check: return Words::tr("Check swing");
    case StationPhase::Configuration: break;
    }
    return toText(job.job().plan.configurations[static_cast<std::size_t>(station.configuration - 1)]);
}

QString letterOf(Control control)
{
    return control == Control::NorthSouth ? QStringLiteral("C") : control == Control::EastWest ? QStringLiteral("B") : QStringLiteral("A");
}

} // namespace

QString procedureMeaning(ProcedureKind kind)
{
    switch (kind) {
    case ProcedureKind::Coefficient:
        return Words::tr(
            "Read N, E, S and W; on S the N–S screw takes out C, on W the E–W screw takes out B; check swing; A by turning the compass "
            "in its mount (worksheet to CAP 562).");
    case ProcedureKind::HalfError:
        return Words::tr(
            "On N and E all of the error is taken out, on S and W half of what is left; check swing; A by turning the compass in its mount "
            "(Barfield 56-101-01200).");
    case ProcedureKind::IndexFirst:
        return Words::tr("Read N, E, S and W; the mount is turned by their mean, then B on W and C on N; check swing.");
    case ProcedureKind::FluxValve:
        return Words::tr("Read N, E, S and W untouched; the flux valve is turned by their mean, then C on N and B on E; check swing "
                         "(Duncan Aviation, after MIL-STD-765A practice).");
    case ProcedureKind::CheckOnly: return Words::tr("Nothing is touched: the check swing alone.");
    }
    return {};
}

QString stationHeading(double nominal_deg)
{
    static const std::array<QString, 8> kNames{
        Words::tr("N"), Words::tr("NE"), Words::tr("E"), Words::tr("SE"), Words::tr("S"), Words::tr("SW"), Words::tr("W"), Words::tr("NW")};
    const QString figure = QStringLiteral("%1°").arg(nominal_deg, 3, 'f', 0, QChar('0'));
    const double eighth = nominal_deg / 45.0;
    return eighth == std::floor(eighth) ? figure + ' ' + kNames[static_cast<std::size_t>(eighth) % 8] : figure;
}

QString figureText(double heading_deg)
{
    const double shown = std::round(printedHeading_deg(heading_deg, 1) * 10.0) / 10.0;
    const bool whole = shown == std::round(shown);
    return QStringLiteral("%1").arg(shown, whole ? 3 : 5, 'f', whole ? 0 : 1, QChar('0'));
}

QString turnSentence(const MakeCompassRead& turn)
{
    const QString control = wordFor(turn.control);
    if (turn.removal == HowMuch::All)
        return Words::tr("Error %1°: turn the %2 until all of it is gone, and the compass reads")
            .arg(signedNumber(turn.coefficient_deg, 1), control);
    if (turn.removal == HowMuch::Half)
        return Words::tr("Half of the error is %1°: turn the %2 until the compass reads")
            .arg(signedNumber(turn.coefficient_deg, 1), control);
    return Words::tr("%1 = %2°: turn the %3 until the compass reads")
        .arg(letterOf(turn.control), signedNumber(turn.coefficient_deg, 1), control);
}

QString stepTitle(const GuidedJob& job)
{
    const auto& state = job.state();
    if (state.phase != JobPhase::Stations)
        return phaseWord(job);
    return Words::tr("%1 · step %2 of %3").arg(phaseWord(job)).arg(state.current + 1).arg(state.stations.size());
}

QString costWords(const std::vector<double>& planned_deg, const std::vector<double>& read_deg)
{
    const SkipCost cost = skipCost(planned_deg, read_deg);
    if (!std::isfinite(cost.remaining))
        return Words::tr("What was read does not tell a curve.");
    const QString price = Words::tr("The curve is known to ±%1 of a reading's error at %2 instead of ±%3.")
                              .arg(cost.remaining, 0, 'f', 2)
                              .arg(stationHeading(cost.at_deg))
                              .arg(cost.planned, 0, 'f', 2);
    return price + (cost.withoutSecondHarmonic ? Words::tr(" D and E are not told any more.") : QString());
}

QString instrumentWords(const GuidedJob& job)
{
    const DatumInstrument& datum = job.datum();
    const StationState* station = job.station();
    QString should;
    if (station && datum.kind == DatumKind::ShadowPin) {
        should = Words::tr("the bearing of the shadow from the nose");
    } else if (const auto shown = station ? job.datumShould_deg(station->station.nominal_deg) : std::nullopt) {
        const bool byEye = datum.kind == DatumKind::SightingCompass || datum.kind == DatumKind::Theodolite;
        const QString figure = figureText(*shown);
        should = byEye && datum.ahead == SightingDirection::Reciprocal ? Words::tr("the sight reads the reciprocal: about %1").arg(figure)
            : byEye                                                    ? Words::tr("the sight reads the heading: about %1").arg(figure)
            : datum.kind == DatumKind::RoseLine ? Words::tr("the line of %1").arg(figureText(station->station.nominal_deg))
            : datum.givesTrue                   ? Words::tr("it shows true: about %1").arg(figure)
                                                : Words::tr("it shows about %1").arg(figure);
    }
    const QString name = toText(datum.name);
    return should.isEmpty() ? Words::tr("Instrument: %1").arg(name) : QStringLiteral("%1: %2").arg(name, should);
}

std::string readOutWords(const DatumInstrument& instrument)
{
    std::vector<Message> words;
    if (instrument.kind == DatumKind::SightingCompass || instrument.kind == DatumKind::Theodolite)
        words.push_back(
            instrument.ahead == SightingDirection::Direct ? MARKED("ui", "from ahead: direct") : MARKED("ui", "from ahead: reciprocal"));
    if (instrument.zero_deg != 0)
        words.push_back({MARKED("ui", "zero %1°"), signedFigureText(instrument.zero_deg, 2)});
    if (instrument.givesTrue)
        words.push_back(MARKED("ui", "true, less variation"));
    return together(std::move(words)).english();
}

QString skipWords(const JobState& state)
{
    std::vector<double> planned, read;
    QStringList skipped;
    for (const auto& station : state.stations) {
        if (station.station.phase != StationPhase::Check)
            continue;
        planned.push_back(station.station.nominal_deg);
        if (station.reading)
            read.push_back(station.station.nominal_deg);
        if (!station.skipped.empty())
            skipped += Words::tr("%1 (%2)").arg(stationHeading(station.station.nominal_deg), toText(station.skipped));
    }
    if (skipped.isEmpty())
        return {};
    return Words::tr("Skipped: %1. ").arg(skipped.join(QStringLiteral(", "))) + costWords(planned, read);
}

} // namespace lubberline::ui
