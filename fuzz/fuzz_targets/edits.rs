//! Fuzzes `inkpanel_fuzz::edits`: `fuzz/README.md` says how.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| inkpanel_fuzz::edits(bytes));
