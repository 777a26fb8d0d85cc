#pragma once
/// The audit trail in the words of whoever looks at a record: what was done, from what, to what, by whom, when.

#include <QString>

#include <vector>

#include "core/record/FleetRows.h"

namespace lubberline::ui {

struct AuditLine {
    QString when; ///< to the second, UTC
    QString what;
    QString before, after;
    QString who; ///< of a signature; nobody else names himself
};

/// One line for each thing that an entry changed, at least one for each entry. Words that this program does not know stay as they are.
[[nodiscard]] std::vector<AuditLine> auditLines(const AuditRow& row);

} // namespace lubberline::ui
