//! Roughing in parallel cuts: G81 and G82, G817 to G829 with the contour behind them, G810 and G820 along a contour.
//!
//! Source: T 7, 8.1 and 8.2 (docs/sources.md).

use crate::diag::{Diagnostic, codes};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::layers::{Allowance, Blank, Layers, Relief, Trace};
use crate::ir::cycle::roughing::{Corner, Nose};
use crate::ir::cycle::turning::Towards;
use crate::machine::{Axis, RecessDepth};

use super::chain::Coord;
use super::finishing::reduced;
use super::geometry::Blank as Stock;
use super::outline::Outline;
use super::readings::Question;
use super::technology::Oversize;
use super::tool_side::tool_is_left;
use super::words::Words;
use super::{Outcome, Reported, Run};

/// How far G81 and G82 lift off, mm.
const RECTANGLE_LIFT: f64 = 1.0;

impl Run<'_> {
    /// G81 along Z, G82 along X: a rectangle between the tool and a corner.
    pub(super) fn rectangle(&mut self, w: &Words, along_z: bool) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        let corner = self.corner_of(w, at)?;
        if along_z && corner.y.min(at.y) < 0.0 {
            return self.refuse(
                w.span(b'X', span),
                codes::T1007::cuts_of_g81_would_lie_beyond_turning(&(2.0 * corner.y.min(at.y))),
            );
        }
        let (infeed, offset) = if along_z { (b'I', b'K') } else { (b'K', b'I') };
        if let Some(num) = w.get(offset).filter(|num| num.value != 0.0) {
            return self.refuse(num.span, codes::T9007::to_which_side_makes_end_oblique(&(offset as char)));
        }
        let num = self.needed(w, infeed, "the greatest infeed", span)?;
        let on_diameter = along_z && self.job.settings.control.turning.infeed == Some(RecessDepth::Diameter);
        let most = num.value.abs() * self.st.mm() * if on_diameter { 0.5 } else { 1.0 };
        // One cut is one cut, however its depth counts.
        if along_z && 2.0 * (at.y - corner.y).abs() > most {
            self.depends_on(Question::Infeed, num.span);
        }
        if most == 0.0 {
            return self.refuse(num.span, codes::T1007::greatest_infeed_is_not_zero());
        }
        let into = match along_z {
            true if corner.y < at.y => Towards::MinusX,
            true => Towards::PlusX,
            false if corner.x < at.x => Towards::MinusZ,
            false => Towards::PlusZ,
        };
        let feed = self.cutting_feed()?;
        let infeed = if self.choice(w, b'Q', 0, 1)? == 1 { Some(feed) } else { None };
        let back = self.choice(w, b'V', 0, 1)? == 1;
        let layers = self.beside(Layers::rectangle(at, corner, into, most, RECTANGLE_LIFT, feed))?;
        self.send_cycle(&Cycle::Layers(Layers {
            allowance: Allowance { axes: self.rectangle_oversize(into)?, around: 0.0 },
            blank: Blank::Corner(Corner { infeed, back }),
            ..layers
        }));
        Ok(())
    }

    /// Cuts that begin at the tool.
    fn beside(&self, layers: Option<Layers>) -> Outcome<Layers> {
        layers.map_or_else(|| self.refuse(self.block_span(), codes::T2025::tool_does_not_stand_beside_contour()), Ok)
    }

    pub(super) fn corner_of(&mut self, w: &Words, at: Point2) -> Outcome<Point2> {
        let ordinate = |coord: Coord, from: f64| match coord {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Stay | Coord::Open => None,
        };
        let x = ordinate(self.coord(w.get(b'X'), Axis::X), at.y);
        let z = ordinate(self.coord(w.get(b'Z'), Axis::Z), at.x);
        match (x, z) {
            (Some(x), Some(z)) => Ok(Point2::new(z, x)),
            _ => self.refuse(self.block_span(), codes::P1004::cycle_needs_x()),
        }
    }

    /// G57 holds for G81 and G82 and stays in force; G58 does not belong to them.
    fn rectangle_oversize(&self, into: Towards) -> Outcome<Vec2> {
        match self.st.oversize {
            None => Ok(Vec2::zeros()),
            // Inside, X of G57 is entered with a minus sign.
            Some((Oversize::Paraxial { x, z }, _)) if into == Towards::PlusX && x <= 0.0 && z >= 0.0 => {
                Ok(Vec2::new(z, -x / 2.0))
            }
            Some((Oversize::Paraxial { x, z }, _)) if into != Towards::PlusX && x >= 0.0 && z >= 0.0 => {
                Ok(Vec2::new(z, x / 2.0))
            }
            Some((_, loc)) => self.oversize_refused(loc, "this oversize does not fit the cycle behind it"),
        }
    }

    pub(super) fn oversize_refused<T>(&self, loc: crate::text::Loc, message: &str) -> Outcome<T> {
        let found = Diagnostic::new(codes::T9007, loc, message);
        self.report(
            found.also(self.here.origin.loc, "the cycle").help("program I and K in the cycle, or G50 before it"),
        );
        Err(Reported)
    }

    /// G817 to G829, G810, G820: along a contour. `along_z`: the cuts run along Z.
    pub(super) fn contour_roughing(&mut self, w: &Words, outline: Option<&Outline>, number: u16) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        let along_z = number / 10 == 81;
        for letter in [b'X', b'Z', b'A', b'W'] {
            if let Some(num) = w.get(letter) {
                return self.refuse(num.span, codes::T9007::of_g_is_not_supported(&(letter as char), &number));
            }
        }
        if let Some(num) = w.get(b'Q').filter(|num| num.value != 0.0) {
            return self.refuse(num.span, codes::T9007::only_value_0_of_q_is_supported());
        }
        if let Some(num) = w.long("XA").or(w.long("ZA")) {
            return self.refuse(num.span, codes::T9007::corner_of_blank_is_taken_from_tool());
        }
        let most = self.needed(w, b'P', "the greatest infeed", span)?;
        let most = self.above_zero(most, "the greatest infeed")?;
        let section = self.contour_with_ends(w, outline)?;
        let contour = section.elements();
        let into = towards(&contour, at, along_z);
        self.check_side(&contour, at, into, number)?;
        if let Some(left) = tool_is_left(&contour, into) {
            self.check_forms(&section, left)?;
        }
        self.check_stock(&contour, at, into, number)?;
        let feed = self.cutting_feed()?;
        let layers = self.beside(Layers::from_corner(&contour, into, at, most, self.cycle_clearance(), feed))?;
        let layers = self.with_reliefs(w, layers, number)?;
        let layers = Layers {
            nose: self.nose_of_tool()?.unwrap_or(Nose { radius: 0.0, tip: into.unit() }),
            blank: Blank::Corner(Corner { infeed: None, back: !matches!(number, 817 | 827) }),
            allowance: Allowance { axes: self.contour_oversize(w)?, around: 0.0 },
            trace: match self.choice(w, b'H', 1, 2)? {
                0 => Trace::Level,
                1 => Trace::Last,
                _ => Trace::None,
            },
            ..layers
        };
        self.nose_matters_not_in(&layers)?;
        self.send_cycle(&Cycle::Layers(layers));
        self.st.oversize = None;
        Ok(())
    }

    /// What becomes of parts that fall behind a higher one: G819 and G829 cut them, the others where E says so.
    fn with_reliefs(&self, w: &Words, mut layers: Layers, number: u16) -> Outcome<Layers> {
        let falls = !layers.reliefs().is_empty();
        let plunges = match w.get(b'E') {
            Some(num) => num.value != 0.0,
            None => matches!(number, 819 | 829),
        };
        if !plunges || !falls {
            if falls || layers.leans_over() {
                let found = codes::T2026::g_leaves_parts_of_contour_standing(&number).at(self.here.origin.loc);
                let cuts = !matches!(number, 817 | 818 | 827 | 828) && falls;
                self.report(if cuts { found.help("E with a feed above 0 cuts them") } else { found });
            }
            return Ok(layers);
        }
        let feed = layers.feeds.rough;
        layers.relief = Relief::Cut;
        layers.feeds.plunge = if w.has(b'E') { self.own_feed(w, b'E', feed)? } else { reduced(feed) };
        if !w.has(b'E') {
            self.note_descending();
        }
        self.check_flank(&layers, number)?;
        Ok(layers)
    }

    /// The flank of the tool clears the falling side of a relief cut.
    fn check_flank(&self, layers: &Layers, number: u16) -> Outcome {
        let steepest = layers.steepest_fall();
        match self.known_tool().and_then(|tool| tool.clearance).filter(|angle| *angle > 0.0) {
            Some(angle) if steepest > angle + 1e-6 => {
                self.refuse(self.block_span(), codes::T2030::contour_falls_at_degrees(&steepest, &angle))
            }
            Some(_) => Ok(()),
            None => {
                let found = codes::T2031::g_cuts_falling_parts(&number).at(self.here.origin.loc);
                self.report(
                    found.help("give the clearance angle of the tool in partc.toml: `[tools.N] clearance = 30`"),
                );
                Ok(())
            }
        }
    }

    /// From the tool the contour has to rise; a tool on the wrong side would cut into the finished part.
    fn check_side(&self, contour: &[Element], at: Point2, into: Towards, number: u16) -> Outcome {
        let bored = match self.geometry.blank {
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
            return self.refuse(self.block_span(), codes::T2025::tool_does_not_stand_outside_of_contour());
        }
        Ok(())
    }

    /// I and K of the cycle, else G57.
    pub(super) fn contour_oversize(&self, w: &Words) -> Outcome<Vec2> {
        let mm = self.st.mm();
        let length = |letter: u8| match w.get(letter) {
            Some(num) if num.value < 0.0 => self.refuse(num.span, codes::T1007::oversize_is_not_negative()),
            num => Ok(num.map_or(0.0, |num| num.value * mm)),
        };
        if w.has(b'I') || w.has(b'K') {
            if let Some((oversize, loc)) = self.st.oversize {
                let name = oversize.name();
                let found = codes::T8017::changes_nothing_here_i_or_k(&name).at(loc);
                self.report(
                    found.also(self.here.origin.loc, "the cycle").help("program both I and K in the cycle, or neither"),
                );
            }
            return Ok(Vec2::new(length(b'K')?, length(b'I')? / 2.0));
        }
        match self.st.oversize {
            None => Ok(Vec2::zeros()),
            Some((Oversize::Paraxial { x, z }, _)) if x >= 0.0 && z >= 0.0 => Ok(Vec2::new(z, x / 2.0)),
            Some((_, loc)) => self.oversize_refused(loc, "an equidistant or negative oversize is not supported here"),
        }
    }
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
