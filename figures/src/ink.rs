//! The palette: one colour, one meaning, in every figure. A page may set its own values.

/// The meaning of a mark, which determines its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ink {
    /// Right results, and all plain lines and letters: the colour of the text around the figure.
    Text,
    /// Angular velocity.
    Omega,
    /// Angular momentum.
    Momentum,
    /// The principal axis with the smallest moment.
    AxisMin,
    /// The middle one.
    AxisMid,
    /// The one with the largest moment.
    AxisMax,
    /// The curve between two kinds of motion.
    Separatrix,
    /// Results of a wrong program.
    Wrong,
    /// The surface of a body.
    Surface,
    /// The background of the figure.
    Paper,
    /// Grid lines, hidden edges, remarks.
    Faint,
}

struct Shade {
    ink: Ink,
    /// The custom property that a page may set.
    property: &'static str,
    light: &'static str,
    dark: &'static str,
}

const fn shade(ink: Ink, property: &'static str, light: &'static str, dark: &'static str) -> Shade {
    Shade { ink, property, light, dark }
}

/// The colours of a figure that stands alone: blue, orange and the others after Okabe and Ito, darkened or
/// lightened until each has a contrast of 3 : 1 or more with its ground (the body's surface excepted).
const SHADES: [Shade; 11] = [
    shade(Ink::Text, "color", "#1f2328", "#e6edf3"),
    shade(Ink::Omega, "--fig-omega", "#0072b2", "#56b4e9"),
    shade(Ink::Momentum, "--fig-momentum", "#c06a00", "#f0a030"),
    shade(Ink::AxisMin, "--fig-axis-min", "#00805f", "#2fc79a"),
    shade(Ink::AxisMid, "--fig-axis-mid", "#b0307f", "#f08cc6"),
    shade(Ink::AxisMax, "--fig-axis-max", "#7d6c00", "#dcc84f"),
    shade(Ink::Separatrix, "--fig-separatrix", "#5b3fa8", "#b9a3ff"),
    shade(Ink::Wrong, "--fig-wrong", "#c4281b", "#ff7a66"),
    shade(Ink::Surface, "--fig-surface", "#e3eaf0", "#2a333c"),
    shade(Ink::Paper, "--fig-paper", "#ffffff", "#0d1117"),
    shade(Ink::Faint, "--fig-faint", "#848b94", "#848d97"),
];

impl Ink {
    /// The colour as CSS has it: the page's own, or else this one.
    pub(crate) fn css(self) -> String {
        let shade = &SHADES[self.index()];
        let own = format!("var({},{})", shade.property, shade.light);
        if self == Self::Text { "currentColor".into() } else { own }
    }

    /// A number for this ink inside plotters, which has only red, green and blue.
    pub(crate) fn index(self) -> usize {
        SHADES.iter().position(|shade| shade.ink == self).unwrap_or(0)
    }

    /// The ink whose colour a page sets by this custom property.
    pub(crate) fn of_property(property: &str) -> Option<Self> {
        SHADES.iter().find(|shade| shade.property == property).map(|shade| shade.ink)
    }

    /// The ink behind such a number.
    pub(crate) fn from_index(index: usize) -> Self {
        SHADES.get(index).map_or(Self::Text, |shade| shade.ink)
    }
}

/// The style sheet of a figure that is opened or embedded by itself. `svg:root` matches only there: in a
/// page the root is the page, and the page's own theme holds.
pub(crate) fn stand_alone_style() -> String {
    style_of("svg:root")
}

/// The palette for the elements that a selector picks, for a light and for a dark ground.
pub(crate) fn style_of(selector: &str) -> String {
    let list = |pick: fn(&Shade) -> &'static str| -> String {
        SHADES.iter().map(|shade| format!("{}:{};", shade.property, pick(shade))).collect()
    };
    format!(
        "{selector}{{color-scheme:light dark;{}}}@media (prefers-color-scheme:dark){{{selector}{{{}}}}}",
        list(|s| s.light),
        list(|s| s.dark)
    )
}

/// The colours on a light and on a dark ground.
#[cfg(test)]
pub(crate) fn alone() -> [(&'static str, [&'static str; 11]); 2] {
    [("alone", SHADES.map(|shade| shade.light)), ("alone, dark", SHADES.map(|shade| shade.dark))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ink_survives_the_way_through_plotters() {
        assert!(SHADES.iter().all(|shade| Ink::from_index(shade.ink.index()) == shade.ink));
    }
}
