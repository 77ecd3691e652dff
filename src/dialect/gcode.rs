//! Plain G-code as LinuxCNC reads it, that of partc included.

use crate::sema::gcode;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "gcode",
    name: "plain G-code (LinuxCNC)",
    extensions: &["ngc", "gcode"],
    recognizes,
    turns: false,
    run: gcode::run,
    check_form: gcode::check_form,
    check_unexecuted: None,
    comment: ["(", "[", "]", ")"],
    numbers_by_one: false,
    survey: gcode::survey,
    cycles: Vec::new,
};

/// partc printed it.
fn recognizes(head: &[u8]) -> bool {
    head.split(|b| *b == b'\n').take(2).any(|line| line.starts_with(b"(partc "))
}
