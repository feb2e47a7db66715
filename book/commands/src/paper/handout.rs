//! A chapter as a handout: story, figures, formulas, numbers and the sources that it cites, without programs.

use super::fitted::Setting;
use super::pages::Paper;
use super::sheet::{self, Size};
use super::tree::{Element, Node, each, rewritten, xml};
use std::collections::BTreeSet;
use tumbling_site::language::Language;
use tumbling_site::places::escaped;
use tumbling_site::{goals, home};

/// The handout of a chapter as HTML, set this closely, with three times this many lines to write on, in the
/// language of its page.
///
/// # Errors
/// There is no such chapter.
pub(super) fn sheet(paper: &Paper, name: &str, size: Size, fit: Setting) -> Result<String, String> {
    let [fit, lines] = fit;
    let page = sheet::chapter(paper, name)?;
    let (language, original) = Language::of(name)?.map_or((None, name), |(own, of)| (Some(own), of));
    let say = |words: &str| language.as_ref().map_or(words.to_owned(), |own| own.label(words).0);
    let number = page.number.as_deref().unwrap_or_default();
    let goals: String =
        goals::of(original)?.iter().map(|goal| format!("<li>{}</li>", escaped(&say(&goal.goal)))).collect();
    let story = whole(&xml(&sheet::within(&story(&page.body), name)));
    let sources = xml(&sheet::within(&sources(paper, &page.body), name));
    let list = format!("<h2>{}</h2>\n<ul class=\"sources\">{sources}</ul>", say("References"));
    let sources = if sources.is_empty() { sources } else { list };
    let notes = format!("<h2>{}</h2>\n{}", say("Notes"), "<div class=\"line\"></div>\n".repeat(3 * lines));
    let notes = if lines == 0 { String::new() } else { notes };
    let body = format!(
        "<div class=\"columns\">\n<header><p>{}</p>\n{}\n</header>\n<div class=\"goals\"><p>{}</p><ul>{goals}</ul></div>\n{story}\n\
         {sources}\n{notes}</div>\n<footer><p>{} {}: {}, CC\u{a0}BY\u{a0}4.0{}.</p></footer>",
        escaped(&say(&format!("{}, chapter {number}", paper.about.title))),
        heading(&page.body),
        say("After this chapter you can"),
        say("The book has the programs that check these numbers, the exercises and the answers."),
        say("Text and figures"),
        escaped(&say(&paper.about.authors.join(", "))),
        escaped(&home::address()),
    );
    let title = format!("{}: {}", page.title, say("handout"));
    let class = format!("handout fit-{fit}");
    let code = language.map_or(paper.about.language.clone(), |own| own.code);
    sheet::document(paper, [&code, &title], &class, size, "@page { margin: 11mm 12mm 13mm; }", &body)
}

/// Where something was left out.
const CUT: &str = "\u{1}";

/// The story without the marks of what was left out; a sentence that led to it ends there.
fn whole(story: &str) -> String {
    let end = |part: &str| part.trim_end().strip_suffix(":</p>").map(|said| format!("{said}.</p>\n"));
    story.split(CUT).map(|part| end(part).unwrap_or_else(|| part.to_owned())).collect()
}

fn heading(body: &[Node]) -> String {
    body.iter().find(|node| node.is("h1")).map_or(String::new(), |title| xml(std::slice::from_ref(title)))
}

/// The chapter up to its exercises, without programs, stills, links and questions, which the story answers.
fn story(body: &[Node]) -> Vec<Node> {
    let id = |node: &Node| node.element().and_then(|element| element.get("id")) == Some("exercises");
    let end = body.iter().position(|node| node.is("h2") && id(node)).unwrap_or(body.len());
    rewritten(body[..end].to_vec(), &mut |element| on_sheet(element))
}

/// The entries of the list of references that the chapter cites, in the order of the list.
fn sources(paper: &Paper, body: &[Node]) -> Vec<Node> {
    let mut places = BTreeSet::new();
    let cited = |link: &str| Some(link.split_once("references.html#")?.1.to_owned());
    each(body, &mut |element| places.extend(element.get("href").and_then(cited)));
    let mut found = Vec::new();
    for page in paper.pages.iter().filter(|page| page.name == "references") {
        each(&page.body, &mut |item| {
            let mut is_cited = false;
            each(&item.children, &mut |inside| {
                is_cited |= inside.get("id").is_some_and(|id| places.contains(id))
            });
            if item.name == "li" && is_cited {
                found.extend(rewritten(vec![item.clone().into()], &mut |element| on_sheet(element)));
            }
        });
    }
    found
}

fn on_sheet(element: Element) -> Vec<Node> {
    let out = ["program", "to-end", "still", "question", "aside"].iter().any(|it| element.has_class(it));
    match element.name.as_str() {
        "h1" => Vec::new(),
        _ if out => vec![Node::Text(CUT.into())],
        "a" => element.children,
        _ => vec![element.into()],
    }
}
