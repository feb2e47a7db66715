//! Points of a sheet.

/// A point: right and down from the upper left corner.
pub(crate) type P = (f64, f64);

/// The point `r` away from `centre` at `angle` (radians, from the right, upwards).
pub(crate) fn polar(centre: P, r: f64, angle: f64) -> P {
    (centre.0 + r * angle.cos(), centre.1 - r * angle.sin())
}
