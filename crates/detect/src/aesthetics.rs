//! Aesthetic score of an image, by a model that was trained on people's ratings of photos.
//!
//! H. Talebi, P. Milanfar, "NIMA: Neural Image Assessment" (2018). It was trained on stretched images with
//! nearest-neighbour reduction; a smoother reduction lowers its scores.

use super::model::Net;
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::Image;

/// Side of the model's input in pixels.
const SIDE: usize = 224;
/// Highest rating. Ratings start at 1.
const MOST: usize = 10;

/// The image-aesthetics model, loaded.
pub struct Aesthetics(Net<1>);

impl Aesthetics {
    /// Loads the model (an ONNX file).
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Net::new(onnx, SIDE).map(Self)
    }

    /// The predicted mean rating of an image by people, from 1 to 10. Most photos are near 5.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn score(&self, picture: &Image) -> Result<f64> {
        let [logits] = self.0.run(&stretched(picture))?;
        if logits.len() != MOST {
            return Err(Error::Detector("the file has another model".into()));
        }
        Ok(mean(&logits))
    }
}

/// Resizes a picture by nearest neighbour to the model's input: three planes of 224 x 224 values in -1..1.
fn stretched(picture: &Image) -> Vec<f32> {
    let nearest = |i: usize, length: usize| (2 * i + 1) * length / (2 * SIDE);
    let (planes, (width, height)) = (picture.planes(), (picture.width(), picture.height()));
    let mut input = Vec::with_capacity(3 * SIDE * SIDE);
    for channel in 0..3 {
        // A gray picture has one plane, which is all three.
        let plane = &planes[if planes.len() < 3 { 0 } else { channel }];
        for y in 0..SIDE {
            let row = plane.row(nearest(y, height));
            input.extend((0..SIDE).map(|x| f32::from(row[nearest(x, width)]) / 127.5 - 1.0));
        }
    }
    input
}

/// The mean of the scores 1, 2, ... whose shares are the softmax of `logits`.
fn mean(logits: &[f32]) -> f64 {
    let most = logits.iter().copied().fold(f32::MIN, f32::max);
    let weights = logits.iter().map(|logit| f64::from(logit - most).exp());
    let (sum, all) = weights
        .zip(1..)
        .fold((0.0, 0.0), |(sum, all), (weight, score)| (sum + weight * f64::from(score), all + weight));
    sum / all
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_image::raster::Plane;

    #[test]
    fn the_nearest_pixels_of_a_stretched_picture_are_taken() {
        let plane = Plane::from_fn(448, 2, |x, y| if y == 0 { (x / 2) as u8 } else { 255 });
        let input = stretched(&Image::from_luma(plane));
        assert_eq!(input.len(), 3 * SIDE * SIDE);
        let at = |channel: usize, x: usize, y: usize| (input[(channel * SIDE + y) * SIDE + x] + 1.0) * 127.5;
        for channel in 0..3 {
            assert!((at(channel, 100, 111) - 100.0).abs() < 1e-3);
            assert!((at(channel, 100, 112) - 255.0).abs() < 1e-3);
        }
    }

    #[test]
    fn logits_become_a_mean_score() {
        assert!((mean(&[0.0; 10]) - 5.5).abs() < 1e-9);
        let mut sure = [0.0; 10];
        sure[7] = 900.0;
        assert!((mean(&sure) - 8.0).abs() < 1e-9);
    }
}
