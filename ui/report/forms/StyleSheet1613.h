#pragma once
/// A sheet in the style of the US DD Form 1613, "Pilot's compass correction card" (columns after TM 1-1500-204-23-4, pp. 4-27
/// to 4-29). The form has a sign of its own: its deviation is compass − magnetic; the sheet says so.

#include <QString>

#include <optional>
#include <vector>

#include "core/record/Fleet.h"
#include "core/swing/Gaps.h"
#include "ui/report/page/Table.h"

class QPagedPaintDevice;

namespace lubberline::ui {

struct StyleSheet1613 {
    SwingRecord record;           ///< the swing after compensation: the residual swing
    std::optional<Swing> asFound; ///< the compensating swing
    QString madeAtUtc;
    bool holds = false;                      ///< the record's signatures stand over what it says now
    bool verified = false;                   ///< a known key stands behind every name
    bool superseded = false;                 ///< a later revision amends it
    std::optional<SwingRecord> compensating; ///< the record that asFound is of; none: it is of the guided swing of `record`
    bool compensatingHolds = false;
    bool outOfLimits = false;     ///< of the residual swing (core/swing/CardRemarks.h)
    std::vector<Message> remarks; ///< on the residual swing (core/swing/CardRemarks.h)
    std::vector<ReadingGap> gaps; ///< arcs of it where nobody read: STEER in them is marked

    [[nodiscard]] bool isSigned() const { return record.swing.state == SwingState::Signed && holds; }
};

/// Spread of the deviation after compensation that the manual allows [deg] (TM 1-1500-204-23-4, p. 4-29).
inline constexpr double kSpread1613_deg = 5;

/// Rows N, NE … NW: rose heading; compensating swing: magnetic (1), compass (2), deviation (2) − (1); residual swing: magnetic
/// (3), compass (4), "C to M" (3) − (4); computation: "M to C" (4) − (3). Degrees; a dash where nothing was read within 22.5°.
[[nodiscard]] Table table1613(const StyleSheet1613& sheet);

/// Errors: InvalidInput (an ending other than .pdf), Numeric (STEER does not rise with TO FLY: no card can be made), Io, Unsupported
/// (no font).
Result<void> write1613(const StyleSheet1613& sheet, const QString& path);
Result<void> print1613(const StyleSheet1613& sheet, QPagedPaintDevice& device);

} // namespace lubberline::ui
