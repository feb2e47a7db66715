mod cloud;
mod mesh;
mod properties;
mod refusals;
mod shapes;
mod shells;
mod surface;
mod topology;
