//! Holds the program of `cargo exercise NAME`, which is an example: the workspace has one binary, the book's.
