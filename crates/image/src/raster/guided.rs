//! The guided filter: aligns the edges of a mask with the edges of its image.
//!
//! In every window, the mask is fitted by a linear function of the guide's luma. Each pixel gets the mean of
//! the fits of all windows that contain it. Windows end at the edge of the image.
//!
//! Source: He, Sun and Tang, "Guided Image Filtering", 2013.

use std::ops::Range;

use super::resize::{Region, resample};
use super::{Image, Plane};
use crate::simd::point::luma_plane;

/// Radius of a window in pixels of a 1920 x 1080 picture.
const RADIUS: f32 = 8.0;
/// How much of the guide's variance counts as noise, for luma of 0 to 1.
const EPSILON: f32 = 1e-4;

/// Side in pixels of the tiles of a mask that are filtered separately.
const TILE: usize = 64;

/// Enlarges a region of a small mask to the size of `guide`, an image of the same region, with its edges.
/// `scale` is the scale of lengths: 1 for an image of 1920 x 1080.
#[must_use]
pub fn refined(mask: &Plane, region: Region, guide: &Image, scale: f32) -> Plane {
    let (width, height) = (guide.width(), guide.height());
    let radius = (RADIUS * scale).round().max(1.0) as usize;
    guided(&luma_plane(guide), &resample(mask, region, width, height), radius, EPSILON)
}

/// Multiplies the steepness of a mask border by `by`.
pub fn steepen(mask: &mut Plane, by: i32) {
    for share in mask.samples_mut() {
        *share = (128 + by * (i32::from(*share) - 128)).clamp(0, 255) as u8;
    }
}

/// The mean of the window of each pixel of a mask.
#[must_use]
pub fn softened(mask: &Plane, radius: usize) -> Plane {
    let (width, height) = (mask.width(), mask.height());
    let reach = |at: usize, length: usize| (at.saturating_sub(radius), (at + radius + 1).min(length));
    let part = |(from, to): (usize, usize)| 1.0 / (to - from) as f64;
    let across: Vec<f64> = (0..width).map(|x| part(reach(x, width))).collect();
    // Sums of columns over the rows of the window, and of all columns before each. The sum of a window is a
    // difference, so it is correct even if the sum of all columns wraps around.
    let mut columns = vec![0_u32; width];
    let mut sums = vec![0_u32; width + 1];
    let mut out = mask.clone();
    let mut held = 0..0;
    for y in 0..height {
        let (top, bottom) = reach(y, height);
        for y in held.end..bottom {
            columns.iter_mut().zip(mask.row(y)).for_each(|(sum, &share)| *sum += u32::from(share));
        }
        for y in held.start..top {
            columns.iter_mut().zip(mask.row(y)).for_each(|(sum, &share)| *sum -= u32::from(share));
        }
        held = top..bottom;
        let mut all = 0_u32;
        for (sum, &column) in sums[1..].iter_mut().zip(&columns) {
            all = all.wrapping_add(column);
            *sum = all;
        }
        let down = part((top, bottom));
        let mean = |left: u32, right: u32, across: f64| {
            ((f64::from(right.wrapping_sub(left)) * (across * down)) as f32 + 0.5) as u8
        };
        let row = out.row_mut(y);
        // Complete windows are in the middle. Windows at both ends are cut off.
        let middle = radius.min(width)..width.saturating_sub(radius).max(radius.min(width));
        for x in (0..middle.start).chain(middle.end..width) {
            let (left, right) = reach(x, width);
            row[x] = mean(sums[left], sums[right], across[x]);
        }
        if let Some(&across) = across.get(middle.start) {
            let windows = sums.iter().zip(sums.get(2 * radius + 1..).unwrap_or_default());
            for (share, (&left, &right)) in row[middle].iter_mut().zip(windows) {
                *share = mean(left, right, across);
            }
        }
    }
    out
}

/// `mask` filtered by `guide`, which is of the same size.
#[must_use]
pub fn guided(guide: &Plane, mask: &Plane, radius: usize, epsilon: f32) -> Plane {
    // Windows of windows.
    where_uneven(mask, 2 * radius, &|part| guided_part((guide, mask), part, radius, epsilon))
}

/// A part of a picture: columns and rows.
struct Part {
    x: Range<usize>,
    y: Range<usize>,
}

impl Part {
    fn size(&self) -> (usize, usize) {
        (self.x.len(), self.y.len())
    }

    /// Its samples.
    fn of<'p>(&'p self, plane: &'p Plane) -> impl Iterator<Item = u8> + 'p {
        self.y.clone().flat_map(|y| plane.row(y)[self.x.clone()].iter().copied())
    }
}

/// Filters only the tiles of a mask within `reach` of a change, with `filter`. In constant areas every mean
/// is equal to the mask.
fn where_uneven(mask: &Plane, reach: usize, filter: &dyn Fn(&Part) -> Vec<u8>) -> Plane {
    let mut out = mask.clone();
    let tiles = |side: usize| (0..side).step_by(TILE).map(move |start| start..(start + TILE).min(side));
    let near =
        |tile: &Range<usize>, side: usize| tile.start.saturating_sub(reach)..(tile.end + reach).min(side);
    for down in tiles(mask.height()) {
        for across in tiles(mask.width()) {
            let part = Part { x: near(&across, mask.width()), y: near(&down, mask.height()) };
            let first = mask.at(part.x.start, part.y.start);
            // All of a row at once, rather than up to the first that differs.
            let even =
                |y: usize| mask.row(y)[part.x.clone()].iter().fold(0, |all, it| all | (it ^ first)) == 0;
            if part.y.clone().all(even) {
                continue;
            }
            let filtered = filter(&part);
            for y in down.clone() {
                let from = (y - part.y.start) * part.x.len() + across.start - part.x.start;
                out.row_mut(y)[across.clone()].copy_from_slice(&filtered[from..from + across.len()]);
            }
        }
    }
    out
}

fn guided_part((guide, mask): (&Plane, &Plane), part: &Part, radius: usize, epsilon: f32) -> Vec<u8> {
    let share = |sample: u8| f32::from(sample) / 255.0;
    let both = part.of(guide).zip(part.of(mask)).map(|(luma, shown)| (share(luma), share(shown)));
    let values: Vec<[f32; 4]> = both.map(|(luma, shown)| [luma * shown, shown, luma * luma, luma]).collect();
    let mut lines: Vec<[f32; 2]> = Vec::with_capacity(values.len());
    for [product, shown, square, luma] in means(&values, part.size(), radius) {
        let slope = (product - luma * shown) / (square - luma * luma + epsilon);
        lines.push([slope, shown - slope * luma]);
    }
    let lines = means(&lines, part.size(), radius);
    let fitted = lines.iter().zip(&values).map(|([slope, start], [.., luma])| slope * luma + start);
    fitted.map(|share| (share * 255.0 + 0.5) as u8).collect()
}

/// Means of the square window of each pixel, clipped at the edges, for several planes at once. Their sums are
/// independent, so they run in parallel.
fn means<const N: usize>(
    values: &[[f32; N]],
    (width, height): (usize, usize),
    radius: usize,
) -> Vec<[f32; N]> {
    let mut out = vec![[0.0; N]; values.len()];
    // Sums of columns over the rows of the window, and of all columns up to each.
    let mut columns = vec![[0.0f64; N]; width];
    let mut sums = vec![[0.0f64; N]; width + 1];
    let row = |y: usize| &values[y * width..(y + 1) * width];
    let reach = |at: usize, length: usize| (at.saturating_sub(radius), (at + radius + 1).min(length));
    let part = |(from, to): (usize, usize)| 1.0 / (to - from) as f64;
    let across: Vec<f64> = (0..width).map(|x| part(reach(x, width))).collect();
    let mut held = 0..0;
    for (y, out) in out.chunks_exact_mut(width).enumerate() {
        let (top, bottom) = reach(y, height);
        for y in held.end..bottom {
            for (sum, value) in columns.iter_mut().zip(row(y)) {
                (0..N).for_each(|n| sum[n] += f64::from(value[n]));
            }
        }
        for y in held.start..top {
            for (sum, value) in columns.iter_mut().zip(row(y)) {
                (0..N).for_each(|n| sum[n] -= f64::from(value[n]));
            }
        }
        held = top..bottom;
        let mut all = [0.0; N];
        for (sum, column) in sums[1..].iter_mut().zip(&columns) {
            (0..N).for_each(|n| all[n] += column[n]);
            *sum = all;
        }
        let down = part((top, bottom));
        for (x, (out, across)) in out.iter_mut().zip(&across).enumerate() {
            let (left, right) = reach(x, width);
            let (left, right) = (&sums[left], &sums[right]);
            (0..N).for_each(|n| out[n] = ((right[n] - left[n]) * (across * down)) as f32);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_cut_off_at_the_edges() {
        let values: Vec<[f32; 2]> = (0..35).map(|i| [((i * 7919) % 23) as f32, i as f32]).collect();
        let (width, height, radius) = (7, 5, 2);
        let got = means(&values, (width, height), radius);
        for y in 0..height {
            for x in 0..width {
                let within = |at: usize, middle: usize| at.abs_diff(middle) <= radius;
                let window: Vec<[f32; 2]> = (0..values.len())
                    .filter(|i| within(i % width, x) && within(i / width, y))
                    .map(|i| values[i])
                    .collect();
                for n in 0..2 {
                    let mean = window.iter().map(|value| value[n]).sum::<f32>() / window.len() as f32;
                    assert!((got[y * width + x][n] - mean).abs() < 1e-4);
                }
            }
        }
    }

    #[test]
    fn a_soft_mask_takes_the_guides_edge() {
        // A black object on white, with an imprecise mask.
        let guide = Plane::from_fn(80, 40, |x, _| if x < 43 { 20 } else { 230 });
        let mask = Plane::from_fn(80, 40, |x, _| (255.0 * ((46.0 - x as f32) / 8.0).clamp(0.0, 1.0)) as u8);
        let refined = guided(&guide, &mask, 8, EPSILON);
        assert!(refined.at(42, 20) > 170 && refined.at(43, 20) < 85, "{:?}", &refined.row(20)[36..50]);
        assert_eq!((refined.at(5, 20), refined.at(75, 20)), (255, 0));
    }

    #[test]
    fn tiles_are_as_the_whole() {
        // Round, so that tiles are even and uneven in every way.
        let (width, height, radius) = (300, 211, 5);
        let guide = Plane::from_fn(width, height, |x, y| ((x * 7919 + y * 104_729) % 251) as u8);
        let mask = Plane::from_fn(width, height, |x, y| {
            let far = (x as f32 - 170.0).hypot(y as f32 - 120.0);
            (255.0 * ((80.0 - far) / 6.0).clamp(0.0, 1.0)) as u8
        });
        let all = Part { x: 0..width, y: 0..height };
        let whole = guided_part((&guide, &mask), &all, radius, EPSILON);
        assert!(guided(&guide, &mask, radius, EPSILON).samples() == whole);
    }

    #[test]
    fn softened_planes_are_means_of_windows() {
        for (width, height, radius) in
            [(300, 211, 5), (40, 30, 20), (12, 70, 9), (5, 5, 8), (1, 1, 0), (9, 1, 4)]
        {
            let mask = Plane::from_fn(width, height, |x, y| ((x * 7919 + y * 104_729) % 251) as u8);
            let shares: Vec<[f32; 1]> = mask.samples().iter().map(|share| [f32::from(*share)]).collect();
            let means = means(&shares, (width, height), radius);
            let soft: Vec<u8> = means.iter().map(|[mean]| (mean + 0.5) as u8).collect();
            assert!(softened(&mask, radius).samples() == soft, "{width} x {height}, radius {radius}");
        }
    }

    #[test]
    fn any_size_is_filtered() {
        for (width, height) in [(1, 1), (1, 50), (50, 1), (3, 2)] {
            let plane = Plane::from_fn(width, height, |x, y| (x * 40 + y * 90) as u8);
            let filtered = guided(&plane, &plane, 8, EPSILON);
            assert_eq!((filtered.width(), filtered.height()), (width, height));
        }
    }
}
