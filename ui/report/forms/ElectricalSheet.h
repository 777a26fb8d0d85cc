#pragma once
/// The record of an electrical swing on paper: the swing data sheet with its errors, the tests that it must pass, and lines to sign.

#include <QString>

#include "core/record/Fleet.h"

namespace lubberline::ui {

struct ElectricalSheet {
    ElectricalSwing swing;
    Aircraft aircraft;     ///< empty where the sheet stands alone, as in a file
    CompassSystem compass; ///< likewise
    QString madeAtUtc;
};

/// Errors: InvalidInput (an ending other than .pdf), Io, Unsupported (no font).
Result<void> writeElectricalSheet(const ElectricalSheet& sheet, const QString& path);

} // namespace lubberline::ui
