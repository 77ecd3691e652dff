//! Roughing in parallel cuts: G81 and G82, G817 to G829 with the contour behind them, G810 and G820 along a contour.
//!
//! Source: T 7, 8.1 and 8.2 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::tolerance;
use crate::geo::{Element, Point2, Vec2, distance};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::layers::{Allowance, Blank, Layers, Relief, Trace};
use crate::ir::cycle::roughing::{Corner, Nose};
use crate::ir::cycle::turning::Towards;
use crate::machine::RecessDepth;
use crate::sema::cycle::call::{Elsewhere, Made};
use crate::sema::cycle::row::{Name, Parameter, Rule, length, number};

use super::super::blank::Blank as Stock;
use super::super::readings::Question;
use super::super::technology::Oversize;
use super::super::tool_side::tool_is_left;
use super::finishing::reduced;
use super::{
    APPROACH, CORNER_X, CORNER_Z, Contour, CycleCall, DEPARTURE, DESCENDING, END, ENDS, ID, INFEED, LEFT_OUT, LIMIT_X,
    LIMIT_Z, NE, NS, Need, OVERSIZE_X, OVERSIZE_Z, Planned, Refused, Row, SMOOTHING, Unbuilt, XA, ZA, one, word,
};

/// How far G81 and G82 lift off, mm.
const RECTANGLE_LIFT: f64 = 1.0;

const DOWN: Parameter = number("Q", "down to the cut at 0 rapid, 1 feed").rule(Rule::OneOf(0, 1)).default("0");
const BACK: Parameter = number("V", "1 returns to the start").rule(Rule::OneOf(0, 1)).default("0");
const ALONG: &[Parameter] = &[CORNER_X, CORNER_Z, INFEED, SMOOTHING.default("1"), OVERSIZE_X, OVERSIZE_Z];
const PLUNGING: &[Parameter] =
    &[CORNER_X, CORNER_Z, INFEED, DESCENDING, SMOOTHING.default("1"), OVERSIZE_X, OVERSIZE_Z];
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

const fn oblique(end: Name) -> Unbuilt {
    Unbuilt::not_zero(end, |it| codes::T9007::to_which_side_makes_end_oblique(&it.word))
}

const fn limit(word: Name) -> Unbuilt {
    Unbuilt::all(word, |it: &Refused| codes::T9007::of_g_is_not_supported(&it.word, &it.cycle))
}

const LIMITS: &[Unbuilt] = &[limit(word::X), limit(word::Z)];
const OF_REFERENCED: &[Unbuilt] = &[
    limit(word::X),
    limit(word::Z),
    limit(word::A),
    limit(word::W),
    Unbuilt::not_zero(word::Q, |_| codes::T9007::only_value_0_of_q_is_supported()),
    Unbuilt::all(word::XA, |_| codes::T9007::corner_of_blank_is_taken_from_tool()),
    Unbuilt::all(word::ZA, |_| codes::T9007::corner_of_blank_is_taken_from_tool()),
    Unbuilt::one(word::V, 4.0, |_| codes::T9007::v4_only_chamfer_or_rounding_of_element()),
];

const fn behind(number: u16, name: &'static str, what: &'static str, parameters: &'static [Parameter]) -> Row {
    Row::new(number, name, what, PILOT, parameters, |call| call.contour_roughing())
        .contour(Contour::Follows)
        .unbuilt(LIMITS)
        .requires(&[Need::Feed])
}

const fn referenced(number: u16, name: &'static str, what: &'static str) -> Row {
    Row::new(number, name, what, PLUS, REFERENCED, |call| call.contour_roughing())
        .contour(Contour::Referenced)
        .unbuilt(OF_REFERENCED)
        .requires(&[Need::Feed])
}

pub(super) const ROWS: &[Row] = &[
    Row::new(
        81,
        "G81",
        "longitudinal roughing",
        "4110P, p. 61",
        &[
            CORNER_X.needed(),
            CORNER_Z.needed(),
            length("I", "greatest infeed along X").needed(),
            length("K", "oblique end; refused where it is not 0").default("0"),
            DOWN,
            BACK,
        ],
        |call| call.rectangle(true),
    )
    .unbuilt(&[oblique(word::K)])
    .requires(&[Need::Feed]),
    Row::new(
        82,
        "G82",
        "transverse roughing",
        "4110P, p. 61",
        &[
            CORNER_X.needed(),
            CORNER_Z.needed(),
            length("I", "oblique end; refused where it is not 0").default("0"),
            length("K", "greatest infeed along Z").needed(),
            DOWN,
            BACK,
        ],
        |call| call.rectangle(false),
    )
    .unbuilt(&[oblique(word::I)])
    .requires(&[Need::Feed]),
    referenced(810, "G810", "longitudinal roughing"),
    behind(817, "G817", "longitudinal contour roughing", ALONG),
    behind(818, "G818", "longitudinal contour roughing", ALONG),
    behind(819, "G819", "longitudinal contour roughing with plunging", PLUNGING),
    referenced(820, "G820", "transverse roughing"),
    behind(827, "G827", "transverse contour roughing", ALONG),
    behind(828, "G828", "transverse contour roughing", ALONG),
    behind(829, "G829", "transverse contour roughing with plunging", PLUNGING),
];

impl CycleCall<'_> {
    /// G81 along Z, G82 along X: a rectangle between the tool and a corner.
    fn rectangle(&self, along_z: bool) -> Planned {
        let at = self.st.at;
        let corner = self.corner()?;
        if along_z && corner.y.min(at.y) < 0.0 {
            let fault = codes::T1007::cuts_of_g81_would_lie_beyond_turning(&(2.0 * corner.y.min(at.y)));
            return self.refuse_argument(word::X, fault);
        }
        let infeed = if along_z { word::I } else { word::K };
        let on_diameter = along_z && self.settings.control.turning.infeed == Some(RecessDepth::Diameter);
        let most = self.given.magnitude(infeed) * if on_diameter { 0.5 } else { 1.0 };
        // One cut is one cut, however its depth counts.
        if along_z && 2.0 * (at.y - corner.y).abs() > most {
            self.depends_on(Question::Infeed, self.given.place_of(infeed));
        }
        if most == 0.0 {
            return self.refuse_argument(infeed, codes::T1007::greatest_infeed_is_not_zero());
        }
        let into = match along_z {
            true if corner.y < at.y => Towards::MinusX,
            true => Towards::PlusX,
            false if corner.x < at.x => Towards::MinusZ,
            false => Towards::PlusZ,
        };
        let feed = self.feed()?;
        let infeed = (self.given.whole(word::Q) == 1).then_some(feed);
        let back = self.given.whole(word::V) == 1;
        let layers = self.beside(Layers::rectangle(at, corner, into, most, RECTANGLE_LIFT, feed))?;
        one(Cycle::Layers(Layers {
            allowance: Allowance { axes: self.rectangle_oversize(into)?, around: 0.0 },
            blank: Blank::Corner(Corner { infeed, back }),
            ..layers
        }))
    }

    /// Cuts that begin at the tool.
    fn beside(&self, layers: Option<Layers>) -> Made<Layers> {
        layers.map_or_else(|| self.refuse(codes::T2025::tool_does_not_stand_beside_contour()), Ok)
    }

    /// G57 holds for G81 and G82 and stays in force; G58 does not belong to them.
    fn rectangle_oversize(&self, into: Towards) -> Made<Vec2> {
        match self.st.modal.oversize {
            None => Ok(Vec2::zeros()),
            // Inside, X of G57 is entered with a minus sign.
            Some((Oversize::Paraxial { x, z }, _)) if into == Towards::PlusX && x <= 0.0 && z >= 0.0 => {
                Ok(Vec2::new(z, -x / 2.0))
            }
            Some((Oversize::Paraxial { x, z }, _)) if into != Towards::PlusX && x >= 0.0 && z >= 0.0 => {
                Ok(Vec2::new(z, x / 2.0))
            }
            Some((_, place)) => self.no_oversize(place, codes::T9007::oversize_does_not_fit_cycle()),
        }
    }

    /// G817 to G829, G810, G820: along a contour.
    fn contour_roughing(&self) -> Planned {
        let (at, number) = (self.st.at, self.st.number);
        let section = self.contour()?;
        let contour = section.elements();
        let into = towards(&contour, at, number / 10 == 81);
        self.check_side(&contour, into)?;
        if let Some(left) = tool_is_left(&contour, into) {
            self.check_forms(section, left)?;
        }
        self.check_stock(&contour, into)?;
        let (most, feed) = (self.given.length(word::P), self.feed()?);
        let layers = self.beside(Layers::from_corner(&contour, into, at, most, self.clearance(), feed))?;
        let layers = self.with_reliefs(layers)?;
        let layers = Layers {
            nose: self.nose_of_tool()?.unwrap_or(Nose { radius: 0.0, tip: into.unit() }),
            blank: Blank::Corner(Corner { infeed: None, back: !matches!(number, 817 | 827) }),
            allowance: Allowance { axes: self.contour_oversize()?, around: 0.0 },
            trace: match self.given.number(word::H) {
                Some(0.0) => Trace::Level,
                Some(2.0) => Trace::None,
                _ => Trace::Last,
            },
            ..layers
        };
        self.nose_matters_not_in(&layers)?;
        one(Cycle::Layers(layers))
    }

    /// What becomes of parts that fall behind a higher one: G819 and G829 cut them, the others where E says so.
    fn with_reliefs(&self, mut layers: Layers) -> Made<Layers> {
        let number = self.st.number;
        let falls = !layers.reliefs().is_empty();
        let plunges = match self.given.number(word::E) {
            Some(feed) => feed != 0.0,
            None => matches!(number, 819 | 829),
        };
        if !plunges || !falls {
            if falls || layers.leans_over() {
                let cuts = !matches!(number, 817 | 818 | 827 | 828) && falls;
                self.say(if cuts {
                    codes::T2026::e_cuts_parts_that_g_leaves(&number)
                } else {
                    codes::T2026::g_leaves_parts_of_contour_standing(&number)
                });
            }
            return Ok(layers);
        }
        let feed = layers.feeds.rough;
        layers.relief = Relief::Cut;
        layers.feeds.plunge = if self.given.has(word::E) {
            self.own_feed(word::E, feed)?
        } else {
            self.say(codes::T2028::descending_elements_are_cut_at_half_feed());
            reduced(feed)
        };
        self.check_flank(&layers)?;
        Ok(layers)
    }

    /// The flank of the tool clears the falling side of a relief cut.
    fn check_flank(&self, layers: &Layers) -> Made {
        let steepest = layers.steepest_fall();
        match self.known_tool().and_then(|tool| tool.clearance).filter(|angle| *angle > 0.0) {
            Some(angle) if steepest > angle + 1e-6 => {
                self.refuse(codes::T2030::contour_falls_at_degrees(&steepest, &angle))
            }
            Some(_) => Ok(()),
            None => {
                let active = self.st.modal.tool.as_ref();
                let answer = active.map(|tool| Answer::tool(tool.number, "clearance"));
                self.say(codes::T2031::g_cuts_falling_parts(&self.st.number).answers(answer));
                Ok(())
            }
        }
    }

    /// From the tool the contour has to rise; a tool on the wrong side would cut into the finished part.
    fn check_side(&self, contour: &[Element], into: Towards) -> Made {
        let (at, number) = (self.st.at, self.st.number);
        let bored = match self.st.blank {
            Some(Stock::Bar { bore, .. }) => bore > 0.0,
            Some(Stock::Casting { bore, .. }) => bore,
            None => false,
        };
        let inside = into == Towards::PlusX;
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return Ok(()) };
        let (a, b) = (first.from(), last.to());
        let along = |p: Point2| if into.is_radial() { (p.x - at.x).abs() } else { (p.y - at.y).abs() };
        let (near, far) = if along(a) <= along(b) { (a, b) } else { (b, a) };
        let out = -(into.unit().x + into.unit().y);
        let falls = (into.depth_coordinate(far) - into.depth_coordinate(near)) * out < -1e-6;
        if falls || (inside && !bored && matches!(number, 810 | 820)) {
            return self.refuse(codes::T2025::tool_does_not_stand_outside_of_contour());
        }
        Ok(())
    }

    /// I and K of the cycle, else G57.
    pub(super) fn contour_oversize(&self) -> Made<Vec2> {
        if self.given.has(word::I) || self.given.has(word::K) {
            if let Some((oversize, place)) = self.st.modal.oversize {
                let fault = codes::T8017::changes_nothing_here_i_or_k(&oversize.name());
                self.say_elsewhere(Elsewhere { place, fault, call: Label::Cycle });
            }
            return Ok(Vec2::new(self.given.length(word::K), self.given.length(word::I) / 2.0));
        }
        match self.st.modal.oversize {
            None => Ok(Vec2::zeros()),
            Some((Oversize::Paraxial { x, z }, _)) if x >= 0.0 && z >= 0.0 => Ok(Vec2::new(z, x / 2.0)),
            Some((_, place)) => self.no_oversize(place, codes::T9007::equidistant_or_negative_oversize()),
        }
    }

    /// Roughing begins at the tool: it stands outside of the blank along the infeed and along the cut.
    fn check_stock(&self, contour: &[Element], into: Towards) -> Made {
        let at = self.st.at;
        let (radius, length, right, bore) = match self.st.blank {
            Some(Stock::Bar { radius, length, right, bore }) => (radius, length, right, bore),
            Some(Stock::Casting { oversize, bore }) => {
                let (low, high) = frame(contour);
                let inner = if bore { (low.y - oversize).max(0.0) } else { 0.0 };
                (high.y + oversize, high.x - low.x + 2.0 * oversize, high.x + oversize, inner)
            }
            None => return Ok(()),
        };
        let along = |p: Point2| if into.is_radial() { p.x } else { p.y };
        let ends = contour.iter().flat_map(|element| [along(element.from()), along(element.to())]);
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let cut = match (into.is_radial(), along(at) >= (low + high) / 2.0) {
            (true, true) => Towards::MinusZ,
            (true, false) => Towards::PlusZ,
            (false, true) => Towards::MinusX,
            (false, false) => Towards::PlusX,
        };
        for side in [into, cut] {
            let (word, tool, limit, free) = match side {
                Towards::MinusX => ("X", 2.0 * at.y, 2.0 * radius, at.y >= radius - tolerance::SAME),
                Towards::PlusX => ("X", 2.0 * at.y, 2.0 * bore, at.y <= bore + tolerance::SAME),
                Towards::MinusZ => ("Z", at.x, right, at.x >= right - tolerance::SAME),
                Towards::PlusZ => ("Z", at.x, right - length, at.x <= right - length + tolerance::SAME),
            };
            if !free {
                let beyond = if matches!(side, Towards::MinusX | Towards::MinusZ) { "or more" } else { "or less" };
                let number = self.st.number;
                return self.refuse(codes::T2025::g_begins_at_tool(&number, &word, &tool, &limit, &beyond));
            }
        }
        Ok(())
    }
}

/// The lower and the upper corner of a frame around a contour; arcs count as their circles.
fn frame(contour: &[Element]) -> (Point2, Point2) {
    let mut low = Point2::new(f64::INFINITY, f64::INFINITY);
    let mut high = -low;
    let mut take = |p: Point2, around: f64| {
        low = Point2::new(low.x.min(p.x - around), low.y.min(p.y - around));
        high = Point2::new(high.x.max(p.x + around), high.y.max(p.y + around));
    };
    for element in contour {
        take(element.from(), 0.0);
        take(element.to(), 0.0);
        if let Element::Arc { from, center, .. } = *element {
            take(center, distance(from, center));
        }
    }
    (low, high)
}

/// Into the material: from the tool to the contour.
fn towards(contour: &[Element], at: Point2, along_z: bool) -> Towards {
    let points = contour.iter().flat_map(|element| [element.from(), element.to()]);
    let (mut below, mut above) = (0.0_f64, 0.0_f64);
    for p in points {
        let off = if along_z { p.y - at.y } else { p.x - at.x };
        below = below.max(-off);
        above = above.max(off);
    }
    match (along_z, above > below) {
        (true, false) => Towards::MinusX,
        (true, true) => Towards::PlusX,
        (false, false) => Towards::MinusZ,
        (false, true) => Towards::PlusZ,
    }
}
