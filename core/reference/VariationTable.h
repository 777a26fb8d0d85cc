#pragma once
/// A table of variation that an instrument carries in steps of latitude and longitude, and what reading between its entries misses.

#include "core/earth/FieldModel.h"

namespace lubberline {

enum class TableReading { Nearest, Between }; ///< the nearest entry, or bilinear between the four

struct TableError {
    double tabled_deg = 0;  ///< what the table says there, east positive
    double error_deg = 0;   ///< table − model
    double largest_deg = 0; ///< |error| anywhere in the cell of the place
};

/// The variation is taken round a circle: 179° W and 179° E lie 2° apart. Beside a magnetic pole no table helps: the largest error
/// there is as large as it is. @param step_deg of the table, 0.1 … 30. Errors: those of FieldModel::evaluate(), InvalidInput.
Result<TableError> variationTableError(const FieldModel& model, const Place& place, double year, double step_deg, TableReading reading);

} // namespace lubberline
