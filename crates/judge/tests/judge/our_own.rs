//! The exact motion and the library's own methods, judged.

use crate::common::{MOMENTS, SPINS, csv, exact, judged, stepped, stepped_by};
use nalgebra::Vector3;
use tumbling::step::{Engine, Method, State, System};
use tumbling::{Body, Inertia};
use tumbling_judge::{Alteration, Base, Confidence, Growth, LawName, Outcome, Rule, Verdict};

fn growth(verdict: &Verdict, name: LawName) -> Growth {
    verdict.laws.iter().find(|law| law.name == name).map_or(Growth::Rounding, |law| law.growth)
}

#[test]
fn the_exact_motion_is_kept_to_rounding_in_every_law() {
    for spin in SPINS {
        let verdict = judged(&csv(&exact(spin.into(), 0.01, 3000)));
        assert!(verdict.laws.iter().all(|law| law.growth == Growth::Rounding), "{spin:?} {verdict}");
        assert!(verdict.laws.len() >= 6);
        assert_eq!(verdict.outcome, Outcome::Passed);
        let flips = verdict.flips.unwrap();
        assert_eq!(flips.found, flips.exact);
        assert_eq!(verdict.diagnosis.unwrap().best.rule, Rule::EXACT);
    }
}

#[test]
fn every_method_is_graded_as_it_says_of_itself_and_named() {
    let mut all_said = [false; 3];
    for &method in Method::ALL {
        let keeps = method.info();
        let spin = Vector3::new(1.0, 2.0, 1.5);
        let verdict = judged(&csv(&stepped(method, spin, 0.05, 1000)));
        let is_kept = |law| growth(&verdict, law) == Growth::Rounding;
        for (law, kept) in [
            (LawName::Energy, keeps.energy),
            (LawName::Momentum, keeps.momentum),
            (LawName::Direction, keeps.direction),
            (LawName::Unit, keeps.unit),
        ] {
            // A method of high order may be exact to rounding at this step without a law that says so.
            let too_good = method.info().order >= 6;
            assert!(kept == is_kept(law) || !kept && too_good, "{method:?} {law:?}: {verdict}");
        }
        let diagnosis = verdict.diagnosis.as_ref().unwrap();
        // What advice says is kept is kept in this record.
        let said = |words| diagnosis.advice[0].words.contains(words);
        let named = ["energy and momentum have", "momentum's length have", "momentum has those of rounding"]
            .map(said);
        all_said = [0, 1, 2].map(|i| all_said[i] || named[i]);
        let (energy, direction) = (named[0] || named[1], named[0] || named[2]);
        let right = (!energy || is_kept(LawName::Energy)) && (!direction || is_kept(LawName::Direction));
        assert!(right, "{method:?}: {verdict}");
        let rules = std::iter::once(diagnosis.best.rule).chain(diagnosis.alike.iter().copied());
        assert!(rules.filter_map(|rule| rule.method()).any(|x| x == (method, 1)), "{method:?}: {diagnosis}");
        assert_eq!(diagnosis.confidence, Confidence::ToRounding, "{method:?}");
    }
    assert_eq!(all_said, [true; 3]);
}

#[test]
fn momentum_taken_for_spin_is_named_where_the_record_is_of_momentum() {
    let (tensor, spin) = (Inertia::from_moments(1.0, 2.0, 2.5).unwrap(), Vector3::new(1.0, 2.0, 1.5));
    let body = Body::spinning(tensor, nalgebra::UnitQuaternion::identity(), &spin).unwrap();
    let run = Engine::MomentumForSpin.run(&body, 0.01, 500).unwrap();
    // What the engine itself believes in: a momentum that stays, in the world.
    let momentum = body.momentum_world();
    let row = |(i, body): (u32, &Body)| (0.01 * f64::from(i), body.attitude().into_inner(), momentum);
    let text = csv(&(0..).zip(&run).map(row).collect::<Vec<_>>()).replace("wx,wy,wz", "lxw,lyw,lzw");
    let diagnosis = judged(&text).diagnosis.unwrap();
    // Runge and Kutta's turn is right to 1e-10 here, and the number is the mean of the moments.
    let Base::MomentumForSpin(mass) = diagnosis.best.rule.base else { panic!("{diagnosis}") };
    assert!((mass - 5.5 / 3.0).abs() < 1e-6, "{diagnosis}");
    assert!(diagnosis.best.median < 1e-8 && diagnosis.ratio().unwrap() > 1e4, "{diagnosis}");
}

#[test]
fn a_cap_on_the_spin_is_named() {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let rows = stepped_by(Vector3::new(1.0, 2.0, 1.5), 0.02, 1000, |motion| {
        let end = Method::SemiImplicitEuler.step(&system, motion, 0.02).unwrap();
        let omega = system.omega(&end.momentum);
        let omega = omega * (2.6 / omega.norm()).min(1.0);
        let q = motion.attitude * tumbling::attitude::turn(&(omega * 0.02));
        State { attitude: q, momentum: system.momentum(&omega) }
    });
    let diagnosis = judged(&csv(&rows)).diagnosis.unwrap();
    let Some(Alteration::Capped(most)) = diagnosis.best.rule.alteration else { panic!("{diagnosis}") };
    assert!((most - 2.6).abs() < 1e-9, "{diagnosis}");
}
