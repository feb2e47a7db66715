//! The site: its pages and their addresses, where its files lie, and what it says of itself.

pub(crate) mod build;
pub(crate) mod files;
pub(crate) mod goals;
pub(crate) mod home;
pub(crate) mod log;
pub(crate) mod manifests;
pub(crate) mod paths;
pub(crate) mod places;
pub(crate) mod share;
