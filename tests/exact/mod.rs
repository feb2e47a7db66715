mod details;
mod flips;
mod motion;
mod sensitivity;
