//! The code of the chapters, run by `cargo test`: one module for each chapter, in the order of the
//! book. A chapter's code may use `tumbling` and `nalgebra`, and the crates of proofs and measurements.
//!
//! Edition 2024 lets rustdoc build all of it as one program; a block fenced `rust,standalone_crate`
//! gets one of its own. One chapter alone: `cargo test -p tumbling-book --doc two_arrows`.

#[cfg(doctest)]
#[doc = include_str!("introduction.md")]
mod introduction {}

#[cfg(doctest)]
#[doc = include_str!("toss-a-book.md")]
mod toss_a_book {}

#[cfg(doctest)]
#[doc = include_str!("matrix-mass.md")]
mod matrix_mass {}

#[cfg(doctest)]
#[doc = include_str!("principal-axes.md")]
mod principal_axes {}

#[cfg(doctest)]
#[doc = include_str!("two-arrows.md")]
mod two_arrows {}

#[cfg(doctest)]
#[doc = include_str!("worked-example.md")]
mod worked_example {}

#[cfg(doctest)]
#[doc = include_str!("body-and-world.md")]
mod body_and_world {}

#[cfg(doctest)]
#[doc = include_str!("eulers-equations.md")]
mod eulers_equations {}

#[cfg(doctest)]
#[doc = include_str!("three-pitfalls.md")]
mod three_pitfalls {}

#[cfg(doctest)]
#[doc = include_str!("dzhanibekov.md")]
mod dzhanibekov {}

#[cfg(doctest)]
#[doc = include_str!("coin.md")]
mod coin {}

#[cfg(doctest)]
#[doc = include_str!("exact-motion.md")]
mod exact_motion {}

#[cfg(doctest)]
#[doc = include_str!("closed-form.md")]
mod closed_form {}

#[cfg(doctest)]
#[doc = include_str!("a-top.md")]
mod a_top {}

#[cfg(doctest)]
#[doc = include_str!("stepping-through-time.md")]
mod stepping_through_time {}

#[cfg(doctest)]
#[doc = include_str!("error-against-run-time.md")]
mod error_against_run_time {}

#[cfg(doctest)]
#[doc = include_str!("only-what-you-need.md")]
mod only_what_you_need {}

#[cfg(doctest)]
#[doc = include_str!("where-things-break.md")]
mod where_things_break {}

#[cfg(doctest)]
#[doc = include_str!("test-your-engine.md")]
mod test_your_engine {}

#[cfg(doctest)]
#[doc = include_str!("put-it-into-your-engine.md")]
mod put_it_into_your_engine {}

#[cfg(doctest)]
#[doc = include_str!("proofs.md")]
mod proofs {}

#[cfg(doctest)]
#[doc = include_str!("problems.md")]
mod problems {}

#[cfg(doctest)]
#[doc = include_str!("for-teachers.md")]
mod for_teachers {}

#[cfg(doctest)]
#[doc = include_str!("where-next.md")]
mod where_next {}

#[cfg(doctest)]
#[doc = include_str!("your-own-body.md")]
mod your_own_body {}

#[cfg(doctest)]
#[doc = include_str!("about.md")]
mod about {}

#[cfg(doctest)]
#[doc = include_str!("library.md")]
mod library {}

#[cfg(doctest)]
#[doc = include_str!("records.md")]
mod records {}

#[cfg(doctest)]
#[doc = include_str!("notation.md")]
mod notation {}

#[cfg(doctest)]
#[doc = include_str!("errata.md")]
mod errata {}

#[cfg(doctest)]
#[doc = include_str!("references.md")]
mod references {}

#[cfg(doctest)]
#[doc = include_str!("glossary.md")]
mod glossary {}

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
        let tested = between(modules, "#[doc = include_str!(\"", "\")]");
        assert_eq!(read, tested, "left: SUMMARY.md, right: chapters/lib.rs");

        let names: Vec<&str> =
            modules.lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(" {}")).collect();
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
