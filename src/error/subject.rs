//! The quantity that an error is about.

use core::fmt;

macro_rules! subjects {
    ($($name:ident => $words:literal,)*) => {
        /// The quantity that an [`Error`](crate::Error) is about, for programs that write their own messages
        /// or mark the input. `Display` prints the words used in the error's message.
        ///
        /// ```
        /// use tumbling::solid::Cuboid;
        /// use tumbling::Subject;
        /// let error = Cuboid::new(1.0, -2.0, 3.0).unwrap_err();
        /// assert_eq!(error.subject(), Subject::EdgeY);
        /// assert_eq!(error.to_string(), "the edge along y is -2.0: it must be above zero");
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Subject {
            $(#[doc = concat!("\"", $words, "\"")] $name,)*
        }

        impl Subject {
            /// The words used in the error's message: "the mass", "the edge along x".
            #[must_use]
            pub fn words(self) -> &'static str {
                match self {
                    $(Self::$name => $words,)*
                }
            }
        }
    };
}

subjects! {
    Mass => "the mass",
    Density => "the density",
    Volume => "the volume",
    Area => "the area",
    Length => "the length",
    Radius => "the radius",
    InnerRadius => "the inner radius",
    OuterRadius => "the outer radius",
    Height => "the height",
    EdgeX => "the edge along x",
    EdgeY => "the edge along y",
    EdgeZ => "the edge along z",
    SemiAxisX => "the semi-axis along x",
    SemiAxisY => "the semi-axis along y",
    SemiAxisZ => "the semi-axis along z",
    Vertex => "the vertex",
    Vertices => "vertices",
    Face => "a face",
    Faces => "faces",
    MeshEdge => "an edge",
    Shell => "a shell",
    Position => "the position",
    Points => "points",
    DistinctPoints => "distinct points",
    Parts => "parts",
    Offset => "the offset",
    Point => "the point",
    CentreOfMass => "the centre of mass",
    Tensor => "the inertia tensor",
    Moment => "a moment of inertia",
    Product => "a product of inertia",
    Ixx => "the moment Ixx",
    Iyy => "the moment Iyy",
    Izz => "the moment Izz",
    Ixy => "the product Ixy",
    Ixz => "the product Ixz",
    Iyz => "the product Iyz",
    LargestMoment => "the largest moment of inertia",
    SmallestMoment => "the smallest principal moment",
    PrincipalMoment => "a principal moment",
    PrincipalMoments => "the principal moments",
    MomentRatio => "a ratio of the moments",
    TurnedMoment => "a turned moment",
    InverseMoment => "an inverse moment",
    MomentAboutAxis => "the moment",
    Axis => "the axis",
    AxesTurn => "the turn from the principal axes",
    RelativeTolerance => "the relative tolerance",
    Attitude => "the attitude quaternion",
    AttitudeLength => "the length of the attitude quaternion",
    Spin => "the spin",
    AngularMomentum => "the angular momentum",
    DisturbanceRate => "the rate of a small disturbance",
    Time => "the time",
    IntervalStart => "the start of the interval",
    IntervalEnd => "the end of the interval",
    GreatestSpin => "the greatest spin",
    Period => "the period",
    NextFlip => "the time of the next flip",
    TimeBetweenFlips => "the time between flips",
    FlipNumber => "the number of flips from the start",
    Derivative => "a derivative of the motion",
    FlipTimes => "the times of flips",
    ComplementaryModulus => "the complementary modulus",
    Arm => "the arm",
    Weight => "the weight",
    ArmOffAxis => "the part of the arm across the nearest principal axis, as a share of the arm",
    MomentDifference => "the relative difference of the two moments across the top's axis",
    TopFastestRate => "the fastest rate of the top",
    TopRate => "a rate or an energy of the top",
    TopHanging => "1 plus the cosine of the lean",
    TopUpright => "1 less the cosine of the lean",
    TopSpinAcross => "the square of the spin across the axis over that of the fastest rate",
    TopTorque => "twice the weight's torque over the moment across the axis and the square of the fastest rate",
    Step => "the step",
    Steps => "steps",
    Duration => "the duration",
    EndTime => "the time to run to",
    TimeAfterStep => "the time after a step",
    MotionAfterStep => "the motion after a step",
    AttitudeAfterStep => "the attitude after a step",
    TurnOfStep => "the turn of a step",
    MoserVeselovTurn => "the turn (rad) of a Moser-Veselov step",
    AlteredMoment => "the relative change of an inverse moment that preprocessing makes for a turn this long",
    SpinSquare => "the square of the spin",
    Midpoint => "the midpoint of a step",
    Stages => "the stages of a collocation step",
    StepEnd => "the end of a step",
    Tolerance => "the tolerance",
    StepLength => "a step that meets the tolerance",
    RateAtStart => "the rate at the start",
    AdaptiveRun => "an adaptive run",
    MotionWithinStep => "the motion within a step",
    MotionOutsideStep => "the motion outside the last step",
    Transition => "the state transition",
    StepTransition => "the state transition of a step",
    StepError => "the error of an adaptive step",
    FlipWithinStep => "the time of a flip within a step",
    Torque => "the torque",
    Field => "the field of a torque (a weight, a magnetic field, or the stiffness times the direction of rest)",
    DampingCoefficient => "a damping coefficient",
    UnequalDamping => "damping that differs from axis to axis",
    DissipationStrength => "the strength of the dissipation",
    GradientStrength => "the strength of the gravity gradient",
    GradientDirection => "the direction of the gravity gradient",
    OrbitRate => "the rate of the orbit",
    PeriodicRate => "the rate of a periodic torque",
    PeriodicPhase => "the phase of a periodic torque",
    TorqueStart => "the start of a torque",
    TorqueEnd => "the end of a torque",
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.words())
    }
}
