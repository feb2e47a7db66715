//! The laws that each chapter states, in its order, and its maths that states nothing.

use crate::site::{files, paths};
use serde::Deserialize;
use std::sync::OnceLock;
use tumbling_proofs::equations::laws::*;
use tumbling_proofs::equations::{Exemption, Expected};

/// Chapters by the names of their files, with their laws.
#[rustfmt::skip]
pub(super) const CHAPTERS: &[(&str, &[Law])] = &[
    ("matrix-mass", &[VELOCITY, MOMENTUM_OF_A_PIECE, FIRST_OF_A_PIECE, FIRST_OF_A_PIECE,
        PRODUCT_WITHOUT_MINUS, MOMENTUM, MOMENTUM_BY_ENTRY, TENSOR_OF_A_PIECE, MOMENTUM]),
    ("principal-axes", &[AXIS_MOMENTUM, PRODUCT_WHEN_TURNED, PARALLEL_AXES, SUM_ABOUT_1, SUM_ABOUT_2,
        SUM_ABOUT_3, THIRD_INEQUALITY, TRIANGLE]),
    ("two-arrows", &[SLOPES, TWICE_THE_ENERGY, PLANAR_MOMENTUM, TANGENT_OF_THE_GAP, SUMMIT_ANGLE,
        SUMMIT_GAP]),
    ("worked-example", &[BOX_ABOUT_X, BOX_ABOUT_Y, BOX_ABOUT_Z, BOX_MOMENTUM]),
    ("body-and-world", &[WORLD_TENSOR, WORLD_INVERSE, WORLD_SPIN]),
    ("eulers-equations", &[FROM_REST, RATE_SEEN_FROM_THE_BODY, MOMENTUM_RATE, MOMENTUM_RATE_BY_ACCELERATION,
        ACCELERATION, EULER_1, EULER_2, EULER_3, MOMENTUM_RATE, ENERGY, LINEARISED_A, LINEARISED_B,
        LINEARISED_TWICE, WOBBLE, SWING, GROWTH]),
    ("why-the-middle-one", &[DIFFERENCE_OF_MOMENTS, WOBBLE]),
    ("three-pitfalls", &[FROZEN_TENSOR, MOMENTUM_FOR_SPIN]),
    ("dzhanibekov", &[ENERGY_ELLIPSOID, MOMENTUM_ELLIPSOID, WOBBLE]),
    ("coin", &[COIN_1, COIN_2, COIN_RATE, COIN_COSINE, COIN_SINE, COIN_SPIN, COIN_AXIS]),
    ("exact-motion", &[JACOBI_1, JACOBI_2, JACOBI_3, JACOBI_RATE, JACOBI_PARAMETER, JACOBI_A1, JACOBI_A2,
        JACOBI_A3]),
    ("a-top", &[STEADY_TOP, NODDING_TOP, SLEEPING_TOP]),
    ("closed-form", &[CLOSED_EULER_X, CLOSED_EULER_M, CLOSED_EULER_C, CLOSED_DISTANCES,
        CLOSED_DISTANCES_BY_MOMENTS, CLOSED_ENERGY, CLOSED_MOMENTUM, CLOSED_DISCRIMINANT, CLOSED_WITHOUT_C,
        CLOSED_WITHOUT_X, CLOSED_P, CLOSED_Q, CLOSED_ELLIPSE, CLOSED_CIRCLED, CLOSED_MODULUS,
        CLOSED_COMPLEMENT, CLOSED_AX, CLOSED_AM, CLOSED_AC, CLOSED_BALANCE, CLOSED_RATE, CLOSED_RATE_SQUARED,
        CLOSED_X, CLOSED_M, CLOSED_C, CLOSED_SN, CLOSED_CN, CLOSED_DN, CLOSED_PHASE_ERROR, CLOSED_SIZE_ERROR,
        THETA_3, THETA_4, THETA_2, THETA_1, SN_BY_THETAS, CN_BY_THETAS, DN_BY_THETAS, CLOSED_SHARE,
        CLOSED_BETA, CLOSED_GAMMA, CLOSED_DELTA, CLOSED_TURNING, ZERO_H1, ZERO_L1, ZERO_H2, ZERO_L2, ZERO_H3,
        ZERO_L3, DIRECT_A1, DIRECT_A2, ZERO_C1, ZERO_D1, ZERO_C2, ZERO_D2, DIRECT_B1, DIRECT_B2, CLOSED_TILT,
        CLOSED_DRIFT, ZERO_TURNING, COMPLEMENTARY_THETA_1, COMPLEMENTARY_THETA_2, COMPLEMENTARY_THETA_3,
        COMPLEMENTARY_THETA_4, COMPLEMENTARY_N_2, COMPLEMENTARY_N_3, COMPLEMENTARY_N_4, SN_NEAR_THE_FLIP,
        CN_NEAR_THE_FLIP, DN_NEAR_THE_FLIP, SN_NEAR_THE_SADDLE, CN_NEAR_THE_SADDLE, DN_NEAR_THE_SADDLE,
        COMPLEMENTARY_A1, COMPLEMENTARY_A2, COMPLEMENTARY_B1, COMPLEMENTARY_B2, CLOSED_TURNING_AT_THE_SADDLE,
        CLOSED_DRIFT_AT_THE_SADDLE, COIN_RATE, CLOSED_AX, CLOSED_AC, CLOSED_COMPLEMENT_SQUARED, CLOSED_R,
        CLOSED_S, CLOSED_T, VARIATION, CARLSON_FIRST, CARLSON_SECOND]),
    ("top-closed-form", &[HEAVY_VERTICAL, HEAVY_HEIGHT, HEAVY_ALONG, HEAVY_PULL, HEAVY_ALPHA, HEAVY_BETA,
        HEAVY_OMEGA, HEAVY_MOMENTUM, HEAVY_ENERGY, HEAVY_RISING, HEAVY_CUBIC, HEAVY_ROOTS, HEAVY_FROM_START,
        HEAVY_SLOPE, HEAVY_FROM_TOP, HEAVY_FROM_BOTTOM, HEAVY_THIRD, HEAVY_AT_BOTTOM, HEAVY_AT_TOP,
        HEAVY_SWING, HEAVY_RATE, HEAVY_MODULUS, HEAVY_COMPLEMENT, HEAVY_SN, HEAVY_CN, HEAVY_DN, HEAVY_ANGLE_1,
        HEAVY_ANGLE_2, HEAVY_ANGLE_3, HEAVY_S1, HEAVY_C1, HEAVY_D1, HEAVY_SJ, HEAVY_CJ, HEAVY_DJ,
        HEAVY_TURNING, HEAVY_ODD, HEAVY_EVEN, HEAVY_BELOW, HEAVY_ROUND]),
    ("stepping-through-time", &[EXPLICIT_STEP, EXPLICIT_GAIN, TURN_ANGLE, TURN_J, TURN_K, MEAN_MOMENTUM,
        MIDPOINT_STEP, MIDPOINT_WORK, DISCRETE_START, DISCRETE_END]),
    ("where-things-break", &[NEWTON_MATRIX]),
    ("proofs", &[BOX_ABOUT_X, POWER, ENERGY_RATE, WOBBLE, GROWTH, GAP_OF_A_BOX, ACCELERATION, MOMENTUM_RATE,
        TRIANGLE, ATTITUDE_RATE]),
    ("notation", &[MOMENTUM, PRODUCT_OF_INERTIA, ATTITUDE_RATE, ROTATED]),
    ("errata", &[]),
    ("glossary", &[GYROSCOPIC_TORQUE]),
];

/// The entries of `equations.toml` for a piece of maths.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    chapter: String,
    tex: String,
    why: String,
    proof: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Lists {
    exempt: Vec<Line>,
    notation: Vec<Line>,
}

/// The entries for a chapter.
fn own(lines: &'static [Line], chapter: &str) -> &'static [Exemption] {
    let of = lines.iter().filter(|line| line.chapter == chapter);
    of.map(|line| Exemption { tex: &line.tex, reason: &line.why, proof: line.proof.as_deref() })
        .collect::<Vec<_>>()
        .leak()
}

/// The laws and exemptions that a chapter must have.
///
/// # Errors
/// `equations.toml` cannot be read, at which line and why.
pub(super) fn of(chapter: &str) -> Result<Expected, String> {
    static ALL: OnceLock<Result<Vec<(&str, Expected)>, String>> = OnceLock::new();
    let all = ALL.get_or_init(|| {
        let text = files::text(&paths::book().join("equations.toml"))?;
        let Lists { exempt, notation } = &*Box::leak(Box::new(read(&text)?));
        let of = |&(name, laws)| {
            (name, Expected { laws, exemptions: own(exempt, name), notation: own(notation, name) })
        };
        Ok(CHAPTERS.iter().map(of).collect())
    });
    let mut all = all.as_ref().map_err(String::clone)?.iter();
    Ok(all.find(|known| known.0 == chapter).map_or(Expected::NOTHING, |known| known.1))
}

fn read(text: &str) -> Result<Lists, String> {
    toml::from_str(text).map_err(|e| format!("book/equations.toml: {e}"))
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn a_broken_list_of_equations_is_named_with_its_line_and_what_is_wrong() {
        let right = "[[exempt]]\nchapter = \"a\"\ntex = 'x'\nwhy = 'y'\n[[notation]]\nchapter = \"a\"\ntex = 'z'\nwhy = 'y'\n";
        assert!(read(right).is_ok());
        for (from, to, at) in [("why", "whi", 4), ("'z'", "'z", 7), ("[not", "[nut", 5), ("tex", "", 3)] {
            let wrong = read(&right.replacen(from, to, 1)).err().unwrap_or_default();
            let says = format!("book/equations.toml: TOML parse error at line {at},");
            assert!(wrong.contains(&says), "{wrong}");
        }
    }
}
