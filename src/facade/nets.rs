//! The nets that find faces and objects.

use super::failure::Failure;
use crate::detect::Detectors;
use crate::framing::Subject;
use crate::page::import::Imported;
use std::path::Path;

/// The nets that find faces and objects, read once for any number of albums: `faces.onnx` and `objects.onnx`, which
/// `cargo xtask models` makes and which stand beside the released command line.
pub struct Nets(Detectors);

impl Nets {
    /// Reads both from a folder.
    ///
    /// # Errors
    /// `no-models` where a file is not there; `detector` where one is not the net that it should be.
    pub fn open(folder: impl AsRef<Path>) -> Result<Self, Failure> {
        let file = |name: &str| {
            let file = folder.as_ref().join(name);
            std::fs::read(&file)
                .map_err(|error| Failure::new("no-models", format!("{}: {error}", file.display())))
        };
        Self::from_bytes(&file("faces.onnx")?, &file("objects.onnx")?)
    }

    /// Reads the net of faces and that of objects from the bytes of their files.
    ///
    /// # Errors
    /// `detector` where one is not the net that it should be.
    pub fn from_bytes(faces: &[u8], objects: &[u8]) -> Result<Self, Failure> {
        Ok(Self(Detectors::new(faces, objects)?))
    }

    pub(super) fn look(&self, photo: &Imported) -> Result<Vec<Subject>, Failure> {
        Ok(self.0.detect(&photo.work)?.into_iter().map(Into::into).collect())
    }
}
