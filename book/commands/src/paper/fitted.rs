//! Sheets in the loosest layout that does not need more pages.

use super::sheet::{Size, chapter};
use super::{NO_BROWSER, Paper, browser, handout, mended, numbers, problems, write};
use std::fmt::Write as _;
use std::path::Path;
use tumbling_site::draw::each_made;
use tumbling_site::files::write_changed;
use tumbling_site::say;

/// A layout: how tight the sheet is, `fit-N` in `print.css`, and how many copies of its repeatable parts it
/// has: three lines to write on, or the answers, of which a page to be cut apart has several.
pub(super) type Setting = [usize; 2];

/// The number of layouts, from the loosest to the tightest.
const FITS: usize = 8;

/// The tightest layout of answers if several copies share a page: their letters are not smaller than the
/// book's.
const CLOSE: usize = 4;

/// The sheets of these kinds (`handout`, `problems`, `answers`) of these chapters, or of every one, as HTML,
/// and as PDF where a browser is found.
///
/// # Errors
/// There is no such chapter, or a sheet that cannot be made, printed or written.
pub(super) fn print(
    paper: &Paper,
    chapters: &[String],
    kinds: &[&str],
    size: Size,
    folder: &Path,
) -> Result<(), String> {
    let named: Result<Vec<_>, String> = chapters.iter().map(|name| chapter(paper, name)).collect();
    let pages = if chapters.is_empty() { paper.chapters().collect() } else { named? };
    let sheets: Vec<_> = pages.iter().flat_map(|page| kinds.iter().map(|kind| (&page.name, *kind))).collect();
    let make = |at: usize, setting: Setting| match sheets[at] {
        (name, "handout") => handout::sheet(paper, name, size, setting),
        (name, kind) => problems::sheet(paper, name, size, setting, kind == "answers"),
    };
    let file = |at: usize, ending| folder.join(format!("{}-{}.{ending}", sheets[at].0, sheets[at].1));
    // First the files that can be printed by hand, in case the browser fails.
    for at in 0..sheets.len() {
        write(&file(at, "html"), make(at, [FITS / 2, 0])?.as_bytes())?;
    }
    let Some(browser) = browser::found() else {
        say!("{NO_BROWSER}");
        return Ok(());
    };
    say!("To print as PDF: {} ...", sheets.len());
    let best = |tried: Vec<Vec<Setting>>| chosen(&browser, &tried, &make);
    let mut found = best(sheets.iter().map(|(_, kind)| widths(kind)).collect())?;
    for step in [5, 1].into_iter().filter(|_| kinds == ["handout"]) {
        let more = |[fit, times]: &Setting| (0..5).rev().map(|more| [*fit, times + step * more]).collect();
        found = best(found.iter().map(more).collect())?;
    }
    let printed = |at: usize| {
        write_changed(&file(at, "html"), make(at, found[at])?.as_bytes())?;
        browser::pdf(&browser, &file(at, "html"))
    };
    each_made(sheets.len(), printed, |at, pdf, _| write(&file(at, "pdf"), &mended(pdf?, &paper.about)))
}

/// The layouts of a sheet of this kind, the best first; the last needs the fewest pages.
fn widths(kind: &str) -> Vec<Setting> {
    let fits = |times: usize, most: usize| (0..most).map(move |fit| [fit, times]);
    let copies = [3, 2].into_iter().filter(|_| kind == "answers");
    copies.flat_map(|times| fits(times, CLOSE)).chain(fits(0, FITS)).collect()
}

/// The [`widest`] setting of each sheet. All are printed in one document, since starting the browser takes
/// longest.
fn chosen(
    browser: &Path,
    tried: &[Vec<Setting>],
    make: &dyn Fn(usize, Setting) -> Result<String, String>,
) -> Result<Vec<Setting>, String> {
    let settings = tried.iter().enumerate().flat_map(|(at, all)| all.iter().map(move |one| (at, *one)));
    let (mut all, mut count) = (String::new(), 0);
    for (at, setting) in settings {
        let html = make(at, setting)?;
        let [head, language, body] = parts(&html).ok_or("a sheet without a language or a body")?;
        let head = if count == 0 { head } else { "" };
        let _ = write!(all, "{head}{} lang=\"{language}\"{body}</section>", start(count));
        count += 1;
    }
    let file = tempfile::Builder::new().suffix(".html").tempfile();
    let file = file.map_err(|e| format!("no file for the browser: {e}"))?;
    write_changed(file.path(), format!("{all}{}>.</section>", start(count)).as_bytes())?;
    let places = numbers::of(&browser::pdf(browser, file.path())?);
    let unread = format!("{} printed no places that can be read: print the HTML yourself", browser.display());
    let starts = (0..=count).map(|at| places.get(&format!("trial-{at}")).copied());
    Ok(widest(tried, &starts.collect::<Option<Vec<_>>>().ok_or(unread)?))
}

/// The text before the body of a sheet, its language, and the rest up to the body's end.
fn parts(html: &str) -> Option<[&str; 3]> {
    let (head, body) = html.split_once("<body")?;
    let (_, language) = head.split_once("<html lang=\"")?;
    Some([head, language.split_once('"')?.0, body.rsplit_once("</body>")?.0])
}

/// For each sheet, the first of its layouts that needs no more pages than the last. `starts` has the pages on
/// which all layouts begin, one after the other, and the page after the last.
fn widest(tried: &[Vec<Setting>], starts: &[usize]) -> Vec<Setting> {
    let mut pages = starts.windows(2).map(|pair| pair[1].abs_diff(pair[0]));
    let first = tried.iter().filter_map(|settings| {
        let own: Vec<_> = settings.iter().zip(pages.by_ref()).collect();
        own.iter().find(|(_, count)| *count <= own[own.len() - 1].1).map(|(setting, _)| **setting)
    });
    first.collect()
}

/// The start of a section on a page of its own. The browser reports only the pages of places with a link to
/// them.
fn start(at: usize) -> String {
    format!("<a href=\"#trial-{at}\"></a><section id=\"trial-{at}\" style=\"break-before: page\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sheet of two pages set widely and of one set closer, and one that needs two in any setting.
    #[test]
    fn each_sheet_is_set_as_widely_as_its_fewest_pages_allow() {
        let tried = [vec![[0, 3], [1, 3], [0, 0]], vec![[2, 0], [3, 0]]];
        assert_eq!(widest(&tried, &[1, 3, 4, 5, 7, 9]), [[1, 3], [2, 0]]);
        // Answers stand three times on a page before twice or once, and only then so closely as problems.
        let answers = widths("answers");
        assert_eq!([answers[0], answers[CLOSE], answers[2 * CLOSE]], [[0, 3], [0, 2], [0, 0]]);
        assert_eq!(answers[2 * CLOSE..], widths("problems"));
        let german = "<html lang=\"de\">\n<body class=\"a\">b</body>";
        assert_eq!(parts(german).map(|[_, own, body]| [own, body]), Some(["de", " class=\"a\">b"]));
        assert_eq!([parts("<body></body>"), parts("<html lang=\"de\">")], [None, None]);
    }
}
