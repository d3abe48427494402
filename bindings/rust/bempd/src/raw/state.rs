use std::fmt;
use std::path::Path;
use std::ptr::{self, NonNull};

use bempd_sys as sys;

use super::handle::{check, terminated, Handle};
use crate::model::utf8;
use crate::Result;

/// A saved state of a model, to repeat a step from or to keep as bytes.
pub struct State(NonNull<sys::bempd_state>);

// SAFETY: the library keeps a saved state as plain data.
unsafe impl Send for State {}

impl State {
    /// Reads a state from what [`State::to_bytes`] gave.
    pub fn from_bytes(bytes: &[u8]) -> Result<State> {
        let mut state = ptr::null_mut();
        // SAFETY: the bytes are given with their length, and the place for the result is valid.
        check(unsafe { sys::bempd_state_from_bytes(bytes.len() as i64, bytes.as_ptr(), &mut state) })?;
        Ok(State::own(state))
    }

    /// Reads a state from a file that [`State::write`] wrote.
    pub fn read(path: impl AsRef<Path>) -> Result<State> {
        let path = terminated(utf8(path.as_ref())?)?;
        let mut state = ptr::null_mut();
        // SAFETY: the path ends with a zero, and the place for the result is valid.
        check(unsafe { sys::bempd_state_read(path.as_ptr(), &mut state) })?;
        Ok(State::own(state))
    }

    /// Writes it to a file, which is there as a whole or not at all; a state before it stays until then.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = terminated(utf8(path.as_ref())?)?;
        // SAFETY: the state is valid and only read, and the path ends with a zero.
        check(unsafe { sys::bempd_state_write(self.0.as_ptr(), path.as_ptr()) })
    }

    /// The state as bytes, with magic, version, byte order and checksum.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        let mut needed = 0;
        // SAFETY: the state is valid; without a buffer only the size is written.
        check(unsafe { sys::bempd_state_to_bytes(self.0.as_ptr(), 0, ptr::null_mut(), &mut needed) })?;
        let mut bytes = vec![0; needed as usize];
        // SAFETY: the state is valid and the buffer has the capacity given.
        check(unsafe { sys::bempd_state_to_bytes(self.0.as_ptr(), needed, bytes.as_mut_ptr(), ptr::null_mut()) })?;
        Ok(bytes)
    }

    fn own(state: *mut sys::bempd_state) -> State {
        State(NonNull::new(state).expect("a good status comes with a state"))
    }
}

impl fmt::Debug for State {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("State").finish_non_exhaustive()
    }
}

impl Drop for State {
    fn drop(&mut self) {
        // SAFETY: the state came from the library and is freed once.
        unsafe { sys::bempd_state_free(self.0.as_ptr()) }
    }
}

impl Handle {
    pub(crate) fn save(&mut self) -> Result<State> {
        let mut state = ptr::null_mut();
        // SAFETY: the place for the result is valid.
        self.call(|model| unsafe { sys::bempd_state_save(model, &mut state) })?;
        Ok(State::own(state))
    }

    pub(crate) fn save_with_values(&mut self) -> Result<State> {
        let mut state = ptr::null_mut();
        // SAFETY: the place for the result is valid.
        self.call(|model| unsafe {
            sys::bempd_state_save_with(model, sys::BEMPD_STATE_BODY_AND_VALUES as i32, &mut state)
        })?;
        Ok(State::own(state))
    }

    pub(crate) fn restore(&mut self, state: &State) -> Result<()> {
        // SAFETY: the state is valid and only read.
        self.call(|model| unsafe { sys::bempd_state_restore(model, state.0.as_ptr()) })
    }
}
