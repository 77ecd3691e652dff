//! What values of the control mean, in the words of a finding that asks for one.
//!
//! Source: K 5.6 and 5.7 (docs/sources.md).

use crate::machine::Axis;

/// Of Q100 to Q199; empty where every machine has its own.
pub(super) fn of_parameter(number: u32) -> &'static str {
    match number {
        100..=107 => "a value from the PLC",
        108 => "the radius of the active tool with its oversizes",
        112 => "the overlap factor of pockets",
        114 => "the length of the active tool",
        115 => "X where the probe touched, or the deviation of a length that was measured",
        116 => "Y where the probe touched, or the deviation of a radius that was measured",
        117 => "Z where the probe touched",
        118 => "the 4th axis where the probe touched",
        119 => "the 5th axis where the probe touched",
        120 => "the angle of A that the control computed for PLANE or cycle 19",
        121 => "the angle of B that the control computed for PLANE or cycle 19",
        122 => "the angle of C that the control computed for PLANE or cycle 19",
        123 => "the radius compensation: 0 R0, 1 RL, 2 RR, 3 R+, 4 R-",
        150..=199 => "a result of a touch probe cycle",
        _ => "",
    }
}

/// Of FN 18: SYSREAD, by ID, NR and IDX; empty where it is not told.
pub(super) fn of_system_data(id: u32, nr: u32, idx: Option<f64>) -> String {
    let index = idx.filter(|n| n.fract() == 0.0 && (1.0..=9.0).contains(n)).map(|n| n as usize);
    let axis = index.map_or("an axis".to_owned(), |n| Axis::ALL[n - 1].letter().to_string());
    match (id, nr) {
        (20, 2) => "the tool that is prepared".to_owned(),
        (20, 13) => "the spindle in use".to_owned(),
        (50, 11) => "the age of a tool in minutes".to_owned(),
        (51, _) => "a value of the pocket table".to_owned(),
        (52, 1) => "the pocket that a tool is in".to_owned(),
        (220, 3) => format!("the distance of the datum from the reference point along {axis}"),
        (220, 4) => format!("the shift of {axis} by the PLC"),
        (230, 2) => format!("the lower software limit of {axis}"),
        (230, 3) => format!("the upper software limit of {axis}"),
        (240, 1) => format!("the position of {axis} in machine coordinates"),
        (270, 1) => format!("the position of {axis} in the coordinates of the program"),
        (290, 1..=2) => "the kinematics in use".to_owned(),
        (320, 1) => "the time of the control in seconds".to_owned(),
        (350, _) => "a calibration value of the touch probe".to_owned(),
        (360, 1) => format!("the last touch point in {axis}"),
        (360, 2) => format!("the last touch point in {axis}, in machine coordinates"),
        (500, _) => "a value of the datum table".to_owned(),
        (502..=504, _) => "a value of the preset table".to_owned(),
        (510, _) => "a value of the pallet table".to_owned(),
        (530, 1) => "the row of the active preset".to_owned(),
        (530, 2) => "whether the preset is write-protected".to_owned(),
        _ => String::new(),
    }
}
