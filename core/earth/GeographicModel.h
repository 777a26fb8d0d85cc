#pragma once
/// A table of coefficients as a model of GeographicLib.

#include <memory>

#include <GeographicLib/MagneticModel.hpp>

#include "core/base/Result.h"
#include "core/earth/FieldTables.h"

namespace lubberline {

/// GeographicLib reads its models from two files of its own format: they are written into a fresh private folder below the
/// machine's temporary one and removed again. Errors: Io (no folder can be made or written).
Result<std::shared_ptr<const GeographicLib::MagneticModel>> geographicModel(const FieldTable& table);

} // namespace lubberline
