//! Lists the proofs with the time each takes, and what their altered laws leave over.
//!
//! `cargo run --example proofs [-- [mutants] [NAME ...]]`; with `widths` or `errors` alone, the table of
//! enclosures or those of the bounds of rounding errors and of the measured ones.

use std::time::Instant;
use tumbling_proofs::interval::{forward, motion};
use tumbling_proofs::proofs;

fn main() {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    if names == ["widths"] {
        motion::table().iter().flatten().for_each(|row| println!("{row}"));
        return;
    }
    if names == ["errors"] {
        forward::table().iter().flatten().for_each(|row| println!("{row}"));
        forward::measured().iter().flatten().for_each(|row| println!("{row}"));
        return;
    }
    let with_mutants = names.iter().any(|name| name == "mutants");
    names.retain(|name| name != "mutants");
    let start = Instant::now();
    let (mut count, mut held) = (0, 0);
    let meant = |name: &str| names.is_empty() || names.iter().any(|word| word == name);
    for proof in proofs().iter().filter(|proof| meant(proof.name)) {
        let begin = Instant::now();
        let outcome = proof.check();
        let time = begin.elapsed();
        count += 1;
        held += usize::from(outcome.is_ok());
        let verdict = outcome.map_or_else(|residue| format!("FAILS: {residue}"), |()| "holds".to_owned());
        println!(
            "{:>8.3} s  {:?}, {}: {verdict}. {}",
            time.as_secs_f64(),
            proof.kind,
            proof.name,
            proof.statement
        );
        if with_mutants {
            for mutant in proof.mutants {
                let left = (mutant.check)()
                    .map_or_else(|residue| residue.to_string(), |()| "STILL HOLDS".to_owned());
                println!("            with {}: {left}", mutant.change);
            }
        }
    }
    println!("{:>8.3} s  {held} of {count} hold", start.elapsed().as_secs_f64());
}
