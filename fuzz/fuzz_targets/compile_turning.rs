//! Any bytes as a program: no panic, every finding has a place, the output is plain.
#![no_main]

use libfuzzer_sys::fuzz_target;
use partc::driver::Session;
use partc::machine::{Compensation, Settings};
use partc::text::files::NoFiles;
use partc::text::{Memory, Opened};

fuzz_target!(|bytes: &[u8]| {
    let mut settings = Settings::default();
    settings.limits.steps = 5_000;
    settings.limits.output_blocks = 5_000;
    settings.control.feed = Some(100.0);
    settings.output.compensation = Compensation::Control;
    let text = Box::new(Memory::new(bytes.to_vec()));
    let session = Session::new(Opened { name: "fuzz.nc".into(), identity: "fuzz".into(), text });
    let dialect = partc::dialect::find("heidenhain-turning").expect("a dialect");
    let mut out = Vec::new();
    session.compile(dialect, &settings, &NoFiles, &mut out, None).expect("memory takes everything");
    assert!(out.is_ascii());
    for found in session.diags.into_sorted() {
        assert!(found.label.loc.line >= 1 && found.label.loc.span.start as usize <= bytes.len());
    }
});
