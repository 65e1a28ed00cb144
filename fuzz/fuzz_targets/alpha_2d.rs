#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| delone_fuzz::hold("alpha-2d", bytes));
