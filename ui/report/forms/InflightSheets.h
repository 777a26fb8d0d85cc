#pragma once
/// Documents of a swing in flight: what legs by GPS told, and how a continuous swing settled.

#include "core/inflight/ContinuousSwing.h"
#include "core/inflight/Legs.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// Of a file, without its folders.
[[nodiscard]] QString sourceName(const std::string& path);
/// Without what a font does not have.
[[nodiscard]] QStringList printableAll(const std::vector<Message>& messages);

/// @param source name of the log. @param warnings that are said of it, those of the solution included.
[[nodiscard]] ReferenceSheet legsSheet(const LegsSolution& solution, const QString& source, const QStringList& warnings);
[[nodiscard]] ReferenceSheet continuousSheet(const ContinuousResult& result, const QString& source, const QStringList& warnings);

} // namespace lubberline::ui
