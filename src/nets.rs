//! Detection models for faces and objects.

use crate::failure::Failure;
use inkpanel_engine::detect::Detectors;
use inkpanel_engine::framing::{Subject, subject_of};
use inkpanel_engine::page::import::Imported;
use std::path::Path;

/// File of the landmark model.
const LANDMARKS: &str = "landmarks.onnx";

/// The models that find faces and objects. They are loaded once for any number of albums. The files are
/// `faces.onnx` and `objects.onnx`, and optionally `landmarks.onnx`, which finds open eyes and mouths.
/// `cargo xtask models` makes them, and releases have them next to the command line.
pub struct Nets(Detectors);

impl Nets {
    /// Reads the models from a folder.
    ///
    /// # Errors
    /// `no-models` if a file is missing; `detector` if a file is not the expected model.
    pub fn open(folder: impl AsRef<Path>) -> Result<Self, Failure> {
        let file = |name: &str| {
            let file = folder.as_ref().join(name);
            std::fs::read(&file)
                .map_err(|error| Failure::new("no-models", format!("{}: {error}", file.display())))
        };
        let nets = Self::from_bytes(&file("faces.onnx")?, &file("objects.onnx")?)?;
        match file(LANDMARKS) {
            Ok(landmarks) => nets.with_landmarks(&landmarks),
            Err(_) => Ok(nets),
        }
    }

    /// Loads the models of faces and objects from the bytes of their files.
    ///
    /// # Errors
    /// `detector` if the bytes are not the expected model.
    pub fn from_bytes(faces: &[u8], objects: &[u8]) -> Result<Self, Failure> {
        Ok(Self(Detectors::new(faces, objects)?))
    }

    /// Adds the landmark model. Then photos with open eyes come before near-duplicates with shut eyes.
    ///
    /// # Errors
    /// `detector` if the bytes are not the expected model.
    pub fn with_landmarks(self, landmarks: &[u8]) -> Result<Self, Failure> {
        Ok(Self(self.0.with_landmarks(landmarks)?))
    }

    /// Models that are loaded already.
    #[doc(hidden)]
    #[must_use]
    pub fn new(detectors: Detectors) -> Self {
        Self(detectors)
    }

    pub(crate) fn look(&self, photo: &Imported) -> Result<Vec<Subject>, Failure> {
        Ok(self.0.detect(&photo.work)?.into_iter().map(subject_of).collect())
    }
}
