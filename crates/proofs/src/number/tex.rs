//! What can be written as TeX.

/// What can be written as TeX, to be set in maths mode. The plain text of the same is its `Display`.
pub trait Tex {
    /// The TeX source, without dollar signs.
    fn tex(&self) -> String;
}
