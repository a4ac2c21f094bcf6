//! # Images of Inkpanel
//!
//! Planes of pixels, and what reads and changes them. This crate is the lowest layer of Inkpanel, and is compiled for speed.
//!
//! | module | content |
//! |---|---|
//! | [`error`] | the error type of all crates |
//! | [`raster`] | planar u8 images, decoding, resampling, masks |
//! | [`simd`] | row kernels on SIMD lanes |
//! | [`order`] | sorting with little code |

pub mod error;
#[cfg(target_arch = "wasm32")]
mod js_error;
pub mod order;
pub mod raster;
pub mod simd;

pub use error::{Error, Result};
