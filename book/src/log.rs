//! Hearing what mdBook complains of.
//!
//! mdBook tells of a missing include or an unclosed tag only through `tracing`, and then builds the
//! page all the same. With nobody listening such a page ships. So we listen, and count.

use crate::complain;
use std::fmt::{self, Write as _};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tracing::field::{Field, Visit};
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber};

/// Runs `work`; says how many warnings and errors were heard meanwhile, each printed as it came.
pub(crate) fn listening<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let heard = Arc::new(AtomicUsize::new(0));
    let result = tracing::subscriber::with_default(Listener(Arc::clone(&heard)), work);
    (result, heard.load(Ordering::SeqCst))
}

struct Listener(Arc<AtomicUsize>);

impl Subscriber for Listener {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        *metadata.level() <= Level::WARN
    }

    fn event(&self, event: &Event<'_>) {
        self.0.fetch_add(1, Ordering::SeqCst);
        let mut text = String::new();
        event.record(&mut Words(&mut text));
        complain!("mdbook: {}", text.trim_end());
    }

    // Spans carry nothing that we tell.
    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }
    fn record(&self, _: &Id, _: &Record<'_>) {}
    fn record_follows_from(&self, _: &Id, _: &Id) {}
    fn enter(&self, _: &Id) {}
    fn exit(&self, _: &Id) {}
}

struct Words<'a>(&'a mut String);

impl Visit for Words<'_> {
    fn record_debug(&mut self, field: &Field, value: &dyn fmt::Debug) {
        let _ = match field.name() {
            "message" => write!(self.0, "{value:?} "),
            name => write!(self.0, "{name}={value:?} "),
        };
    }
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
