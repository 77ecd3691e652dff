//! What one block leaves to the next: nothing leaks out of a described contour, and numbers of one program are none of
//! the next.

use partc::internals::text::files::NoFiles;
use partc::internals::text::{FileError, Files, Memory, Opened, Request};

use super::common::{Compiled, compile_bytes, settings};

const LATHE: &str = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ncompensation = \"control\"\n\
    [tools.1]\nradius = 0.8\norientation = 3\n";

/// A turning cycle with a contour that holds `inside` in its first block, and `after` it.
fn around_contour(inside: &str, after: &str) -> Compiled {
    let program = format!(
        "G18 G90 DIAMON G95 F0.2\nS500 M3\nT1 D1\nG0 X80 Z5\nCYCLE95(\"A1:E1\",2.5,0.1,,,0.3,0.2,0.1,9,,,)\nG0 X90 Z10\n\
         {after}\nM30\nA1:\nG18 G90 DIAM90\nG0 Z0 X0 {inside}\nG1 X30\nZ-22\nX46\nE1:\n"
    );
    compile_bytes("P.MPF", program.into_bytes(), "sinumerik", &settings(LATHE), &NoFiles)
}

/// CYCLE95 says where the way of its tool is partc's own.
const OWN_WAY: &str = "P8101";

#[test]
fn a_feed_of_a_positioning_axis_stays_inside_a_described_contour() {
    let said = around_contour("", "FA[Z]=100\nPOS[Z]=20");
    assert_eq!(said.codes(), [OWN_WAY], "{:?}", said.rendered);
    let inside = around_contour("FA[Z]=100", "POS[Z]=20");
    assert_eq!(inside.codes(), [OWN_WAY, "P2002"], "{:?}", inside.rendered);
}

#[test]
fn a_rounding_that_holds_on_stays_inside_a_described_contour() {
    let plain = around_contour("", "G1 X100 Z0\nZ-20\nX120");
    let inside = around_contour("RNDM=2", "G1 X100 Z0\nZ-20\nX120");
    let moves = |compiled: &Compiled| compiled.attempt.lines().rev().take(6).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(moves(&plain), moves(&inside));
    assert!(plain.attempt.contains("Z-20"), "{}", plain.attempt);
}

/// One program that others jump to.
struct Called(&'static str);

impl Files for Called {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let text = Box::new(Memory::new(self.0.as_bytes().to_vec()));
        Ok(Opened { name: request.name.to_owned(), identity: request.name.to_owned(), text })
    }
}

/// `body` jumps to a program that goes on with `next`; increments count with the offset.
fn jump(body: &str, next: &'static str) -> Compiled {
    let options = settings("[start]\nX = 50\n[control]\ng91_after_offset = \"with-offset\"\n");
    compile_bytes("P1.NC", format!("{body}\nJMP P13\n").into_bytes(), "mtc200", &options, &Called(next))
}

#[test]
fn an_increment_in_another_program_does_not_count_from_the_number_of_the_start() {
    // X stood at 50 at the start and at 80 when the program ended: G50 shifts the zero, and G91 goes on from the tool.
    let compiled = jump("G90 G00 X80", "G50 X10\nG91 G00 X5\nRET\n");
    assert!(!compiled.has_errors(), "{:?}", compiled.rendered);
    assert!(compiled.output.contains("X85"), "{}", compiled.output);
}
