//! The position stage in C has the same bits as the one in Rust, compiles without warnings in C and C++,
//! refuses moments that no body has, and rejects compiler options that break it. Without a C compiler the
//! tests report this and check nothing.

use nalgebra::{Quaternion, Vector3};
use num_traits::Float;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;
use tumbling::number::Field;
use tumbling::step::PositionStage;

const STEPS: u32 = 100_000;

trait Real: Field + Float + From<f32> {
    /// The option that makes the programs take this precision.
    const OPTION: &str;
    fn bits(self) -> u64;
}

impl Real for f32 {
    const OPTION: &str = "-DSINGLE";
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Real for f64 {
    const OPTION: &str = "-DDOUBLE";
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

/// The steps of `compare.c`, and the sum of their bits.
fn sum<T: Real>() -> String {
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
            let inverse = step % 48 == 0;
            body = if inverse { PositionStage::of_inverse } else { PositionStage::new }(&moments).unwrap();
            if step % 32 == 0 {
                body = body.in_frame(Quaternion::new(w, x, y, z)).unwrap();
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
    format!("{sum:016x}")
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn header() -> PathBuf {
    root().join("examples/engines/c/position_stage.h")
}

/// Those of the two that are installed.
fn compilers() -> Vec<&'static str> {
    let found = |compiler: &&str| Command::new(compiler).arg("--version").output().is_ok();
    let compilers: Vec<&str> = ["gcc", "clang"].into_iter().filter(found).collect();
    if compilers.is_empty() {
        eprintln!("neither gcc nor clang is installed: the header in C was NOT tried");
    }
    compilers
}

fn words(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text)).concat()
}

/// The compiler's messages for a program that is given as text, which it preprocesses (`-E`) or reads too.
fn of_text(compiler: &str, as_far_as: &str, options: &[&str], program: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("program.c");
    std::fs::write(&source, program).unwrap();
    Command::new(compiler)
        .arg(as_far_as)
        .args(options)
        .arg("-I")
        .args([header().parent().unwrap(), &source])
        .output()
        .unwrap()
}

/// The output of a program for `examples/engines/c`, which must compile without warnings and succeed.
fn printed(compiler: &str, options: &[&str], source: &Path) -> String {
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("program");
    let compiled = Command::new(compiler)
        .args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"])
        .args(options)
        .arg("-I")
        .arg(header().parent().unwrap())
        .args([source.as_os_str(), "-o".as_ref(), program.as_os_str(), "-lm".as_ref()])
        .output()
        .unwrap();
    assert!(compiled.status.success(), "{compiler} {options:?}: {}", words(&compiled));
    let output = Command::new(&program).arg(STEPS.to_string()).output().unwrap();
    assert!(output.status.success(), "{compiler} {options:?}: {}", words(&output));
    words(&output).trim().to_owned()
}

/// Two programs of the folder as one, since the header takes the compiler longer than either of them.
const BOTH: &str = r#"
#define main extremes
#include "extremes.c"
#undef main
#define main compare
#include "compare.c"
#undef main
int main(int count, char **words) {
    return extremes() + compare(count, words);
}
"#;

/// And bodies at the ends of the range step as in their own scale, or are refused.
#[test]
fn the_header_in_c_has_the_bits_of_the_library() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("both.c");
    std::fs::write(&source, BOTH).unwrap();
    for (option, sum) in [(f32::OPTION, &sum::<f32>()), (f64::OPTION, &*DOUBLE)] {
        for compiler in compilers() {
            assert_eq!(printed(compiler, &["-ffp-contract=off", option], &source), *sum, "{compiler}");
        }
    }
}

/// The sum of the library's steps in double precision, which two tests compare with.
static DOUBLE: LazyLock<String> = LazyLock::new(sum::<f64>);

/// What gcc refuses by its macros, clang for x86 takes back over the functions of the header.
#[cfg(target_arch = "x86_64")]
#[test]
fn options_for_other_bits_have_no_effect_in_clang() {
    let compare = header().with_file_name("compare.c");
    // The first has in it those for associative and reciprocal arithmetic, zeros without signs, and functions
    // that only come near.
    for option in ["-funsafe-math-optimizations", "-fno-honor-nans", "-fno-honor-infinities"] {
        if compilers().contains(&"clang") && std::arch::is_x86_feature_detected!("fma") {
            assert_eq!(printed("clang", &["-mfma", option], &compare), *DOUBLE, "{option}");
        }
    }
}

#[test]
fn options_that_take_away_what_tells_a_number_from_none_do_not_compile() {
    let program = "#include \"position_stage.h\"\nint main(void) { return 0; }\n";
    for compiler in compilers() {
        let fast: &[&[&str]] = &[&["-ffast-math"], &["-Ofast"], &["-ffinite-math-only"]];
        let other_bits: &[&[&str]] = &[
            &["-funsafe-math-optimizations"],
            &["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"],
            &["-freciprocal-math"],
            &["-fno-signed-zeros"],
            &["-std=c99", "-ffp-contract=fast"],
        ];
        let refused = if compiler == "gcc" { [fast, other_bits].concat() } else { fast.to_vec() };
        for options in refused {
            let answer = of_text(compiler, "-E", options, program);
            assert!(!answer.status.success(), "{compiler} takes {options:?}");
            assert!(words(&answer).contains("#error") || words(&answer).contains("compile without"));
        }
        // That `-O2` is taken, the other tests show.
        let harmless = ["-O3", "-fno-math-errno", "-fno-trapping-math"];
        let answer = of_text(compiler, "-fsyntax-only", &harmless, program);
        assert!(answer.status.success(), "{compiler}: {}", words(&answer));
        let old = of_text(compiler, "-E", &["-DTUMBLING_REAL=float"], program);
        assert!(words(&old).contains("define TUMBLING_FLOAT"), "{}", words(&old));
    }
}

/// Every function in both precisions in one program, with arrays that are constant and arrays that are not.
const EVERY_CALL: &str = r#"
#define TUMBLING_FLOAT
#include "position_stage.h"
#include "position_stage.h"
#include "position_stage.h"
#define CALLED(name, real) \
    static int name##_called(void) { \
        real tensor[3][3] = {{2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, moments[3], frame[4]; \
        const real constant[3][3] = {{2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, inverse[3] = {1, 2, 0}; \
        name##_body body; \
        name##_state state = {{1, 0, 0, 0}, {1, 2, 3}}; \
        int done = name##_principal(tensor, moments, frame) + name##_principal(constant, moments, frame); \
        done += name##_of_inverse(&body, inverse, 0) + name##_prepare(&body, moments, frame); \
        return done + (name##_step(&body, &state, (real)0.01) > 0); \
    }
CALLED(tumbling, double)
CALLED(tumblingf, float)
int main(void) {
    return tumbling_called() + tumblingf_called() == 10 ? 0 : 1;
}
"#;

#[test]
fn the_header_compiles_without_a_warning_in_every_c_and_cpp() {
    let warnings = "-Wall -Wextra -pedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow";
    let strict: Vec<_> = warnings.split(' ').chain(["-Werror"]).collect();
    for compiler in compilers() {
        for standard in ["c99", "c2x", "c++11", "c++20"] {
            let language = if standard.contains('+') { "c++" } else { "c" };
            let standard = format!("-std={standard}");
            let options = [&strict[..], &["-x", language, &standard]].concat();
            let answer = of_text(compiler, "-fsyntax-only", &options, EVERY_CALL);
            assert!(answer.status.success(), "{compiler} {standard}: {}", words(&answer));
        }
    }
}

#[test]
fn the_header_names_its_version_its_home_and_its_licence() {
    let header = std::fs::read_to_string(header()).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    assert!(header.contains(&format!("\n   Version: {version}\n")));
    assert!(header.contains(&format!("#define TUMBLING_POSITION_STAGE_VERSION \"{version}\"\n")));
    let one_file = std::fs::read_to_string(root().join("examples/engines/position_stage.rs")).unwrap();
    assert!(one_file.contains(&format!("\n//! Version: {version}\n")));
    let manifest = include_str!("../../Cargo.toml");
    let home = manifest.split_once("\nrepository = \"").and_then(|(_, rest)| rest.split('"').next());
    let home = home.unwrap_or("not yet published");
    let licence = std::fs::read_to_string(root().join("LICENSE-MIT")).unwrap();
    for (text, margin) in [(header, "   "), (one_file, "//! ")] {
        assert!(text.contains(&format!("{margin}Home: {home}\n")), "{home}");
        for line in licence.lines() {
            assert!(text.contains(format!("\n{margin}{line}").trim_end()), "{line}");
        }
    }
}

/// The program in the chapter prints the output that the chapter shows.
#[test]
fn the_program_of_the_chapter_counts_the_flips_that_it_says() {
    let chapter = std::fs::read_to_string(root().join("book/chapters/put-it-into-your-engine.md")).unwrap();
    let program = chapter.split("```text\n").find(|block| block.starts_with("#include")).unwrap();
    let program = program.split("```").next().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("flips.c");
    std::fs::write(&source, program).unwrap();
    let single = program.replace("#include \"pos", "#define TUMBLING_FLOAT\n#include \"pos");
    let single = single.replace("tumbling_", "tumblingf_").replace("double", "float");
    let in_single = folder.path().join("flips_in_single.c");
    std::fs::write(&in_single, single).unwrap();
    for compiler in compilers() {
        // With and without a fused multiply-add, where the processor has one.
        let options: &[&[&str]] = match compiler {
            "gcc" if cfg!(target_arch = "x86_64") => &[&["-ffp-contract=off"], &["-O3", "-march=native"]],
            _ => &[&["-O2"]],
        };
        for options in options {
            for source in [&source, &in_single] {
                assert_eq!(printed(compiler, options, source), "281 flips", "{compiler} {options:?}");
            }
        }
    }
    assert!(chapter.contains("It prints 281 flips. For single precision put `#define TUMBLING_FLOAT` above"));
}
