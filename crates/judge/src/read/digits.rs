//! The digits of a number as it is written.

/// How many digits from the first that is not zero, before an exponent.
pub(crate) fn significant(field: &str) -> u32 {
    let mut count = 0;
    for byte in field.bytes() {
        match byte {
            b'e' | b'E' => break,
            b'0' if count == 0 => {}
            b'0'..=b'9' => count += 1,
            _ => {}
        }
    }
    count
}

/// How many bits of a number's binary digits are significant.
pub(crate) const fn significant_bits(x: f64) -> u32 {
    // The first one is not written.
    let rest = u64::BITS - (x.to_bits() << 12).trailing_zeros();
    if x == 0.0 { 0 } else { 1 + rest }
}

/// What a one is worth in the last place: 0.001 in 1.250, 1e-9 in 1.5e-8.
pub(crate) fn last_place(field: &str) -> f64 {
    let (number, exponent) = field.split_once(['e', 'E']).unwrap_or((field, "0"));
    let places = number.split_once('.').map_or(0, |(_, after)| after.len());
    let exponent: i32 = exponent.parse().unwrap_or(0);
    10.0_f64.powi(exponent.saturating_sub(i32::try_from(places).unwrap_or(i32::MAX)))
}
