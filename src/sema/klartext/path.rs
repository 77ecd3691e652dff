//! Path blocks: L, C, CR, CT, LP, CP, CTP, single-axis blocks, CC, RND, CHF.
//!
//! Source: reference section 2.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Deg, Plane, Point2, SAME_POINT, Vec2, angle, distance};
use crate::ir::contour::{Arc, ArcShape, Coords, Corner, CornerShape, EndPoint, Move, Path, Polar};
use crate::ir::{Feed, Pos, Side};
use crate::machine::{Axis, AxisSet, CcMissing, Compensation, CpSign, PolarMissing, Unit};
use crate::parser::klartext::ast::{Block, PathFn, Stmt};
use crate::text::Span;

use super::mfunc::Args;
use super::state::{LastPolar, PoleState};
use super::words::{Admits, Comp, FeedWord, MWord, Words};
use super::{Outcome, Reported, Run};

/// How far the end of an arc may miss the circle: machine parameter *circleDeviation* at its largest.
const CIRCLE_TOLERANCE: f64 = 0.016;

/// Feed words in an INCH program count tenths of an inch.
const INCH_FEED: f64 = 25.4 / 10.0;

const PATH: Admits = Admits::AXES.and(Admits::COMP).and(Admits::FEED).and(Admits::M).and(Admits::SPEED);

impl Run<'_> {
    pub(super) fn path_block(&mut self, function: PathFn, block: &Block) -> Outcome {
        let admits = match function {
            PathFn::Line => PATH,
            PathFn::Circle => PATH.and(Admits::TURN),
            PathFn::CircleRadius => PATH.and(Admits::TURN).and(Admits::RADIUS),
            PathFn::CircleTangent => PATH,
            PathFn::LinePolar | PathFn::TangentPolar => PATH.and(Admits::POLAR),
            PathFn::CirclePolar => PATH.and(Admits::POLAR).and(Admits::TURN),
        };
        let result = self.gather(block, function.word(), admits).and_then(|w| {
            let result = self.run_path(function, &w);
            self.put_back(w);
            result
        });
        if result.is_err() {
            self.lose_after(function, block);
        }
        result
    }

    /// A path block failed: the axes it would have moved are unknown now.
    #[cold]
    fn lose_after(&mut self, function: PathFn, block: &Block) {
        let mut axes: AxisSet = block
            .words
            .iter()
            .filter_map(|word| match word.addr {
                crate::parser::klartext::ast::Addr::Axis { axis, .. } => Some(axis),
                _ => None,
            })
            .collect();
        if function != PathFn::Line {
            axes = axes.union(AxisSet::MAIN);
        }
        self.st.lose(axes);
        self.lost();
    }

    fn run_path(&mut self, function: PathFn, w: &Words) -> Outcome {
        self.check_m(w)?;
        let machine = w.has_m(91);
        if machine && (function != PathFn::Line || !w.incremental.is_empty()) {
            return self.fail_help(
                codes::K9008,
                w.axes_span,
                "machine coordinates (M91) are supported in L blocks with absolute words",
                "write `L Z+0 R0 FMAX M91`",
            );
        }
        self.switch_side(w, function.is_arc())?;
        // M functions and the feed act before the end point is computed: M94 and M126 change what it means.
        let moves = function != PathFn::Line || !w.axes.known().is_empty();
        if w.m().is_empty() {
            self.set_feed(w)?;
        } else {
            self.m_at_start(w, moves)?;
            if self.ended {
                return Err(Reported);
            }
            self.set_feed(w)?;
        }
        if let Some(speed) = w.speed {
            self.spindle_speed(speed, w.axes_span)?;
        }
        if machine {
            self.machine_move(w)?;
        } else if moves {
            match function {
                PathFn::Line => self.line(w)?,
                PathFn::Circle => self.circle(w)?,
                PathFn::CircleRadius => self.circle_by_radius(w)?,
                PathFn::CircleTangent => self.tangent(w)?,
                PathFn::LinePolar => self.polar_end(w, Path::Line)?,
                PathFn::TangentPolar => {
                    let plane = self.pole("CTP")?.plane;
                    self.polar_end(w, Path::Arc(Arc { plane, shape: ArcShape::Tangent }))?;
                }
                PathFn::CirclePolar => self.polar_arc(w)?,
            }
        }
        if w.m().is_empty() && !self.cycles.modal() {
            return Ok(());
        }
        self.after_motion(w, moves)
    }

    /// M functions at the end of the block, then the cycle call of M99 and M89.
    fn after_motion(&mut self, w: &Words, moves: bool) -> Outcome {
        let once = w.has_m(99);
        let modal = self.cycles.modal() && moves && !once;
        if w.has_m(89) {
            self.cycles.set_modal(true);
        }
        if once {
            self.cycles.set_modal(false);
        }
        let calls = once || modal || w.has_m(89);
        let stops_here = w.m().iter().any(|m| matches!(m.number, 2 | 30));
        if calls && stops_here {
            return self.fail(codes::K1014, w.m()[0].span, "a cycle call and the end of the program in one block");
        }
        self.m_at_end(w)?;
        if calls && !self.ended {
            return self.call_cycle();
        }
        Ok(())
    }

    /// A block that holds M functions or a feed only.
    pub(super) fn functions_block(&mut self, block: &Block) -> Outcome {
        let w = self.gather(block, "", PATH)?;
        self.run_path(PathFn::Line, &w)
    }

    // Feed and compensation.

    fn set_feed(&mut self, w: &Words) -> Outcome {
        let feed = match w.feed {
            FeedWord::None | FeedWord::Max => return Ok(()),
            FeedWord::Value(f) => self.feed_of(f),
            FeedWord::PerRevolution(f) => Feed::PerRevolution(f),
            FeedWord::Auto => match self.st.tool_feed {
                Some(f) => Feed::PerMinute(f),
                None => {
                    return self.fail_help(
                        codes::K2003,
                        w.feed_span,
                        "the last TOOL CALL has no F, so F AUTO has no value",
                        "put F into the TOOL CALL, or set `[control] feed` in partc.toml",
                    );
                }
            },
        };
        if feed.value() <= 0.0 {
            return self.fail(codes::O1001, w.feed_span, format!("the feed is {}", feed.value()));
        }
        self.st.feed = Some(feed);
        Ok(())
    }

    /// A feed word in the unit and mode in force.
    pub(super) fn feed_of(&mut self, value: f64) -> Feed {
        if self.st.per_revolution {
            return Feed::PerRevolution(value);
        }
        Feed::PerMinute(if self.level().unit == Unit::Inch { value * INCH_FEED } else { value })
    }

    /// Feed of a move that cuts; `None` for rapid traverse.
    #[inline]
    fn move_feed(&mut self, w: &Words) -> Outcome<Option<Feed>> {
        if w.feed == FeedWord::Max {
            return Ok(None);
        }
        match self.st.feed {
            Some(feed) => Ok(Some(feed)),
            None => self.feed_missing(),
        }
    }

    #[cold]
    fn feed_missing<T>(&mut self) -> Outcome<T> {
        self.report(
            Diagnostic::new(codes::K2002, self.here.origin.loc, "no feed rate is programmed before this cutting move")
                .help("program F in this block, in an earlier one, or in the TOOL CALL"),
        );
        // One report is enough.
        self.st.feed = Some(Feed::PerMinute(1.0));
        Err(Reported)
    }

    fn switch_side(&mut self, w: &Words, arc: bool) -> Outcome {
        let Some(Comp::Side(side)) = w.comp else { return Ok(()) };
        if side == self.st.side {
            return Ok(());
        }
        if arc {
            return self.fail_help(
                codes::K2601,
                w.comp_span,
                "radius compensation cannot start or end in an arc",
                "program a straight block with RL, RR or R0 before or after the arc",
            );
        }
        if side != Side::None {
            if self.st.side != Side::None {
                return self.fail_help(
                    codes::K2602,
                    w.comp_span,
                    "RL and RR follow each other without R0",
                    "program a straight block with R0 between them",
                );
            }
            if self.job.settings.output.compensation == Compensation::Resolve {
                return self.fail_help(
                    codes::K9007,
                    w.comp_span,
                    "radius compensation cannot be computed yet",
                    "set `[output] compensation = \"control\"` to print G41/G42",
                );
            }
            self.check_cutter(w.comp_span)?;
        }
        self.st.side = side;
        Ok(())
    }

    // Moves.

    /// Sends a move and takes over its end.
    #[inline]
    fn send(&mut self, end: EndPoint, after: &Pos, path: Path, feed: Option<Feed>) {
        self.movement(&Move { end, path, feed, side: self.st.side, coords: Coords::Frame });
        self.st.pos.update(after);
        self.st.lost = self.st.lost.without(after.known());
        self.st.moved = true;
    }

    fn line(&mut self, w: &Words) -> Outcome {
        let end = self.absolute(w)?;
        self.line_to(w, end)
    }

    fn line_to(&mut self, w: &Words, end: Pos) -> Outcome {
        let feed = self.move_feed(w)?;
        let end = self.check_axes(w, end, feed.is_some())?;
        let feed = self.plunge_feed(feed, &end);
        self.st.polar = None;
        let path = if feed.is_some() { Path::Line } else { Path::Rapid };
        self.send(EndPoint::Cartesian(end), &end, path, feed);
        Ok(())
    }

    /// Rotary axes and parallel axes have rules of their own.
    #[inline]
    fn check_axes(&mut self, w: &Words, end: Pos, cuts: bool) -> Outcome<Pos> {
        if end.known().without(AxisSet::MAIN).is_empty() {
            return Ok(end);
        }
        self.rare_axes(w, end, cuts)
    }

    #[cold]
    fn rare_axes(&mut self, w: &Words, mut end: Pos, cuts: bool) -> Outcome<Pos> {
        for axis in end.known().without(AxisSet::MAIN).iter() {
            if !axis.is_rotary() {
                if self.st.transform.scales() || self.st.transform.mirror.contains(axis) {
                    return self.fail(
                        codes::K2506,
                        w.axes_span,
                        format!("{} moves while a scaling or mirror is active", axis.letter()),
                    );
                }
                continue;
            }
            if self.st.rotary_feed && cuts {
                return self.fail_help(
                    codes::K2509,
                    w.axes_span,
                    format!("{} moves at a feed under M116", axis.letter()),
                    "switch M116 off with M117 and program degrees per minute",
                );
            }
            let target = end.get(axis).unwrap_or(0.0);
            end.set(axis, self.rotary_target(axis, target));
        }
        Ok(end)
    }

    /// Where a rotary axis goes in unbroken degrees, so that the output turns the same way.
    fn rotary_target(&mut self, axis: Axis, target: f64) -> f64 {
        let offset = &mut self.st.rotary_offset[axis.index() - Axis::A.index()];
        let Some(from) = self.st.pos.get(axis) else { return target };
        if self.st.short_way {
            // `from` already holds the whole turns.
            let ahead = Deg(target - from).normal().0;
            let step = if ahead > 180.0 { ahead - 360.0 } else { ahead };
            *offset = from + step - target;
            return from + step;
        }
        target + *offset
    }

    /// M94: the display of rotary axes is taken below 360 degrees; the axes do not move.
    pub(super) fn reduce_rotary(&mut self, axes: AxisSet) {
        for axis in [Axis::A, Axis::B, Axis::C] {
            if !axes.is_empty() && !axes.contains(axis) {
                continue;
            }
            if let Some(at) = self.st.pos.get(axis) {
                let offset = &mut self.st.rotary_offset[axis.index() - Axis::A.index()];
                let shown = at - *offset;
                *offset = at - shown % 360.0;
            }
        }
    }

    /// M103: the feed component into the workpiece is limited.
    fn plunge_feed(&self, feed: Option<Feed>, end: &Pos) -> Option<Feed> {
        let (Some(share), Some(feed)) = (self.st.plunge_share, feed) else { return feed };
        let axis = self.st.axis();
        let step = |axis: Axis| match (end.get(axis), self.st.pos.get(axis)) {
            (Some(to), Some(from)) => to - from,
            _ => 0.0,
        };
        let down = step(axis);
        if down >= 0.0 {
            return Some(feed);
        }
        let way = AxisSet::MAIN.iter().fold(0.0, |sum: f64, axis| libm::hypot(sum, step(axis)));
        Some(feed.with_value((feed.value() * share * way / -down).min(feed.value())))
    }

    /// A move in machine coordinates: afterwards the workpiece position of its axes is not known.
    fn machine_move(&mut self, w: &Words) -> Outcome {
        let feed = self.move_feed(w)?;
        let end = w.axes;
        let path = if feed.is_some() { Path::Line } else { Path::Rapid };
        let coords = Coords::Machine;
        self.movement(&Move { end: EndPoint::Cartesian(end), path, feed, side: self.st.side, coords });
        for axis in end.known().iter() {
            self.st.pos.forget(axis);
            self.st.lost.remove(axis);
            if axis.is_rotary() {
                self.st.rotary_offset[axis.index() - Axis::A.index()] = 0.0;
            }
        }
        self.st.polar = None;
        Ok(())
    }

    /// M140: away from the workpiece along the tool axis, before the block moves.
    pub(super) fn retract(&mut self, m: &MWord) -> Outcome {
        let axis = self.st.axis();
        let Args { feed, value, max, .. } = m.args;
        let feed = feed.map(|f| self.feed_of(f));
        let path = if feed.is_some() { Path::Line } else { Path::Rapid };
        let mut end = Pos::UNKNOWN;
        if max {
            let Some(top) = self.job.settings.control.retract_max else {
                return self.fail_help(
                    codes::K2705,
                    m.span,
                    "M140 MB MAX retracts to the end of the travel, which only the machine knows",
                    "set the machine coordinate in partc.toml: `[control] retract_max = -1.0`",
                );
            };
            self.job.diags.push_once(Diagnostic::new(
                codes::K2704,
                self.loc(m.span),
                format!("M140 MB MAX goes to machine coordinate {}{top}", axis.letter()),
            ));
            end.set(axis, top);
            let coords = Coords::Machine;
            self.movement(&Move { end: EndPoint::Cartesian(end), path, feed, side: self.st.side, coords });
            self.st.pos.forget(axis);
            self.st.lost.remove(axis);
            return Ok(());
        }
        let from = self.position_of(axis, m.span, "M140")?;
        end.set(axis, from + value.unwrap_or(0.0));
        self.send(EndPoint::Cartesian(end), &end, path, feed);
        Ok(())
    }

    // Arcs.

    /// The pole in force.
    fn pole(&mut self, function: &str) -> Outcome<PoleState> {
        let Some(pole) = self.st.pole else {
            if self.st.pole_lost {
                return Err(Reported);
            }
            self.report(
                Diagnostic::new(codes::K2101, self.here.origin.loc, format!("{function} needs a circle centre or pole"))
                    .help("program `CC X… Y…` before this block"),
            );
            return Err(Reported);
        };
        if pole.system != self.st.system {
            self.report(
                Diagnostic::new(codes::K2108, self.here.origin.loc, "the coordinate system changed since CC was programmed")
                    .also(pole.set, "CC is programmed here")
                    .help("program CC again after the change"),
            );
        }
        Ok(pole)
    }

    /// Direction of an arc: as written, or that of the last one.
    fn turn(&mut self, w: &Words, function: &str) -> Outcome<bool> {
        let turn = match (w.turn, self.st.turn) {
            (Some(turn), _) => turn,
            (None, Some(turn)) => {
                self.report(
                    Diagnostic::new(codes::K2103, self.here.origin.loc, format!("{function} without DR turns as the arc before"))
                        .help("write DR+ or DR-"),
                );
                turn
            }
            (None, None) => {
                self.report(
                    Diagnostic::new(codes::K2104, self.here.origin.loc, format!("{function} without DR, and no arc before it"))
                        .help("write DR+ for counter-clockwise or DR- for clockwise"),
                );
                return Err(Reported);
            }
        };
        self.st.turn = Some(turn);
        Ok(turn)
    }

    /// Where the tool stands in `plane`.
    fn start_in(&mut self, plane: Plane, what: &str) -> Outcome<Point2> {
        let (first, second, _) = plane.axes();
        let span = self.block_span();
        let x = self.position_of(Axis::ALL[first], span, what)?;
        let y = self.position_of(Axis::ALL[second], span, what)?;
        Ok(Point2::new(x, y))
    }

    /// End point of an arc: axes of the plane that are not written keep their value.
    fn arc_end(&mut self, w: &Words, plane: Plane, start: Point2) -> Outcome<Pos> {
        let mut end = self.absolute(w)?;
        let (first, second, _) = plane.axes();
        for (axis, value) in [(Axis::ALL[first], start.x), (Axis::ALL[second], start.y)] {
            if end.get(axis).is_none() {
                end.set(axis, value);
            }
        }
        let cuts = self.move_feed(w)?.is_some();
        self.check_axes(w, end, cuts)
    }

    /// Feed of an arc. Plain G-code has no arc at rapid traverse: FMAX needs a number.
    fn arc_feed(&mut self, w: &Words) -> Outcome<Feed> {
        if let Some(feed) = self.move_feed(w)? {
            return Ok(feed);
        }
        match self.job.settings.control.rapid_feed {
            Some(feed) => Ok(Feed::PerMinute(feed)),
            None => self.fail_help(
                codes::K9019,
                w.feed_span,
                "an arc at FMAX has no counterpart in plain G-code",
                "program a feed, or set `[control] rapid_feed` in partc.toml",
            ),
        }
    }

    fn send_arc(&mut self, w: &Words, plane: Plane, shape: ArcShape, end: Pos) -> Outcome {
        let feed = self.arc_feed(w)?;
        if self.st.edge_feed && self.st.side != Side::None {
            self.error(codes::K9008, "M109 and M110 change the feed on compensated arcs, which the target computes");
            return Err(Reported);
        }
        let feed = self.plunge_feed(Some(feed), &end);
        self.send(EndPoint::Cartesian(end), &end, Path::Arc(Arc { plane, shape }), feed);
        Ok(())
    }

    fn circle(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("C")?;
        let ccw = self.turn(w, "C")?;
        let start = self.start_in(pole.plane, "C")?;
        let end = self.arc_end(w, pole.plane, start)?;
        self.st.polar = None;
        let shape = ArcShape::Center { center: pole.at, ccw, tol: CIRCLE_TOLERANCE };
        self.send_arc(w, pole.plane, shape, end)
    }

    fn circle_by_radius(&mut self, w: &Words) -> Outcome {
        let Some(radius) = w.radius.filter(|r| *r != 0.0) else {
            return self.fail_help(codes::K1006, self.block_span(), "CR needs a radius that is not zero", "write R+20 or R-20");
        };
        let ccw = self.turn(w, "CR")?;
        let plane = self.st.plane();
        let start = self.start_in(plane, "CR")?;
        let end = self.arc_end(w, plane, start)?;
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return self.fail(codes::K2109, self.block_span(), "CR names no end point in the working plane");
        }
        self.st.polar = None;
        self.send_arc(w, plane, ArcShape::Radius { radius, ccw, tol: CIRCLE_TOLERANCE }, end)
    }

    fn tangent(&mut self, w: &Words) -> Outcome {
        let plane = self.st.plane();
        self.flat(w, plane, "CT")?;
        let start = self.start_in(plane, "CT")?;
        let end = self.arc_end(w, plane, start)?;
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return self.fail(codes::K2109, self.block_span(), "CT names no end point in the working plane");
        }
        self.st.polar = None;
        self.send_arc(w, plane, ArcShape::Tangent, end)
    }

    /// CT and CTP are arcs of the plane: no other axis can move along.
    fn flat(&mut self, w: &Words, plane: Plane, function: &str) -> Outcome {
        if w.axes.known().without(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        self.fail_help(
            codes::K1005,
            w.axes_span,
            format!("{function} is an arc in the plane and moves no other axis"),
            "program the other axis in a block of its own",
        )
    }

    // Polar blocks.

    /// Radius and angle of the start, about the pole: as the last polar block left them, or from the position.
    fn polar_start(&mut self, pole: &PoleState, what: &str) -> Outcome<(f64, Option<Deg>)> {
        if let Some(last) = self.st.polar
            && last.pole == pole.at
            && last.plane == pole.plane
        {
            return Ok((last.radius, Some(last.angle)));
        }
        let start = self.start_in(pole.plane, what)?;
        let v: Vec2 = start - pole.at;
        let radius = distance(start, pole.at);
        Ok((radius, (radius > SAME_POINT).then(|| Deg::of(v))))
    }

    /// A missing polar word: the same as the position, or the last programmed one.
    fn inherited_polar(&mut self, w: &Words, pole: &PoleState, start: (f64, Option<Deg>)) -> (f64, Option<Deg>) {
        let plain = |word: Option<(f64, bool)>| matches!(word, Some((_, false)));
        let complete = plain(w.polar_radius) && plain(w.polar_angle);
        let follows = self.st.polar.is_some_and(|last| last.pole == pole.at && last.plane == pole.plane);
        if complete || follows {
            return start;
        }
        let missing = w.polar_radius.is_none() || w.polar_angle.is_none();
        if !missing {
            return start;
        }
        if self.job.settings.control.polar_missing == PolarMissing::Programmed
            && let Some((radius, angle)) = self.st.programmed_polar
        {
            return (radius, Some(angle));
        }
        self.report(
            Diagnostic::new(codes::K2107, self.here.origin.loc, "the missing polar word is computed from the position")
                .help("write both PR and PA"),
        );
        start
    }

    /// LP and CTP.
    fn polar_end(&mut self, w: &Words, path: Path) -> Outcome {
        let function = if path == Path::Line { "LP" } else { "CTP" };
        let pole = self.pole(function)?;
        if w.polar_radius.is_none() && w.polar_angle.is_none() {
            return self.fail_help(
                codes::K2109,
                self.block_span(),
                format!("{function} has neither PR nor PA"),
                "write the polar radius and angle of the end point",
            );
        }
        let complete = matches!((w.polar_radius, w.polar_angle), (Some((_, false)), Some((_, false))));
        let start = if complete { (0.0, None) } else { self.polar_start(&pole, function)? };
        let (r0, a0) = self.inherited_polar(w, &pole, start);
        let radius = match w.polar_radius {
            Some((r, false)) => r,
            Some((r, true)) => start.0 + r,
            None => r0,
        };
        let angle = match (w.polar_angle, start.1, a0) {
            (Some((a, false)), ..) => Deg(a),
            (Some((a, true)), Some(from), _) => Deg(from.0 + a),
            (None, _, Some(angle)) => angle,
            _ => return self.angle_undefined(),
        };
        self.forbid_plane_axes(w, pole.plane, function)?;
        let feed = if path == Path::Line { self.move_feed(w)? } else { Some(self.arc_feed(w)?) };
        let rest = self.absolute(w)?;
        let rest = self.check_axes(w, rest, feed.is_some())?;
        let mut end = rest;
        end.set_in_plane(pole.plane, angle::polar_point(pole.at, radius, angle));
        if path != Path::Line {
            self.flat(w, pole.plane, function)?;
            self.start_in(pole.plane, function)?;
        }
        let feed = self.plunge_feed(feed, &end);
        let path = if feed.is_none() { Path::Rapid } else { path };
        let polar = Polar { pole: pole.at, plane: pole.plane, radius, angle, rest };
        self.send(EndPoint::Polar(polar), &end, path, feed);
        self.st.polar = Some(LastPolar { radius, angle, pole: pole.at, plane: pole.plane });
        self.st.programmed_polar = Some((radius, angle));
        Ok(())
    }

    fn angle_undefined<T>(&mut self) -> Outcome<T> {
        self.fail_help(
            codes::K2110,
            self.block_span(),
            "the tool stands on the pole, so the angle is not determined",
            "write the angle PA",
        )
    }

    /// CP: arc or helix about the pole.
    fn polar_arc(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("CP")?;
        if let Some((_, incremental)) = w.polar_radius {
            let _ = incremental;
            return self.fail_help(
                codes::K1005,
                self.block_span(),
                "CP takes no PR: its radius is the distance of the tool from the pole",
                "remove PR, or go to the radius with LP first",
            );
        }
        let Some((angle, incremental)) = w.polar_angle else {
            return self.fail(codes::K2109, self.block_span(), "CP needs PA or IPA");
        };
        self.forbid_plane_axes(w, pole.plane, "CP")?;
        let start = self.start_in(pole.plane, "CP")?;
        let (radius, Some(from)) = self.polar_start(&pole, "CP")? else { return self.angle_undefined() };
        let sweep = if incremental {
            self.incremental_sweep(w, angle)?
        } else {
            let ccw = self.turn(w, "CP")?;
            if angle.abs() > 360.0 {
                self.report(Diagnostic::new(
                    codes::K2106,
                    self.here.origin.loc,
                    format!("PA {angle} is reduced to a direction"),
                ));
            }
            absolute_sweep(from, angle, ccw, radius)
        };
        let mut end = self.absolute(w)?;
        end.set_in_plane(pole.plane, angle::rotated(start, pole.at, Deg(sweep)));
        let cuts = self.move_feed(w)?.is_some();
        let end = self.check_axes(w, end, cuts)?;
        let shape = ArcShape::Sweep { center: pole.at, sweep: Deg(sweep) };
        self.send_arc(w, pole.plane, shape, end)?;
        let angle = Deg(from.0 + sweep);
        self.st.polar = Some(LastPolar { radius, angle, pole: pole.at, plane: pole.plane });
        self.st.programmed_polar = Some((radius, angle));
        Ok(())
    }

    /// IPA is the sweep itself; its sign and DR must agree.
    fn incremental_sweep(&mut self, w: &Words, angle: f64) -> Outcome<f64> {
        if angle == 0.0 {
            return self.fail(codes::K2109, self.block_span(), "IPA is zero: the arc has no length");
        }
        let ccw = match w.turn {
            Some(turn) => turn,
            None => self.turn(w, "CP")?,
        };
        self.st.turn = Some(ccw);
        if ccw == (angle > 0.0) {
            return Ok(angle);
        }
        if self.job.settings.control.cp_sign == CpSign::Dr {
            let one_turn = Deg(angle).normal().0;
            return Ok(match (ccw, one_turn == 0.0) {
                (true, true) => 360.0,
                (true, false) => one_turn,
                (false, true) => -360.0,
                (false, false) => one_turn - 360.0,
            });
        }
        self.fail_help(
            codes::K2105,
            self.block_span(),
            format!("IPA {angle} turns one way and DR the other"),
            "give IPA the sign of DR, or set `[control] cp_sign = \"dr\"`",
        )
    }

    /// Axes of the plane have no place beside a polar end.
    fn forbid_plane_axes(&mut self, w: &Words, plane: Plane, function: &str) -> Outcome {
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        self.fail_help(
            codes::K1005,
            w.axes_span,
            format!("{function} takes its end from PR and PA, not from an axis of the plane"),
            "remove the axis word, or use L or C",
        )
    }

    // Pole, corners, single-axis blocks.

    pub(super) fn pole_block(&mut self, block: &Block) -> Outcome {
        let result = self.gather(block, "CC", Admits::AXES).and_then(|w| {
            let result = self.set_pole(&w, block.span);
            self.put_back(w);
            result
        });
        self.st.pole_lost = result.is_err();
        if result.is_err() {
            self.st.pole = None;
        }
        result
    }

    fn set_pole(&mut self, w: &Words, span: Span) -> Outcome {
        let axes = w.axes.known();
        if !axes.without(AxisSet::MAIN).is_empty() || axes.len() > 2 {
            return self.fail_help(codes::K1005, w.axes_span, "CC takes two of X, Y, Z", "write `CC X+20 Y+10`");
        }
        let mut indices = axes.iter().map(Axis::index);
        let plane = match (indices.next(), indices.next()) {
            (Some(a), Some(b)) => Plane::spanned_by(a, b).unwrap_or_default(),
            (Some(a), None) => {
                let plane = self.st.plane();
                let (first, second, _) = plane.axes();
                if a != first && a != second {
                    return self.fail(codes::K1005, w.axes_span, "this axis is not in the working plane: write both axes");
                }
                plane
            }
            _ => self.st.plane(),
        };
        if axes.len() == 1 {
            self.report(
                Diagnostic::new(codes::K2102, self.loc(span), "CC with one coordinate: the other one is taken from the position")
                    .help("write both coordinates"),
            );
        }
        let written = self.absolute(w)?;
        let (first, second, _) = plane.axes();
        let previous = self.st.pole.filter(|pole| pole.plane == plane);
        let keep = axes.len() == 1 && self.job.settings.control.cc_missing == CcMissing::Previous;
        let old = previous.filter(|_| keep).map(|pole| pole.at);
        let mut coordinate = |axis: Axis, old: Option<f64>| match (written.get(axis), old) {
            (Some(value), _) => Ok(value),
            (None, Some(old)) => Ok(old),
            (None, None) => self.position_of(axis, span, "CC"),
        };
        let x = coordinate(Axis::ALL[first], old.map(|p| p.x))?;
        let y = coordinate(Axis::ALL[second], old.map(|p| p.y))?;
        self.st.pole = Some(PoleState { at: Point2::new(x, y), plane, set: self.loc(span), system: self.st.system });
        Ok(())
    }

    pub(super) fn corner_block(&mut self, block: &Block) -> Outcome {
        let rounding = block.stmt == Stmt::Rounding;
        let head = if rounding { "RND" } else { "CHF" };
        let admits = Admits::FEED.and(Admits::M).and(Admits::NUMBER);
        let w = self.gather(block, head, if rounding { admits.and(Admits::RADIUS) } else { admits })?;
        self.check_m(&w)?;
        let mm = self.level().unit.mm();
        let size = w.radius.or(w.number.map(|n| n * mm));
        let Some(size) = size.filter(|size| *size > 0.0) else {
            let what = if rounding { "RND needs a radius above zero" } else { "CHF needs a length above zero" };
            return self.fail(codes::K1006, block.span, what);
        };
        let feed = match w.feed {
            FeedWord::None => match self.st.feed {
                Some(feed) => feed,
                None => return self.feed_missing(),
            },
            FeedWord::Value(f) if f > 0.0 => self.feed_of(f),
            FeedWord::PerRevolution(f) if f > 0.0 => Feed::PerRevolution(f),
            _ => return self.fail(codes::O1001, w.feed_span, "the feed of a corner is a number above zero"),
        };
        let shape =
            if rounding { CornerShape::Rounding { radius: size } } else { CornerShape::Chamfer { side: size } };
        self.m_at_start(&w, true)?;
        self.out.corner(&Corner { shape, feed }, &self.st.ctx, &self.here.origin);
        self.st.polar = None;
        self.m_at_end(&w)
    }

    /// `X+50 R+ F200`: one axis, or several without R+ and R-.
    pub(super) fn paraxial_block(&mut self, block: &Block) -> Outcome {
        let result = self.gather(block, "positioning", PATH.and(Admits::PARAXIAL)).and_then(|w| match w.comp {
            Some(Comp::Paraxial(longer)) => self.lengthened(&w, longer),
            _ => self.run_path(PathFn::Line, &w),
        });
        if result.is_err() {
            self.lose_after(PathFn::Line, block);
        }
        result
    }

    /// R+ makes the way longer by the tool radius, R- shorter.
    fn lengthened(&mut self, w: &Words, longer: bool) -> Outcome {
        let mut axes = w.axes.known().iter();
        let (Some(axis), None, Side::None) = (axes.next(), axes.next(), self.st.side) else {
            return self.fail_help(
                codes::K2604,
                w.comp_span,
                "R+ and R- belong to a block that moves one axis without RL or RR",
                "program the axes in blocks of their own",
            );
        };
        self.check_m(w)?;
        let radius = self.tool_radius(w.comp_span)?;
        let from = self.position_of(axis, w.axes_span, if longer { "R+" } else { "R-" })?;
        let target = self.absolute(w)?.get(axis).unwrap_or(from);
        let sign = if longer { 1.0 } else { -1.0 };
        let way = target - from;
        let mut end = Pos::UNKNOWN;
        end.set(axis, target + sign * radius * if way < 0.0 { -1.0 } else { 1.0 });
        self.m_at_start(w, true)?;
        self.set_feed(w)?;
        self.line_to(w, end)?;
        self.after_motion(w, true)
    }
}

/// Both axes of a plane.
fn plane_axes(plane: Plane) -> AxisSet {
    let (first, second, _) = plane.axes();
    [Axis::ALL[first], Axis::ALL[second]].into_iter().collect()
}

/// Sweep from `from` to the direction `to`, at most one turn; a turn if there is nothing to go.
fn absolute_sweep(from: Deg, to: f64, ccw: bool, radius: f64) -> f64 {
    let ahead = Deg(to - from.0).normal().0;
    let nothing = Deg::from_radians(SAME_POINT / radius.max(SAME_POINT)).0.min(1e-3);
    let ahead = if ahead < nothing || ahead > 360.0 - nothing { 0.0 } else { ahead };
    match (ccw, ahead == 0.0) {
        (true, true) => 360.0,
        (true, false) => ahead,
        (false, true) => -360.0,
        (false, false) => ahead - 360.0,
    }
}
