//! G869, recess turning along a contour: its parameters and their defaults.
//!
//! Source: T 8.8 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Element, Point2};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::{Operation, Passes, RecessEnd, RecessFeeds, RecessTool, RecessTurning};
use crate::ir::cycle::turning::Towards;
use crate::machine::RecessDepth;
use crate::machine::tools::Corner;

use super::geometry::Blank;
use super::outline::Outline;
use super::readings::Question;
use super::tool_side::tool_is_left;
use super::words::Words;
use super::{Outcome, Run};

/// Clearance where neither G47 nor the configuration sets one, in mm.
const CLEARANCE: f64 = 1.0;

impl Run<'_> {
    pub(super) fn recess_turning(&mut self, w: &Words, outline: Option<&Outline>) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        self.refuse_limits(w)?;
        let most = self.needed(w, b'P', "the greatest infeed", span)?;
        let most = self.above_zero(most, "the greatest infeed")?;
        let (tool, radial) = self.recess_tool()?;
        let section = self.contour_with_ends(w, outline)?;
        let contour = section.elements();
        let into = direction(&contour, radial);
        if let Some(left) = tool_is_left(&contour, into) {
            self.check_forms(&section, left)?;
        }
        self.above_rim(&contour, at, into)?;
        let clearance = self.cycle_clearance();
        let turn = self.cutting_feed()?;
        let operation = match self.choice(w, b'Q', 0, 2)? {
            0 => Operation::RoughAndFinish,
            1 => Operation::Rough,
            _ => Operation::Finish,
        };
        let recess = RecessTurning {
            blank: self.blank_height(w, into, &contour, into.depth_coordinate(at), clearance)?,
            contour,
            into,
            tool,
            most,
            oversize: self.contour_oversize(w)?,
            offset_width: self.length(w, "B")?,
            compensation: self.turning_depth(w, operation)?,
            passes: self.passes(w)?,
            operation,
            clearance,
            feeds: RecessFeeds { plunge: self.own_feed(w, b'O', turn)?, turn, finish: self.own_feed(w, b'E', turn)? },
            end: match self.choice(w, b'H', 0, 2)? {
                0 => RecessEnd::Start,
                1 => RecessEnd::Front,
                _ => RecessEnd::Lift,
            },
        };
        self.send_cycle(&Cycle::RecessTurning(recess));
        self.st.oversize = None;
        Ok(())
    }

    /// R or RB: how much higher the tool stands while it turns the floor in finishing.
    fn turning_depth(&self, w: &Words, operation: Operation) -> Outcome<f64> {
        let num = match (w.get(b'R'), w.long("RB")) {
            (Some(_), Some(num)) => return self.refuse(num.span, codes::P1005::r_rb_are_same_word_of_g869()),
            (r, rb) => r.or(rb),
        };
        let Some(num) = num else { return Ok(0.0) };
        if num.value < 0.0 {
            return self.refuse(num.span, codes::T1007::turning_depth_compensation_is_not_negative());
        }
        if num.value > 0.0 && operation != Operation::Rough {
            self.depends_on(Question::TurningDepth, num.span);
        }
        let towards = self.job.settings.control.turning.towards_floor == Some(true);
        Ok(num.value * self.st.mm() * if towards { -1.0 } else { 1.0 })
    }

    /// U, and what B does with it.
    fn passes(&self, w: &Words) -> Outcome<Passes> {
        if self.choice(w, b'U', 0, 1)? == 0 {
            return Ok(Passes::BothWays);
        }
        if let Some(num) = w.get(b'B').filter(|num| num.value != 0.0) {
            self.depends_on(Question::OffsetOneWay, num.span);
        }
        let shorter = self.job.settings.control.turning.offset_one_way == Some(true);
        Ok(if shorter { Passes::OneWayShorter } else { Passes::OneWay })
    }

    /// The tool comes from outside of the rims of the recess; below the higher one it stands between the two.
    fn above_rim(&self, contour: &[Element], at: Point2, into: Towards) -> Outcome {
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
        self.refuse(
            self.block_span(),
            codes::T2025::tool_stands_at_inside_of_material(&word, &(tool * scale), &(rim * scale)),
        )
    }

    /// Words whose effect on the path no text at hand describes.
    fn refuse_limits(&self, w: &Words) -> Outcome {
        for letter in [b'X', b'Z', b'A', b'W'] {
            if let Some(num) = w.get(letter) {
                return self.refuse(num.span, codes::T9007::of_g869_cutting_limit(&(letter as char)));
            }
        }
        let said = w.long("XA").or(w.long("ZA"));
        match w.long("RI").or(w.long("RK")).filter(|_| said.is_some()) {
            Some(num) => self.refuse(num.span, codes::P1005::xa_za_say_where_corner_of_blank()),
            None => Ok(()),
        }
    }

    /// A length that is not negative, 0 where it is missing.
    fn length(&self, w: &Words, name: &str) -> Outcome<f64> {
        let num = match name.as_bytes() {
            [letter] => w.get(*letter),
            _ => w.long(name),
        };
        match num {
            None => Ok(0.0),
            Some(num) if num.value >= 0.0 => Ok(num.value * self.st.mm()),
            Some(num) => self.refuse(num.span, codes::T1007::is_not_negative(&name)),
        }
    }

    /// A feed of the cycle in the mode in force.
    pub(super) fn own_feed(&self, w: &Words, letter: u8, active: Feed) -> Outcome<Feed> {
        let Some(num) = w.get(letter) else { return Ok(active) };
        Ok(active.with_value(self.above_zero(num, "a feed")?))
    }

    pub(super) fn cycle_clearance(&self) -> f64 {
        self.st.clearance.or(self.job.settings.control.turning.clearance).unwrap_or(CLEARANCE)
    }

    /// The tool in the cutting position as a recessing tool, and whether it cuts radially.
    pub(super) fn recess_tool(&self) -> Outcome<(RecessTool, bool)> {
        let span = self.block_span();
        let Some(active) = &self.st.tool else {
            return self.refuse(span, codes::P2004::no_tool_is_in_cutting_position());
        };
        let known = self.known_tool();
        let radial = match known.and_then(|tool| tool.kind.as_deref()) {
            Some("recess-radial") => Some(true),
            Some("recess-axial") => Some(false),
            _ => None,
        };
        let data = known.and_then(|tool| Some((tool.width?, tool.radius?, tool.reference)));
        let (Some(radial), Some((width, nose, reference))) = (radial, data) else {
            let number = active.number;
            return self.refuse(
                span,
                codes::P2004::kind_width_or_nose_radius_of_recessing(&number).answers([
                    Answer::tool(number, "kind").one_of(&["\"recess-radial\"", "\"recess-axial\""]),
                    Answer::tool(number, "width"),
                    Answer::tool(number, "radius"),
                ]),
            );
        };
        let edge = match reference {
            Corner::Minus => 0.0,
            Corner::Plus => -width,
            Corner::Middle => -width / 2.0,
        };
        Ok((RecessTool { width, nose, edge }, radial))
    }

    /// How high the blank stands: XA or ZA, the bar of the section BLANK, or up to the clearance below the tool.
    fn blank_height(&self, w: &Words, into: Towards, contour: &[Element], tool: f64, clearance: f64) -> Outcome<f64> {
        let mm = self.st.mm();
        for name in if into.is_radial() { ["ZA", "RK"] } else { ["XA", "RI"] } {
            if let Some(num) = w.long(name).filter(|num| name.ends_with('A') || num.value != 0.0) {
                self.note_idle(num.span, name, "only the height of the blank along the infeed counts");
            }
        }
        let out = -(into.unit().x + into.unit().y);
        let ends = contour.iter().flat_map(|element| [element.from(), element.to()]);
        let rim = ends.map(|p| into.depth_coordinate(p) * out).fold(f64::NEG_INFINITY, f64::max);
        let corner = match into.is_radial() {
            true => w.long("XA").map(|num| num.value * mm / 2.0),
            false => w.long("ZA").map(|num| num.value * mm),
        };
        // RI and RK stand on the rim of the contour.
        let half = self.job.settings.control.turning.recess_blank != Some(RecessDepth::Radius);
        let proud = match into.is_radial() {
            true => w.long("RI").map(|num| (num, if half { mm / 2.0 } else { mm })),
            false => w.long("RK").map(|num| (num, mm)),
        };
        if let Some((num, scale)) = proud {
            if num.value < 0.0 {
                return self.refuse(num.span, codes::T1007::oversize_of_blank_is_not_negative());
            }
            if into.is_radial() && num.value > 0.0 {
                self.depends_on(Question::RecessBlank, num.span);
            }
            return Ok((rim + num.value * scale) * out);
        }
        let stock = match (self.geometry.blank, into) {
            (Some(Blank::Bar { radius, .. }), Towards::MinusX) => Some(radius),
            (Some(Blank::Bar { bore, .. }), Towards::PlusX) if bore > 0.0 => Some(bore),
            (Some(Blank::Bar { right, .. }), Towards::MinusZ) => Some(right),
            _ => None,
        };
        // Elsewhere the tool would stay lower than the bar afterwards.
        let back = self.choice(w, b'H', 0, 2)? == 0;
        let left = self.left_by_roughing(contour, into).filter(|_| back).map_or(f64::INFINITY, |left| left * out);
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
