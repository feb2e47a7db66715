//! The code of the chapters, run by `cargo test`: one module for each chapter, in the order of the
//! book. A chapter's code may use `tumbling` and `nalgebra`, and the crates of proofs and measurements.
//!
//! Edition 2024 lets rustdoc build all of it as one program; a block fenced `rust,standalone_crate`
//! gets one of its own. One chapter alone: `cargo test -p tumbling-book --doc two_arrows`.

macro_rules! chapters {
    ($($file:literal $name:ident)*) => {
        $(#[cfg(doctest)] #[doc = include_str!($file)] mod $name {})*
    };
}

chapters! {
    "introduction.md" introduction
    "toss-a-book.md" toss_a_book
    "matrix-mass.md" matrix_mass
    "principal-axes.md" principal_axes
    "two-arrows.md" two_arrows
    "worked-example.md" worked_example
    "body-and-world.md" body_and_world
    "eulers-equations.md" eulers_equations
    "why-the-middle-one.md" why_the_middle_one
    "three-pitfalls.md" three_pitfalls
    "coin.md" coin
    "dzhanibekov.md" dzhanibekov
    "a-top.md" a_top
    "where-next.md" where_next
    "your-own-body.md" your_own_body
    "exact-motion.md" exact_motion
    "stepping-through-time.md" stepping_through_time
    "error-against-run-time.md" error_against_run_time
    "proofs.md" proofs
    "where-things-break.md" where_things_break
    "test-your-engine.md" test_your_engine
    "put-it-into-your-engine.md" put_it_into_your_engine
    "problems.md" problems
    "for-teachers.md" for_teachers
    "toss-a-book-de.md" toss_a_book_de
    "appendix.md" appendix
    "closed-form.md" closed_form
    "top-closed-form.md" top_closed_form
    "library.md" library
    "only-what-you-need.md" only_what_you_need
    "records.md" records
    "errata.md" errata
    "notation.md" notation
    "glossary.md" glossary
    "references.md" references
    "about.md" about
}

/// A chapter that is not listed here is a chapter whose code nobody runs; one that `SUMMARY.md` lacks
/// is one that nobody reads.
#[cfg(test)]
mod listed {
    use std::fs;
    use std::path::Path;

    /// What stands between `before` and `after`, wherever both surround it in one line.
    fn between<'a>(text: &'a str, before: &str, after: &str) -> Vec<&'a str> {
        text.lines()
            .filter_map(|line| line.split_once(before)?.1.split_once(after))
            .map(|(inner, _)| inner)
            .collect()
    }

    #[test]
    fn summary_files_and_modules_name_the_same_chapters_in_the_same_order() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("chapters");
        let summary = fs::read_to_string(folder.join("SUMMARY.md")).unwrap();
        let modules = include_str!("lib.rs");

        let read = between(&summary, "](", ")");
        let tested = between(modules, "    \"", "\" ");
        assert_eq!(read, tested, "left: SUMMARY.md, right: chapters/lib.rs");

        let names: Vec<&str> = modules
            .lines()
            .filter_map(|line| Some(line.strip_prefix("    \"")?.split_once("\" ")?.1))
            .collect();
        let expected: Vec<String> =
            tested.iter().map(|file| file.trim_end_matches(".md").replace(['-', '/'], "_")).collect();
        assert_eq!(names, expected, "a module is named after its chapter");

        let mut files: Vec<String> = fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
            .collect();
        let mut named = read;
        files.sort();
        named.sort_unstable();
        assert_eq!(files, named, "left: the files in book/chapters, right: SUMMARY.md");
    }
}
