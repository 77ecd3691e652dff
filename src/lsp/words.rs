//! What the words of the languages mean, in a few words: for editors.

/// A word of a language: its spelling, and what it means. Numbers are written without leading zeros.
type Meaning = (&'static str, &'static str);

/// What `word` means in a dialect; `None` for what is not in the tables.
pub fn meaning(dialect: &str, word: &str) -> Option<&'static str> {
    let word = spelling(word);
    let tables: &[&[Meaning]] = match dialect {
        "klartext" => &[KLARTEXT, M],
        "sinumerik" => &[SINUMERIK, METRIC, G, M],
        "heidenhain-turning" => &[TURNING, M],
        "mtc200" => &[MTC200, METRIC, G, M],
        _ => &[GCODE, G],
    };
    tables.iter().find_map(|table| table.iter().find(|(name, _)| *name == word)).map(|(_, meaning)| *meaning)
}

/// All words of a dialect.
pub fn all(dialect: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let tables: [&'static [Meaning]; 4] = match dialect {
        "klartext" => [KLARTEXT, M, &[], &[]],
        "sinumerik" => [SINUMERIK, METRIC, G, M],
        "heidenhain-turning" => [TURNING, M, &[], &[]],
        "mtc200" => [MTC200, METRIC, G, M],
        _ => [GCODE, G, &[], &[]],
    };
    tables.into_iter().flatten().copied()
}

/// Upper case, without the zeros in front of a number: `g01` is `G1`.
fn spelling(word: &str) -> String {
    let word = word.to_ascii_uppercase();
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &word[letters.len()..];
    let number = digits.trim_start_matches('0');
    if digits.is_empty() || letters.len() != 1 {
        return word;
    }
    format!("{letters}{}", if number.is_empty() { "0" } else { number })
}

const M: &[Meaning] = &[
    ("M0", "program stop"),
    ("M1", "optional stop"),
    ("M2", "end of the program"),
    ("M3", "spindle clockwise"),
    ("M4", "spindle counter-clockwise"),
    ("M5", "spindle stop"),
    ("M6", "tool change"),
    ("M7", "mist coolant on"),
    ("M8", "coolant on"),
    ("M9", "coolant off"),
    ("M13", "spindle clockwise, coolant on"),
    ("M14", "spindle counter-clockwise, coolant on"),
    ("M19", "oriented stop of the spindle"),
    ("M30", "end of the program, and back to its start"),
];

const G: &[Meaning] = &[
    ("G0", "rapid traverse"),
    ("G1", "straight line at the feed"),
    ("G2", "arc clockwise"),
    ("G3", "arc counter-clockwise"),
    ("G4", "dwell"),
    ("G17", "working plane XY, tool axis Z"),
    ("G18", "working plane ZX, tool axis Y"),
    ("G19", "working plane YZ, tool axis X"),
    ("G33", "thread with a constant lead"),
    ("G40", "radius compensation off"),
    ("G41", "radius compensation, tool left of the contour"),
    ("G42", "radius compensation, tool right of the contour"),
    ("G54", "work offset 1"),
    ("G55", "work offset 2"),
    ("G56", "work offset 3"),
    ("G57", "work offset 4"),
    ("G90", "absolute coordinates"),
    ("G91", "incremental coordinates"),
    ("G94", "feed per minute"),
    ("G95", "feed per revolution"),
    ("G96", "constant cutting speed"),
    ("G97", "constant speed of the spindle"),
];

/// On LinuxCNC these two are cycles of lathes.
const METRIC: &[Meaning] = &[("G70", "inches"), ("G71", "millimetres")];

/// LinuxCNC.
const GCODE: &[Meaning] = &[
    ("G53", "coordinates of the machine, for this block"),
    ("G20", "inches"),
    ("G21", "millimetres"),
    ("G43", "tool length compensation"),
    ("G49", "tool length compensation off"),
    ("M0", "program stop"),
    ("M1", "optional stop"),
    ("M2", "end of the program"),
    ("M3", "spindle clockwise"),
    ("M4", "spindle counter-clockwise"),
    ("M5", "spindle stop"),
    ("M6", "tool change"),
    ("M7", "mist coolant on"),
    ("M8", "flood coolant on"),
    ("M9", "coolant off"),
    ("M30", "end of the program, and back to its start"),
];

const KLARTEXT: &[Meaning] = &[
    ("L", "straight line"),
    ("LP", "straight line to polar coordinates about the pole CC"),
    ("LN", "straight line with a surface normal"),
    ("CC", "pole, or centre of the next circle C"),
    ("C", "arc about CC, or the rotary axis C"),
    ("CR", "arc by its radius R"),
    ("CT", "arc, tangential to the element before"),
    ("CP", "arc about the pole by the polar angle PA; with IZ a helix"),
    ("CTP", "arc, tangential to the element before, to polar coordinates"),
    ("RND", "rounds the corner between the elements before and after"),
    ("CHF", "chamfer between the lines before and after"),
    ("APPR", "approaches the contour"),
    ("DEP", "departs from the contour"),
    ("PR", "polar radius from the pole"),
    ("PA", "polar angle about the pole, degrees from the first axis of the plane"),
    ("IPA", "polar angle by which the tool goes on: any number of turns"),
    ("DR+", "counter-clockwise"),
    ("DR-", "clockwise"),
    ("RL", "radius compensation, tool left of the contour"),
    ("RR", "radius compensation, tool right of the contour"),
    ("R0", "no radius compensation"),
    ("F", "feed, mm/min unless another unit is in force"),
    ("FMAX", "rapid traverse, for this block"),
    ("FU", "feed per revolution"),
    ("FZ", "feed per tooth"),
    ("LBL", "label: start of a section; LBL 0 is its end"),
    ("CALL", "calls a label, a program, or the last cycle"),
    ("REP", "so many repetitions of the section"),
    ("TOOL", "TOOL CALL changes the tool, TOOL DEF says its data or prepares it"),
    ("BLK", "BLK FORM: corners of the blank"),
    ("FN", "function of a Q parameter"),
    ("M89", "a cycle is called after every positioning block from here on"),
    ("M91", "coordinates of the machine, for this block"),
    ("M92", "coordinates from a point of the machine, for this block"),
    ("M97", "small steps of a contour are cut along the intersection"),
    ("M98", "open corners are cut to their end"),
    ("M99", "calls the last cycle after this block"),
    ("M103", "feed factor of plunging moves"),
    ("M120", "looks ahead along a compensated contour"),
    ("M128", "the tool tip stays while rotary axes turn"),
    ("M136", "feed per revolution"),
    ("M137", "feed per minute again"),
];

const SINUMERIK: &[Meaning] = &[
    ("ANG", "angle of the line in the plane, degrees from its first axis"),
    ("RND", "rounding at the end of the block"),
    ("RNDM", "rounding at every corner from here on"),
    ("CHF", "chamfer at the end of the block: the length of its hypotenuse"),
    ("CHR", "chamfer at the end of the block: the way along each element"),
    ("CR", "radius of the arc; below zero for the longer one"),
    ("AR", "opening angle of the arc"),
    ("AP", "polar angle about the pole"),
    ("RP", "polar radius from the pole"),
    ("CIP", "arc through a point between its ends"),
    ("CT", "arc, tangential to the element before"),
    ("TURN", "whole turns on top of the arc"),
    ("TRANS", "shifts the origin; what was shifted before goes"),
    ("ATRANS", "shifts the origin on from where it is"),
    ("ROT", "rotates the frame"),
    ("AROT", "rotates the frame on"),
    ("MIRROR", "mirrors axes"),
    ("SCALE", "scales axes"),
    ("DIAMON", "X is a diameter"),
    ("DIAMOF", "X is a radius"),
    ("AC", "absolute, for this word"),
    ("IC", "incremental, for this word"),
    ("MCALL", "calls a cycle after every move from here on"),
    ("LIMS", "highest speed under constant cutting speed"),
    ("SUPA", "no offset: coordinates of the machine, for this block"),
    ("GOTOF", "jumps forward"),
    ("GOTOB", "jumps back"),
    ("G53", "no offset, for this block"),
    ("G60", "exact stop"),
    ("G64", "continuous path"),
    ("G110", "pole, from the last position"),
    ("G111", "pole, from the origin"),
    ("G112", "pole, from the last pole"),
    ("G450", "arc round outside corners"),
    ("G451", "intersection at outside corners"),
    ("G500", "no work offset"),
    ("M17", "end of the subprogram"),
];

const TURNING: &[Meaning] = &[
    ("G0", "rapid traverse; of a contour its start"),
    ("G1", "straight line"),
    ("G2", "arc clockwise, centre incremental"),
    ("G3", "arc counter-clockwise, centre incremental"),
    ("G12", "arc clockwise, centre absolute"),
    ("G13", "arc counter-clockwise, centre absolute"),
    ("G14", "to the tool change point"),
    ("G26", "limit of the speed"),
    ("G95", "feed per revolution"),
    ("G96", "constant cutting speed"),
    ("G97", "constant speed of the spindle"),
    ("G80", "end of a cycle or of its contour"),
];

const MTC200: &[Meaning] = &[
    ("G8", "block transition at the best velocity"),
    ("G9", "slows down at the block transition"),
    ("G20", "free selection of the plane"),
    ("G47", "tool length compensation off"),
    ("G53", "cancels the zero offsets"),
    ("G48", "tool length compensation on"),
    ("BST", "stops, and goes on at the label at the next start"),
    ("BRA", "jumps to a label"),
    ("JSR", "calls a program as a subroutine"),
    ("RET", "end of the program, back to its beginning"),
    ("RTS", "end of the subroutine"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_however_they_are_spelled() {
        assert_eq!(meaning("sinumerik", "g01"), Some("straight line at the feed"));
        assert_eq!(meaning("klartext", "G1"), None);
        assert_eq!(meaning("klartext", "m30"), meaning("mtc200", "M30"));
        assert_eq!(meaning("gcode", "G00"), Some("rapid traverse"));
        assert_eq!(meaning("klartext", "Q200"), None);
        // The same word is another one on another control.
        assert_eq!((meaning("mtc200", "G71"), meaning("gcode", "G71")), (Some("millimetres"), None));
        assert_eq!(meaning("mtc200", "G20"), Some("free selection of the plane"));
    }

    #[test]
    fn no_word_stands_twice_in_a_language() {
        for dialect in crate::dialect::ALL {
            let mut words: Vec<&str> = all(dialect.id).map(|(word, _)| word).collect();
            let count = words.len();
            words.sort_unstable();
            words.dedup();
            // The languages of lathes say more of some G than the common table.
            assert!(words.len() == count, "{}: {words:?}", dialect.id);
        }
    }
}
