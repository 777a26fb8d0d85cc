#pragma once
/// Private to db: swings and readings to and from rows.

#include "core/record/FleetRows.h"
#include "core/record/Swing.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

/// The columns of a swing in the order of swingFrom(), for SELECT … FROM swing s.
[[nodiscard]] QString swingColumns();
/// The columns of a reading in the order of readingFrom(), for SELECT … FROM reading r.
[[nodiscard]] QString readingColumns();

/// Without readings; the columns begin at `first`.
[[nodiscard]] Swing swingFrom(const Statement& row, int first);
[[nodiscard]] Reading readingFrom(const Statement& row, int first);

/// Of a reading no more than results need: both headings, and whether it is left out (without the reason).
[[nodiscard]] QString headingColumns();
[[nodiscard]] Reading headingsOnlyFrom(const Statement& row, int first);

/// A line of a list with its cached results, for SELECT … FROM swing.
[[nodiscard]] QString swingRowColumns();
inline constexpr int kSwingRowColumns = 18;
[[nodiscard]] SwingRow swingRowFrom(const Statement& row);

/// Binds the particulars in the order of swingFields(), from compass to the index that was removed.
void bindParticulars(Statement& statement, const Swing& swing);
/// "compass_id, site_id, …": for INSERT and, each with " = ?", for UPDATE.
[[nodiscard]] QStringList swingFields();

/// Binds from nominal to extra, in the order of readingFields().
void bindReading(Statement& statement, const Reading& reading);
[[nodiscard]] QStringList readingFields();

/// One line for the audit trail: all that is stated of a reading.
[[nodiscard]] std::string auditText(const Reading& reading);

} // namespace lubberline::db
