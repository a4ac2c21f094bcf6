//! Selection: which of many photos are worth a panel.
//!
//! Near-duplicates are found by their [`fingerprint`] and form [`groups`]. The photo with the best
//! [`sharpness`] of each group is selected, unless it is blurred. The [`verdict`] has the reason. Video
//! frames are photos as well: [`look`] samples a video, [`shots`] finds its shots, and [`stills`] selects
//! representative frames.

mod dissolves;
pub mod fingerprint;
pub mod groups;
pub mod look;
pub mod sharpness;
pub mod shots;
pub mod stills;
pub mod verdict;

pub use verdict::{DUPLICATE_THRESHOLD, DUPLICATE_THRESHOLD_RANGE, Reason, Settings, Verdict, choose};

use crate::raster::Image;
use crate::simd::point::luma_plane;

/// Measurements of a photo for selection.
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
