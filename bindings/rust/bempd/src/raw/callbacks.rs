use std::any::Any;
use std::ffi::CStr;
use std::ops::ControlFlow;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::ptr::NonNull;
use std::sync::{Arc, Mutex, PoisonError};

use bempd_sys as sys;

use super::cancel::CancelTarget;
use super::Handle;
use crate::{BoundaryValue, CrackId, GrowingTip, LogLevel, PhaseProgress, Progress, Result, TipEnd};

pub(crate) type ProgressFunction = Box<dyn FnMut(Progress) -> ControlFlow<()> + Send>;
pub(crate) type PhaseFunction = Box<dyn FnMut(PhaseProgress) -> ControlFlow<()> + Send>;
pub(crate) type LogFunction = Box<dyn FnMut(LogLevel, &str) + Send>;
pub(crate) type BoundaryFunction = Box<dyn FnMut(f64, f64) -> Option<BoundaryValue> + Send>;
pub(crate) type GrowthFunction = Box<dyn FnMut(&GrowingTip) -> f64 + Send>;

/// The first panic of a closure during a call, until the call has returned.
#[derive(Default)]
pub(super) struct PanicSlot(Mutex<Option<Box<dyn Any + Send>>>);

impl PanicSlot {
    pub(super) fn take(&self) -> Option<Box<dyn Any + Send>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn is_set(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    fn set(&self, panic: Box<dyn Any + Send>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(panic);
    }
}

/// A closure, and where its panic goes. The library holds its address, so it is not moved or lent while it is kept.
pub(super) struct Kept<F>(NonNull<Closure<F>>);

struct Closure<F> {
    function: F,
    panic: Arc<PanicSlot>,
}

// SAFETY: `Kept` owns its closure, like a box.
unsafe impl<F: Send> Send for Kept<F> {}

impl<F> Kept<F> {
    fn new(function: F, panic: &Arc<PanicSlot>) -> Kept<F> {
        let closure = Box::new(Closure { function, panic: Arc::clone(panic) });
        Kept(NonNull::from(Box::leak(closure)))
    }

    fn user(&self) -> *mut c_void {
        self.0.as_ptr().cast()
    }
}

impl<F> Drop for Kept<F> {
    fn drop(&mut self) {
        // SAFETY: the closure came from a box and the library does not call it any more.
        drop(unsafe { Box::from_raw(self.0.as_ptr()) });
    }
}

/// Runs the closure behind `user`; `None` if it panics or one has panicked before in this call.
///
/// # Safety
/// `user` must come from `Kept<F>::user`, and the closure must not be running.
unsafe fn run<F, T>(user: *mut c_void, body: impl FnOnce(&mut F) -> T) -> Option<T> {
    let closure = &mut *user.cast::<Closure<F>>();
    if closure.panic.is_set() {
        return None;
    }
    // Whoever catches the panic after the call sees a model that is as it was before.
    match catch_unwind(AssertUnwindSafe(|| body(&mut closure.function))) {
        Ok(value) => Some(value),
        Err(panic) => {
            closure.panic.set(panic);
            None
        }
    }
}

#[derive(Default)]
pub(super) struct Callbacks {
    progress: Option<Kept<ProgressFunction>>,
    phases: Option<Kept<PhaseFunction>>,
    log: Option<Kept<LogClosure>>,
    boundary: Vec<Kept<BoundaryFunction>>,
    growth: Vec<Kept<GrowthFunction>>,
}

struct LogClosure {
    function: LogFunction,
    cancel: Arc<CancelTarget>,
}

unsafe extern "C" fn progress(load_factor: f64, events: i64, broken_bonds: i64, user: *mut c_void) -> i32 {
    let report = Progress { load_factor, events, broken_bonds };
    match run(user, |function: &mut ProgressFunction| function(report)) {
        Some(ControlFlow::Continue(())) => 0,
        _ => 1,
    }
}

unsafe extern "C" fn phase(name: *const c_char, share: f64, seconds: f64, expected: f64, user: *mut c_void) -> i32 {
    let told = |function: &mut PhaseFunction| {
        // SAFETY: the library gives a string that ends with a zero and lives during the call.
        let phase = CStr::from_ptr(name).to_string_lossy();
        function(PhaseProgress { phase: &phase, share, seconds, expected })
    };
    match run(user, told) {
        Some(ControlFlow::Continue(())) => 0,
        _ => 1,
    }
}

unsafe extern "C" fn log(level: i32, message: *const c_char, user: *mut c_void) {
    let cancel = Arc::clone(&(*user.cast::<Closure<LogClosure>>()).function.cancel);
    let line = |closure: &mut LogClosure| {
        // SAFETY: the library gives a string that ends with a zero and lives during the call.
        let message = CStr::from_ptr(message).to_string_lossy();
        (closure.function)(LogLevel::from_raw(level), &message);
    };
    if run(user, line).is_none() {
        cancel.request();
    }
}

unsafe extern "C" fn boundary(x: f64, y: f64, constant: *mut f64, proportional: *mut f64, user: *mut c_void) -> i32 {
    match run(user, |function: &mut BoundaryFunction| function(x, y)).flatten() {
        Some(value) => {
            constant.cast::<[f64; 2]>().write(value.constant);
            proportional.cast::<[f64; 2]>().write(value.proportional);
            0
        }
        None => 1,
    }
}

#[allow(clippy::too_many_arguments)] // those of the C function
unsafe extern "C" fn growth(
    crack: i32,
    end: i32,
    equivalent: f64,
    ratio: f64,
    stress_intensity_1: f64,
    stress_intensity_2: f64,
    t_stress: f64,
    length: f64,
    x: f64,
    y: f64,
    user: *mut c_void,
) -> f64 {
    let tip = GrowingTip {
        crack: CrackId(crack),
        end: TipEnd::from_raw(end),
        equivalent,
        ratio,
        stress_intensities: [stress_intensity_1, stress_intensity_2],
        t_stress,
        length,
        place: [x, y],
    };
    run(user, |function: &mut GrowthFunction| function(&tip)).unwrap_or(f64::NAN)
}

impl Handle {
    pub(crate) fn set_resistance_function(&mut self, material: i32, function: GrowthFunction) -> Result<()> {
        let kept = Kept::new(function, &self.panic);
        let user = kept.user();
        self.callbacks.growth.push(kept);
        // SAFETY: the closure is kept until the model is freed.
        self.call(|model| unsafe { sys::bempd_set_resistance_function(model, material, Some(growth), user) })
    }

    pub(crate) fn set_progress(&mut self, function: Option<ProgressFunction>) -> Result<()> {
        let kept = function.map(|function| Kept::new(function, &self.panic));
        match &kept {
            // SAFETY: the closure is kept until it is replaced or the model is freed.
            Some(kept) => self.call(|model| unsafe { sys::bempd_set_progress(model, Some(progress), kept.user()) })?,
            // SAFETY: no function takes no pointer.
            None => self.call(|model| unsafe { sys::bempd_set_progress(model, None, std::ptr::null_mut()) })?,
        }
        self.callbacks.progress = kept;
        Ok(())
    }

    pub(crate) fn set_phase_progress(&mut self, function: Option<PhaseFunction>) -> Result<()> {
        let kept = function.map(|function| Kept::new(function, &self.panic));
        match &kept {
            // SAFETY: as in `set_progress`.
            Some(kept) => {
                self.call(|model| unsafe { sys::bempd_set_phase_progress(model, Some(phase), kept.user()) })?
            }
            // SAFETY: no function takes no pointer.
            None => self.call(|model| unsafe { sys::bempd_set_phase_progress(model, None, std::ptr::null_mut()) })?,
        }
        self.callbacks.phases = kept;
        Ok(())
    }

    pub(crate) fn set_log(&mut self, function: Option<LogFunction>) -> Result<()> {
        let kept = function.map(|function| {
            let cancel = self.cancel_target();
            Kept::new(LogClosure { function, cancel }, &self.panic)
        });
        match &kept {
            // SAFETY: as in `set_progress`.
            Some(kept) => self.call(|model| unsafe { sys::bempd_set_log(model, Some(log), kept.user()) })?,
            // SAFETY: no function takes no pointer.
            None => self.call(|model| unsafe { sys::bempd_set_log(model, None, std::ptr::null_mut()) })?,
        }
        self.callbacks.log = kept;
        Ok(())
    }

    /// Hands a boundary function to `add`. It is kept even if that fails, for the model's whole life: preparing asks it.
    pub(super) fn with_boundary_function(
        &mut self,
        function: BoundaryFunction,
        add: impl FnOnce(*mut sys::bempd_model, sys::bempd_boundary_function, *mut c_void, *mut i32) -> sys::bempd_status,
    ) -> Result<i32> {
        let kept = Kept::new(function, &self.panic);
        let user = kept.user();
        self.callbacks.boundary.push(kept);
        self.output(|model, id| add(model, Some(boundary), user, id))
    }
}
