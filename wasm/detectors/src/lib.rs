//! The detector module. It is separate from the core, so that the first page does not wait for its code. It
//! contains only `inkpanel-detect`.

#[cfg(target_arch = "wasm32")]
mod boundary;
