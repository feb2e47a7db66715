//! Which equation of the book means which functions of the library; and what is no claim.

use super::{bodies, motion};
use crate::tex::{Scope, Statement};

/// An equation that a chapter states, and what its names stand for.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// The chapter's file, without ending.
    pub chapter: &'static str,
    /// Its left side as written, by which it is found: laws with one left side stand in the order of the chapter.
    pub left: &'static str,
    /// What it is proven to be.
    pub says: &'static str,
    /// The meanings of its names; in each it must hold.
    pub cases: &'static [fn() -> Scope],
    /// For a bound: meanings in which its two sides are equal, so that no weaker bound passes.
    pub attained: &'static [fn() -> Scope],
    /// For an example: what it says in general, or why it is none of that.
    pub in_general: fn(&Statement) -> Result<Statement, String>,
    /// For an example with numbers: the values of its variables there. Without any, no number is passed.
    pub example: &'static [(&'static str, i64)],
    /// Whether it is a bare expression, the sentence around it saying what it is; then `left` is all of it.
    pub bare: bool,
}

impl Law {
    /// Proves it as stated.
    ///
    /// # Errors
    /// What is left over, or why the statement has no meaning.
    pub fn prove(&self, statement: &Statement) -> Result<(), String> {
        if self.bare {
            return self.cases.iter().try_for_each(|case| statement.prove_worth(&case()));
        }
        if statement.gives_values() {
            return Err("gives nothing but values where a law is expected".to_owned());
        }
        let mut statement = statement.clone();
        if !self.example.is_empty() {
            for case in self.cases {
                statement = statement.prove_example(&case(), self.example)?;
            }
        }
        let statement = &(self.in_general)(&statement)?;
        for case in self.cases {
            statement.prove(&case())?;
        }
        let not_attained = |problem| format!("a bound that is not attained: {problem}");
        for case in self.attained {
            statement.prove_attained(&case()).map_err(not_attained)?;
        }
        Ok(())
    }
}

impl Law {
    /// Whether each side of two statements of it is worth the same, in every meaning of their names.
    pub(super) fn says_the_same(&self, a: &Statement, b: &Statement) -> bool {
        if self.bare {
            return true;
        }
        match ((self.in_general)(a), (self.in_general)(b)) {
            (Ok(a), Ok(b)) => self.cases.iter().all(|case| a.same_sides(&b, &case())),
            _ => false,
        }
    }
}

/// An equation that claims nothing about the library.
#[derive(Debug, Clone, Copy)]
pub struct Exemption {
    /// The chapter's file, without ending.
    pub chapter: &'static str,
    /// All of it, as written.
    pub tex: &'static str,
    /// Why it is no claim.
    pub reason: &'static str,
}

const fn law(
    chapter: &'static str,
    left: &'static str,
    cases: &'static [fn() -> Scope],
    says: &'static str,
) -> Law {
    Law {
        chapter,
        left,
        says,
        cases,
        attained: &[],
        example: &[],
        in_general: |statement| Ok(statement.clone()),
        bare: false,
    }
}

const fn bare(
    chapter: &'static str,
    tex: &'static str,
    cases: &'static [fn() -> Scope],
    says: &'static str,
) -> Law {
    Law { bare: true, ..law(chapter, tex, cases, says) }
}

/// The laws that the book states.
#[must_use]
pub fn laws() -> &'static [Law] {
    use bodies::{axis, body, piece, planar, the_box, the_box_spun};
    use motion::{
        attitude, energy, equal_moments, frozen, grows, momentum_for_spin, rates, summit, swings,
        world_inverse, world_tensor,
    };
    const LAWS: &[Law] = &[
        bare(
            "matrix-mass",
            r"\boldsymbol{\omega}\times\mathbf{r}",
            &[motion::carried_round],
            "the rate of a turning place, by attitude::rate",
        ),
        bare(
            "matrix-mass",
            r"\mathbf{r}\times m(\boldsymbol{\omega}\times\mathbf{r})",
            &[bodies::moving_piece],
            "inertia::point_mass times the spin",
        ),
        bare(
            "matrix-mass",
            r"\sum mxy",
            &[bodies::product_without_minus],
            "the product in inertia::point_mass of any points, without the minus",
        ),
        bare(
            "eulers-equations",
            r"-\boldsymbol{\omega}\times\mathbf{v}",
            &[motion::seen_from_the_body],
            "the rate by euler::momentum_rate of an arrow that nothing turns in the room",
        ),
        bare("two-arrows", "b/a", &[motion::slopes], "by what the momentum's slope exceeds the spin's"),
        bare(
            "two-arrows",
            r"\mathbf{L}\cdot\boldsymbol{\omega}",
            &[bodies::twice_the_energy],
            "twice the sum of m v²/2 of any points",
        ),
        bare(
            "glossary",
            r"(I\boldsymbol{\omega})\times\boldsymbol{\omega}",
            &[motion::gyroscopic],
            "euler::tensor_times_acceleration without torque",
        ),
        bare(
            "proofs",
            r"\boldsymbol{\omega}\cdot I\dot{\boldsymbol{\omega}}",
            &[motion::power],
            "the rate of observe::energy by euler::angular_acceleration",
        ),
        law("proofs", "I_2", &[motion::in_order], "symbols::ordered_moments"),
        law("proofs", "I_3", &[motion::in_order], "symbols::ordered_moments"),
        Law {
            attained: &[equal_moments],
            ..law("proofs", r"\lambda^2", grows::BOTH, "stability::rate_squared, about the middle")
        },
        bare(
            "proofs",
            "(a^2-b^2)/(a^2+b^2+2c^2)",
            &[bodies::box_gap],
            "the tangent of the gap by Cuboid::moments and euler::coupling",
        ),
        law(
            "matrix-mass",
            r"\mathbf{L}",
            &[body],
            "the momentum of any points is inertia::point_mass of them times the spin",
        ),
        law("matrix-mass", r"\begin{pmatrix}L_x\\L_y\\L_z\end{pmatrix}", &[body], "the same, entry by entry"),
        law("matrix-mass", r"I_{\text{piece}}", &[piece], "inertia::point_mass"),
        law("matrix-mass", r"\mathbf{L}", &[body], "the same, in the remark on signs"),
        law("worked-example", r"I_{xx}", &[the_box], "Cuboid::moments, about x"),
        law("worked-example", r"I_{yy}", &[the_box], "Cuboid::moments, about y"),
        law("worked-example", r"I_{zz}", &[the_box], "Cuboid::moments, about z"),
        Law {
            in_general: bodies::for_any_spin,
            example: &[("m", 1), ("a", 2), ("b", 1), ("c", 3)],
            ..law(
                "worked-example",
                r"\mathbf{L}",
                &[the_box_spun],
                "inertia::omega_world gives back the spin, here (1, 1, 0)",
            )
        },
        law("two-arrows", r"\mathbf{L}", &[planar], "inertia::omega_world gives back the spin"),
        law(
            "two-arrows",
            r"\tan\theta",
            &[summit],
            "where the derivative of the gap is zero, by euler::coupling",
        ),
        law("two-arrows", r"\sin(\text{gap})", &[summit], "the gap there, by euler::coupling"),
        law(
            "principal-axes",
            r"\mathbf{L}",
            &[|| axis(0), || axis(1), || axis(2)],
            "about each axis, inertia::omega_world gives back the spin",
        ),
        Law {
            attained: &[bodies::flat],
            ..law(
                "principal-axes",
                "I_1+I_2",
                &[body],
                "the diagonal of inertia::point_mass, of any points; an equality for flat bodies",
            )
        },
        law(
            "body-and-world",
            r"I_{\text{world}}",
            world_tensor::CASES,
            "inertia::turned, and inertia::point_mass of turned points",
        ),
        law("body-and-world", r"I_{\text{world}}^{-1}", &[world_inverse], "the inverse of inertia::turned"),
        law("body-and-world", r"\boldsymbol{\omega}", &[world_inverse], "inertia::omega_world"),
        law("eulers-equations", r"\dot{\mathbf{L}}", rates::ALL, "euler::momentum_rate"),
        law(
            "eulers-equations",
            r"\dot{\mathbf{L}}",
            rates::ALL,
            "euler::momentum_rate and euler::tensor_times_acceleration",
        ),
        law(
            "eulers-equations",
            r"I\dot{\boldsymbol{\omega}}",
            rates::ALL,
            "euler::angular_acceleration, and euler::tensor_times_acceleration",
        ),
        law("eulers-equations", r"I_1\dot{\omega}_1", &[rates::free], "euler::angular_acceleration, first"),
        law("eulers-equations", r"I_2\dot{\omega}_2", &[rates::free], "euler::angular_acceleration, second"),
        law("eulers-equations", r"I_3\dot{\omega}_3", &[rates::free], "euler::angular_acceleration, third"),
        law("eulers-equations", r"\dot{\mathbf{L}}", rates::ALL, "euler::momentum_rate"),
        law(
            "eulers-equations",
            "E",
            &[energy, body],
            "observe::energy, and half the sum of m v² over any points",
        ),
        law("eulers-equations", r"\lambda^2", &[motion::wobble], "stability::rate_squared"),
        Law {
            attained: &[equal_moments],
            ..law(
                "eulers-equations",
                r"\lambda^2",
                swings::BOTH,
                "stability::rate_squared, about the largest and the smallest",
            )
        },
        Law {
            attained: &[equal_moments],
            ..law("eulers-equations", r"\lambda^2", grows::BOTH, "stability::rate_squared, about the middle")
        },
        law(
            "three-pitfalls",
            r"I_{\text{body}}\dot{\boldsymbol{\omega}}",
            &[frozen],
            "Engine::Frozen's rate, wrong as it is",
        ),
        law(
            "three-pitfalls",
            r"\boldsymbol{\omega}",
            &[momentum_for_spin],
            "Engine::MomentumForSpin's omega_world, wrong as it is",
        ),
        law(
            "notation",
            r"\mathbf{L}",
            &[body],
            "the momentum of any points is inertia::point_mass of them times the spin",
        ),
        law("notation", r"I_{xy}", &[body], "the product in inertia::point_mass, of any points"),
        law("notation", r"\dot{q}", &[attitude], "attitude::rate"),
        law(
            "notation",
            r"\mathbf{v}_{\text{world}}",
            &[attitude],
            "q v q* by attitude::product, with attitude::rotation_matrix",
        ),
    ];
    LAWS
}

const fn exempt(chapter: &'static str, tex: &'static str, reason: &'static str) -> Exemption {
    Exemption { chapter, tex, reason }
}

/// Equations that claim nothing about the library.
#[must_use]
pub fn exemptions() -> &'static [Exemption] {
    const EXEMPTIONS: &[Exemption] = &[
        exempt(
            "matrix-mass",
            r"\mathbf{p}=m\mathbf{v}",
            "the momentum of what slides, for comparison; the library has only what turns",
        ),
        exempt("matrix-mass", r"\mathbf{r}=(x,y,z)", "names the coordinates"),
        exempt(
            "principal-axes",
            r"I=\begin{pmatrix}I_1&0&0\\0&I_2&0\\0&0&I_3\end{pmatrix}",
            "the form of a diagonal matrix; that the library finds one is tested on floats, for it takes roots",
        ),
        exempt("principal-axes", r"I_1\le I_2\le I_3", "the order in which we name them"),
        exempt("two-arrows", "a<b", "the order in which we name them"),
    ];
    EXEMPTIONS
}

/// Bare expressions that name a thing and say nothing about it; each stands once for each time it is written, inline.
#[must_use]
pub fn notation() -> &'static [Exemption] {
    const JACOBI: &str = "the name of a function; what it does is proven in closed_forms";
    const NOTATION: &[Exemption] = &[
        exempt("body-and-world", r"R^{\mathsf{T}}", "names the transpose; the law beside it uses it"),
        exempt(
            "eulers-equations",
            r"e^{\lambda t}",
            "the solution of x'' = rate² x; the rate is what is proven",
        ),
        exempt("exact-motion", r"\operatorname{sn}", JACOBI),
        exempt("exact-motion", r"\operatorname{cn}", JACOBI),
        exempt("exact-motion", r"\operatorname{dn}", JACOBI),
        exempt("proofs", r"\lambda^2", "the left side of the law that follows in the sentence"),
        exempt("proofs", r"I\dot{\boldsymbol{\omega}}", "the left side of the law that the sentence names"),
    ];
    NOTATION
}
