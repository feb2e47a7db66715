//! The outcomes of several records, a line each: `cargo run -p tumbling-judge --example outcomes -- FILES`.

use std::fs::File;
use std::io::BufReader;
use tumbling_judge::{Options, judge};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        let verdict = judge(BufReader::new(File::open(&path)?), &Options::default())?;
        println!("{path}\t{}", verdict.outcome.key());
    }
    Ok(())
}
