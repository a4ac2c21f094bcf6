//! The wasm module of lettering.
//!
//! The page loads it with the first text item.
//! The crate contains only the bindings, so the engine is compiled once for all modules.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
#[cfg(target_arch = "wasm32")]
#[path = "../../letters.rs"]
pub mod letters;
