//! Fuzzes `inkpanel_fuzz::plan`: `cargo +nightly fuzz run plan`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::plan(bytes));
