use std::cell::Cell;
use std::ffi::{CStr, CString};
use std::panic::resume_unwind;
use std::ptr;
use std::sync::Arc;

use bempd_sys as sys;

use super::callbacks::{Callbacks, PanicSlot};
use super::cancel::CancelTarget;
use crate::{Error, Result};

/// An owned `bempd_model`. Methods that change the model, and so may end the life of its views, take `&mut self`.
pub(crate) struct Handle {
    model: *mut sys::bempd_model,
    running: Cell<bool>,
    pub(super) panic: Arc<PanicSlot>,
    pub(super) callbacks: Callbacks,
    cancel: Arc<CancelTarget>,
}

// SAFETY: the library keeps nothing per thread but the sentence of calls without a model, and the closures are `Send`.
unsafe impl Send for Handle {}

impl Handle {
    pub(crate) fn new() -> Result<Handle> {
        let mut model = ptr::null_mut();
        // SAFETY: the place for the result is valid.
        check(unsafe { sys::bempd_model_create(&mut model) })?;
        Ok(Handle {
            model,
            running: Cell::new(false),
            panic: Arc::default(),
            callbacks: Callbacks::default(),
            cancel: Arc::new(CancelTarget::new(model)),
        })
    }

    pub(crate) fn cancel_target(&self) -> Arc<CancelTarget> {
        Arc::clone(&self.cancel)
    }

    /// Makes one call on the model; afterwards goes on with the panic of a closure, if there was one.
    pub(super) fn call(&self, function: impl FnOnce(*mut sys::bempd_model) -> sys::bempd_status) -> Result<()> {
        let nested = self.running.replace(true);
        let result = match function(self.model) {
            sys::BEMPD_OK => Ok(()),
            // A model that is in another call keeps its sentence for that one.
            status => Err(error(status, if nested { ptr::null() } else { self.model })),
        };
        self.running.set(nested);
        if !nested {
            if let Some(panic) = self.panic.take() {
                resume_unwind(panic);
            }
        }
        result
    }

    /// A call with one output.
    pub(super) fn output<T: Default>(
        &self,
        function: impl FnOnce(*mut sys::bempd_model, *mut T) -> sys::bempd_status,
    ) -> Result<T> {
        let mut value = T::default();
        self.call(|model| function(model, &mut value))?;
        Ok(value)
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        self.cancel.forget_model();
        // SAFETY: the model came from `bempd_model_create` and nothing borrows from it any more.
        unsafe { sys::bempd_model_free(self.model) }
    }
}

/// Outcome of a call without a model.
pub(super) fn check(status: sys::bempd_status) -> Result<()> {
    match status {
        sys::BEMPD_OK => Ok(()),
        status => Err(error(status, ptr::null())),
    }
}

fn error(status: sys::bempd_status, model: *const sys::bempd_model) -> Error {
    // SAFETY: the model is valid or NULL, and the sentence is copied before any other call.
    let mut sentence = text(unsafe { sys::bempd_last_error(model) });
    if sentence.is_empty() {
        // SAFETY: any status is allowed, the answer is a constant string.
        sentence = text(unsafe { sys::bempd_status_name(status) });
    }
    match status {
        sys::BEMPD_ERROR_ARGUMENT => Error::Argument(sentence),
        sys::BEMPD_ERROR_ORDER => Error::Order(sentence),
        sys::BEMPD_ERROR_UNSOLVABLE => Error::Unsolvable(sentence),
        sys::BEMPD_ERROR_CONVERGENCE => Error::Convergence(sentence),
        sys::BEMPD_ERROR_CANCELLED => Error::Cancelled(sentence),
        sys::BEMPD_ERROR_MEMORY => Error::Memory(sentence),
        sys::BEMPD_ERROR_IO => Error::Io(sentence),
        _ => Error::Internal(sentence),
    }
}

fn text(string: *const std::os::raw::c_char) -> String {
    // SAFETY: the library's strings are never NULL and end with a zero.
    unsafe { CStr::from_ptr(string) }.to_string_lossy().into_owned()
}

/// A constant string of the library.
///
/// # Safety
/// `string` must be NULL or end with a zero, and live as long as the library.
pub(super) unsafe fn constant_text(string: *const std::os::raw::c_char) -> &'static str {
    if string.is_null() {
        return "";
    }
    CStr::from_ptr(string).to_str().unwrap_or("")
}

/// A string for the library.
pub(super) fn terminated(string: &str) -> Result<CString> {
    CString::new(string).map_err(|_| Error::Argument(format!("\"{}\" contains a zero byte", string.escape_debug())))
}

/// A struct filled by its `_init` function.
pub(super) fn filled<T>(init: unsafe extern "C" fn(*mut T, i64) -> sys::bempd_status) -> Result<T>
where
    T: Copy,
{
    let mut value = std::mem::MaybeUninit::<T>::zeroed();
    // SAFETY: the place is valid and of the size given; the structs of the interface are plain numbers and pointers, for
    // which zero is a value.
    unsafe {
        check(init(value.as_mut_ptr(), std::mem::size_of::<T>() as i64))?;
        Ok(value.assume_init())
    }
}
