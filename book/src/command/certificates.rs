//! Writing the theorems for Coq, or checking that the committed ones are what would be written.

use crate::say;
use crate::site::files::write_changed;
use crate::site::paths;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use tumbling_proofs::Certificate;

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// Write nothing; fail and name the committed files that are not what would be written
    #[arg(long)]
    check: bool,
}

/// Makes the certificates and writes or checks them.
///
/// # Errors
/// A claim without a theorem; a file that cannot be written or, with `--check`, is not what it should be.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let certificates = tumbling_proofs::certificates();
    let missing: Vec<_> = certificates.iter().flat_map(|c| &c.missing).map(String::as_str).collect();
    if !missing.is_empty() {
        return Err(format!("no theorem can be written for:\n  {}", missing.join("\n  ")));
    }
    let table = table(&certificates);
    let mut files: Vec<_> = certificates.into_iter().map(|c| (format!("{}.v", c.part), c.text)).collect();
    files.push(("README.md".to_owned(), table.clone()));
    let folder = paths::certificates();
    if arguments.check {
        check(&files, &folder)?;
        say!("All {} files of theorems are as committed.", files.len());
        return Ok(());
    }
    for (name, text) in &files {
        write_changed(&folder.join(name), text.as_bytes())?;
    }
    say!("{table}");
    Ok(())
}

/// That the folder holds these files and no other.
fn check(files: &[(String, String)], folder: &Path) -> Result<(), String> {
    let mut wrong: Vec<String> = Vec::new();
    for (name, text) in files {
        if fs::read_to_string(folder.join(name)).ok().as_ref() != Some(text) {
            wrong.push(format!("{name} is not what would be written"));
        }
    }
    let entries = fs::read_dir(folder).map_err(|e| format!("cannot read {}: {e}", folder.display()))?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    wrong.extend(
        names
            .filter(|name| files.iter().all(|(file, _)| file != name))
            .map(|name| format!("{name} belongs to nothing")),
    );
    if wrong.is_empty() {
        return Ok(());
    }
    wrong.sort();
    Err(format!("in {} (`cargo run -- certificates` renews it):\n  {}", folder.display(), wrong.join("\n  ")))
}

/// What is checked, as a table, and which proofs have no theorem.
fn table(certificates: &[Certificate]) -> String {
    let mut text = String::from(
        "# What Coq checks of the proofs\n\n\
         Made by `cargo run -- certificates`. A theorem is a claim that holds for all numbers; a counterexample is \
         numbers for which a claim fails that must fail; a mutant is refuted by a counterexample to it, or by a \
         theorem that says the opposite.\n\n\
         | File | Proofs | Theorems | Counterexamples | Mutants refuted |\n|---|---|---|---|---|\n",
    );
    let mut all = [0; 4];
    for c in certificates {
        let row = [c.proofs.len(), c.theorems, c.counterexamples, c.mutants];
        let _ = writeln!(text, "| `{}.v` | {} | {} | {} | {} |", c.part, row[0], row[1], row[2], row[3]);
        all.iter_mut().zip(row).for_each(|(sum, n)| *sum += n);
    }
    let _ = writeln!(text, "| all | {} | {} | {} | {} |", all[0], all[1], all[2], all[3]);
    let without: Vec<_> = certificates.iter().flat_map(|c| &c.without).collect();
    if !without.is_empty() {
        let _ = writeln!(
            text,
            "\n{} proofs claim only equalities of numbers, those of two bodies' power series, and have no theorem:\n",
            without.len()
        );
        without.iter().for_each(|name| text += &format!("- {name}\n"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_differs_is_named_and_so_is_one_too_many() {
        let folder = tempfile::TempDir::new().unwrap();
        let files = [("a.v".to_owned(), "new".to_owned())];
        fs::write(folder.path().join("a.v"), "old").unwrap();
        fs::write(folder.path().join("b.v"), "more").unwrap();
        let wrong = check(&files, folder.path()).unwrap_err();
        assert!(wrong.contains("a.v is not what") && wrong.contains("b.v belongs to nothing"), "{wrong}");
        fs::remove_file(folder.path().join("b.v")).unwrap();
        fs::write(folder.path().join("a.v"), "new").unwrap();
        assert_eq!(check(&files, folder.path()), Ok(()));
    }
}
