//! # Inkpanel
//!
//! Photos in, a stylised storyboard page out. The modules stand in the order that a photo travels; a stage
//! never imports a later one.
//!
//! | module | stage |
//! |---|---|
//! | [`raster`] | pixels: planar u8 images, decoding, resampling (under everything) |
//! | [`simd`] | row kernels on lanes (under `style`) |
//! | [`select`] | fingerprints, near-duplicate groups, the sharpest of each |
//! | [`layout`] | page templates: split trees, polygons, gutters, merges |
//! | [`framing`] | which photo goes into which panel, and the crop that fits it |
//! | [`style`] | chains of filter blocks in two layers |
//! | [`page`] | panels, borders and paper composed into one page; PNG |
//!
//! On top, without algorithms of their own: `wasm` (the web boundary) and `main.rs` (the command line).
//!
//! Invariants: no global state, no clock, no randomness but from a seed that the caller gives; every
//! spatial parameter of a style is in pixels of a 1920 x 1080 image and scaled to the render at hand.

pub mod error;
pub mod framing;
pub mod layout;
pub mod page;
pub mod raster;
pub mod select;
pub mod simd;
pub mod style;

#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use error::{Error, Result};
