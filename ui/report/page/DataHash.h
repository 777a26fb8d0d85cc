#pragma once

#include <QString>

#include <string>

#include "core/record/Fleet.h"

namespace lubberline::ui {

/// SHA-256, lower-case hexadecimal, of the record's exchange JSON: what is printed on every page. It is that of the attached
/// file, byte for byte.
[[nodiscard]] QString dataHash(const SwingRecord& record);
/// SHA-256 of a text, lower-case hexadecimal.
[[nodiscard]] QString hashOfText(const std::string& text);

} // namespace lubberline::ui
