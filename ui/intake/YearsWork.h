#pragma once
/// A table of years read by its mapping: a first glance at once, the whole on a worker.

#include <QString>
#include <QStringList>

#include <array>
#include <optional>
#include <vector>

#include "core/base/Progress.h"
#include "core/format/csv/YearsCsv.h"
#include "db/stores/Stores.h"
#include "db/transfer/Years.h"

namespace lubberline::ui {

/// A swing of a table as it would come in.
struct YearsGlance {
    std::int64_t line = 0;
    QString type, aircraft, compass, date, stage;
    int readings = 0;
    std::array<std::optional<double>, 5> coefficient_deg; ///< A…E
    double maxAbs_deg = 0;
};

/// Its columns with what stands in the first rows, by which people know them.
struct YearsColumnsShown {
    YearsHeader header;
    std::vector<QStringList> examples; ///< of each column
};
/// Errors: those of the reader.
Result<YearsColumnsShown> columnsShown(const QString& path);

/// The first swings. Errors: of a row up to there.
Result<std::vector<YearsGlance>> firstSwings(const QString& path, const YearsTable& table, int most);

/// What would be stored, or what was: on a worker, with a connection of its own.
Result<db::YearsOutcome> yearsWork(
    const db::Stores& stores, const QString& path, const YearsTable& table, db::YearsStep step, const Progress& progress);

} // namespace lubberline::ui
