//! Cycles that work along a contour, or take off a shape of their own: read and checked, their tracks are not published.

use crate::sema::cycle::row::{Parameter, Rule, Signature, Status, feed, length, number, words};

use super::{Cycle, Source, Work};

/// The tracks of these cycles are made inside the control.
const UNPUBLISHED: Status =
    Status::Checked { code: "S9020", why: "the tracks are made inside the control and not published" };
/// "Above 0" where 0 is what an empty field becomes.
const FEED: Rule = Rule::AboveOrEmpty(61003);

const UMODE: Parameter = number("_UMODE", "");
const GMODE: Parameter = number("_GMODE", "");
const DMODE: Parameter = number("_DMODE", "");
const AMODE: Parameter = number("_AMODE", "");

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
        needs: &[],
        work: Work::NamesContour,
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
        needs: &[],
        work: Work::Unpublished(Source::Milled),
    },
];
