//! Preview of a mask during correction: the background is dark, and a line of light and shade runs along the
//! edge.

use super::WITHIN;
use crate::raster::guided::refined;
use crate::raster::resize::{Region, fit, resample, resample_image};
use crate::raster::{Image, Plane};

/// Pixels of the picture along its longer side: as many as a dialog has room for, and no more than can be drawn 60 times a second.
const LONGEST: usize = 800;
/// How dark it is beside the subject, 0 to 255.
const SHADE: u16 = 168;

/// The overlay that shows a mask on its photo.
pub struct View {
    photo: Image,
    /// Red, green, blue and how much it hides, row by row.
    rgba: Vec<u8>,
}

impl View {
    /// Creates the overlay of a photo or of a smaller copy.
    #[must_use]
    pub fn new(photo: &Image) -> Self {
        let (width, height) = fit(photo.width(), photo.height(), LONGEST);
        let photo = resample_image(photo, Region::whole(photo.width(), photo.height()), width, height);
        Self { rgba: vec![0; 4 * width * height], photo }
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> (usize, usize) {
        (self.photo.width(), self.photo.height())
    }

    /// The mask over the photo, RGBA row by row. `fine` uses the photo's own edges, as on pages. It is too
    /// slow during a stroke.
    pub fn draw(&mut self, mask: &Plane, fine: bool) -> &[u8] {
        let (width, height) = self.size();
        let whole = Region::whole(mask.width(), mask.height());
        let shares = if fine {
            let scale = ((width * height) as f32 / (1920.0 * 1080.0)).sqrt();
            refined(mask, whole, &self.photo, scale)
        } else {
            resample(mask, whole, width, height)
        };
        for (y, row) in self.rgba.chunks_exact_mut(4 * width).enumerate() {
            let here = shares.row(y);
            let (above, below) = (shares.row(y.saturating_sub(1)), shares.row((y + 1).min(height - 1)));
            for (x, pixel) in row.chunks_exact_mut(4).enumerate() {
                let share = here[x];
                let beside = [here[x.saturating_sub(1)], here[(x + 1).min(width - 1)], above[x], below[x]];
                let within = share >= WITHIN;
                let edge = beside.into_iter().any(|other| (other >= WITHIN) != within);
                let light = if edge && within { 255 } else { 0 };
                let hides = if edge { 255 } else { (SHADE * u16::from(255 - share) / 255) as u8 };
                pixel.copy_from_slice(&[light, light, light, hides]);
            }
        }
        &self.rgba
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beside_the_subject_it_is_dark_and_its_edge_is_a_line() {
        let plane = |dark: u8| Plane::from_fn(1600, 800, move |x, _| if x < 800 { dark } else { 250 });
        let photo = Image::from_rgb([plane(10), plane(20), plane(30)]).unwrap();
        let mut view = View::new(&photo);
        assert_eq!(view.size(), (800, 400));
        let mask = Plane::from_fn(320, 160, |x, _| if x < 160 { 255 } else { 0 });
        for fine in [false, true] {
            let rgba = view.draw(&mask, fine).to_vec();
            let at = |x: usize| &rgba[4 * (200 * 800 + x)..][..4];
            assert_eq!((at(10), at(790)), (&[0, 0, 0, 0][..], &[0, 0, 0, SHADE as u8][..]), "{fine}");
            let line: Vec<_> =
                (0..799).filter(|x| at(*x)[0] == 255 && at(*x + 1) == [0, 0, 0, 255]).collect();
            assert_eq!(line.len(), 1, "{fine}");
            assert!(line[0].abs_diff(399) < 3, "{line:?}");
        }
        let all = view.draw(&Plane::filled(320, 160, 255), true).to_vec();
        assert!(all.chunks_exact(4).all(|pixel| pixel[3] == 0));
    }
}
