//! The engine for Python. The public API is in `inkpanel/__init__.py`, which calls these functions. There are
//! no algorithms here. The interpreter's lock is held only while arguments are read and results are returned,
//! never during image processing.

mod arrays;
mod failure;
mod nets;
mod page;
mod photos;
mod planning;
mod settings;
mod styling;

use pyo3::prelude::*;

/// The compiled part of the package `inkpanel`.
#[pymodule]
mod _inkpanel {
    #[pymodule_export]
    use super::page::{Page, pdf};
    #[pymodule_export]
    use super::planning::render;
    #[pymodule_export]
    use super::styling::stylize;
    use super::{failure, json_to_python};
    use inkpanel_engine::kinds::{self, Role};
    use inkpanel_engine::native;
    use inkpanel_engine::page::catalogue;
    use inkpanel_engine::style::painters::Painters;
    use pyo3::prelude::*;
    use std::path::PathBuf;
    use std::sync::Arc;

    /// Whether a file name is of a photo, by the table of file kinds.
    #[pyfunction]
    fn is_photo(name: &str) -> bool {
        !kinds::is_sidecar(name) && kinds::by_name(name).is_some_and(|kind| kind.role == Role::Photo)
    }

    /// Sets the folder with `painters.onnx`, the model of the block Painter.
    #[pyfunction]
    fn find_painters(folder: PathBuf) {
        native::read_painters_with(move || {
            let onnx = std::fs::read(folder.join("painters.onnx")).ok()?;
            Painters::new(&onnx).ok().map(Arc::new)
        });
    }

    /// Names and help texts of the page settings.
    #[pyfunction]
    fn page_settings() -> Vec<(String, &'static str)> {
        inkpanel::page_settings().collect()
    }

    /// All filter blocks with their parameters.
    #[pyfunction]
    fn blocks(py: Python<'_>) -> PyResult<Py<PyAny>> {
        json_to_python(py, &catalogue::blocks())
    }

    /// All page templates with their numbers of panels.
    #[pyfunction]
    fn layouts(py: Python<'_>) -> PyResult<Py<PyAny>> {
        json_to_python(py, &catalogue::layouts())
    }

    /// All designed styles, as style files.
    #[pyfunction]
    fn styles(py: Python<'_>) -> PyResult<Py<PyAny>> {
        json_to_python(py, &catalogue::styles())
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        failure::add(module)
    }
}

/// Converts a value to JSON and then to Python.
fn json_to_python(py: Python<'_>, value: &impl serde::Serialize) -> PyResult<Py<PyAny>> {
    let text = serde_json::to_string(value).map_err(|error| failure::Failure::fault(&error.to_string()))?;
    python_of(py, &text)
}

/// Converts JSON text to Python.
fn python_of(py: Python<'_>, json: &str) -> PyResult<Py<PyAny>> {
    Ok(py.import("json")?.call_method1("loads", (json,))?.unbind())
}
