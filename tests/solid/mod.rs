mod mesh;
mod properties;
mod refusals;
mod shapes;
mod shared;
mod shells;
mod surface;
mod topology;
