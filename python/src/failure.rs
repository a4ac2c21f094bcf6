//! Errors for Python: one exception class with a code and a message.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    inkpanel,
    Error,
    PyValueError,
    "Invalid input.\n\n\
     The message says why and what would be right. `code` is the stable name of the kind of error\n\
     (`unknown-style`, `damaged`, `not-found`), `file` is the affected photo, or None."
);

/// Something that went wrong.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Failure {
    code: &'static str,
    message: String,
    file: Option<String>,
}

pub(crate) type Done<T> = Result<T, Failure>;

impl Failure {
    pub(crate) fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), file: None }
    }

    /// An argument that is not what it should be.
    pub(crate) fn argument(name: &str, reason: &str) -> Self {
        Self::new("invalid-argument", format!("{name}: {reason}"))
    }

    /// A fault of ours.
    pub(crate) fn fault(reason: &str) -> Self {
        Self::new("fault", format!("internal error; please report it: {reason}"))
    }
}

impl From<inkpanel_engine::Error> for Failure {
    fn from(error: inkpanel_engine::Error) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

impl From<inkpanel::Failure> for Failure {
    fn from(failure: inkpanel::Failure) -> Self {
        let file = failure.photo().map(str::to_owned);
        Self { code: failure.code(), message: failure.to_string(), file }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| {
            let error = Error::new_err(failure.message);
            let told = error.value(py);
            match told.setattr("code", failure.code).and_then(|()| told.setattr("file", failure.file)) {
                Ok(()) => error,
                Err(other) => other,
            }
        })
    }
}

/// Adds the class to the module.
pub(crate) fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let class = module.py().get_type::<Error>();
    class.setattr("code", "invalid-argument")?;
    class.setattr("file", module.py().None())?;
    module.add("Error", class)
}

/// Does `work` while other threads of Python run. A panic, which is a bug or a fault of a decoder, becomes a
/// normal error. `except Exception` does not catch Python's own panic exception.
pub(crate) fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> Done<T> + Send) -> PyResult<T> {
    Ok(py.detach(|| inkpanel::survived(work))?)
}
