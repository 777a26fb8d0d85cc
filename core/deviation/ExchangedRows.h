#pragma once
/// Two figures that stand in each other's row.

#include <span>

#include "core/deviation/SwingSlips.h"

namespace lubberline {

/// Where two readings that slipped would go with the curve of the others if their compass figures were exchanged, that is the likeliest of what
/// happened to both: one slip is put before two (Slip::WrongRow, with the magnetic heading that each figure fits). Nothing is done with fewer
/// than six others, or where two exchanges are as likely.
void nameExchangedRows(SlipSearch& search, std::span<const Observation> readings);

} // namespace lubberline
