#pragma once
/// The correction card FOR/STEER at the size of a cockpit placard, with crop marks, one or two STEER columns.

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/swing/Card.h"

class QPagedPaintDevice;

namespace lubberline::ui {

struct CardColumn {
    QString heading; ///< "STEER", or "RADIO ON" and "RADIO OFF"
    Card card;
};

struct CardInput {
    SwingRecord record;
    std::vector<CardColumn> columns;    ///< one or two, with the same FOR headings
    QString madeAtUtc;                  ///< ISO 8601; printed beside the card
    std::optional<CardOptions> options; ///< how the figures were made: printed beside the card when given
    QString nextDue = {};               ///< ISO 8601; empty: not known
    QStringList loadsToName = {};       ///< that push the deviation past 10° (core/procedure/LoadNotes.h)
    QString reprintOf = {};             ///< the date of the signature, where a lost card is printed again; empty: it is the first
};

/// A PDF of one A4 page; the card is cut out along the crop marks. Errors: InvalidInput (ending not .pdf, columns that do not
/// match), Io, Unsupported (no font).
Result<void> writeCard(const CardInput& input, const QString& path);

/// Paints the same page on any paged device (a QPrinter), always at its true size. Errors: InvalidInput (columns), Unsupported,
/// Io.
Result<void> printCard(const CardInput& input, QPagedPaintDevice& device);

} // namespace lubberline::ui
