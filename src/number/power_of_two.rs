//! Scaling by powers of two, which is exact, so that no product overflows or underflows on the way.

/// `x * 2^exponent`, exact unless the result is subnormal or overflows.
pub(crate) fn times_power_of_two(x: f64, exponent: i32) -> f64 {
    let factor = |e: i32| f64::from_bits(u64::from((e + 1023).unsigned_abs()) << 52);
    if (-1022..=1023).contains(&exponent) {
        return x * factor(exponent);
    }
    // One factor cannot reach from the smallest subnormal to the largest number: take up to three.
    let mut rest = exponent.clamp(-3000, 3000);
    let mut y = x;
    while rest != 0 {
        let part = rest.clamp(-1022, 1023);
        y *= factor(part);
        rest -= part;
    }
    y
}

/// The exponent `e` with `2^e <= |x| < 2^(e+1)`; 0 for zero, which needs no scaling.
pub(crate) fn exponent(x: f64) -> i32 {
    if x == 0.0 || !x.is_finite() {
        return 0;
    }
    let bits = |y: f64| i32::try_from(y.to_bits() >> 52 & 0x7ff).unwrap_or(0);
    match bits(x) {
        0 => bits(x * 18_446_744_073_709_551_616.0) - 1023 - 64,
        biased => biased - 1023,
    }
}

/// One unit in the last place of a finite `x`: the distance between its neighbours, also at the ends of the
/// range.
pub(crate) fn ulp(x: f64) -> f64 {
    let x = x.abs();
    // The largest number has no finite one above it; the step below it is as long.
    if x == f64::MAX { x - x.next_down() } else { x.next_up() - x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_there_and_back_is_exact_from_the_smallest_subnormal_to_the_largest_number() {
        for x in [5e-324, -1.5e-310, f64::MIN_POSITIVE, 0.1, -1.0, 3.0, f64::MAX] {
            let e = exponent(x);
            let unit = times_power_of_two(x, -e);
            assert!((1.0..2.0).contains(&unit.abs()), "{x:e}: {unit}");
            assert_eq!(times_power_of_two(unit, e), x);
        }
        assert_eq!(exponent(0.0), 0);
        assert_eq!(ulp(f64::MAX), 2_f64.powi(971));
    }

    #[test]
    fn a_unit_in_the_last_place_is_finite_at_both_ends_of_the_range() {
        for x in [1.0, -1.5, 3.7e-200, 1e300, f64::MIN_POSITIVE, 1e-310] {
            assert_eq!(ulp(x), x.abs().next_up() - x.abs(), "{x:e}");
        }
        assert_eq!(ulp(f64::MAX), f64::MAX - f64::MAX.next_down());
        assert_eq!(ulp(0.0), 5e-324);
    }
}
