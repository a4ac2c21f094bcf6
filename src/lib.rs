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
//! | `detect` | faces and objects, by two nets (feature `detect`) |
//! | [`layout`] | page templates: split trees, polygons, gutters, merges |
//! | [`framing`] | which photo goes into which panel, and the crop that fits it |
//! | [`style`] | chains of filter blocks in two layers |
//! | [`page`] | panels, borders and paper composed into one page; PNG, JPEG, PDF |
//!
//! On top, without algorithms of their own: `wasm`, `wasm_detect` and `wasm_words` with `wasm_files` (the web boundary, in three modules) and `main.rs` (the command line).
//!
//! Invariants: no global state, no clock, no randomness but from a seed that the caller gives; every
//! spatial parameter of a style is in pixels of a 1920 x 1080 image and scaled to the render at hand.

#[cfg(feature = "detect")]
pub mod detect;
pub mod error;
pub mod framing;
pub mod layout;
pub mod page;
pub mod raster;
pub mod select;
pub mod simd;
pub mod style;

#[cfg(all(target_arch = "wasm32", not(feature = "detect"), not(feature = "words")))]
pub mod wasm;
#[cfg(all(target_arch = "wasm32", feature = "detect"))]
pub mod wasm_detect;
#[cfg(all(target_arch = "wasm32", feature = "words"))]
pub mod wasm_files;
#[cfg(all(target_arch = "wasm32", feature = "words"))]
pub mod wasm_words;

pub use error::{Error, Result};
