//! Chooses the filter of each block of 2 x 2 pixels by the structure tensor of halved luma.
//!
//! ```text
//! z        = means of 2 x 2 pixels
//! d1, d2   = Roberts' differences across the corners between four z
//! a, b, c  = d1 d1, d1 d2, d2 d2 over the gradient, smoothed along both axes
//! l1, l2   = ((a + c) +- sqrt((a - c)^2 + 4 b^2)) / 2
//! ```
//!
//! An even number of corners surrounds each z, so the smoothing also moves the corners back to the pixels.
//! Division by the gradient keeps one strong edge from deciding for all around it. Orientation is the sector
//! of (a - c, 2 b), strength is l1, in grey steps for a z, coherence is (sqrt l1 - sqrt l2) / (sqrt l1 + sqrt
//! l2).

use super::bank::Shape;
use crate::context::Context;
use crate::raster::Plane;
use crate::simd::blade::{self, Limits, TAPS, products, quantise, smooth_columns};

/// Corners before a pixel in its smoothing.
const BEFORE: usize = TAPS / 2 - 1;

/// Additional floats after a row that the last lanes may read.
const SLACK: usize = 8;

/// Writes the bucket of each block. `places` has half the sides of `luma`, rounded up.
pub fn choose(luma: &Plane, shape: &Shape, places: &mut Plane, context: &mut Context<'_>) {
    let (columns, rows) = (places.width(), places.height());
    let limits = Limits::new(&shape.strengths, &shape.coherences);
    let length = columns + TAPS + SLACK;
    // Two halved rows, a ring of three products of corners, and their sums.
    let mut memory = context.take_floats(length * (2 + 3 * TAPS + 3));
    memory.fill(0.0);
    let (halves, rest) = memory.split_at_mut(2 * length);
    let (ring, sums) = rest.split_at_mut(3 * TAPS * length);
    let (mut upper, mut lower) = halves.split_at_mut(length);
    halve(luma, 0, columns, upper);
    lower.copy_from_slice(upper);
    // Row j of corners is between the rows j - 1 and j of z, clamped to the plane.
    let mut corners = -(BEFORE as isize);
    for y in 0..rows {
        while corners <= (y + TAPS - 1 - BEFORE) as isize {
            if corners > 0 {
                std::mem::swap(&mut upper, &mut lower);
                halve(luma, (corners as usize).min(rows - 1), columns, lower);
            }
            let slot = corners.rem_euclid(TAPS as isize) as usize;
            products(upper, lower, &mut ring[slot * 3 * length..][..3 * length]);
            corners += 1;
        }
        let row = |k: usize| {
            let slot = (y + k + TAPS - BEFORE) % TAPS;
            &ring[slot * 3 * length..][..3 * length]
        };
        smooth_columns(std::array::from_fn(row), sums);
        let (a, rest) = sums.split_at(length);
        let (b, c) = rest.split_at(length);
        quantise([a, b, c], &limits, places.row_mut(y));
    }
    context.give_floats(memory);
}

/// Row `y` of halved luma, with BEFORE + 1 repeats of its ends on both sides.
fn halve(luma: &Plane, y: usize, columns: usize, out: &mut [f32]) {
    const LEAD: usize = BEFORE + 1;
    let last = luma.height() - 1;
    let (above, below) = (luma.row((2 * y).min(last)), luma.row((2 * y + 1).min(last)));
    blade::halve(above, below, &mut out[LEAD..LEAD + columns]);
    let (first, end) = (out[LEAD], out[LEAD + columns - 1]);
    out[..LEAD].fill(first);
    out[LEAD + columns..].fill(end);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::bank::ORIENTATIONS;

    fn shape() -> Shape {
        Shape { strengths: vec![2.0, 6.0, 14.0, 32.0], coherences: vec![1.0 / 3.0, 2.0 / 3.0] }
    }

    fn buckets(luma: &Plane) -> Plane {
        let mut places = Plane::filled(luma.width().div_ceil(2), luma.height().div_ceil(2), 255);
        choose(luma, &shape(), &mut places, &mut Context::default());
        places
    }

    /// Returns a ramp that rises in one direction by `slope` grey levels per pixel.
    fn ramp(degrees: f32, slope: f32) -> Plane {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Plane::from_fn(60, 60, |x, y| {
            (128.0 + slope * ((x as f32 - 30.0) * cos + (y as f32 - 30.0) * sin)) as u8
        })
    }

    #[test]
    fn every_orientation_has_a_bucket_of_its_own() {
        let mut seen = std::collections::BTreeSet::new();
        for i in 0..ORIENTATIONS {
            let degrees = (i as f32 + 0.5) * 180.0 / ORIENTATIONS as f32;
            let place = buckets(&ramp(degrees, 2.5)).at(15, 15);
            assert_eq!(buckets(&ramp(degrees + 180.0, 2.5)).at(15, 15), place, "half a turn changes nothing");
            seen.insert(place / 15);
        }
        assert_eq!(seen.len(), ORIENTATIONS);
    }

    #[test]
    fn strength_and_coherence_are_in_their_order() {
        let strength = |place: u8| place / 3 % 5;
        assert_eq!(
            buckets(&Plane::filled(30, 20, 90)).samples(),
            vec![buckets(&ramp(0.0, 0.0)).at(0, 0); 150]
        );
        // One grey step a pixel is two for a pixel of halved luma.
        let found: Vec<u8> =
            [0.0, 1.5, 3.5, 6.0].map(|slope| strength(buckets(&ramp(10.0, slope)).at(15, 15))).into();
        assert_eq!(found, [0, 1, 2, 2]);
        assert_eq!(buckets(&ramp(100.0, 3.0)).at(15, 15) % 3, 2, "a ramp has one direction");
        let mut random = oorandom::Rand32::new(4);
        let noise = Plane::from_fn(60, 60, |_, _| random.rand_u32() as u8);
        let weak = buckets(&noise).samples().iter().filter(|&&place| place % 3 < 2).count();
        assert!(weak > 800, "noise has no direction: {weak} of 900");
    }

    #[test]
    fn every_size_is_filled_within_the_bank() {
        for (width, height) in [(1, 1), (1, 67), (67, 1), (2, 3), (5, 4), (66, 67)] {
            let mut random = oorandom::Rand32::new(6);
            let luma = Plane::from_fn(width, height, |_, _| random.rand_u32() as u8);
            assert!(buckets(&luma).samples().iter().all(|&place| usize::from(place) < shape().buckets()));
        }
    }
}
