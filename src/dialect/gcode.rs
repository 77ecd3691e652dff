//! Plain G-code as LinuxCNC reads it, that of partc included.

use crate::sema::gcode;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "gcode",
    name: "plain G-code (LinuxCNC)",
    extensions: &["ngc", "gcode"],
    recognizes,
    turns: false,
    folders: &[],
    run: gcode::run,
    check_form: gcode::check_form,
    check_unexecuted: None,
    comment: ["(", "[", "]", ")"],
    numbers_by_one: false,
    survey: gcode::survey,
    cycles: Vec::new,
};

/// Lines in which the head of an output says what printed it: behind `%`, the number of the program, and modes.
const HEAD: usize = 8;

/// partc printed it, for whichever receiver: who runs it says which programs are no plain G-code.
fn recognizes(head: &[u8]) -> bool {
    const NAMED: &[u8] = b"(partc ";
    let named = |line: &[u8]| line.get(..NAMED.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(NAMED));
    head.split(|b| *b == b'\n').take(HEAD).any(|line| named(line.trim_ascii()))
}
