//! The hash of very many answers of the library, as a program and as a WebAssembly module.

#[path = "../../../tests/common/same_bits.rs"]
mod same_bits;

pub use same_bits::{Hash, hash};

/// The hash, for WebAssembly, which has no program to print it.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits(rounds: u32) -> u64 {
    hash(rounds).value()
}

/// How many numbers it is of.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits_numbers(rounds: u32) -> u64 {
    hash(rounds).numbers
}
