//! Scenes in TOML files.
//!
//! ```
//! let text = r#"
//! accuracy = 1e-9
//! span = 60.0                 # s
//! every = 0.5                 # s; or a list of times instead of the two: times = [0.0, 1.5]
//! wants = ["spin", "energy"]  # of spin, attitude, energy, angle-to-momentum, flips, polhode
//!
//! [[body]]
//! moments = [1.0, 2.0, 2.5]   # kg m², the diagonal of the tensor; products = [xy, xz, yz] where there are any
//! spin = [0.01, 10.0, 0.0]    # rad/s in body axes; or momentum = [...] in world axes, kg m²/s
//! attitude = [1, 0, 0, 0]     # body to world, scalar part first; may be left out
//!
//! [[torque]]                  # on every body; the README lists the kinds
//! damping = [0.1, 0.1, 0.1]   # N m s along the principal axes; all equal for a body with products
//!
//! [[torque]]
//! in-body = [0.0, 0.5, 0.0]   # N m
//! from = 10.0                 # s; any kind may have a time when it begins, and one when it ends
//! to = 12.5                   # s
//! "#;
//! let file = tumbling_scenes::file::read(&text).unwrap();
//! assert_eq!(file.scene.times().count(), 121);
//!
//! let error = tumbling_scenes::file::read(&text.replace("moments", "momets")).unwrap_err();
//! assert_eq!(error.to_string(), "line 8, `momets`: no such field. Did you mean `moments`?");
//! ```

mod fields;
mod read;
mod torque;
mod write;

pub use read::read;
pub use write::write;

use crate::error::{Error, Field};
use crate::scene::Scene;

/// A scene as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct File {
    /// The scene.
    pub scene: Scene,
    /// The place of each body.
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
    /// An error of this body as an [`Error::File`], at the line of the field where it is one.
    ///
    /// ```
    /// let scene = "accuracy = 1e-9\ntimes = [1]\nwants = []\n";
    /// let text = format!("{scene}[[body]]\nmoments = [1, 1, 3]\nspin = [0, 0, 1]\n");
    /// let file = tumbling_scenes::file::read(&text).unwrap();
    /// let error = file.scene.plan(0).unwrap_err();
    /// let error = file.bodies[0].error(&error).to_string();
    /// assert!(error.starts_with("line 5, `moments`: body 0: no body has principal moments"), "{error}");
    /// ```
    #[must_use]
    pub fn error(&self, error: &Error) -> Error {
        let names: &[&str] = match error.field() {
            None => &[],
            Some(Field::Moments) => &["moments"],
            Some(Field::Products) => &["products", "moments"],
            Some(Field::Attitude) => &["attitude"],
            Some(Field::Spin) => &["spin"],
            Some(Field::Momentum) => &["momentum"],
        };
        let found = names.iter().find_map(|name| self.fields.iter().find(|(field, _)| field == name));
        Error::File {
            line: Some(found.map_or(self.line, |&(_, line)| line)),
            field: found.map(|(name, _)| (*name).to_owned()),
            why: error.to_string(),
        }
    }
}

const SCENE: [&str; 7] = ["accuracy", "span", "every", "times", "wants", "body", "torque"];
const BODY: [&str; 5] = ["moments", "products", "attitude", "spin", "momentum"];
const OUTPUTS: [&str; 6] = ["spin", "attitude", "energy", "angle-to-momentum", "flips", "polhode"];
