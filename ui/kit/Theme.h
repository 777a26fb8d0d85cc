#pragma once

#include <QIcon>
#include <QString>

namespace lubberline::ui {

/// Light or dark, for the whole application: the Fusion style, whose colours follow the palette everywhere.
void applyTheme(bool dark);

/// Of every text in the application, in percent of what the desktop asks for.
void applyTextSize(int percent);

/// One of our own drawings (resources/icons), by its name without ending.
[[nodiscard]] QIcon icon(const QString& name);

} // namespace lubberline::ui
