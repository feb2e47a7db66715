mod cloud;
mod mesh;
mod properties;
mod refusals;
mod shapes;
