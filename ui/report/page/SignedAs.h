#pragma once

#include <QString>

#include <vector>

#include "core/record/SignatureState.h"

namespace lubberline::ui {

/// What is printed otherwise today than it was signed: "signed as registration of the aircraft: 3713"; empty for nothing.
[[nodiscard]] QString signedAs(const SignatureState& state);
/// Of the signatures that hold, each once.
[[nodiscard]] QString signedAs(const std::vector<SignatureState>& states);

} // namespace lubberline::ui
