//! A row of the record of what scenes cost.

use crate::record::{Record, Row, Wrong};

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

impl Row for Saving {
    const COLUMNS: &'static [&'static str] = &["table", "row", "what", "value"];

    fn fields(&self) -> Vec<String> {
        vec![self.table.clone(), self.row.clone(), self.what.clone(), format!("{}", self.value)]
    }

    fn read(fields: &[&str]) -> Result<Self, Wrong> {
        let [table, row, what, value] = fields else { return Err(format!("{} fields", fields.len())) };
        let value = value.parse().map_err(|_| format!("`{value}` is no number"))?;
        Ok(Self { table: (*table).into(), row: (*row).into(), what: (*what).into(), value })
    }
}

/// The committed record of what scenes cost.
///
/// # Errors
/// A record that cannot be read.
pub fn recorded() -> Result<Record<Saving>, Wrong> {
    Record::read(include_str!("../record/scenes.csv"))
}
