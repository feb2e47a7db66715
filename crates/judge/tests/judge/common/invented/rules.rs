//! The rules that make records: of the judge's catalogue and others, and what a fault alters in them.

use super::{Fault, Step};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{Base, PHYSICS_ENGINES, Turn, When};

pub(super) fn rate(moments: &Vector3<f64>, omega: &Vector3<f64>) -> Vector3<f64> {
    angular_acceleration(moments, omega, &Vector3::zeros())
}

pub(super) fn turned(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> Quaternion<f64> {
    product(q, &turn(&(omega * h)))
}

/// A rule that the judge knows, for a body with these moments.
pub(super) fn known(base: Base, moments: Vector3<f64>) -> Step {
    let system = System::free(moments.try_into().unwrap()).unwrap();
    let stage = PositionStage::new(&moments).unwrap();
    Box::new(move |(q, omega), h| {
        let start = State { attitude: *q, momentum: system.momentum(omega) };
        let end = |state: State<f64>| (state.attitude, system.omega(&state.momentum));
        match base {
            Base::Exact => {
                let end = FreeMotion::new(moments.try_into().ok()?, omega).ok()?.at(h).ok()?;
                Some((product(q, &end.attitude), end.omega))
            }
            Base::Method(method, _) => method.step(&system, &start, h).ok().map(end),
            Base::Engine(engine) => engine.step(&system, &start, h).ok().map(end),
            Base::PositionStage(_) => {
                let end = stage.step(q, &(rotation_matrix(q) * omega), h);
                (end.parts > 0).then(|| (end.attitude, rotation_matrix(&end.attitude).tr_mul(&end.omega)))
            }
            Base::Straight(method, _) => {
                let mut engines = PHYSICS_ENGINES.iter().filter(|engine| engine.limits.straight);
                engines.find(|engine| engine.method == method)?.step(&system, &start, h).ok().map(end)
            }
            Base::FrozenTensor(first) => {
                let spin = first.conjugate() * (q * Quaternion::from_imag(*omega) * q.conjugate()) * first;
                let spin = spin.imag() + rate(&moments, &spin.imag()) * h;
                let world = rotation_matrix(&first) * spin;
                let q = product(&turn(&(world * h)), q);
                Some((q, rotation_matrix(&q).tr_mul(&world)))
            }
            Base::MomentumForSpin(mass) => {
                let (inside, world) = (start.momentum, rotation_matrix(q) * start.momentum);
                let q = turned(q, &(inside / mass), h);
                Some((q, system.omega(&rotation_matrix(&q).tr_mul(&world))))
            }
            _ => None,
        }
    })
}

/// A step of a rule that the judge does not know.
pub(super) struct Unknown<'a> {
    moments: &'a Vector3<f64>,
    w: Vector3<f64>,
    h: f64,
    /// Of the steps before: how many, the first speed, and the last term.
    past: &'a mut (u32, f64, Vector3<f64>),
    /// What turns the body, where that is not the new spin.
    by: Option<Vector3<f64>>,
}

/// The spin at its end.
pub(super) type Spin = fn(&mut Unknown<'_>) -> Option<Vector3<f64>>;

impl Unknown<'_> {
    fn f(&self, w: Vector3<f64>) -> Vector3<f64> {
        rate(self.moments, &w)
    }

    fn explicit(&self) -> Vector3<f64> {
        self.w + self.f(self.w) * self.h
    }

    fn exact(&self) -> Option<Vector3<f64>> {
        FreeMotion::new((*self.moments).try_into().ok()?, &self.w).ok()?.omega(self.h).ok()
    }

    fn energy(&self, w: &Vector3<f64>) -> f64 {
        w.dot(&self.moments.component_mul(w))
    }

    /// The spin at the end, where the mean of both turns the body.
    fn by_mean(&mut self, end: Vector3<f64>) -> Option<Vector3<f64>> {
        self.by = Some((self.w + end) / 2.0);
        Some(end)
    }
}

pub(super) const OUTSIDE: [(&str, Spin); 12] = [
    ("Heun, the mean spin turns", |s| s.by_mean(s.w + (s.f(s.w) + s.f(s.explicit())) * (s.h / 2.0))),
    ("Kutta's third order, the new spin turns", |s| {
        let a = s.f(s.w);
        let b = s.f(s.w + a * (s.h / 2.0));
        Some(s.w + (a + b * 4.0 + s.f(s.w + (b * 2.0 - a) * s.h)) * (s.h / 6.0))
    }),
    ("the exact spin, the new one turns", |s| s.exact()),
    ("two rounds of the midpoint rule", |s| s.by_mean(s.w + s.f((s.w + s.explicit()) / 2.0) * s.h)),
    ("explicit, energy and momentum put right", |s| {
        // Two of the squares of the spin's components are solved for, the third is kept.
        let (mut end, [a, b, c]) = (s.explicit(), (*s.moments).into());
        let (e, l) = (s.energy(&s.w), s.moments.component_mul(&s.w).norm_squared());
        let (e, l) = (e - a * end.x * end.x, l - a * a * end.x * end.x);
        let (y, z) = ((c * e - l) / (b * (c - b)), (l - b * e) / (c * (c - b)));
        if y > 0.0 && z > 0.0 && y.is_finite() && z.is_finite() {
            (end.y, end.z) = (y.sqrt().copysign(end.y), z.sqrt().copysign(end.z));
        }
        Some(end)
    }),
    ("explicit, energy put right", |s| {
        Some(s.explicit() * (s.energy(&s.w) / s.energy(&s.explicit())).sqrt())
    }),
    ("drag of the square of the speed", |s| Some(s.exact()? * (1.0 - 0.02 * s.h * s.w.norm()))),
    ("damping about one axis", |s| {
        Some(s.explicit().component_mul(&Vector3::new(1.0 - 0.05 * s.h, 1.0, 1.0)))
    }),
    ("friction of one size", |s| {
        Some(s.explicit() * (1.0 - (0.02 * s.past.1 * s.h / s.explicit().norm()).min(1.0)))
    }),
    ("momentum in the world, the old tensor", |s| {
        s.by = Some(s.w);
        let after = rotation_matrix(&turn(&(s.w * s.h))).tr_mul(&s.moments.component_mul(&s.w));
        Some(after.component_div(s.moments))
    }),
    (IN_TURN, |s| Some(if s.past.0 % 2 == 1 { s.explicit() } else { s.w })),
    ("Adams and Bashforth, the new spin turns", |s| Some(s.w + (s.f(s.w) * 1.5 - s.past.2 * 0.5) * s.h)),
];

/// Of which two steps are one, of half of the term.
pub(super) const IN_TURN: &str = "every second step without the term";

/// A rule that the judge does not know.
pub(super) fn outside(rule: Spin, moments: Vector3<f64>) -> Step {
    let past = std::cell::Cell::new((0, 0.0, Vector3::zeros()));
    Box::new(move |(q, w), h| {
        let (count, speed, term) = past.get();
        let now = rate(&moments, w);
        let mut before = if count == 0 { (1, w.norm(), now) } else { (count + 1, speed, term) };
        past.set((before.0, before.1, now));
        let mut step = Unknown { moments: &moments, w: *w, h, past: &mut before, by: None };
        let end = rule(&mut step)?;
        Some((turned(q, &step.by.unwrap_or(end), h), end))
    })
}

/// Of which the new spin turns the body, so that it may be altered before it does.
pub(super) const BY_THE_NEW: [Method; 5] = [
    Method::SemiImplicitEuler,
    Method::Rescaled,
    Method::ImplicitOneNewton,
    Method::LinearisedImplicit,
    Method::ConstantSpin,
];

/// A rule with a fault.
pub(super) fn altered(step: Step, fault: Fault) -> Step {
    Box::new(move |(q, w), h| match fault {
        Fault::Damped(rate, When::Before) => step(&(*q, w * (1.0 - rate * h)), h),
        Fault::Damped(rate, When::After) => {
            let w = step(&(*q, *w), h)?.1 * (1.0 - rate * h);
            Some((turned(q, &w, h), w))
        }
        Fault::Damped(rate, When::Turned) => step(&(*q, *w), h).map(|(q, w)| (q, w * (1.0 - rate * h))),
        Fault::Term(times) => {
            let w = step(&(*q, *w), h * times)?.1;
            Some((turned(q, &w, h), w))
        }
        Fault::Turned(Turn::Old) => Some((turned(q, w, h), step(&(*q, *w), h)?.1)),
        Fault::Turned(Turn::BodyInWorld) => {
            let w = step(&(*q, *w), h)?.1;
            Some((product(&turn(&(w * h)), q), w))
        }
        Fault::Turned(Turn::WorldInBody) => {
            let world = rotation_matrix(q) * step(&(*q, *w), h)?.1;
            let q = turned(q, &world, h);
            Some((q, rotation_matrix(&q).tr_mul(&world)))
        }
        Fault::Turned(Turn::TwiceBefore) => step(&(turned(q, w, h), *w), h),
        Fault::Turned(Turn::TwiceAfter) => step(&(*q, *w), h).map(|(q, w)| (turned(&q, &w, h), w)),
        Fault::Turned(Turn::Own) => {
            let (end, w) = step(&(*q, *w), h)?;
            let w = rotation_matrix(q).tr_mul(&(rotation_matrix(&end) * w));
            Some((turned(q, &w, h), w))
        }
        _ => step(&(*q, *w), h),
    })
}
