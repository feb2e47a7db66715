//! The colours of exported drawings: plain ones, for programs that know no style sheets.

use crate::ink::Ink;

/// How an exported drawing looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theme {
    /// The pages' colours by day, on white.
    Light,
    /// The pages' colours by night, on dark blue.
    Navy,
    /// For paper: black on white, in colours that differ as greys too.
    Print,
}

/// The fonts that exported drawings name: `tumbling-media` carries them.
const SANS: &str = "Tumbling Sans";
const SYMBOLS: &str = "Tumbling Symbols";

/// The inks in the order of the palette: text, spin, momentum, three axes, separatrix, wrong, surface, paper,
/// faint.
type Colours = [&'static str; 11];

const LIGHT: Colours = [
    "#23211d", "#0068a8", "#a85a00", "#00755c", "#a3217f", "#6f6200", "#5a4fb0", "#c5281c", "#dde8ef",
    "#ffffff", "#848380",
];

const NAVY: Colours = [
    "#cfd1e3", "#56b4e9", "#f0a030", "#3ecf9f", "#ea8bc8", "#d8c84a", "#a99cf5", "#ff7a5c", "#263040",
    "#161923", "#7e808f",
];

const PRINT: Colours = [
    "#000000", "#003f7a", "#d07000", "#004d38", "#b0307f", "#a08a00", "#1e0a5c", "#c4281b", "#e6e6e6",
    "#ffffff", "#8c8c8c",
];

impl Theme {
    /// Every one.
    pub const ALL: [Self; 3] = [Self::Light, Self::Navy, Self::Print];

    /// Its name, in one word.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Navy => "navy",
            Self::Print => "print",
        }
    }

    fn colours(self) -> &'static Colours {
        match self {
            Self::Light => &LIGHT,
            Self::Navy => &NAVY,
            Self::Print => &PRINT,
        }
    }

    /// Red, green and blue of each ink, the ground first.
    #[must_use]
    pub fn inks(self) -> Vec<[u8; 3]> {
        let channel = |hex: &str, at| u8::from_str_radix(&hex[at..at + 2], 16).unwrap_or(0);
        let mut inks: Vec<_> =
            self.colours().iter().map(|hex| [1, 3, 5].map(|at| channel(hex, at))).collect();
        inks.swap(0, Ink::Paper.index());
        inks
    }

    /// A drawing of this crate in these colours: without style sheet, on a ground of its own, its letters in
    /// the fonts of `tumbling-media`.
    #[must_use]
    pub fn dressed(self, svg: &str) -> String {
        let colours = self.colours();
        let bare = without_style(svg).replace("currentColor", colours[Ink::Text.index()]);
        let mut out = String::with_capacity(bare.len());
        let mut rest = bare.as_str();
        while let Some((before, found)) = rest.split_once("var(") {
            let (inside, after) = found.split_once(')').unwrap_or((found, ""));
            let (property, fallback) = inside.split_once(',').unwrap_or((inside, ""));
            out.push_str(before);
            out.push_str(match property {
                "--fig-font" => SANS,
                "--fig-symbols" => SYMBOLS,
                _ => Ink::of_property(property).map_or(fallback, |ink| colours[ink.index()]),
            });
            rest = after;
        }
        out.push_str(rest);
        with_ground(&out, colours[Ink::Paper.index()])
    }
}

fn without_style(svg: &str) -> String {
    let Some((before, rest)) = svg.split_once("<style>") else { return svg.to_owned() };
    format!("{before}{}", rest.split_once("</style>\n").map_or(rest, |(_, x)| x))
}

/// With its height in the document, and a sheet of this colour below everything.
fn with_ground(svg: &str, paper: &str) -> String {
    let sheet = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once('"'));
    let Some(((wide, high), (head, marks))) =
        sheet.and_then(|(size, _)| size.split_once(' ')).zip(svg.split_once("<g "))
    else {
        return svg.to_owned();
    };
    let height = |wide: f64, high: f64| -> Option<f64> {
        let width: f64 = head.split_once("width=\"")?.1.split_once('"')?.0.parse().ok()?;
        Some(width * high / wide)
    };
    let height = wide.parse().ok().zip(high.parse().ok()).and_then(|(wide, high)| height(wide, high));
    let said = height.map_or_else(String::new, |height| format!(" height=\"{height}\""));
    let head = head.replacen(" viewBox=", &format!("{said} viewBox="), 1);
    format!("{head}<path d=\"M0 0h{wide}v{high}h-{wide}z\" fill=\"{paper}\"/>\n<g {marks}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE 1976 lightness, 0 to 100: the grey in which a colour is printed.
    fn lightness(hex: &str) -> f64 {
        let channel = |at: usize| {
            let c = f64::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        let y = 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
        if y > 0.008856 { 116.0 * y.cbrt() - 16.0 } else { 903.3 * y }
    }

    #[test]
    fn what_stands_side_by_side_differs_in_greys_too() {
        let grey = |ink: Ink| lightness(PRINT[ink.index()]);
        for group in [
            &[Ink::Omega, Ink::Momentum][..],
            &[Ink::Separatrix, Ink::AxisMin, Ink::AxisMid, Ink::AxisMax],
            &[Ink::Text, Ink::Wrong, Ink::Faint],
            &[Ink::Paper, Ink::Surface],
        ] {
            for (i, &one) in group.iter().enumerate() {
                for &other in &group[..i] {
                    let apart = (grey(one) - grey(other)).abs();
                    assert!(apart > 8.0, "{one:?} and {other:?} are {apart:.1} apart");
                }
            }
        }
    }

    #[test]
    fn every_ink_stands_out_from_its_ground_in_every_theme_and_in_a_drawing_alone() {
        let themes = Theme::ALL.map(|theme| (theme.name(), *theme.colours()));
        for (theme, colours) in themes.into_iter().chain(crate::ink::alone()) {
            let ratio = |ink: Ink| {
                // From lightness back to luminance, for the contrast that WCAG defines.
                let y = |hex| ((lightness(hex) + 16.0) / 116.0_f64).powi(3) + 0.05;
                let (a, b) = (y(colours[ink.index()]), y(colours[Ink::Paper.index()]));
                a.max(b) / a.min(b)
            };
            for index in 0..colours.len() {
                let ink = Ink::from_index(index);
                let least = match ink {
                    Ink::Paper | Ink::Surface => continue,
                    Ink::Text => 7.0,
                    _ => 3.0,
                };
                assert!(ratio(ink) >= least, "{theme} {ink:?}: {:.2}", ratio(ink));
            }
        }
    }

    #[test]
    fn a_page_s_colours_become_plain_ones_and_the_rest_stays() {
        let svg = "<svg width=\"5\" viewBox=\"0 0 50 100\" fill=\"currentColor\">\n<style>a{}</style>\n<g fill=\"none\">\n\
                   <path style=\"fill:var(--fig-omega,#0072b2);stroke:currentColor\"/></g></svg>";
        let out = Theme::Print.dressed(svg);
        assert_eq!(
            out,
            "<svg width=\"5\" height=\"10\" viewBox=\"0 0 50 100\" fill=\"#000000\">\n\
             <path d=\"M0 0h50v100h-50z\" fill=\"#ffffff\"/>\n<g fill=\"none\">\n\
             <path style=\"fill:#003f7a;stroke:#000000\"/></g></svg>"
        );
    }
}
