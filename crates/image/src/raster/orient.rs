//! Rotations and reflections of EXIF and of videos: from sensor orientation to display orientation.

use super::{Image, Plane};
use crate::error::Result;
use crate::simd::mix::{LANES, load, transpose};

/// Turns an image upright. `orientation` is EXIF's 1..=8; anything else counts as 1.
pub(super) fn upright(image: Image, orientation: u8) -> Result<Image> {
    if !(2..=8).contains(&orientation) {
        return Ok(image);
    }
    let turned = |plane: &Plane| turned(plane, orientation);
    match image.planes() {
        [r, g, b] => Image::from_rgb([turned(r), turned(g), turned(b)]),
        planes => Ok(Image::from_luma(turned(&planes[0]))),
    }
}

/// Turns an image clockwise by `degrees`: 90, 180 or 270; anything else leaves it.
///
/// # Errors
/// None that an image with planes of one size can cause.
pub fn turned_clockwise(image: Image, degrees: u32) -> Result<Image> {
    let orientation = match degrees {
        90 => 6,
        180 => 3,
        270 => 8,
        _ => 1,
    };
    upright(image, orientation)
}

/// True when the turn swaps width and height.
pub(super) fn swaps_sides(orientation: u8) -> bool {
    (5..=8).contains(&orientation)
}

/// Each of the eight is a transposition or not, then a mirroring of each axis or not.
fn turned(plane: &Plane, orientation: u8) -> Plane {
    let mut plane = if swaps_sides(orientation) { transposed(plane) } else { plane.clone() };
    let width = plane.width();
    if matches!(orientation, 2 | 3 | 6 | 7) {
        plane.samples_mut().chunks_exact_mut(width).for_each(<[u8]>::reverse);
    }
    if matches!(orientation, 3 | 4 | 7 | 8) {
        let height = plane.height();
        for y in 0..height / 2 {
            let (upper, lower) = plane.samples_mut().split_at_mut((height - 1 - y) * width);
            upper[y * width..(y + 1) * width].swap_with_slice(&mut lower[..width]);
        }
    }
    plane
}

/// Rows to columns, in tiles: a whole column at a time would miss the cache at every sample.
fn transposed(plane: &Plane) -> Plane {
    let (width, height) = (plane.width(), plane.height());
    let mut out = Plane::filled(height, width, 0);
    let (whole_width, whole_height) = (width - width % LANES, height - height % LANES);
    for y in (0..whole_height).step_by(LANES) {
        for x in (0..whole_width).step_by(LANES) {
            let tile = std::array::from_fn(|i| load(plane.samples(), (y + i) * width + x));
            for (i, column) in transpose(tile).into_iter().enumerate() {
                out.row_mut(x + i)[y..y + LANES].copy_from_slice(&column.to_array());
            }
        }
    }
    for y in 0..height {
        let start = if y < whole_height { whole_width } else { 0 };
        for x in start..width {
            out.row_mut(x)[y] = plane.at(x, y);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_brings_the_left_column_to_the_top() {
        let image = Image::from_luma(Plane::from_fn(2, 3, |x, y| (10 * y + x) as u8));
        let samples =
            |degrees| turned_clockwise(image.clone(), degrees).unwrap().planes()[0].samples().to_vec();
        assert_eq!(samples(0), [0, 1, 10, 11, 20, 21]);
        assert_eq!(samples(90), [20, 10, 0, 21, 11, 1]);
        assert_eq!(samples(180), [21, 20, 11, 10, 1, 0]);
        assert_eq!(samples(270), [1, 11, 21, 0, 10, 20]);
    }

    #[test]
    fn the_eight_orientations_put_the_corners_where_exif_says() {
        // Position of row 0 and column 0 of the file (Exif 2.32, table of tag 274), as the position of the
        // file's pixel (x, y) of a 35 x 50 image.
        let (w, h) = (35usize, 50usize);
        let file = Plane::from_fn(w, h, |x, y| (x * 7 + y * 5) as u8);
        for orientation in 1..=8u8 {
            let out = turned(&file, orientation);
            let at = |x: usize, y: usize| match orientation {
                1 => out.at(x, y),
                2 => out.at(w - 1 - x, y),
                3 => out.at(w - 1 - x, h - 1 - y),
                4 => out.at(x, h - 1 - y),
                5 => out.at(y, x),
                6 => out.at(h - 1 - y, x),
                7 => out.at(h - 1 - y, w - 1 - x),
                _ => out.at(y, w - 1 - x),
            };
            for y in 0..h {
                for x in 0..w {
                    assert_eq!(at(x, y), file.at(x, y), "orientation {orientation} at {x}, {y}");
                }
            }
        }
    }
}
