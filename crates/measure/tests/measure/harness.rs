//! The harness itself: that it distinguishes a right method from a wrong one.

use nalgebra::Quaternion;
use std::path::Path;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State};
use tumbling_measure::contestant::{About, Contestant, Exact, Group, Knob, Ours, Setting, ours};
use tumbling_measure::errors::{Ended, Observed, Observer, Outcome};
use tumbling_measure::measure::{Effort, measure};
use tumbling_measure::record::{self, Long, Record, Work};
use tumbling_measure::story::{self, Story, in_world};
use tumbling_measure::{campaign, long, verdict};

// A ladder ends by its errors: the seconds are far above what a rung takes, on a busy machine too.
const SMALL: Effort = Effort { repeats: 1, seconds: 2.0, turns: 4000, starts: 1, long: 0.0 };

fn measured(contestant: impl Contestant + 'static, story: &str) -> Vec<Work> {
    let stories: Vec<Story> = story::all().unwrap().into_iter().filter(|s| s.name == story).collect();
    assert_eq!(stories.len(), 1);
    measure(&[Box::new(contestant)], &stories, SMALL, &mut |_| ())
}

fn judged(contestant: &dyn Contestant, story: &Story, steps: u64) -> (Outcome, Option<f64>) {
    let mut observer = Observer::new(story);
    let ended = contestant.run(story, Setting::Steps(steps), Some(&mut observer));
    let (outcome, errors) = observer.judge(ended.as_ref());
    (outcome, errors.attitude)
}

/// Halving the step of the classical method divides its errors by 16, with torque and without.
#[test]
fn a_method_of_order_four_shows_slope_four() {
    let names = ["wobble", "heavy top", "damped spin", "gravity gradient", "resonant push"];
    for story in story::all().unwrap().into_iter().filter(|story| names.contains(&story.name)) {
        let steps = (story.speed() * story.end / 0.01).ceil() as u64;
        let [coarse, fine] =
            [steps, 2 * steps].map(|steps| judged(&Ours(Method::RungeKutta4), &story, steps).1.unwrap());
        let slope = (coarse / fine).log2();
        assert!((slope - 4.0).abs() < 0.2, "{}: {slope}", story.name);
    }
}

/// A ladder of settings doubles the steps, and its rows come back as they are measured.
#[test]
fn a_ladder_doubles_the_steps() {
    let rows = measured(Ours(Method::RungeKutta4), "wobble");
    assert!(rows.len() > 5, "{rows:?}");
    for pair in rows.windows(2) {
        assert_eq!(pair[1].equal_steps().unwrap(), 2 * pair[0].equal_steps().unwrap());
    }
    let [.., fine] = rows.as_slice() else { panic!("no rows") };
    assert!(fine.right() && fine.attitude.unwrap() < 1e-6 && fine.seconds.unwrap() > 0.0, "{fine:?}");
}

/// What must hold of the true end of each story, whoever computed it.
#[test]
fn the_table_keeps_the_laws() {
    for story in story::all().unwrap() {
        let end = &story.truth.motion;
        assert!((end.attitude.norm() - 1.0).abs() < 1e-15, "{}", story.name);
        assert!((story.energy(end) / story.truth.energy - 1.0).abs() < 1e-14, "{}", story.name);
        let started = story.energy(&story.start);
        if story.keeps_energy() {
            assert!((started / story.truth.energy - 1.0).abs() < 1e-14, "{}", story.name);
        } else if story.drive.damping != [0.0; 3] {
            assert!(story.truth.energy < started, "{}", story.name);
        }
        if story.is_free() {
            let moved = in_world(&end.attitude, &end.momentum) - story.start.momentum;
            assert!(moved.norm() < 1e-14 * story.start.momentum.norm(), "{}", story.name);
        }
    }
}

/// A contestant that is right but for one thing.
struct Broken(fn(State<f64>) -> Result<State<f64>, Outcome>);

impl Contestant for Broken {
    fn about(&self) -> About {
        About { name: "broken", group: Group::Neither, knob: Knob::Steps }
    }
    fn run(&self, story: &Story, setting: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let mut ended = Ours(Method::RungeKutta4).run(story, setting, observer)?;
        ended.motion = (self.0)(ended.motion)?;
        Ok(ended)
    }
}

#[test]
fn what_is_broken_shows_as_broken() {
    let stories = story::all().unwrap();
    let [wobble] = [&stories[1]];
    assert_eq!(judged(&Broken(Ok), wobble, 8192).0, Outcome::Right);
    let lost = Broken(|motion| Ok(State { attitude: motion.attitude * f64::NAN, ..motion }));
    assert_eq!(judged(&lost, wobble, 8192), (Outcome::NotFinite, None));
    let refuses = Broken(|_| Err(Outcome::Refused("not today".into())));
    assert_eq!(judged(&refuses, wobble, 8192).0, Outcome::Refused("not today".into()));
    // Turned by a tenth of a radian about some axis, the attitude is off by just that, and nothing else is.
    let turned = Broken(|motion| {
        let by = Quaternion::new(0.05_f64.cos(), 0.0, 0.6 * 0.05_f64.sin(), 0.8 * 0.05_f64.sin());
        Ok(State { attitude: by * motion.attitude, ..motion })
    });
    let (outcome, attitude) = judged(&turned, wobble, 1 << 16);
    assert_eq!(outcome, Outcome::Right);
    assert!((attitude.unwrap() - 0.1).abs() < 1e-6, "{attitude:?}");
}

/// Without the gyroscopic term a body never flips: the box's 100 are missed, and seen to be missed.
#[test]
fn a_missing_flip_is_counted() {
    let stories = story::all().unwrap();
    assert_eq!(stories[0].truth.flips.unwrap().count, 100);
    assert_eq!(judged(&Ours(Method::ConstantSpin), &stories[0], 4096).0, Outcome::Flips(0));
}

/// The phase is the last flip's delay relative to the time between two: here the method's own clock runs slow
/// by a known share.
#[test]
fn a_slow_clock_shows_as_phase() {
    struct Slow;
    impl Contestant for Slow {
        fn about(&self) -> About {
            About { name: "slow", group: Group::Neither, knob: Knob::Steps }
        }
        fn run(&self, story: &Story, _: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
            let omega = story.system.omega(&story.start.momentum);
            let exact = FreeMotion::new((*story.system.moments()).try_into()?, &omega)?;
            let mut motion = story.start;
            let observer = observer.unwrap();
            for k in 1..=10_000_u32 {
                let t = story.end * f64::from(k) / 1e4;
                let there = exact.at(t * (1.0 - 1e-6))?;
                motion = State {
                    attitude: there.attitude.into_inner(),
                    momentum: story.system.momentum(&there.omega),
                };
                observer.observe(t, &motion);
            }
            Ok(Ended { motion, steps: 10_000, seconds: None })
        }
    }
    let stories = story::all().unwrap();
    let mut observer = Observer::new(&stories[0]);
    let ended = Slow.run(&stories[0], Setting::None, Some(&mut observer));
    let (outcome, errors) = observer.judge(ended.as_ref());
    assert_eq!(outcome, Outcome::Right);
    let flips = stories[0].truth.flips.unwrap();
    let expected = 1e-6 * flips.last / flips.apart;
    assert!((errors.phase.unwrap() / expected - 1.0).abs() < 1e-3, "{errors:?}");
    assert!(errors.energy.unwrap() < 1e-13 && errors.direction.unwrap() < 1e-13, "{errors:?}");
}

/// A drift of the energy that is always to one side has slope one.
#[test]
fn the_classical_method_loses_energy_along_a_line() {
    let rows = long::run(Method::RungeKutta4, SMALL);
    let slope = long::slope(&rows, 30, |row| row.mean).unwrap();
    assert!((slope - 1.0).abs() < 0.1, "{slope}");
}

#[test]
fn the_exact_motion_is_asked_once_and_comes_within_rounding() {
    let rows = measured(Exact, "box");
    let [row] = rows.as_slice() else { panic!("{rows:?}") };
    assert!(row.right());
    assert!(row.attitude.unwrap() < 1e-11, "{row:?}");
}

/// The committed record can be read, is whole, and came of a full run of a build for release.
#[test]
fn the_committed_record_is_one_for_the_record() {
    let (work, long) = (record::work().unwrap(), record::long().unwrap());
    for (key, wanted) in [("effort", "full"), ("compiler", "release"), ("peers", "rapier3d-f64")] {
        assert!(work.said(key).is_some_and(|said| said.contains(wanted)), "{key}: {:?}", work.said(key));
        assert!(long.said(key).is_some_and(|said| said.contains(wanted)), "{key}: {:?}", long.said(key));
    }
    let has = |story: &Story, name: &str| {
        work.rows.iter().any(|row| row.story == story.name && row.contestant == name)
    };
    for contestant in ours() {
        let stories = story::all().unwrap();
        let measured =
            stories.iter().filter(|story| contestant.takes(story)).map(|s| has(s, contestant.about().name));
        let measured: Vec<bool> = measured.collect();
        // A method newer than the record is in none of it.
        assert!(
            measured.iter().all(|&has| has) || !measured.contains(&true),
            "{}: {measured:?}",
            contestant.about().name
        );
    }
    assert!(verdict::contestants(&work.rows).iter().filter(|(_, group)| *group == Group::Peer).count() == 5);
}

/// All of it in one go, as short as it can be: the files read back, and the windows of long runs double.
#[test]
fn what_a_campaign_writes_reads_back() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("campaign");
    let contestants: [Box<dyn Contestant>; 3] =
        [Box::new(Exact), Box::new(Ours(Method::MoserVeselov8)), Box::new(Ours(Method::RungeKutta4))];
    let effort = Effort { repeats: 1, seconds: 1e-4, turns: 5, starts: 2, long: 60.0 };
    let said = campaign::write(&contestants, effort, &["one 1.2".into()], &folder, &mut |_| ()).unwrap();
    assert!(said.contains("The box after 100 flips"), "{said}");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let work = Record::<Work>::read(&read("work.csv")).unwrap();
    assert_eq!((work.said("peers"), work.said("effort")), (Some("one 1.2"), Some("less than full")));
    assert!(work.rows.iter().any(|row| row.contestant == "exact motion" && row.right()));
    let long = Record::<Long>::read(&read("long.csv")).unwrap().rows;
    assert_eq!(long.iter().map(|row| row.turns).collect::<Vec<_>>(), [1, 2, 4, 5, 1, 2, 4, 5]);
    assert!(long.iter().all(|row| row.right() && row.mean < 1e-3 && row.mean <= row.largest), "{long:?}");
}
