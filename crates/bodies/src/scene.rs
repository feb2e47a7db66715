//! The bodies of a scene's file.

use crate::error::Error;
use crate::file;
use crate::files::{Files, Left};
use crate::table::Table;
use std::path::Path;
use toml::Spanned;

/// Makes bodies of the tables of one text: what their files hold is counted together.
#[derive(Debug)]
pub struct SceneBodies<'a> {
    text: &'a str,
    folder: &'a Path,
    left: Left,
}

impl<'a> SceneBodies<'a> {
    /// Of tables of this text, whose files lie in `folder`.
    #[must_use]
    pub fn new(text: &'a str, folder: &'a Path) -> Self {
        Self { text, folder, left: Left::default() }
    }

    /// The tensor about the centre of mass: moments (xx, yy, zz) and products (xy, xz, yz), kg m². A table of
    /// these alone is not checked.
    ///
    /// # Errors
    /// The line, the field and the rule that it breaks.
    pub fn tensor(&self, table: &Spanned<Table>) -> Result<([f64; 3], [f64; 3]), Error> {
        let of_start = ["name", "moments", "products", "spin", "momentum", "attitude"];
        let alone = table.get_ref().present().iter().all(|(field, _)| of_start.contains(field));
        if let Some(tensor) = table.get_ref().tensor().filter(|_| alone) {
            return Ok(tensor);
        }
        let files = Files::new(self.folder, &self.left);
        let matrix = file::model(self.text, table.get_ref(), &table.span(), &files)?.inertia.matrix();
        let products = [(0, 1), (0, 2), (1, 2)].map(|place| matrix[place]);
        Ok((matrix.diagonal().into(), products))
    }
}
