//! The problems of a chapter for paper and pencil: its questions, and its section of the page of problems.

use super::page::Page;
use super::pages::Paper;
use super::sheet::{self, Size, after};
use super::tree::{Element, Node, rewritten, xml};
use crate::site::places::escaped;
use std::fmt::Write as _;

/// The page with the problems; its sections have the names of the chapters.
const PAGE: &str = "problems";

/// A problem and its answer.
struct Problem {
    asked: Vec<Node>,
    answer: Vec<Node>,
}

/// The problems of a chapter as HTML, the answers on a sheet of their own.
///
/// # Errors
/// There is no such chapter, or an answer is missing.
pub(super) fn sheet(paper: &Paper, name: &str, size: Size) -> Result<String, String> {
    let page = sheet::chapter(paper, name)?;
    let title = escaped(&page.title);
    let mut problems = questions(paper, page)?;
    problems.extend(written(paper, name)?);
    let (mut asked, mut answers) = (String::new(), String::new());
    for problem in problems {
        let _ =
            writeln!(asked, "<li class=\"problem\">{}</li>", xml(&sheet::within(&problem.asked, "asked")));
        let _ = writeln!(
            answers,
            "<li class=\"problem\">{}</li>",
            xml(&sheet::within(&problem.answer, "answer"))
        );
    }
    let body = format!(
        "<section class=\"problems\"><h1>{title}: problems</h1>\n<p class=\"for\">Paper and pencil, with the chapter or its handout at hand. Give numbers with their units.</p>\n\
         <ol>{asked}</ol></section>\n<section class=\"answers\"><h1>{title}: answers</h1>\n<ol>{answers}</ol>\n\
         <p class=\"for\">From {}, CC BY 4.0. The numbers are computed and checked by the book&#8217;s tests.</p></section>",
        escaped(&paper.about.title)
    );
    sheet::document(paper, &format!("{}: problems", page.title), "sheet", size, "", &body)
}

/// The questions that the chapter itself asks.
fn questions(paper: &Paper, page: &Page) -> Result<Vec<Problem>, String> {
    let answers = named(paper, "answers")?;
    let mut found = Vec::new();
    for question in page.body.iter().filter_map(Node::element).filter(|it| it.has_class("question")) {
        let id = question.get("id").unwrap_or_default();
        let answer = after(&answers.body, &format!("{id}-answer"))
            .ok_or_else(|| format!("the question {id} has no answer"))?;
        let asked = rewritten(question.children.clone(), &mut |element| on_sheet(element));
        found.push(Problem { asked, answer: plain(answer) });
    }
    Ok(found)
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

/// What a sheet shows of an element: no programs, and no links, since nothing leads on from paper.
fn on_sheet(element: Element) -> Vec<Node> {
    let dropped = ["program", "to-end", "summary"].iter().any(|class| element.has_class(class));
    match element.name.as_str() {
        _ if dropped => Vec::new(),
        "a" | "blockquote" => element.children,
        "h3" => vec![Element::new("h2", &[], element.children).into()],
        // Every problem has a number; that it is to be predicted need not be said.
        "strong" if element.text() == "Predict." => Vec::new(),
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
