//! The position stage in C has the bits of the one in Rust. Without a C compiler the test says so and checks
//! nothing.

use nalgebra::{Quaternion, Vector3};
use num_traits::Float;
use std::path::Path;
use std::process::Command;
use tumbling::number::Field;
use tumbling::step::PositionStage;

const STEPS: u32 = 100_000;

trait Real: Field + Float + From<f32> {
    const NAME: &str;
    fn bits(self) -> u64;
}

impl Real for f32 {
    const NAME: &str = "float";
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Real for f64 {
    const NAME: &str = "double";
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

struct Seed(u64);

impl Seed {
    /// From 0 to 1, with 24 bits.
    fn number<T: Real>(&mut self) -> T {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        <T as From<f32>>::from((self.0 >> 40) as f32 / 16_777_216.0)
    }
}

/// The steps of `crates/c/compare.c`, and the sum of their bits.
fn sum<T: Real>() -> u64 {
    let n = |x: f32| <T as From<f32>>::from(x);
    let mut seed = Seed(1);
    let mut sum = 14_695_981_039_346_656_037_u64;
    let mut body = PositionStage::new(&Vector3::new(n(1.0), n(1.0), n(1.0))).unwrap();
    let (mut attitude, mut omega) =
        (Quaternion::new(n(0.0), n(0.0), n(0.0), n(0.0)), Vector3::repeat(n(0.0)));
    for step in 0..STEPS {
        if step % 16 == 0 {
            let mut moments = Vector3::from_fn(|_, _| seed.number::<T>() + n(0.0625));
            if step % 64 == 16 {
                moments.y = moments.x;
            }
            if step % 64 == 32 {
                moments = Vector3::new(n(0.0), n(1.0), n(1.0));
            }
            let mut four = || [0; 4].map(|_| seed.number::<T>());
            let [w, x, y, z] = four().map(|x| x - n(0.5));
            body = PositionStage::new(&moments).unwrap();
            if step % 32 == 0 {
                body = body.in_frame(Quaternion::new(w, x, y, z));
            }
            let [w, x, y, z] = four().map(|x| x + n(0.0625));
            attitude = Quaternion::new(w, x, y, z);
            omega = Vector3::from_fn(|_, _| n(16.0) * seed.number::<T>() - n(8.0));
        }
        let size = seed.number::<T>();
        let h = size * size * size * size / n(4.0) - n(0.0078125);
        let end = body.step(&attitude, &omega, h);
        sum = sum.wrapping_add(u64::from(end.parts));
        (attitude, omega) = (end.attitude, end.omega);
        let q = attitude.coords;
        for x in [q.w, q.x, q.y, q.z, omega.x, omega.y, omega.z] {
            sum = (sum ^ x.bits()).wrapping_mul(1_099_511_628_211);
        }
        let axis = step as usize % 3;
        omega[axis] = omega[axis] * n(0.9375) + seed.number::<T>() - n(0.5);
    }
    sum
}

fn in_c<T: Real>(compiler: &str, folder: &Path, expected: u64) {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/c/compare.c");
    let program = folder.join(format!("{compiler}-{}", T::NAME));
    let output = Command::new(compiler)
        .args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off"])
        .arg(format!("-DTUMBLING_REAL={}", T::NAME))
        .args([sources.as_os_str(), "-o".as_ref(), program.as_os_str(), "-lm".as_ref()])
        .output()
        .unwrap();
    assert!(output.status.success(), "{compiler}: {}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).arg(STEPS.to_string()).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), format!("{expected:016x}"), "{compiler}");
}

#[test]
fn the_header_in_c_has_the_bits_of_the_library() {
    let found = |compiler: &&str| Command::new(compiler).arg("--version").output().is_ok();
    let compilers: Vec<&str> = ["gcc", "clang"].into_iter().filter(found).collect();
    if compilers.is_empty() {
        eprintln!("neither gcc nor clang is installed: the header in C was NOT compared");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (single, double) = (sum::<f32>(), sum::<f64>());
    for compiler in compilers {
        in_c::<f32>(compiler, folder.path(), single);
        in_c::<f64>(compiler, folder.path(), double);
    }
}
