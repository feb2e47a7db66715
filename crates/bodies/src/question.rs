//! Asks whether the input of a body is intended: its units, its mass and moments, its parts and their places.
//! (The questions on degrees and on fixed joints are asked where a robot is read.)

use crate::document::from_toml;
use crate::file::number;
use crate::model::BodyModel;
use crate::shape::{Weight, shaped};
use crate::table::{Given, Table};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::Range;
use tumbling::MassProperties;

/// Whether a number stands without its unit.
pub(crate) fn bare(number: &str) -> bool {
    !number.contains(['"', '\''])
}

/// The numbers of a field as written; one with a unit is in quotes.
fn numbers(written: &str) -> Vec<String> {
    let list = if written.starts_with('[') { written.into() } else { format!("[{written}]") };
    let all: BTreeMap<String, Vec<Given>> = from_toml(&format!("all = {list}")).unwrap_or_default();
    let one = |given| match given {
        Given::Number(number) => short(number),
        Given::Text(text) => format!("'{}'", text.trim()),
    };
    all.into_values().flatten().map(one).collect()
}

/// Each with a unit: this one, where it has none.
fn with_unit(numbers: &[String], unit: &str) -> Vec<String> {
    let one = |number: &String| if bare(number) { format!("'{number} {unit}'") } else { number.clone() };
    numbers.iter().map(one).collect()
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
pub(crate) fn of(text: &str, fields: &[(&str, Range<usize>)], name: &str, needed: &[&str]) -> Option<String> {
    // Thin bodies have no density in kg/m³, and vertices have no units.
    let thin = ["plate", "disk", "rod", "tetrahedron"].contains(&name);
    if let Some((_, span)) = fields.iter().find(|(field, _)| *field == "density") {
        return dense(&text[span.clone()]).filter(|_| !thin);
    }
    let given = fields.iter().filter(|(field, _)| needed.contains(field) || *field == "mass");
    let given: Vec<_> = given.map(|(field, span)| (*field, numbers(&text[span.clone()]))).collect();
    let ((_, mass), sizes) = given.split_last().filter(|_| !thin)?;
    let sizes: Vec<_> = sizes.iter().flat_map(|size| size.1.clone()).collect();
    let [in_kg, in_m] = [mass, &sizes].map(|all| all.iter().any(|number| bare(number)));
    // Where a solid can be so dense, how far it is from a thing in the hand, by density and mass.
    let far = |m: &str, kg: &str| {
        let line = |(field, all): &(&str, Vec<String>)| {
            let all = with_unit(all, if *field == "mass" { kg } else { m });
            let list = format!("[{}]", all.join(","));
            format!("{field} = {}", if all.len() == 1 { &all[0] } else { &list })
        };
        let table: Table = from_toml(&given.iter().map(line).collect::<Vec<_>>().join("\n")).ok()?;
        let density = number(&table.mass) / shaped(name, &table, Weight::Density(1.0)).ok()?.0.mass();
        let off = |x: f64, usual: f64| (x / usual).log10().abs();
        SOLIDS.contains(&density).then(|| off(density, 1e3) + off(number(&table.mass), 0.3))
    };
    let fits = far("m", "kg").is_some();
    if fits && mass.iter().chain(&sizes).all(|number| bare(number)) {
        return None;
    }
    let pairs = [("m", "g"), ("cm", "kg"), ("cm", "g"), ("mm", "kg"), ("mm", "g")];
    let asked = pairs.into_iter().filter(|(m, kg)| (in_m || *m == "m") && (in_kg || *kg == "kg"));
    let words = |m, kg| [in_m.then_some(m), in_kg.then_some(kg)].into_iter().flatten().collect::<Vec<_>>();
    let mut likely: Vec<_> =
        asked.filter_map(|(m, kg)| Some((far(m, kg)?, words(m, kg).join(" and ")))).collect();
    likely.sort_by(|a, b| a.0.total_cmp(&b.0));
    let words = likely.into_iter().map(|pair| pair.1).collect::<Vec<_>>().join(", or in ");
    let shown = |all: &[String], unit: &str| with_unit(all, unit).join(" × ").replace('\'', "");
    let plain = format!("{} in {}", shown(mass, "kg"), shown(&sizes, "m"));
    let none = (!fits).then(|| format!("{plain}: {NONE_IS}"));
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
