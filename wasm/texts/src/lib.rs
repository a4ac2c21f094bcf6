//! The wasm module of text files: their encodings, subtitles and scripts.
//!
//! The page loads it with the first subtitles or script, and with the first file that is not UTF-8.

#[cfg(target_arch = "wasm32")]
pub mod boundary;
