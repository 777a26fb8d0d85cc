#pragma once
/// Signatures for a fleet that was made up.

#include "core/record/Fleet.h"

namespace lubberline::db {

/// Gives every swing of the fleet that says signed, and has no signature, those of its datum reader and its inspector, as names that nobody
/// verified, at the end of its day. For the demonstration: of a real swing nobody but its people can say that they signed it.
void signInNames(Fleet& fleet);

} // namespace lubberline::db
