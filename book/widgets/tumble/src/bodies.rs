//! The bodies of the page: those with a name, a ball, and an even box of the reader's own.

use crate::Why;
use exchange::Numbers;
use nalgebra::Vector3;
use tumbling::PrincipalMoments;
use tumbling::body::named::NamedBody;
use tumbling::solid::{Ball, Cuboid, Shape};

/// Those with a name, in the page's order. After them: 7, a ball; 8, a box of given edges; 9, a box of given
/// moments.
pub(crate) const BODIES: [NamedBody; 7] = [
    NamedBody::TheBox,
    NamedBody::Book,
    NamedBody::Phone,
    NamedBody::TennisRacket,
    NamedBody::WingNut,
    NamedBody::Hammer,
    NamedBody::THandle,
];

/// The mass of the ball and of a box of the reader's own, kg.
pub(crate) const OWN_MASS: f64 = 1.0;

/// The radius of the ball, m.
pub(crate) const BALL: f64 = 0.5;

/// A body of the page. Each lies with the smallest moment along z, the largest along y and the middle one
/// along x.
pub(crate) enum Chosen {
    Named(NamedBody),
    Ball,
    /// Its edges along x, y and z, m, and the moments about them, kg m².
    Box {
        edges: [f64; 3],
        moments: Vector3<f64>,
    },
}

impl Chosen {
    /// The body of this number; `own` are the three edges, m, or moments, kg m², in any order, of one of the
    /// reader's own. None where there is no such number.
    pub(crate) fn new(which: f64, own: [f64; 3]) -> Option<Result<Self, Why>> {
        let named = |place: usize| BODIES.get(place).copied().map(|body| Ok(Self::Named(body)));
        match which as usize {
            7 => Some(Ok(Self::Ball)),
            8 => Some(with_edges(sorted(own))),
            9 => Some(with_moments(sorted(own))),
            place => named(place),
        }
    }

    /// The moments about x, y and z, kg m², and the centre of mass from where the drawing has its origin, m.
    pub(crate) fn moments(&self) -> (Vector3<f64>, Vector3<f64>) {
        match self {
            Self::Named(body) => {
                let of = body.moments();
                (of.inertia.diagonal(), of.centre)
            }
            Self::Ball => (Ball::moments(&OWN_MASS, [&BALL]), Vector3::zeros()),
            Self::Box { moments, .. } => (*moments, Vector3::zeros()),
        }
    }
}

/// From the smallest to the largest.
fn sorted(mut own: [f64; 3]) -> [f64; 3] {
    own.sort_unstable_by(f64::total_cmp);
    own
}

fn with_edges([thick, wide, long]: [f64; 3]) -> Result<Chosen, Why> {
    Cuboid::new(wide, thick, long)?;
    let edges = [wide, thick, long];
    Ok(Chosen::Box { edges, moments: Cuboid::moments(&OWN_MASS, edges.each_ref()) })
}

/// The even box of these moments: from `I = m/12 (b² + c²)` and so on, `a² = 6/m (I_b + I_c - I_a)`.
fn with_moments([least, middle, most]: [f64; 3]) -> Result<Chosen, Why> {
    let moments: Vector3<f64> = PrincipalMoments::new(middle, most, least)?.vector();
    let half = moments.sum() / 2.0;
    let edges = moments.map(|moment| (12.0 / OWN_MASS * (half - moment)).max(0.0).sqrt());
    Ok(Chosen::Box { edges: edges.into(), moments })
}

/// The moments of a body about x, y and z, kg m², and its centre of mass, m; no answer where there is no such
/// body.
pub(crate) fn answer(which: f64, own: [f64; 3], row: &Numbers) -> Result<usize, Why> {
    let Some(body) = Chosen::new(which, own) else {
        return Err(Why(["a body", " has a number from 0 to 9"]));
    };
    let (moments, centre) = body?.moments();
    Ok(row.fill(&[moments.x, moments.y, moments.z, centre.x, centre.y, centre.z]))
}
