//! What mends most findings of a code, where a finding says nothing better.

use crate::diag::{Answer, Code, Help};

/// The line of help for `code`.
#[cold]
pub(super) fn usual_help(code: &Code) -> Option<Help> {
    let text = match code.id {
        "P1003" => "remove the word, or put it into a block where it belongs",
        "K1007" => "write the unit after the name: `BEGIN PGM PART MM`",
        "K1009" => "correct the wrong one of the two",
        "K2010" => "check the number, or the parameter it comes from",
        "K2109" => "write the end point of the arc",
        "P2011" => "check the number, or the spelling of the name",
        "P2012" => "repeat with `CALL LBL 1 REP 2` or a conditional jump instead",
        "P2013" => "end the called program with END PGM",
        "P2020" => "assign a value before this block",
        "P2022" => "look where the parameters of the block get their values",
        "P2024" => "TONUMB makes a number of a text, TOCHAR a text of a number",
        "P2025" => "Q0 to Q1999, QL0 to QL499, QR0 to QR499 and QS0 to QS1999 exist",
        "P2026" => "look at the condition before this block",
        "K2401" => "put CYCL DEF of the machining cycle before it",
        "K2402" => "program all parts of the cycle, one after the other",
        "P9010" => "program the moves of the cycle as blocks",
        "K9002" => "write the end point of an element more",
        "K9003" => "program the approach and the departure as L and C blocks",
        "K9004" => "have the CAM system put out the tilted work for the target machine",
        "K9005" => {
            "remove the block, or set `[control] probing = \"leave-out\"` if the part is set up before the program"
        }
        "K9006" => "put the values into the program",
        "P9012" => "convert the block to L, C or CR",
        "K9010" => "put the points into the program: `PATTERN DEF POS1 (X+12 Y+20 Z+0)`",
        "P9011" => "remove the function if the path does not depend on it",
        "K9012" => "program the values: `CYCL DEF 7.1 X+60`",
        "K9014" => "remove the block if the part does not depend on it",
        "K9015" => "have the CAM system put out lines and arcs",
        "K9017" => "assign the text itself: `QS1 = \"TEXT\"`",
        "K9018" => "program the roughing as blocks",
        "O9002" => "the sense of rotation comes from M3 or M4, the speed is positive",
        "P4003" => "nest the calls less deeply",
        _ => return None,
    };
    Some(match code.id {
        "K9005" => Answer::key("control", "probing").help(text),
        _ => text.into(),
    })
}
