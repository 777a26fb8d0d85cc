#include "core/earth/FieldTables.h"

namespace lubberline {

FieldTable emptyTable(const std::string& name, double firstEpoch, int epochs, int degree)
{
    FieldTable table;
    table.name = name;
    table.firstEpoch = firstEpoch;
    table.lastYear = firstEpoch + 5.0 * epochs;
    table.degree = degree;
    table.main.assign(static_cast<std::size_t>(epochs), GaussSet(gaussCount(degree)));
    table.change.assign(gaussCount(degree), Gauss{});
    return table;
}

} // namespace lubberline
