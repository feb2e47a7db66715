//! Counts the warnings and errors of mdBook.
//!
//! mdBook reports a missing include or an unclosed tag only through `tracing`, and builds the page anyway. So
//! we listen to these events and count them; otherwise such a page would be published.

use std::io::stderr;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tracing::Level;

/// Runs `work`; returns its result with the number of warnings and errors meanwhile, each printed as it came.
pub(crate) fn listening<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let heard = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&heard);
    // A writer is made for each event.
    let writer = move || {
        count.fetch_add(1, Ordering::SeqCst);
        stderr()
    };
    let listener =
        tracing_subscriber::fmt().with_max_level(Level::WARN).without_time().with_writer(writer).finish();
    let result = tracing::subscriber::with_default(listener, work);
    (result, heard.load(Ordering::SeqCst))
}

#[cfg(test)]
mod tests {
    use super::listening;

    #[test]
    fn warnings_and_errors_are_counted_and_the_rest_is_not() {
        let ((), heard) = listening(|| {
            tracing::info!("going well");
            tracing::warn!("not so well");
            tracing::error!(file = "x.md", "missing");
        });
        assert_eq!(heard, 2);
    }
}
