//! APPR and DEP: LT, CT and LCT, onto a contour that the target compensates.
//!
//! Source: K 2.10 (docs/sources.md). Lengths and radii count on the path of the tool centre, so the printed contour has
//! the radius R ± r. An approach is sent when the first contour element is known: its direction decides where the
//! approach begins. The last compensated block leads to the end of the contour, the first one from PH.

use crate::diag::{Diagnostic, codes};
use crate::geo::{self, Point2, SAME_DIRECTION, SAME_POINT, Vec2, distance, left, length};
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::{Axis, Compensation, Generation};
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Site;
use crate::text::Span;

use super::last_move::LastMove;
use super::words::{Admits, Comp, FeedWord, Words};
use super::{Outcome, Reported, Run};

/// Functions and comments that may stand between an approach and the first element of its contour.
pub(super) const MOST_HELD: usize = 256;
/// How far a computed arc end may lie beside its circle, in mm.
const CLOSE: f64 = 1e-6;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    /// LT: straight, by this length.
    Line { length: f64 },
    /// CT: arc of this radius (negative: from the other side) over this angle in degrees.
    Arc { radius: f64, angle: f64 },
    /// LCT: arc of this radius with a tangential line.
    LineArc { radius: f64 },
}

/// An approach whose contour is not known yet.
#[derive(Debug)]
pub(super) struct Approach {
    shape: Shape,
    name: String,
    here: Site,
    span: Span,
    from: Point2,
    to: Point2,
    /// Depth, reached at PH before the way to the contour.
    depth: Option<f64>,
    side: Side,
    /// Tool radius in the programmed frame.
    radius: f64,
    /// Feed to PH; `None` for rapid.
    lead: Option<Feed>,
    feed: Feed,
    /// What came since: it belongs behind the approach.
    pub held: Vec<(Function, Origin)>,
}

impl Run<'_> {
    pub(super) fn approach_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let (name, span) = self.block_name(block, text, 2);
        let result = self.read_approach(&name, span, block, text);
        if result.is_err() {
            self.approach = None;
            self.st.compensation.end();
            self.st.compensation.lose();
            self.lose_all();
        }
        result
    }

    fn read_approach(&mut self, name: &str, span: Span, block: &Block, text: &[u8]) -> Outcome {
        let upper = name.to_ascii_uppercase();
        let (function, kind) = upper.split_once(' ').unwrap_or((&upper, ""));
        if !matches!(kind, "LT" | "CT" | "LCT") {
            return self.fail(codes::K9003, span, format!("{name} is not supported yet"));
        }
        let departs = function == "DEP";
        let (rest, len, angle) = self.named_lengths(block, text, &upper)?;
        let admits = if departs && kind != "LCT" {
            Admits::FEED.and(Admits::RADIUS).and(Admits::M)
        } else {
            Admits::PATH.and(Admits::RADIUS)
        };
        let w = self.gather(&rest, &upper, admits)?;
        self.check_m(&w)?;
        self.forbid_m(&w, &upper, &[6, 89, 91, 99, 140])?;
        if !departs {
            self.forbid_m(&w, &upper, &[2, 30])?;
        }
        if w.feed == FeedWord::Max {
            return self.fail_help(
                codes::K9003,
                w.feed_span,
                format!("{name} at FMAX is not supported"),
                "program a feed",
            );
        }
        let shape = self.shape(kind, len, angle, w.radius, &upper)?;
        self.m_at_start(&w, true)?;
        if departs {
            self.depart(&upper, shape, &w)?;
        } else {
            self.approach_later(name, span, shape, &w)?;
        }
        self.m_at_end(&w)
    }

    /// Takes LEN and CCA out of the words of the block.
    fn named_lengths(&mut self, block: &Block, text: &[u8], name: &str) -> Outcome<(Block, Option<f64>, Option<f64>)> {
        let mm = self.level().frame.unit.mm();
        let (mut len, mut angle) = (None, None);
        let mut rest = block.clone();
        rest.words.clear();
        let mut words = block.words.iter();
        while let Some(&word) = words.next() {
            if word.addr != Addr::Name {
                rest.words.push(word);
                continue;
            }
            let value = match words.next() {
                Some(value @ Word { addr: Addr::Value, .. }) => self.number(value.value, value.span)?,
                _ => return self.not_admitted(word, name),
            };
            let slot = match word.span.of(text).to_ascii_uppercase().as_slice() {
                b"LEN" => &mut len,
                b"CCA" => &mut angle,
                _ => return self.not_admitted(word, name),
            };
            if slot.replace(value).is_some() {
                return self.twice(word, block);
            }
        }
        Ok((rest, len.map(|len| len * mm), angle))
    }

    fn shape(
        &mut self,
        kind: &str,
        len: Option<f64>,
        angle: Option<f64>,
        radius: Option<f64>,
        name: &str,
    ) -> Outcome<Shape> {
        let span = self.block_span();
        let shape = match (kind, len, angle, radius) {
            ("LT", Some(length), None, None) if length > 0.0 => Shape::Line { length },
            ("CT", None, Some(angle), Some(radius)) if angle > 0.0 && angle <= 360.0 && radius != 0.0 => {
                Shape::Arc { radius, angle }
            }
            ("LCT", None, None, Some(radius)) if radius > 0.0 => Shape::LineArc { radius },
            _ => {
                let form = match kind {
                    "LT" => "LEN above zero: `LEN15`",
                    "CT" => "CCA up to 360 degrees and R: `CCA90 R+10`",
                    _ => "R above zero: `R8`",
                };
                return self.fail_help(
                    codes::K1006,
                    span,
                    format!("{name} takes its size from other words"),
                    format!("write {form}"),
                );
            }
        };
        Ok(shape)
    }

    /// The radius of the tool in the programmed frame, and what compensation needs besides.
    fn approach_radius(&mut self, span: Span) -> Outcome<f64> {
        if self.job.settings.output.compensation == Compensation::Resolve {
            return self.fail_help(
                codes::K9007,
                span,
                "radius compensation cannot be computed yet",
                "set `[output] compensation = \"control\"` to print G41/G42",
            );
        }
        self.check_cutter(span)?;
        let radius = self.tool_radius(span)?;
        let scale = self.st.ctx.frame.uniform_scale();
        if scale.is_none_or(|scale| (scale - 1.0).abs() > SAME_DIRECTION) {
            return self.fail_help(
                codes::K9003,
                span,
                "an approach or departure under scaling is not supported",
                "reset the scaling in front of the contour",
            );
        }
        Ok(radius)
    }

    fn approach_later(&mut self, name: &str, span: Span, shape: Shape, w: &Words) -> Outcome {
        let plane = self.st.plane();
        let side = match w.comp {
            Some(Comp::Side(side @ (Side::Left | Side::Right))) if !self.st.compensation.is_on() => side,
            Some(Comp::Side(Side::Left | Side::Right)) => {
                return self.fail(codes::K9003, span, format!("{name} while RL or RR is active is not supported"));
            }
            _ => {
                return self.fail_help(
                    codes::K9003,
                    span,
                    format!("{name} with R0 is not supported: controls differ in what it does"),
                    "write RL or RR, or program the approach as L and C blocks",
                );
            }
        };
        let radius = self.approach_radius(w.comp_span)?;
        let (first, second, third) = plane.axes();
        let third = Axis::ALL[third];
        if !w.axes.known().without(plane_axes(plane)).without(crate::machine::AxisSet::of(third)).is_empty() {
            return self.fail(
                codes::K1005,
                w.axes_span,
                format!("{name} moves the axes of the plane and the tool axis"),
            );
        }
        let from = self.start_in(plane, name)?;
        // LT and CT go to PH as the block before went, LCT at the feed of its own block.
        let before = if self.st.feed.last_rapid { None } else { self.st.feed.word() };
        let own = matches!(shape, Shape::LineArc { .. });
        if before.is_none() && !self.st.feed.last_rapid && !own {
            return self.feed_missing();
        }
        self.set_feed(w)?;
        let Some(feed) = self.st.feed.word() else { return self.feed_missing() };
        let lead = if own { Some(feed) } else { before };
        let end = self.absolute(w)?;
        let coordinate = |axis: usize, old: f64| end.get(Axis::ALL[axis]).unwrap_or(old);
        let to = Point2::new(coordinate(first, from.x), coordinate(second, from.y));
        let mut after = Pos::UNKNOWN;
        after.set_in_plane(plane, to);
        if let Some(depth) = end.get(third) {
            after.set(third, depth);
        }
        self.approach = Some(Box::new(Approach {
            shape,
            name: name.to_owned(),
            here: self.here,
            span,
            from,
            to,
            depth: end.get(third),
            side,
            radius,
            lead,
            feed,
            held: Vec::new(),
        }));
        self.st.compensation.select(side);
        self.st.compensation.found();
        self.st.position.move_to(&after);
        self.st.polar.forget_last();
        self.st.last = None;
        Ok(())
    }

    /// The first element of the contour is about to be sent: now the approach to it is known.
    #[cold]
    pub(super) fn send_approach(&mut self, end: &Pos, path: &Path) {
        let Some(approach) = self.approach.take() else { return };
        let plane = self.st.plane();
        let (first, second, _) = plane.axes();
        let coordinate = |axis: usize, old: f64| end.get(Axis::ALL[axis]).unwrap_or(old);
        let to = Point2::new(coordinate(first, approach.to.x), coordinate(second, approach.to.y));
        let element = LastMove::new(approach.to, to, *path);
        let here = std::mem::replace(&mut self.here, approach.here);
        let made = match element.direction(true) {
            Some(heading) => self.make_approach(&approach, heading),
            None => self.fail_help(
                codes::K9003,
                approach.span,
                format!("{} leads onto a block whose direction is not known here", approach.name),
                "let a straight line or an arc of the working plane with centre or radius follow",
            ),
        };
        if made.is_err() {
            self.lost();
        }
        self.here = here;
        for (function, origin) in &approach.held {
            self.core.out.function(function, &self.st.ctx, origin);
        }
    }

    fn make_approach(&mut self, a: &Approach, heading: Vec2) -> Outcome {
        let beside = if a.side == Side::Left { left(heading) } else { -left(heading) };
        let plane = self.st.plane();
        let third = Axis::ALL[plane.axes().2];
        let (start, arc) = match a.shape {
            Shape::Line { length } => (a.to - heading * length, None),
            Shape::Arc { radius, angle } => {
                let on = self.circle_beside(a.to, beside, radius, a.radius, a.side, &a.name)?;
                let turn = if on.ccw { -angle } else { angle };
                (geo::angle::rotated(a.to, on.center, geo::Deg(turn)), Some(on))
            }
            Shape::LineArc { radius } => {
                let on = self.circle_beside(a.to, beside, radius, a.radius, a.side, &a.name)?;
                let Some(out) = touching(a.from, on.center, radius, on.ccw) else { return self.inside(a) };
                (on.center + out * on.radius, Some(on))
            }
        };
        self.plane_move(start, a.lead, a.side);
        // Newer controls go to the depth together with the plane; the printed path stages it as the older ones do.
        if let Some(depth) = a.depth {
            if self.job.settings.control.klartext >= Generation::Tnc7 {
                return self.fail_help(
                    codes::K9003,
                    a.span,
                    format!("{} with the tool axis is not supported for this control", a.name),
                    "write the depth into a block in front of the approach",
                );
            }
            let mut end = Pos::UNKNOWN;
            end.set(third, depth);
            self.raw_move(end, Path::Line(a.feed), a.side);
        }
        match arc {
            None => self.plane_move(a.to, Some(a.feed), a.side),
            Some(on) => self.arc_move(a.to, &on, a.feed, a.side)?,
        }
        Ok(())
    }

    fn inside<T>(&self, a: &Approach) -> Outcome<T> {
        self.fail_help(
            codes::K2605,
            a.span,
            format!("the start of {} lies inside its circle", a.name),
            "start further away, or make R smaller",
        )
    }

    /// The circle that touches the contour in `at`, with its printed radius.
    fn circle_beside(
        &mut self,
        at: Point2,
        beside: Vec2,
        radius: f64,
        tool: f64,
        side: Side,
        name: &str,
    ) -> Outcome<Circle> {
        // On the side of the tool the contour lies outside the path of its centre, on the other side inside.
        let printed = radius + tool;
        if radius < 0.0 && printed >= 0.0 {
            return self.fail_help(
                codes::K2605,
                self.block_span(),
                format!("the radius of {name} is not larger than the tool, and its arc bends around the contour"),
                "make R larger than the radius of the tool",
            );
        }
        let ccw = (side == Side::Left) == (radius > 0.0);
        Ok(Circle { center: at + beside * printed, radius: printed.abs(), ccw })
    }

    fn depart(&mut self, name: &str, shape: Shape, w: &Words) -> Outcome {
        let span = self.block_span();
        let side = self.st.compensation.side();
        let plane = self.st.plane();
        let at = self.start_in(plane, name)?;
        // Where RL or RR was refused, that was said.
        if side == Side::None && self.st.compensation.take_lost() {
            return Err(Reported);
        }
        if self.approach.is_some() || side == Side::None || w.comp.is_some_and(|comp| comp != Comp::Side(Side::None)) {
            return self.fail_help(
                codes::K9003,
                span,
                format!("{name} is supported behind a contour with RL or RR"),
                "program the departure as L and C blocks",
            );
        }
        let radius = self.approach_radius(span)?;
        let Some(heading) =
            self.st.last.filter(|last| distance(last.to, at) <= SAME_POINT).and_then(|last| last.direction(false))
        else {
            return self.fail_help(
                codes::K9003,
                span,
                format!("{name} follows a block whose direction is not known here"),
                "let a straight line or an arc of the working plane with centre or radius stand in front",
            );
        };
        self.set_feed(w)?;
        let Some(feed) = self.st.feed.word() else { return self.feed_missing() };
        let beside = if side == Side::Left { left(heading) } else { -left(heading) };
        let edge = at + beside * radius;
        let third = Axis::ALL[plane.axes().2];
        let end = match shape {
            Shape::Line { length } => edge + heading * length,
            Shape::Arc { radius: r, angle } => {
                let on = self.circle_beside(at, beside, r, radius, side, name)?;
                let turn = geo::Deg(if on.ccw { angle } else { -angle });
                self.arc_move(geo::angle::rotated(at, on.center, turn), &on, feed, side)?;
                geo::angle::rotated(edge, on.center, turn)
            }
            Shape::LineArc { radius: r } => {
                let on = self.circle_beside(at, beside, r, radius, side, name)?;
                let (first, second, _) = plane.axes();
                let words = self.absolute(w)?;
                let coordinate = |axis: usize, old: f64| words.get(Axis::ALL[axis]).unwrap_or(old);
                let end = Point2::new(coordinate(first, at.x), coordinate(second, at.y));
                // Backwards it is an approach.
                let Some(out) = touching(end, on.center, r, !on.ccw) else {
                    return self.fail_help(
                        codes::K2605,
                        span,
                        format!("the end of {name} lies inside its circle"),
                        "end further away, or make R smaller",
                    );
                };
                self.arc_move(on.center + out * on.radius, &on, feed, side)?;
                end
            }
        };
        self.st.compensation.end();
        self.plane_move(end, Some(feed), Side::None);
        let mut after = Pos::UNKNOWN;
        after.set_in_plane(plane, end);
        if matches!(shape, Shape::LineArc { .. })
            && let Some(depth) = w.axes.get(third)
        {
            let depth =
                if w.incremental.contains(third) { self.absolute(w)?.get(third).unwrap_or(depth) } else { depth };
            let mut up = Pos::UNKNOWN;
            up.set(third, depth);
            self.raw_move(up, Path::Line(feed), Side::None);
            after.set(third, depth);
        }
        self.st.position.move_to(&after);
        self.st.polar.forget_last();
        self.st.last = None;
        self.st.feed.last_rapid = false;
        Ok(())
    }

    fn plane_move(&mut self, to: Point2, feed: Option<Feed>, side: Side) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(self.st.plane(), to);
        self.raw_move(end, Path::straight(feed), side);
    }

    fn arc_move(&mut self, to: Point2, on: &Circle, feed: Feed, side: Side) -> Outcome {
        self.check_edge_feed(side)?;
        let plane = self.st.plane();
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(plane, to);
        let shape = ArcShape::Center { center: on.center, ccw: on.ccw, tol: CLOSE };
        self.raw_move(end, Path::Arc(Arc { plane, shape, turns: 0 }, feed), side);
        Ok(())
    }

    fn raw_move(&mut self, end: Pos, path: Path, side: Side) {
        self.movement(&Move { end, path, side, coords: Coords::Frame });
        self.st.moved = true;
    }

    /// Refuses whatever may not stand between an approach and its contour.
    pub(super) fn forbid_open_approach(&mut self) -> Outcome {
        let Some(approach) = self.approach.take() else { return Ok(()) };
        let loc = approach.here.loc(&self.job, approach.span);
        let found = Diagnostic::new(codes::K9003, loc, format!("no contour element follows {}", approach.name))
            .help("let a path block follow directly");
        self.job.diags.push(found.called(approach.here.origin.call));
        self.lose_all();
        Err(Reported)
    }
}

/// The circle of an approach or departure as it is printed.
#[derive(Debug, Clone, Copy)]
struct Circle {
    center: Point2,
    radius: f64,
    ccw: bool,
}

/// Direction from the centre to the point where the line from `from` touches the circle, which is travelled from
/// there in the sense of `ccw`. `None` inside.
fn touching(from: Point2, center: Point2, radius: f64, ccw: bool) -> Option<Vec2> {
    let out = from - center;
    let far = length(out);
    if far < radius {
        return None;
    }
    let angle = libm::acos((radius / far).min(1.0));
    Some(geo::turned(out / far, if ccw { angle } else { -angle }))
}
