//! Metadata of pages for other programs: the description, the preview of a shared link, and the map of the
//! site.

use crate::files::{self, write_changed};
use crate::language::{Language, with};
use crate::places::{self, escaped};
use std::path::Path;

/// The picture shown where a page is shared, beside the pages.
const PREVIEW: &str = "preview.png";

/// The pages that are no chapters, and what they are.
const OTHERS: [(&str, &str); 3] = [
    ("404", "There is no such page in this book."),
    ("print", "The whole book on one page, for printing."),
    ("toc", "The chapters of this book."),
];

/// Where the pages will stand, with a `/` at its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Site(String);

impl Site {
    /// From an address as typed.
    ///
    /// # Errors
    /// It is no address of a site.
    pub fn parse(address: &str) -> Result<Self, String> {
        let host = address.strip_prefix("https://").or_else(|| address.strip_prefix("http://"));
        let plain = |host: &str| {
            !host.is_empty() && !host.contains(|c: char| c.is_whitespace() || "\"<>&?#".contains(c))
        };
        if !host.is_some_and(plain) {
            return Err(format!(
                "`--site` takes the address of a site, as in https://example.org/tumbling/, but got `{address}`."
            ));
        }
        Ok(Self(format!("{}/", address.trim_end_matches('/'))))
    }
}

/// Gives each page its own description and what a shared link shows; with a site's address also the full
/// addresses and `sitemap.xml`. Only what is built here has this: mdBook alone gives every page the book's
/// description.
///
/// # Errors
/// A page that cannot be read or written, or is not as expected.
pub fn tell(book: &Path, pages: &Path, site: Option<&Site>) -> Result<(), String> {
    let sentences = places::sentences(book)?;
    for (name, sentence) in OTHERS {
        rewrite(&pages.join(format!("{name}.html")), |html| with_head(&named(html), sentence, None, site))?;
    }
    let mut map = String::new();
    for (name, sentence) in &sentences {
        // The first chapter is the index as well; the index is the one to be found.
        let file = pages.join(format!("{name}.html"));
        let index = name == "introduction";
        let address = if index { String::new() } else { format!("{name}.html") };
        rewrite(&file, |html| with_head(&html, sentence, Some(&address), site))?;
        if let Some((own, original)) = Language::of(name)? {
            // Without scripts the contents are a page in a frame; this chapter's leads to itself.
            let toc = format!("toc-{}.html", own.code);
            let page = own.framed(&files::text(&file)?)?.replace("\"toc.html\"", &format!("\"{toc}\""));
            write_changed(&file, page.as_bytes())?;
            let all = own.markup(&files::text(&pages.join("toc.html"))?.replace("&#39;", "'")).0;
            let all = all.replace(&format!("{original}."), &format!("{name}."));
            let all = all.replacen("lang=\"en\"", &format!("lang=\"{}\"", own.code), 1);
            // A chapter's number is no decimal.
            write_changed(&pages.join(toc), with(&all, ',', '.').as_bytes())?;
        }
        if index {
            write_changed(&pages.join("index.html"), &files::bytes(&file)?)?;
        }
        if let Some(Site(root)) = site {
            map.push_str(&format!("<url><loc>{root}{address}</loc></url>\n"));
        }
    }
    if site.is_some() {
        let text = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n{map}</urlset>\n"
        );
        write_changed(&pages.join("sitemap.xml"), text.as_bytes())?;
    }
    Ok(())
}

/// Changes a page.
fn rewrite(file: &Path, change: impl Fn(String) -> Option<String>) -> Result<bool, String> {
    let page = change(files::text(file)?);
    let page = page.ok_or_else(|| format!("{} has no title or no description", file.display()))?;
    write_changed(file, page.as_bytes())
}

/// The page with a title and a place for a description: mdBook's table of contents has neither.
fn named(html: String) -> String {
    let head = "<meta charset=\"UTF-8\">\n<title>Contents - Tumbling</title>\n<meta name=\"description\" content=\"\">";
    if html.contains("<title>") { html } else { html.replacen("<meta charset=\"UTF-8\">", head, 1) }
}

/// The page with its own description; `None` if the page has no description to replace. Without an address
/// the page has no canonical link.
fn with_head(html: &str, sentence: &str, address: Option<&str>, site: Option<&Site>) -> Option<String> {
    let written = between(html, "<title>", "</title>")?;
    // The first page has the name of the book itself.
    let doubled = written.split_once(" - ").filter(|(page, book)| page == book);
    let title = doubled.map_or(written, |(_, book)| book);
    let old = between(html, "<meta name=\"description\" content=\"", "\">")?;
    let sentence = escaped(sentence);
    // Without an address, the path of the picture is relative, which is enough for local readers.
    let root = site.map_or("", |Site(root)| root);
    let mut head = format!(
        "{sentence}\">\n        <meta property=\"og:type\" content=\"article\">\n        <meta property=\"og:title\" \
         content=\"{title}\">\n        <meta property=\"og:description\" content=\"{sentence}\">\n        <meta \
         property=\"og:image\" content=\"{root}{PREVIEW}\">\n        <meta name=\"twitter:card\" content=\"summary_large_image"
    );
    if let (Some(address), Some(_)) = (address, site) {
        head.push_str(&format!(
            "\">\n        <link rel=\"canonical\" href=\"{root}{address}\">\n        <meta property=\"og:url\" \
             content=\"{root}{address}"
        ));
    }
    let html = html.replacen(&format!("<title>{written}</title>"), &format!("<title>{title}</title>"), 1);
    Some(html.replacen(&format!("content=\"{old}\">"), &format!("content=\"{head}\">"), 1))
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    let start = text.find(before)? + before.len();
    Some(&text[start..start + text[start..].find(after)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str =
        "<head><title>Axes - Tumbling</title><meta name=\"description\" content=\"The book.\"></head>";

    #[test]
    fn a_page_tells_its_own_sentence() {
        let page = with_head(PAGE, "Three \"quiet\" axes.", Some("axes.html"), None).unwrap();
        assert!(page.contains("name=\"description\" content=\"Three &quot;quiet&quot; axes.\">"), "{page}");
        assert!(page.contains("og:title\" content=\"Axes - Tumbling\">") && !page.contains("The book."));
        assert!(
            page.contains("og:image\" content=\"preview.png\">") && !page.contains("canonical"),
            "{page}"
        );
        let first = with_head(&PAGE.replace("Axes", "Tumbling"), "A flip.", Some(""), None).unwrap();
        assert!(
            first.contains("<title>Tumbling</title>") && first.contains("og:title\" content=\"Tumbling\">"),
            "{first}"
        );
        assert_eq!(with_head("<head></head>", "A.", Some("a.html"), None), None);
    }

    #[test]
    fn a_page_of_a_site_knows_its_full_address() {
        let site = Site::parse("https://example.org/book").unwrap();
        let page = with_head(PAGE, "Axes.", Some("axes.html"), Some(&site)).unwrap();
        assert!(page.contains("rel=\"canonical\" href=\"https://example.org/book/axes.html\">"), "{page}");
        assert!(page.contains("og:image\" content=\"https://example.org/book/preview.png\">"), "{page}");
        assert!(page.contains("content=\"summary_large_image\">"), "{page}");
        let contents = named("<head><meta charset=\"UTF-8\"></head>".to_owned());
        let page = with_head(&contents, "The chapters.", None, Some(&site)).unwrap();
        assert!(page.contains("book/preview.png\">") && !page.contains("canonical"), "{page}");
    }

    #[test]
    fn what_is_no_address_is_refused() {
        for wrong in
            ["", "example.org", "https://", "https://a b/", "ftp://a/", "https://a/?x", "https://a/\">"]
        {
            assert!(Site::parse(wrong).is_err(), "{wrong}");
        }
    }
}
