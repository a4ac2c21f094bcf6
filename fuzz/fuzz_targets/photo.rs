//! Fuzzes `inkpanel_fuzz::photo`; see `fuzz/README.md`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::photo(bytes));
