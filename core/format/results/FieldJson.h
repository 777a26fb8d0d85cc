#pragma once
/// The JSON of `field` (the contract of the command line).

#include <string>

#include "core/earth/FieldModel.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const FieldAnswer& answer);

} // namespace lubberline
