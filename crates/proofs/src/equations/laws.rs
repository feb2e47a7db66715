//! Laws as equations in TeX, and the meanings of the names of each.

use super::bodies::{self, axis, body, planar, the_box, the_box_spun};
use super::closed;
use super::heavy;
use super::motion::{
    self, attitude, equal_moments, frozen, grows, momentum_for_spin, rates, summit, swings, world_inverse,
    world_tensor,
};
use super::steps::{self, explicit, turn};
use super::tops;
use crate::proof::Kind;
use crate::proofs::{gap::box_gap, proofs};
use crate::tex::{Scope, Statement, parse};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use tumbling::solid::{Cuboid, Shape};

/// An equation, and what its names stand for.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// Its left side as written, by which the law is found; laws with the same left side are found in their
    /// order.
    pub left: &'static str,
    /// What it is proven to be.
    pub says: &'static str,
    /// The meanings of its names; the law must hold in each.
    pub cases: &'static [fn() -> Scope],
    /// For a bound: meanings in which its two sides are equal, so that a weaker bound fails.
    pub attained: &'static [fn() -> Scope],
    /// For an example with numbers: the values of its variables. Without values, numbers are refused.
    pub example: &'static [(&'static str, i64)],
    /// What it says about the library, by the meanings of its names.
    pub kind: Kind,
    /// Whether it is a bare expression, with its meaning in the sentence around it; then `left` is all of it.
    pub bare: bool,
}

/// The meanings of names, computed once: those of the closed form take a while.
fn known(case: fn() -> Scope) -> Scope {
    static KNOWN: Mutex<BTreeMap<usize, Scope>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(case as usize).or_insert_with(case).clone()
}

impl Law {
    /// Reads a statement in TeX and proves it.
    ///
    /// # Errors
    /// What cannot be read, what is left over, or why the statement has no meaning.
    pub fn holds(&self, tex: &str) -> Result<(), String> {
        match parse(tex).map_err(|error| error.to_string())?.as_slice() {
            [statement] => self.prove(statement),
            all => Err(format!("{} statements where one is expected", all.len())),
        }
    }

    /// Proves it as stated.
    ///
    /// # Errors
    /// What is left over, or why the statement has no meaning.
    pub fn prove(&self, statement: &Statement) -> Result<(), String> {
        if self.bare {
            return self.cases.iter().try_for_each(|case| statement.prove_worth(&known(*case)));
        }
        if statement.gives_values() {
            return Err("gives nothing but values where a law is expected".to_owned());
        }
        let mut statement = statement.clone();
        for case in self.cases {
            if !self.example.is_empty() {
                statement = statement.prove_example(&known(*case), self.example)?;
            }
            statement.prove(&known(*case))?;
        }
        let not_attained = |problem| format!("a bound that is not attained: {problem}");
        for case in self.attained {
            statement.prove_attained(&known(*case)).map_err(not_attained)?;
        }
        Ok(())
    }
}

/// A statement that claims nothing about the library, or for which a proof shows what the reason says.
#[derive(Debug, Clone, Copy)]
pub struct Exemption {
    /// All of it, as written.
    pub tex: &'static str,
    /// The reason why it is no claim, or what the proof shows about it.
    pub reason: &'static str,
    /// The name of the proof that must hold, if there is one.
    pub proof: Option<&'static str>,
}

impl Exemption {
    /// Runs its proof, if there is one, and gives the kind of it.
    ///
    /// # Errors
    /// What is left over; that no proof has this name.
    pub(super) fn prove(&self) -> Result<Option<Kind>, String> {
        static KNOWN: Mutex<BTreeMap<&str, Result<Option<Kind>, String>>> = Mutex::new(BTreeMap::new());
        let Some(name) = self.proof else { return Ok(None) };
        let prove = || match proofs().iter().find(|proof| proof.name == name) {
            Some(proof) => proof.check().map(|()| Some(proof.kind)).map_err(|residue| residue.to_string()),
            None => Err(format!("no proof has the name `{name}`")),
        };
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        known.entry(name).or_insert_with(prove).clone()
    }
}

const fn law(left: &'static str, cases: &'static [fn() -> Scope], says: &'static str) -> Law {
    Law { left, says, cases, attained: &[], example: &[], kind: Kind::Library, bare: false }
}

const fn again(left: &'static str, cases: &'static [fn() -> Scope], says: &'static str) -> Law {
    Law { kind: Kind::Again, ..law(left, cases, says) }
}

const fn lemma(left: &'static str, cases: &'static [fn() -> Scope], says: &'static str) -> Law {
    Law { kind: Kind::Lemma, ..law(left, cases, says) }
}

/// Of the axes across, middle and circled: cyclic and not.
const BOTH_ORDERS: &[fn() -> Scope] = &[closed::at_any_time, closed::in_the_other_order];

const fn bare(tex: &'static str, cases: &'static [fn() -> Scope], says: &'static str) -> Law {
    Law { bare: true, ..law(tex, cases, says) }
}

macro_rules! laws {
    ($($name:ident = $law:expr;)+) => {
        $(#[allow(missing_docs, reason = "it says itself what it is proven to be")]
        pub const $name: Law = $law;)+

        /// All of them, by their names.
        pub const ALL: &[(&str, Law)] = &[$((stringify!($name), $name)),+];
    };
}

laws! {
    VELOCITY = law(r"\mathbf{v}", &[motion::carried_round], "the rate of a turning place, by attitude::rate", );
    MOMENTUM_OF_A_PIECE = law(r"\mathbf{L}_{\text{piece}}", &[bodies::moving_piece], "inertia::point_mass times the spin", );
    FIRST_OF_A_PIECE = law("L_x", &[bodies::moving_piece], "the first row of inertia::point_mass times the spin", );
    PRODUCT_WITHOUT_MINUS = bare(r"\sum mxy", &[bodies::product_without_minus], "the product in inertia::point_mass of any points, without the minus", );
    RATE_SEEN_FROM_THE_BODY = law(r"\dot{\mathbf{v}}", &[motion::seen_from_the_body], "the rate by laws::momentum_rate of an arrow that nothing turns in the room", );
    FROM_REST = law(r"\dot{\boldsymbol{\omega}}", &[rates::at_rest], "euler::tensor_times_acceleration without spin");
    LINEARISED_A = law(r"I_a\dot{\omega}_a", &[motion::linearised], "euler::angular_acceleration across a spin");
    LINEARISED_B = law(r"I_b\dot{\omega}_b", &[motion::linearised], "euler::angular_acceleration across a spin");
    LINEARISED_TWICE = law(r"\ddot{\omega}_a", &[motion::linearised], "the second rate by euler::angular_acceleration, and stability::rate_squared");
    ENERGY_ELLIPSOID = law("2E", &[motion::conserved], "observe::energy, twice");
    MOMENTUM_ELLIPSOID = law("L^2", &[motion::conserved], "the square of System::momentum");
    SUM_ABOUT_1 = law("I_1", &[body], "the diagonal of inertia::point_mass, of any points");
    SUM_ABOUT_2 = law("I_2", &[body], "the diagonal of inertia::point_mass, of any points");
    SUM_ABOUT_3 = law("I_3", &[body], "the diagonal of inertia::point_mass, of any points");
    DIFFERENCE_OF_MOMENTS = law("I_1-I_2", &[body], "the diagonal of inertia::point_mass, of any points");
    THIRD_INEQUALITY = law("I_1+I_2-I_3", &[body], "the diagonal of inertia::point_mass, of any points");
    PARALLEL_AXES = law("I_{zz}", &[bodies::two_parts], "solid::combined of any two parts");
    COIN_1 = law(r"\dot{\omega}_1", &[tops::coin], "euler::angular_acceleration with two equal moments");
    COIN_2 = lemma(r"\dot{\omega}_2", &[tops::coin], "the rate by which Ω is named");
    COIN_RATE = law(r"\Omega", &[tops::coin], "the rate by euler::angular_acceleration");
    COIN_COSINE = again(r"\omega_1", &[tops::coin_in_time], "a motion along which euler::angular_acceleration holds");
    COIN_SINE = again(r"\omega_2", &[tops::coin_in_time], "a motion along which euler::angular_acceleration holds");
    COIN_SPIN = law(r"\boldsymbol{\omega}", &[tops::coin], "the spin, with the rate by euler::angular_acceleration");
    COIN_AXIS = lemma(r"\dot{\mathbf{e}}", &[tops::coin], "the rate of the axis");
    STEADY_TOP = again("Wh", &[tops::steady_top], "the torque that a steady precession needs, by euler::coupling");
    NODDING_TOP = again(r"\lambda^2", &[tops::nodding], "the second rate of the lean, with both momenta constant");
    SLEEPING_TOP = again(r"I_3^2\omega_3^2", &[tops::sleeping_top], "where the two rates of an upright precession are one");
    JACOBI_1 = again(r"\omega_1", &[tops::jacobi_motion], "a motion along which euler::angular_acceleration holds");
    JACOBI_2 = again(r"\omega_2", &[tops::jacobi_motion], "a motion along which euler::angular_acceleration holds");
    JACOBI_3 = again(r"\omega_3", &[tops::jacobi_motion], "a motion along which euler::angular_acceleration holds");
    JACOBI_RATE = again("p^2", &[tops::jacobi_motion], "the rate of that motion, with observe::energy");
    JACOBI_PARAMETER = again("m", &[tops::jacobi_motion], "the parameter of that motion, with observe::energy");
    JACOBI_A1 = again("a_1^2", &[tops::jacobi_motion], "an amplitude of that motion, with observe::energy");
    JACOBI_A2 = again("a_2^2", &[tops::jacobi_motion], "an amplitude of that motion, with observe::energy");
    JACOBI_A3 = again("a_3^2", &[tops::jacobi_motion], "an amplitude of that motion, with observe::energy");
    CLOSED_EULER_X = again(r"I_X\dot{\omega}_X", BOTH_ORDERS, "euler::angular_acceleration along the closed form");
    CLOSED_EULER_M = again(r"I_M\dot{\omega}_M", BOTH_ORDERS, "euler::angular_acceleration along the closed form");
    CLOSED_EULER_C = again(r"I_C\dot{\omega}_C", BOTH_ORDERS, "euler::angular_acceleration along the closed form");
    CLOSED_DISTANCES = lemma("d_{CX}", &[closed::at_any_time], "the distances of the moments");
    CLOSED_DISTANCES_BY_MOMENTS = lemma("I_Md_{CX}", &[closed::at_any_time], "the same times the moments");
    CLOSED_WITHOUT_C = again("2EI_C-L^2", &[closed::at_any_time], "observe::energy and the momentum without the circled component");
    CLOSED_WITHOUT_X = again("L^2-2EI_X", &[closed::at_any_time], "the same without the component across");
    CLOSED_ELLIPSE = again(r"\frac{\omega_X^2}{A_X^2}+\frac{\omega_M^2}{A_M^2}", &[closed::at_any_time], "two components of the closed form");
    CLOSED_CIRCLED = again(r"\omega_C^2", &[closed::at_any_time], "the third component of the closed form");
    CLOSED_BALANCE = again(r"I_M\eta A_M", BOTH_ORDERS, "euler::angular_acceleration of the middle component");
    CLOSED_ENERGY = again("2E", &[closed::at_any_time], "observe::energy of the closed form");
    CLOSED_MOMENTUM = again("L^2", &[closed::at_any_time], "the length of its momentum");
    CLOSED_DISCRIMINANT = again("D", &[closed::at_any_time], "the discriminant of the closed form");
    CLOSED_P = again("P^2", &[closed::at_any_time], "its combination of one sign");
    CLOSED_Q = again("Q^2", &[closed::at_any_time], "its other combination of one sign");
    CLOSED_MODULUS = again("k^2", &[closed::at_any_time], "the modulus with which it satisfies euler::angular_acceleration");
    CLOSED_COMPLEMENT = again("k'^2", &[closed::at_any_time], "the complement of that modulus");
    CLOSED_AX = again("A_X^2", &[closed::at_any_time], "an amplitude of the closed form");
    CLOSED_AM = again("A_M^2", &[closed::at_any_time], "an amplitude of the closed form");
    CLOSED_AC = again("A_C^2", &[closed::at_any_time], "an amplitude of the closed form");
    CLOSED_RATE = again(r"\eta", BOTH_ORDERS, "the rate with which it satisfies euler::angular_acceleration");
    CLOSED_RATE_SQUARED = again(r"\eta^2", &[closed::at_any_time], "the square of that rate");
    CLOSED_X = again(r"\omega_X", &[closed::at_any_time], "a component of the closed form");
    CLOSED_M = again(r"\omega_M", &[closed::at_any_time], "a component of the closed form");
    CLOSED_C = again(r"\omega_C", &[closed::at_any_time], "a component of the closed form");
    CLOSED_PHASE_ERROR = lemma(r"\mu", &[closed::at_any_time], "what takes the difference of two relative errors away, to first order");
    CLOSED_SIZE_ERROR = lemma(r"\lambda", &[closed::at_any_time], "what then takes both away, to first order");
    CLOSED_DRIFT = again(r"\nu", &[closed::drift], "half the rate about the momentum where the phase is zero, less that of the angle of a there");
    CLOSED_DRIFT_AT_THE_SADDLE = again(r"\nu", &[closed::drift_at_the_saddle], "the same at the saddle, with ComplementaryPair::turning_at_saddle");
    COMPLEMENTARY_N_2 = law("m_2", &[closed::complementary], "ComplementarySeries::constants");
    COMPLEMENTARY_N_3 = law("m_3", &[closed::complementary], "ComplementarySeries::constants");
    COMPLEMENTARY_N_4 = law("m_4", &[closed::complementary], "ComplementarySeries::constants");
    VARIATION = law(r"I_1\dot{W}_1", &[|| closed::variation(0), || closed::variation(1), || closed::variation(2)], "the derivative of euler::angular_acceleration along a change of the spin");
    CARLSON_FIRST = lemma("r_F", &[|| closed::carlson(3, 1)], "the binomial series of the integrand, integrated term by term");
    CARLSON_SECOND = lemma("r_D", &[|| closed::carlson(5, 3)], "the binomial series of the integrand, integrated term by term");
    CLOSED_SN = again(r"\operatorname{sn}(u_0)", &[closed::at_any_time], "sn, from the spin");
    CLOSED_CN = again(r"\operatorname{cn}(u_0)", &[closed::at_any_time], "cn, from the spin");
    CLOSED_DN = again(r"\operatorname{dn}(u_0)", &[closed::at_any_time], "dn, from the spin");
    CLOSED_SHARE = again(r"\chi", &[closed::at_any_time], "the share with which a + b j satisfies attitude::rate");
    CLOSED_BETA = again(r"\beta^2", &[closed::at_any_time], "of the zero with which a + b j satisfies attitude::rate");
    CLOSED_GAMMA = again(r"\gamma^2", &[closed::at_any_time], "of the same zero");
    CLOSED_DELTA = again(r"\delta^2", &[closed::at_any_time], "of the same zero");
    CLOSED_TURNING = again(r"\dot{\psi}", &[closed::at_any_time], "the phase with which a + b j satisfies attitude::rate");
    CLOSED_TILT = again(r"\kappa", &[closed::at_the_saddle], "the quotient of b and a at the saddle");
    CLOSED_TURNING_AT_THE_SADDLE = again(r"\dot{\psi}", &[closed::at_the_saddle], "the same phase at the saddle");
    CLOSED_COMPLEMENT_SQUARED = again("k'^2A_C^2", &[closed::at_any_time], "a square of the closed form");
    CLOSED_R = lemma("R", &[closed::at_any_time], "the quotient of two amplitudes squared");
    CLOSED_S = lemma("S", &[closed::at_any_time], "the same of two others");
    CLOSED_T = lemma("T", &[closed::at_any_time], "the same of two others");
    SN_BY_THETAS = law(r"\operatorname{sn}", &[closed::direct_quotients], "the quotient of the library's sums");
    CN_BY_THETAS = law(r"\operatorname{cn}", &[closed::direct_quotients], "the quotient of the library's sums");
    DN_BY_THETAS = law(r"\operatorname{dn}", &[closed::direct_quotients], "the quotient of the library's sums");
    SN_NEAR_THE_FLIP = law(r"\operatorname{sn}", &[closed::complementary], "the quotient of the library's sums");
    CN_NEAR_THE_FLIP = law(r"\operatorname{cn}", &[closed::complementary], "the quotient of the library's sums");
    DN_NEAR_THE_FLIP = law(r"\operatorname{dn}", &[closed::complementary], "the quotient of the library's sums");
    SN_NEAR_THE_SADDLE = law(r"\operatorname{sn}", &[closed::complementary_at_the_saddle], "the quotient of the library's sums");
    CN_NEAR_THE_SADDLE = law(r"\operatorname{cn}", &[closed::complementary_at_the_saddle], "the quotient of the library's sums");
    DN_NEAR_THE_SADDLE = law(r"\operatorname{dn}", &[closed::complementary_at_the_saddle], "the quotient of the library's sums");
    THETA_1 = law(r"\theta_1", &[closed::direct], "DirectSeries::thetas");
    THETA_2 = law(r"\theta_2", &[closed::direct], "DirectSeries::thetas");
    THETA_3 = law(r"\theta_3", &[closed::direct], "DirectSeries::thetas");
    THETA_4 = law(r"\theta_4", &[closed::direct], "DirectSeries::thetas");
    ZERO_H1 = law("h_1", &[closed::attitude], "DirectPair::waves");
    ZERO_L1 = law("l_1", &[closed::attitude], "DirectPair::waves");
    ZERO_H2 = law("h_2", &[closed::attitude], "DirectPair::waves");
    ZERO_L2 = law("l_2", &[closed::attitude], "DirectPair::waves");
    ZERO_H3 = law("h_3", &[closed::attitude], "DirectPair::waves");
    ZERO_L3 = law("l_3", &[closed::attitude], "DirectPair::waves");
    ZERO_C1 = law("H_1", &[closed::attitude], "DirectPair::waves");
    ZERO_D1 = law("J_1", &[closed::attitude], "DirectPair::waves");
    ZERO_C2 = law("H_2", &[closed::attitude], "DirectPair::waves");
    ZERO_D2 = law("J_2", &[closed::attitude], "DirectPair::waves");
    ZERO_TURNING = law(r"\rho", &[closed::attitude], "DirectPair::turning_at_zero");
    DIRECT_A1 = law("a_1", &[closed::attitude], "DirectPair::sums");
    DIRECT_A2 = law("a_2", &[closed::attitude], "DirectPair::sums");
    DIRECT_B1 = law("b_1", &[closed::attitude], "DirectPair::sums");
    DIRECT_B2 = law("b_2", &[closed::attitude], "DirectPair::sums");
    COMPLEMENTARY_THETA_1 = law(r"\theta'_1", &[closed::complementary], "ComplementarySeries::sums");
    COMPLEMENTARY_THETA_2 = law(r"\theta'_2", &[closed::complementary], "ComplementarySeries::sums");
    COMPLEMENTARY_THETA_3 = law(r"\theta'_3", &[closed::complementary], "ComplementarySeries::sums");
    COMPLEMENTARY_THETA_4 = law(r"\theta'_4", &[closed::complementary], "ComplementarySeries::sums");
    COMPLEMENTARY_A1 = law("a_1", &[closed::complementary_attitude], "ComplementaryPair::sums");
    COMPLEMENTARY_A2 = law("a_2", &[closed::complementary_attitude], "ComplementaryPair::sums");
    COMPLEMENTARY_B1 = law("b_1", &[closed::complementary_attitude], "ComplementaryPair::sums");
    COMPLEMENTARY_B2 = law("b_2", &[closed::complementary_attitude], "ComplementaryPair::sums");
    HEAVY_VERTICAL = law("V", &[heavy::turning], "the vertical seen from the body, by attitude::rotation_matrix");
    HEAVY_HEIGHT = law("c", &[heavy::leaning], "the same, along the axis");
    HEAVY_ALONG = lemma("n", &[heavy::turning], "the momentum about the axis");
    HEAVY_PULL = lemma("g", &[heavy::turning], "the torque of the weight");
    HEAVY_ALPHA = law(r"\dot{\alpha}", &[heavy::turning], "attitude::rate");
    HEAVY_BETA = law(r"\dot{\beta}", &[heavy::turning], "attitude::rate");
    HEAVY_OMEGA = law(r"\dot{\omega}", &[heavy::turning], "euler::angular_acceleration under the torque of the weight");
    HEAVY_MOMENTUM = lemma("l", &[heavy::turning], "the momentum about the vertical, by its components");
    HEAVY_ENERGY = law("e", &[heavy::turning], "observe::energy and the height, without the spin about the axis");
    HEAVY_RISING = law(r"\dot{c}", &[heavy::turning], "the rate of the height, by attitude::rate");
    HEAVY_CUBIC = law(r"\dot{c}^2", &[heavy::turning], "the square of that rate");
    HEAVY_ROOTS = lemma(r"\dot{c}^2", &[heavy::any_height], "the cubic by its roots");
    HEAVY_FROM_START = lemma(r"\dot{c}^2", &[heavy::from_the_start], "the cubic by the height above the start");
    HEAVY_SLOPE = lemma("F", &[heavy::from_the_start], "the derivative of the cubic at the start");
    HEAVY_FROM_TOP = lemma(r"-\dot{c}^2", &[heavy::from_the_top], "the cubic by the depth below the top");
    HEAVY_FROM_BOTTOM = lemma(r"-\dot{c}^2", &[heavy::from_the_bottom], "the cubic by the height above the bottom");
    HEAVY_THIRD = lemma("g(c_3-1)", &[heavy::any_height], "the third root by the sum of the roots");
    HEAVY_AT_BOTTOM = lemma("(l+n)^2", &[heavy::any_height], "the cubic at -1");
    HEAVY_AT_TOP = lemma("(l-n)^2", &[heavy::any_height], "the cubic at 1");
    HEAVY_SWING = lemma("c", &[heavy::swinging], "a height whose rate has the cubic as its square");
    HEAVY_RATE = lemma(r"\eta^2", &[heavy::swinging], "the rate with which it has");
    HEAVY_MODULUS = lemma("k^2", &[heavy::swinging], "the modulus with which it has");
    HEAVY_COMPLEMENT = lemma("k'^2", &[heavy::swinging], "the complement of that modulus");
    HEAVY_SN = lemma(r"\operatorname{sn}(u_0)^2", &[heavy::swinging], "sn, from the height");
    HEAVY_CN = lemma(r"\operatorname{cn}(u_0)^2", &[heavy::swinging], "cn, from the height");
    HEAVY_DN = lemma(r"\operatorname{dn}(u_0)^2", &[heavy::swinging], "dn, from the height");
    HEAVY_ANGLE_1 = law(r"\dot{\phi}_1", &[heavy::turning], "the rate of the angle by attitude::rate, without the steady turn");
    HEAVY_ANGLE_2 = law(r"\dot{\phi}_2", &[heavy::turning], "the rate of the angle by attitude::rate, without the steady turn");
    HEAVY_ANGLE_3 = law(r"\dot{\phi}_3", &[heavy::turning], "the rate of the angle by euler::angular_acceleration, without the steady turn");
    HEAVY_S1 = lemma("S_1^2", &[heavy::lowest_zero], "where the height is -1");
    HEAVY_C1 = lemma("C_1^2", &[heavy::lowest_zero], "the same zero");
    HEAVY_D1 = lemma("D_1^2", &[heavy::lowest_zero], "the same zero");
    HEAVY_SJ = lemma("S_j^2", &[heavy::other_zero], "where the height is that of the zero");
    HEAVY_CJ = lemma("C_j^2", &[heavy::other_zero], "the same zero");
    HEAVY_DJ = lemma("D_j^2", &[heavy::other_zero], "the same zero");
    HEAVY_TURNING = lemma(r"\rho_j", &[heavy::sums], "the first terms of the rate of a theta function's angle");
    HEAVY_ODD = lemma("A", &[heavy::sums], "the sum of its first terms, in hyperbolic functions");
    HEAVY_EVEN = lemma("B", &[heavy::sums], "the sum of its first terms, in hyperbolic functions");
    HEAVY_BELOW = lemma("N", &[heavy::sums], "the sum of its first terms, in hyperbolic functions");
    HEAVY_ROUND = law("P", &[heavy::turning], "the rate at which the axis goes round, by attitude::rate");
    PRODUCT_WHEN_TURNED = law("I'_{xy}", &[motion::turned_axes], "inertia::turned, by an angle about the third axis");
    TANGENT_OF_THE_GAP = law(r"\tan(\text{gap})", &[motion::slant], "the tangent of the gap, by euler::coupling");
    SLOPES = bare("b/a", &[motion::slopes], "by what the momentum's slope exceeds the spin's");
    TWICE_THE_ENERGY = Law { kind: Kind::Lemma, ..bare(r"\mathbf{L}\cdot\boldsymbol{\omega}", &[bodies::twice_the_energy], "twice the sum of m v²/2 of any points", ) };
    GYROSCOPIC_TORQUE = bare(r"(I\boldsymbol{\omega})\times\boldsymbol{\omega}", &[motion::gyroscopic], "euler::tensor_times_acceleration without torque", );
    ENERGY_RATE = law(r"\dot{E}", &[motion::power], "the rate of observe::energy by euler::angular_acceleration");
    POWER = bare(r"\boldsymbol{\omega}\cdot I\dot{\boldsymbol{\omega}}", &[motion::power], "the rate of observe::energy by euler::angular_acceleration", );
    GROWTH = Law { attained: &[equal_moments], ..law(r"\lambda^2", grows::BOTH, "stability::rate_squared, about the middle") };
    GAP_OF_A_BOX = law(r"\tan(\text{gap})", &[|| box_gap(|m, a, b, c| Cuboid::moments(m, [a, b, c]))], "the tangent of the gap by solid::Cuboid::moments and euler::coupling", );
    MOMENTUM = law(r"\mathbf{L}", &[body], "the momentum of any points is inertia::point_mass of them times the spin", );
    MOMENTUM_BY_ENTRY = law(r"\begin{pmatrix}L_x\\L_y\\L_z\end{pmatrix}", &[body], "the momentum of any points is inertia::point_mass of them times the spin, entry by entry");
    TENSOR_OF_A_PIECE = law(r"I_{\text{piece}}", &[bodies::moving_piece], "inertia::point_mass");
    BOX_ABOUT_X = law(r"I_{xx}", &[the_box], "solid::Cuboid::moments, about x");
    BOX_ABOUT_Y = law(r"I_{yy}", &[the_box], "solid::Cuboid::moments, about y");
    BOX_ABOUT_Z = law(r"I_{zz}", &[the_box], "solid::Cuboid::moments, about z");
    BOX_MOMENTUM = Law { example: &[("m", 1), ("a", 2), ("b", 1), ("c", 3)], ..law(r"\mathbf{L}", &[the_box_spun], "inertia::omega_world gives back the spin, here (1, 1, 0)", ) };
    PLANAR_MOMENTUM = law(r"\mathbf{L}", &[planar], "inertia::omega_world gives back the spin");
    SUMMIT_ANGLE = law(r"\tan\theta", &[summit], "where the derivative of the gap is zero, by euler::coupling", );
    SUMMIT_GAP = law(r"\sin(\text{gap})", &[summit], "the gap there, by euler::coupling");
    AXIS_MOMENTUM = law(r"\mathbf{L}", &[|| axis(0), || axis(1), || axis(2)], "about each axis, inertia::omega_world gives back the spin", );
    TRIANGLE = Law { attained: &[bodies::flat], ..law("I_1+I_2", &[body], "the diagonal of inertia::point_mass, of any points; an equality for flat bodies", ) };
    WORLD_TENSOR = law(r"I_{\text{world}}", world_tensor::CASES, "inertia::turned, and inertia::point_mass of turned points", );
    WORLD_INVERSE = law(r"I_{\text{world}}^{-1}", &[world_inverse], "the inverse of inertia::turned");
    WORLD_SPIN = law(r"\boldsymbol{\omega}", &[world_inverse], "inertia::omega_world");
    MOMENTUM_RATE = law(r"\dot{\mathbf{L}}", rates::ALL, "laws::momentum_rate");
    MOMENTUM_RATE_BY_ACCELERATION = law(r"\dot{\mathbf{L}}", rates::ALL, "laws::momentum_rate and euler::tensor_times_acceleration", );
    ACCELERATION = law(r"I\dot{\boldsymbol{\omega}}", rates::ALL, "euler::angular_acceleration, and euler::tensor_times_acceleration", );
    EULER_1 = law(r"I_1\dot{\omega}_1", &[rates::free], "euler::angular_acceleration, first");
    EULER_2 = law(r"I_2\dot{\omega}_2", &[rates::free], "euler::angular_acceleration, second");
    EULER_3 = law(r"I_3\dot{\omega}_3", &[rates::free], "euler::angular_acceleration, third");
    ENERGY = law("E", &[motion::power, body], "observe::energy, and half the sum of m v² over any points", );
    WOBBLE = law(r"\lambda^2", &[motion::wobble], "stability::rate_squared");
    SWING = Law { attained: &[equal_moments], ..law(r"\lambda^2", swings::BOTH, "stability::rate_squared, about the largest and the smallest", ) };
    FROZEN_TENSOR = law(r"I_{\text{body}}\dot{\boldsymbol{\omega}}", &[frozen], "Engine::Frozen's rate, wrong as it is", );
    MOMENTUM_FOR_SPIN = law(r"\boldsymbol{\omega}", &[momentum_for_spin], "Engine::MomentumForSpin's omega_world, wrong as it is", );
    EXPLICIT_STEP = law(r"\mathbf{L}'", explicit::CASES, "laws::momentum_rate held for the step, and the steps of Method::ExplicitEuler and SemiImplicitEuler", );
    EXPLICIT_GAIN = law(r"\mathbf{L}'\cdot\mathbf{L}'", explicit::CASES, "the squared length after that step", );
    TURN_J = law("L'_j", turn::ALL, "the momentum in the axes of a body turned by attitude::rotation_matrix, next axis");
    TURN_K = law("L'_k", turn::ALL, "the same, the axis after that");
    TURN_ANGLE = bare("hL_i/I_i", &[steps::angle], "the step times the spin by inertia::omega_world");
    MEAN_MOMENTUM = lemma(r"\mathbf{M}", &[steps::midpoint], "the mean of both ends of a midpoint step");
    MIDPOINT_STEP = again(r"\mathbf{L}'", &[steps::midpoint], "laws::momentum_rate at the mean, held for the step");
    MIDPOINT_WORK = again("E'-E", &[steps::midpoint], "the change of observe::energy in that step, for a torque that is constant in it", );
    DISCRETE_START = again(r"(1+\mathbf{c}\cdot\mathbf{c})\tfrac{h}{2}\mathbf{L}", &[steps::discrete], "the equation of Moser and Veselov's step");
    DISCRETE_END = again(r"(1+\mathbf{c}\cdot\mathbf{c})\tfrac{h}{2}\mathbf{L}'", &[steps::discrete], "the same momentum after the turn, by attitude::rotation_matrix", );
    NEWTON_MATRIX = law(r"A\boldsymbol{\delta}", &[steps::newton], "the tensor less the step times the derivative of euler::coupling by the spin", );
    PRODUCT_OF_INERTIA = law(r"I_{xy}", &[body], "the product in inertia::point_mass, of any points");
    ATTITUDE_RATE = law(r"\dot{q}", &[attitude], "attitude::rate");
    ROTATED = law(r"\mathbf{v}_{\text{world}}", &[attitude], "q v q* by attitude::product, with attitude::rotation_matrix", );
}
