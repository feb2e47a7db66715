//! Bodies from files: the data on a body that command lines, drawings and reports need.
//!
//! A [`BodyModel`] has a name, an inertia tensor for a [`tumbling::Body`], mass and centre as far as they are
//! known, and the surfaces to draw. It comes from the name of a body of the book, from a TOML file, or from a
//! link of a URDF file. A TOML file contains one of these:
//!
//! ```
//! use tumbling_bodies::BodyModel;
//! let model = |text: &str| BodyModel::from_toml(text, "examples".as_ref());
//! let phone = model("sides = [0.077, 0.0078, 0.16] # m, along x, y and z\nmass = 0.2 # kg")?;
//! assert_eq!(phone.mass, Some(0.2));
//! // Another solid; `density` (kg/m³; kg/m² of a plate or disk, kg/m of a rod) may stand for `mass`.
//! let coin = model("shape = 'cylinder'\nradius = 0.012\nheight = 0.002\ndensity = 8900")?;
//! assert_eq!(coin.moments()?[0], coin.moments()?[1]);
//! // Parts: each a body, at a place (m) and turned about an axis (x, y, z, degrees).
//! let hammer = model(
//!     "[[part]]\nshape = 'cylinder'\nradius = 0.0145\nheight = 0.29\ndensity = 680\nat = [0, 0, 0.145]\n\
//!      [[part]]\nsides = [0.1, 0.032, 0.032]\ndensity = 7850\nat = [0, 0, 0.306]\nturn = [0, 0, 1, 90]",
//! )?;
//! assert_eq!(hammer.surfaces.len(), 2);
//! // Moments (xx, yy, zz) and products (xy, xz, yz, signed so that L = I w) alone, kg m².
//! let satellite = model("moments = [0.04, 0.04, 0.007]\nproducts = [0, 1e-4, 0]")?;
//! assert_eq!(satellite.mass, None);
//!
//! let error = model("sides = [1, 2, 3]\nmass = -1").unwrap_err();
//! assert_eq!(error.to_string(), "line 2, `mass`: the mass is -1.0: it must be above zero");
//! # Ok::<(), tumbling_bodies::Error>(())
//! ```
//!
//! Other fields are `mesh = "part.stl"` (or `.obj`, next to the file; `unit = 0.001` for millimetres) with
//! `mass` or `density`, `urdf = "robot.urdf"` with `link = "arm"`, and `body = "hammer"` for a body of the
//! book or `body = "other.toml"` for another file. `sides` next to `moments` set only the box that is drawn.
//! `spin` (rad/s) is the speed in figures and films; without it, the speed follows from the size.
//!
//! The bodies of a scene are such tables too, with a spin of three numbers or a momentum, and an attitude
//! ([`Table`], [`SceneBodies`]).

mod document;
mod error;
mod file;
mod files;
mod mesh;
mod model;
mod named;
mod question;
mod shape;
mod surface;
mod table;
mod urdf;

pub use document::from_toml;
pub use error::Error;
pub use files::read_text;
pub use model::BodyModel;
pub use named::SceneBodies;
pub use surface::Surface;
pub use table::{Spin, Table, list};
