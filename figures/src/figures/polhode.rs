//! The ellipsoid of equal energy and the paths of the spin on it, shared by two figures.

use crate::draw::{Canvas, Fill, Ink, P, Pen, View};
use crate::motion;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::Inertia;
use tumbling::exact::time_between_flips;

/// The spins at which a body has one given energy.
#[derive(Debug)]
pub(crate) struct Ellipsoid {
    pub(crate) inertia: Inertia,
    pub(crate) moments: Vector3<f64>,
    /// Half its axes: the spins about the principal axes.
    pub(crate) reach: Vector3<f64>,
}

impl Ellipsoid {
    /// For moments in rising order, with an energy such that the longest half axis is 1 rad/s.
    pub(crate) fn new(moments: [f64; 3]) -> Result<Self, Box<dyn Error>> {
        let inertia = Inertia::from_moments(moments[0], moments[1], moments[2])?;
        let reach = Vector3::from(moments).map(|moment| (moments[0] / moment).sqrt());
        Ok(Self { inertia, moments: moments.into(), reach })
    }

    fn seen(&self, view: &View, p: &Vector3<f64>) -> bool {
        view.toward().dot(&self.moments.component_mul(p)) > 0.0
    }

    /// The outline: where the line of sight grazes the surface.
    pub(crate) fn outline(&self, view: &View) -> Vec<P> {
        // On the unit sphere from which the ellipsoid is stretched, the outline is a great circle.
        let pole = view.toward().component_div(&self.reach).normalize();
        let first = pole.cross(&Vector3::x()).normalize();
        let second = pole.cross(&first);
        (0..=180)
            .map(|i| {
                let (s, c) = (TAU * f64::from(i) / 180.0).sin_cos();
                view.at(&(first * c + second * s).component_mul(&self.reach))
            })
            .collect()
    }

    /// The closed path of the spin that starts `share` of the way from the end of an axis (0 or 2, positive
    /// or negative) to the separatrix.
    pub(crate) fn polhode(
        &self,
        axis: usize,
        sign: f64,
        share: f64,
    ) -> Result<Vec<Vector3<f64>>, Box<dyn Error>> {
        let other = 2 - axis;
        let angle = share * self.separatrix_angle(axis);
        let mut start = Vector3::zeros();
        start[axis] = sign * angle.cos() * self.reach[axis];
        start[other] = sign * angle.sin() * self.reach[other];
        let half = time_between_flips(self.moments.try_into()?, &start)?.ok_or("no period")?;
        let steps = 360;
        let body = motion::spun(self.inertia, start)?;
        let path = motion::free(&body, 2.0 * half / f64::from(steps), usize::try_from(steps)?)?;
        Ok(path.iter().map(|(_, body)| body.omega_body()).collect())
    }

    /// The distance of the separatrix from the end of axis 0 or 2, on the sphere before stretching, in the
    /// plane of these two axes.
    fn separatrix_angle(&self, axis: usize) -> f64 {
        let i = &self.moments;
        // There `I1 (I2 - I1) w1² = I3 (I3 - I2) w3²`, and `I w²` is the same for the ends of all axes.
        let tangent = ((i[1] - i[0]) / (i[2] - i[1])).sqrt();
        if axis == 0 { tangent.atan() } else { (1.0 / tangent).atan() }
    }

    /// One of the two ellipses that make up the separatrix.
    pub(crate) fn separatrix(&self, sign: f64) -> Vec<Vector3<f64>> {
        let angle = self.separatrix_angle(0);
        let across = Vector3::new(angle.cos(), 0.0, sign * angle.sin());
        (0..=360)
            .map(|i| {
                let (s, c) = (TAU * f64::from(i) / 360.0).sin_cos();
                (Vector3::y() * c + across * s).component_mul(&self.reach)
            })
            .collect()
    }

    /// Draws a curve on the surface: solid in front, faint behind.
    pub(crate) fn curve(
        &self,
        canvas: &Canvas,
        view: &View,
        points: &[Vector3<f64>],
        before: Pen,
        behind: Option<Pen>,
    ) {
        let mut from = 0;
        for part in points.chunk_by(|p, q| self.seen(view, p) == self.seen(view, q)) {
            let pen = if self.seen(view, &points[from]) { Some(before) } else { behind };
            // Each part goes on to the first point of the next, so that no gap remains.
            let to = (from + part.len()).min(points.len() - 1);
            if let Some(pen) = pen {
                canvas.path(&points[from..=to].iter().map(|p| view.at(p)).collect::<Vec<_>>(), pen);
            }
            from = to;
        }
    }

    /// An arrowhead on a curve, at the point nearest to the viewer.
    pub(crate) fn head(&self, canvas: &Canvas, view: &View, points: &[Vector3<f64>], at: usize, pen: Pen) {
        let n = points.len() - 1;
        let around: Vec<P> = (0..=12).map(|i| view.at(&points[(at + n + i - 12) % n])).collect();
        if self.seen(view, &points[at % n]) {
            canvas.arrow_along(&around, pen);
        }
    }

    /// The surface itself.
    pub(crate) fn surface(&self, canvas: &Canvas, view: &View, edge: Pen) {
        let outline = self.outline(view);
        canvas.area(&outline, Fill::new(Ink::Surface), Some(edge));
    }
}
