//! Subject masks by the small `U²-Net`, at 320 x 320 pixels, for any kind of subject.
//!
//! X. Qin et al., "U²-Net: Going Deeper with Nested U-Structure for Salient Object Detection" (2020). It was trained on
//! stretched photos.

use super::model::{Net, Run};
use super::ssd::sigmoid;
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::resize::{Region, resample_image};
use inkpanel_image::raster::{Image, Matte, Plane};

/// Side of the model's input and output in pixels.
pub const SIDE: usize = 320;
/// Means and standard deviations of the photos that it was trained on, by channel.
const MEANS: [f32; 3] = [0.485, 0.456, 0.406];
const DEVIATIONS: [f32; 3] = [0.229, 0.224, 0.225];

/// The subject model, loaded.
pub struct Segmenter(Net<1>);

impl Segmenter {
    /// Loads the model (an ONNX file).
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Net::new(onnx, SIDE).map(Self)
    }

    /// Finds the subject mask of a photo, at most 320 pixels per side. A copy of 600 pixels per side is
    /// enough.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn look(&self, photo: &Image) -> Result<Matte> {
        matte(&self.shares(photo)?, (photo.width(), photo.height()))
    }

    /// Like [`look`](Self::look), in steps of some milliseconds.
    ///
    /// # Errors
    /// As [`look`](Self::look).
    pub fn begin(&self, photo: &Image) -> Result<Look> {
        let run = self.0.begin(&normalized(photo))?;
        Ok(Look { run, size: (photo.width(), photo.height()) })
    }

    /// The raw output of the model for the photo stretched to 320 x 320: the subject share of each pixel, 0
    /// to 1, row by row.
    ///
    /// # Errors
    /// As [`look`](Self::look).
    pub fn shares(&self, photo: &Image) -> Result<Vec<f64>> {
        shares(self.0.run(&normalized(photo))?)
    }
}

/// A detection in progress, step by step.
pub struct Look {
    run: Run<1>,
    size: (usize, usize),
}

impl Look {
    /// Runs one step. The last step returns the mask.
    ///
    /// # Errors
    /// As [`Segmenter::look`].
    pub fn advance(&mut self) -> Result<Option<Matte>> {
        let Some(outputs) = self.run.advance()? else { return Ok(None) };
        matte(&shares(outputs)?, self.size).map(Some)
    }
}

fn shares([logits]: [Vec<f32>; 1]) -> Result<Vec<f64>> {
    if logits.len() != SIDE * SIDE {
        return Err(Error::Detector("the file is not the subject model".into()));
    }
    Ok(logits.into_iter().map(sigmoid).collect())
}

/// `size` is the photo's.
fn matte(shares: &[f64], size: (usize, usize)) -> Result<Matte> {
    let samples = shares.iter().map(|share| (share * 255.0).round() as u8).collect();
    Ok(Matte::new(&Plane::from_samples(SIDE, SIDE, samples)?, size))
}

/// Three planes of 320 x 320 values.
fn normalized(photo: &Image) -> Vec<f32> {
    let reduced = resample_image(photo, Region::whole(photo.width(), photo.height()), SIDE, SIDE);
    let last = reduced.planes().len() - 1;
    let mut input = Vec::with_capacity(3 * SIDE * SIDE);
    for (channel, (mean, deviation)) in MEANS.into_iter().zip(DEVIATIONS).enumerate() {
        let samples = reduced.planes()[channel.min(last)].samples();
        input.extend(samples.iter().map(|sample| (f32::from(*sample) / 255.0 - mean) / deviation));
    }
    input
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_photo_is_stretched_and_gray_is_all_three_channels() {
        let gray = Image::from_luma(Plane::from_fn(640, 10, |x, _| (x / 3) as u8));
        let input = normalized(&gray);
        assert_eq!(input.len(), 3 * SIDE * SIDE);
        for (channel, (mean, deviation)) in MEANS.into_iter().zip(DEVIATIONS).enumerate() {
            let value = input[(channel * SIDE + 200) * SIDE + 150] * deviation + mean;
            assert!((value * 255.0 - 100.0).abs() <= 1.0, "{value}");
        }
    }
}
