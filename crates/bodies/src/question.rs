//! Asks whether the input of a body is intended: its units, its mass and moments, its parts and their places.
//! (The questions on degrees and on fixed joints are asked where a robot is read.)

use crate::document::from_toml;
use crate::file::number;
use crate::model::BodyModel;
use crate::shape::{Weight, shaped};
use crate::table::Table;
use std::f64::consts::PI;
use std::ops::Range;
use tumbling::MassProperties;

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

/// With two digits.
fn plain(x: f64) -> String {
    short(format!("{x:.1e}").parse().unwrap_or(x))
}

/// Without a row of zeros.
fn short(x: f64) -> String {
    if (1e-9..1e9).contains(&x) { x.to_string() } else { format!("{x:e}") }
}

const SOLIDS: std::ops::Range<f64> = 10.0..25_000.0;
const NONE_IS: &str = "no solid is so light or so heavy. Are the numbers right?";

/// Asks whether other units were intended, for numbers that make a body lighter than foam or heavier than any
/// metal, or that have no unit next to others with a unit. It lists all likely units, the most likely first.
pub(crate) fn of(
    text: &str,
    present: &[(&'static str, Range<usize>)],
    name: &str,
    needed: &[&str],
) -> Option<String> {
    // Thin bodies have no density in kg/m³, and vertices have no units.
    let thin = ["plate", "disk", "rod", "tetrahedron"].contains(&name);
    if let Some((_, span)) = present.iter().find(|(field, _)| *field == "density") {
        return dense(&text[span.clone()]).filter(|_| !thin);
    }
    let given = present.iter().filter(|(field, _)| needed.contains(field) || *field == "mass");
    let given: Vec<_> = given.map(|(field, span)| (*field, &text[span.clone()])).collect();
    let (&(_, mass), sizes) = given.split_last().filter(|_| !thin)?;
    let sizes = sizes.iter().map(|size| size.1).collect::<Vec<_>>().join(", ");
    let [in_kg, in_m] = [mass, &sizes].map(|all| all.split(',').any(bare));
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
        SOLIDS.contains(&density).then(|| off(density, 1e3) + off(number(&table.mass), 0.3))
    };
    if [mass, &sizes].iter().all(|all| all.split(',').all(bare)) && far("m", "kg").is_some() {
        return None;
    }
    let pairs = [("m", "g"), ("cm", "kg"), ("cm", "g"), ("mm", "kg"), ("mm", "g")];
    let asked = pairs.into_iter().filter(|(m, kg)| (in_m || *m == "m") && (in_kg || *kg == "kg"));
    let words = |m, kg| [in_m.then_some(m), in_kg.then_some(kg)].into_iter().flatten().collect::<Vec<_>>();
    let mut likely: Vec<_> =
        asked.filter_map(|(m, kg)| Some((far(m, kg)?, words(m, kg).join(" and ")))).collect();
    likely.sort_by(|a, b| a.0.total_cmp(&b.0));
    let words = likely.into_iter().map(|pair| pair.1).collect::<Vec<_>>().join(", or in ");
    let shown = |all: &str, unit: &str| {
        let number = if all.split(',').all(bare) { format!("{all} {unit}") } else { with_unit(all, unit) };
        number.replace(['[', ']', '"', '\''], "")
    };
    let plain =
        format!("{} in {}", shown(mass, "kg"), shown(&sizes, "m").replace(", ", ",").replace(',', " × "));
    let none = (in_m == in_kg && far("m", "kg").is_none()).then(|| format!("{plain}: {NONE_IS}"));
    if words.is_empty() { none } else { Some(format!("{plain}: is this in {words}?")) }
}

/// The question for an unlikely density: `meant`, if the density times `times` is likely.
fn unlikely(density: f64, times: f64, meant: &'static str) -> Option<&'static str> {
    let said = if SOLIDS.contains(&(times * density)) { meant } else { NONE_IS };
    (!SOLIDS.contains(&density)).then_some(said)
}

/// As [`of`], of a density as written.
fn dense(written: &str) -> Option<String> {
    let table: Table = from_toml(&format!("density = {written}")).ok()?;
    let (unit, times) = if bare(written) { (" kg/m³", 1e3) } else { ("", 1.0) };
    let said = unlikely(number(&table.density), times, "is this in g/cm3?")?;
    Some(format!("{}{unit}: {said}", written.replace(['"', '\''], "")))
}

/// For a mesh without a unit: asks whether its numbers were intended in mm, by the volume that it encloses.
pub(crate) fn filled(mass: f64, volume: f64, set: bool) -> Option<String> {
    let times = if set { 1.0 } else { 1e9 };
    let said = unlikely(mass / volume, times, "is the mesh in mm, `unit = 0.001`?")?;
    Some(format!("{} kg in {} m³: {said}", short(mass), plain(volume)))
}

/// For an angle in degrees, given to hundredths: whether it would be a multiple of 15 degrees if it were in
/// rad.
pub(crate) fn turned(degrees: f64) -> Option<String> {
    let parts = (degrees / (PI / 12.0)).round();
    let near = (degrees - parts * PI / 12.0).abs() < 0.005 && (10.0 * degrees).fract() != 0.0;
    let (meant, none) = (15.0 * parts, if parts.abs() == 24.0 { ", which is no turn" } else { "" });
    let asked = format!("a turn by {degrees}° is small: is this in rad? In degrees it is {meant}{none}");
    (near && (1.0..=24.0).contains(&parts.abs())).then_some(asked)
}

/// For a mass and a tensor: asks whether a body can have both. Of all bodies with the same density, a ball
/// has the smallest trace.
pub(crate) fn spread(body: &BodyModel) -> Option<String> {
    let (mass, moments) = (body.mass?, body.principal().moments());
    let density = mass / (4.0 / 3.0 * PI * (5.0 / 6.0 * moments.sum() / mass).powf(1.5));
    let sizes = [(moments.max() / mass).sqrt(), body.reach()];
    let [radius, reach] = sizes.map(plain);
    let large = format!(": a ring with these has a radius of {radius} m; the drawing reaches {reach} m");
    let large = (!(0.1..100.0).contains(&(sizes[1] / sizes[0]))).then_some(large);
    let dense = format!(": a ball with these would need {density:.1e} kg/m³");
    let dense = if density.is_finite() { dense } else { String::new() };
    let why = (!(1e-3..SOLIDS.end).contains(&density)).then_some(dense).or(large)?;
    let [mass, most] = [short(mass), plain(moments.max())];
    Some(format!("{mass} kg and moments up to {most} kg m²{why}. Are the units right?"))
}

/// For parts, each with its size, m: asks whether a part equal to another in the same place was intended
/// twice, and whether a part farther from all others than ten times its own size was intended to be nearer.
pub(crate) fn placed(parts: &[(MassProperties, f64)]) -> Option<String> {
    let gap = |at: usize| {
        let others = (0..parts.len()).filter(|other| *other != at).map(|other| &parts[other]);
        let far = others.map(|(part, reach)| (part.centre() - parts[at].0.centre()).norm() - reach);
        far.fold(f64::INFINITY, f64::min)
    };
    // A body with more parts than this was not written by hand.
    let few = if parts.len() <= 100 { parts.len() } else { 0 };
    if let Some(at) = (0..few).find(|&at| parts[..at].contains(&parts[at])) {
        return Some(format!("part {} equals another in the same place: is it written twice?", at + 1));
    }
    let sizes = (0..few).map(|at| (2.0 * parts[at].1, gap(at)));
    let (size, gap) =
        sizes.into_iter().find(|(size, gap)| gap.is_finite() && *size > 0.0 && *gap > 10.0 * size)?;
    let [size, gap] = [size, gap].map(plain);
    Some(format!("a part {size} m large lies {gap} m from the others: is its place in cm, or in mm?"))
}
