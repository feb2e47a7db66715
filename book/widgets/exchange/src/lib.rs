//! The data that a module shares with its page: one row of numbers, and one text.
//!
//! The page writes its question into the numbers, calls `answer`, and reads the answer from the same numbers.
//! WebAssembly cannot pass lists as arguments; a row at a known address makes this unnecessary. The row
//! consists of atomic integers, which may be changed from outside at any time without unsafe code, and which
//! cost nothing with a single thread.
//!
//! A module is a function from numbers to numbers, and one line that names it to the page:
//!
//! ```
//! use exchange::Numbers;
//! /// The sum of two numbers; the answer is one number.
//! pub fn answer(_what: u32, row: &Numbers) -> usize {
//!     row.set(0, row.get(0) + row.get(1));
//!     1
//! }
//! exchange::page!(answer);
//!
//! let row = Numbers::empty();
//! row.fill(&[2.0, 3.0]);
//! assert_eq!(answer(0, &row), 1);
//! assert_eq!(row.get(0), 5.0);
//! ```
//!
//! [`page!`] makes exports only for WebAssembly. Elsewhere the module is an ordinary library, and the grid
//! calls the same `answer`.

use std::sync::atomic::{AtomicU8, AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// How many numbers a row holds.
pub const ROOM: usize = 4096;

/// The row of numbers.
pub struct Numbers([AtomicU64; ROOM]);

impl Numbers {
    /// All zero.
    #[must_use]
    pub const fn empty() -> Self {
        Self([const { AtomicU64::new(0) }; ROOM])
    }

    /// The number at this place; NaN where there is none.
    #[must_use]
    pub fn get(&self, place: usize) -> f64 {
        self.0.get(place).map_or(f64::NAN, |bits| f64::from_bits(bits.load(Relaxed)))
    }

    /// The `N` numbers from this place on.
    #[must_use]
    pub fn take<const N: usize>(&self, from: usize) -> [f64; N] {
        std::array::from_fn(|i| self.get(from + i))
    }

    /// Writes a number to this place, if the place exists.
    pub fn set(&self, place: usize, number: f64) {
        if let Some(bits) = self.0.get(place) {
            bits.store(number.to_bits(), Relaxed);
        }
    }

    /// Writes these from the start; returns how many there are.
    pub fn fill(&self, numbers: &[f64]) -> usize {
        self.fill_from(0, numbers)
    }

    /// Writes these from a place on; returns the place after them.
    pub fn fill_from(&self, from: usize, numbers: &[f64]) -> usize {
        for (place, &number) in (from..).zip(numbers) {
            self.set(place, number);
        }
        from + numbers.len()
    }

    /// The address of the row in the module's memory.
    #[must_use]
    pub fn address(&self) -> usize {
        self.0.as_ptr().addr()
    }
}

/// A text from the module to its page.
pub struct Text(Mutex<String>);

impl Text {
    /// Empty.
    #[must_use]
    pub const fn empty() -> Self {
        Self(Mutex::new(String::new()))
    }

    /// Puts this text there.
    pub fn say(&self, text: String) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = text;
    }

    /// What was last put there.
    #[must_use]
    pub fn said(&self) -> String {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The address of the text in the module's memory, and its length in bytes of UTF-8.
    #[must_use]
    pub fn place(&self) -> (usize, usize) {
        let text = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        (text.as_ptr().addr(), text.len())
    }
}

/// A line from the module to its page, for a module that needs no memory beyond its initial one.
pub struct Line {
    bytes: [AtomicU8; Self::ROOM],
    length: AtomicUsize,
}

impl Line {
    /// The largest length of a line in bytes of UTF-8; the rest of a longer line is omitted.
    pub const ROOM: usize = 256;

    /// Empty.
    #[must_use]
    pub const fn empty() -> Self {
        Self { bytes: [const { AtomicU8::new(0) }; Self::ROOM], length: AtomicUsize::new(0) }
    }

    /// Puts these words there, one after the other.
    pub fn say(&self, words: &[&str]) {
        let all = words.iter().flat_map(|word| word.bytes());
        let mut length = 0;
        for (place, byte) in self.bytes.iter().zip(all) {
            place.store(byte, Relaxed);
            length += 1;
        }
        self.length.store(length, Relaxed);
    }

    /// What was last put there.
    #[must_use]
    pub fn said(&self) -> String {
        let bytes: Vec<u8> =
            self.bytes.iter().take(self.length.load(Relaxed)).map(|byte| byte.load(Relaxed)).collect();
        String::from_utf8_lossy(&bytes).into_owned()
    }

    /// Where the line begins in the module's memory, and how many bytes it is.
    #[must_use]
    pub fn place(&self) -> (usize, usize) {
        (self.bytes.as_ptr().addr(), self.length.load(Relaxed))
    }
}

/// Bytes from the page to the module, a piece at a time.
pub struct Piece([AtomicU8; Self::ROOM]);

impl Piece {
    /// How many bytes a piece can have.
    pub const ROOM: usize = 1 << 16;

    /// Empty.
    #[must_use]
    pub const fn empty() -> Self {
        Self([const { AtomicU8::new(0) }; Self::ROOM])
    }

    /// Copies the first bytes out, as many as fit on both sides.
    pub fn copy_to(&self, room: &mut [u8]) {
        for (to, from) in room.iter_mut().zip(&self.0) {
            *to = from.load(Relaxed);
        }
    }

    /// Where the piece begins in the module's memory.
    #[must_use]
    pub fn address(&self) -> usize {
        self.0.as_ptr().addr()
    }
}

/// An allocator for modules that need little memory: a list of free blocks, a tenth of the code of `std`'s.
#[cfg(target_arch = "wasm32")]
pub type Memory = lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator>;

/// None of it is taken yet.
#[cfg(target_arch = "wasm32")]
#[must_use]
pub const fn memory() -> Memory {
    Memory::new(lol_alloc::FreeListAllocator::new())
}

/// Exports a module's `answer` to its page. A module that also has words passes its [`Text`] or [`Line`], and
/// a module that needs much memory says so.
///
/// `answer` receives the kind of the question and the row, and returns the number of numbers in the answer.
/// `None` means that the question has no answer; the text, if the module has one, gives the reason.
#[macro_export]
macro_rules! page {
    ($answer:path, much) => {
        #[cfg(target_arch = "wasm32")]
        #[allow(unsafe_code, missing_docs, reason = "a page finds a function by its name alone")]
        mod page {
            use super::*;

            static ROW: $crate::Numbers = $crate::Numbers::empty();

            #[unsafe(export_name = "numbers")]
            extern "C" fn the_numbers() -> usize {
                ROW.address()
            }

            #[unsafe(export_name = "answer")]
            extern "C" fn an_answer(what: u32) -> usize {
                $answer(what, &ROW)
            }
        }
    };
    ($answer:path, $text:path, much) => {
        $crate::page!($answer, much);

        #[cfg(target_arch = "wasm32")]
        #[allow(unsafe_code, missing_docs, reason = "a page finds a function by its name alone")]
        mod words {
            use super::*;

            #[unsafe(export_name = "text")]
            extern "C" fn start_of_text() -> usize {
                $text.place().0
            }

            #[unsafe(export_name = "text_length")]
            extern "C" fn length_of_text() -> usize {
                $text.place().1
            }
        }
    };
    ($answer:path $(, $text:path)?) => {
        $crate::page!($answer $(, $text)?, much);

        #[cfg(target_arch = "wasm32")]
        #[global_allocator]
        static MEMORY: $crate::Memory = $crate::memory();
    };
}
