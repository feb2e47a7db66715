//! Units in column names.

use std::f64::consts::{PI, TAU};

/// How many of a unit of time are a second; `None` for no unit of time.
pub(crate) fn per_second(unit: &str) -> Option<f64> {
    Some(match unit {
        "" | "s" | "sec" | "secs" | "second" | "seconds" => 1.0,
        "ms" | "msec" | "millisecond" | "milliseconds" => 1e3,
        "us" | "\u{b5}s" | "\u{3bc}s" | "usec" | "microsecond" | "microseconds" => 1e6,
        "ns" | "nsec" | "nanosecond" | "nanoseconds" => 1e9,
        "min" | "minute" | "minutes" => 1.0 / 60.0,
        "h" | "hour" | "hours" => 1.0 / 3600.0,
        _ => return None,
    })
}

/// A number of a unit of time, or a frequency in its unit, in s; `None` for a unit that is not known.
pub(crate) fn period(number: f64, unit: &str) -> Option<f64> {
    match unit.to_lowercase().as_str() {
        "hz" | "hertz" | "fps" => Some(1.0 / number),
        "khz" => Some(1e-3 / number),
        unit => Some(number / per_second(unit)?),
    }
}

/// A unit of moments of inertia in kg m²; `None` for a unit that is not known.
pub(crate) fn inertia(unit: &str) -> Option<f64> {
    let unit: String = unit.chars().filter(|c| c.is_alphanumeric()).collect();
    Some(match unit.replace('²', "2").as_str() {
        "" | "kgm2" => 1.0,
        "kgcm2" => 1e-4,
        "gm2" => 1e-3,
        "kgmm2" => 1e-6,
        "gcm2" => 1e-7,
        "gmm2" => 1e-9,
        _ => return None,
    })
}

/// A unit of spin in rad/s; `None` for no unit of spin. Of lower case, and without blanks.
pub(crate) fn spin(unit: &str) -> Option<f64> {
    let unit: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    Some(match unit.as_str() {
        "" | "rad/s" | "rads" | "radps" | "rad/sec" | "radians" | "radians/s" | "rads^-1" | "rads-1"
        | "rad*s^-1" | "rad\u{b7}s^-1" | "1/s" | "s^-1" | "s-1" | "body" => 1.0,
        "mrad/s" => 1e-3,
        "deg/s" | "deg" | "degrees/s" | "degrees" | "deg/sec" | "\u{b0}/s" | "\u{b0}/sec" | "\u{b0}"
        | "dps" | "degs^-1" => PI / 180.0,
        "rpm" | "rev/min" | "r/min" | "1/min" => PI / 30.0,
        "rps" | "rev/s" | "r/s" | "hz" | "turns/s" | "turn/s" => TAU,
        _ => return None,
    })
}
