//! # Inkpanel's detectors
//!
//! Faces and objects in a photo, by two single-shot detectors that run on this device. A third model scores
//! the aesthetics of an image, a fourth finds the subject mask of a photo, and a fifth the eyelids and lips of faces.
//! No model recognises a person.
//!
//! The module is on the level of `select`: it reads a photo's pixels once and returns boxes for framing. It
//! is a separate crate, so that its wasm module contains no page code, and builds without models do not need
//! tract. The models are files (`www/models/`, made by `cargo xtask models`); the caller reads them.
//! Coordinates are fractions of the photo, so that results of a reduced copy are valid for the original.

mod aesthetics;
mod constants;
mod enlarge;
mod faces;
mod landmarks;
mod letterbox;
mod light;
mod model;
mod objects;
mod operators;
mod planes;
mod prelu;
mod segment;
mod ssd;
mod weights;
mod winograd;

use serde::{Deserialize, Serialize};

pub use aesthetics::Aesthetics;
pub use faces::{Faces, worth_a_closer_look};
use inkpanel_image::error::Result;
use inkpanel_image::raster::Image;
pub use landmarks::{FaceMesh, Landmarks, has_readable_faces};
pub use objects::Objects;
pub use segment::{Look, SIDE as SEGMENT_SIDE, Segmenter};

/// Six points of a face, in fractions of the photo from the left and from the top.
///
/// Their order: right eye, left eye, tip of the nose, middle of the mouth, right ear, left ear. The right eye is the
/// person's right eye.
pub type FacePoints = [[f64; 2]; 6];

/// Eyes and mouth of a face, as ratios of distances in the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Expression {
    /// Distance of the lids of the person's right eye, in widths of the eye: about 0.2 if shut, and 0.3 if open.
    pub right_eye: f64,
    /// The left eye.
    pub left_eye: f64,
    /// Distance of the lips, in widths of the mouth: 0 if closed.
    pub mouth: f64,
    /// Height of the corners of the mouth above its middle, in widths of the mouth. It is negative in a sad face.
    pub smile: f64,
}

/// Something that was found in a photo. Its box lies inside the photo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// Points of a face. `None` for objects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(type = "ReadonlyArray<[number, number]>", optional))]
    pub points: Option<FacePoints>,
    /// Eyes and mouth of a face. `None` for objects and small faces, and without the landmark model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub expression: Option<Expression>,
    /// Light of a face, compared with its photo: 0 in the shade of a bright photo, 1 in light. `None` for objects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub light: Option<f64>,
}

/// Result of the first search for faces.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FirstLook {
    /// The faces.
    pub boxes: Vec<Detection>,
    /// Whether a second pass over parts of the photo may find more, even without objects.
    pub closer: bool,
}

/// Both detectors, ready to run. In the browser each has a separate worker.
pub struct Detectors {
    /// The first of the two.
    pub faces: Faces,
    /// The second.
    pub objects: Objects,
    /// The landmark model, which is optional.
    pub landmarks: Option<Landmarks>,
}

impl Detectors {
    /// Loads both models (ONNX files).
    ///
    /// # Errors
    /// `detector` if a file is not the expected model.
    pub fn new(faces: &[u8], objects: &[u8]) -> Result<Self> {
        Ok(Self { faces: Faces::new(faces)?, objects: Objects::new(objects)?, landmarks: None })
    }

    /// Adds the landmark model (an ONNX file), which finds the eyelids and lips of faces.
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn with_landmarks(self, onnx: &[u8]) -> Result<Self> {
        Ok(Self { landmarks: Some(Landmarks::new(onnx)?), ..self })
    }

    /// Finds faces and objects in a photo in colour, faces first, each from the surest to the least sure; a
    /// copy of 600 pixels or more a side is enough. Also searches small faces, and the heads of persons.
    ///
    /// # Errors
    /// `detector` if a model fails.
    pub fn detect(&self, photo: &Image) -> Result<Vec<Detection>> {
        let objects = self.objects.look(photo)?;
        let mut found = self.faces.look_closer(photo, &self.faces.search(photo)?, &objects)?;
        if let Some(landmarks) = &self.landmarks {
            landmarks.read(photo, &mut found)?;
        }
        found.extend(objects);
        Ok(found)
    }
}
