//! The families of methods, a file each.

pub(crate) mod averaged;
pub(crate) mod engine_rules;
pub(crate) mod gauss;
pub(crate) mod implicit;
pub(crate) mod moser_veselov;
pub(crate) mod runge_kutta;
pub(crate) mod splitting;
