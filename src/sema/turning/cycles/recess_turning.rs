//! G869, recess turning along a contour: its words and their defaults.
//!
//! Source: T 8.8 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Element, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::{Operation, Passes, RecessEnd, RecessFeeds, RecessTurning};
use crate::ir::cycle::turning::Towards;
use crate::machine::RecessDepth;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Name, Rule, feed, length, number};

use super::super::blank::Blank;
use super::super::readings::Question;
use super::super::tool_side::tool_is_left;
use super::{
    APPROACH, Contour, CycleCall, DEPARTURE, ENDS, ID, INFEED, LIMIT_X, LIMIT_Z, NE, NS, Need, OVERSIZE_X, OVERSIZE_Z,
    Planned, Refused, Row, Unbuilt, XA, ZA, one, word,
};

const fn limit(word: Name) -> Unbuilt {
    Unbuilt::all(word, |it: &Refused| codes::T9007::of_g869_cutting_limit(&it.word))
}

pub(super) const ROWS: &[Row] = &[Row::new(
    869,
    "G869",
    "recess turning",
    "4290-71, p. 225; MANUALplus 620",
    &[
        NS,
        NE,
        ID,
        INFEED,
        length("R", "turning depth compensation").unsigned().default("0"),
        length("RB", "turning depth compensation, as R").unsigned().default("R"),
        OVERSIZE_X,
        OVERSIZE_Z,
        LIMIT_X,
        LIMIT_Z,
        APPROACH,
        DEPARTURE,
        number("Q", "0 roughs and finishes, 1 roughs, 2 finishes").rule(Rule::OneOf(0, 2)).default("0"),
        number("U", "0 both ways, 1 one way").rule(Rule::OneOf(0, 1)).default("0"),
        number("H", "0 back to the start, 1 in front of the contour, 2 lifted").rule(Rule::OneOf(0, 2)).default("0"),
        ENDS,
        feed("O", "feed of recessing").rule(Rule::Above(0)).default("that in force"),
        feed("E", "feed of finishing").rule(Rule::Above(0)).default("that in force"),
        length("B", "offset width").unsigned().default("0"),
        XA,
        ZA,
        length("RI", "oversize of the blank along X"),
        length("RK", "oversize of the blank along Z"),
    ],
    |call| call.recess_turning(),
)
.contour(Contour::Referenced)
.unbuilt(&[
    limit(word::X),
    limit(word::Z),
    limit(word::A),
    limit(word::W),
    Unbuilt::one(word::V, 4.0, |_| codes::T9007::v4_only_chamfer_or_rounding_of_element()),
])
.requires(&[
    Need::LaterControl(|| {
        codes::T2017::manualplus_4110_has_no_g869().answer(Answer::key("control", "heidenhain_turning"))
    }),
    Need::Feed,
])];

impl CycleCall<'_> {
    fn recess_turning(&self) -> Planned {
        let at = self.st.at;
        self.corner_of_blank_is_given_once()?;
        let (tool, radial) = self.no_fault(self.st.modal.recess_tool(self.settings))?;
        let section = self.contour()?;
        let contour = section.elements();
        let into = direction(&contour, radial);
        if let Some(left) = tool_is_left(&contour, into) {
            self.check_forms(section, left)?;
        }
        self.above_rim(&contour, at, into)?;
        let clearance = self.clearance();
        let turn = self.feed()?;
        let operation = match self.given.whole(word::Q) {
            0 => Operation::RoughAndFinish,
            1 => Operation::Rough,
            _ => Operation::Finish,
        };
        one(Cycle::RecessTurning(RecessTurning {
            blank: self.blank_height(into, &contour, into.depth_coordinate(at), clearance)?,
            contour,
            into,
            tool,
            most: self.given.length(word::P),
            oversize: self.contour_oversize()?,
            offset_width: self.given.length(word::B),
            compensation: self.turning_depth(operation)?,
            passes: self.passes(),
            operation,
            clearance,
            feeds: RecessFeeds { plunge: self.own_feed(word::O, turn)?, turn, finish: self.own_feed(word::E, turn)? },
            end: match self.given.whole(word::H) {
                0 => RecessEnd::Start,
                1 => RecessEnd::Front,
                _ => RecessEnd::Lift,
            },
        }))
    }

    /// R or RB: how much higher the tool stands while it turns the floor in finishing.
    fn turning_depth(&self, operation: Operation) -> Made<f64> {
        let name = match (self.given.has(word::R), self.given.has(word::RB)) {
            (true, true) => return self.refuse_argument(word::RB, codes::P1005::r_rb_are_same_word_of_g869()),
            (false, false) => return Ok(0.0),
            (true, false) => word::R,
            (false, true) => word::RB,
        };
        let depth = self.given.length(name);
        if depth > 0.0 && operation != Operation::Rough {
            self.depends_on(Question::TurningDepth, self.given.place_of(name));
        }
        let towards = self.settings.control.turning.towards_floor == Some(true);
        Ok(depth * if towards { -1.0 } else { 1.0 })
    }

    /// U, and what B does with it.
    fn passes(&self) -> Passes {
        if self.given.whole(word::U) == 0 {
            return Passes::BothWays;
        }
        if self.given.or_zero(word::B) != 0.0 {
            self.depends_on(Question::OffsetOneWay, self.given.place_of(word::B));
        }
        let shorter = self.settings.control.turning.offset_one_way == Some(true);
        if shorter { Passes::OneWayShorter } else { Passes::OneWay }
    }

    /// The tool comes from outside of the rims of the recess; below the higher one it stands between the two.
    fn above_rim(&self, contour: &[Element], at: Point2, into: Towards) -> Made {
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return Ok(()) };
        let out = -(into.unit().x + into.unit().y);
        let height = |p: Point2| into.depth_coordinate(p) * out;
        let along = |p: Point2| if into.is_radial() { p.x } else { p.y };
        let (a, b) = (first.from(), last.to());
        let between = (along(at) - along(a)) * (along(at) - along(b)) < 0.0;
        let rim = if between { height(a).min(height(b)) } else { height(a).max(height(b)) };
        let tool = height(at);
        if tool >= rim - 1e-6 {
            return Ok(());
        }
        let (word, scale) = if into.is_radial() { ("X", 2.0 * out) } else { ("Z", out) };
        self.refuse(codes::T2025::tool_stands_at_inside_of_material(&word, &(tool * scale), &(rim * scale)))
    }

    fn corner_of_blank_is_given_once(&self) -> Made {
        let first = |names: [Name; 2]| names.into_iter().find(|name| self.given.has(*name));
        match (first([word::XA, word::ZA]), first([word::RI, word::RK])) {
            (Some(_), Some(name)) => self.refuse_argument(name, codes::P1005::xa_za_say_where_corner_of_blank()),
            _ => Ok(()),
        }
    }

    /// How high the blank stands: XA or ZA, the bar of the section BLANK, or up to the clearance below the tool.
    fn blank_height(&self, into: Towards, contour: &[Element], tool: f64, clearance: f64) -> Made<f64> {
        let (corner, along, proud) = match into.is_radial() {
            true => (word::XA, [word::ZA, word::RK], word::RI),
            false => (word::ZA, [word::XA, word::RI], word::RK),
        };
        let idle = [self.given.has(along[0]), self.given.or_zero(along[1]) != 0.0];
        for (name, _) in along.into_iter().zip(idle).filter(|(_, idle)| *idle) {
            self.say_of(name, codes::T8017::only_height_of_blank_counts(&name));
        }
        let out = -(into.unit().x + into.unit().y);
        let ends = contour.iter().flat_map(|element| [element.from(), element.to()]);
        let rim = ends.map(|p| into.depth_coordinate(p) * out).fold(f64::NEG_INFINITY, f64::max);
        let corner = self.given.length_if(corner).map(|place| if into.is_radial() { place / 2.0 } else { place });
        // RI and RK stand on the rim of the contour.
        if let Some(oversize) = self.given.length_if(proud) {
            if oversize < 0.0 {
                return self.refuse_argument(proud, codes::T1007::oversize_of_blank_is_not_negative());
            }
            if into.is_radial() && oversize > 0.0 {
                self.depends_on(Question::RecessBlank, self.given.place_of(proud));
            }
            let half = into.is_radial() && self.settings.control.turning.recess_blank != Some(RecessDepth::Radius);
            return Ok((rim + oversize * if half { 0.5 } else { 1.0 }) * out);
        }
        let stock = match (self.st.blank, into) {
            (Some(Blank::Bar { radius, .. }), Towards::MinusX) => Some(radius),
            (Some(Blank::Bar { bore, .. }), Towards::PlusX) if bore > 0.0 => Some(bore),
            (Some(Blank::Bar { right, .. }), Towards::MinusZ) => Some(right),
            _ => None,
        };
        // Elsewhere the tool would stay lower than the bar afterwards.
        let back = self.given.whole(word::H) == 0;
        let left = self.st.modal.stock.left_by_roughing(contour, into, self.st.modal.shift.total());
        let left = left.filter(|_| back).map_or(f64::INFINITY, |left| left * out);
        let stock = stock.map(|height| (height * out).min(left));
        let height = corner.map(|height| height * out).or(stock).unwrap_or(tool * out - clearance);
        Ok(height.max(rim) * out)
    }
}

/// Into the material: from the rim of the contour to its floor.
fn direction(contour: &[Element], radial: bool) -> Towards {
    let height = |element: &Element| {
        let (from, to) = (element.from(), element.to());
        if radial { from.y + to.y } else { from.x + to.x }
    };
    let rim = contour.first().map_or(0.0, |first| if radial { 2.0 * first.from().y } else { 2.0 * first.from().x });
    let sum: f64 = contour.iter().map(|element| height(element) - rim).sum();
    match (radial, sum > 0.0) {
        (true, false) => Towards::MinusX,
        (true, true) => Towards::PlusX,
        (false, false) => Towards::MinusZ,
        (false, true) => Towards::PlusZ,
    }
}
