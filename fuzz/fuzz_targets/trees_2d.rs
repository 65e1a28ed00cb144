#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| delone_fuzz::hold("trees-2d", bytes));
