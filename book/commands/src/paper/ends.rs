//! The pages at the end of a book on paper: answers to questions, hints and solutions.

use super::page::{Page, opened};
use super::tree::{Element, Node};
use std::{iter, mem};

/// The folds that move to the end, by how their words begin.
const MOVED: [&str; 3] = ["Hint", "Solution", "Answer"];

/// The pages at the end, and their titles.
const ANSWERS: (&str, &str) = ("answers", "Answers to the questions");
const SOLUTIONS: (&str, &str) = ("solutions", "Hints and solutions");

/// The contents taken from the pages so far.
#[derive(Debug, Default)]
pub(super) struct Ends {
    answers: Vec<Node>,
    solutions: Vec<Node>,
}

impl Ends {
    /// Takes from a page what belongs at the end, and leaves links to it there.
    pub(super) fn take(&mut self, page: &str, title: &str, body: Vec<Node>) -> Vec<Node> {
        let (answers, solutions) = (self.answers.len(), self.solutions.len());
        let mut out = Vec::new();
        let mut heading: Option<(String, Vec<Node>)> = None;
        for node in body {
            let Node::Element(mut element) = node else {
                out.push(node);
                continue;
            };
            if ["h2", "h3"].contains(&element.name.as_str()) {
                heading = element.get("id").map(|id| (id.to_owned(), element.children.clone()));
            }
            if element.has_class("question") {
                self.answers.extend(answer(page, &mut element));
                out.push(element.into());
            } else if element.name == "details" {
                match heading.as_ref().filter(|_| is_moved(&element)) {
                    Some((id, words)) => {
                        out.extend(self.solution(page, id, words, element).map(Node::from));
                    }
                    None => out.push(opened(element, "program")),
                }
            } else {
                out.push(element.into());
            }
        }
        for (nodes, from) in [(&mut self.answers, answers), (&mut self.solutions, solutions)] {
            if nodes.len() > from {
                nodes.insert(from, chapter_heading(page, title));
            }
        }
        out
    }

    /// Keeps a hint or a solution; returns the link to it if it is the first of its exercise.
    fn solution(&mut self, page: &str, id: &str, words: &[Node], fold: Element) -> Option<Element> {
        let place = format!("{page}-{id}");
        let known = self.solutions.iter().filter_map(Node::element);
        let is_new = known.filter_map(|element| element.get("id")).all(|id| id != place);
        if is_new {
            let back = link(&format!("{page}.html#{id}"), words.to_vec());
            self.solutions.push(Element::new("h3", &[("id", &place)], vec![back]).into());
        }
        let only_answer = summary(&fold).starts_with("Answer");
        let told = if only_answer { "Answer" } else { "Hints and solution" };
        self.solutions.push(opened(fold, "told"));
        is_new.then(|| to_end(&format!("{}.html#{place}", SOLUTIONS.0), told))
    }

    /// The pages at the end.
    pub(super) fn pages(self) -> Vec<Page> {
        let made = [(ANSWERS, self.answers), (SOLUTIONS, self.solutions)].map(|((name, title), nodes)| {
            let heading = Element::new("h1", &[("id", name)], vec![Node::Text(title.into())]);
            let body = iter::once(heading.into()).chain(nodes).collect();
            Page { name: name.into(), title: title.into(), number: None, body }
        });
        made.into_iter().filter(|page| page.body.len() > 1).collect()
    }
}

fn summary(fold: &Element) -> String {
    let summary = fold.children.iter().filter_map(Node::element).find(|element| element.name == "summary");
    summary.map_or_else(String::new, Element::text)
}

fn is_moved(fold: &Element) -> bool {
    let words = summary(fold);
    MOVED.iter().any(|moved| words.starts_with(moved))
}

fn chapter_heading(page: &str, title: &str) -> Node {
    let back = link(&format!("{page}.html"), vec![Node::Text(title.to_owned())]);
    Element::new("h2", &[("id", &format!("of-{page}"))], vec![back]).into()
}

fn link(target: &str, words: Vec<Node>) -> Node {
    Element::new("a", &[("href", target)], words).into()
}

/// A line that leads to the end.
fn to_end(target: &str, words: &str) -> Element {
    Element::new("p", &[("class", "to-end")], vec![link(target, vec![Node::Text(words.into())])])
}

/// Removes the answer from a question; the question is repeated before the answer at the end.
fn answer(page: &str, question: &mut Element) -> Vec<Node> {
    let Some(id) = question.get("id").map(str::to_owned) else { return Vec::new() };
    let quote = question.children.iter_mut().find_map(|node| match node {
        Node::Element(element) if element.name == "blockquote" => Some(element),
        _ => None,
    });
    let Some(quote) = quote else { return Vec::new() };
    let Some(at) = quote.children.iter().rposition(|node| node.is("p")) else { return Vec::new() };
    let asked = quote.children.iter().find(|node| node.is("p")).cloned();
    let place = format!("{id}-answer");
    let there = to_end(&format!("{}.html#{place}", ANSWERS.0), "Answer").into();
    let told = mem::replace(&mut quote.children[at], there);
    let Some(Node::Element(mut asked)) = asked else { return Vec::new() };
    asked.children = vec![link(&format!("{page}.html#{id}"), asked.children)];
    asked.set("id", &place);
    asked.set("class", "asked");
    vec![asked.into(), told]
}
