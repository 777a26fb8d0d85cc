#pragma once
/// The words of a guided swing.

#include <QString>
#include <QStringList>

#include <vector>

#include "core/procedure/JobState.h"
#include "core/record/SwingJob.h"

namespace lubberline::ui {

class GuidedJob;

[[nodiscard]] QString procedureMeaning(ProcedureKind kind); ///< what is done in which order, and whose method it is
[[nodiscard]] QString stationHeading(double nominal_deg);   ///< "180° S", "315° NW", "015°"
[[nodiscard]] QString figureText(double heading_deg);       ///< "176", "176.5": as a compass is read
/// "sighting compass: the sight reads the reciprocal: about 180": what the datum is, and what it should show at the station.
[[nodiscard]] QString instrumentWords(const GuidedJob& job);
/// What is known less when of the planned headings only these are read: "The curve is known to ±0.9 of a reading's error at 090° E instead
/// of ±0.8."
[[nodiscard]] QString costWords(const std::vector<double>& planned_deg, const std::vector<double>& read_deg);
/// "C = −6.0°: turn the N–S screw until the compass reads".
[[nodiscard]] QString turnSentence(const MakeCompassRead& turn);
/// "Correction · step 3 of 12".
[[nodiscard]] QString stepTitle(const GuidedJob& job);
/// "from ahead, reciprocal; zero +0.3°; true": for the record, so in no language but that of all records.
[[nodiscard]] std::string readOutWords(const DatumInstrument& instrument);
/// "315° was skipped (tug cannot turn): the curve is known to ±0.9 of a reading at 320° instead of ±0.8"; empty where nothing
/// was.
[[nodiscard]] QString skipWords(const JobState& state);

} // namespace lubberline::ui
