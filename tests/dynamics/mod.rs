mod euler;
mod observe;
mod stability;
