//! wasm bindings of the detector module.
//!
//! Boxes cross as JSON text, pixels as byte arrays. Every error is a JavaScript `Error` with a `code` in
//! addition to its `message`.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use inkpanel_detect::{
    Aesthetics, Detection, Faces, FirstLook, Landmarks, Look, Objects, Segmenter, has_readable_faces,
    worth_a_closer_look,
};
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::{Image, Plane};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The face detector. Photos are given as their red, green and blue planes one after the other; boxes are
/// `{label, score, x, y, width, height}` in fractions of the photo.
#[wasm_bindgen]
pub struct FaceDetector {
    net: Faces,
}

#[wasm_bindgen]
impl FaceDetector {
    /// Loads the model.
    #[wasm_bindgen(constructor)]
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Faces::new(onnx)? })
    }

    /// Finds faces of a photo, also one that fills it: `{boxes, closer}`. `closer` is `true` if [`Self::look_closer`] may find more, even
    /// without objects.
    pub fn look(&self, width: usize, height: usize, planes: &[u8]) -> Result<String> {
        let photo = image(width, height, planes)?;
        let boxes = self.net.search(&photo)?;
        json(&FirstLook { closer: worth_a_closer_look(&photo, &boxes), boxes })
    }

    /// Also finds small faces, and faces of the persons in `objects`. `boxes` are the result of the first search. The result
    /// replaces them.
    pub fn look_closer(
        &self,
        width: usize,
        height: usize,
        planes: &[u8],
        boxes: &str,
        objects: &str,
    ) -> Result<String> {
        json(&self.net.look_closer(&image(width, height, planes)?, &parsed(boxes)?, &parsed(objects)?)?)
    }
}

/// The landmark model, which finds the eyelids and lips of faces. Photos and boxes have the same form as in
/// [`FaceDetector`].
#[wasm_bindgen]
pub struct FaceReader {
    net: Landmarks,
}

#[wasm_bindgen]
impl FaceReader {
    /// Loads the model.
    #[wasm_bindgen(constructor)]
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Landmarks::new(onnx)? })
    }

    /// Whether a photo has faces that are large enough.
    pub fn suits(width: usize, height: usize, boxes: &str) -> Result<bool> {
        Ok(has_readable_faces((width, height), &parsed(boxes)?))
    }

    /// Adds the expressions of the largest faces. The result replaces `boxes`.
    pub fn read(&self, width: usize, height: usize, planes: &[u8], boxes: &str) -> Result<String> {
        let mut found = parsed(boxes)?;
        self.net.read(&image(width, height, planes)?, &mut found)?;
        json(&found)
    }
}

/// The object detector. Photos and boxes have the same form as in [`FaceDetector`].
#[wasm_bindgen]
pub struct ObjectDetector {
    net: Objects,
}

#[wasm_bindgen]
impl ObjectDetector {
    /// Loads the model.
    #[wasm_bindgen(constructor)]
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Objects::new(onnx)? })
    }

    /// Objects of a photo, an array of boxes.
    pub fn look(&self, width: usize, height: usize, planes: &[u8]) -> Result<String> {
        json(&self.net.look(&image(width, height, planes)?)?)
    }
}

/// The model that finds the subject mask of a photo. Photos have the same form as in [`FaceDetector`].
#[wasm_bindgen]
pub struct SubjectNet {
    net: Segmenter,
}

#[wasm_bindgen]
impl SubjectNet {
    /// Loads the model.
    #[wasm_bindgen(constructor)]
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Segmenter::new(onnx)? })
    }

    /// Begins to look at a photo.
    pub fn begin(&self, width: usize, height: usize, planes: &[u8]) -> Result<SubjectLook> {
        Ok(SubjectLook { look: self.net.begin(&image(width, height, planes)?)? })
    }
}

/// A look at a photo in steps of some milliseconds, so that its worker can rest in between.
#[wasm_bindgen]
pub struct SubjectLook {
    look: Look,
}

#[wasm_bindgen]
impl SubjectLook {
    /// One step. The last step returns the subject mask as text for `raster::Matte`.
    pub fn advance(&mut self) -> Result<Option<String>> {
        self.look.advance().map(|matte| matte.map(Into::into))
    }
}

/// The image-aesthetics model.
#[wasm_bindgen]
pub struct AestheticsNet {
    net: Aesthetics,
}

#[wasm_bindgen]
impl AestheticsNet {
    /// Loads the model.
    #[wasm_bindgen(constructor)]
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Aesthetics::new(onnx)? })
    }

    /// The predicted mean rating of an RGBA image, 1 to 10.
    pub fn score(&self, width: usize, height: usize, rgba: &[u8]) -> Result<f64> {
        self.net.score(&Image::from_rgba(width, height, rgba, [255; 3])?)
    }
}

fn image(width: usize, height: usize, planes: &[u8]) -> Result<Image> {
    let count = width.saturating_mul(height);
    let expected = count.saturating_mul(3);
    if count == 0 || planes.len() != expected {
        return Err(Error::BufferSize { width, height, expected, actual: planes.len() });
    }
    let plane = |i: usize| Plane::from_samples(width, height, planes[i * count..(i + 1) * count].to_vec());
    Image::from_rgb([plane(0)?, plane(1)?, plane(2)?])
}

fn parsed(boxes: &str) -> Result<Vec<Detection>> {
    serde_json::from_str(boxes).map_err(|error| internal(&error))
}

fn json(value: &impl serde::Serialize) -> Result<String> {
    serde_json::to_string(value).map_err(|error| internal(&error))
}

fn internal(error: &serde_json::Error) -> Error {
    Error::Detector(error.to_string())
}
