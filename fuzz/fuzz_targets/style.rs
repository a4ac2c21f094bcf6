//! Fuzzes `inkpanel_fuzz::style`: `cargo +nightly fuzz run style`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::style(bytes));
