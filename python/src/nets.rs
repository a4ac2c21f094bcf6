//! The models that find faces and objects, loaded once and cached for the process.

use crate::failure::{Done, Failure};
use inkpanel::Nets;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

static READ: Mutex<Option<HashMap<PathBuf, Arc<Nets>>>> = Mutex::new(None);

/// Returns the models in a folder.
pub(crate) fn of(folder: &Path) -> Done<Arc<Nets>> {
    // Simultaneous threads wait for the first one instead of reading the models again.
    let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let read = read.get_or_insert_default();
    if let Some(nets) = read.get(folder) {
        return Ok(nets.clone());
    }
    let nets = Nets::open(folder).map_err(|failure| match failure.code() {
        "no-models" => Failure::new(
            "no-models",
            format!(
                "{failure}; the detection models are missing; pass detect=False, or their folder as models"
            ),
        ),
        _ => failure.into(),
    })?;
    let nets = Arc::new(nets);
    read.insert(folder.to_owned(), nets.clone());
    Ok(nets)
}
