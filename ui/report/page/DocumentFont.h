#pragma once
/// The font of documents. None is shipped: DejaVu Sans where it is installed, because it has every sign that is printed here
/// (δ ψ ′ ° − ≤), else the system's.

#include <QFont>
#include <QStringList>

#include "core/base/Result.h"

namespace lubberline::ui {

/// Without any font a PDF comes out blank, and nobody is told: so it is refused.
/// Errors: Unsupported, naming the package to install.
Result<QString> documentFamily();

/// The choice itself. @param system the family that the system gives for its standard font; empty when it has none.
Result<QString> chooseFamily(const QStringList& installed, const QString& system);

/// Sizes in points become pixels of a page's units (Page.h), so that layout does not depend on the device's resolution.
[[nodiscard]] QFont documentFont(const QString& family, double size_pt, bool bold = false);

} // namespace lubberline::ui
