//! The module of masks corrected by hand: all that `inkpanel::wasm_brush` exports. A crate of its own, so that
//! each module has its own name among what cargo makes, and none is compiled again because another was.

#[cfg(target_arch = "wasm32")]
use inkpanel as _;
