//! Torques named after their causes, with units.

use super::Torque;
use crate::number::Field;
use alloc::boxed::Box;
use nalgebra::Vector3;

impl<T: Field> Torque<T> {
    /// Gravity on a top whose centre of mass is at `arm` (m) from the fixed point, in body axes, and whose
    /// weight (mass times gravitational acceleration, N) pulls along the world's -z. The top's inertia tensor
    /// must be that about the fixed point.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::Body;
    /// use tumbling::solid::{Ellipsoid, Solid};
    /// use tumbling::step::{Method, Stepper, Torque};
    /// // An egg of 60 g on its tip, leaning by 0.3 rad: what it gains in kinetic energy, gravity has done as
    /// // work.
    /// let egg = Ellipsoid::new(0.02, 0.021, 0.03)?.with_mass(0.06)?;
    /// let (arm, weight) = (Vector3::new(0.0, 0.0, 0.03), egg.mass() * 9.81);
    /// let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.3);
    /// let body = Body::spinning(egg.about(&-arm)?, leaning, &Vector3::new(0.0, 0.0, 150.0))?;
    /// let mut stepper = Stepper::new(&body, Method::Gauss6)?.with_torques([Torque::gravity(&arm, weight)])?;
    /// stepper.run(1e-3, 1000).try_for_each(|state| state.map(drop))?;
    /// let height = |body: &Body| (body.attitude() * arm).z;
    /// let end = stepper.body()?;
    /// let work = weight * (height(&body) - height(&end));
    /// assert!((end.energy() - body.energy() - work).abs() < 1e-12 * body.energy());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn gravity(arm: &Vector3<T>, weight: T) -> Self {
        Self::Aligning { arm: arm.clone(), field: Vector3::new(T::zero(), T::zero(), -weight) }
    }

    /// A spring that turns the body back to where its axis `arm` (body axes) lies along `rest` (world axes):
    /// `stiffness` (N m) times the sine of the angle between the two, so near rest the stiffness in N m/rad.
    /// The two vectors are not normalized: their lengths multiply the stiffness.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // A hundredth of a radian off, 2 kg m² at 8 N m/rad: half an oscillation in pi/2 s.
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let leaning = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 0.01);
    /// let body = Body::spinning(inertia, leaning, &Vector3::zeros())?;
    /// let spring = Torque::spring(&Vector3::x(), &Vector3::x(), 8.0);
    /// let mut stepper = Stepper::adaptive(&body, 1e-10, 1000)?.with_torques([spring])?;
    /// let end = stepper.step(std::f64::consts::FRAC_PI_2)?;
    /// assert!((2.0 * end.attitude.j + 0.01).abs() < 1e-6);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn spring(arm: &Vector3<T>, rest: &Vector3<T>, stiffness: T) -> Self {
        Self::Aligning { arm: arm.clone(), field: rest.map(|x| x * stiffness.clone()) }
    }

    /// The gravity gradient on a satellite in a circular orbit, in world axes that do not turn with the
    /// orbit. `toward`, of length 1 (a stepper refuses other lengths), points to the attracting body at time
    /// zero. It turns with `orbit`, the orbit's angular velocity (rad/s, along its normal). For a body that
    /// does not move relative to the attracting one, see [`Torque::GravityGradient`].
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // A satellite as it should be: its long axis x toward the earth, the axis z of its largest moment
    /// // normal to the orbit of 90 minutes, turning with it. After a quarter of an orbit it still points
    /// // there.
    /// let rate = std::f64::consts::TAU / 5400.0;
    /// let inertia = Inertia::from_moments(10.0, 40.0, 45.0)?;
    /// let spin = Vector3::new(0.0, 0.0, rate);
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &spin)?;
    /// let gradient = Torque::gravity_gradient(&Vector3::x(), &spin);
    /// let mut stepper = Stepper::adaptive(&body, 1e-12, 1000)?.with_torques([gradient])?;
    /// stepper.step(1350.0)?;
    /// let pointing = stepper.body()?.attitude() * Vector3::x();
    /// assert!((pointing - Vector3::y()).norm() < 1e-10);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn gravity_gradient(toward: &Vector3<T>, orbit: &Vector3<T>) -> Self {
        let square = orbit.dot(orbit);
        Self::GravityGradient {
            strength: square * T::integer(3),
            direction: toward.clone(),
            orbit: orbit.clone(),
        }
    }

    /// `torque` from the time `start` to the time `end` (s), and no torque before and after: a thruster that
    /// fires. The time is that of the [`Stepper`](crate::step::Stepper).
    ///
    /// An adaptive run ends a step where a torque begins and where it ends. Methods with a fixed step, and
    /// kicks, apply the torque if the time at which they evaluate it is between the two.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // 2 N m for 0.3 s on 4 kg m², from rest.
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
    /// let fired = Torque::during(0.5, 0.8, Torque::InBody(Vector3::z() * 2.0));
    /// let mut stepper = Stepper::adaptive(&body, 1e-10, 1000)?.with_torques([fired])?;
    /// stepper.step(10.0)?;
    /// assert!((stepper.omega().z - 0.15).abs() < 1e-14);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn during(start: T, end: T, torque: Self) -> Self {
        Self::During { start, end, torque: Box::new(torque) }
    }
}
