//! A reader that has read enough, as of `delone cdt .. | head -1`: what is printed then has nowhere to go, which is no fault.
//!
//! The standard library's `println!` panics there. Its message is known by its words: the tests of the program hold them fast.

use std::panic::PanicHookInfo;

/// The exit status of a program that a closed pipe has ended, as shells tell it.
const CLOSED_PIPE: i32 = 128 + 13;

/// From now on a closed pipe ends the program without a word.
pub(crate) fn end_quietly_when_closed() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        if is_closed_pipe(info) {
            std::process::exit(CLOSED_PIPE);
        }
        before(info);
    }));
}

fn is_closed_pipe(info: &PanicHookInfo<'_>) -> bool {
    let said = info.payload_as_str();
    said.is_some_and(|said| {
        said.starts_with("failed printing to std") && said.contains("Broken pipe")
    })
}
