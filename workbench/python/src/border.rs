//! The border between the two languages: errors as exceptions of one family, panics caught.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::prelude::*;

/// The exception for a code of the batch and a message: a class of the package's module of errors.
pub(crate) fn error(py: Python<'_>, code: &str, message: &str) -> PyErr {
    let made = py.import("zonotope._errors").and_then(|errors| errors.getattr("of_code")?.call1((code, message)));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// Runs the library without the interpreter's lock; a panic is an exception `InternalError` with its message.
pub(crate) fn outside<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| guarded(work)).map_err(|message| error(py, "internal_error", &message))
}

/// Runs work that is too short to give up the interpreter's lock for it.
pub(crate) fn inside<T>(py: Python<'_>, work: impl FnOnce() -> T) -> PyResult<T> {
    guarded(work).map_err(|message| error(py, "internal_error", &message))
}

fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    // The work owns what it changes: nothing half done is left behind.
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| message_of(payload.as_ref()))
}

fn message_of(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic without a message").to_owned()
}

/// Panics behind the border, for the test that nothing does so across it.
#[pyfunction]
pub(crate) fn provoke_panic(py: Python<'_>, message: String) -> PyResult<()> {
    outside(py, || panic!("{message}"))
}
