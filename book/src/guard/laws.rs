//! Which laws each chapter states, in its order, and which of its maths claims nothing.

use tumbling_proofs::equations::{Exemption, Expected, laws};

const fn exempt(tex: &'static str, reason: &'static str) -> Exemption {
    Exemption { tex, reason, proof: None }
}

/// Proven apart, by the proof of this name.
const fn by(proof: &'static str, tex: &'static str, reason: &'static str) -> Exemption {
    Exemption { tex, reason, proof: Some(proof) }
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
    (
        "a-top",
        Expected {
            laws: &[laws::STEADY_TOP, laws::NODDING_TOP, laws::SLEEPING_TOP],
            exemptions: &[],
            notation: &[
                exempt(r"2\pi/\lambda", "names the time of a nod"),
                exempt(r"I_3\,\omega_3/I_1", "the root of the law before it without precession"),
            ],
        },
    ),
    (
        "closed-form",
        Expected {
            laws: &[
                laws::CLOSED_EULER_X,
                laws::CLOSED_EULER_M,
                laws::CLOSED_EULER_C,
                laws::CLOSED_DISTANCES,
                laws::CLOSED_DISTANCES_BY_MOMENTS,
                laws::CLOSED_ENERGY,
                laws::CLOSED_MOMENTUM,
                laws::CLOSED_DISCRIMINANT,
                laws::CLOSED_WITHOUT_C,
                laws::CLOSED_WITHOUT_X,
                laws::CLOSED_P,
                laws::CLOSED_Q,
                laws::CLOSED_ELLIPSE,
                laws::CLOSED_CIRCLED,
                laws::CLOSED_MODULUS,
                laws::CLOSED_COMPLEMENT,
                laws::CLOSED_AX,
                laws::CLOSED_AM,
                laws::CLOSED_AC,
                laws::CLOSED_BALANCE,
                laws::CLOSED_RATE,
                laws::CLOSED_RATE_SQUARED,
                laws::CLOSED_X,
                laws::CLOSED_M,
                laws::CLOSED_C,
                laws::CLOSED_SN,
                laws::CLOSED_CN,
                laws::CLOSED_DN,
                laws::CLOSED_PHASE_ERROR,
                laws::CLOSED_SIZE_ERROR,
                laws::THETA_3,
                laws::THETA_4,
                laws::THETA_2,
                laws::THETA_1,
                laws::CLOSED_SHARE,
                laws::CLOSED_BETA,
                laws::CLOSED_GAMMA,
                laws::CLOSED_DELTA,
                laws::CLOSED_TURNING,
                laws::ZERO_H1,
                laws::ZERO_L1,
                laws::ZERO_H2,
                laws::ZERO_L2,
                laws::ZERO_H3,
                laws::ZERO_L3,
                laws::DIRECT_A1,
                laws::DIRECT_A2,
                laws::ZERO_C1,
                laws::ZERO_D1,
                laws::ZERO_C2,
                laws::ZERO_D2,
                laws::DIRECT_B1,
                laws::DIRECT_B2,
                laws::CLOSED_TILT,
                laws::CLOSED_DRIFT,
                laws::ZERO_TURNING,
                laws::COMPLEMENTARY_THETA_1,
                laws::COMPLEMENTARY_THETA_2,
                laws::COMPLEMENTARY_THETA_3,
                laws::COMPLEMENTARY_THETA_4,
                laws::COMPLEMENTARY_N_2,
                laws::COMPLEMENTARY_N_3,
                laws::COMPLEMENTARY_N_4,
                laws::COMPLEMENTARY_A1,
                laws::COMPLEMENTARY_A2,
                laws::COMPLEMENTARY_B1,
                laws::COMPLEMENTARY_B2,
                laws::CLOSED_TURNING_AT_THE_SADDLE,
                laws::CLOSED_DRIFT_AT_THE_SADDLE,
                laws::CLOSED_FLIP,
                laws::CLOSED_TWIST,
                laws::COIN_RATE,
                laws::CLOSED_AX,
                laws::CLOSED_AC,
                laws::CLOSED_COMPLEMENT_SQUARED,
                laws::CLOSED_R,
                laws::CLOSED_S,
                laws::CLOSED_T,
                laws::VARIATION,
                laws::CARLSON_FIRST,
                laws::CARLSON_SECOND,
            ],
            exemptions: &[
                exempt(r"u=u_0+\eta t", "the argument runs evenly; the rate is what is proven"),
                by("gauss-mean", r"K=\frac{\pi}{2G}", "the integral that keeps its value from mean to mean"),
                by("gauss-mean", r"K'=\frac{\pi}{2G'}", "the same with the other modulus"),
                exempt(r"\operatorname{log}(q)=-\frac{\pi K'}{K}", "names the nome"),
                exempt(r"\operatorname{log}(p)=-\frac{\pi K}{2K'}", "names the complementary nome"),
                by(
                    "legendre-by-carlson",
                    r"u_0=\operatorname{sn}(u_0)R_F(\operatorname{cn}(u_0)^2,\operatorname{dn}(u_0)^2,1)",
                    "Legendre's integral by a change of variable",
                ),
                by(
                    "legendre-by-carlson",
                    r"K-u_0=\operatorname{cn}(u_0)R_F(k'^2\operatorname{sn}(u_0)^2,k'^2,\operatorname{dn}(u_0)^2)",
                    "the same from the other end",
                ),
                exempt(r"z=\frac{\pi u}{2K}", "names the phase"),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{sn}=\frac{n_3\theta_1\sin z}{n_2\theta_4}",
                    "of the infinite sums",
                ),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{cn}=\frac{n_4\theta_2\cos z}{n_2\theta_4}",
                    "of the infinite sums",
                ),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{dn}=\frac{n_4\theta_3}{n_3\theta_4}",
                    "of the infinite sums",
                ),
                by(
                    "legendre-by-carlson",
                    r"y=\beta R_F(\gamma^2,\delta^2,1)",
                    "the same integral of the zero",
                ),
                exempt(r"\operatorname{log}(f)=-\frac{\pi y}{K}", "names an exponential of the zero"),
                exempt(r"g=\frac{q}{f}", "names its partner"),
                exempt(r"x=\frac{\pi u}{2K'}", "names the argument of the complementary series"),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{sn}=\frac{m_3\theta'_1}{m_4\theta'_2}",
                    "of the infinite sums, at an imaginary argument",
                ),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{cn}=\frac{2em_2\theta'_4}{m_4\theta'_2}",
                    "of the infinite sums, at an imaginary argument",
                ),
                by(
                    "jacobi-by-thetas",
                    r"\operatorname{dn}=\frac{2em_2\theta'_3}{m_3\theta'_2}",
                    "of the infinite sums, at an imaginary argument",
                ),
                by(
                    "half-periods",
                    r"\operatorname{sn}=\frac{m_3\theta'_4}{m_4\theta'_3}",
                    "the same from the saddle",
                ),
                by(
                    "half-periods",
                    r"\operatorname{cn}=\frac{k'm_3^2\theta'_1}{2em_4m_2\theta'_3}",
                    "the same from the saddle",
                ),
                by(
                    "half-periods",
                    r"\operatorname{dn}=\frac{k'm_3\theta'_2}{2em_2\theta'_3}",
                    "the same from the saddle",
                ),
                exempt(r"\phi=\frac{\pi y}{4K'}", "names the angle of the zero"),
                exempt(r"u=u_0+\eta t-2NK", "takes whole half periods off the argument"),
                by(
                    "legendre-by-carlson",
                    r"F=\tfrac{1}{6}\operatorname{sn}(u)^3R_D(\operatorname{cn}(u)^2,1,\operatorname{dn}(u)^2)",
                    "Legendre's integral differentiated",
                ),
                by(
                    "sensitivity-of-the-attitude",
                    r"\frac{d}{dt}(\boldsymbol{\alpha}\cdot\mathbf{L})=\mathbf{W}\cdot\mathbf{L}",
                    "the rate that keeps the momentum in the room, to first order",
                ),
                by(
                    "last-mean",
                    r"G=\frac{G_1+G_2}{2}-\frac{(G_1-G_2)^2}{8(G_1+G_2)}",
                    "but for a term of the fourth order, which the proof gives",
                ),
                exempt(
                    r"\xi=\sqrt{Z_1}\sqrt{Z_2}+\sqrt{Z_2}\sqrt{Z_3}+\sqrt{Z_3}\sqrt{Z_1}",
                    "names the sum of the products of roots",
                ),
                by(
                    "carlson-duplication",
                    r"R_F(Z_1,Z_2,Z_3)=R_F(\frac{Z_1+\xi}{4},\frac{Z_2+\xi}{4},\frac{Z_3+\xi}{4})",
                    "by a change of variable",
                ),
                by(
                    "carlson-duplication",
                    r"R_D(Z_1,Z_2,Z_3)=\frac{1}{4}R_D(\frac{Z_1+\xi}{4},\frac{Z_2+\xi}{4},\frac{Z_3+\xi}{4})+\frac{3}{\sqrt{Z_3}(Z_3+\xi)}",
                    "by a change of variable",
                ),
            ],
            notation: &[
                exempt("2E", "heads a column of values"),
                exempt("L^2", "heads a column of values"),
                exempt("P^2", "heads a column of values"),
                exempt("Q^2", "heads a column of values"),
                exempt("K'/K", "the ratio by which a series is chosen"),
                exempt(r"\sum (-1)^n\,q^{n^2} e^{2inz}", "defines a theta function"),
                exempt("-i", "names a factor of a theta function"),
                exempt(r"a+b\,\mathbf{j}", "names the quaternion"),
                exempt(r"a+b\,\mathbf{j}", "names the quaternion"),
                exempt(r"a+b\,\mathbf{j}", "names the quaternion"),
                exempt(r"z-s\,i\,z_0", "names the phase moved by the zero"),
                exempt("-i", "names a factor; the attitude with it is proven"),
                exempt(r"\nu\,t", "names the common phase"),
                exempt(r"-s\,\phi", "names the angle of a at the saddle"),
                exempt(r"-2\,s\,\phi", "names what a half period adds"),
                exempt("L/I_M", "names the lead of the law before it"),
                exempt(r"2\,K", "names the half period"),
                exempt("L/I_1", "names the rate about the momentum"),
            ],
        },
    ),
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
            laws: &[
                laws::BOX_ABOUT_X,
                laws::POWER,
                laws::ENERGY_RATE,
                laws::MIDDLE_MOMENT,
                laws::LARGEST_MOMENT,
                laws::WOBBLE,
                laws::GROWTH,
                laws::GAP_OF_A_BOX,
                laws::ACCELERATION,
                laws::MOMENTUM_RATE,
                laws::TRIANGLE,
                laws::ATTITUDE_RATE,
            ],
            exemptions: &[
                by(
                    "length-of-momentum",
                    r"\frac{d}{dt}(\mathbf{L}\cdot\mathbf{L})=2\mathbf{L}\cdot\boldsymbol{\tau}",
                    "in both forms of the law",
                ),
                by(
                    "spin-is-not-conserved",
                    r"\frac{d}{dt}(\boldsymbol{\omega}\cdot\boldsymbol{\omega})=\frac{2(I_1-I_2)(I_2-I_3)(I_1-I_3)}{I_1I_2I_3}\omega_1\omega_2\omega_3",
                    "without a torque",
                ),
            ],
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
    (
        "errata",
        Expected {
            laws: &[],
            exemptions: &[],
            notation: &[
                exempt(r"\Delta_j = G^2 - 2\,T I_j", "an abbreviation of the notes"),
                exempt(r"I_j\,\Delta_h/(I_j - I_h)", "an abbreviation of the notes"),
                exempt(
                    r"(\sigma B_{13}\operatorname{dn},\ -B_{21}\operatorname{sn},\ B_{31}\operatorname{cn})",
                    "the notes' momentum; proven as errata-rate-about-the-smallest-axis",
                ),
                exempt(r"\lambda t - \nu", "the notes' argument"),
                exempt(r"\lambda = -\sigma\lambda_3", "proven as errata-rate-about-the-smallest-axis"),
                exempt(r"\lambda = -\sigma\lambda_1", "proven as errata-rate-about-the-largest-axis"),
                exempt(r"G^2 = 2\,T I_2", "held by the assertion below"),
                exempt(r"\dot\psi = (2\,T + G\,m_3/I_3)/(G + m_3)", "proven as errata-rate-of-the-angle"),
                exempt("B_{31}/G", "a factor of the angle below"),
                exempt("n = -(B_{31}/B_{13})^2", "proven as errata-sign-of-the-angle"),
                exempt(r"G\,t/I_3", "proven as errata-sign-of-the-angle"),
                exempt(r"G\,(I_3 - I_1)/(\lambda I_1 I_3)", "proven as errata-sign-of-the-angle"),
                exempt(r"\Pi(\operatorname{am}, n, k)", "proven as errata-sign-of-the-angle"),
                exempt(
                    r"\frac{B_{31}\,B_{13}}{G\,B_{21}}\operatorname{arctan}\left(\frac{B_{21}}{B_{13}}\operatorname{sd}\right)",
                    "proven as errata-sign-of-the-angle",
                ),
                exempt(
                    r"1/(1 - n\operatorname{tanh}^2)",
                    "the notes' integrand; errata-characteristic-on-the-separatrix",
                ),
                exempt(
                    "n = G^4/(B_{21}^2 B_{23}^2)",
                    "proven to be one as errata-characteristic-on-the-separatrix",
                ),
                exempt("1 - n", "what the notes divide by"),
                exempt(r"2\,T t/G", "the rate above about the middle axis, where G² is 2 T I2"),
                exempt(
                    r"\frac{M}{I_3}\left(1 + \frac{I_{32}\,I_{31}}{I_1 I_{32} + I_3 I_{21}\operatorname{sn}^2}\right)",
                    "proven as errata-precession",
                ),
                exempt("I_{jh} = I_j - I_h", "an abbreviation of Orekit's"),
                exempt(
                    r"(o_1\operatorname{cn},\ o_2\operatorname{sn},\ o_3\operatorname{dn})",
                    "Orekit's spin; proven as errata-acceleration",
                ),
                exempt(
                    r"\operatorname{cn}\operatorname{dn}",
                    "Orekit's derivative; refuted as errata-acceleration",
                ),
                exempt(
                    r"-\operatorname{sn}\operatorname{dn}",
                    "Orekit's derivative; refuted as errata-acceleration",
                ),
            ],
        },
    ),
    ("glossary", Expected { laws: &[laws::GYROSCOPIC_TORQUE], exemptions: &[], notation: &[] }),
];

/// What is expected of a chapter.
pub(super) fn of(chapter: &str) -> Expected {
    CHAPTERS.iter().find(|known| known.0 == chapter).map_or(Expected::NOTHING, |known| known.1)
}
