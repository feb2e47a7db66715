//! Bodies with three different moments and spins from one end of the number range to the other: all results
//! for accepted inputs are finite, and instants are in order.

use crate::common::*;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::dynamics::observe::sign_changes;
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::exact::{Batch, FreeMotion, Instant, LagrangeTop, Polhode, Regime, time_between_flips};
use tumbling::{Axis, Body, ErrorKind, Inertia, PrincipalMoments};

/// A number of any size, more often than not next to an end of the range or to one.
fn size() -> impl Strategy<Value = f64> {
    let power = prop_oneof![-323.0..308.0_f64, 300.0..308.25, -323.0..-300.0, -3.0..3.0];
    let ends = prop::sample::select(vec![0.0, 5e-324, f64::MIN_POSITIVE, 1.0, f64::MAX, 0.5 * f64::MAX]);
    prop_oneof![6 => power.prop_map(|power| 10_f64.powf(power).min(f64::MAX)), 1 => ends]
}

fn signed() -> impl Strategy<Value = f64> {
    (size(), any::<bool>()).prop_map(|(x, back)| if back { -x } else { x })
}

/// Of a possible body of any size, thin and flat ones too.
fn body() -> impl Strategy<Value = PrincipalMoments> {
    let part = || prop_oneof![3 => 0.05..1.0_f64, 1 => (-99.0..0.0_f64).prop_map(|power| 10_f64.powf(power))];
    (part(), part(), part(), -307.0..307.0_f64).prop_filter_map("no possible body", |(x, y, z, power)| {
        let size = 10_f64.powf(power);
        PrincipalMoments::new((y + z) * size, (z + x) * size, (x + y) * size).ok()
    })
}

fn spin() -> impl Strategy<Value = Vector3<f64>> {
    let alike = (vector(1.0), size()).prop_map(|(direction, size)| direction * size);
    let any = prop::array::uniform3(prop_oneof![9 => signed(), 1 => anything()]).prop_map(Vector3::from);
    prop_oneof![any, alike]
}

fn is_state(at: &Instant) -> bool {
    at.omega.iter().all(|x| x.is_finite()) && (at.attitude.norm() - 1.0).abs() < 1e-15
}

fn constants(regime: Regime) -> Vec<f64> {
    match regime {
        Regime::Steady { speed } => vec![speed],
        Regime::SymmetricTop { nutation, precession, .. } => vec![nutation, precession],
        Regime::Elliptic { modulus, complement, rate, .. } => vec![modulus, complement, rate],
        Regime::Separatrix { rate } => vec![rate],
        _ => Vec::new(),
    }
}

/// Checks that all results of a motion are finite and its flips are in order.
fn holds(motion: &FreeMotion, t: f64, u: f64) -> Result<(), TestCaseError> {
    for none in [f64::NAN, f64::INFINITY] {
        let errors = [
            motion.at(none).err(),
            motion.next_flip(none).err(),
            motion.flips(none, u).err(),
            motion.sensitivities(none).err(),
        ];
        prop_assert!(errors.iter().all(|e| e.as_ref().is_some_and(|e| e.kind() == ErrorKind::NotFinite)));
    }
    let at = motion.at(t).unwrap();
    prop_assert!(is_state(&at), "{at:?}");
    prop_assert_eq!((motion.omega(t).unwrap(), motion.attitude(t).unwrap()), (at.omega, at.attitude));
    if let Ok(body) = motion.body(t) {
        prop_assert!(body.momentum_world().iter().all(|x| x.is_finite()), "{body:?}");
    }
    prop_assert!(constants(motion.regime()).iter().all(|x| x.is_finite()), "{:?}", motion.regime());
    if let Regime::Elliptic { modulus, .. } = motion.regime() {
        prop_assert!(modulus <= 1.0, "{modulus:?}");
    }
    prop_assert!(motion.period().ok().flatten().is_none_or(|x| x.is_finite() && x > 0.0));
    prop_assert!(motion.twist_of_half_period().is_none_or(|x| x.is_finite() && x >= 0.0));
    for axis in Axis::ALL {
        let angles = motion.angles_to_momentum(axis);
        prop_assert!(angles.is_ok_and(|[a, b]| 0.0 <= a && a <= b && b <= 3.2) || at.omega.norm() == 0.0);
    }
    if let Ok(Some(flip)) = motion.next_flip(t) {
        prop_assert!(flip.is_finite() && flip > t, "{flip} after {t}");
    }
    if let Ok(flips) = motion.flips(t, u) {
        let (count, last) = (flips.remaining(), flips.clone().next_back());
        let times: Vec<f64> = flips.take(5).collect();
        prop_assert!(times.len() as u64 == count.min(5));
        prop_assert!(times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
        prop_assert!(
            times.iter().chain(&last).all(|flip| (t..=u).contains(flip) && *flip != t),
            "{times:?} {last:?}"
        );
    }
    for matrix in motion.sensitivities(t).into_iter().flat_map(|(a, b)| [a, b]) {
        prop_assert!(matrix.iter().all(|x| x.is_finite()));
    }
    Ok(())
}

proptest! {
    #[test]
    fn an_accepted_motion_is_made_of_numbers(m in body(), omega in spin(), t in signed(), u in signed()) {
        if let Ok(motion) = FreeMotion::new(m, &omega) {
            holds(&motion, t, u)?;
            let mut numbers = true;
            Batch::<f64>::new(&[motion]).each(&[t], |_, _, at: Instant| numbers &= is_state(&at)).unwrap();
            prop_assert!(numbers);
        }
    }

    #[test]
    fn an_accepted_body_moves_in_numbers(
        m in body(), frame in attitude(), start in attitude(), omega in spin(), t in signed(), u in signed(),
    ) {
        let [x, y, z] = m.into();
        let body = Inertia::from_moments(x, y, z)
            .and_then(|inertia| inertia.turned(frame))
            .and_then(|inertia| Body::spinning(inertia, start, &omega));
        if let Ok(motion) = body.and_then(|body| FreeMotion::of(&body)) {
            holds(&motion, t, u)?;
        }
    }

    #[test]
    fn an_accepted_polhode_is_made_of_numbers(m in body(), omega in spin()) {
        if let Ok(Polhode { least, greatest, period }) = Polhode::new(m, &omega) {
            prop_assert!(least.iter().zip(&greatest).all(|(a, b)| 0.0 <= *a && a <= b && b.is_finite()), "{least} {greatest}");
            prop_assert!(period.is_none_or(|x| x.is_finite() && x > 0.0), "{period:?}");
        }
        if let Ok(Some(time)) = time_between_flips(m, &omega) {
            prop_assert!(time.is_finite() && time > 0.0);
        }
        for axis in [Axis::Smallest, Axis::Middle, Axis::Largest] {
            if let Ok(Stability::Growth { rate } | Stability::Libration { rate }) = of_spin(m, axis, omega.x) {
                prop_assert!(rate.is_finite() && rate > 0.0);
            }
        }
    }

    #[test]
    fn an_accepted_top_is_made_of_numbers(
        ratio in 0.01..1.99_f64, scale in size(), start in attitude(), omega in spin(), arm in signed(), weight in size(), t in signed(),
    ) {
        let Ok(moments) = PrincipalMoments::new(scale, scale * ratio, scale) else { return Ok(()) };
        for start in [start, UnitQuaternion::identity()] {
            let Ok(top) = LagrangeTop::new(moments, start, &omega, &(Vector3::y() * arm), weight) else { continue };
            prop_assert!(is_state(&top.at(t).unwrap()), "{top:?}");
            prop_assert!(top.at(f64::NAN).is_err() && top.at(f64::INFINITY).is_err());
            prop_assert!(top.period().ok().flatten().is_none_or(|x| x.is_finite() && x > 0.0), "{top:?}");
            let numbers = [top.energy(), top.momentum_about_axis(), top.precession_rate()];
            prop_assert!(numbers.iter().chain(&top.lean()).all(|x| x.is_finite()), "{top:?}");
            if let Ok(body) = top.body(t) {
                prop_assert!(body.momentum_world().iter().all(|x| x.is_finite()));
            }
        }
    }

    #[test]
    fn changes_of_sign_are_in_order_and_between_their_samples(
        from in signed(), steps in prop::collection::vec((0..4_u64, signed()), 2..9),
    ) {
        // Times that are a few units apart, where the share of the way is rounded by as much.
        let mut time = from;
        let samples: Vec<(f64, f64)> = steps.iter().map(|&(units, x)| {
            time = (0..units).fold(time, |t, _| t.next_up());
            (time, x)
        }).collect();
        let changes = sign_changes(samples.iter().copied());
        prop_assert!(changes.windows(2).all(|pair| pair[0] <= pair[1]), "{changes:?} of {samples:?}");
        let within = |t: &f64| (samples[0].0..=samples[samples.len() - 1].0).contains(t);
        prop_assert!(changes.iter().all(within), "{changes:?} of {samples:?}");
    }
}

#[test]
fn an_energy_within_the_range_is_a_number_where_spin_times_momentum_is_none() {
    let motion = FreeMotion::new([1.7e308; 3].try_into().unwrap(), &Vector3::new(1.2, 0.0, 0.0)).unwrap();
    assert!((motion.energy() / 1.224e308 - 1.0).abs() < 1e-15, "{}", motion.energy());
    let least = FreeMotion::new([5e-324; 3].try_into().unwrap(), &Vector3::new(2e155, 0.0, 0.0)).unwrap();
    assert!((least.energy() / (2e155 * 5e-324 * 1e155) - 1.0).abs() < 1e-15, "{}", least.energy());
}

/// The component along the circled axis is greatest a quarter period later, and then beyond `f64`.
#[test]
fn a_polhode_that_leaves_the_range_is_refused() {
    let tilted = [3.34, 2.24, 3.64];
    for (m, omega) in [
        (tilted, [-5.8e300, f64::MAX, 0.0]),
        (tilted, [1.7e308, 1.7e308, 0.0]),
        ([1.0, 1.0, 1.5], [1.5e308, 1.5e308, 1.0]),
    ] {
        let polhode = Polhode::new(m.try_into().unwrap(), &omega.into());
        refused(polhode, ErrorKind::Unrepresentable, "the greatest spin");
    }
    // Twice the time between two flips, which itself is a number.
    let slow =
        Polhode::new(PrincipalMoments::new(1.0, 2.0, 3.0).unwrap(), &Vector3::new(2e-308, 6e-308, -1e-308));
    refused(slow, ErrorKind::Unrepresentable, "the period");
}
