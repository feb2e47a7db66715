//! The families of methods, a file each.

pub(crate) mod buss;
pub(crate) mod decimal;
pub(crate) mod dormand_prince;
pub(crate) mod engine_rules;
pub(crate) mod explicit;
pub(crate) mod gauss;
mod implicit;
pub(crate) mod lie;
pub(crate) mod moser_veselov;
pub(crate) mod rk4;
pub(crate) mod spiral;
pub(crate) mod splitting;
pub(crate) mod symmetric_top;
