//! Trying a law that panics where it is broken.

use std::cell::{Cell, RefCell};
use std::fmt;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::Once;

/// How a law was broken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken {
    /// The law's name.
    pub law: String,
    /// File and line of the panic; for another program's output, the kind of fault.
    pub place: String,
    /// What was said.
    pub message: String,
}

impl Broken {
    /// What failures of one cause have in common, as far as one can tell: law, place, and the first words said, numbers left
    /// out. A verdict's first fault counts too.
    #[must_use]
    pub fn bucket(&self) -> String {
        let fault = self.message.lines().find_map(|line| line.strip_prefix("  fault"));
        let said = format!("{} {}", self.message.lines().next().unwrap_or(""), fault.unwrap_or(""));
        let words =
            said.split_whitespace().filter(|word| !word.contains(|c: char| c.is_ascii_digit()));
        let words: Vec<&str> = words.take(16).collect();
        format!("{} at {}: {}", self.law, self.place, words.join(" "))
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is broken at {}: {}", self.law, self.place, self.message)
    }
}

thread_local! {
    static LISTENS: Cell<bool> = const { Cell::new(false) };
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Runs `hold`; a panic becomes an error, silently, with its place. Other threads' panics speak as before.
///
/// # Errors
/// If `hold` panics.
pub fn attempt(law: &str, hold: impl FnOnce() -> usize) -> Result<usize, Broken> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |info| if LISTENS.get() { note(info) } else { before(info) }));
    });
    LISTENS.set(true);
    let outcome = catch_unwind(AssertUnwindSafe(hold));
    LISTENS.set(false);
    outcome.map_err(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| payload.downcast_ref::<&str>().copied());
        let message = text.unwrap_or("a panic without words").to_owned();
        Broken { law: law.to_owned(), place: PLACE.take(), message }
    })
}

/// Keeps where a panic happened, by the path inside the project.
fn note(info: &PanicHookInfo<'_>) {
    let place = info.location().map_or_else(String::new, |place| {
        let file = place.file();
        let inside = file.find("crates/").map_or(file, |start| &file[start..]);
        format!("{inside}:{}", place.line())
    });
    PLACE.set(place);
}
