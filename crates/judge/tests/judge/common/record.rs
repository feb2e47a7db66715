//! What engines did to a body, as recorded in `crates/engines/data`.

use nalgebra::Vector3;
use tumbling::step::{State, System, Torque};
pub use tumbling_engines::RecordedRow as Row;
use tumbling_engines::{PHYSICS_ENGINES, PhysicsEngine, RECORDED, Trajectory};

/// The step of all records, s.
pub const H: f64 = 1.0 / 60.0;

/// The engine of a record's name.
pub fn engine(record: &str) -> &'static PhysicsEngine {
    PHYSICS_ENGINES.iter().find(|engine| engine.record == Some(record)).unwrap()
}

/// The step at which a recorded body was put back to rest, if it was.
pub fn reset(record: &str, story: &str) -> Option<usize> {
    let steps = [("major", 336), ("minor", 795), ("fast", 20), ("wound", 12)];
    let euler = record == "mujoco-4.0.0-euler";
    steps.into_iter().find(|(name, _)| euler && *name == story).map(|(_, step)| step)
}

pub struct Record {
    pub system: System<f64>,
    pub rows: Vec<Row>,
}

impl Record {
    pub fn read(engine: &str, story: &str) -> Self {
        let run = RECORDED.iter().find(|run| (run.engine, run.story) == (engine, story));
        let Trajectory { moments, torque, rows } = run.unwrap().read().unwrap();
        let torques = if torque == Vector3::zeros() { Vec::new() } else { vec![Torque::InWorld(torque)] };
        Self { system: System::with(moments.try_into().unwrap(), torques).unwrap(), rows }
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
