//! What engines did to a body, as recorded in `crates/judge/data`.

use nalgebra::{Quaternion, Vector3};
use std::path::PathBuf;
use tumbling::step::{State, System, Torque};

/// The step of all records, s.
pub const H: f64 = 1.0 / 60.0;

pub struct Row {
    /// How many steps after the start.
    pub step: usize,
    /// Body to world.
    pub attitude: Quaternion<f64>,
    /// In body axes.
    pub omega: Vector3<f64>,
}

pub struct Record {
    pub system: System<f64>,
    pub rows: Vec<Row>,
}

impl Record {
    pub fn read(engine: &str, story: &str) -> Self {
        let name = format!("{engine}--{story}.csv");
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data").join(&name);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let after = |word: &str| -> Vector3<f64> {
            let rest = text.lines().next().unwrap().split(word).nth(1).unwrap();
            let numbers: Vec<f64> = rest.split_whitespace().take(3).map(|x| x.parse().unwrap()).collect();
            Vector3::new(numbers[0], numbers[1], numbers[2])
        };
        let torque = after("torque");
        let torques = if torque == Vector3::zeros() { Vec::new() } else { vec![Torque::InWorld(torque)] };
        let row = |line: &str| {
            let x: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            assert_eq!(x.len(), 8, "{name}: {line}");
            let step = x[0] as usize;
            Row {
                step,
                attitude: Quaternion::new(x[1], x[2], x[3], x[4]),
                omega: Vector3::new(x[5], x[6], x[7]),
            }
        };
        let rows: Vec<Row> = text.lines().skip(2).map(row).collect();
        Self { system: System::with(after("moments").try_into().unwrap(), torques).unwrap(), rows }
    }

    pub fn motion(&self, row: &Row) -> State<f64> {
        State { attitude: row.attitude, momentum: self.system.momentum(&row.omega) }
    }

    /// Rows that follow one another, and whether the second is of a body put back to rest.
    pub fn pairs(&self) -> impl Iterator<Item = (&Row, &Row, bool)> {
        let next = |w: &[Row]| w[0].step + 1 == w[1].step;
        self.rows.windows(2).filter(move |w| next(w)).map(|w| {
            let reset = w[0].omega != Vector3::zeros() && w[1].omega == Vector3::zeros();
            (&w[0], &w[1], reset)
        })
    }
}
