//! What partc prints for a tap is a program of a language that partc reads: compiled again, for any target, it taps the same hole.

use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

/// A program with taps in the words of a control: dialect, file, what has to be said of it, text.
struct Source {
    dialect: &'static str,
    file: &'static str,
    settings: &'static str,
    text: &'static str,
}

const SINUMERIK: &str = "[control]\ntool_change = \"m6\"\n";

const SOURCES: &[Source] = &[
    Source {
        dialect: "sinumerik",
        file: "PART.MPF",
        settings: SINUMERIK,
        text: "T1 M6\nD1\nG17 G54 G90 G0 X10 Y20 Z50\nS500 M3\nCYCLE84(10,0,2,-15,,0,5,,1.25,0,400,400)\nG0 X20\n\
               CYCLE84(10,0,2,-15,,0,5,,-1,0,300,300)\nG0 X30 Z2\nSPOS=0\nG331 Z-10 K1.5 S300\nG332 Z2\nG0 X40\n\
               G331\nZ-8 K0.7\nG332\nZ2\nG0 Z50\nM30\n",
    },
    Source {
        dialect: "klartext",
        file: "PART.H",
        settings: "",
        text: "0 BEGIN PGM PART MM\n1 TOOL CALL 1 Z S500\n2 L X+10 Y+20 Z+50 R0 FMAX\n\
               3 CYCL DEF 207 RIGID TAPPING Q200=2 Q201=-15 Q239=+1.25 Q203=+0 Q204=+20\n4 CYCL CALL\n\
               5 CYCL DEF 207 RIGID TAPPING Q200=2 Q201=-10 Q239=-1 Q203=+0 Q204=+20\n6 L X+30 FMAX M99\n7 L Z+50 FMAX\n\
               8 END PGM PART MM\n",
    },
    Source {
        dialect: "gcode",
        file: "PART.ngc",
        settings: "",
        text: "G21 G90 G17 G94 G40 G49 G80 G91.1\nT1 M6\nG54\nG0 X10 Y20 Z50\nS400 M3\nG0 Z2\nG33.1 Z-15 K1.25\nM5\nG0 Z50\nM30\n",
    },
];

/// Targets with a word for a tap.
const TARGETS: [&str; 6] = ["linuxcnc", "fanuc", "haas", "mazak", "sinumerik", "heidenhain"];

fn print(source: &Source, text: &str, name: &str) -> Compiled {
    // The angle at the start is said by some of them only.
    let tapping = "[output]\ntool_length = \"off\"\ntapping = \"as-target\"\n";
    let mut settings = settings(&format!("{}{tapping}", source.settings));
    settings.output.target = target::find(name).expect("a target");
    compile_bytes(source.file, text.as_bytes().to_vec(), source.dialect, &settings, &NoFiles)
}

/// The lines that tap, without the speeds that some of them say again; parameters of a dialog as numbers.
fn taps(text: &str) -> Vec<String> {
    const WORDS: [&str; 7] = ["G33.1 ", "G84 ", "G74 ", "G84.2 ", "G84.3 ", "G331 ", "G332 "];
    const PARAMETERS: [&str; 2] = ["Q239=", "CYCL CALL"];
    let taps = |line: &&str| WORDS.iter().chain(&PARAMETERS).any(|word| line.contains(word));
    let plain = |line: &str| {
        let words = line.split(' ').filter(|word| !word.starts_with('S') && word.parse::<u32>().is_err());
        words.collect::<Vec<_>>().join(" ")
    };
    text.lines().filter(taps).map(plain).collect()
}

#[test]
fn a_printed_tap_compiles_again_for_every_target_and_taps_the_same_hole() {
    for source in SOURCES {
        for between in SOURCES {
            let name = match between.dialect {
                "gcode" => "linuxcnc",
                "klartext" => "heidenhain",
                other => other,
            };
            let first = print(source, source.text, name);
            assert!(!first.has_errors(), "{} to {name}: {:?}", source.file, first.rendered);
            for target in TARGETS {
                let again = print(between, &first.output, target);
                let what = format!("{} to {name} to {target}", source.file);
                assert!(!again.has_errors(), "{what}: {:?}\n{}", again.rendered, first.output);
                let direct = print(source, source.text, target);
                assert_eq!(taps(&again.output), taps(&direct.output), "{what}\n{}", first.output);
                assert!(!taps(&direct.output).is_empty(), "{what}: no tap");
            }
        }
    }
}
