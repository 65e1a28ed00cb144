//! How a command ends when it does not end well.

use std::fmt;

/// Why a command stopped; each kind is an exit status.
#[derive(Debug)]
pub(crate) enum Failure {
    /// 1: a judge or a comparison found a difference; `None` if the output has said so already.
    Difference(Option<String>),
    /// 2: bad usage or bad input.
    Input(String),
    /// 3: a limit was reached.
    Limit(String),
}

impl Failure {
    pub(crate) fn input(message: impl fmt::Display) -> Self {
        Self::Input(message.to_string())
    }

    pub(crate) fn status(&self) -> u8 {
        match self {
            Self::Difference(_) => 1,
            Self::Input(_) => 2,
            Self::Limit(_) => 3,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Difference(message) => f.write_str(message.as_deref().unwrap_or("")),
            Self::Input(message) => write!(f, "error: {message}"),
            Self::Limit(message) => write!(f, "stopped: {message}"),
        }
    }
}
