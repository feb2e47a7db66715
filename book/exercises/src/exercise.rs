//! One exercise, read from its file.

use std::fs;
use std::path::Path;

/// The line above the place that the reader fills.
pub const BEGIN: &str = "// -- your turn --";

/// The line below it.
pub const END: &str = "// -- until here --";

/// An exercise.
#[derive(Debug, Clone)]
pub struct Exercise {
    /// The chapter's name and a number: `two_arrows_1`.
    pub name: String,
    /// Its heading.
    pub title: String,
    /// The task, in Markdown.
    pub task: String,
    /// The code above the place left open, with the line that marks it.
    before: String,
    /// What stands in the place until it is filled: one or more `todo!`.
    open: String,
    /// The code below the place, with the line that marks it.
    after: String,
    /// Hints in Markdown, each telling more than the one before.
    pub hints: Vec<String>,
    /// Words about the solution, in Markdown; may be empty.
    pub words: String,
    /// What to put into the place.
    solution: String,
    /// Answers that must be refused.
    pub wrong: Vec<Wrong>,
}

/// An answer that must be refused.
#[derive(Debug, Clone)]
pub struct Wrong {
    /// What is wrong with it.
    pub what: String,
    /// What it puts into the place.
    code: String,
}

impl Exercise {
    /// Reads the text of `whole/NAME.md`.
    ///
    /// # Errors
    /// What is missing or stands in the wrong place, with its line.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        let fault = |line: usize, what: &str| format!("book/exercises/whole/{name}.md:{line}: {what}");
        let sections = sections(text);
        let (first, rest) = sections.split_first().ok_or_else(|| fault(1, "the file is empty"))?;
        let mut exercise = Self::parse_task(name, first).map_err(|what| fault(first.line, what))?;
        for section in rest {
            exercise.add(section).map_err(|what| fault(section.line, what))?;
        }
        exercise.whole().map_err(|what| fault(1, what))?;
        Ok(exercise)
    }

    /// The task, with nothing about its answer.
    fn parse_task(name: &str, first: &Section) -> Result<Self, &'static str> {
        let title = first.heading.strip_prefix("# ").ok_or("begin with `# TITLE`")?;
        let (task, code, rest) = first.code()?;
        if !rest.trim().is_empty() {
            return Err("the block is the last of the task");
        }
        let (before, open, after) = parted(&code)
            .ok_or("the block has the two lines that mark the place left open, once, in this order")?;
        if !open.contains("todo!(\"") || before.contains("todo!") || after.contains("todo!") {
            return Err("what is left open is a `todo!(\"what to write\")` between the two lines");
        }
        Ok(Self {
            name: name.into(),
            title: title.trim().into(),
            task,
            before,
            open,
            after,
            hints: Vec::new(),
            words: String::new(),
            solution: String::new(),
            wrong: Vec::new(),
        })
    }

    /// A hint, the solution or a wrong answer.
    fn add(&mut self, section: &Section) -> Result<(), &'static str> {
        let answer = || -> Result<(String, String), &'static str> {
            let (words, code, _) = section.code()?;
            let empty = code.trim().is_empty();
            if empty || code.contains("todo!") || code.contains(BEGIN) || code.contains(END) {
                return Err("an answer is what stands between the two lines");
            }
            Ok((words, code))
        };
        let solved = !self.solution.is_empty();
        match section.heading.trim() {
            "## Hint" if !solved => self.hints.push(section.body.trim().into()),
            "## Solution" if !solved => (self.words, self.solution) = answer()?,
            heading => match heading.strip_prefix("## Wrong: ") {
                Some(what) if solved => self.wrong.push(Wrong { what: what.into(), code: answer()?.1 }),
                _ => return Err("after the task come `## Hint`, `## Solution`, `## Wrong: WHY`"),
            },
        }
        Ok(())
    }

    /// Whether it has all that an exercise has.
    fn whole(&self) -> Result<(), &'static str> {
        let missing = [
            (self.task.is_empty(), "an exercise says what is asked"),
            (self.hints.is_empty(), "an exercise has a `## Hint`"),
            (self.solution.is_empty(), "an exercise has a `## Solution`"),
            (self.wrong.is_empty(), "an exercise has a `## Wrong: WHY`, to show what its assertions refuse"),
        ];
        missing.into_iter().find(|(missing, _)| *missing).map_or(Ok(()), |(_, what)| Err(what))
    }

    /// The chapter's name and the exercise's number.
    #[must_use]
    pub fn place(&self) -> (String, &str) {
        let (chapter, number) = self.name.rsplit_once('_').unwrap_or((&self.name, ""));
        (chapter.replace('_', "-"), number)
    }

    /// The command that runs it.
    #[must_use]
    pub fn command(&self) -> String {
        format!("cargo exercise {}", self.name)
    }

    /// The block with its place left open.
    #[must_use]
    pub fn open(&self) -> String {
        self.with(&self.open)
    }

    /// The block, solved.
    #[must_use]
    pub fn solved(&self) -> String {
        self.with(&self.indented(&self.solution))
    }

    /// The block, answered like this.
    #[must_use]
    pub fn answered(&self, wrong: &Wrong) -> String {
        self.with(&self.indented(&wrong.code))
    }

    /// What the solution puts into the place.
    #[must_use]
    pub fn solution(&self) -> &str {
        &self.solution
    }

    /// The file that the reader edits, untouched. Its block is a program of its own: one that does not
    /// compile is no hindrance to another.
    #[must_use]
    pub fn stub(&self) -> String {
        let (chapter, number) = self.place();
        format!(
            "# {}\n\n{}\n\nFill the place between the two marks, then run `{}`. It fails until you are right.\n\n\
             ```rust,standalone_crate\n{}```\n\n\
             Hints and a solution fold out in the book: exercise {number} at the end of `{chapter}`.\n",
            self.title,
            self.task,
            self.command(),
            self.open()
        )
    }

    fn with(&self, place: &str) -> String {
        format!("{}{place}{}", self.before, self.after)
    }

    /// An answer, moved in as far as its place is.
    fn indented(&self, answer: &str) -> String {
        let mark = self.before.lines().last().unwrap_or_default();
        let indent = &mark[..mark.len() - mark.trim_start().len()];
        let line = |line: &str| if line.is_empty() { "\n".into() } else { format!("{indent}{line}\n") };
        answer.lines().map(line).collect()
    }
}

/// All exercises of this folder, by name.
///
/// # Errors
/// What cannot be read.
pub(crate) fn read_all(folder: &Path) -> Result<Vec<Exercise>, String> {
    let cannot = |e: std::io::Error| format!("cannot read {}: {e}", folder.display());
    let mut exercises = Vec::new();
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if let Some(name) = path.file_name().and_then(|file| file.to_str()?.strip_suffix(".md")) {
            let text = fs::read_to_string(&path).map_err(cannot)?;
            exercises.push(Exercise::read(name, &text.replace("\r\n", "\n"))?);
        }
    }
    exercises.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(exercises)
}

/// A heading and what stands below it.
struct Section {
    heading: String,
    body: String,
    line: usize,
}

impl Section {
    /// What stands before the only Rust block, the block's lines, and what stands after it.
    fn code(&self) -> Result<(String, String, String), &'static str> {
        let wrong = "one block begins with ```rust and ends with ```";
        let (words, rest) = self.body.split_once("```rust\n").ok_or(wrong)?;
        let (code, rest) = rest.split_once("```\n").ok_or(wrong)?;
        if rest.contains("```") || words.contains("```") {
            Err(wrong)
        } else {
            Ok((words.trim().into(), code.into(), rest.into()))
        }
    }
}

/// The text, cut at the headings that stand outside of blocks.
fn sections(text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    let mut in_block = false;
    for (at, line) in text.lines().enumerate() {
        if line.starts_with("```") {
            in_block = !in_block;
        }
        let heading = !in_block && (line.starts_with("# ") || line.starts_with("## "));
        match sections.last_mut() {
            Some(section) if !heading => {
                section.body.push_str(line);
                section.body.push('\n');
            }
            _ => sections.push(Section { heading: line.into(), body: String::new(), line: at + 1 }),
        }
    }
    sections
}

/// The code up to the place, the place, and the code after it.
fn parted(code: &str) -> Option<(String, String, String)> {
    let lines: Vec<&str> = code.split_inclusive('\n').collect();
    let marks = |mark: &str| -> Vec<usize> {
        lines.iter().enumerate().filter(|(_, line)| line.trim() == mark).map(|(at, _)| at).collect()
    };
    let (begin, end) = match (marks(BEGIN).as_slice(), marks(END).as_slice()) {
        ([begin], [end]) => (*begin, *end),
        _ => return None,
    };
    (begin < end).then(|| (lines[..=begin].concat(), lines[begin + 1..end].concat(), lines[end..].concat()))
}
