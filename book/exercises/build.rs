//! Makes the exercises' programs from `whole/`: the reader's doc-tests, and all blocks as functions for the
//! proof.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

#[expect(dead_code, reason = "of what the library offers, this needs the blocks alone")]
#[path = "src/exercise.rs"]
mod exercise;

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=whole");
    let folder = env::var("CARGO_MANIFEST_DIR").map_err(|e| e.to_string())?;
    let out = env::var("OUT_DIR").map_err(|e| e.to_string())?;
    let exercises = exercise::read_all(&Path::new(&folder).join("whole"))?;

    let mut mine = String::new();
    let mut runs = String::new();
    let mut list = String::from("pub const ALL: &[Run] = &[\n");
    for exercise in &exercises {
        let name = &exercise.name;
        let stub = Path::new(&folder).join(format!("stubs/{name}.md"));
        let _ = writeln!(mine, "#[doc = include_str!({stub:?})]\nmod {name} {{}}");
        let mut add = |variant: &str, what: &str, block: &str| {
            let _ = writeln!(runs, "{}", function(&format!("{name}_{variant}"), block));
            let _ = writeln!(
                list,
                "    Run {{ name: {name:?}, variant: {what:?}, run: || {name}_{variant}::run() }},"
            );
        };
        add("open", "open", &exercise.open());
        add("solved", "solved", &exercise.solved());
        for (at, wrong) in exercise.wrong.iter().enumerate() {
            add(&format!("wrong_{at}"), &format!("wrong: {}", wrong.what), &exercise.answered(wrong));
        }
    }
    list.push_str("];\n");
    for (file, text) in [("mine.rs", mine), ("runs.rs", runs + &list)] {
        let path = Path::new(&out).join(file);
        fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))?;
    }
    Ok(())
}

/// The block as rustdoc would run it.
fn function(name: &str, block: &str) -> String {
    let code: String = block
        .lines()
        .map(|line| line.strip_prefix("# ").unwrap_or(line))
        .flat_map(|line| [line, "\n"])
        .collect();
    let ends_in_result = code.trim_end().ends_with("(())");
    let (returns, finish) =
        if ends_in_result { ("-> Result<(), impl core::fmt::Debug> ", ".unwrap()") } else { ("", "") };
    format!("mod {name} {{\npub fn run() {{ inner(){finish} }}\nfn inner() {returns}{{\n{code}}}\n}}")
}
