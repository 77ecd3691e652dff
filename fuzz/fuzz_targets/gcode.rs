#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| partc_fuzz::targets::gcode(bytes));
