#pragma once
/// The one seam below the stores where a test makes a database fail or be slow: a full drive, another program's lock, a statement
/// half-way through a change. Never set outside of tests.

#include <QString>

#include <functional>
#include <optional>

#include "core/base/Result.h"

namespace lubberline::db {

/// Asked before each statement is run; what it answers is what the statement fails with. It may also wait.
using Fault = std::function<std::optional<Error>(const QString& sql)>;

} // namespace lubberline::db
