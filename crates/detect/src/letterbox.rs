//! Scales a part of a photo to fit the square input of a model, centred on black.

use inkpanel_image::raster::Image;
use inkpanel_image::raster::resize::{Region, resample_image};

/// Position of the model's square input on the photo. Points of the square are in 0..1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Letterbox {
    /// Position of the square on the photo: left edge in widths of the photo, top edge in heights.
    origin: [f64; 2],
    /// Sides of the square in widths and heights of the photo.
    scale: [f64; 2],
}

/// Converts `region` to a model's input: three planes of `side * side` values in -1..1, and their position.
pub(super) fn letterbox(photo: &Image, region: Region, side: usize) -> (Vec<f32>, Letterbox) {
    letterbox_with_margin(photo, region, side, side)
}

/// Like [`letterbox`], but the longer side of `region` has only `inner` of the `side` pixels. The rest is black.
pub(super) fn letterbox_with_margin(
    photo: &Image,
    region: Region,
    side: usize,
    inner: usize,
) -> (Vec<f32>, Letterbox) {
    let whole = [photo.width() as f64, photo.height() as f64];
    // The sides of the reduced region in whole pixels.
    let longer = region.width.max(region.height);
    let size = [region.width, region.height]
        .map(|length| ((length / longer * inner as f64).round() as usize).clamp(1, inner));
    let reduced = resample_image(photo, region, size[0], size[1]);
    let [left, top] = size.map(|length| (side - length) / 2);
    let mut input = vec![-1.0; 3 * side * side];
    for (channel, plane) in reduced.planes().iter().take(3).enumerate() {
        for y in 0..size[1] {
            let start = (channel * side + top + y) * side + left;
            for (value, sample) in input[start..].iter_mut().zip(plane.row(y)) {
                *value = f32::from(*sample) / 127.5 - 1.0;
            }
        }
    }
    let axis = |at: f64, length: f64, size: usize, before: usize, whole: f64| {
        let pixel = length / size as f64;
        ((at - before as f64 * pixel) / whole, side as f64 * pixel / whole)
    };
    let (x, width) = axis(region.x, region.width, size[0], left, whole[0]);
    let (y, height) = axis(region.y, region.height, size[1], top, whole[1]);
    (input, Letterbox { origin: [x, y], scale: [width, height] })
}

impl Letterbox {
    /// A box of the square as a box of the photo, both as left, top, right, bottom; cut off at the photo's edges.
    pub(super) fn to_photo(self, [left, top, right, bottom]: [f64; 4]) -> [f64; 4] {
        let place = |at: f64, axis: usize| (self.origin[axis] + at * self.scale[axis]).clamp(0.0, 1.0);
        [place(left, 0), place(top, 1), place(right, 0), place(bottom, 1)]
    }

    /// A point of the square as a point of the photo. Points outside the photo move to its edge.
    pub(super) fn point_to_photo(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y, ..] = self.to_photo([x, y, x, y]);
        [x, y]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_image::raster::Plane;

    fn photo(width: usize, height: usize) -> Image {
        let plane = |channel: usize| {
            Plane::from_fn(width, height, |x, y| if (x, y) == (0, 0) { 255 } else { 50 * channel as u8 })
        };
        Image::from_rgb([plane(0), plane(1), plane(2)]).unwrap()
    }

    #[test]
    fn a_photo_with_a_margin_takes_the_middle_of_the_square() {
        let (input, place) = letterbox_with_margin(&photo(80, 40), Region::whole(80, 40), 40, 20);
        let at = |x: usize, y: usize| input[1600 + y * 40 + x];
        assert!((at(9, 20) + 1.0).abs() < 1e-6 && (at(30, 20) + 1.0).abs() < 1e-6);
        assert!((at(15, 20) - (50.0 / 127.5 - 1.0)).abs() < 1e-6);
        let back = place.to_photo([0.25, 0.375, 0.5, 0.625]);
        assert!(back.iter().zip([0.0, 0.0, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{back:?}");
    }

    #[test]
    fn a_wide_photo_lies_in_the_middle_with_black_above_and_below() {
        let (input, place) = letterbox(&photo(80, 40), Region::whole(80, 40), 40);
        let at = |channel: usize, x: usize, y: usize| input[(channel * 40 + y) * 40 + x];
        assert!((at(1, 20, 9) + 1.0).abs() < 1e-6);
        assert!((at(1, 20, 10) - (50.0 / 127.5 - 1.0)).abs() < 1e-6);
        assert!(at(0, 0, 10) > at(0, 1, 10));
        assert!((at(2, 39, 30) + 1.0).abs() < 1e-6);
        let back = place.to_photo([0.25, 0.25, 0.5, 0.75]);
        assert!(back.iter().zip([0.25, 0.0, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{back:?}");
    }

    #[test]
    fn a_part_is_mapped_back_to_its_place() {
        let region = Region { x: 40.0, y: 10.0, width: 20.0, height: 30.0 };
        let (_, place) = letterbox(&photo(80, 40), region, 30);
        let back = place.to_photo([5.0 / 30.0, 0.0, 25.0 / 30.0, 1.0]);
        let expected = [0.5, 0.25, 0.75, 1.0];
        assert!(back.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{back:?}");
        let point = place.point_to_photo([5.0 / 30.0, 0.5]);
        assert!((point[0] - 0.5).abs() < 1e-9 && (point[1] - 0.625).abs() < 1e-9, "{point:?}");
        let outside = place.point_to_photo([-9.0, 9.0]);
        assert!(outside[0].abs() < 1e-9 && (outside[1] - 1.0).abs() < 1e-9, "{outside:?}");
    }
}
