//! The part of the reference, whole, for each target and unit.

use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// The part of the reference, as a mill and as a lathe make it.
const MILL: &str = "G54\nT1 M6\nS3000 M3\nG0 X0 Y0\nZ5\nG1 Z-1 F100\nX30 F200\nG3 X40 Y10 I0 J10\nG3 X40 Y10 I-10 J0\n\
                    G3 X40 Y10 Z-7 I-10 J0 TURN=2\nG4 F0.5\nG0 Z50\nM30\n";
const LATHE: &str = "DIAMON\nT1 D1\nS1000 M4\nG0 X40 Z2\nG95 G1 Z-10 F0.25\nG2 X50 Z-15 I5 K0\nG3 X60 Z-20 I0 K-5\nG4 F0.5\n\
                     LIMS=2500\nG96 S200 M4\nG1 X62\nG97 S800 M3\nG0 X19.4 Z5\nG33 Z-20 K1.5\nG0 X24\nZ5\nG1 Z4 F0.25\n\
                     G0 X100 Z50\nM30\n";

/// The whole output of the part, for each target and unit.
#[test]
fn the_part_of_the_reference_on_every_target() {
    for target in target::ALL {
        let lathe = target.frame.mill.is_none();
        let mut shown = String::new();
        for (part, kind) in [(MILL, "mill"), (LATHE, "lathe")] {
            if (kind == "lathe") != lathe && (lathe || target.frame.lathe.is_none()) {
                continue;
            }
            for units in ["mm", "inch"] {
                if units == "inch" && target.frame.inch_head.is_none() {
                    continue;
                }
                // What few can say is left out where it is refused, in steps.
                let by_hand = if target.tool.change.is_none() { "tool_change = \"stop\"\n" } else { "" };
                let part = if target.feed.per_revolution.is_none() {
                    part.replace("G95 G1", "G94 G1").replace("F0.25", "F250")
                } else {
                    part.to_owned()
                };
                let part = if target.motion.thread.is_none() { part.replace("G33 Z-20 K1.5\n", "") } else { part };
                let part = if target.spindle.cutting_speed.is_none() || units == "inch" {
                    part.replace("LIMS=2500\nG96 S200 M4\n", "").replace("G97 S800", "S800")
                } else {
                    part
                };
                let lacks_offsets = target.offsets.is_empty();
                let part = if lacks_offsets { part.replace("G54\nT1 M6\n", "") } else { part };
                let part = if target.arcs.helices { part } else { part.replace("G3 X40 Y10 Z-7 I-10 J0 TURN=2\n", "") };
                let macros = if target.m.listed { "rapid_feed = 6000\npass_m = [3, 5]\n" } else { "" };
                let by_hand = if lacks_offsets { "" } else { by_hand };
                let axis = if kind == "lathe" { "diameter_axis = \"X\"\n" } else { "" };
                let configuration = format!(
                    "[machine]\nkind = \"{kind}\"\n{axis}[control]\ntool_change = \"{}\"\n[output]\ntarget = \"{}\"\nunits = \"{units}\"\ndwell_unit = \"seconds\"\n{by_hand}{macros}",
                    if kind == "lathe" { "t" } else { "m6" },
                    target.name
                );
                let settings = settings(&configuration);
                let compiled = compile_bytes("PART.MPF", part.into_bytes(), "sinumerik", &settings, &NoFiles);
                assert!(!compiled.has_errors(), "{} {kind} {units}: {:?}", target.name, compiled.rendered);
                let text = compiled.output.replace(env!("CARGO_PKG_VERSION"), "VERSION");
                shown += &format!("{kind}, {units}\n\n{text}\n");
            }
        }
        insta::assert_snapshot!(format!("part_for_{}", target.name), shown);
    }
}
