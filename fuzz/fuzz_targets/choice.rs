//! Fuzzes `inkpanel_fuzz::choice`: `cargo +nightly fuzz run choice`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::choice(bytes));
