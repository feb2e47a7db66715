//! Scenes in TOML files.
//!
//! ```
//! let text = r#"
//! accuracy = 1e-9
//! span = 60.0                 # s
//! every = 0.5                 # s; or a list of times instead of the two: times = [0.0, 1.5]
//! wants = ["spin", "energy"]  # of spin, attitude, energy, gap, flips, polhode
//!
//! [[body]]
//! moments = [1.0, 2.0, 2.5]   # kg m², the diagonal of the tensor; products = [xy, xz, yz] where there are any
//! spin = [0.01, 10.0, 0.0]    # rad/s in body axes; or momentum = [...] in world axes, kg m²/s
//! attitude = [1, 0, 0, 0]     # body to world, scalar part first; may be left out
//!
//! [[torque]]                  # on every body; or in-body, in-world (N m), arm and field, dissipation
//! damping = [0.1, 0.1, 0.1]   # N m s along the principal axes; all alike for a body with products
//! "#;
//! let file = tumbling_scenes::file::read(text).unwrap();
//! assert_eq!(file.scene.times().count(), 121);
//!
//! let wrong = tumbling_scenes::file::read(&text.replace("moments", "momets")).unwrap_err();
//! assert_eq!(wrong.to_string(), "line 8, `momets`: no such field. Did you mean `moments`?");
//! ```

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::fmt::{self, Write as _};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use tumbling::scene::{LetGo, Scene, Times, Toss, TossPart, Wants};
use tumbling::step::Torque;
use tumbling::{Error, Refusal};

/// What is wrong with a file, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Wrong {
    /// The line, from 1; none where the whole file is meant.
    pub line: Option<usize>,
    /// The field, where it is one.
    pub field: Option<String>,
    /// What is wrong, and what was expected.
    pub why: String,
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.line, &self.field) {
            (Some(line), Some(field)) => write!(f, "line {line}, `{field}`: {}", self.why),
            (Some(line), None) => write!(f, "line {line}: {}", self.why),
            (None, Some(field)) => write!(f, "`{field}`: {}", self.why),
            (None, None) => f.write_str(&self.why),
        }
    }
}

impl std::error::Error for Wrong {}

/// A scene as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct File {
    /// The scene.
    pub scene: Scene,
    /// Where each body stands.
    pub bodies: Vec<Place>,
}

/// The lines of a body and its fields, from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Where the body begins.
    pub line: usize,
    /// Of its fields, those that it has.
    pub fields: Vec<(&'static str, usize)>,
}

impl Place {
    /// What is wrong with a body, at the field that is meant if it is one.
    ///
    /// ```
    /// let text = "accuracy = 1e-9\ntimes = [1]\nwants = []\n[[body]]\nmoments = [1, 1, 3]\nspin = [0, 0, 1]\n";
    /// let file = tumbling_scenes::file::read(text).unwrap();
    /// let error = file.scene.plan(0).unwrap_err();
    /// let wrong = file.bodies[0].wrong(&file.scene.bodies()[0], &error).to_string();
    /// assert!(wrong.starts_with("line 5, `moments`: body 0: no body has principal moments"), "{wrong}");
    /// ```
    #[must_use]
    pub fn wrong(&self, toss: &Toss, error: &Error) -> Wrong {
        let fields: &[&str] = match toss.fault() {
            None => &[],
            Some((TossPart::Moments, _)) => &["moments"],
            Some((TossPart::Products, _)) => &["products", "moments"],
            Some((TossPart::Attitude, _)) => &["attitude"],
            Some((TossPart::Start, _)) => &["spin", "momentum"],
        };
        let found = fields.iter().find_map(|name| self.fields.iter().find(|(field, _)| field == name));
        Wrong {
            line: Some(found.map_or(self.line, |&(_, line)| line)),
            field: found.map(|(name, _)| (*name).to_owned()),
            why: error.to_string(),
        }
    }
}

const SCENE: [&str; 7] = ["accuracy", "span", "every", "times", "wants", "body", "torque"];
const BODY: [&str; 5] = ["moments", "products", "attitude", "spin", "momentum"];
const TORQUE: [&str; 6] = ["in-body", "in-world", "arm", "field", "damping", "dissipation"];
const WANTS: [&str; 6] = ["spin", "attitude", "energy", "gap", "flips", "polhode"];

/// Where each line begins, in bytes.
struct Lines(Vec<usize>);

impl Lines {
    fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n');
        Self(std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect())
    }

    fn at(&self, span: &Range<usize>) -> usize {
        self.0.partition_point(|&start| start <= span.start)
    }

    fn wrong(&self, span: &Range<usize>, field: &str, why: impl Into<String>) -> Wrong {
        Wrong { line: Some(self.at(span)), field: Some(field.to_owned()), why: why.into() }
    }
}

/// A table whose fields are all known.
struct Fields<'a, 'i> {
    lines: &'a Lines,
    table: &'a DeTable<'i>,
    span: Range<usize>,
}

impl<'a, 'i> Fields<'a, 'i> {
    fn new(
        lines: &'a Lines,
        table: &'a DeTable<'i>,
        span: Range<usize>,
        known: &[&str],
    ) -> Result<Self, Wrong> {
        for key in table.keys() {
            let name = key.get_ref().as_ref();
            if !known.contains(&name) {
                return Err(lines.wrong(
                    &key.span(),
                    name,
                    format!("no such field.{}", nearest(name, known)),
                ));
            }
        }
        Ok(Self { lines, table, span })
    }

    fn get(&self, name: &str) -> Option<&'a Spanned<DeValue<'i>>> {
        self.table.iter().find(|(key, _)| key.get_ref().as_ref() == name).map(|(_, value)| value)
    }

    /// What the library says of a field's value.
    fn refused(&self, name: &str, error: &Error) -> Wrong {
        let span = self.get(name).map_or_else(|| self.span.clone(), Spanned::span);
        self.lines.wrong(&span, name, error.to_string())
    }

    fn missing(&self, what: &str) -> Wrong {
        // Of the file itself no line is to blame.
        let line = (self.span.start > 0).then(|| self.lines.at(&self.span));
        Wrong { line, field: None, why: format!("{what} is missing") }
    }

    /// Of two fields that go together the one that is there.
    fn alone(&self, there: &str, missing: &str) -> Wrong {
        let span = self.get(there).map_or_else(|| self.span.clone(), Spanned::span);
        self.lines.wrong(&span, there, format!("beside it {missing} is missing"))
    }

    fn expected(&self, name: &str, value: &Spanned<DeValue<'_>>, expected: &str) -> Wrong {
        let kind = value.get_ref().type_str();
        self.lines.wrong(
            &value.span(),
            name,
            format!("{expected} is expected here, not a value of type {kind}"),
        )
    }

    fn number_of(&self, name: &str, value: &Spanned<DeValue<'_>>) -> Result<f64, Wrong> {
        let text = match value.get_ref() {
            DeValue::Float(number) => number.as_str(),
            DeValue::Integer(number) if number.radix() == 10 => number.as_str(),
            _ => return Err(self.expected(name, value, "a number")),
        };
        let plain = text.replace('_', "");
        let number: f64 = plain.parse().map_err(|_| self.expected(name, value, "a number"))?;
        let mantissa = plain.split(['e', 'E']).next().unwrap_or_default();
        if !number.is_finite() {
            let why = format!("{text} is no finite number that can be computed with");
            return Err(self.lines.wrong(&value.span(), name, why));
        }
        if number == 0.0 && mantissa.contains(|digit| matches!(digit, '1'..='9')) {
            let why = format!("{text} is closer to zero than any number that can be computed with");
            return Err(self.lines.wrong(&value.span(), name, why));
        }
        Ok(number)
    }

    fn number(&self, name: &str) -> Result<Option<f64>, Wrong> {
        self.get(name).map(|value| self.number_of(name, value)).transpose()
    }

    fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, Wrong> {
        let Some(value) = self.get(name) else { return Ok(None) };
        let DeValue::Array(list) = value.get_ref() else {
            return Err(self.expected(name, value, "a list of numbers"));
        };
        list.iter().map(|item| self.number_of(name, item)).collect::<Result<_, _>>().map(Some)
    }

    fn exactly<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, Wrong> {
        let Some(numbers) = self.numbers(name)? else { return Ok(None) };
        let count = numbers.len();
        numbers.try_into().map(Some).map_err(|_| {
            let span = self.get(name).map_or(0..0, Spanned::span);
            self.lines.wrong(&span, name, format!("{N} numbers are expected here, not {count}"))
        })
    }

    fn vector(&self, name: &str) -> Result<Option<Vector3<f64>>, Wrong> {
        Ok(self.exactly::<3>(name)?.map(Vector3::from))
    }

    /// The tables of a list, with where each begins.
    fn tables(&self, name: &str, known: &[&str]) -> Result<Vec<Fields<'a, 'i>>, Wrong> {
        let Some(value) = self.get(name) else { return Ok(Vec::new()) };
        let wrong =
            || self.expected(name, value, &format!("a list of tables, `[[{name}]]` at the head of each,"));
        let DeValue::Array(list) = value.get_ref() else { return Err(wrong()) };
        list.iter()
            .map(|item| match item.get_ref() {
                DeValue::Table(table) => Fields::new(self.lines, table, item.span(), known),
                _ => Err(wrong()),
            })
            .collect()
    }
}

/// What others call what is meant here.
const ELSEWHERE: [(&str, &str); 16] = [
    ("omega", "spin"),
    ("angular_velocity", "spin"),
    ("w", "spin"),
    ("inertia", "moments"),
    ("tensor", "moments"),
    ("angular_momentum", "momentum"),
    ("quaternion", "attitude"),
    ("orientation", "attitude"),
    ("rotation", "attitude"),
    ("dt", "every"),
    ("step", "every"),
    ("duration", "span"),
    ("end", "span"),
    ("tolerance", "accuracy"),
    ("drag", "damping"),
    ("gravity", "field"),
];

fn nearest(name: &str, known: &[&str]) -> String {
    let lower = name.to_lowercase();
    let meant = ELSEWHERE.iter().find(|(word, meant)| *word == lower && known.contains(meant));
    if let Some((_, meant)) = meant {
        return format!(" Did you mean `{meant}`?");
    }
    let best = known
        .iter()
        .map(|known| (strsim::normalized_damerau_levenshtein(name, known), known))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    match best {
        Some((likeness, name)) if likeness >= 0.6 => format!(" Did you mean `{name}`?"),
        _ => format!(" There are `{}`.", known.join("`, `")),
    }
}

/// A scene from the text of a file.
///
/// # Errors
/// The line and the field that are wrong, and what was expected. What is wrong with a body alone is said when it is planned.
pub fn read(text: &str) -> Result<File, Wrong> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = Lines::of(text);
    let root = DeTable::parse(text).map_err(|error| Wrong {
        line: error.span().map(|span| lines.at(&span)),
        field: None,
        why: error.message().to_owned(),
    })?;
    let root = Fields::new(&lines, root.get_ref(), 0..0, &SCENE)?;
    let accuracy = root.number("accuracy")?.ok_or_else(|| root.missing("the field `accuracy`"))?;
    let times = times(&root)?;
    let wants = wants(&root)?;
    let bodies = root.tables("body", &BODY)?;
    if bodies.is_empty() {
        return Err(root.missing("a body, `[[body]]`,"));
    }
    let tosses = bodies.iter().map(toss).collect::<Result<_, _>>()?;
    let torque_tables = root.tables("torque", &TORQUE)?;
    let torques = torque_tables.iter().map(torque).collect::<Result<_, _>>()?;
    times.validate().map_err(|error| {
        let field = match &times {
            Times::Given(_) => "times",
            Times::Every { span, .. } if *span < 0.0 => "span",
            Times::Every { .. } => "every",
        };
        root.refused(field, &error)
    })?;
    let scene =
        Scene::new(tosses, torques, times, wants, accuracy).map_err(|error| match error.refusal() {
            Refusal::OfTorque { index, source } => match torque_tables.get(*index) {
                Some(table) => {
                    let field = TORQUE.into_iter().find(|field| table.get(field).is_some());
                    table.refused(field.unwrap_or_default(), source)
                }
                None => Wrong { line: None, field: None, why: source.to_string() },
            },
            // Bodies and times are there and right: this is all that is left.
            _ => root.refused("accuracy", &error),
        })?;
    let place = |body: &Fields<'_, '_>| Place {
        line: lines.at(&body.span),
        fields: BODY.into_iter().filter_map(|name| Some((name, lines.at(&body.get(name)?.span())))).collect(),
    };
    Ok(File { scene, bodies: bodies.iter().map(place).collect() })
}

fn times(root: &Fields<'_, '_>) -> Result<Times, Wrong> {
    match (root.numbers("times")?, root.number("every")?, root.number("span")?) {
        (Some(times), None, None) => Ok(Times::Given(times)),
        (None, Some(step), Some(span)) => Ok(Times::Every { step, span }),
        (Some(_), _, _) => {
            let span = root.get("times").map_or(0..0, Spanned::span);
            Err(root.lines.wrong(
                &span,
                "times",
                "either `times` or `every` and `span` are expected, not both",
            ))
        }
        (None, None, Some(_)) => Err(root.alone("span", "`every`")),
        (None, Some(_), None) => Err(root.alone("every", "`span`")),
        (None, None, None) => Err(root.missing("`every` and `span`, or `times`,")),
    }
}

fn wants(root: &Fields<'_, '_>) -> Result<Wants, Wrong> {
    let value = root.get("wants").ok_or_else(|| root.missing("the field `wants`"))?;
    let DeValue::Array(list) = value.get_ref() else {
        return Err(root.expected("wants", value, "a list of words"));
    };
    let mut wants = Wants::NOTHING;
    for item in list.iter() {
        let DeValue::String(word) = item.get_ref() else {
            return Err(root.expected("wants", item, "a word"));
        };
        let asked = match word.as_ref() {
            "spin" => &mut wants.spin,
            "attitude" => &mut wants.attitude,
            "energy" => &mut wants.energy,
            "gap" => &mut wants.gap,
            "flips" => &mut wants.flips,
            "polhode" => &mut wants.polhode,
            other => {
                let why = format!("`{other}` cannot be asked for.{}", nearest(other, &WANTS));
                return Err(root.lines.wrong(&item.span(), "wants", why));
            }
        };
        *asked = true;
    }
    Ok(wants)
}

fn toss(body: &Fields<'_, '_>) -> Result<Toss, Wrong> {
    let moments = body.vector("moments")?.ok_or_else(|| body.missing("of this body the field `moments`"))?;
    let products = body.vector("products")?.unwrap_or_else(Vector3::zeros);
    let [w, x, y, z] = body.exactly::<4>("attitude")?.unwrap_or([1.0, 0.0, 0.0, 0.0]);
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    let with = match (body.vector("spin")?, body.vector("momentum")?) {
        (Some(spin), None) => LetGo::Spin(spin),
        (None, Some(momentum)) => LetGo::Momentum(momentum),
        (None, None) => return Err(body.missing("of this body `spin` or `momentum`")),
        (Some(_), Some(_)) => {
            let span = body.get("momentum").map_or(0..0, Spanned::span);
            return Err(body.lines.wrong(
                &span,
                "momentum",
                "either `spin` or `momentum` is expected, not both",
            ));
        }
    };
    Ok(Toss { moments, products, attitude, with })
}

fn torque(torque: &Fields<'_, '_>) -> Result<Torque<f64>, Wrong> {
    let found = [
        torque.vector("in-body")?.map(Torque::InBody),
        torque.vector("in-world")?.map(Torque::InWorld),
        match (torque.vector("arm")?, torque.vector("field")?) {
            (Some(arm), Some(field)) => Some(Torque::Aligning { arm, field }),
            (None, None) => None,
            (Some(_), None) => return Err(torque.alone("arm", "`field` (N)")),
            (None, Some(_)) => return Err(torque.alone("field", "`arm` (m)")),
        },
        torque.vector("damping")?.map(Torque::Damping),
        torque.number("dissipation")?.map(Torque::Dissipation),
    ];
    let mut found = found.into_iter().flatten();
    match (found.next(), found.next()) {
        (Some(one), None) => Ok(one),
        (None, _) => Err(torque.missing(
            "what this torque is: `in-body`, `in-world`, `arm` and `field`, `damping` or `dissipation`",
        )),
        (Some(_), Some(_)) => Err(Wrong {
            line: Some(torque.lines.at(&torque.span)),
            field: Some("torque".into()),
            why: "one kind of torque is expected in each `[[torque]]`, not two".into(),
        }),
    }
}

/// A number that reads back to the bit.
fn number(x: f64) -> String {
    format!("{x:?}")
}

fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().copied().map(number).collect();
    format!("[{}]", numbers.join(", "))
}

/// The text of a file that holds the scene: [`read`] gives it back to the bit. A body whose numbers are not all finite is written
/// as it is, and refused by [`read`].
#[must_use]
pub fn write(scene: &Scene) -> String {
    let mut text = format!("accuracy = {}\n", number(scene.accuracy()));
    let _ = match scene.times() {
        Times::Given(times) => writeln!(text, "times = {} # s", list(times)),
        Times::Every { step, span } => {
            writeln!(text, "span = {} # s\nevery = {} # s", number(*span), number(*step))
        }
    };
    let wants = scene.wants();
    let asked = [wants.spin, wants.attitude, wants.energy, wants.gap, wants.flips, wants.polhode];
    let words: Vec<String> =
        WANTS.iter().zip(asked).filter(|(_, asked)| *asked).map(|(word, _)| format!("\"{word}\"")).collect();
    let _ = writeln!(text, "wants = [{}]", words.join(", "));
    for body in scene.bodies() {
        let _ = writeln!(text, "\n[[body]]\nmoments = {} # kg m²", list(body.moments.as_slice()));
        if body.products.iter().any(|product| product.to_bits() != 0) {
            let _ = writeln!(text, "products = {} # kg m²", list(body.products.as_slice()));
        }
        let q = body.attitude.quaternion();
        let _ = writeln!(text, "attitude = {}", list(&[q.w, q.i, q.j, q.k]));
        let _ = match &body.with {
            LetGo::Spin(spin) => writeln!(text, "spin = {} # rad/s, body axes", list(spin.as_slice())),
            LetGo::Momentum(momentum) => {
                writeln!(text, "momentum = {} # kg m²/s, world axes", list(momentum.as_slice()))
            }
        };
    }
    for torque in scene.torques() {
        let _ = text.write_str("\n[[torque]]\n");
        let _ = match torque {
            Torque::InBody(value) => writeln!(text, "in-body = {} # N m", list(value.as_slice())),
            Torque::InWorld(value) => writeln!(text, "in-world = {} # N m", list(value.as_slice())),
            Torque::Aligning { arm, field } => {
                writeln!(text, "arm = {}\nfield = {}", list(arm.as_slice()), list(field.as_slice()))
            }
            Torque::Damping(value) => writeln!(text, "damping = {} # N m s", list(value.as_slice())),
            Torque::Dissipation(strength) => {
                writeln!(text, "dissipation = {} # s/(kg m²)", number(*strength))
            }
            // The library may know more kinds one day; the test of round trips names all there are.
            _ => writeln!(text, "# a torque that files do not have yet: {torque:?}"),
        };
    }
    text
}
