#pragma once
/// Private to db: what a failed statement means, in words for the user.

#include <QSqlError>

#include "core/base/Result.h"

namespace lubberline::db {

[[nodiscard]] Error errorOf(const QSqlError& error, const QString& path);

} // namespace lubberline::db
