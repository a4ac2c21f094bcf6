//! Detection: faces and objects in a photo, by two single-shot detectors that run on this device.
//!
//! Stands beside `select`: it looks at a photo's pixels once and gives boxes, which framing works with. The nets
//! are files (`www/models/`, made by `cargo xtask models`); whoever calls reads them. Everything is in fractions
//! of the photo, so that a reduced copy gives the answer for the original.

mod faces;
mod letterbox;
mod model;
mod objects;
mod operators;
mod ssd;

use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::raster::Image;
use faces::Faces;
use objects::Objects;

/// Something that was found in a photo. Its box lies inside the photo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Detection {
    /// `face`, or one of COCO's eighty kinds of objects.
    pub label: String,
    /// The detector's confidence, 0..1.
    pub score: f64,
    /// Left edge, 0..1.
    pub x: f64,
    /// Top edge, 0..1.
    pub y: f64,
    /// Width, 0..1.
    pub width: f64,
    /// Height, 0..1.
    pub height: f64,
}

/// What the first look at a photo found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Findings {
    /// Faces first, then objects, each from the surest to the least sure.
    pub boxes: Vec<Detection>,
    /// Whether [`Detectors::look_closer`] may find more faces.
    pub closer: bool,
}

/// Both detectors, ready to run.
pub struct Detectors {
    faces: Faces,
    objects: Objects,
}

impl Detectors {
    /// Reads the two nets (ONNX files).
    ///
    /// # Errors
    /// `detector` when a file is not the net that it should be.
    pub fn new(faces: &[u8], objects: &[u8]) -> Result<Self> {
        Ok(Self { faces: Faces::new(faces)?, objects: Objects::new(objects)? })
    }

    /// Finds faces and objects in a whole photo in colour; a copy of 600 pixels or more a side is enough.
    ///
    /// # Errors
    /// `detector` when a net fails.
    pub fn look(&self, photo: &Image) -> Result<Findings> {
        let mut found = self.look_for_faces(photo)?;
        found.boxes.extend(self.look_for_objects(photo)?);
        Ok(found)
    }

    /// The faces of [`Detectors::look`] alone.
    ///
    /// # Errors
    /// `detector` when the net fails.
    pub fn look_for_faces(&self, photo: &Image) -> Result<Findings> {
        let boxes = self.faces.look(photo)?;
        Ok(Findings { closer: faces::worth_a_closer_look(photo, &boxes), boxes })
    }

    /// The objects of [`Detectors::look`] alone.
    ///
    /// # Errors
    /// `detector` when the net fails.
    pub fn look_for_objects(&self, photo: &Image) -> Result<Vec<Detection>> {
        self.objects.look(photo)
    }

    /// Finds also small faces, in parts of the photo that overlap. `first` are the boxes of the first look; the
    /// answer is what to take in their place.
    ///
    /// # Errors
    /// `detector` when the net fails.
    pub fn look_closer(&self, photo: &Image, first: Vec<Detection>) -> Result<Vec<Detection>> {
        let (faces, objects): (Vec<_>, Vec<_>) =
            first.into_iter().partition(|found| found.label == faces::LABEL);
        let mut boxes = self.faces.look_closer(photo, &faces)?;
        boxes.extend(objects);
        Ok(boxes)
    }

    /// Both looks, the second where it is worth it.
    ///
    /// # Errors
    /// `detector` when a net fails.
    pub fn detect(&self, photo: &Image) -> Result<Vec<Detection>> {
        let first = self.look(photo)?;
        if first.closer { self.look_closer(photo, first.boxes) } else { Ok(first.boxes) }
    }
}
