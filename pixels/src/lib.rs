//! # Inkpanel's pixels
//!
//! What runs over pixels, whole pictures at a time, and is therefore compiled for speed where the rest of
//! Inkpanel is compiled to be small. `inkpanel` gives its modules on under their own names.
//!
//! | module | for |
//! |---|---|
//! | [`error`] | the one error type |
//! | [`raster`] | planar u8 images, decoding, resampling |
//! | [`simd`] | row kernels on lanes |
//! | `style` | chains of filter blocks in two layers (feature `pages`) |
//! | [`order`] | sorting that weighs little in a module |

pub mod error;
pub mod order;
pub mod raster;
pub mod simd;
#[cfg(feature = "pages")]
pub mod style;
#[cfg(target_arch = "wasm32")]
pub mod thrown;

pub use error::{Error, Result};
