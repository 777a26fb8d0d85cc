#pragma once
/// How urgent a swing is, as a badge: a shape and a word besides the colour.

#include <QIcon>
#include <QString>
#include <QStringList>

#include "core/due/DueRules.h"

namespace lubberline::ui {

/// "overdue", "due", "due soon", "not due".
[[nodiscard]] QString dueWord(DueState state);
/// A full square (overdue), an empty one (due), a bar (due soon), a dot (not due).
[[nodiscard]] QIcon dueIcon(DueState state);

/// The same shape as a character, for lists that have another badge already.
[[nodiscard]] QString dueMark(DueState state);

} // namespace lubberline::ui
