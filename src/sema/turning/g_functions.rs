//! The G functions: what they are called, which words they take, and those that are refused by name.

use super::cycles::{self, Row};
use super::frames::ShiftOf;
use super::words::{Letters, letters};

/// What a G function does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Rapid,
    Line,
    Arc {
        ccw: bool,
        absolute: bool,
    },
    MachineRapid,
    ChangePoint,
    Dwell,
    ExactStop,
    /// Interpreter stop: the path is the same without.
    Nothing,
    SpeedLimit,
    PerMinute,
    PerRevolution,
    CuttingSpeed,
    Revolutions,
    CompensationOff,
    CompensationLeft,
    CompensationRight,
    Shift(ShiftOf),
    Clearance,
    OversizeParaxial,
    OversizeEquidistant,
    OversizeOff,
    SingleThread,
    /// G80
    EndOfContour,
    /// A cycle that a contour may follow.
    Cycle,
    Refused,
}

/// A row of the table.
#[derive(Debug)]
pub(super) struct Function {
    pub number: u16,
    pub kind: Kind,
    pub name: &'static str,
    /// Single letters it takes.
    pub letters: Letters,
    /// Longer addresses it takes.
    pub longs: &'static [&'static str],
    pub cycle: Option<&'static Row>,
}

const fn row(number: u16, kind: Kind, name: &'static str, words: &str, longs: &'static [&'static str]) -> Function {
    Function { number, kind, name, letters: letters(words), longs, cycle: None }
}

const fn cycle(number: u16) -> Function {
    let row = cycles::of(number);
    Function {
        number,
        kind: Kind::Cycle,
        name: row.signature.what,
        letters: row.letters(),
        longs: &[],
        cycle: Some(row),
    }
}

impl Function {
    /// Does it take this longer address?
    pub fn takes(&self, long: &str) -> bool {
        self.longs.contains(&long) || self.cycle.is_some_and(|cycle| cycle.takes(long))
    }
}

const fn refused(number: u16, name: &'static str) -> Function {
    row(number, Kind::Refused, name, "", &[])
}

const TRANSITIONS: &[&str] = &["AN", "BR"];

/// Every known function, by number.
pub(super) const TABLE: &[Function] = &[
    row(0, Kind::Rapid, "rapid traverse", "XZ", &[]),
    row(1, Kind::Line, "line", "XZABEQ", TRANSITIONS),
    row(2, Kind::Arc { ccw: false, absolute: false }, "arc", "XZRIKBEQ", &["BR"]),
    row(3, Kind::Arc { ccw: true, absolute: false }, "arc", "XZRIKBEQ", &["BR"]),
    row(4, Kind::Dwell, "dwell", "F", &[]),
    row(9, Kind::ExactStop, "exact stop", "", &[]),
    row(12, Kind::Arc { ccw: false, absolute: true }, "arc", "XZRIKBEQ", &["BR"]),
    row(13, Kind::Arc { ccw: true, absolute: true }, "arc", "XZRIKBEQ", &["BR"]),
    row(14, Kind::ChangePoint, "tool change point", "QD", &[]),
    row(26, Kind::SpeedLimit, "speed limit", "S", &[]),
    cycle(31),
    cycle(32),
    row(33, Kind::SingleThread, "single thread cut", "XZFBPCHEIK", &[]),
    refused(35, "metric thread"),
    cycle(36),
    row(40, Kind::CompensationOff, "nose radius compensation off", "", &[]),
    row(41, Kind::CompensationLeft, "nose radius compensation left", "", &[]),
    row(42, Kind::CompensationRight, "nose radius compensation right", "", &[]),
    row(47, Kind::Clearance, "clearance of cycles", "P", &[]),
    refused(48, "reduced rapid traverse"),
    row(50, Kind::OversizeOff, "oversize off", "", &[]),
    row(51, Kind::Shift(ShiftOf::Relative), "zero shift", "XZ", &[]),
    row(52, Kind::OversizeOff, "oversize off", "P", &[]),
    refused(53, "zero shift by machine parameter"),
    refused(54, "zero shift by machine parameter"),
    refused(55, "zero shift by machine parameter"),
    row(56, Kind::Shift(ShiftOf::Additive), "additive zero shift", "XZ", &[]),
    row(57, Kind::OversizeParaxial, "paraxial oversize", "XZ", &[]),
    row(58, Kind::OversizeEquidistant, "equidistant oversize", "P", &[]),
    row(59, Kind::Shift(ShiftOf::Absolute), "absolute zero shift", "XZ", &[]),
    refused(64, "interrupted feed"),
    cycle(71),
    refused(72, "counterboring"),
    refused(73, "tapping with contour reference"),
    cycle(74),
    row(
        80,
        Kind::EndOfContour,
        "end of contour",
        "",
        &["XS", "ZS", "XE", "ZE", "AC", "WC", "BS", "BE", "RC", "IC", "KC", "EC", "HC"],
    ),
    cycle(81),
    cycle(82),
    refused(83, "contour repeat cycle"),
    cycle(85),
    cycle(86),
    refused(87, "line with radius"),
    refused(88, "line with chamfer"),
    cycle(89),
    refused(93, "feed per tooth"),
    row(94, Kind::PerMinute, "feed per minute", "F", &[]),
    row(95, Kind::PerRevolution, "feed per revolution", "F", &[]),
    row(96, Kind::CuttingSpeed, "constant cutting speed", "S", &[]),
    row(97, Kind::Revolutions, "constant speed", "S", &[]),
    refused(147, "clearance of milling and drilling cycles"),
    refused(148, "selection of wear offsets"),
    refused(152, "zero shift of the C axis"),
    refused(192, "feed per minute of a rotary axis"),
    refused(193, "feed per tooth of the driven tool"),
    refused(195, "feed per revolution of the driven tool"),
    refused(196, "constant cutting speed of the driven tool"),
    refused(197, "constant speed of the driven tool"),
    refused(350, "simple longitudinal thread"),
    refused(351, "extended longitudinal thread"),
    refused(352, "tapered pipe thread"),
    refused(353, "taper thread"),
    row(701, Kind::MachineRapid, "rapid traverse in machine coordinates", "XZ", &[]),
    refused(702, "auxiliary blank"),
    refused(799, "thread milling"),
    refused(800, "thread milling"),
    refused(806, "thread milling"),
    cycle(810),
    refused(811, "rectangular recess turning"),
    refused(815, "contour recess turning"),
    cycle(817),
    cycle(818),
    cycle(819),
    cycle(820),
    refused(821, "rectangular recess turning"),
    refused(825, "contour recess turning"),
    cycle(827),
    cycle(828),
    cycle(829),
    refused(830, "contour-parallel roughing"),
    refused(835, "contour-parallel roughing with a neutral tool"),
    refused(840, "contour milling"),
    refused(860, "contour recessing"),
    refused(861, "axial contour recessing"),
    refused(862, "radial contour recessing"),
    refused(865, "axial rectangular recess"),
    refused(866, "recess"),
    cycle(869),
    cycle(890),
    refused(901, "actual values in variables"),
    refused(902, "zero shift in variables"),
    refused(903, "lag in variables"),
    row(909, Kind::Nothing, "interpreter stop", "", &[]),
    refused(920, "zero shifts off"),
    refused(921, "zero shifts and tool lengths off"),
];

/// The function of this number.
#[inline]
pub(super) fn find(number: u16) -> Option<&'static Function> {
    // The path functions stand at known places.
    if let Some(row) = TABLE.get(usize::from(number))
        && row.number == number
    {
        return Some(row);
    }
    let at = TABLE.binary_search_by_key(&number, |row| row.number).ok()?;
    TABLE.get(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_sorted() {
        assert!(TABLE.windows(2).all(|pair| pair[0].number < pair[1].number));
        assert_eq!(find(890).map(|row| row.name), Some("finishing"));
        assert!(find(5).is_none());
    }
}
