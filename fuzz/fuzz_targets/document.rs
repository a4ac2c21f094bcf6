//! Fuzzes `inkpanel_fuzz::document`: `cargo +nightly fuzz run document`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::document(bytes));
