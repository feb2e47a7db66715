//! Writing what the proofs claim as theorems for Coq.

use crate::say;
use crate::site::files::write_changed;
use crate::site::paths;
use std::fmt::Write as _;
use std::path::PathBuf;
use tumbling_proofs::Certificate;

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The folder that they are written into, in place of crates/proofs/coq/certificates
    #[arg(long)]
    out: Option<PathBuf>,
}

/// Makes the certificates and writes them.
///
/// # Errors
/// A claim without a theorem; a file that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let certificates = tumbling_proofs::certificates();
    let missing: Vec<_> = certificates.iter().flat_map(|c| &c.missing).map(String::as_str).collect();
    if !missing.is_empty() {
        return Err(format!("no theorem can be written for:\n  {}", missing.join("\n  ")));
    }
    let folder =
        arguments.out.clone().unwrap_or_else(|| paths::repository().join("crates/proofs/coq/certificates"));
    for c in &certificates {
        write_changed(&folder.join(format!("{}.v", c.part)), c.text.as_bytes())?;
    }
    say!("{}", table(&certificates));
    Ok(())
}

/// What Coq is to check, as a table, and which proofs have no theorem.
fn table(certificates: &[Certificate]) -> String {
    let mut text = String::from(
        "A theorem is a claim about letters that holds for all numbers; a counterexample is numbers, those of a body where \
         there is one, for which a claim fails that must fail; a mutant is refuted by a counterexample to it, or by a \
         theorem that says the opposite. Claims of numbers alone, and of the same on both sides, are not made.\n\n\
         | File | Proofs | Theorems | Counterexamples | Mutants refuted |\n|---|---|---|---|---|\n",
    );
    let mut all = [0; 4];
    for c in certificates {
        let row = [c.proofs.len(), c.theorems, c.counterexamples, c.mutants];
        let _ = writeln!(text, "| `{}.v` | {} | {} | {} | {} |", c.part, row[0], row[1], row[2], row[3]);
        all.iter_mut().zip(row).for_each(|(sum, n)| *sum += n);
    }
    let _ = writeln!(text, "| all | {} | {} | {} | {} |", all[0], all[1], all[2], all[3]);
    let without: Vec<_> = certificates.iter().flat_map(|c| &c.without).copied().collect();
    let _ = write!(text, "\n{} proofs have no theorem: {}.", without.len(), without.join(", "));
    text
}
