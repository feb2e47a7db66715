//! Which laws each chapter states, in its order, and which of its maths claims nothing.

use tumbling_proofs::equations::{Exemption, Expected, laws};

/// Each chapter with its laws, what is exempt with the reason (and the proof that shows it apart), and what
/// is notation.
macro_rules! chapters {
    ($(
        $name:literal [$($law:ident)*]
        {$($tex:literal: $why:literal $(by $proof:literal)?;)*}
        {$($bare:literal: $of:literal;)*}
    )*) => {
        &[$(($name, Expected {
            laws: &[$(laws::$law),*],
            exemptions: &[$(Exemption { tex: $tex, reason: $why, proof: [$(Some($proof),)? None][0] }),*],
            notation: &[$(Exemption { tex: $bare, reason: $of, proof: None }),*],
        })),*]
    };
}

/// Chapters by the names of their files. Bare expressions that name a thing and say nothing about it are
/// notation, each once for each time it is written, inline.
pub(super) const CHAPTERS: &[(&str, Expected)] = chapters! {
    "matrix-mass" [
        VELOCITY MOMENTUM_OF_A_PIECE FIRST_OF_A_PIECE FIRST_OF_A_PIECE PRODUCT_WITHOUT_MINUS MOMENTUM
        MOMENTUM_BY_ENTRY TENSOR_OF_A_PIECE MOMENTUM
    ] {
        r"\mathbf{p}=m\mathbf{v}":
            "the momentum of what slides, for comparison; the library has only what turns";
        r"\mathbf{r}=(x,y,z)": "names the coordinates";
    } {}
    "principal-axes" [
        AXIS_MOMENTUM PARALLEL_AXES SUM_ABOUT_1 SUM_ABOUT_2 SUM_ABOUT_3 THIRD_INEQUALITY TRIANGLE
    ] {
        r"I=\begin{pmatrix}I_1&0&0\\0&I_2&0\\0&0&I_3\end{pmatrix}":
            "the form of a diagonal matrix; that the library finds one is tested on floats, for it takes roots";
        r"I_1\le I_2\le I_3": "the order in which we name them";
    } {}
    "two-arrows" [SLOPES TWICE_THE_ENERGY PLANAR_MOMENTUM SUMMIT_ANGLE SUMMIT_GAP] {
        "a<b": "the order in which we name them";
    } {}
    "worked-example" [BOX_ABOUT_X BOX_ABOUT_Y BOX_ABOUT_Z BOX_MOMENTUM] {} {}
    "body-and-world" [WORLD_TENSOR WORLD_INVERSE WORLD_SPIN] {} {
        r"R^{\mathsf{T}}": "names the transpose; the law beside it uses it";
    }
    "eulers-equations" [
        FROM_REST RATE_SEEN_FROM_THE_BODY MOMENTUM_RATE MOMENTUM_RATE_BY_ACCELERATION ACCELERATION EULER_1
        EULER_2 EULER_3 MOMENTUM_RATE ENERGY LINEARISED_A LINEARISED_B LINEARISED_TWICE WOBBLE SWING GROWTH
    ] {} {
        r"e^{\lambda t}": "the solution of x'' = rate² x; the rate is what is proven";
    }
    "three-pitfalls" [FROZEN_TENSOR MOMENTUM_FOR_SPIN] {} {}
    "dzhanibekov" [ENERGY_ELLIPSOID MOMENTUM_ELLIPSOID] {} {}
    "coin" [COIN_1 COIN_2 COIN_RATE COIN_COSINE COIN_SINE COIN_SPIN COIN_AXIS] {
        r"\phi=\Omega t": "names the angle";
    } {}
    "exact-motion" [
        JACOBI_SN JACOBI_CN JACOBI_DN JACOBI_1 JACOBI_2 JACOBI_3 JACOBI_RATE JACOBI_PARAMETER JACOBI_A1
        JACOBI_A2 JACOBI_A3
    ] {} {}
    "a-top" [STEADY_TOP NODDING_TOP SLEEPING_TOP] {} {
        r"2\pi/\lambda": "names the time of a nod";
        r"I_3\,\omega_3/I_1": "the root of the law before it without precession";
    }
    "closed-form" [
        CLOSED_EULER_X CLOSED_EULER_M CLOSED_EULER_C CLOSED_DISTANCES CLOSED_DISTANCES_BY_MOMENTS
        CLOSED_ENERGY CLOSED_MOMENTUM CLOSED_DISCRIMINANT CLOSED_WITHOUT_C CLOSED_WITHOUT_X CLOSED_P CLOSED_Q
        CLOSED_ELLIPSE CLOSED_CIRCLED CLOSED_MODULUS CLOSED_COMPLEMENT CLOSED_AX CLOSED_AM CLOSED_AC
        CLOSED_BALANCE CLOSED_RATE CLOSED_RATE_SQUARED CLOSED_X CLOSED_M CLOSED_C CLOSED_SN CLOSED_CN
        CLOSED_DN CLOSED_PHASE_ERROR CLOSED_SIZE_ERROR THETA_3 THETA_4 THETA_2 THETA_1
        SN_BY_THETAS CN_BY_THETAS DN_BY_THETAS CLOSED_SHARE
        CLOSED_BETA CLOSED_GAMMA CLOSED_DELTA CLOSED_TURNING ZERO_H1 ZERO_L1 ZERO_H2 ZERO_L2 ZERO_H3 ZERO_L3
        DIRECT_A1 DIRECT_A2 ZERO_C1 ZERO_D1 ZERO_C2 ZERO_D2 DIRECT_B1 DIRECT_B2 CLOSED_TILT CLOSED_DRIFT
        ZERO_TURNING COMPLEMENTARY_THETA_1 COMPLEMENTARY_THETA_2 COMPLEMENTARY_THETA_3 COMPLEMENTARY_THETA_4
        COMPLEMENTARY_N_2 COMPLEMENTARY_N_3 COMPLEMENTARY_N_4
        SN_NEAR_THE_FLIP CN_NEAR_THE_FLIP DN_NEAR_THE_FLIP
        SN_NEAR_THE_SADDLE CN_NEAR_THE_SADDLE DN_NEAR_THE_SADDLE COMPLEMENTARY_A1 COMPLEMENTARY_A2
        COMPLEMENTARY_B1 COMPLEMENTARY_B2 CLOSED_TURNING_AT_THE_SADDLE CLOSED_DRIFT_AT_THE_SADDLE CLOSED_FLIP
        CLOSED_TWIST COIN_RATE CLOSED_AX CLOSED_AC CLOSED_COMPLEMENT_SQUARED CLOSED_R CLOSED_S CLOSED_T
        VARIATION CARLSON_FIRST CARLSON_SECOND
    ] {
        r"u=u_0+\eta t": "the argument runs evenly; the rate is what is proven";
        r"K=\frac{\pi}{2G}": "the integral that keeps its value from mean to mean" by "gauss-mean";
        r"K'=\frac{\pi}{2G'}": "the same with the other modulus" by "gauss-mean";
        r"\operatorname{log}(q)=-\frac{\pi K'}{K}":
            "the nome of this modulus: a theorem on theta functions that is quoted, not proven";
        r"\operatorname{log}(p)=-\frac{\pi K}{2K'}": "the same of the complementary modulus, quoted";
        r"u_0=\operatorname{sn}(u_0)R_F(\operatorname{cn}(u_0)^2,\operatorname{dn}(u_0)^2,1)":
            "Legendre's integral by a change of variable" by "legendre-by-carlson";
        r"K-u_0=\operatorname{cn}(u_0)R_F(k'^2\operatorname{sn}(u_0)^2,k'^2,\operatorname{dn}(u_0)^2)":
            "the same from the other end" by "legendre-by-carlson";
        r"z=\frac{\pi u}{2K}": "the scale of the argument in theta functions of this nome, quoted";
        r"y=\beta R_F(\gamma^2,\delta^2,1)": "the same integral of the zero" by "legendre-by-carlson";
        r"\operatorname{log}(f)=-\frac{\pi y}{K}": "names an exponential of the zero";
        r"g=\frac{q}{f}": "names its partner";
        r"x=\frac{\pi u}{2K'}": "the same by the imaginary transformation, quoted";
        r"\phi=\frac{\pi y}{4K'}": "names half of the zero's argument, at the scale that is quoted";
        r"u=u_0+\eta t-2NK": "takes whole half periods off; that the period is 4 K is quoted";
        r"F=\tfrac{1}{6}\operatorname{sn}(u)^3R_D(\operatorname{cn}(u)^2,1,\operatorname{dn}(u)^2)":
            "Legendre's integral differentiated" by "legendre-by-carlson";
        r"\frac{d}{dt}(\boldsymbol{\alpha}\cdot\mathbf{L})=\mathbf{W}\cdot\mathbf{L}":
            "the rate that keeps the momentum in the room, to first order" by "sensitivity-of-the-attitude";
        r"G=\frac{G_1+G_2}{2}-\frac{(G_1-G_2)^2}{8(G_1+G_2)}":
            "but for a term of the fourth order, which the proof gives" by "last-mean";
        r"\xi=\sqrt{Z_1}\sqrt{Z_2}+\sqrt{Z_2}\sqrt{Z_3}+\sqrt{Z_3}\sqrt{Z_1}":
            "names the sum of the products of roots";
        r"R_F(Z_1,Z_2,Z_3)=R_F(\frac{Z_1+\xi}{4},\frac{Z_2+\xi}{4},\frac{Z_3+\xi}{4})":
            "by a change of variable" by "carlson-duplication";
        r"R_D(Z_1,Z_2,Z_3)=\frac{1}{4}R_D(\frac{Z_1+\xi}{4},\frac{Z_2+\xi}{4},\frac{Z_3+\xi}{4})+\frac{3}{\sqrt{Z_3}(Z_3+\xi)}":
            "by a change of variable" by "carlson-duplication";
    } {
        "2E": "heads a column of values";
        "L^2": "heads a column of values";
        "P^2": "heads a column of values";
        "Q^2": "heads a column of values";
        "K'/K": "the ratio by which a series is chosen";
        r"\sum (-1)^n\,q^{n^2} e^{2inz}": "defines a theta function";
        "-i": "names a factor of a theta function";
        r"a+b\,\mathbf{j}": "names the quaternion";
        r"a+b\,\mathbf{j}": "names the quaternion";
        r"a+b\,\mathbf{j}": "names the quaternion";
        r"z-s\,i\,z_0": "names the phase moved by the zero";
        "-i": "names a factor; the attitude with it is proven";
        r"\nu\,t": "names the common phase";
        r"-s\,\phi": "names the angle of a at the saddle";
        r"-2\,s\,\phi": "names what a half period adds";
        "L/I_M": "names the lead of the law before it";
        r"2\,K": "names the half period";
        "L/I_1": "names the rate about the momentum";
    }
    "stepping-through-time" [
        EXPLICIT_STEP EXPLICIT_GAIN TURN_ANGLE TURN_J TURN_K MEAN_MOMENTUM MIDPOINT_STEP MIDPOINT_WORK
        DISCRETE_START DISCRETE_END
    ] {} {
        r"\frac{1906}{195}\,h^2": "a term of a power series, held by an assertion beside it";
        r"\frac{19849}{63375}\,h^5": "a term of a power series, held by an assertion beside it";
    }
    "where-things-break" [NEWTON_MATRIX] {} {
        r"A\boldsymbol{\delta}": "the left side of the law that follows in the sentence";
        r"h\,(I\boldsymbol{\omega})\times\boldsymbol{\omega}":
            "what the sentence sets it equal to; held by an assertion below";
        r"h\,\boldsymbol{\tau}\cdot J\mathbf{M}": "a law of the chapter on steps, repeated";
        r"-c\,\boldsymbol{\omega}": "names a drag";
        "hc": "names a product; the sentence compares it with the moments";
        "hc": "names a product; the sentence compares it with the moments";
    }
    "proofs" [
        BOX_ABOUT_X POWER ENERGY_RATE MIDDLE_MOMENT LARGEST_MOMENT WOBBLE GROWTH GAP_OF_A_BOX ACCELERATION
        MOMENTUM_RATE TRIANGLE ATTITUDE_RATE
    ] {
        r"\frac{d}{dt}(\mathbf{L}\cdot\mathbf{L})=2\mathbf{L}\cdot\boldsymbol{\tau}":
            "in both forms of the law" by "length-of-momentum";
        r"\frac{d}{dt}(\boldsymbol{\omega}\cdot\boldsymbol{\omega})=\frac{2(I_1-I_2)(I_2-I_3)(I_1-I_3)}{I_1I_2I_3}\omega_1\omega_2\omega_3":
            "without a torque" by "spin-is-not-conserved";
    } {
        r"\lambda^2": "the left side of the law that follows in the sentence";
        r"I\dot{\boldsymbol{\omega}}": "the left side of the law that the sentence names";
    }
    "notation" [MOMENTUM PRODUCT_OF_INERTIA ATTITUDE_RATE ROTATED] {} {}
    "errata" [] {} {
        r"\Delta_j = G^2 - 2\,T I_j": "an abbreviation of the notes";
        r"I_j\,\Delta_h/(I_j - I_h)": "an abbreviation of the notes";
        r"(\sigma B_{13}\operatorname{dn},\ -B_{21}\operatorname{sn},\ B_{31}\operatorname{cn})":
            "the notes' momentum; proven as errata-rate-about-the-smallest-axis";
        r"\lambda t - \nu": "the notes' argument";
        r"\lambda = -\sigma\lambda_3": "proven as errata-rate-about-the-smallest-axis";
        r"\lambda = -\sigma\lambda_1": "proven as errata-rate-about-the-largest-axis";
        r"G^2 = 2\,T I_2": "held by the assertion below";
        r"\dot\psi = (2\,T + G\,m_3/I_3)/(G + m_3)": "proven as errata-rate-of-the-angle";
        "B_{31}/G": "a factor of the angle below";
        "n = -(B_{31}/B_{13})^2": "proven as errata-sign-of-the-angle";
        r"G\,t/I_3": "proven as errata-sign-of-the-angle";
        r"G\,(I_3 - I_1)/(\lambda I_1 I_3)": "proven as errata-sign-of-the-angle";
        r"\Pi(\operatorname{am}, n, k)": "proven as errata-sign-of-the-angle";
        r"\frac{B_{31}\,B_{13}}{G\,B_{21}}\operatorname{arctan}\left(\frac{B_{21}}{B_{13}}\operatorname{sd}\right)":
            "proven as errata-sign-of-the-angle";
        r"1/(1 - n\operatorname{tanh}^2)": "the notes' integrand; errata-characteristic-on-the-separatrix";
        "n = G^4/(B_{21}^2 B_{23}^2)": "proven to be one as errata-characteristic-on-the-separatrix";
        "1 - n": "what the notes divide by";
        r"2\,T t/G": "the rate above about the middle axis, where G² is 2 T I2";
        r"\frac{M}{I_3}\left(1 + \frac{I_{32}\,I_{31}}{I_1 I_{32} + I_3 I_{21}\operatorname{sn}^2}\right)":
            "proven as errata-precession";
        "I_{jh} = I_j - I_h": "an abbreviation of Orekit's";
        r"(o_1\operatorname{cn},\ o_2\operatorname{sn},\ o_3\operatorname{dn})":
            "Orekit's spin; proven as errata-acceleration";
        r"\operatorname{cn}\operatorname{dn}": "Orekit's derivative; refuted as errata-acceleration";
        r"-\operatorname{sn}\operatorname{dn}": "Orekit's derivative; refuted as errata-acceleration";
    }
    "glossary" [GYROSCOPIC_TORQUE] {} {}
};

/// What is expected of a chapter.
pub(super) fn of(chapter: &str) -> Expected {
    CHAPTERS.iter().find(|known| known.0 == chapter).map_or(Expected::NOTHING, |known| known.1)
}
