#pragma once
/// The state of a compass, an aircraft or a type as the fleet tree's badges show it.

namespace lubberline {

/// In order of urgency: a parent shows the most urgent of its children.
enum class Status { NotKnown, InLimits, OutOfLimits };

} // namespace lubberline
