#pragma once
/// Angles that core holds in radians and files in degrees.

namespace lubberline {

/// The degrees to write for an angle: short where a short figure reads back (toRadians) to the same radians, and always a
/// figure that is written the same again after it was read. Within 1e-15 of the angle's size. @param angle_rad finite.
[[nodiscard]] double writtenDegrees(double angle_rad);

} // namespace lubberline
