//! Resampling: exact area means for reduction, Catmull-Rom for enlargement, each axis separately.
//!
//! Between the two axes the samples are rounded to u8, as Pillow does: a result is within 1 of the exact one.

use super::axis::Axis;
use super::separable::Separable;
use super::{Image, Plane};
#[cfg(feature = "decode")]
use crate::error::{Error, Result};

/// A rectangle in pixels of the source; may be fractional. Parts outside the source are ignored.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Region {
    /// Left edge.
    pub x: f64,
    /// Upper edge.
    pub y: f64,
    /// Width, above 0.
    pub width: f64,
    /// Height, above 0.
    pub height: f64,
}

impl Region {
    /// The whole of a `width` x `height` source.
    #[must_use]
    pub fn whole(width: usize, height: usize) -> Self {
        Self { x: 0.0, y: 0.0, width: width as f64, height: height as f64 }
    }
}

/// Resamples a region of a plane to `width` x `height` (sides of 0 are taken as 1).
///
/// Values are rounded to the nearest; a region of whole pixels at its own size is copied exactly.
#[must_use]
pub fn resample(source: &Plane, region: Region, width: usize, height: usize) -> Plane {
    let plan = plan(source.width(), source.height(), region, width, height);
    let [plane] = plan.planes::<1>(source.samples());
    plane
}

/// Resamples a region of an image. Saved chroma of another size keeps its size ratio to the image.
#[must_use]
#[inline(never)]
pub fn resample_image(source: &Image, region: Region, width: usize, height: usize) -> Image {
    let (width, height) = (width.max(1), height.max(1));
    let plan = plan(source.width(), source.height(), region, width, height);
    let resampled = |plane: &Plane| {
        let [plane] = plan.planes::<1>(plane.samples());
        plane
    };
    if let [r, g, b] = source.planes() {
        let planes = [resampled(r), resampled(g), resampled(b)];
        // Planes of one plan have one size, so this is always the first arm.
        return Image::from_rgb(planes).unwrap_or_else(|_| source.clone());
    }
    let luma = resampled(&source.planes()[0]);
    let Some(chroma) = source.chroma() else { return Image::from_luma(luma) };
    let chroma = chroma.each_ref().map(|plane| {
        let across = plane.width() as f64 / source.width() as f64;
        let down = plane.height() as f64 / source.height() as f64;
        let region = Region {
            x: region.x * across,
            y: region.y * down,
            width: region.width * across,
            height: region.height * down,
        };
        let size = |length: usize, ratio: f64| ((length as f64 * ratio).round() as usize).max(1);
        resample(plane, region, size(width, across), size(height, down))
    });
    Image::from_luma_chroma(luma, chroma)
}

#[cfg(feature = "decode")]
/// Reduces `C` interleaved channels (`C * width * height` bytes) straight to planes of another size.
///
/// # Errors
/// `buffer-size` if the number of bytes is different or a side is 0.
pub(crate) fn planes_of_interleaved<const C: usize>(
    samples: &[u8],
    (width, height): (usize, usize),
    (new_width, new_height): (usize, usize),
) -> Result<Vec<Plane>> {
    let expected = width.saturating_mul(height).saturating_mul(C);
    if samples.len() != expected || expected == 0 {
        return Err(Error::BufferSize { width, height, expected, actual: samples.len() });
    }
    if (width, height) == (new_width, new_height) {
        let mut planes: [Plane; C] = std::array::from_fn(|_| Plane::filled(width, height, 0));
        // Channel by channel, which compiles to SIMD.
        for (channel, plane) in planes.iter_mut().enumerate() {
            for (sample, pixel) in plane.samples_mut().iter_mut().zip(samples.as_chunks::<C>().0) {
                *sample = pixel[channel];
            }
        }
        return Ok(planes.into());
    }
    let plan = plan(width, height, Region::whole(width, height), new_width, new_height);
    Ok(plan.planes::<C>(samples).into())
}

/// The size of a `width` x `height` image made to have a long side of at most `longest`; never larger.
#[must_use]
pub fn fit(width: usize, height: usize, longest: usize) -> (usize, usize) {
    let long = width.max(height);
    if long <= longest {
        return (width.max(1), height.max(1));
    }
    let scaled = |side: usize| ((side as f64 * longest as f64 / long as f64).round() as usize).max(1);
    (scaled(width), scaled(height))
}

/// Both axes of one resampling.
fn plan(source_width: usize, source_height: usize, region: Region, width: usize, height: usize) -> Separable {
    let (x, region_width) = inside(region.x, region.width, source_width);
    let (y, region_height) = inside(region.y, region.height, source_height);
    Separable {
        width: source_width,
        height: source_height,
        across: Axis::new(source_width, x, region_width, width.max(1)),
        down: Axis::new(source_height, y, region_height, height.max(1)),
    }
}

/// Start and length of a stretch, brought inside `0..side`. A stretch without length becomes the whole side.
fn inside(start: f64, length: f64, side: usize) -> (f64, f64) {
    let side = side as f64;
    let from = start.clamp(0.0, side);
    let to = (start + length).clamp(0.0, side);
    if to - from > 1e-6 { (from, to - from) } else { (0.0, side) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The resampling in plain f64, without rounding between the passes.
    fn naive(source: &Plane, region: Region, width: usize, height: usize) -> Vec<f64> {
        let row = |y: usize| source.row(y).iter().map(|&v| f64::from(v)).collect::<Vec<_>>();
        let rows: Vec<Vec<f64>> = (0..source.height()).map(row).collect();
        let across: Vec<Vec<f64>> =
            rows.iter().map(|row| naive_axis(row, region.x, region.width, width)).collect();
        let mut out = vec![0.0; width * height];
        for x in 0..width {
            let column: Vec<f64> = across.iter().map(|row| row[x]).collect();
            for (y, value) in naive_axis(&column, region.y, region.height, height).into_iter().enumerate() {
                out[y * width + x] = value.clamp(0.0, 255.0);
            }
        }
        out
    }

    fn naive_axis(line: &[f64], origin: f64, length: f64, count: usize) -> Vec<f64> {
        let step = length / count as f64;
        let at = |i: isize| line[i.clamp(0, line.len() as isize - 1) as usize];
        (0..count)
            .map(|i| {
                let (from, to) = (origin + i as f64 * step, origin + (i + 1) as f64 * step);
                if step >= 1.0 {
                    let part = |x: usize| (to.min(x as f64 + 1.0) - from.max(x as f64)).max(0.0);
                    return (0..line.len()).map(|x| part(x) * line[x]).sum::<f64>() / step;
                }
                let centre = f64::midpoint(from, to) - 0.5;
                let (k, t) = (centre.floor() as isize, centre - centre.floor());
                let [a, b, c, d] = [at(k - 1), at(k), at(k + 1), at(k + 2)];
                b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
            })
            .collect()
    }

    /// Noise in 32..=223: Catmull-Rom cannot leave 0..=255 between the passes, where we clamp and the naive way does not.
    fn noise(width: usize, height: usize, seed: u64) -> Plane {
        let mut random = oorandom::Rand32::new(seed);
        Plane::from_fn(width, height, |_, _| random.rand_range(32..224) as u8)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn a_resampled_region_is_within_one_of_the_exact_one(
            (source_width, source_height) in (1usize..80, 1usize..80),
            (width, height) in (1usize..70, 1usize..70),
            (left, top, across, down) in (0.0f64..0.9, 0.0f64..0.9, 0.05f64..1.0, 0.05f64..1.0),
            seed in any::<u64>(),
        ) {
            let source = noise(source_width, source_height, seed);
            let (w, h) = (source_width as f64, source_height as f64);
            let region = Region { x: left * w, y: top * h, width: (1.0 - left) * across * w, height: (1.0 - top) * down * h };
            let out = resample(&source, region, width, height);
            let exact = naive(&source, region, width, height);
            for (&sample, exact) in out.samples().iter().zip(exact) {
                prop_assert!((f64::from(sample) - exact).abs() <= 1.14, "{sample} for {exact}");
            }
        }

        #[test]
        fn its_own_size_is_the_same_image(width in 1usize..70, height in 1usize..70, seed in any::<u64>()) {
            let source = noise(width, height, seed);
            prop_assert_eq!(&resample(&source, Region::whole(width, height), width, height), &source);
        }

        #[test]
        fn whole_pixels_are_cut_out_exactly(width in 2usize..70, height in 2usize..70, seed in any::<u64>()) {
            let source = noise(width, height, seed);
            let region = Region { x: 1.0, y: 1.0, width: (width - 1) as f64, height: (height - 1) as f64 };
            let out = resample(&source, region, width - 1, height - 1);
            let expected = Plane::from_fn(width - 1, height - 1, |x, y| source.at(x + 1, y + 1));
            prop_assert_eq!(&out, &expected);
        }

        #[test]
        fn a_flat_plane_stays_flat(value: u8, width in 1usize..300, height in 1usize..300) {
            let source = Plane::filled(97, 131, value);
            let out = resample(&source, Region { x: 0.3, y: 5.7, width: 90.1, height: 100.9 }, width, height);
            prop_assert!(out.samples().iter().all(|&sample| sample == value));
        }

        #[test]
        fn interleaved_and_planar_agree(width in 1usize..70, height in 1usize..70, seed in any::<u64>()) {
            let rgb = noise(53 * 3, 31, seed);
            let image = Image::from_interleaved_rgb(53, 31, rgb.samples()).unwrap();
            let expected = resample_image(&image, Region::whole(53, 31), width, height);
            let planes = planes_of_interleaved::<3>(rgb.samples(), (53, 31), (width, height)).unwrap();
            prop_assert_eq!(planes.as_slice(), expected.planes());
        }
    }

    #[test]
    fn a_long_reduction_keeps_its_mean() {
        let source = Plane::from_fn(5000, 3, |x, _| if x % 3 == 0 { 255 } else { 0 });
        let out = resample(&source, Region::whole(5000, 3), 7, 1);
        assert!(out.samples().iter().all(|&sample| sample == 85), "{:?}", out.samples());
    }

    #[test]
    fn a_region_beyond_the_source_is_cut_off() {
        let source = noise(10, 10, 1);
        let out = resample(&source, Region { x: 4.0, y: -3.0, width: 60.0, height: 5.0 }, 6, 2);
        assert_eq!(out, Plane::from_fn(6, 2, |x, y| source.at(x + 4, y)));
        let empty = Region { x: f64::NAN, y: 0.0, width: 0.0, height: f64::INFINITY };
        assert_eq!(resample(&source, empty, 10, 10), source);
    }

    #[test]
    fn saved_chroma_keeps_its_own_size_ratio() {
        let chroma = [Plane::filled(20, 10, 100), Plane::filled(20, 10, 150)];
        let image = Image::from_luma_chroma(noise(40, 20, 2), chroma);
        let out = resample_image(&image, Region::whole(40, 20), 80, 30);
        let [u, v] = out.chroma().unwrap();
        assert_eq!((out.width(), out.height()), (80, 30));
        assert_eq!((u, v), (&Plane::filled(40, 15, 100), &Plane::filled(40, 15, 150)));
    }

    #[test]
    fn fit_bounds_the_long_side_and_never_enlarges() {
        assert_eq!(fit(4000, 3000, 1600), (1600, 1200));
        assert_eq!(fit(3000, 4000, 1600), (1200, 1600));
        assert_eq!(fit(640, 480, 1600), (640, 480));
        assert_eq!(fit(10_000, 3, 100), (100, 1));
    }
}
