mod observe;
mod stability;
