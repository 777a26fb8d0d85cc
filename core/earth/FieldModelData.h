#pragma once
/// What is inside a FieldModel, for the sources of this folder.

#include "core/earth/FieldModel.h"
#include "core/earth/GeographicModel.h"

namespace lubberline {

struct FieldModel::Data {
    explicit Data(const FieldTable& table)
        : name(table.name)
        , firstYear(table.firstEpoch)
        , lastYear(table.lastYear)
        , degree(table.degree)
        , model(table)
    {
    }
    const std::string name;
    const double firstYear, lastYear;
    const int degree;
    const GeographicModel model;
};

} // namespace lubberline
