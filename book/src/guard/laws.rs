//! Which laws each chapter states, in its order, and which of its maths claims nothing.

use tumbling_proofs::equations::{Exemption, Expected, laws};

const fn exempt(tex: &'static str, reason: &'static str) -> Exemption {
    Exemption { tex, reason }
}

/// Chapters by the names of their files. Bare expressions that name a thing and say nothing about it are
/// notation, each once for each time it is written, inline.
pub(super) const CHAPTERS: &[(&str, Expected)] = &[
    (
        "matrix-mass",
        Expected {
            laws: &[
                laws::VELOCITY,
                laws::MOMENTUM_OF_A_PIECE,
                laws::FIRST_OF_A_PIECE,
                laws::FIRST_OF_A_PIECE,
                laws::PRODUCT_WITHOUT_MINUS,
                laws::MOMENTUM,
                laws::MOMENTUM_BY_ENTRY,
                laws::TENSOR_OF_A_PIECE,
                laws::MOMENTUM,
            ],
            exemptions: &[
                exempt(
                    r"\mathbf{p}=m\mathbf{v}",
                    "the momentum of what slides, for comparison; the library has only what turns",
                ),
                exempt(r"\mathbf{r}=(x,y,z)", "names the coordinates"),
            ],
            notation: &[],
        },
    ),
    (
        "principal-axes",
        Expected {
            laws: &[
                laws::AXIS_MOMENTUM,
                laws::PARALLEL_AXES,
                laws::SUM_ABOUT_1,
                laws::SUM_ABOUT_2,
                laws::SUM_ABOUT_3,
                laws::THIRD_INEQUALITY,
                laws::TRIANGLE,
            ],
            exemptions: &[
                exempt(
                    r"I=\begin{pmatrix}I_1&0&0\\0&I_2&0\\0&0&I_3\end{pmatrix}",
                    "the form of a diagonal matrix; that the library finds one is tested on floats, for it takes roots",
                ),
                exempt(r"I_1\le I_2\le I_3", "the order in which we name them"),
            ],
            notation: &[],
        },
    ),
    (
        "two-arrows",
        Expected {
            laws: &[
                laws::SLOPES,
                laws::TWICE_THE_ENERGY,
                laws::PLANAR_MOMENTUM,
                laws::SUMMIT_ANGLE,
                laws::SUMMIT_GAP,
            ],
            exemptions: &[exempt("a<b", "the order in which we name them")],
            notation: &[],
        },
    ),
    (
        "worked-example",
        Expected {
            laws: &[laws::BOX_ABOUT_X, laws::BOX_ABOUT_Y, laws::BOX_ABOUT_Z, laws::BOX_MOMENTUM],
            exemptions: &[],
            notation: &[],
        },
    ),
    (
        "body-and-world",
        Expected {
            laws: &[laws::WORLD_TENSOR, laws::WORLD_INVERSE, laws::WORLD_SPIN],
            exemptions: &[],
            notation: &[exempt(r"R^{\mathsf{T}}", "names the transpose; the law beside it uses it")],
        },
    ),
    (
        "eulers-equations",
        Expected {
            laws: &[
                laws::FROM_REST,
                laws::RATE_SEEN_FROM_THE_BODY,
                laws::MOMENTUM_RATE,
                laws::MOMENTUM_RATE_BY_ACCELERATION,
                laws::ACCELERATION,
                laws::EULER_1,
                laws::EULER_2,
                laws::EULER_3,
                laws::MOMENTUM_RATE,
                laws::ENERGY,
                laws::LINEARISED_A,
                laws::LINEARISED_B,
                laws::LINEARISED_TWICE,
                laws::WOBBLE,
                laws::SWING,
                laws::GROWTH,
            ],
            exemptions: &[],
            notation: &[exempt(
                r"e^{\lambda t}",
                "the solution of x'' = rate² x; the rate is what is proven",
            )],
        },
    ),
    (
        "three-pitfalls",
        Expected { laws: &[laws::FROZEN_TENSOR, laws::MOMENTUM_FOR_SPIN], exemptions: &[], notation: &[] },
    ),
    (
        "dzhanibekov",
        Expected {
            laws: &[laws::ENERGY_ELLIPSOID, laws::MOMENTUM_ELLIPSOID],
            exemptions: &[],
            notation: &[],
        },
    ),
    (
        "coin",
        Expected {
            laws: &[
                laws::COIN_1,
                laws::COIN_2,
                laws::COIN_RATE,
                laws::COIN_COSINE,
                laws::COIN_SINE,
                laws::COIN_SPIN,
                laws::COIN_AXIS,
            ],
            exemptions: &[exempt(r"\phi=\Omega t", "names the angle")],
            notation: &[],
        },
    ),
    (
        "exact-motion",
        Expected {
            laws: &[
                laws::JACOBI_SN,
                laws::JACOBI_CN,
                laws::JACOBI_DN,
                laws::JACOBI_1,
                laws::JACOBI_2,
                laws::JACOBI_3,
                laws::JACOBI_RATE,
                laws::JACOBI_PARAMETER,
                laws::JACOBI_A1,
                laws::JACOBI_A2,
                laws::JACOBI_A3,
            ],
            exemptions: &[],
            notation: &[],
        },
    ),
    ("a-top", Expected { laws: &[laws::STEADY_TOP, laws::SLEEPING_TOP], exemptions: &[], notation: &[] }),
    (
        "stepping-through-time",
        Expected {
            laws: &[
                laws::EXPLICIT_STEP,
                laws::EXPLICIT_GAIN,
                laws::TURN_ANGLE,
                laws::TURN_J,
                laws::TURN_K,
                laws::MEAN_MOMENTUM,
                laws::MIDPOINT_STEP,
                laws::MIDPOINT_WORK,
                laws::DISCRETE_START,
                laws::DISCRETE_END,
            ],
            exemptions: &[],
            notation: &[
                exempt(r"\frac{1906}{195}\,h^2", "a term of a power series, held by an assertion beside it"),
                exempt(
                    r"\frac{19849}{63375}\,h^5",
                    "a term of a power series, held by an assertion beside it",
                ),
            ],
        },
    ),
    (
        "where-things-break",
        Expected {
            laws: &[laws::NEWTON_MATRIX],
            exemptions: &[],
            notation: &[
                exempt(r"A\boldsymbol{\delta}", "the left side of the law that follows in the sentence"),
                exempt(
                    r"h\,(I\boldsymbol{\omega})\times\boldsymbol{\omega}",
                    "what the sentence sets it equal to; held by an assertion below",
                ),
                exempt(r"h\,\boldsymbol{\tau}\cdot J\mathbf{M}", "a law of the chapter on steps, repeated"),
                exempt(r"-c\,\boldsymbol{\omega}", "names a drag"),
                exempt("hc", "names a product; the sentence compares it with the moments"),
                exempt("hc", "names a product; the sentence compares it with the moments"),
            ],
        },
    ),
    (
        "proofs",
        Expected {
            laws: &[laws::POWER, laws::MIDDLE_MOMENT, laws::LARGEST_MOMENT, laws::GROWTH, laws::GAP_OF_A_BOX],
            exemptions: &[],
            notation: &[
                exempt(r"\lambda^2", "the left side of the law that follows in the sentence"),
                exempt(r"I\dot{\boldsymbol{\omega}}", "the left side of the law that the sentence names"),
            ],
        },
    ),
    (
        "notation",
        Expected {
            laws: &[laws::MOMENTUM, laws::PRODUCT_OF_INERTIA, laws::ATTITUDE_RATE, laws::ROTATED],
            exemptions: &[],
            notation: &[],
        },
    ),
    ("glossary", Expected { laws: &[laws::GYROSCOPIC_TORQUE], exemptions: &[], notation: &[] }),
];

/// What is expected of a chapter.
pub(super) fn of(chapter: &str) -> Expected {
    CHAPTERS.iter().find(|known| known.0 == chapter).map_or(Expected::NOTHING, |known| known.1)
}
