#pragma once
/// The job card that a crew takes out: a blank form of the procedure, with the QR code of the record to come back by.

#include <QString>

#include "core/record/Fleet.h"

class QPagedPaintDevice;

namespace lubberline::ui {

struct JobCardInput {
    SwingRecord record; ///< of the swing that is to be made; its readings do not matter
    SwingJob job;       ///< plan, checklist and datum
    QString madeAtUtc;
};

/// Errors: InvalidInput (an ending other than .pdf), Io, Unsupported (no font).
Result<void> writeJobCard(const JobCardInput& input, const QString& path);
Result<void> printJobCard(const JobCardInput& input, QPagedPaintDevice& device);

/// What is to be done at a station, in the worksheet's words: "C = (dN − dS)/2; make compass read: compass − C".
[[nodiscard]] QStringList stationFormulas(const SwingJob& job);

} // namespace lubberline::ui
