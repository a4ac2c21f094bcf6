//! The module of the nets, which is never in one with the core, so that the first page does not wait for their code. It is made of
//! `inkpanel-detect` alone.

#[cfg(target_arch = "wasm32")]
mod boundary;
