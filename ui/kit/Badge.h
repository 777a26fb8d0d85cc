#pragma once
/// States as badges: a shape and a word besides the colour, so that none of the three is needed to tell them apart.

#include <QColor>
#include <QIcon>
#include <QString>

#include "core/record/Status.h"

namespace lubberline::ui {

/// "in limits", "out of limits", "not known".
[[nodiscard]] QString badgeWord(Status status);
/// The word with what it means, for tooltips.
[[nodiscard]] QString badgeMeaning(Status status);
/// A disc (in limits), a triangle (out of limits), a ring (not known).
[[nodiscard]] QIcon badgeIcon(Status status);
[[nodiscard]] QColor badgeColour(Status status);

} // namespace lubberline::ui
