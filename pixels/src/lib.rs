//! Pixel code of Inkpanel. This crate is compiled for speed, the rest of Inkpanel for size. The crate
//! `inkpanel` re-exports its modules.

pub mod error;
pub mod order;
pub mod raster;
pub mod simd;
#[cfg(feature = "pages")]
pub mod style;
#[cfg(target_arch = "wasm32")]
pub mod thrown;

pub use error::{Error, Result};
