//! # Inkpanel's pixels
//!
//! Pixel code of Inkpanel. This crate is compiled for speed, the rest of Inkpanel for size. The crate
//! `inkpanel` re-exports its modules.
//!
//! | module | content |
//! |---|---|
//! | [`error`] | the error type of all modules |
//! | [`raster`] | planar u8 images, decoding, resampling |
//! | [`simd`] | row kernels on SIMD lanes |
//! | `style` | chains of filter blocks in two layers (feature `pages`) |
//! | [`order`] | sorting with little code |

pub mod error;
#[cfg(target_arch = "wasm32")]
mod js_error;
pub mod order;
pub mod raster;
pub mod simd;
#[cfg(feature = "pages")]
pub mod style;

pub use error::{Error, Result};
