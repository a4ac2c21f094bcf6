//! Fuzzes `inkpanel_fuzz::photo`: `cargo +nightly fuzz run photo`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::photo(bytes));
