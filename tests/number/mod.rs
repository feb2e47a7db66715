mod counted;
mod lane;
