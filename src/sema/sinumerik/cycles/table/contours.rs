//! Cycles that work along a contour, or take off a shape of their own: read and checked, their tracks are not published.

use crate::sema::cycle_table::{Parameter, Rule, Signature, Status, angle, count, dwell, feed, length, number, words};

use super::super::arguments::{MID, VARI};
use super::super::called_contours::last_digits;
use super::{Cycle, Source, Unpublished, Variant, Work};

/// The tracks of these cycles are made inside the control.
const UNPUBLISHED: Status =
    Status::Checked { code: "S9020", why: "the tracks are made inside the control and not published" };
/// "Above 0" where 0 is what an empty field becomes.
const FEED: Rule = Rule::Above(61003);

const UMODE: Parameter = number("_UMODE", "");
const GMODE: Parameter = number("_GMODE", "");
const DMODE: Parameter = number("_DMODE", "");
const AMODE: Parameter = number("_AMODE", "");

const BY_NUMBER: Variant = Variant {
    fits: |args| (1..=12).contains(&last_digits(args, VARI, 100)),
    help: "1 to 4 rough, 5 to 8 finish, 9 to 12 do both; of each along Z or X, outside or inside",
    infeed: |args| (!(5..=8).contains(&last_digits(args, VARI, 100))).then_some(MID),
};
const CORNER: Variant = Variant {
    fits: |args| matches!(args.digit(VARI, 0), 1 | 2) && matches!(args.digit(VARI, 1), 1 | 2),
    help: "units 1 along Z, 2 along X; tens 1 roughing, 2 finishing",
    infeed: |args| (args.digit(VARI, 1) == 1).then_some(MID),
};
const ALONG: Variant = Variant {
    fits: |args| (1..=3).contains(&args.digit(VARI, 0)) && (1..=3).contains(&args.digit(VARI, 1)),
    help: "units 1 along Z, 2 along X, 3 along the contour; tens 1 roughing, 2 finishing, 3 both",
    infeed: |_| None,
};

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE62",
            what: "contour call",
            status: Status::Built,
            source: "SINUMERIK NC programming 12/2019",
            parameters: &[
                words("KNAME", "name of the contour or program"),
                number("TYPE", "0 program, 1 name, 2 labels, 3 labels in a program").rule(Rule::OneOf(0, 3)),
                words("LAB1", "label of the start"),
                words("LAB2", "label of the end"),
            ],
        },
        work: Work::Contour(|run, args| run.contour_call(args)),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE63",
            what: "contour pocket or spigot",
            status: UNPUBLISHED,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                words("_PRG", "program that is made"),
                number("_VARI", "machining"),
                length("_RP", "retraction plane"),
                length("_Z0", "reference plane"),
                length("_SC", "safety distance").unsigned(),
                length("_Z1", "depth"),
                feed("_F", "feed in the plane").rule(FEED),
                feed("_FZ", "feed in depth").rule(FEED),
                length("_DXY", "infeed in the plane").unsigned(),
                length("_MID", "infeed in depth").unsigned(),
                length("_UXY", "allowance on the wall").unsigned(),
                length("_UZ", "allowance on the floor").unsigned(),
                number("_CDIR", "climb or conventional"),
                length("_XS", "start point"),
                length("_YS", "start point"),
                length("_ER", "radius of the helix"),
                length("_EP", "pitch of the helix"),
                angle("_EW", "angle of plunging"),
                length("_FS", "chamfer").unsigned(),
                length("_ZFS", "depth of the chamfer"),
                words("_TR", "reference tool"),
                number("_DR", "its edge"),
                UMODE,
                GMODE,
                DMODE,
                AMODE,
            ],
        },
        work: Work::Unpublished(Unpublished { contour: Source::Milled, turned: false, variant: None, advice: None }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE64",
            what: "predrilling of a contour pocket",
            status: UNPUBLISHED,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                words("_PRG", "program that is made"),
                number("_VARI", "machining"),
                length("_RP", "retraction plane"),
                length("_Z0", "reference plane"),
                length("_SC", "safety distance").unsigned(),
                length("_Z1", "depth"),
                feed("_F", "feed").rule(FEED),
                length("_DXY", "infeed in the plane").unsigned(),
                length("_UXY", "allowance on the wall").unsigned(),
                length("_UZ", "allowance on the floor").unsigned(),
                number("_CDIR", "climb or conventional"),
                words("_TR", "reference tool"),
                number("_DR", "its edge"),
                UMODE,
                GMODE,
                DMODE,
                AMODE,
            ],
        },
        work: Work::Unpublished(Unpublished { contour: Source::Milled, turned: false, variant: None, advice: None }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE95",
            what: "stock removal along a contour",
            status: UNPUBLISHED,
            source: "SINUMERIK 840D cycles 11/2002",
            parameters: &[
                words("NPP", "contour"),
                length("MID", "greatest infeed").unsigned(),
                length("FALZ", "allowance along Z").unsigned(),
                length("FALX", "allowance along X").unsigned(),
                length("FAL", "allowance along the contour").unsigned(),
                feed("FF1", "feed of roughing").rule(FEED),
                feed("FF2", "feed into relief cuts").rule(FEED),
                feed("FF3", "feed of finishing").rule(FEED),
                number("VARI", "machining").needed(),
                dwell("DT", "dwell to break the chip").unsigned(),
                length("DAM", "way after which the chip is broken").unsigned(),
                length("_VRT", "lift").unsigned(),
                GMODE,
                DMODE,
            ],
        },
        work: Work::Unpublished(Unpublished {
            contour: Source::Argument,
            turned: true,
            variant: Some(BY_NUMBER),
            advice: None,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE951",
            what: "stock removal at a corner",
            status: UNPUBLISHED,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                length("_SPD", "corner of the blank, diameter").needed(),
                length("_SPL", "corner of the blank along Z").needed(),
                length("_EPD", "finished corner, diameter").needed(),
                length("_EPL", "finished corner along Z").needed(),
                length("_ZPD", "point between, diameter"),
                length("_ZPL", "point between along Z"),
                number("_LAGE", "0 and 1 external, 2 and 3 internal").rule(Rule::OneOf(0, 3)),
                length("_MID", "greatest infeed").unsigned(),
                length("_FALX", "allowance on X").unsigned(),
                length("_FALZ", "allowance on Z").unsigned(),
                number("_VARI", "machining").needed(),
                length("_RF1", "first corner"),
                length("_RF2", "second corner"),
                length("_RF3", "third corner"),
                length("_SDIS", "safety distance").unsigned(),
                feed("_FF1", "feed").rule(FEED),
                number("_NR", "0 corner, 1 with transitions, 2 with a slope").rule(Rule::OneOf(0, 2)),
                DMODE,
                AMODE,
            ],
        },
        work: Work::Unpublished(Unpublished {
            contour: Source::None,
            turned: true,
            variant: Some(CORNER),
            advice: None,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE952",
            what: "stock removal along a contour",
            status: UNPUBLISHED,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                words("_PRG", "program that is made"),
                words("_CON", "contour of the rest that is made"),
                words("_CONR", "contour of the rest that is taken"),
                number("_VARI", "machining").needed(),
                feed("_F", "feed of roughing").rule(FEED),
                feed("_FR", "feed of plunging").rule(FEED),
                length("_RP", "retraction plane"),
                length("_D", "greatest infeed").unsigned(),
                length("_DX", "infeed on X").unsigned(),
                length("_DZ", "infeed on Z").unsigned(),
                length("_UX", "allowance on X").unsigned(),
                length("_UZ", "allowance on Z").unsigned(),
                length("_U", "allowance along the contour").unsigned(),
                length("_U1", "further allowance"),
                number("_BL", "blank: 1 cylinder, 2 allowance, 3 contour"),
                length("_XD", "blank on X"),
                length("_ZD", "blank on Z"),
                length("_XA", "limit on X"),
                length("_ZA", "limit on Z"),
                length("_XB", "limit on X"),
                length("_ZB", "limit on Z"),
                length("_XDA", "first limit of the groove"),
                length("_XDB", "second limit of the groove"),
                count("_N", "number of grooves"),
                length("_DP", "distance of the grooves"),
                length("_DI", "way after which the chip is broken"),
                length("_SC", "safety distance").unsigned(),
                count("_DN", "number of the second edge"),
                GMODE,
                DMODE,
                AMODE,
                number("_PK", ""),
                number("_DCH", ""),
                feed("_FS", "feed of finishing").rule(FEED),
            ],
        },
        work: Work::Unpublished(Unpublished {
            contour: Source::Turned,
            turned: true,
            variant: Some(ALONG),
            advice: None,
        }),
    },
];
