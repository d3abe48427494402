use std::fmt;
use std::sync::Arc;

use crate::raw::CancelTarget;

/// Stops a step from any thread. It may outlive its model; then it does nothing.
///
/// ```
/// # let model = bempd::Model::new()?;
/// let token = model.cancel_token();
/// std::thread::spawn(move || token.cancel()).join().unwrap();
/// # Ok::<(), bempd::Error>(())
/// ```
#[derive(Clone)]
pub struct CancelToken(pub(crate) Arc<CancelTarget>);

impl CancelToken {
    /// Asks the step that runs to stop: it returns to its start and fails with
    /// [`Error::Cancelled`](crate::Error::Cancelled). A request made while no step runs is forgotten.
    pub fn cancel(&self) {
        self.0.request();
    }

    /// Asks the step that runs to end and to keep the events that it has done; a long one at hand is given up. It succeeds with
    /// [`StopReason::Requested`](crate::StopReason::Requested). A request made while no step runs is forgotten.
    pub fn stop(&self) {
        self.0.request_stop();
    }
}

impl fmt::Debug for CancelToken {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("CancelToken").finish_non_exhaustive()
    }
}
