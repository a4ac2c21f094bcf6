//! Fuzzes `inkpanel_fuzz::saved`; see `fuzz/README.md`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::saved(bytes));
