//! The module of files other than PNG: all that `inkpanel::wasm_files`, `inkpanel::wasm_boards`, `inkpanel::wasm_comics` and `inkpanel::wasm_letters`
//! export. A crate of its own, so that each module has its own name among what cargo makes, and none is compiled again because
//! another was.

#[cfg(target_arch = "wasm32")]
use inkpanel as _;
