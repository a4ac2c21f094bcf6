//! The pixel container of the whole product: planar u8, either luma or R, G, B.

use super::plane::Plane;
use crate::error::{Error, Result};

/// A luma image (one plane) or a colour image (R, G, B planes), all of one size.
///
/// A luma image may carry the U and V planes that To `GrayScale` saved, so that To Color can restore the
/// colours. They may have another size after a Size block.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Image {
    planes: Vec<Plane>,
    chroma: Option<[Plane; 2]>,
}

impl Image {
    /// A luma image.
    #[must_use]
    pub fn from_luma(y: Plane) -> Self {
        Self { planes: vec![y], chroma: None }
    }

    /// A luma image that remembers its chroma (U, V around 128).
    #[must_use]
    pub fn from_luma_chroma(y: Plane, chroma: [Plane; 2]) -> Self {
        Self { planes: vec![y], chroma: Some(chroma) }
    }

    /// A colour image.
    ///
    /// # Errors
    /// `buffer-size` when the planes differ in size.
    pub fn from_rgb(planes: [Plane; 3]) -> Result<Self> {
        let (width, height) = (planes[0].width(), planes[0].height());
        for plane in &planes[1..] {
            if (plane.width(), plane.height()) != (width, height) {
                return Err(Error::BufferSize {
                    width,
                    height,
                    expected: width * height,
                    actual: plane.samples().len(),
                });
            }
        }
        Ok(Self { planes: planes.into(), chroma: None })
    }

    /// A colour image of its red, green and blue samples, one plane after the other.
    ///
    /// # Errors
    /// `buffer-size` when there are not three times `width * height` of them, or none.
    pub fn from_rgb_planes(width: usize, height: usize, samples: &[u8]) -> Result<Self> {
        let count = width.saturating_mul(height);
        let expected = count.saturating_mul(3);
        if count == 0 || samples.len() != expected {
            return Err(Error::BufferSize { width, height, expected, actual: samples.len() });
        }
        let plane =
            |i: usize| Plane::from_samples(width, height, samples[i * count..(i + 1) * count].to_vec());
        Self::from_rgb([plane(0)?, plane(1)?, plane(2)?])
    }

    #[cfg(feature = "decode")]
    /// A colour image of three planes, or of one grey plane.
    pub(super) fn from_planes(planes: Vec<Plane>) -> Result<Self> {
        Self::from_rgb(<[Plane; 3]>::try_from(planes).unwrap_or_else(|mut planes| {
            let plane = planes.swap_remove(0);
            [plane.clone(), plane.clone(), plane]
        }))
    }

    /// A colour image from interleaved RGB bytes.
    ///
    /// # Errors
    /// `buffer-size` when `rgb` does not hold `3 * width * height` bytes or a side is 0.
    pub fn from_interleaved_rgb(width: usize, height: usize, rgb: &[u8]) -> Result<Self> {
        Self::from_interleaved::<3>(width, height, rgb)
    }

    /// A colour image from interleaved RGBA bytes, flattened on the paper colour.
    ///
    /// # Errors
    /// `buffer-size` when `rgba` does not hold `4 * width * height` bytes or a side is 0.
    pub fn from_rgba(width: usize, height: usize, rgba: &[u8], paper: [u8; 3]) -> Result<Self> {
        let mut image = Self::from_interleaved::<4>(width, height, rgba)?;
        if rgba.iter().skip(3).step_by(4).all(|&a| a == 255) {
            return Ok(image);
        }
        for (plane, paper) in image.planes.iter_mut().zip(paper) {
            for (sample, rgba) in plane.samples_mut().iter_mut().zip(rgba.chunks_exact(4)) {
                let (alpha, paper) = (u32::from(rgba[3]), u32::from(paper));
                *sample = ((u32::from(*sample) * alpha + paper * (255 - alpha) + 127) / 255) as u8;
            }
        }
        Ok(image)
    }

    fn from_interleaved<const N: usize>(width: usize, height: usize, bytes: &[u8]) -> Result<Self> {
        let expected = width.saturating_mul(height).saturating_mul(N);
        if expected == 0 || bytes.len() != expected {
            return Err(Error::BufferSize { width, height, expected, actual: bytes.len() });
        }
        let mut planes = [0; 3].map(|_| Plane::filled(width, height, 0));
        let [r, g, b] = &mut planes;
        let samples = r.samples_mut().iter_mut().zip(g.samples_mut()).zip(b.samples_mut());
        for (((r, g), b), pixel) in samples.zip(bytes.chunks_exact(N)) {
            (*r, *g, *b) = (pixel[0], pixel[1], pixel[2]);
        }
        Self::from_rgb(planes)
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.planes[0].width()
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.planes[0].height()
    }

    /// True for one luma plane, false for R, G, B.
    #[must_use]
    pub fn is_luma(&self) -> bool {
        self.planes.len() == 1
    }

    /// The one luma plane, or R, G and B.
    #[must_use]
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// The planes, to be changed in place.
    pub fn planes_mut(&mut self) -> &mut [Plane] {
        &mut self.planes
    }

    /// The saved U and V planes of a luma image.
    #[must_use]
    pub fn chroma(&self) -> Option<&[Plane; 2]> {
        self.chroma.as_ref()
    }

    /// Returns the planes and the saved chroma.
    #[must_use]
    pub fn into_parts(self) -> (Vec<Plane>, Option<[Plane; 2]>) {
        (self.planes, self.chroma)
    }

    /// Writes interleaved RGBA with an alpha of 255 into `out`, which must hold `4 * width * height` bytes.
    ///
    /// # Errors
    /// `buffer-size` when `out` has another size.
    pub fn write_rgba(&self, out: &mut [u8]) -> Result<()> {
        let (width, height) = (self.width(), self.height());
        let expected = width * height * 4;
        if out.len() != expected {
            return Err(Error::BufferSize { width, height, expected, actual: out.len() });
        }
        let plane = |i: usize| self.planes[i.min(self.planes.len() - 1)].samples();
        let samples = plane(0).iter().zip(plane(1)).zip(plane(2));
        for (pixel, ((&r, &g), &b)) in out.chunks_exact_mut(4).zip(samples) {
            pixel.copy_from_slice(&[r, g, b, 255]);
        }
        Ok(())
    }

    /// Interleaved RGBA with an alpha of 255.
    #[must_use]
    pub fn to_rgba(&self) -> Vec<u8> {
        let mut out = vec![0; self.width() * self.height() * 4];
        // The buffer has the right size by construction.
        let _ = self.write_rgba(&mut out);
        out
    }

    /// Interleaved RGB.
    #[must_use]
    pub fn to_rgb(&self) -> Vec<u8> {
        let plane = |i: usize| self.planes[i.min(self.planes.len() - 1)].samples();
        let mut out = vec![0; self.width() * self.height() * 3];
        let samples = plane(0).iter().zip(plane(1)).zip(plane(2));
        for (pixel, ((&r, &g), &b)) in out.chunks_exact_mut(3).zip(samples) {
            pixel.copy_from_slice(&[r, g, b]);
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rgba_survives_the_way_in_and_out() {
        let rgba: Vec<u8> = (0..5 * 3 * 4).map(|i| if i % 4 == 3 { 255 } else { (i * 7) as u8 }).collect();
        let image = Image::from_rgba(5, 3, &rgba, [255; 3]).unwrap();
        assert_eq!(image.to_rgba(), rgba);
        let rgb: Vec<u8> = rgba.chunks(4).flat_map(|pixel| pixel[..3].to_vec()).collect();
        assert_eq!(image.to_rgb(), rgb);
    }

    #[test]
    fn alpha_is_flattened_on_the_paper() {
        let image = Image::from_rgba(1, 1, &[200, 100, 0, 0], [10, 20, 30]).unwrap();
        assert_eq!(image.to_rgba(), [10, 20, 30, 255]);
        let image = Image::from_rgba(1, 1, &[200, 100, 0, 128], [0, 0, 0]).unwrap();
        assert_eq!(image.to_rgba(), [100, 50, 0, 255]);
    }

    #[test]
    fn planes_of_different_sizes_are_refused() {
        let planes = [Plane::filled(2, 2, 0), Plane::filled(2, 2, 0), Plane::filled(3, 2, 0)];
        assert_eq!(Image::from_rgb(planes).unwrap_err().code(), "buffer-size");
    }
}
