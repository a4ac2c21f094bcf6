//! The wasm module of export formats other than PNG.
//!
//! The app loads it with the first such export. The crate contains only the bindings, so the engine is
//! compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boards;
#[cfg(target_arch = "wasm32")]
pub mod comics;
#[cfg(target_arch = "wasm32")]
pub mod files;
#[cfg(target_arch = "wasm32")]
#[path = "../../letters.rs"]
pub mod letters;
