//! Fuzzes `inkpanel_fuzz::layout`: `cargo +nightly fuzz run layout`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::layout(bytes));
