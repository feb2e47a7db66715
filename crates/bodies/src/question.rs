//! Whether other units were meant than those in which a body was read.

use crate::document::from_toml;
use crate::file::number;
use crate::shape::{Weight, shaped};
use crate::table::Table;
use std::ops::Range;

/// Whether a number stands without its unit.
fn bare(number: &str) -> bool {
    !number.contains(['"', '\''])
}

/// Numbers as written, with this unit behind each that has none.
fn with_unit(numbers: &str, unit: &str) -> String {
    let one = |number: &str| {
        let plain = number.trim_matches(|c: char| c.is_whitespace() || "[]".contains(c));
        if bare(number) { number.replace(plain, &format!("'{plain} {unit}'")) } else { number.into() }
    };
    numbers.split(',').map(one).collect::<Vec<_>>().join(",")
}

/// Of bare numbers that make a body lighter than a foam or heavier than any metal, or that stand beside some
/// with a unit: whether other units were meant, all that are likely, likeliest first.
pub(crate) fn of(
    text: &str,
    present: &[(&'static str, Range<usize>)],
    name: &str,
    needed: &[&str],
) -> Option<String> {
    let given = present.iter().filter(|(field, _)| needed.contains(field) || *field == "mass");
    let given: Vec<_> = given.map(|(field, span)| (*field, &text[span.clone()])).collect();
    let (&(last, mass), sizes) = given.split_last()?;
    let sizes = sizes.iter().map(|size| size.1).collect::<Vec<_>>().join(", ");
    let [in_kg, in_m] = [mass, &sizes].map(|all| all.split(',').any(bare));
    if last != "mass" || !(in_kg || in_m) || ["plate", "disk", "rod"].contains(&name) {
        return None;
    }
    // Where a solid can be so dense, how far it is from a thing in the hand, by density and mass.
    let far = |m: &str, kg: &str| {
        let line = |(field, text): &(&str, &str)| {
            let unit = if *field == "mass" { kg } else { m };
            format!("{field} = {}", with_unit(text, unit))
        };
        let table: Table = from_toml(&given.iter().map(line).collect::<Vec<_>>().join("\n")).ok()?;
        let sides = table.sides.as_ref().map_or(&[][..], |sides| sides.get_ref());
        let density = number(&table.mass) / shaped(name, &table, sides, Weight::Density(1.0)).ok()?.0.mass();
        let off = |x: f64, usual: f64| (x / usual).log10().abs();
        (10.0..25_000.0).contains(&density).then(|| off(density, 1e3) + off(number(&table.mass), 0.3))
    };
    let mixed = [mass, &sizes].iter().any(|all| !all.split(',').all(bare));
    if !mixed && far("m", "kg").is_some() {
        return None;
    }
    let pairs = [("m", "g"), ("cm", "kg"), ("cm", "g"), ("mm", "kg"), ("mm", "g")];
    let asked = pairs.into_iter().filter(|(m, kg)| (in_m || *m == "m") && (in_kg || *kg == "kg"));
    let words = |m: &str, kg: &str| match (in_m, in_kg) {
        (true, true) => format!("{m} and {kg}"),
        (true, false) => m.into(),
        _ => kg.into(),
    };
    let mut likely: Vec<_> = asked.filter_map(|(m, kg)| Some((far(m, kg)?, words(m, kg)))).collect();
    likely.sort_by(|a, b| a.0.total_cmp(&b.0));
    let words = likely.into_iter().map(|pair| pair.1).collect::<Vec<_>>().join(", or in ");
    let shown = |all: &str, unit: &str| match all.split(',').all(bare) {
        true => format!("{all} {unit}"),
        false => with_unit(all, unit),
    };
    let shown = format!("{} in {}", shown(mass, "kg"), shown(&sizes, "m").replace(',', " ×"));
    let plain = shown.replace(['[', ']', '"', '\''], "");
    let odd = in_m && in_kg && far("m", "kg").is_none();
    match words.is_empty() {
        false => Some(format!("{plain}: is this in {words}?")),
        true => odd.then(|| format!("{plain}: no solid is so light or so heavy. Are the numbers right?")),
    }
}
