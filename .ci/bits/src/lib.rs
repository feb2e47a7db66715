//! The hashes of very many answers of the library and of scenes, as a program and as a WebAssembly module.

#[path = "../../../tests/common/same_bits.rs"]
mod library;
#[path = "../../../crates/scenes/tests/scenes/common/same_bits.rs"]
mod scenes;

pub use library::Hash;

/// The hash of this many rounds of answers, of the library or of scenes.
pub fn hash(rounds: u32, of_scenes: bool) -> Hash {
    if of_scenes { scenes::hash(rounds) } else { library::hash(rounds) }
}

/// The hash, for WebAssembly, which has no program to print it.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits(rounds: u32, of_scenes: bool) -> u64 {
    hash(rounds, of_scenes).value()
}

/// How many numbers it is of.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits_numbers(rounds: u32, of_scenes: bool) -> u64 {
    hash(rounds, of_scenes).numbers
}
