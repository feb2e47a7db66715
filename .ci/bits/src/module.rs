//! The hashes as a WebAssembly module, which has no program to print them.

mod hashes;
use hashes::hash;

/// The hash of this many rounds of answers, of the library or of scenes.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits(rounds: u32, of_scenes: bool) -> u64 {
    hash(rounds, of_scenes).value()
}

/// How many numbers it is of.
#[unsafe(no_mangle)]
pub extern "C" fn same_bits_numbers(rounds: u32, of_scenes: bool) -> u64 {
    hash(rounds, of_scenes).numbers
}
