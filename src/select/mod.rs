//! Selection: which of many photos are worth a panel.
//!
//! Photos that show the same are found by their [`fingerprint`] and put into [`groups`]; of each group the
//! one with the best [`sharpness`] is kept, unless it is blurred; the [`verdict`] says why. Frames of a film
//! are photos, too: a [`look`] at many of them finds its [`shots`], and of these the [`stills`] that stand for it.

mod dissolves;
pub mod fingerprint;
pub mod groups;
pub mod look;
pub mod sharpness;
pub mod shots;
pub mod stills;
pub mod verdict;

pub use verdict::{Settings, THRESHOLD, THRESHOLDS, Verdict, choose};

use crate::raster::Image;
use crate::simd::point::luma_plane;

/// What selection compares.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// See [`fingerprint::fingerprint`].
    pub fingerprint: u64,
    /// See [`sharpness::gradient`]: comparable between photos that show the same.
    pub gradient: f32,
    /// See [`sharpness::paper`].
    pub paper: f32,
    /// See [`sharpness::laplacian`]: comparable across an album.
    pub laplacian: f32,
}

/// Measures a photo.
#[must_use]
pub fn measure(image: &Image) -> Measures {
    let luma = luma_plane(image);
    Measures {
        fingerprint: fingerprint::fingerprint(&luma),
        gradient: sharpness::gradient(&luma),
        paper: sharpness::paper(&luma),
        laplacian: sharpness::laplacian(&luma),
    }
}
