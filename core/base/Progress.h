#pragma once

#include <functional>

namespace lubberline {

/// Called now and then by long work with the fraction done, 0…1; returning false cancels the work,
/// which then returns ErrorCode::Cancelled and leaves nothing changed. May be empty. Called on the worker's thread.
using Progress = std::function<bool(double fraction)>;

} // namespace lubberline
