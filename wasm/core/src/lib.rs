//! The wasm module of the core, which the page loads first.
//!
//! It exports planning, page composition and filters.
//! The crate contains only the bindings, so the engine is compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
