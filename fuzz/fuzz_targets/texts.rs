//! Fuzzes `inkpanel_fuzz::texts`: `fuzz/README.md` says how.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::texts(bytes));
