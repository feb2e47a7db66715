//! Records made for the judge.

pub mod invented;
pub mod record;

use nalgebra::{Quaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State, System};
use tumbling_judge::{Options, Verdict, judge};

pub const SPINS: [[f64; 3]; 4] = [[0.1, 3.0, 0.2], [4.0, 0.5, -0.6], [0.3, -0.4, 5.0], [1.0, 2.0, 1.5]];
pub const MOMENTS: Vector3<f64> = Vector3::new(1.0, 2.0, 2.5);

/// A time, an attitude (body to world) and a spin (body axes).
pub type Row = (f64, Quaternion<f64>, Vector3<f64>);

/// The exact motion, from an attitude that is not the identity.
pub fn exact(omega: Vector3<f64>, h: f64, count: u32) -> Vec<Row> {
    let start = nalgebra::UnitQuaternion::from_euler_angles(0.4, -0.3, 1.1).into_inner();
    let rows = exact_of(MOMENTS.into(), omega, h, count).into_iter();
    rows.map(|(t, q, omega)| (t, start * q, omega)).collect()
}

/// The exact motion of any moments.
pub fn exact_of(moments: [f64; 3], omega: Vector3<f64>, h: f64, count: u32) -> Vec<Row> {
    let motion = FreeMotion::new(Vector3::from(moments).try_into().unwrap(), &omega).unwrap();
    let row = |i| {
        let t = h * f64::from(i);
        let now = motion.at(t).unwrap();
        (t, now.attitude.into_inner(), now.omega)
    };
    (0..=count).map(row).collect()
}

/// A run of a method.
pub fn stepped(method: Method, omega: Vector3<f64>, h: f64, count: u32) -> Vec<Row> {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    stepped_by(omega, h, count, |motion| method.step(&system, motion, h).unwrap())
}

/// A run of any rule for attitude and momentum in body axes.
pub fn stepped_by(
    omega: Vector3<f64>,
    h: f64,
    count: u32,
    step: impl Fn(&State<f64>) -> State<f64>,
) -> Vec<Row> {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let mut motion = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let mut rows = Vec::new();
    for i in 0..=count {
        rows.push((h * f64::from(i), motion.attitude, system.omega(&motion.momentum)));
        motion = step(&motion);
    }
    rows
}

/// A number with 17 significant digits.
fn number(x: f64) -> String {
    format!("{x:.16e}")
}

pub fn csv(rows: &[Row]) -> String {
    written("# inertia: 1 2 2.5 kg m2", rows, number, number)
}

/// Rows below a header, times and the other numbers written so.
pub fn written(
    header: &str,
    rows: &[Row],
    time: impl Fn(f64) -> String,
    number: impl Fn(f64) -> String,
) -> String {
    let mut text = format!("{header}\nt,qw,qx,qy,qz,wx,wy,wz\n");
    for (t, q, w) in rows {
        let numbers = [q.w, q.i, q.j, q.k, w.x, w.y, w.z].map(&number);
        text += &format!("{},{}\n", time(*t), numbers.join(","));
    }
    text
}

/// Spins alone, with all their digits, below a header.
pub fn spins(header: &str, rows: impl IntoIterator<Item = (f64, Vector3<f64>)>) -> String {
    let row = |(t, w): (f64, Vector3<f64>)| format!("{t:e},{:e},{:e},{:e}\n", w.x, w.y, w.z);
    format!("{header}\nt,wx,wy,wz\n{}", rows.into_iter().map(row).collect::<String>())
}

pub fn judged(text: &str) -> Verdict {
    judge(text.as_bytes(), &Options::default()).unwrap()
}

/// The sentence with which a text is refused.
pub fn refused(text: impl AsRef<[u8]>) -> String {
    judge(text.as_ref(), &Options::default()).unwrap_err().to_string()
}
