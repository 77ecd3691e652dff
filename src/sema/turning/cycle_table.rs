//! The cycles of the turning dialects: which words each takes, and where its contour is from.
//!
//! Sources: MANUALplus 4110 pilot (4110P) and manual (4110), CNC PILOT 4290 DIN PLUS (4290-71), MANUALplus 620.

use crate::diag::{Answer, codes};
use crate::sema::cycle::row::{
    Kind, Name, Parameter, Rule, Signature, Status, angle, count, dwell, feed, length, number, words,
};

use super::outline::Outline;
use super::program_parts::Family;
use super::words::{Fun, Letters, Words, letters};
use super::{Outcome, Run};

/// A cycle that is compiled.
#[derive(Debug)]
pub(super) struct Cycle {
    pub number: u16,
    pub signature: Signature,
    pub contour: Contour,
    pub run: fn(&mut Run<'_>, &Words, Behind<'_>) -> Outcome,
}

/// The contour in the blocks behind a cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Behind<'a> {
    pub outline: Option<&'a Outline>,
    /// G41 or G42 at its start.
    pub side: Option<Fun>,
}

/// Where a cycle has its contour from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Contour {
    /// It has none.
    None,
    /// From the blocks up to G80.
    Follows,
    /// From NS, NE or ID, else from the blocks up to G80.
    Referenced,
    /// The same, and a line to X, Z needs none.
    LineOrReferenced,
}

impl Cycle {
    /// Its single letters.
    pub const fn letters(&self) -> Letters {
        let mut found = 0;
        let mut at = 0;
        while at < self.signature.parameters.len() {
            if let Name::Word(name) = self.signature.parameters[at].name
                && name.len() == 1
            {
                found |= letters(name);
            }
            at += 1;
        }
        found
    }

    /// Does it take this longer address with a number?
    pub fn takes(&self, long: &str) -> bool {
        let mut numbers = self.signature.parameters.iter().filter(|known| !matches!(known.kind, Kind::Text));
        numbers.any(|known| matches!(known.name, Name::Word(name) if name.len() > 1 && name == long))
    }

    /// Do blocks of a contour follow?
    pub fn waits(&self, w: &Words, named: bool) -> bool {
        let referenced = w.long("NS").is_some() || named;
        match self.contour {
            Contour::None => false,
            Contour::Follows => true,
            Contour::Referenced => !referenced,
            Contour::LineOrReferenced => !w.has(b'X') && !w.has(b'Z') && !referenced,
        }
    }

    /// ID names its contour.
    pub fn takes_name(&self) -> bool {
        matches!(self.contour, Contour::Referenced | Contour::LineOrReferenced)
    }
}

/// What all of them take.
pub fn signatures() -> Vec<&'static Signature> {
    ROWS.iter().map(|cycle| &cycle.signature).collect()
}

/// The cycle of this number; there has to be one.
pub(super) const fn of(number: u16) -> &'static Cycle {
    let mut at = 0;
    while ROWS[at].number != number {
        at += 1;
    }
    &ROWS[at]
}

const fn cycle(
    number: u16,
    name: &'static str,
    what: &'static str,
    source: &'static str,
    parameters: &'static [Parameter],
    contour: Contour,
    run: fn(&mut Run<'_>, &Words, Behind<'_>) -> Outcome,
) -> Cycle {
    Cycle { number, signature: Signature { name, what, status: Status::Built, source, parameters }, contour, run }
}

const X: Parameter = length("X", "corner or end point, diameter");
const Z: Parameter = length("Z", "corner or end point");
const NS: Parameter = number("NS", "block number of the first element of the contour");
const NE: Parameter = number("NE", "block number of the last element of the contour").default("NS alone");
const ID: Parameter = words("ID", "name of the contour");
const XA: Parameter = length("XA", "corner of the blank, diameter");
const ZA: Parameter = length("ZA", "corner of the blank along Z");
const LIMIT_X: Parameter = length("X", "limit of the cut, diameter").default("none");
const LIMIT_Z: Parameter = length("Z", "limit of the cut").default("none");
const INFEED: Parameter = length("P", "greatest infeed").needed();
const OVERSIZE_X: Parameter = length("I", "oversize along X, diameter").default("that of G57 or G58");
const OVERSIZE_Z: Parameter = length("K", "oversize along Z").default("that of G57 or G58");
const APPROACH: Parameter = angle("A", "angle of the approach");
const DEPARTURE: Parameter = angle("W", "angle of the departure");
const ENDS: Parameter = number("V", "chamfer or rounding at 0 both ends, 1 the first, 2 the last, 3 none")
    .rule(Rule::OneOf(0, 3))
    .default("0");
const LEFT_OUT: Parameter = number("D", "elements that are left out").default("none");
const SMOOTHING: Parameter =
    number("H", "0 along the contour after each cut, 1 after the last one, 2 not at all").rule(Rule::OneOf(0, 2));
const DESCENDING: Parameter = feed("E", "feed of descending elements; 0 leaves them out").default("reduced");
const END: Parameter = number("Q", "0 back to the start, 1 in front of the contour, 2 lifted").rule(Rule::OneOf(0, 2));
const BOTTOM: Parameter = length("Z", "bottom of the hole").needed();
const OVER_HOLE: Parameter = length("X", "diameter at which the tool stands");
const PER_HOLE: Parameter = dwell("E", "dwell at the bottom").unsigned().default("0");
const SOFT: Parameter = number("V", "reduced feed at the ends; refused where it is not 0").default("0");
const BACK: Parameter = number("D", "out of the hole at 0 rapid, 1 feed").rule(Rule::OneOf(0, 1)).default("0");

const CORNER: &[Parameter] = &[
    X,
    Z,
    length("I", "G81 greatest infeed along X, G82 oblique end (refused where it is not 0)"),
    length("K", "G82 greatest infeed along Z, G81 oblique end (refused where it is not 0)"),
    number("Q", "down to the cut at 0 rapid, 1 feed").rule(Rule::OneOf(0, 1)).default("0"),
    number("V", "1 returns to the start").rule(Rule::OneOf(0, 1)).default("0"),
];
const ALONG: &[Parameter] = &[X, Z, INFEED, SMOOTHING.default("1"), OVERSIZE_X, OVERSIZE_Z];
const PLUNGING: &[Parameter] = &[X, Z, INFEED, DESCENDING, SMOOTHING.default("1"), OVERSIZE_X, OVERSIZE_Z];
const REFERENCED: &[Parameter] = &[
    NS,
    NE,
    ID,
    INFEED,
    OVERSIZE_X,
    OVERSIZE_Z,
    DESCENDING,
    LIMIT_X,
    LIMIT_Z,
    APPROACH,
    DEPARTURE,
    SMOOTHING.default("1"),
    END.default("0"),
    ENDS,
    LEFT_OUT,
    XA,
    ZA,
];

const PILOT: &str = "4110P, pp. 60 to 67";
const PLUS: &str = "MANUALplus 620, G830 p. 251";

/// By number.
pub(super) const ROWS: &[Cycle] = &[
    cycle(
        31,
        "G31",
        "thread cycle",
        "4110P, p. 74; 4110, p. 336; MANUALplus 620, p. 272",
        &[
            NS,
            NE,
            ID,
            X,
            Z,
            length("F", "pitch").default("that of the contour"),
            length("U", "depth on the radius: above 0 internal").default("that of the contour"),
            length("I", "greatest infeed"),
            count("IC", "number of cuts, in place of I"),
            length("R", "difference of the radii of end and start").default("0"),
            length("B", "run-in").default("F by turns a minute by 1000"),
            length("P", "run-out").default("F by turns a minute by 1000"),
            angle("A", "infeed angle").default("half the pitch at the first cut, 30 degrees in DIN PLUS"),
            number("V", "series of the depths").rule(Rule::OneOf(0, 6)).default("0"),
            number("H", "infeed 0 radial, 1 left, 2 right, 3 by turns").rule(Rule::OneOf(0, 3)).default("0"),
            count("Q", "cuts at full depth").default("0"),
            angle("C", "start angle").default("0"),
            number("O", "ends of the contour; refused where it is not 0").default("0"),
            number("J", "0 along Z, 1 across").rule(Rule::OneOf(0, 1)).default("by the line"),
        ],
        Contour::LineOrReferenced,
        |run, w, contour| run.thread_cycle(w, contour.outline),
    ),
    cycle(
        32,
        "G32",
        "simple thread",
        "MANUALplus 620",
        &[
            X,
            Z,
            length("F", "pitch").needed(),
            length("P", "depth").needed(),
            length("I", "greatest infeed").needed(),
            number("B", "last cut 0 split, 1 whole").rule(Rule::OneOf(0, 1)).default("0"),
            count("Q", "cuts at full depth").default("0"),
            length("K", "run-out").default("0"),
            angle("W", "taper").default("0"),
            angle("C", "start angle").default("0"),
            number("H", "infeed 0 radial, 1 left, 2 right, 3 by turns").rule(Rule::OneOf(0, 3)).default("0"),
        ],
        Contour::None,
        |run, w, _| run.simple_thread(w),
    ),
    cycle(
        36,
        "G36",
        "tapping",
        "CNC PILOT 4290",
        &[
            OVER_HOLE,
            BOTTOM,
            length("F", "pitch").needed(),
            length("B", "run-in; refused where it is not 0").default("0"),
            number("Q", "spindle; refused where it is not 0").default("0"),
            number("H", "reference of the pitch; refused where it is not 0").default("0"),
        ],
        Contour::None,
        |run, w, _| run.tapping(w),
    ),
    cycle(
        71,
        "G71",
        "drilling",
        "CNC PILOT 4290",
        &[OVER_HOLE, BOTTOM, PER_HOLE, SOFT, BACK],
        Contour::None,
        |run, w, _| run.drilling(w, false),
    ),
    cycle(
        74,
        "G74",
        "deep-hole drilling",
        "4290-71, p. 601",
        &[
            OVER_HOLE,
            BOTTOM,
            length("P", "first step, above 0").default("the whole depth"),
            length("I", "by which each step is shorter").unsigned().default("0"),
            length("B", "way back to break the chip").default("out of the hole"),
            length("J", "least step, above 0").default("a tenth of P"),
            PER_HOLE,
            SOFT,
            BACK,
        ],
        Contour::None,
        |run, w, _| run.drilling(w, true),
    ),
    cycle(81, "G81", "longitudinal roughing", "4110P, p. 61", CORNER, Contour::None, |run, w, _| {
        run.rectangle(w, true)
    }),
    cycle(82, "G82", "transverse roughing", "4110P, p. 61", CORNER, Contour::None, |run, w, _| run.rectangle(w, false)),
    cycle(
        85,
        "G85",
        "undercut",
        "4110P, p. 80",
        &[
            X.needed(),
            Z.needed(),
            length("I", "E and F: oversize; DIN 76: depth").default("0"),
            length("K", "0 form F, above 0 width of DIN 76").default("form E"),
            feed("E", "feed").default("that in force"),
        ],
        Contour::None,
        |run, w, _| run.undercut_cycle(w),
    ),
    cycle(
        86,
        "G86",
        "simple recess",
        "4110P, p. 68",
        &[
            X,
            Z,
            length("I", "radial: oversize; axial: width"),
            length("K", "radial: width; axial: oversize"),
            dwell("E", "dwell at the floor").default("one turn"),
        ],
        Contour::None,
        |run, w, _| run.simple_recess(w),
    ),
    cycle(
        89,
        "G89",
        "contour finishing",
        "4110P, p. 67",
        &[
            length("B", "first corner; refused where it is not 0").default("0"),
            length("I", "oversize along the contour").default("that of G58"),
            length("K", "lift: 0 stays").default("back to the start"),
            number("J", "reference element; refused where it is not 0").default("0"),
        ],
        Contour::Follows,
        |run, w, contour| run.contour_finishing(w, contour.outline, contour.side),
    ),
    cycle(810, "G810", "longitudinal roughing", PLUS, REFERENCED, Contour::Referenced, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 810)
    }),
    cycle(817, "G817", "longitudinal contour roughing", PILOT, ALONG, Contour::Follows, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 817)
    }),
    cycle(818, "G818", "longitudinal contour roughing", PILOT, ALONG, Contour::Follows, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 818)
    }),
    cycle(
        819,
        "G819",
        "longitudinal contour roughing with plunging",
        PILOT,
        PLUNGING,
        Contour::Follows,
        |run, w, contour| run.contour_roughing(w, contour.outline, 819),
    ),
    cycle(820, "G820", "transverse roughing", PLUS, REFERENCED, Contour::Referenced, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 820)
    }),
    cycle(827, "G827", "transverse contour roughing", PILOT, ALONG, Contour::Follows, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 827)
    }),
    cycle(828, "G828", "transverse contour roughing", PILOT, ALONG, Contour::Follows, |run, w, contour| {
        run.contour_roughing(w, contour.outline, 828)
    }),
    cycle(
        829,
        "G829",
        "transverse contour roughing with plunging",
        PILOT,
        PLUNGING,
        Contour::Follows,
        |run, w, contour| run.contour_roughing(w, contour.outline, 829),
    ),
    cycle(
        869,
        "G869",
        "recess turning",
        "4290-71, p. 225; MANUALplus 620",
        &[
            NS,
            NE,
            ID,
            INFEED,
            length("R", "turning depth compensation").default("0"),
            length("RB", "the same").default("R"),
            OVERSIZE_X,
            OVERSIZE_Z,
            LIMIT_X,
            LIMIT_Z,
            APPROACH,
            DEPARTURE,
            number("Q", "0 roughs and finishes, 1 roughs, 2 finishes").rule(Rule::OneOf(0, 2)).default("0"),
            number("U", "0 both ways, 1 one way").rule(Rule::OneOf(0, 1)).default("0"),
            number("H", "0 back to the start, 1 in front of the contour, 2 lifted")
                .rule(Rule::OneOf(0, 2))
                .default("0"),
            ENDS,
            feed("O", "feed of recessing").default("that in force"),
            feed("E", "feed of finishing").default("that in force"),
            length("B", "offset width").default("0"),
            XA,
            ZA,
            length("RI", "oversize of the blank along X"),
            length("RK", "oversize of the blank along Z"),
        ],
        Contour::Referenced,
        |run, w, contour| {
            run.is_no_basic_control()?;
            run.recess_turning(w, contour.outline)
        },
    ),
    cycle(
        890,
        "G890",
        "finishing",
        "MANUALplus 620, G890; CNC PILOT 640, p. 336",
        &[
            NS,
            NE,
            ID,
            DESCENDING,
            ENDS,
            number("Q", "way of the approach").rule(Rule::OneOf(0, 4)).default("0"),
            number("H", "way of the retraction").rule(Rule::OneOf(3, 8)).default("3"),
            LIMIT_X,
            LIMIT_Z,
            LEFT_OUT,
            length("I", "end point, diameter"),
            length("K", "end point along Z"),
            number("O", "feed on small arcs 0 reduced, 1 as it is").rule(Rule::OneOf(0, 1)).default("0"),
            number("U", "element in the words of G80; refused where it is not 0").default("0"),
            number("B", "refused where it is not 0").default("0"),
        ],
        Contour::Referenced,
        |run, w, contour| run.finishing(w, contour.outline),
    ),
];

impl Run<'_> {
    fn is_no_basic_control(&self) -> Outcome {
        if self.sections.family() != Family::Basic {
            return Ok(());
        }
        self.refuse(
            self.block_span(),
            codes::T2017::manualplus_4110_has_no_g869().answer(Answer::key("control", "heidenhain_turning")),
        )
    }
}
