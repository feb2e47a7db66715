//! Additions to a tagged PDF that PDF/UA requires and a browser omits: metadata, standard tags, descriptions
//! of links, and marks on the contents of the margins.
//!
//! Chromium writes each object as plain text with its dictionary in front, one entry a line, and a table of
//! where they begin. A file that looks otherwise is not touched.

use super::numbers;
use super::pages::About;
use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read as _, Write as _};
use tumbling_site::places::escaped;

/// The beginning of a formula's description: a figure with such a description is a formula.
pub(super) const FORMULA: &str = "formula: ";

/// Objects by their numbers: the text between `obj` and `endobj`.
pub(super) type Objects = BTreeMap<usize, Vec<u8>>;

/// The PDF with the additions.
///
/// # Errors
/// How it differs from what Chromium writes.
pub(super) fn mended(pdf: &[u8], about: &About) -> Result<Vec<u8>, String> {
    let (mut objects, trailer) = read(pdf).ok_or("it has no plain table of objects")?;
    let pages = numbers::of(pdf);
    let items =
        objects.iter().filter(|(_, body)| text(body).contains("\n/S /LI\n")).map(|(number, _)| *number);
    let items: BTreeSet<usize> = items.collect();
    let mut contents = BTreeSet::new();
    let mut inside: BTreeMap<usize, Vec<(usize, String)>> = BTreeMap::new();
    let mut catalog = None;
    for (number, body) in &mut objects {
        let old = text(body);
        if old.starts_with("<</Type /Page\n") {
            contents.extend(after(&old, "\n/Contents ").and_then(reference));
        } else if old.starts_with("<</Type /Catalog\n") {
            catalog = Some(*number);
        } else if old.starts_with("<</Type /StructElem\n") {
            let new = tagged(&old, &items);
            if let Some(item) = after(&new, "\n/P ").and_then(reference).filter(|at| items.contains(at)) {
                inside.entry(item).or_default().push((*number, new.clone()));
            }
            *body = new.into_bytes();
        } else if old.contains("\n/Subtype /Link\n") && !old.contains("\n/Contents ") {
            *body = old
                .replacen("\n/F 4\n", &format!("\n/F 4\n/Contents ({})\n", target(&old, &pages)), 1)
                .into_bytes();
        }
    }
    for number in contents {
        let body = objects.get_mut(&number).ok_or("a page without its text")?;
        *body = marked(body).ok_or("the text of a page cannot be read")?;
    }
    for (item, kids) in inside {
        with_body(item, kids, &mut objects);
    }
    let catalog = catalog.ok_or("it has no catalog")?;
    let metadata = objects.keys().next_back().map_or(1, |last| last + 1);
    let xmp = metadata_of(about, &title(&objects).unwrap_or_else(|| about.title.clone()));
    let stream =
        format!("<</Type /Metadata\n/Subtype /XML\n/Length {}>> stream\n{xmp}\nendstream", xmp.len());
    objects.insert(metadata, stream.into_bytes());
    if let Some(body) = objects.get_mut(&catalog) {
        let with = format!("<</Type /Catalog\n/Metadata {metadata} 0 R\n");
        *body = text(body).replacen("<</Type /Catalog\n", &with, 1).into_bytes();
    }
    Ok(written(&objects, metadata + 1, &trailer))
}

/// The dictionary of an object as text; nothing if it is none.
pub(super) fn text(body: &[u8]) -> String {
    if body.ends_with(b"endstream") {
        String::new()
    } else {
        String::from_utf8(body.to_vec()).unwrap_or_default()
    }
}

fn after<'a>(text: &'a str, words: &str) -> Option<&'a str> {
    text.split_once(words).map(|(_, after)| after)
}

/// The number in `12 0 R`.
fn reference(text: &str) -> Option<usize> {
    text.split_once(" 0 R")?.0.trim().parse().ok()
}

/// The objects, and the entries of the trailer that name some of them.
pub(super) fn read(pdf: &[u8]) -> Option<(Objects, String)> {
    let tail = String::from_utf8_lossy(&pdf[pdf.len().saturating_sub(400)..]).into_owned();
    let (rest, start) = tail.rsplit_once("startxref\n")?;
    let start: usize = start.lines().next()?.parse().ok()?;
    let trailer = rest.rsplit_once("trailer\n")?.1;
    let kept = ["/Root ", "/Info "]
        .map(|name| after(trailer, name).and_then(reference).map(|at| format!("{name}{at} 0 R")));
    let table = String::from_utf8_lossy(pdf.get(start..)?).into_owned();
    let mut begins: Vec<usize> = Vec::new();
    for line in table.strip_prefix("xref\n")?.lines().skip(1).take_while(|line| !line.starts_with("trailer"))
    {
        if let Some(offset) = line.strip_suffix(" n ").and_then(|line| line.split(' ').next()) {
            begins.push(offset.parse().ok()?);
        }
    }
    begins.sort_unstable();
    begins.push(start);
    let mut objects = Objects::new();
    for pair in begins.windows(2) {
        let object = pdf.get(pair[0]..pair[1])?;
        let end = object.windows(7).position(|at| at == b" 0 obj\n")?;
        let number = std::str::from_utf8(&object[..end]).ok()?.parse().ok()?;
        let body = object[end + 7..].strip_suffix(b"\nendobj\n")?;
        objects.insert(number, body.to_vec());
    }
    Some((objects, kept.into_iter().flatten().collect::<Vec<_>>().join("\n")))
}

/// An element of the structure, by standard names alone; `items` are those of lists.
fn tagged(element: &str, items: &BTreeSet<usize>) -> String {
    let coded: String = FORMULA.bytes().map(|byte| format!("{byte:04X}")).collect();
    let is_formula =
        element.contains(&format!("/Alt ({FORMULA}")) || element.contains(&format!("/Alt <FEFF{coded}"));
    let parent = after(element, "\n/P ").and_then(reference);
    let in_item = parent.is_some_and(|parent| items.contains(&parent));
    let mut out =
        element.replacen("\n/S /Em\n", "\n/S /Span\n", 1).replacen("\n/S /Strong\n", "\n/S /Span\n", 1);
    if is_formula {
        out = out.replacen("\n/S /Figure\n", "\n/S /Formula\n", 1);
    }
    if in_item {
        out = out.replacen("\n/S /NonStruct\n", "\n/S /LBody\n", 1);
    }
    out
}

/// Adds a body to an item of a list, for its direct contents: a link, another list.
fn with_body(item: usize, kids: Vec<(usize, String)>, objects: &mut Objects) {
    let parent = format!("\n/P {item} 0 R\n");
    let has = |name: &str| kids.iter().any(|(_, kid)| kid.contains(name));
    if has("\n/S /LBody\n") || has("\n/S /Lbl\n") {
        return;
    }
    let Some(old) = objects.get(&item).map(|body| text(body)) else { return };
    let Some((head, inside)) = old.split_once("\n/K ") else { return };
    let new = objects.keys().next_back().map_or(1, |last| last + 1);
    let body = format!("<</Type /StructElem\n/S /LBody{parent}/K {inside}");
    let held = format!("{head}\n/K {new} 0 R>>");
    for (number, kid) in kids {
        objects.insert(number, kid.replacen(&parent, &format!("\n/P {new} 0 R\n"), 1).into_bytes());
    }
    objects.insert(new, body.into_bytes());
    objects.insert(item, held.into_bytes());
}

/// The contents of a string up to the parenthesis that ends it, still escaped.
fn literal(text: &str) -> Option<&str> {
    let (mut escaped, mut depth) = (false, 0_usize);
    let end = text.char_indices().find(|&(_, c)| {
        let ends = c == ')' && !escaped && depth == 0;
        match c {
            _ if escaped => {}
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        escaped = c == '\\' && !escaped;
        ends
    });
    end.map(|(at, _)| &text[..at])
}

/// Where a link leads, in words.
fn target(link: &str, pages: &BTreeMap<String, usize>) -> String {
    if let Some(address) = after(link, "/URI (").and_then(literal) {
        return address.to_owned();
    }
    let place = after(link, "/Dest /").and_then(|rest| rest.split(['\n', '>']).next()).unwrap_or_default();
    pages.get(place).map_or("A place in this book".to_owned(), |page| format!("Page {page}"))
}

/// The text of a page, in which everything without a tag is marked as not part of the content: the margins.
fn marked(stream: &[u8]) -> Option<Vec<u8>> {
    let begin = stream.windows(8).position(|at| at == b" stream\n")? + 8;
    let packed = stream[begin..].strip_suffix(b"endstream")?;
    let mut plain = Vec::new();
    ZlibDecoder::new(packed).read_to_end(&mut plain).ok()?;
    let (mut out, mut depth) = (Vec::with_capacity(plain.len() + 64), 0_usize);
    for line in plain.split(|byte| *byte == b'\n') {
        let loose = depth == 0;
        match line {
            b"BT" if loose => out.extend(b"/Artifact BMC\nBT"),
            b"ET" if loose => out.extend(b"ET\nEMC"),
            _ => out.extend(line),
        }
        out.push(b'\n');
        if line.ends_with(b"BDC") || line.ends_with(b"BMC") {
            depth += 1;
        } else if line == b"EMC" {
            depth = depth.saturating_sub(1);
        }
    }
    let mut packer = ZlibEncoder::new(Vec::new(), Compression::default());
    packer.write_all(&out).ok()?;
    let packed = packer.finish().ok()?;
    let mut body = format!("<</Filter /FlateDecode\n/Length {}>> stream\n", packed.len()).into_bytes();
    body.extend(packed);
    body.extend(b"\nendstream");
    Some(body)
}

/// The title of the document, as the browser has written it in plain letters.
fn title(objects: &Objects) -> Option<String> {
    let titled = |body: &Vec<u8>| {
        let title = text(body).strip_prefix("<</Title (").and_then(literal).map(str::to_owned)?;
        Some(title.replace("\\(", "(").replace("\\)", ")"))
    };
    objects.values().find_map(titled)
}

fn metadata_of(about: &About, title: &str) -> String {
    let [title, description] = [title, &about.description].map(escaped);
    let authors: String =
        about.authors.iter().map(|author| format!("<rdf:li>{}</rdf:li>", escaped(author))).collect();
    format!(
        "<?xpacket begin=\"\u{feff}\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n\
         <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n<rdf:Description rdf:about=\"\" \
         xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:pdfuaid=\"http://www.aiim.org/pdfua/ns/id/\">\n\
         <dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">{title}</rdf:li></rdf:Alt></dc:title>\n\
         <dc:description><rdf:Alt><rdf:li xml:lang=\"x-default\">{description}</rdf:li></rdf:Alt></dc:description>\n\
         <dc:creator><rdf:Seq>{authors}</rdf:Seq></dc:creator>\n<dc:language><rdf:Bag><rdf:li>{}</rdf:li></rdf:Bag></dc:language>\n\
         <pdfuaid:part>1</pdfuaid:part>\n</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>",
        about.language
    )
}

/// The objects as a file.
fn written(objects: &Objects, size: usize, trailer: &str) -> Vec<u8> {
    let mut out = b"%PDF-1.7\n%\xE2\xE3\xCF\xD3\n".to_vec();
    let mut begins = BTreeMap::new();
    for (number, body) in objects {
        begins.insert(*number, out.len());
        out.extend(format!("{number} 0 obj\n").bytes());
        out.extend(body);
        out.extend(b"\nendobj\n");
    }
    let start = out.len();
    out.extend(format!("xref\n0 {size}\n").bytes());
    for number in 0..size {
        let line = begins
            .get(&number)
            .map_or("0000000000 65535 f \n".to_owned(), |at| format!("{at:010} 00000 n \n"));
        out.extend(line.bytes());
    }
    out.extend(format!("trailer\n<</Size {size}\n{trailer}>>\nstartxref\n{start}\n%%EOF\n").bytes());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about() -> About {
        let [title, description, language] = ["A & B", "Why.", "en"].map(str::to_owned);
        About { title, description, authors: vec!["C".into()], language }
    }

    fn packed(plain: &[u8]) -> Vec<u8> {
        let mut packer = ZlibEncoder::new(Vec::new(), Compression::default());
        packer.write_all(plain).unwrap();
        let packed = packer.finish().unwrap();
        let head = format!("<</Filter /FlateDecode\n/Length {}>> stream\n", packed.len());
        [head.as_bytes(), &packed, b"\nendstream"].concat()
    }

    fn printed() -> Vec<u8> {
        let mut objects = Objects::new();
        for (number, body) in [
            (1, "<</Type /Catalog\n/Pages 2 0 R>>"),
            (2, "<</Type /Pages\n/Kids [3 0 R]>>"),
            (3, "<</Type /Page\n/Contents 4 0 R\n/Parent 2 0 R>>"),
            (5, "<</Type /StructElem\n/S /LI\n/P 1 0 R>>"),
            (6, "<</Type /StructElem\n/S /NonStruct\n/P 5 0 R>>"),
            (7, "<</Type /StructElem\n/S /Figure\n/Alt (formula: x)\n/P 1 0 R>>"),
            (8, "<</Type /Annot\n/Subtype /Link\n/F 4\n/Dest /there\n/StructParent 3>>"),
            (9, "<</there [3 0 R /XYZ 0 800 0]>>"),
            (10, "<</Type /StructElem\n/S /LI\n/P 1 0 R\n/K 11 0 R>>"),
            (11, "<</Type /StructElem\n/S /Link\n/P 10 0 R\n/K 1>>"),
        ] {
            objects.insert(number, body.as_bytes().to_vec());
        }
        objects.insert(4, packed(b"BT\n(1) Tj\nET\n/P <</MCID 0 >>BDC\nBT\n(a) Tj\nET\nEMC\n"));
        written(&objects, 12, "/Root 1 0 R")
    }

    #[test]
    fn a_printed_file_gets_metadata_tags_words_for_links_and_marks_on_its_margins() {
        let (objects, trailer) = read(&mended(&printed(), &about()).unwrap()).unwrap();
        let of = |number: usize| String::from_utf8_lossy(&objects[&number]).into_owned();
        assert_eq!(trailer, "/Root 1 0 R");
        assert!(of(10).ends_with("/K 12 0 R>>") && of(11).contains("\n/P 12 0 R\n"), "{}", of(10));
        assert_eq!(of(12), "<</Type /StructElem\n/S /LBody\n/P 10 0 R\n/K 11 0 R>>");
        assert!(of(1).contains("/Metadata 13 0 R"), "{}", of(1));
        assert!(of(13).contains("<rdf:li xml:lang=\"x-default\">A &amp; B<"), "{}", of(13));
        assert!(of(6).contains("/S /LBody") && of(7).contains("/S /Formula"));
        assert!(of(8).contains("/Contents (Page 1)"), "{}", of(8));
        let body = &objects[&4];
        let begin = body.windows(8).position(|at| at == b" stream\n").unwrap() + 8;
        let mut plain = String::new();
        ZlibDecoder::new(&body[begin..]).read_to_string(&mut plain).unwrap();
        let marked = "/Artifact BMC\nBT\n(1) Tj\nET\nEMC\n/P <</MCID 0 >>BDC\nBT\n(a) Tj\nET\nEMC\n";
        assert_eq!(plain.trim_end(), marked.trim_end());
    }

    #[test]
    fn a_parenthesis_in_an_address_or_a_title_does_not_end_it() {
        let link = "<</A <</URI (https://a.org/b_\\(c\\)_(d)?e)>>";
        assert_eq!(target(link, &BTreeMap::new()), "https://a.org/b_\\(c\\)_(d)?e");
        let objects = Objects::from([(1, b"<</Title (A \\(b\\) c)\n/Creator (d)>>".to_vec())]);
        assert_eq!(title(&objects).unwrap(), "A (b) c");
    }

    #[test]
    fn a_file_of_another_make_is_refused() {
        assert!(mended(b"%PDF-1.5\n1 0 obj\n", &about()).is_err());
        let other = String::from_utf8_lossy(&printed()).replace("/Catalog", "/Cats");
        assert!(mended(other.as_bytes(), &about()).is_err());
    }
}
