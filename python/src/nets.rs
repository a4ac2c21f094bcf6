//! The nets that find faces and objects: read once, and kept for all pages of the process.

use crate::failure::{Done, Failure};
use inkpanel::detect::Detectors;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

static READ: Mutex<Option<HashMap<PathBuf, Arc<Detectors>>>> = Mutex::new(None);

/// The nets in a folder.
pub(crate) fn of(folder: &Path) -> Done<Arc<Detectors>> {
    // Threads that ask at once wait for the first, rather than read the nets once more.
    let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let read = read.get_or_insert_default();
    if let Some(nets) = read.get(folder) {
        return Ok(nets.clone());
    }
    let file = |name: &str| {
        let file = folder.join(name);
        std::fs::read(&file).map_err(|error| {
            let why = format!(
                "{}: {error}; the nets that find faces and objects are not here: pass detect=False, or their folder as models",
                file.display()
            );
            Failure::new("no-models", why)
        })
    };
    let nets = Arc::new(Detectors::new(&file("faces.onnx")?, &file("objects.onnx")?)?);
    read.insert(folder.to_owned(), nets.clone());
    Ok(nets)
}
