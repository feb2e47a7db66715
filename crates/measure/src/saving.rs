//! A row of the record of what scenes cost.

use crate::fields::next;
use crate::record::{Fields, Record, Wrong};

/// One number of one table.
#[derive(Debug, Clone, PartialEq)]
pub struct Saving {
    /// `executed` or `compiled`.
    pub table: String,
    /// What it is of.
    pub row: String,
    /// What is counted.
    pub what: String,
    /// How many.
    pub value: f64,
}

/// As it is: names have semicolons, and whole numbers no exponent.
impl Fields for Saving {
    fn columns(_: &'static str) -> Vec<&'static str> {
        vec!["table", "row", "what", "value"]
    }

    fn write(&self, fields: &mut Vec<String>) {
        fields.extend([self.table.clone(), self.row.clone(), self.what.clone(), self.value.to_string()]);
    }

    fn read<'a>(fields: &mut impl Iterator<Item = &'a str>) -> Result<Self, Wrong> {
        let [table, row, what] = [next(fields)?, next(fields)?, next(fields)?].map(String::from);
        Ok(Self { table, row, what, value: f64::read(fields)? })
    }
}

/// The committed record of what scenes cost.
///
/// # Errors
/// A record that cannot be read.
pub fn recorded() -> Result<Record<Saving>, Wrong> {
    Record::read(include_str!("../record/scenes.csv"))
}
