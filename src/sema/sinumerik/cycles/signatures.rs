//! Parameter lists of the cycles that work along a contour or take off a shape of their own.
//!
//! Source: reference sections 5.2 to 5.6 and 6.5. The lists are complete, so that a call can be checked; the paths of
//! these cycles are computed inside the control.

use Rule::{Above, Any, Below90, Choice, Name, Needed, NotNegative};

/// What a value has to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    /// A number, or nothing.
    Any,
    /// A text.
    Name,
    /// A number that has to be there.
    Needed,
    /// "Without sign".
    NotNegative,
    /// Above 0 where given; the alarm of the control.
    Above(u32),
    /// An angle of 0 to below 90 degrees.
    Below90,
    /// A whole number between the two.
    Choice(i32, i32),
}

/// A parameter: its name in the manuals, what it is, what it may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parameter {
    pub name: &'static str,
    pub what: &'static str,
    pub rule: Rule,
}

/// A cycle by its parameters.
#[derive(Debug)]
pub(super) struct Signature {
    pub name: &'static str,
    pub what: &'static str,
    pub contour: Source,
    pub parameters: &'static [Parameter],
}

/// Where a cycle has its contour from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Source {
    /// It has none.
    None,
    /// From its first argument.
    Argument,
    /// From CYCLE62: the turned part, or blank and part.
    Turned,
    /// From CYCLE62: closed contours of pockets, islands and spigots.
    Milled,
}

const fn p(name: &'static str, what: &'static str, rule: Rule) -> Parameter {
    Parameter { name, what, rule }
}

/// The signature of a cycle.
pub(super) fn of(name: &str) -> Option<&'static Signature> {
    SIGNATURES.iter().find(|known| known.name == name)
}

const SIGNATURES: &[Signature] = &[
    Signature {
        name: "CYCLE62",
        what: "contour call",
        contour: Source::None,
        parameters: &[
            p("KNAME", "name of the contour or program", Name),
            p("TYPE", "0 program, 1 name, 2 labels, 3 labels in a program", Choice(0, 3)),
            p("LAB1", "label of the start", Name),
            p("LAB2", "label of the end", Name),
        ],
    },
    Signature {
        name: "CYCLE63",
        what: "contour pocket or spigot",
        contour: Source::Milled,
        parameters: &[
            p("_PRG", "program that is made", Name),
            p("_VARI", "machining", Any),
            p("_RP", "retraction plane", Any),
            p("_Z0", "reference plane", Any),
            p("_SC", "safety distance", NotNegative),
            p("_Z1", "depth", Any),
            p("_F", "feed in the plane", Above(61003)),
            p("_FZ", "feed in depth", Above(61003)),
            p("_DXY", "infeed in the plane", NotNegative),
            p("_MID", "infeed in depth", NotNegative),
            p("_UXY", "allowance on the wall", NotNegative),
            p("_UZ", "allowance on the floor", NotNegative),
            p("_CDIR", "climb or conventional", Any),
            p("_XS", "start point", Any),
            p("_YS", "start point", Any),
            p("_ER", "radius of the helix", Any),
            p("_EP", "pitch of the helix", Any),
            p("_EW", "angle of plunging", Any),
            p("_FS", "chamfer", NotNegative),
            p("_ZFS", "depth of the chamfer", Any),
            p("_TR", "reference tool", Name),
            p("_DR", "its edge", Any),
            p("_UMODE", "", Any),
            p("_GMODE", "", Any),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
        ],
    },
    Signature {
        name: "CYCLE64",
        what: "predrilling of a contour pocket",
        contour: Source::Milled,
        parameters: &[
            p("_PRG", "program that is made", Name),
            p("_VARI", "machining", Any),
            p("_RP", "retraction plane", Any),
            p("_Z0", "reference plane", Any),
            p("_SC", "safety distance", NotNegative),
            p("_Z1", "depth", Any),
            p("_F", "feed", Above(61003)),
            p("_DXY", "infeed in the plane", NotNegative),
            p("_UXY", "allowance on the wall", NotNegative),
            p("_UZ", "allowance on the floor", NotNegative),
            p("_CDIR", "climb or conventional", Any),
            p("_TR", "reference tool", Name),
            p("_DR", "its edge", Any),
            p("_UMODE", "", Any),
            p("_GMODE", "", Any),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
        ],
    },
    Signature {
        name: "CYCLE72",
        what: "path milling",
        contour: Source::Argument,
        parameters: &[
            p("_KNAME", "contour", Name),
            p("_RTP", "retraction plane", Any),
            p("_RFP", "reference plane", Any),
            p("_SDIS", "safety distance", NotNegative),
            p("_DP", "depth", Any),
            p("_MID", "infeed in depth", NotNegative),
            p("_FAL", "allowance on the contour", NotNegative),
            p("_FALD", "allowance on the floor", NotNegative),
            p("_FFP1", "feed in the plane", Above(61003)),
            p("_FFD", "feed in depth", Above(61003)),
            p("_VARI", "machining", Any),
            p("_RL", "side: 40, 41 or 42", Any),
            p("_AS1", "approach", Any),
            p("_LP1", "length or radius of the approach", Any),
            p("_FF3", "feed of the return", Any),
            p("_AS2", "retraction", Any),
            p("_LP2", "length or radius of the retraction", Any),
            p("_UMODE", "", Any),
            p("_FS", "chamfer", NotNegative),
            p("_ZFS", "depth of the chamfer", Any),
            p("_GMODE", "", Any),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
        ],
    },
    Signature {
        name: "CYCLE93",
        what: "groove",
        contour: Source::None,
        parameters: &[
            p("SPD", "start point, diameter", Needed),
            p("SPL", "start point along Z", Needed),
            p("WIDG", "width of the floor", NotNegative),
            p("DIAG", "depth", NotNegative),
            p("STA1", "inclination", Any),
            p("ANG1", "angle of the flank at the start point", Below90),
            p("ANG2", "angle of the other flank", Below90),
            p("RCO1", "outer radius or chamfer, at the start point", Any),
            p("RCO2", "outer radius or chamfer, opposite", Any),
            p("RCI1", "inner radius or chamfer, at the start point", Any),
            p("RCI2", "inner radius or chamfer, opposite", Any),
            p("FAL1", "allowance on the floor", NotNegative),
            p("FAL2", "allowance on the flanks", NotNegative),
            p("IDEP", "infeed", NotNegative),
            p("DTB", "dwell at the floor", Any),
            p("VARI", "machining", Needed),
            p("_VRT", "lift", NotNegative),
            p("_DN", "number of the second edge", Any),
        ],
    },
    Signature {
        name: "CYCLE930",
        what: "groove",
        contour: Source::None,
        parameters: &[
            p("_SPD", "reference point, diameter", Needed),
            p("_SPL", "reference point along Z", Needed),
            p("_WIDG", "width of the floor", NotNegative),
            p("_WIDG2", "width of the top", NotNegative),
            p("_DIAG", "depth at the reference point", Any),
            p("_DIAG2", "depth on the other side", Any),
            p("_STA", "inclination", Any),
            p("_ANG1", "angle of the flank at the reference point", Below90),
            p("_ANG2", "angle of the other flank", Below90),
            p("_RCO1", "first outer corner", Any),
            p("_RCI1", "first inner corner", Any),
            p("_RCI2", "second inner corner", Any),
            p("_RCO2", "second outer corner", Any),
            p("_FAL", "allowance", NotNegative),
            p("_IDEP1", "infeed", NotNegative),
            p("_SDIS", "safety distance", NotNegative),
            p("_VARI", "machining", Any),
            p("_DN", "number of the second edge", Any),
            p("_NUM", "number of grooves", NotNegative),
            p("_DBH", "distance of the grooves", Any),
            p("_FF1", "feed", Above(61003)),
            p("_NR", "0 rectangular, 1 with flanks, 2 inclined", Choice(0, 2)),
            p("_FALX", "allowance on X", NotNegative),
            p("_FALZ", "allowance on Z", NotNegative),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
            p("_GMODE", "", Any),
            p("S_FB", "", Any),
        ],
    },
    Signature {
        name: "CYCLE95",
        what: "stock removal along a contour",
        contour: Source::Argument,
        parameters: &[
            p("NPP", "contour", Name),
            p("MID", "greatest infeed", NotNegative),
            p("FALZ", "allowance along Z", NotNegative),
            p("FALX", "allowance along X", NotNegative),
            p("FAL", "allowance along the contour", NotNegative),
            p("FF1", "feed of roughing", Above(61003)),
            p("FF2", "feed into relief cuts", Above(61003)),
            p("FF3", "feed of finishing", Above(61003)),
            p("VARI", "machining", Needed),
            p("DT", "dwell to break the chip", NotNegative),
            p("DAM", "way after which the chip is broken", NotNegative),
            p("_VRT", "lift", NotNegative),
            p("_GMODE", "", Any),
            p("_DMODE", "", Any),
        ],
    },
    Signature {
        name: "CYCLE951",
        what: "stock removal at a corner",
        contour: Source::None,
        parameters: &[
            p("_SPD", "corner of the blank, diameter", Needed),
            p("_SPL", "corner of the blank along Z", Needed),
            p("_EPD", "finished corner, diameter", Needed),
            p("_EPL", "finished corner along Z", Needed),
            p("_ZPD", "point between, diameter", Any),
            p("_ZPL", "point between along Z", Any),
            p("_LAGE", "0 and 1 external, 2 and 3 internal", Choice(0, 3)),
            p("_MID", "greatest infeed", NotNegative),
            p("_FALX", "allowance on X", NotNegative),
            p("_FALZ", "allowance on Z", NotNegative),
            p("_VARI", "machining", Needed),
            p("_RF1", "first corner", Any),
            p("_RF2", "second corner", Any),
            p("_RF3", "third corner", Any),
            p("_SDIS", "safety distance", NotNegative),
            p("_FF1", "feed", Above(61003)),
            p("_NR", "0 corner, 1 with transitions, 2 with a slope", Choice(0, 2)),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
        ],
    },
    Signature {
        name: "CYCLE952",
        what: "stock removal along a contour",
        contour: Source::Turned,
        parameters: &[
            p("_PRG", "program that is made", Name),
            p("_CON", "contour of the rest that is made", Name),
            p("_CONR", "contour of the rest that is taken", Name),
            p("_VARI", "machining", Needed),
            p("_F", "feed of roughing", Above(61003)),
            p("_FR", "feed of plunging", Above(61003)),
            p("_RP", "retraction plane", Any),
            p("_D", "greatest infeed", NotNegative),
            p("_DX", "infeed on X", NotNegative),
            p("_DZ", "infeed on Z", NotNegative),
            p("_UX", "allowance on X", NotNegative),
            p("_UZ", "allowance on Z", NotNegative),
            p("_U", "allowance along the contour", NotNegative),
            p("_U1", "further allowance", Any),
            p("_BL", "blank: 1 cylinder, 2 allowance, 3 contour", Any),
            p("_XD", "blank on X", Any),
            p("_ZD", "blank on Z", Any),
            p("_XA", "limit on X", Any),
            p("_ZA", "limit on Z", Any),
            p("_XB", "limit on X", Any),
            p("_ZB", "limit on Z", Any),
            p("_XDA", "first limit of the groove", Any),
            p("_XDB", "second limit of the groove", Any),
            p("_N", "number of grooves", Any),
            p("_DP", "distance of the grooves", Any),
            p("_DI", "way after which the chip is broken", Any),
            p("_SC", "safety distance", NotNegative),
            p("_DN", "number of the second edge", Any),
            p("_GMODE", "", Any),
            p("_DMODE", "", Any),
            p("_AMODE", "", Any),
            p("_PK", "", Any),
            p("_DCH", "", Any),
            p("_FS", "feed of finishing", Above(61003)),
        ],
    },
];
