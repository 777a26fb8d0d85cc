#pragma once

#include <QString>

#include "ui/text/NumberText.h"

namespace lubberline::ui {

/// A probability [%]: none is printed as certain.
[[nodiscard]] inline QString shareWords(double probability)
{
    return probability > 0.99 ? QStringLiteral("> 99") : probability < 0.01 ? QStringLiteral("< 1") : plainNumber(100 * probability, 0);
}

} // namespace lubberline::ui
