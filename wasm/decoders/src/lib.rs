//! The wasm module of the rare image decoders.
//!
//! The page loads it with the first WebP, TIFF, GIF or CMYK photo.
//! It needs only the image crate, so that the engine is compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
#[cfg(target_arch = "wasm32")]
#[path = "../../converted.rs"]
pub mod converted;
