//! What figures are drawn with: a canvas, letters, plots, and a view of things in space.

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
pub(crate) use solid::{hull, solid};
pub(crate) use space::{Cuboid, View};
pub(crate) use text::{Label, escaped};
