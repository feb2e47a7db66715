//! Sine and cosine of an angle given in turns: no division by the circle's constant to lose digits in.

use crate::double::Double;
use std::f64::consts::TAU;

/// Sine and cosine of `turns` whole turns.
///
/// Whole and quarter turns are taken off first, exactly, so that a phase of 1e9 turns costs what a small one
/// does, and what is left keeps all its digits.
pub(crate) fn sin_cos_of_turns(turns: Double) -> (f64, f64) {
    let (_, part) = turns.split();
    let quarters = (4.0 * part).round_ties_even();
    let angle = TAU * (part - 0.25 * quarters);
    let (sin, cos) = near_zero(angle);
    match quarters as i32 {
        0 => (sin, cos),
        1 => (cos, -sin),
        -1 => (-cos, sin),
        _ => (-sin, -cos),
    }
}

/// Both by their own series, for angles up to an eighth of a turn: the first term left out is below 1e-17
/// of the sum.
fn near_zero(x: f64) -> (f64, f64) {
    const fn inverse_factorial(n: u32) -> f64 {
        let (mut product, mut i) = (1.0, 2);
        while i <= n {
            product *= i as f64;
            i += 1;
        }
        1.0 / product
    }
    const S: [f64; 8] = [
        -inverse_factorial(3),
        inverse_factorial(5),
        -inverse_factorial(7),
        inverse_factorial(9),
        -inverse_factorial(11),
        inverse_factorial(13),
        -inverse_factorial(15),
        inverse_factorial(17),
    ];
    const C: [f64; 8] = [
        inverse_factorial(4),
        -inverse_factorial(6),
        inverse_factorial(8),
        -inverse_factorial(10),
        inverse_factorial(12),
        -inverse_factorial(14),
        inverse_factorial(16),
        -inverse_factorial(18),
    ];
    let y = x * x;
    let (y2, y4) = (y * y, (y * y) * (y * y));
    // Pairs, then pairs of pairs: the processor works on them side by side.
    let series = |a: &[f64; 8]| {
        let low = (a[0] + a[1] * y) + y2 * (a[2] + a[3] * y);
        let high = (a[4] + a[5] * y) + y2 * (a[6] + a[7] * y);
        low + y4 * high
    };
    let sin = x + x * y * series(&S);
    let half = 0.5 * y;
    let near = 1.0 - half;
    // What the subtraction rounded off goes back in.
    let cos = near + (((1.0 - near) - half) + y2 * series(&C));
    (sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        // Independent: the platform's own sine and cosine.
        #[test]
        fn sine_and_cosine_of_turns_are_those_of_the_angle(turns in -0.6_f64..0.6) {
            let (sin, cos) = sin_cos_of_turns(Double::from(turns));
            let (s, c) = (turns * TAU).sin_cos();
            prop_assert!((sin - s).abs() < 1e-15 && (cos - c).abs() < 1e-15, "{sin} {s} {cos} {c}");
        }

        #[test]
        fn whole_turns_change_nothing(turns in -0.5_f64..0.5, whole in -(1_i64 << 40)..(1 << 40)) {
            let many = Double::sum(whole as f64, turns);
            prop_assert_eq!(sin_cos_of_turns(many), sin_cos_of_turns(Double::from(turns)));
        }
    }

    #[test]
    fn quarter_turns_are_exact_and_their_neighbours_keep_all_digits() {
        assert_eq!(sin_cos_of_turns(Double::from(0.25)), (1.0, 0.0));
        assert_eq!(sin_cos_of_turns(Double::from(-0.25)), (-1.0, 0.0));
        assert_eq!(sin_cos_of_turns(Double::from(7.5)).1, -1.0);
        let beyond = 2_f64.powi(-50);
        let (_, cos) = sin_cos_of_turns(Double::sum(1e6 + 0.25, beyond));
        assert!((cos / (-TAU * beyond) - 1.0).abs() < 1e-15, "{cos}");
    }
}
