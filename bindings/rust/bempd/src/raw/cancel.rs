use std::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

use bempd_sys as sys;

/// The model that a request to cancel goes to, until it is dropped. The lock keeps it alive during the request.
pub(crate) struct CancelTarget(Mutex<ModelPointer>);

struct ModelPointer(*mut sys::bempd_model);

// SAFETY: the pointer is used for `bempd_request_cancel` and `bempd_request_stop` only, which are allowed from any thread at any time.
unsafe impl Send for ModelPointer {}

impl CancelTarget {
    pub(super) fn new(model: *mut sys::bempd_model) -> CancelTarget {
        CancelTarget(Mutex::new(ModelPointer(model)))
    }

    pub(super) fn forget_model(&self) {
        self.lock().0 = ptr::null_mut();
    }

    pub(crate) fn request(&self) {
        self.with_model(sys::bempd_request_cancel);
    }

    pub(crate) fn request_stop(&self) {
        self.with_model(sys::bempd_request_stop);
    }

    fn with_model(&self, call: unsafe extern "C" fn(*mut sys::bempd_model) -> sys::bempd_status) {
        let model = self.lock();
        if !model.0.is_null() {
            // SAFETY: the model is freed only after `forget_model`, which waits for the lock held here.
            let status = unsafe { call(model.0) };
            debug_assert_eq!(status, sys::BEMPD_OK);
        }
    }

    fn lock(&self) -> MutexGuard<'_, ModelPointer> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
