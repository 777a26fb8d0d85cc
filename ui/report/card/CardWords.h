#pragma once
/// What a card says besides its figures: whose they are, how good, by whom signed.

#include <QString>
#include <QStringList>

#include "ui/report/card/CardDocument.h"

namespace lubberline::ui {

/// "OUT OF LIMITS", "DRAFT — NOT SIGNED", "NOT SIGNED", of one of two columns by its name; what else keeps a card from being used. Empty:
/// every column is signed and within its limits.
[[nodiscard]] QString cardBanner(const CardInput& input);

/// "DRAFT", or "NOT SIGNED" of what is complete; empty of what is signed.
[[nodiscard]] QString unsignedMark(const CardColumn& column);

/// "record 0f3c1d52 rev. 2 · data 4fa2b311 · signed" of a column.
[[nodiscard]] QString recordLine(const CardColumn& column);
/// "Performed Ada · PL 12 · 2026-11-23", "Inspected …"; of what is not signed: one line that says so.
[[nodiscard]] QStringList signatureLinesOf(const CardColumn& column);
/// "by the exact fit, 95 % band ±0.8°".
[[nodiscard]] QString qualityLine(const CardColumn& column);
/// "Largest residual −2.4° on 330 magnetic; largest reading +3.0° on 047 magnetic".
[[nodiscard]] QString largestLine(const CardColumn& column);
/// What a pilot must know, short: marks of rows, suspect readings, the attitude, what interpolation misses.
[[nodiscard]] QStringList shortRemarks(const CardColumn& column);
/// "*" a row where nobody read, "!" one over the limit; both may be. Empty: neither.
[[nodiscard]] QString markOf(const CardRow& row, const CardColumn& column);

[[nodiscard]] QString methodWords(const CardOptions& options);
/// "030", "360" never: north is 000.
[[nodiscard]] QString threeDigits(int heading_deg);

} // namespace lubberline::ui
