//! Fuzzes `inkpanel_fuzz::painters`: `fuzz/README.md` says how.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::painters(bytes));
