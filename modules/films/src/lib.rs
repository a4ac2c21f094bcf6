//! The module of films: all that `inkpanel::wasm_films` exports. A crate of its own, so that each module has its own name
//! among what cargo makes, and none is compiled again because another was.

#[cfg(target_arch = "wasm32")]
use inkpanel as _;
