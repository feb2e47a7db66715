//! The book as an EPUB 3 publication.

use super::page::Page;
use super::pages::{Paper, contents};
use super::tree::{Node, rewritten, xml};
use std::io::{Cursor, Write as _};
use std::time::{Duration, SystemTime};
use tumbling_site::places::escaped;
use tumbling_site::{files, paths};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A file of the publication.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) name: String,
    media: &'static str,
    /// Its further properties in the manifest.
    properties: String,
    pub(super) content: Vec<u8>,
}

const XHTML: &str = "application/xhtml+xml";
const IDENTIFIER: &str = concat!("urn:tumbling-book:", env!("CARGO_PKG_VERSION"));

/// Fonts that travel with the book: the reader's device may have none for formulas.
const FONTS: [&str; 3] = ["literata.woff2", "literata-italic.woff2", "tumbling-math.woff2"];

const CONTAINER: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<container version=\"1.0\" xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">
<rootfiles><rootfile full-path=\"EPUB/package.opf\" media-type=\"application/oebps-package+xml\"/></rootfiles>
</container>
";

/// The publication as the bytes of its file.
///
/// # Errors
/// A file that cannot be read.
pub(super) fn file(paper: &Paper) -> Result<Vec<u8>, String> {
    let failed = |e: zip::result::ZipError| format!("the EPUB cannot be packed: {e}");
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let whole = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut put = |name: &str, content: &[u8], options| -> Result<(), String> {
        zip.start_file(name, options).map_err(failed)?;
        zip.write_all(content).map_err(|e| format!("the EPUB cannot be packed: {e}"))
    };
    // Programs that look at the first bytes find the kind of the file there.
    put("mimetype", b"application/epub+zip", whole.compression_method(CompressionMethod::Stored))?;
    put("META-INF/container.xml", CONTAINER.as_bytes(), whole)?;
    let entries = entries(paper)?;
    put("EPUB/package.opf", package(paper, &entries, &modified()).as_bytes(), whole)?;
    for entry in &entries {
        put(&format!("EPUB/{}", entry.name), &entry.content, whole)?;
    }
    zip.finish().map(Cursor::into_inner).map_err(failed)
}

/// All files that the manifest lists.
///
/// # Errors
/// A file that cannot be read.
pub(super) fn entries(paper: &Paper) -> Result<Vec<Entry>, String> {
    let entry = |name: &str, media, properties: &str, content: Vec<u8>| Entry {
        name: name.to_owned(),
        media,
        properties: properties.to_owned(),
        content,
    };
    let cover = super::title::cover(paper)?;
    let title = document(paper, "Title page", &super::title::page(paper));
    let mut entries = vec![
        entry("style.css", "text/css", "", include_bytes!("../../../paper/epub.css").to_vec()),
        entry("nav.xhtml", XHTML, "nav", nav(paper).into_bytes()),
        entry("cover.svg", "image/svg+xml", "cover-image", cover.into_bytes()),
        entry("title.xhtml", XHTML, "", title.into_bytes()),
    ];
    for font in FONTS {
        let bytes = files::bytes(&paths::book().join("theme/fonts").join(font))?;
        entries.push(entry(font, "font/woff2", "", bytes));
    }
    for page in &paper.pages {
        let text = document(paper, &page.title, &xml(&renamed(page)));
        entries.push(entry(&format!("{}.xhtml", page.name), XHTML, &properties(&text), text.into_bytes()));
    }
    Ok(entries)
}

/// The properties that the manifest must state for a page with formulas or drawings.
fn properties(text: &str) -> String {
    let inside = [("mathml", "<math "), ("svg", "<svg ")].into_iter().filter(|(_, tag)| text.contains(tag));
    inside.map(|(name, _)| name).collect::<Vec<_>>().join(" ")
}

/// The page with links to the files of the publication.
fn renamed(page: &Page) -> Vec<Node> {
    rewritten(page.body.clone(), &mut |mut element| {
        if let Some(target) = element.get("href").filter(|target| !target.starts_with("http")) {
            let target = target.replacen(".html", ".xhtml", 1);
            element.set("href", &target);
        }
        vec![element.into()]
    })
}

fn document(paper: &Paper, title: &str, body: &str) -> String {
    let language = &paper.about.language;
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" \
         xmlns:epub=\"http://www.idpf.org/2007/ops\" lang=\"{language}\" xml:lang=\"{language}\">\n<head><title>{}</title>\
         <link rel=\"stylesheet\" type=\"text/css\" href=\"style.css\"/></head>\n<body>\n{body}\n</body>\n</html>\n",
        escaped(title)
    )
}

fn nav(paper: &Paper) -> String {
    let contents = contents(paper, |_| true, &|page, section, words| {
        let place = section.map_or(String::new(), |section| format!("#{section}"));
        format!("<a href=\"{page}.xhtml{place}\">{words}</a>")
    });
    let first = paper.pages.first().map_or("", |page| page.name.as_str());
    let out = format!(
        "<nav epub:type=\"toc\" role=\"doc-toc\" id=\"toc\"><h1>Contents</h1>\n<ol>\n{contents}</ol></nav>\n\
         <nav epub:type=\"landmarks\" hidden=\"\"><h2>Places</h2>\n<ol>\n<li><a epub:type=\"titlepage\" \
         href=\"title.xhtml\">Title page</a></li>\n<li><a epub:type=\"toc\" href=\"nav.xhtml\">Contents</a></li>\n\
         <li><a epub:type=\"bodymatter\" href=\"{first}.xhtml\">Start of the text</a></li>\n</ol></nav>"
    );
    document(paper, "Contents", &out)
}

/// The book's features for blind readers, by the names of schema.org.
const FEATURES: [&str; 8] = [
    "structuralNavigation",
    "tableOfContents",
    "readingOrder",
    "alternativeText",
    "longDescription",
    "MathML",
    "displayTransformability",
    "unlocked",
];

const SUMMARY: &str = "Every figure has a title and a description in words, every formula is MathML with a text. \
                       Links lead from each question and exercise to its answer and back.";

fn package(paper: &Paper, entries: &[Entry], modified: &str) -> String {
    let item = |entry: &Entry| {
        let properties = match entry.properties.as_str() {
            "" => String::new(),
            some => format!(" properties=\"{some}\""),
        };
        let id = entry.name.replace('.', "-");
        format!("<item id=\"{id}\" href=\"{}\" media-type=\"{}\"{properties}/>\n", entry.name, entry.media)
    };
    let items: String = entries.iter().map(item).collect();
    let read = ["title", "nav"].into_iter().chain(paper.pages.iter().map(|page| page.name.as_str()));
    let spine: String = read.map(|name| format!("<itemref idref=\"{name}-xhtml\"/>\n")).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" \
         unique-identifier=\"id\" xml:lang=\"{}\">\n{}<manifest>\n{items}</manifest>\n<spine>\n{spine}</spine>\n</package>\n",
        paper.about.language,
        metadata(paper, modified)
    )
}

fn metadata(paper: &Paper, modified: &str) -> String {
    let about = &paper.about;
    let author = |author: &String| format!("<dc:creator>{}</dc:creator>\n", escaped(author));
    let authors: String = about.authors.iter().map(author).collect();
    let features =
        FEATURES.map(|f| format!("<meta property=\"schema:accessibilityFeature\">{f}</meta>\n")).concat();
    format!(
        "<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">
<dc:identifier id=\"id\">{IDENTIFIER}</dc:identifier>
<dc:title>{}</dc:title>
<dc:language>{}</dc:language>
{authors}<dc:description>{}</dc:description>
<dc:rights>CC BY 4.0, https://creativecommons.org/licenses/by/4.0/</dc:rights>
<meta property=\"dcterms:modified\">{modified}</meta>
<meta property=\"schema:accessMode\">textual</meta>
<meta property=\"schema:accessMode\">visual</meta>
<meta property=\"schema:accessModeSufficient\">textual</meta>
{features}<meta property=\"schema:accessibilityHazard\">none</meta>
<meta property=\"schema:accessibilitySummary\">{SUMMARY}</meta>
</metadata>
",
        escaped(&about.title),
        about.language,
        escaped(&about.description),
    )
}

/// The stated time of publication, in UTC; `SOURCE_DATE_EPOCH` if it is set.
fn modified() -> String {
    let given = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|seconds| seconds.parse().ok());
    let now = || SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or(Duration::ZERO).as_secs();
    at(given.unwrap_or_else(now))
}

/// Seconds since 1970 as a date, by the days of a year that begins in March.
fn at(seconds: u64) -> String {
    let (days, second) = (seconds / 86_400 + 719_468, seconds % 86_400);
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let date = of_year - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    format!(
        "{:04}-{month:02}-{date:02}T{:02}:{:02}:{:02}Z",
        year + era * 400 + next,
        second / 3600,
        second / 60 % 60,
        second % 60
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_date_is_that_of_the_calendar() {
        assert_eq!(at(0), "1970-01-01T00:00:00Z");
        assert_eq!(at(951_782_399), "2000-02-28T23:59:59Z");
        assert_eq!(at(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(at(1_735_689_599), "2024-12-31T23:59:59Z");
    }
}
