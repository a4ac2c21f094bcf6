//! BLADE: an image operator, learned from photos as a bank of small filters. The local edge selects the
//! filter of each place.
//!
//! ```text
//! bucket  halve luma; structure tensor; quantise its orientation, strength and coherence
//! filter  out(i) = sum over 7 x 7 of h(bucket(i), j) z(i + j), the same filter for R, G and B
//! ```
//!
//! A bank is a data file (`crates/style/src/banks/README.md`). It holds filters for a few strengths of its
//! operator. Between two strengths, the weights are interpolated. Below the first strength, they fade towards
//! the identity filter. Beyond the last strength, the filters run several times. A block is a descriptor and
//! a [`Trained`] bank: see `blocks/etf.rs`.
//!
//! Source: Getreuer et al., "BLADE: filter learning for general purpose computational photography", 2018
//! (arXiv 1711.10700).
//!
//! | module | for |
//! |---|---|
//! | [`bank`] | the file, and the filters of a strength |
//! | [`buckets`] | which filter each block of 2 x 2 pixels takes |

pub mod bank;
pub mod buckets;

use std::sync::OnceLock;

use crate::context::Context;
use crate::error::Result;
use crate::raster::resize::{Region, resample_image};
use crate::raster::{Image, Plane};
use crate::simd::blade::{Filter, MARGIN, filter_rows, widen};
use crate::simd::fine::Fine;
use crate::simd::point::luma_plane;
use bank::Bank;

/// A bank that is part of the program, read when it is first used.
#[derive(Debug)]
pub struct Trained {
    name: &'static str,
    bytes: &'static [u8],
    bank: OnceLock<Result<Bank>>,
}

impl Trained {
    /// The bank in the bytes of a file; `name` is for messages.
    #[must_use]
    pub const fn new(name: &'static str, bytes: &'static [u8]) -> Self {
        Self { name, bytes, bank: OnceLock::new() }
    }

    /// The bank.
    ///
    /// # Errors
    /// `invalid-bank`.
    pub fn bank(&self) -> Result<&Bank> {
        self.bank.get_or_init(|| Bank::parse(self.name, self.bytes)).as_ref().map_err(Clone::clone)
    }

    /// Runs the operator at a strength in the unit of the bank. If the unit is a length, it means pixels of
    /// this render.
    ///
    /// # Errors
    /// `invalid-bank`, or `cancelled` if the caller cancels.
    pub fn run(&self, strength: f32, image: Image, context: &mut Context<'_>) -> Result<Image> {
        run(self.bank()?, strength, image, context)
    }
}

/// Runs the operator of a bank at a strength. Strong settings of large prints exceed the reach of
/// `MOST_PASSES` passes. They run on a smaller image, whose larger pixels give the same look as on the
/// screen.
///
/// # Errors
/// `cancelled` if the caller cancels.
pub fn run(bank: &Bank, strength: f32, image: Image, context: &mut Context<'_>) -> Result<Image> {
    let most = bank.strongest() * (MOST_PASSES as f32).sqrt();
    if strength <= most {
        return run_here(bank, strength, image, context);
    }
    let (width, height) = (image.width(), image.height());
    let shrink = f64::from(most / strength);
    let side = |length: usize| ((length as f64 * shrink).round() as usize).max(1);
    let small = resample_image(&image, Region::whole(width, height), side(width), side(height));
    let small = run_here(bank, most, small, context)?;
    Ok(resample_image(&small, Region::whole(small.width(), small.height()), width, height))
}

/// More passes cost more than they show.
const MOST_PASSES: usize = 9;

fn run_here(bank: &Bank, strength: f32, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    // Passes of a smoothing add like variances.
    let passes = (strength / bank.strongest()).powi(2).ceil().clamp(1.0, MOST_PASSES as f32);
    let Some(filters) = bank.filters(strength / passes.sqrt()) else { return Ok(image) };
    let luma = luma_plane(&image);
    let (columns, rows) = (luma.width().div_ceil(2), luma.height().div_ceil(2));
    let mut places = context.take_plane(columns, rows);
    buckets::choose(&luma, bank.shape(), &mut places, context);
    for plane in image.planes_mut() {
        for _ in 0..passes as usize {
            context.check_cancelled()?;
            apply(plane, &places, &filters, context);
        }
    }
    context.give_plane(luma);
    context.give_plane(places);
    Ok(image)
}

/// Filters a plane in place. `places` has the filter of each block of 2 x 2 pixels.
pub fn apply(plane: &mut Plane, places: &Plane, filters: &[Filter], context: &mut Context<'_>) {
    const ROWS: usize = 8;
    let (width, height) = (plane.width(), plane.height());
    let length = width + MARGIN;
    let mut ring = context.blurs.take(length, ROWS);
    let put = |ring: &mut Fine, plane: &Plane, y: usize| widen(plane.row(y), ring.row_mut(y % ROWS));
    for y in 0..height.min(3) {
        put(&mut ring, plane, y);
    }
    for top in (0..height).step_by(2) {
        // The plane already has new values in the rows above. The ring buffer still has their old values.
        for y in [top + 3, top + 4] {
            if y < height {
                put(&mut ring, plane, y);
            }
        }
        let rows = std::array::from_fn(|k| {
            let y = (top + k).saturating_sub(3).min(height - 1);
            ring.row_clamped((y % ROWS) as isize)
        });
        let end = ((top + 2).min(height)) * width;
        let (first, second) = plane.samples_mut()[top * width..end].split_at_mut(width);
        filter_rows(rows, places.row(top / 2), filters, first, second);
    }
    context.blurs.give(ring);
}
