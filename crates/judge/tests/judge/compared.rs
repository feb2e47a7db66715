//! One object, described to an engine in several ways: whether the records are one motion.

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::{Body, Inertia, PrincipalMoments};
use tumbling_judge::{Comparison, Error, Motion, Options, compare, fit_inertia};

/// A body whose own axes and origin lie as its description has them.
struct Description {
    /// From the described axes to the room, at the start.
    start: UnitQuaternion<f64>,
    /// From the centre of mass, in the described axes.
    origin: Vector3<f64>,
    /// By how much its tensor is turned from where it belongs, rad, and about which axis in the room.
    wrong: f64,
    about: Vector3<f64>,
    /// What a moment is multiplied by.
    heavier: f64,
    velocity: Vector3<f64>,
}

fn described(turn: [f64; 3], origin: [f64; 3]) -> Description {
    let (start, origin) = (UnitQuaternion::from_euler_angles(turn[0], turn[1], turn[2]), origin.into());
    let (about, velocity) = (Vector3::y(), Vector3::new(0.3, -0.2, 0.1));
    Description { start, origin, wrong: 0.0, about, heavier: 1.0, velocity }
}

impl Description {
    /// A record of the exact motion of one body, whose spin in the room is always the same at the start.
    fn record(&self) -> String {
        let tilt = UnitQuaternion::from_scaled_axis(self.about.normalize() * self.wrong);
        let tensor = Inertia::from_moments(1.0, 2.0, 2.6 * self.heavier).unwrap();
        let tensor = tensor.turned(self.start.inverse() * tilt).unwrap();
        let omega = self.start.inverse() * Vector3::new(0.4, 2.0, 0.3);
        let body = Body::spinning(tensor, self.start, &omega).unwrap();
        let motion = FreeMotion::of(&body).unwrap();
        let mut text = String::from("t,x,y,z,qw,qx,qy,qz,wx,wy,wz\n");
        for i in 0..600 {
            let t = f64::from(i) / 60.0;
            let now = motion.at(t).unwrap();
            let (q, w) = (now.attitude, now.omega);
            let p = self.velocity * t + q * self.origin;
            let numbers = [t, p.x, p.y, p.z, q.w, q.i, q.j, q.k, w.x, w.y, w.z].map(|x| x.to_string());
            text += &(numbers.join(",") + "\n");
        }
        text
    }
}

fn compared(all: &[Description]) -> Comparison {
    let read = |record: String| Motion::read(record.as_bytes(), &Options::default()).unwrap();
    let name = |k: usize| ["one", "fixed children", "off the origin", "turned frame"][k].to_owned();
    let all = all.iter().enumerate().map(|(k, one)| (name(k), read(one.record())));
    compare(&all.collect::<Vec<_>>(), None).unwrap()
}

fn four() -> [Description; 4] {
    [
        described([0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
        described([0.3, -1.2, 0.4], [0.0, 0.0, 0.0]),
        described([0.0, 0.0, 0.0], [0.1, -0.3, 0.2]),
        described([1.3, 0.2, -2.4], [0.5, 0.0, 0.1]),
    ]
}

#[test]
fn four_descriptions_of_one_object_are_one_motion() {
    let found = compared(&four());
    assert_eq!((found.alike.len(), found.others.len()), (4, 0), "{found}");
    assert!(found.to_string().starts_with("PASSED: one, fixed children, off the origin, turned frame are"));
}

#[test]
fn a_tensor_about_wrong_axes_is_found_with_the_angle() {
    let mut all = four();
    all[3].wrong = 0.02;
    let found = compared(&all);
    assert_eq!(found.alike.len(), 3);
    let (_, apart) = found.others[0];
    let [spin, attitude, position] = apart.off;
    assert!(spin.since.is_some() && attitude.since.is_some() && position.since.is_some(), "{found}");
    let text = found.to_string();
    assert!(text.contains("It starts the same") && text.contains("turned by 1.1°"), "{text}"); // 0.02 rad
}

/// About no principal axis each axis turns by less than the whole.
#[test]
fn the_angle_is_that_of_the_whole_turn_and_the_odd_one_may_be_the_first() {
    let mut all = four();
    (all[0].wrong, all[0].about) = (0.05, Vector3::new(1.0, 2.0, -1.0));
    let found = compared(&all);
    assert_eq!((found.reference, found.others[0].0), (1, 0), "{found}");
    let text = found.to_string();
    assert!(text.contains("turned by 2.9°") && text.contains("in the axes of fixed children"), "{text}"); // 0.05 rad
}

#[test]
fn a_wrong_moment_is_found_with_its_ratio() {
    let mut all = four();
    all[1].heavier = 1.01;
    let text = compared(&all).to_string();
    assert!(text.contains("1.0000 : 2.0000 : 2.6260") && text.contains("1.0000 : 2.0000 : 2.6000"), "{text}");
}

#[test]
fn a_centre_of_mass_elsewhere_and_a_start_otherwise_are_distinguished() {
    let mut all = four();
    all[2].velocity.x += 1e-3;
    let found = compared(&all);
    let (_, apart) = found.others[0];
    let [spin, attitude, position] = apart.off;
    assert!(spin.since.is_none() && attitude.since.is_none() && position.since.is_some(), "{found}");
    assert!(found.to_string().contains("It turns the same"), "{found}");
}

fn two(records: &[String; 2]) -> Result<Comparison, Error> {
    let read = |text: &String| Motion::read(text.as_bytes(), &Options::default()).unwrap();
    compare(&[("a".into(), read(&records[0])), ("b".into(), read(&records[1]))], None)
}

/// An origin that leaves its place after five seconds is said to do so then.
#[test]
fn a_position_that_drifts_late_is_named_with_that_time() {
    let mut texts = [0, 2].map(|k| four()[k].record());
    let drifting = texts[1].lines().map(|line| match line.split_once(',') {
        Some((t, rest)) if t.parse().is_ok_and(|t: f64| t > 5.0) => {
            let (x, rest) = rest.split_once(',').unwrap();
            format!("{t},{},{rest}\n", x.parse::<f64>().unwrap() + 0.1 * (t.parse::<f64>().unwrap() - 5.0))
        }
        _ => format!("{line}\n"),
    });
    texts[1] = drifting.collect();
    let found = two(&texts).unwrap();
    let since = found.others[0].1.off[2].since.unwrap();
    assert!((5.0..5.1).contains(&since), "{found}");
}

#[test]
fn records_of_every_other_row_are_compared_at_common_times_and_origins_are_found() {
    let mut texts = [0, 2].map(|k| four()[k].record());
    let lines = texts[1].lines().enumerate().filter(|(i, _)| i % 2 != 0 || *i == 0);
    texts[1] = lines.map(|(_, line)| format!("{line}\n")).collect();
    let found = two(&texts).unwrap();
    let apart = found.alike[1].1;
    assert_eq!((apart.rows, found.others.len()), (300, 0), "{found}");
    assert!((apart.origin.unwrap() - Vector3::new(0.1, -0.3, 0.2)).norm() < 1e-9, "{found}");
}

#[test]
fn a_record_that_cannot_be_compared_says_why() {
    let rows = |from: usize| {
        let rows = (from..from + 3).map(|i| format!("{i},1,0,0,0\n")).collect::<String>();
        format!("t,qw,qx,qy,qz\n{rows}")
    };
    let wrong = two(&[0, 5].map(rows)).unwrap_err().to_string();
    assert!(wrong.contains("a and b have fewer than two times in common"), "{wrong}");
    for (record, why) in [
        ("t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n", "by their attitudes"),
        ("t,qw,qx,qy,qz\n0,0,0,0,0\n1,1,0,0,0\n", "line 2"),
        ("t,qw,qx,qy,qz\n0,1,0,0,0\n", "one row"),
        ("t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n3,nan,0,0,0\n", "nan"),
        ("t,qw,qx,qy,qz,lx,ly,lz\n0,1,0,0,0,1,2,3\n1,1,0,0,0,1,2,3\n", "moments"),
    ] {
        let wrong = Motion::read(record.as_bytes(), &Options::default()).unwrap_err().to_string();
        assert!(wrong.contains(why), "{record}: {wrong}");
    }
}

#[test]
fn of_a_symmetric_body_the_moments_are_found_and_the_free_axes_named() {
    for (moments, alike) in [([2.0, 2.0, 3.0], [0, 1]), ([1.0, 2.5, 2.5], [1, 2])] {
        let moments = Vector3::from(moments);
        let body = PrincipalMoments::try_from(moments).unwrap();
        let motion = FreeMotion::new(body, &Vector3::new(0.5, 0.7, 1.2)).unwrap();
        let turn = UnitQuaternion::from_euler_angles(0.3, -0.5, 0.4);
        let row = |i: u32| (f64::from(i) / 50.0, turn * motion.omega(f64::from(i) / 50.0).unwrap());
        let fitted = fit_inertia(&(0..400).map(row).collect::<Vec<_>>(), None).unwrap();
        assert!((fitted.moments - moments / moments.sum()).norm() < 1e-6, "{fitted:?}");
        assert_eq!(fitted.alike, Some(alike), "{fitted:?}");
    }
}
