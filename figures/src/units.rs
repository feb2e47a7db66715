//! Numbers with a suitable unit.

use crate::picture::raised;

/// Units of one kind: size, name, and the smallest value for which the unit is used, in the order of these
/// values.
pub(crate) struct Units(&'static [(f64, &'static str, f64)]);

/// Lengths in m: `7.8 mm`.
pub(crate) const LENGTH: Units =
    Units(&[(1e-9, "nm", 0.0), (1e-6, "µm", 1e-6), (1e-3, "mm", 1e-3), (1.0, "m", 1.0), (1e3, "km", 1e3)]);
/// Masses in kg: `200 g`.
pub(crate) const MASS: Units = Units(&[
    (1e-9, "µg", 0.0),
    (1e-6, "mg", 1e-6),
    (1e-3, "g", 1e-3),
    (1.0, "kg", 1.0),
    (1e3, "t", 1e4),
    (1.0, "kg", 1e8),
]);
/// Times in s: `3.2 h`.
pub(crate) const TIME: Units = Units(&[
    (1e-6, "µs", 0.0),
    (1e-3, "ms", 1e-3),
    (1.0, "s", 1.0),
    (60.0, "min", 120.0),
    (3600.0, "h", 7200.0),
    (86_400.0, "days", 172_800.0),
    (31_557_600.0, "years", 63_115_200.0),
]);
const MOMENT: Units =
    Units(&[(1e-9, "g mm²", 0.0), (1e-7, "g cm²", 1e-7), (1e-4, "kg cm²", 1e-4), (1.0, "kg m²", 1e-2)]);

impl Units {
    /// The size and the name of the unit for this value.
    pub(crate) fn of(&self, value: f64) -> (f64, &'static str) {
        let fits = self.0.iter().rev().find(|(_, _, from)| value.abs() >= from * (1.0 - 1e-9));
        fits.or(self.0.first()).map_or((1.0, ""), |&(size, name, _)| (size, name))
    }

    pub(crate) fn say(&self, value: f64) -> String {
        if value == 0.0 {
            return format!("0 {}", self.of(1.0).1);
        }
        let (size, name) = self.of(value);
        format!("{} {name}", number(value / size, 3))
    }
}

/// A position in m, in one unit: `(0, 20, −300) mm`.
pub(crate) fn place(m: &nalgebra::Vector3<f64>) -> String {
    let (size, name) = LENGTH.of(m.amax());
    format!("({}) {name}", m.iter().map(|x| number(x / size, 3)).collect::<Vec<_>>().join(", "))
}

/// Positive numbers in this unit, with the same number of decimals, so that the smallest has three digits.
pub(crate) fn column(all: &[f64], unit: f64) -> Vec<String> {
    let power = (all.iter().copied().fold(f64::INFINITY, f64::min) / unit).log10().floor();
    let decimals = (2.0 - power).max(0.0) as usize;
    let plain = (-3.0..5.0).contains(&power);
    let all = all.iter().map(|x| x / unit);
    all.map(|x| if plain { format!("{x:.decimals$}") } else { significant(x, 3) }).collect()
}

/// Moments of inertia in one unit, kg m² or a part or a power of ten of it, and the unit's name.
pub(crate) fn moments(all: &[f64]) -> (Vec<String>, String) {
    let largest = all.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let (size, name) = if largest < 1e5 {
        let (size, name) = MOMENT.of(largest);
        (size, name.to_owned())
    } else {
        let power = largest.log10().floor() as i32;
        (10_f64.powi(power), format!("× {} kg m²", raised(power)))
    };
    // In one row with the same number of decimals, unless the smallest would have no digits left.
    let smallest = all.iter().map(|x| x.abs()).filter(|&x| x > 0.0).fold(largest, f64::min);
    let tiny = largest < 1e-9 || smallest < 0.02 * largest;
    let digits = (3 - (largest / size).log10().floor() as i32).clamp(0, 5) as usize;
    let written = all
        .iter()
        .map(|&x| if tiny { significant(x / size, 4) } else { with_minus(format!("{:.digits$}", x / size)) });
    (written.collect(), name)
}

fn with_minus(text: String) -> String {
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if zero { text.replace('-', "") } else { text.replace('-', "−") }
}

/// A number with at most this number of significant digits: plain, or with a power of ten where that is long.
pub(crate) fn number(x: f64, digits: usize) -> String {
    written(x, digits, true)
}

/// A number with exactly this number of significant digits, with trailing zeros, for columns.
pub(crate) fn significant(x: f64, digits: usize) -> String {
    written(x, digits, false)
}

fn written(x: f64, digits: usize, short: bool) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { "none".into() };
    }
    let text = format!("{:.*e}", digits.saturating_sub(1), x);
    let Some((mantissa, power)) = text.split_once('e') else { return text };
    let power: i32 = power.parse().unwrap_or(0);
    let trimmed = |text: &str| -> String {
        let few = short && text.contains('.');
        if few { text.trim_end_matches('0').trim_end_matches('.').into() } else { text.into() }
    };
    if (-3..5).contains(&power) {
        let decimals = usize::try_from(digits as i32 - 1 - power).unwrap_or(0);
        let rounded: f64 = text.parse().unwrap_or(x);
        return with_minus(trimmed(&format!("{rounded:.decimals$}")));
    }
    let mantissa = trimmed(mantissa);
    let power = raised(power);
    with_minus(if mantissa == "1" { power } else { format!("{mantissa} × {power}") })
}

/// Round values from zero to `most`, five to ten of them, with their labels.
pub(crate) fn ticks(most: f64) -> Vec<(f64, String)> {
    let rough = most / 4.0;
    let power = 10_f64.powf(rough.log10().floor());
    let step = power * [5.0, 2.0, 1.0].into_iter().find(|factor| factor * power <= rough).unwrap_or(1.0);
    let count = (most / step * (1.0 + 1e-9)).floor() as u32;
    (0..=count).map(|k| (step * f64::from(k), number(step * f64::from(k), 3))).collect()
}

/// An angular velocity (rad/s) in turns: `one turn a second`, `one turn in 3 h`.
pub(crate) fn turning(spin: f64) -> String {
    let turns = spin / std::f64::consts::TAU;
    match number(turns, 3).as_str() {
        "1" => "one turn a second".into(),
        text if turns > 1.0 => format!("{text} turns a second"),
        _ => format!("one turn in {}", TIME.say(1.0 / turns)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_suits_its_number_from_a_dice_to_a_planetoid() {
        assert_eq!([0.0078, 1240.0, 2e-9].map(|m| LENGTH.say(m)), ["7.8 mm", "1.24 km", "2 nm"]);
        assert_eq!(place(&nalgebra::Vector3::new(0.0, 0.02, -0.3)), "(0, 20, −300) mm");
        let masses = [0.001, 0.9995, 4.0, 1e-9, 2e-6, 2.5e4, 1e12].map(|kg| MASS.say(kg));
        assert_eq!(masses, ["1 g", "1000 g", "4 kg", "1 µg", "2 mg", "25 t", "10¹² kg"]);
        assert_eq!([0.004, 90.0, 1e5, 4e5].map(|s| TIME.say(s)), ["4 ms", "90 s", "27.8 h", "4.63 days"]);
        assert_eq!(moments(&[10.0 / 12.0, 13.0 / 12.0, -5.0 / 12.0]).0, ["0.833", "1.083", "−0.417"]);
        assert_eq!(moments(&[1e17, 2.5e16]), (vec!["1.000".into(), "0.250".into()], "× 10¹⁷ kg m²".into()));
        assert_eq!(moments(&[4e-4, 1e-4]).1, "kg cm²");
        assert_eq!(moments(&[1.31e-5, 7.2e-8]), (vec!["131.0".into(), "0.7200".into()], "g cm²".into()));
        assert_eq!(column(&[84.0, 140.4, 600.0], 60.0), ["1.40", "2.34", "10.00"]);
        assert_eq!([0.001, 4e-9, 1234.0].map(|x| significant(x, 2)), ["0.0010", "4.0 × 10⁻⁹", "1200"]);
        assert_eq!([number(-3.0e-7, 3), number(0.1, 3), number(12345.0, 3)], ["−3 × 10⁻⁷", "0.1", "12300"]);
        let spins = [std::f64::consts::TAU, 0.1, 10.0].map(turning);
        assert_eq!(spins, ["one turn a second", "one turn in 62.8 s", "1.59 turns a second"]);
    }

    #[test]
    fn ticks_are_few_and_round() {
        for most in [0.9, 1.0, 3.3, 7.0, 45.0, 1e-7, 8.4e11] {
            let all = ticks(most);
            assert!((4..=11).contains(&all.len()), "{most}: {all:?}");
            assert!(all.last().is_some_and(|last| last.0 <= most * (1.0 + 1e-9)));
        }
        let words: Vec<String> = ticks(7.0).into_iter().map(|tick| tick.1).collect();
        assert_eq!(words, ["0", "1", "2", "3", "4", "5", "6", "7"]);
    }
}
