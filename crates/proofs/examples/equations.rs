//! Lists the book's equations, how each is settled, and what became of altered copies.
//!
//! `cargo run --release -p tumbling-proofs --example equations [-- all]`

#[path = "../tests/chapters/mod.rs"]
mod chapters;

use std::time::Instant;
use tumbling_proofs::equations::{alterations, missing_chapters, read_chapter};

fn main() {
    let show_all = std::env::args().any(|argument| argument == "all");
    let chapters = chapters::chapters();
    let names: Vec<_> = chapters.iter().map(|(name, _)| name.as_str()).collect();
    println!("chapters missing: {:?}", missing_chapters(&names));
    let start = Instant::now();
    for (name, equations) in &chapters {
        let found = read_chapter(name, equations);
        for settled in &found.proven {
            println!("{name}:{}: proven: {}\n    {}", settled.line, settled.tex, settled.why);
        }
        for settled in &found.exempt {
            println!("{name}:{}: exempt: {}\n    {}", settled.line, settled.tex, settled.why);
        }
        for settled in &found.notation {
            println!("{name}:{}: notation: {}\n    {}", settled.line, settled.tex, settled.why);
        }
        for settled in &found.values {
            println!("{name}:{}: values: {}", settled.line, settled.tex);
        }
        for fault in &found.faults {
            println!("{name}: FAULT: {fault}");
        }
    }
    println!("read in {:.3} s\n", start.elapsed().as_secs_f64());
    let start = Instant::now();
    println!("{:>8} {:>8} {:>10}  chapter", "made", "noticed", "still true");
    for (name, equations) in &chapters {
        let table = alterations(name, equations);
        if table.made > 0 {
            println!("{:>8} {:>8} {:>10}  {name}", table.made, table.noticed, table.still_true.len());
        }
        if show_all {
            for true_too in &table.still_true {
                println!(
                    "    line {}: {}: {}",
                    true_too.line,
                    true_too.change,
                    true_too.tex.replace('\n', " ")
                );
            }
        }
    }
    println!("altered in {:.3} s", start.elapsed().as_secs_f64());
}
