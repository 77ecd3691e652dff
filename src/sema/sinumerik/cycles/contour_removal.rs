//! CYCLE95 and CYCLE952: stock removal along a contour.
//!
//! Source: M 3 and 5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Element, Point2, Vec2};
use crate::ir::captured::Captured;
use crate::ir::cycle::layers::{
    Allowance, Blank, ChipBreaking, Clearance, Interruption, LayerFeeds, Layers, Limits, Relief, Segmentation, Trace,
};
use crate::ir::cycle::recess::Operation;
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::turning::Towards;

use super::super::g_groups::GCode;
use super::super::named_contour::CalledContour;
use super::call::{Acts, CycleCall};
use super::layers::{Side, rectangle};
use super::names::{
    AMODE, BL, CON, CONR, D, DAM, DI, DMODE, DT, F, FAL, FALX, FALZ, FF1, FF2, FF3, FR, FS, GMODE, MID, RP, SC, U, U1,
    UX, UZ, VARI, VRT, XA, XB, XD, ZA, ZB, ZD,
};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

/// Way back where a cut of CYCLE952 is interrupted, mm (SD 55586).
const INTERRUPTION: f64 = 1.0;

/// Smallest and largest coordinates of a contour, arcs counted by their whole way.
#[derive(Debug, Clone, Copy)]
struct Extent {
    low: Point2,
    high: Point2,
}

impl Extent {
    fn of(contour: &[Element]) -> Extent {
        let mut extent = Extent {
            low: Point2::new(f64::INFINITY, f64::INFINITY),
            high: Point2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
        };
        for element in contour.iter().flat_map(crate::geo::element::quarters) {
            for p in [element.from(), element.to()] {
                extent.low = Point2::new(extent.low.x.min(p.x), extent.low.y.min(p.y));
                extent.high = Point2::new(extent.high.x.max(p.x), extent.high.y.max(p.y));
            }
        }
        extent
    }

    /// The corner in front of the cuts and out of the material, and the opposite one.
    fn corners(&self, side: Side) -> (Point2, Point2) {
        let pick = |front: bool, low: f64, high: f64| if front { high } else { low };
        let (low, high) = (side.place(self.low), side.place(self.high));
        let near = side.point(pick(side.along < 0.0, low.0, high.0), pick(side.out() > 0.0, low.1, high.1));
        let far = side.point(pick(side.along > 0.0, low.0, high.0), pick(side.out() < 0.0, low.1, high.1));
        (near, far)
    }
}

fn shifted(element: &Element, by: Vec2) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: from + by, to: to + by },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: from + by, to: to + by, center: center + by, sweep }
        }
    }
}

fn elements(made: &Captured) -> Vec<Element> {
    made.pieces.iter().map(|piece| piece.element).collect()
}

impl CycleCall<'_> {
    /// CYCLE95.
    pub(super) fn classic_removal(&self, contours: &[CalledContour]) -> Made<Acts> {
        let [part] = contours else { return Ok(Acts::new()) };
        self.removal_digits()?;
        let (operation, side, leaves_steps) = self.way_95()?;
        let (contour, turned) = side.in_order(&elements(&part.made));
        let most = self.infeed(MID, operation)?;
        let keys = self.settings.cycles.layers.clone();
        let lift = Some(self.given.magnitude(VRT)).filter(|way| *way > 0.0).unwrap_or(keys.release);
        let allowance = Allowance {
            axes: Vec2::new(self.given.magnitude(FALZ), self.given.magnitude(FALX)),
            around: self.given.magnitude(FAL),
        };
        if allowance.axes.y != 0.0 {
            self.say_of(FALX, codes::P8106::falx_counts_on_radius());
        }
        if allowance.around != 0.0 && allowance.axes != Vec2::zeros() {
            self.own_way(codes::P8101::fal_is_left_beside_falx());
        }
        let feeds = self.removal_feeds(operation, [FF1, FF3])?;
        let chips = self.chips_95();
        let nose = self.nose_of_edge()?;
        let extent = Extent::of(&contour);
        let (near, far) = extent.corners(side);
        let (along, up) = if side.into.is_radial() {
            (allowance.axes.x, allowance.axes.y)
        } else {
            (allowance.axes.y, allowance.axes.x)
        };
        let entry = lift + along + allowance.around;
        let (cut, depth) = side.place(near);
        let mut layers = Layers {
            contour,
            into: side.into,
            along: side.along,
            nose,
            blank: Blank::Outline(rectangle(near, far)),
            allowance,
            most,
            segmentation: Segmentation::Uniform,
            trace: if leaves_steps { Trace::Level } else { Trace::Overlapping },
            chips,
            relief: Relief::Cut,
            limits: Limits::default(),
            operation,
            finish_backwards: turned && operation == Operation::Finish,
            clearance: Clearance { lift, entry },
            feeds,
            home: side.point(cut - side.along * entry, depth + side.out() * (up + allowance.around + lift)),
        };
        self.plunge_feed(&mut layers, FF2)?;
        let by_tip = keys.rough_by_tip.unwrap_or(self.settings.control.sinumerik.model == "802d");
        if by_tip && operation != Operation::Finish && nose.radius > 0.0 {
            return self.rough_by_tip(layers);
        }
        self.send_layers(layers)
    }

    /// VARI of CYCLE95: what is done, from where, and whether the cuts leave their steps.
    fn way_95(&self) -> Made<(Operation, Side, bool)> {
        let given = self.given;
        let help = "1 to 4 rough, 5 to 8 finish, 9 to 12 do both; of each along Z or X, outside or inside; 2 before them leaves steps";
        let vari = given.or_zero(VARI);
        if !(1.0..300.0).contains(&vari) || vari.fract() != 0.0 {
            return self.kind_fault(VARI, help);
        }
        let (kind, steps) = (vari as i32 % 100, vari as i32 / 100);
        if !(1..=12).contains(&kind) || steps == 1 {
            return self.kind_fault(VARI, help);
        }
        let Some(operation) = self.operation((kind - 1) / 4 + 1) else { return self.kind_fault(VARI, help) };
        let side = match (kind - 1) % 4 {
            0 => Side { into: Towards::MinusX, along: -1.0 },
            1 => Side { into: Towards::MinusZ, along: -1.0 },
            2 => Side { into: Towards::PlusX, along: -1.0 },
            _ => Side { into: Towards::MinusZ, along: 1.0 },
        };
        Ok((operation, side, steps == 2))
    }

    /// Roughing by the programmed tip, finishing with the nose.
    fn rough_by_tip(&self, layers: Layers) -> Made<Acts> {
        // The tip stands for the nose only where it lies ahead of it and below.
        let ahead = layers.into.unit() + layers.side_of_cuts();
        if layers.nose.tip != ahead {
            self.own_way(codes::P8101::tip_of_tool_does_not_lie_ahead());
            return self.send_layers(layers);
        }
        if !layers.reliefs().is_empty() || layers.leans_over() {
            self.own_way(codes::P8101::contour_falls());
            return self.send_layers(layers);
        }
        let finishes = layers.operation == Operation::RoughAndFinish;
        let nose = layers.nose;
        let rough = Layers { nose: Nose { radius: 0.0, ..nose }, operation: Operation::Rough, ..layers.clone() };
        let mut acts = self.send_layers(rough)?;
        if finishes {
            acts.extend(self.send_layers(Layers { operation: Operation::Finish, ..layers })?);
        }
        Ok(acts)
    }

    /// Feeds of roughing and finishing; one that the kind of machining does not use is not asked for.
    fn removal_feeds(&self, operation: Operation, [rough, finish]: [Name; 2]) -> Made<LayerFeeds> {
        let first = self.mill_feed(if operation == Operation::Finish { finish } else { rough })?;
        let last = if operation == Operation::RoughAndFinish { self.mill_feed(finish)? } else { first };
        Ok(LayerFeeds { rough: first, plunge: first, finish: last })
    }

    /// The feed into relief cuts, where there are some.
    fn plunge_feed(&self, layers: &mut Layers, key: Name) -> Made {
        let cuts = layers.relief == Relief::Cut && layers.operation != Operation::Finish;
        if cuts && !layers.reliefs().is_empty() {
            layers.feeds.plunge = self.mill_feed(key)?;
        }
        Ok(())
    }

    /// A dwell after each part of a long cut.
    fn chips_95(&self) -> Option<ChipBreaking> {
        let given = self.given;
        let every = self.given.magnitude(DAM);
        if every > 0.0 {
            return Some(ChipBreaking { every, by: Interruption::Dwell(given.or_zero(DT).abs()) });
        }
        if given.or_zero(DT) != 0.0 {
            self.unused(DT, "without `DAM`, the way after which the chip is broken");
        }
        None
    }

    /// CYCLE952.
    pub(super) fn contour_removal(&self, contours: &[CalledContour]) -> Made<Acts> {
        let (blank, part) = match contours {
            [part] => (None, part),
            [blank, part] => (Some(elements(&blank.made)), part),
            _ => return Ok(Acts::new()),
        };
        self.removal_digits()?;
        let given = self.given;
        let (operation, side) = self.way_952()?;
        self.no_residual(blank.is_some())?;
        self.digits_952()?;
        let relief = match given.digit(VARI, 6) {
            2 => Relief::Left,
            _ => Relief::Cut,
        };
        let (contour, _) = side.in_order(&elements(&part.made));
        let most = self.infeed(D, operation)?;
        let keys = self.settings.cycles.layers.clone();
        let nose = self.nose_of_edge()?;
        // Alone, finishing has the feed of roughing.
        let feeds = self.removal_feeds(operation, if operation == Operation::Finish { [F, F] } else { [F, FS] })?;
        let blank = self.blank_952(&contour, side, blank)?;
        let (cut, depth) = self.outermost(&contour, side, &blank);
        let clearance = Some(self.given.magnitude(SC)).filter(|way| *way > 0.0).unwrap_or(keys.blank_offset);
        let out = match self.given.length_if(RP).filter(|plane| *plane != 0.0) {
            Some(plane) if side.into.is_radial() && (plane / 2.0 - depth) * side.out() >= 0.0 => plane / 2.0,
            _ => depth + side.out() * clearance,
        };
        let every = self.given.magnitude(DI);
        let mut layers = Layers {
            contour,
            into: side.into,
            along: side.along,
            nose,
            blank,
            allowance: self.allowance_952(),
            most,
            segmentation: if keys.cuts_at_edges { Segmentation::Edges } else { Segmentation::Uniform },
            trace: Trace::Level,
            chips: (every > 0.0).then_some(ChipBreaking { every, by: Interruption::Retract(INTERRUPTION) }),
            relief,
            limits: self.limits_952(side)?,
            operation,
            finish_backwards: false,
            clearance: Clearance { lift: keys.release, entry: keys.blank_offset },
            feeds,
            home: side.point(cut - side.along * keys.blank_offset, out),
        };
        self.plunge_feed(&mut layers, FR)?;
        self.send_with_u1(layers, side)
    }

    /// VARI of CYCLE952: what is done, and from where.
    fn way_952(&self) -> Made<(Operation, Side)> {
        let given = self.given;
        let help = "units 1 along Z, 2 along X; tens 1 rough, 2 finish, 3 both; hundreds 1 X-, 2 X+, 3 Z-, 4 Z+; thousands 1 outside, \
            2 inside, 3 front, 4 rear";
        let vari = given.or_zero(VARI);
        if !(1.0..1e7).contains(&vari) || vari.fract() != 0.0 {
            return self.refuse_argument(VARI, codes::S9015::this_process_vari_has_7_digits());
        }
        if given.digit(VARI, 0) == 3 {
            return self.refuse_argument(VARI, codes::S9015::cutting_parallel_to_contour());
        }
        let Some(operation) = self.operation(given.digit(VARI, 1)) else { return self.kind_fault(VARI, help) };
        let side = match (given.digit(VARI, 0), given.digit(VARI, 2), given.digit(VARI, 3)) {
            (1, way @ (3 | 4), 1) => Side { into: Towards::MinusX, along: if way == 3 { -1.0 } else { 1.0 } },
            (1, way @ (3 | 4), 2) => Side { into: Towards::PlusX, along: if way == 3 { -1.0 } else { 1.0 } },
            (2, way @ (1 | 2), 3) => Side { into: Towards::MinusZ, along: if way == 1 { -1.0 } else { 1.0 } },
            (2, way @ (1 | 2), 4) => Side { into: Towards::PlusZ, along: if way == 1 { -1.0 } else { 1.0 } },
            _ => return self.kind_fault(VARI, help),
        };
        Ok((operation, side))
    }

    /// `_U1` moves the contour away from the material, below 0 into it, along X as a radius and along Z. Roughing leaves
    /// what is above 0 beside its allowances, and nothing less for what is below.
    fn send_with_u1(&self, layers: Layers, side: Side) -> Made<Acts> {
        let given = self.given;
        let by = if given.digit(AMODE, 3) == 1 { self.given.length(U1) } else { 0.0 };
        if by == 0.0 {
            return self.send_layers(layers);
        }
        if !layers.reliefs().is_empty() || layers.leans_over() {
            return self.refuse_argument(U1, codes::S9015::further_allowance_u1_on_contour_that_falls());
        }
        self.say_of(U1, codes::P8106::u1_moves_contour_by_its_amount_along());
        let way = side.point(-side.along * by, side.out() * by) - Point2::origin();
        let moved = |layers: &Layers, operation| Layers {
            contour: layers.contour.iter().map(|element| shifted(element, way)).collect(),
            // The blank lies on the contour as it was.
            blank: match &layers.blank {
                Blank::On(on) => Blank::On(Vec2::new((on.x - by).max(0.0), (on.y - by).max(0.0))),
                other => other.clone(),
            },
            operation,
            ..layers.clone()
        };
        let rough = match (by > 0.0, layers.operation) {
            (true, _) | (false, Operation::Finish) => {
                let made = moved(&layers, layers.operation);
                return self.send_layers(made);
            }
            (false, _) => Layers { operation: Operation::Rough, ..layers.clone() },
        };
        let mut acts = self.send_layers(rough)?;
        if layers.operation == Operation::RoughAndFinish {
            acts.extend(self.send_layers(moved(&layers, Operation::Finish))?);
        }
        Ok(acts)
    }

    /// Residual material is read from files of the control.
    fn no_residual(&self, blank: bool) -> Made {
        for key in [CON, CONR] {
            if !blank && self.given.text(key).is_some() {
                return self.refuse_argument(key, codes::S9015::residual_material());
            }
        }
        Ok(())
    }

    fn digits_952(&self) -> Made {
        let given = self.given;
        if given.digit(DMODE, 4) == 1 && !self.st.is(GCode::G94) {
            return self.refuse_argument(DMODE, codes::P2090::ten_thousands_of_dmode_count_feeds());
        }
        if given.digit(VARI, 4) > 1 || given.digit(VARI, 5) != 1 {
            return self.kind_fault(
                VARI,
                "ten thousands 0 `_UX` and `_UZ`, 1 `_U`; hundred thousands 1: cuts follow the contour",
            );
        }
        if given.digit(VARI, 6) > 2 {
            return self.kind_fault(VARI, "millions 1 cuts reliefs, 2 leaves them");
        }
        self.own_way(codes::P8101::digits_of_vari_are_read_from_stored());
        if given.digit(VARI, 6) == 0 {
            self.say_of(VARI, codes::P8106::of_0_in_millions_of_vari_is_taken());
        }
        let limited = |place: u32| given.digit(GMODE, 3) == 1 && given.digit(GMODE, place) == 1;
        for (place, limit, name) in [(4, 6, "`_XB`, ten thousands"), (5, 7, "`_ZB`, hundred thousands")] {
            if given.digit(AMODE, place) == 1 && limited(limit) {
                self.own_way(codes::P8101::of_amode_1(&name));
            }
        }
        Ok(())
    }

    fn allowance_952(&self) -> Allowance {
        if self.given.digit(VARI, 4) == 1 {
            return Allowance { axes: Vec2::zeros(), around: self.given.magnitude(U) };
        }
        Allowance { axes: Vec2::new(self.given.magnitude(UZ), self.given.magnitude(UX)), around: 0.0 }
    }

    fn blank_952(&self, contour: &[Element], side: Side, blank: Option<Vec<Element>>) -> Made<Blank> {
        let given = self.given;
        let (x, z) = (self.given.length(XD), self.given.length(ZD));
        let (x_from_contour, z_from_contour) = (given.digit(AMODE, 1) == 1, given.digit(AMODE, 2) == 1);
        match (given.or_zero(BL) as i32, blank) {
            (_, Some(outline)) => Ok(Blank::Outline(outline)),
            (3, None) => self.refuse_argument(BL, codes::P2090::contour_of_blank_is_missing()),
            (2, None) => Ok(Blank::On(Vec2::new(z.abs(), x.abs()))),
            _ => {
                let (mut near, far) = Extent::of(contour).corners(side);
                let front = if side.into.is_radial() { -side.along } else { side.out() };
                let outside = if side.into.is_radial() { side.out() } else { -side.along };
                near.x = if z_from_contour { near.x + front * z.abs() } else { z };
                near.y = if x_from_contour { near.y + outside * x.abs() } else { x / 2.0 };
                Ok(Blank::Outline(rectangle(near, far)))
            }
        }
    }

    /// Coordinates of the corner of the blank in front of the cuts, and out of the material.
    fn outermost(&self, contour: &[Element], side: Side, blank: &Blank) -> (f64, f64) {
        let grown = |by: Vec2| {
            let (near, _) = Extent::of(contour).corners(side);
            let (cut, depth) = side.place(near);
            let (along, up) = if side.into.is_radial() { (by.x, by.y) } else { (by.y, by.x) };
            (cut - side.along * along, depth + side.out() * up)
        };
        match blank {
            Blank::Outline(list) => side.place(Extent::of(list).corners(side).0),
            Blank::On(by) => grown(*by),
            Blank::Corner(_) => grown(Vec2::zeros()),
        }
    }

    fn limits_952(&self, side: Side) -> Made<Limits> {
        let given = self.given;
        if given.digit(GMODE, 3) != 1 {
            return Ok(Limits::default());
        }
        // XA is the smaller diameter and ZA lies in front: alone, on other sides, it is open which of both borders it is.
        let usual = side.into == Towards::MinusX && side.along < 0.0;
        for (a, b, names) in [(4, 6, "XA and XB"), (5, 7, "ZA and ZB")] {
            if !usual && given.digit(GMODE, a) != given.digit(GMODE, b) {
                return self.refuse_argument(GMODE, codes::S9015::one_of_limits_without_other_one(&names));
            }
        }
        self.own_way(codes::P8101::what_stands_outside_of_limits_is_taken());
        let given = |key: Name, place: u32| (given.digit(GMODE, place) == 1).then(|| self.given.length(key));
        let radius = |v: Option<f64>| v.map(|v| v / 2.0);
        Ok(Limits { z: [given(ZA, 5), given(ZB, 7)], x: [radius(given(XA, 4)), radius(given(XB, 6))] })
    }
}
