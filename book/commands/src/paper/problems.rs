//! The problems of a chapter for paper and pencil, from its section of the page of problems; a second sheet
//! has the answers.

use super::fitted::Setting;
use super::page::Page;
use super::pages::Paper;
use super::sheet::{self, Size, after};
use super::tree::{Element, Node, rewritten, text, xml};
use tumbling_site::home;
use tumbling_site::language::Language;
use tumbling_site::places::escaped;

/// The page with the problems; its sections have the names of the chapters.
const PAGE: &str = "problems";

/// A problem and its answer.
struct Problem {
    asked: Vec<Node>,
    answer: Vec<Node>,
}

/// The problems of a chapter as HTML, alone or each with its answer, set like this, in the language of its
/// page.
///
/// # Errors
/// There is no such chapter, or an answer or a translation is missing.
pub(super) fn sheet(
    paper: &Paper,
    name: &str,
    size: Size,
    [fit, times]: Setting,
    answers: bool,
) -> Result<String, String> {
    let page = sheet::chapter(paper, name)?;
    let language = Language::of(name)?;
    let problems = match &language {
        Some((own, original)) => translated(written(paper, original)?, own)?,
        None => written(paper, name)?,
    };
    let say = |words: &str| language.as_ref().map_or(words.to_owned(), |(own, _)| own.label(words).0);
    let class = if answers { "answers" } else { "problems" };
    let list = |from: usize, to: usize| {
        let items = problems[from..to].iter().map(|problem| {
            let Problem { asked, answer } = problem;
            let after = Element::new("div", &[("class", "answer")], answer.clone());
            let nodes: Vec<_> = asked.iter().cloned().chain(answers.then(|| after.into())).collect();
            // A problem with a longer answer gets more space.
            let (room, words) = (1 + text(answer).len() / 90, xml(&sheet::within(&nodes, class)));
            format!("<li class=\"problem\" style=\"flex-grow: {room}\">{words}</li>\n")
        });
        format!("<ol start=\"{}\">{}</ol>\n", from + 1, items.collect::<String>())
    };
    let title = format!("{}: {}", page.title, say(class));
    let (from, count) = (say("From the book"), problems.len());
    let of = escaped(&format!("{from} {}, CC\u{a0}BY\u{a0}4.0{}.", paper.about.title, home::address()));
    let head = format!("<h1>{}</h1>\n", escaped(&title));
    let body = if answers {
        let all = list(0, count);
        let checked = say("The numbers are computed and checked by the book’s tests.");
        // A page to be cut apart has several copies; one is enough for a screen reader.
        let copies = (0..times.max(1)).map(|at| {
            let again = if at == 0 { "" } else { " aria-hidden=\"true\"" };
            format!("<section class=\"copy of-{times}\"{again}>{head}{all}<p class=\"for\">{of} {checked}</p></section>\n")
        });
        copies.collect()
    } else {
        // More than three go on both sides of the sheet, with the rest of the paper to work on.
        let front = if count > 3 { count.div_ceil(2) } else { count };
        let [name, date] = ["Name", "Date"].map(say);
        let head = format!(
            "<p class=\"whose\"><span>{name}</span><span>{date}</span></p>{head}<p class=\"for\">{}</p>\n",
            say("Paper and pencil. Give numbers with their units.")
        );
        let turned = format!("</section>\n<section class=\"side\">{}", list(front, count));
        let back = if front < count { turned } else { String::new() };
        format!("<section class=\"side\">{head}{}{back}<p class=\"for\">{of}</p></section>", list(0, front))
    };
    let code = language.map_or(paper.about.language.clone(), |(own, _)| own.code);
    sheet::document(paper, [&code, &title], &format!("sheet fit-{fit}"), size, "", &body)
}

/// The problems in another language, paragraph by paragraph.
fn translated(problems: Vec<Problem>, own: &Language) -> Result<Vec<Problem>, String> {
    let (known, mut lost) = (own.page.get(PAGE).cloned().unwrap_or_default(), Vec::new());
    let mut say = |nodes: Vec<Node>| {
        rewritten(nodes, &mut |mut element| {
            if ["p", "h2"].contains(&element.name.as_str()) {
                let text = element.text().replace('\u{a0}', " ");
                let what = format!("not there; it is in book/chapters/{PAGE}.md");
                lost.extend((!known.contains_key(&text)).then(|| own.fault(&text, "", &what)));
                element.children = known.get(&text).cloned().into_iter().map(Node::Text).collect();
            }
            vec![element.into()]
        })
    };
    let problems =
        problems.into_iter().map(|one| Problem { asked: say(one.asked), answer: say(one.answer) }).collect();
    if lost.is_empty() { Ok(problems) } else { Err(lost.join("\n")) }
}

/// The problems of this chapter in the page of problems.
fn written(paper: &Paper, name: &str) -> Result<Vec<Problem>, String> {
    let (page, solutions) = (named(paper, PAGE)?, named(paper, "solutions")?);
    let id = |node: &Node| node.element().and_then(|it| it.get("id")).unwrap_or_default().to_owned();
    let Some(start) = page.body.iter().position(|node| node.is("h2") && id(node) == name) else {
        return Ok(Vec::new());
    };
    let section = &page.body[start + 1..];
    let end = section.iter().position(|node| node.is("h2")).unwrap_or(section.len());
    let mut found: Vec<Problem> = Vec::new();
    for node in &section[..end] {
        if node.is("h3") {
            let place = format!("{PAGE}-{}", id(node));
            let answer = after(&solutions.body, &place).ok_or_else(|| format!("{place} has no answer"))?;
            found.push(Problem { asked: Vec::new(), answer: plain(answer) });
        }
        if let Some(problem) = found.last_mut() {
            problem.asked.extend(rewritten(vec![node.clone()], &mut |element| on_sheet(element)));
        }
    }
    Ok(found)
}

/// The parts of an element that a sheet shows: no programs and no links, which lead nowhere on paper.
fn on_sheet(element: Element) -> Vec<Node> {
    let dropped = ["program", "to-end", "summary"].iter().any(|class| element.has_class(class));
    match element.name.as_str() {
        _ if dropped => Vec::new(),
        "a" | "blockquote" => element.children,
        "h3" => vec![Element::new("h2", &[], element.children).into()],
        _ => vec![element.into()],
    }
}

fn plain(answer: &Element) -> Vec<Node> {
    let mut nodes = rewritten(vec![answer.clone().into()], &mut |element| on_sheet(element));
    if let [Node::Element(only)] = nodes.as_mut_slice() {
        only.attributes.clear();
    }
    nodes
}

fn named<'a>(paper: &'a Paper, name: &str) -> Result<&'a Page, String> {
    let page = paper.pages.iter().find(|page| page.name == name);
    page.ok_or_else(|| format!("the book has no page `{name}`"))
}
