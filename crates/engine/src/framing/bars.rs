//! Uniform bars at the edges of a photo: letterbox bars, white borders, the address line of a screenshot.

use super::pixel::{luma, rgb};
use crate::raster::Image;

/// Maximum difference of luma from the colour of a bar, in grey levels.
const LIKE: u32 = 12;
/// The part of a line that a bar fills. Lettering fills the rest.
const FLAT: f64 = 0.8;
/// The part of the first line after a bar that may look like it. A sky or a studio wall ends gradually.
const AFTER: f64 = 0.4;
/// Range of the width of a bar, as a part of the side.
const WIDTH: (f64, f64) = (0.012, 0.36);
/// Lines between a bar and the photo, blurred by compression, as a part of the side.
const EDGE: f64 = 0.008;
/// Samples of a line, at most.
const SAMPLES: usize = 240;

/// Widths of the bars at the left, top, right and bottom edge, in 255ths of the side. 0 without a bar.
pub(super) fn bars(image: &Image) -> [u8; 4] {
    let (width, height) = (image.width(), image.height());
    let tone = |x: usize, y: usize| luma(rgb(image, x, y));
    let bar = |count: usize, length: usize, at: &dyn Fn(usize, usize) -> u32| {
        let step = length.div_ceil(SAMPLES);
        let line = |i: usize| (0..length).step_by(step).map(move |j| at(i, j));
        let mut first: Vec<u32> = line(0).collect();
        first.sort_unstable();
        let own = first[first.len() / 2];
        let share =
            |i: usize| line(i).filter(|tone| tone.abs_diff(own) <= LIKE).count() as f64 / first.len() as f64;
        let limit = (WIDTH.1 * count as f64) as usize;
        let end = (0..limit).find(|&i| share(i) < FLAT)?;
        let soft = (EDGE * count as f64).ceil() as usize;
        let next = (end..=end + soft).find(|&i| i < count && share(i) <= AFTER)?;
        let part = next as f64 / count as f64;
        (end as f64 / count as f64 >= WIDTH.0).then(|| (255.0 * part).ceil().min(255.0) as u8)
    };
    if width < 16 || height < 16 {
        return [0; 4];
    }
    let found = [
        bar(width, height, &|i, j| tone(i, j)),
        bar(height, width, &|i, j| tone(j, i)),
        bar(width, height, &|i, j| tone(width - 1 - i, j)),
        bar(height, width, &|i, j| tone(j, height - 1 - i)),
    ];
    found.map(Option::unwrap_or_default)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    /// A textured picture at `left..right`, `top..bottom` of 200 x 160 pixels, on an area of one tone.
    fn framed(tone: u8, (left, right): (usize, usize), (top, bottom): (usize, usize)) -> Image {
        Image::from_luma(Plane::from_fn(200, 160, |x, y| {
            let inside = (left..right).contains(&x) && (top..bottom).contains(&y);
            if inside { (60 + (x * 31 + y * 17) % 120) as u8 } else { tone + ((x + y) % 3) as u8 }
        }))
    }

    #[test]
    fn bars_are_measured_at_each_edge() {
        let part = |pixels: usize, side: usize| (255 * pixels).div_ceil(side) as u8;
        assert_eq!(bars(&framed(0, (40, 160), (0, 160))), [part(40, 200), 0, part(40, 200), 0]);
        assert_eq!(bars(&framed(250, (0, 200), (12, 150))), [0, part(12, 160), 0, part(10, 160)]);
        assert_eq!(bars(&framed(0, (0, 200), (0, 160))), [0; 4]);
        assert_eq!(bars(&framed(9, (0, 1), (0, 160))), [0; 4], "a plain picture has no bars");
    }

    #[test]
    fn an_address_line_is_a_bar_and_a_studio_wall_is_none() {
        let mut plane = framed(250, (0, 200), (20, 160)).planes()[0].clone();
        for x in (30..90).step_by(2) {
            plane.row_mut(9)[x] = 40;
        }
        assert_eq!(bars(&Image::from_luma(plane))[1], 32);
        // A head in front of a white wall.
        let wall = Plane::from_fn(200, 160, |x, y| {
            if (x as f64 - 100.0).hypot(y as f64 - 90.0) < 50.0 { (50 + (x * 7 + y) % 90) as u8 } else { 252 }
        });
        assert_eq!(bars(&Image::from_luma(wall)), [0; 4]);
    }
}
