//! Tools for figures: a canvas, letters, plots, and a view of objects in space.

mod canvas;
mod pen;
mod plot;
mod point;
mod solid;
mod space;
mod text;

pub(crate) use crate::ink::Ink;
pub(crate) use canvas::Canvas;
pub(crate) use pen::{Fill, Pen};
pub(crate) use plot::{Plot, Scale};
pub(crate) use point::{P, polar};
pub(crate) use solid::{exit, hull, solid};
pub(crate) use space::{Cuboid, View};
pub(crate) use text::{Label, escaped};
