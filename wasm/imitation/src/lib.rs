//! The wasm module that finds a style for a picture.
//!
//! The app loads it with the first such picture. The crate contains only the bindings, so the engine is
//! compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
