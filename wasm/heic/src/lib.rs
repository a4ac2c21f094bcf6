//! The wasm module of the HEIC decoder.
//!
//! The page loads it with the first HEIC photo that the browser cannot decode. It is a separate file, so that a host can leave it out.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
#[cfg(target_arch = "wasm32")]
#[path = "../../converted.rs"]
pub mod converted;
