#pragma once
/// The correction card FOR/STEER at the size of a cockpit placard, with crop marks, one or two STEER columns; or, by compass, the
/// magnetic heading for what is read. Each column is of a record of its own, and says which and whether it is signed.

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/swing/Card.h"
#include "core/swing/CardRemarks.h"

class QPagedPaintDevice;

namespace lubberline::ui {

struct CardColumn {
    QString heading; ///< "RADIO ON" and "RADIO OFF"; of one column "STEER"
    Card card;
    SwingRecord record;      ///< that these figures are of
    bool holds = false;      ///< its signatures stand over what the record says now
    bool superseded = false; ///< a later revision amends it
    QString signedAs = {};   ///< what is printed otherwise today than it was signed; may be empty
    bool verified = false;   ///< a known key stands behind every name

    [[nodiscard]] bool outOfLimits() const { return lubberline::outOfLimits(card, record.limits); }

    /// Only then does a signature stand for these figures: what is removed after the swing nobody signed.
    [[nodiscard]] bool isSigned() const { return record.swing.state == SwingState::Signed && holds && card.options.removed.none(); }
};

struct CardInput {
    std::vector<CardColumn> columns; ///< one or two, with the same FOR headings, of one compass
    QString madeAtUtc;               ///< ISO 8601; printed beside the card
    QString nextDue = {};            ///< ISO 8601; empty: not known
    QStringList loadsToName = {};    ///< that push the deviation past 10° (core/procedure/LoadNotes.h)
    QString reprintOf = {};          ///< the date of the signature, where a lost card is printed again; empty: it is the first

    /// Whose card it is.
    [[nodiscard]] const SwingRecord& record() const { return columns.front().record; }
};

/// A PDF of A4; the card is cut out along the crop marks. Errors: InvalidInput (ending not .pdf, columns that do not match: other
/// headings, another aircraft or compass), Io, Unsupported (no font).
Result<void> writeCard(const CardInput& input, const QString& path);

/// Paints the same page on any paged device (a QPrinter), always at its true size. Errors: InvalidInput (columns), Unsupported,
/// Io.
Result<void> printCard(const CardInput& input, QPagedPaintDevice& device);

} // namespace lubberline::ui
