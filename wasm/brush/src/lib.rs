//! The wasm module of the mask brush.
//!
//! The page loads it when a user first edits a mask.
//! The crate contains only the bindings, so the engine is compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
