//! How the laws of free motion are kept from row to row.

pub(crate) mod complaint;
pub(crate) mod curve;
pub(crate) mod followed;
pub(crate) mod jumps;
pub(crate) mod kept;
pub(crate) mod points;
pub(crate) mod trial;
