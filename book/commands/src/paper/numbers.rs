//! The page number of each named place in a PDF, as browsers write PDFs: objects in plain text, pages in
//! order.

use super::mend;
use std::collections::BTreeMap;

/// The number of the page, from one, of each named place.
pub(super) fn of(pdf: &[u8]) -> BTreeMap<String, usize> {
    let objects = mend::read(pdf).map_or_else(BTreeMap::new, |(objects, _)| objects);
    let objects: BTreeMap<usize, String> = objects.iter().map(|(at, body)| (*at, mend::text(body))).collect();
    let mut order = Vec::new();
    let is_root = |body: &str| body.contains("/Type /Pages") && !body.contains("/Parent");
    if let Some((root, _)) = objects.iter().find(|(_, body)| is_root(body)) {
        pages(*root, &objects, &mut order);
    }
    let page = |object: usize| order.iter().position(|at| *at == object).map(|at| at + 1);
    let mut found = BTreeMap::new();
    for body in objects.values().filter(|body| body.contains("/XYZ")) {
        // `/name [12 0 R /XYZ 0 800 0]` or `(name) [...]`
        for (at, _) in body.match_indices(" 0 R /XYZ") {
            let Some((name, object)) = body[..at].rsplit_once('[') else { continue };
            let name = name.trim_end().trim_end_matches(')').rsplit(['/', '(', ' ', '\n']).next();
            if let Some(number) = object.trim().parse().ok().and_then(page) {
                found.insert(name.unwrap_or_default().to_owned(), number);
            }
        }
    }
    found
}

/// The pages under this object, in order.
fn pages(object: usize, objects: &BTreeMap<usize, String>, order: &mut Vec<usize>) {
    let Some(body) = objects.get(&object) else { return };
    let Some((_, kids)) = body.split_once("/Kids [") else { return order.push(object) };
    let kids = kids.split(']').next().unwrap_or_default();
    for kid in kids.split(" 0 R").filter_map(|kid| kid.trim().parse().ok()) {
        pages(kid, objects, order);
    }
}
