use std::fmt;

/// Why a call failed, by what the caller can do about it. Each variant holds the sentence that says what came, what is
/// needed and what to try.
///
/// After any error but [`Error::Internal`] the model is as it was before the call; after that one only drop it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// A value is wrong; correct it and call again.
    Argument(String),
    /// Called too early or too late in the order of a run.
    Order(String),
    /// The scene has no unique equilibrium: a mechanism, or a singular operator.
    Unsolvable(String),
    /// An iteration or the limit on events ended before the goal.
    Convergence(String),
    /// A closure or a [`CancelToken`](crate::CancelToken) asked to stop.
    Cancelled(String),
    /// Memory is not enough.
    Memory(String),
    /// A file could not be written.
    Io(String),
    /// A defect of the library; please report it.
    Internal(String),
}

impl Error {
    /// The sentence of the error.
    pub fn sentence(&self) -> &str {
        match self {
            Error::Argument(sentence)
            | Error::Order(sentence)
            | Error::Unsolvable(sentence)
            | Error::Convergence(sentence)
            | Error::Cancelled(sentence)
            | Error::Memory(sentence)
            | Error::Io(sentence)
            | Error::Internal(sentence) => sentence,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.sentence())
    }
}

impl std::error::Error for Error {}

/// Result of a call that can fail.
pub type Result<T> = std::result::Result<T, Error>;
