//! The wasm module of shot detection and sound analysis.
//!
//! The video worker loads it with the first video.
//! The crate contains only the bindings, so the engine is compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
