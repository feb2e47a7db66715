//! The hashes of very many answers of the library and of scenes.

#[path = "../../../tests/common/same_bits.rs"]
mod library;
#[path = "../../../crates/scenes/tests/scenes/common/same_bits.rs"]
mod scenes;

/// The hash of this many rounds of answers, of the library or of scenes.
pub fn hash(rounds: u32, of_scenes: bool) -> library::Hash {
    if of_scenes { scenes::hash(rounds) } else { library::hash(rounds) }
}
