//! Path blocks: what they have in common, straight lines, single-axis blocks, chamfers and roundings.
//!
//! Source: K 2.1, 2.6, 2.7, 2.13, 2.14 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::Point2;
use crate::ir::contour::{Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Block, PathFn, Stmt};

use super::contour::OwnCorner;
use super::m_table::Args;
use super::state::CornerMade;
use super::words::{Admits, Comp, FeedWord, MWord, Words};
use super::{Outcome, Reported, Run};

/// What a path block does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Motion {
    /// As its function and its words say.
    Programmed(PathFn),
    /// An arc of a free contour to the end that the words hold.
    Solved { center: Point2, ccw: bool },
}

impl Motion {
    fn is_arc(self) -> bool {
        match self {
            Motion::Programmed(function) => function.is_arc(),
            Motion::Solved { .. } => true,
        }
    }
}

impl Run<'_> {
    pub(super) fn path_block(&mut self, function: PathFn, block: &Block) -> Outcome {
        let result = self.gather(block, function.word(), path_words(function)).and_then(|w| {
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
    pub(super) fn lose_after(&mut self, function: PathFn, block: &Block) {
        let mut axes: AxisSet = block
            .words
            .iter()
            .filter_map(|word| match word.addr {
                Addr::Axis { axis, .. } => Some(axis),
                _ => None,
            })
            .collect();
        if function != PathFn::Line {
            axes = axes.union(AxisSet::MAIN);
        }
        self.st.lose(axes);
        self.lost();
    }

    pub(super) fn run_path(&mut self, function: PathFn, w: &Words) -> Outcome {
        self.run_motion(Motion::Programmed(function), w)
    }

    pub(super) fn run_motion(&mut self, motion: Motion, w: &Words) -> Outcome {
        let result = self.run_words(motion, w);
        if self.st.own_corner != OwnCorner::No { result.and(self.end_own_corner(w)) } else { result }
    }

    fn run_words(&mut self, motion: Motion, w: &Words) -> Outcome {
        let is_line = motion == Motion::Programmed(PathFn::Line);
        self.check_m(w)?;
        let machine = w.has_m(91) || w.has_m(92);
        if machine && matches!(w.comp, Some(Comp::Paraxial(_))) {
            return self.core.refuse(w.comp_span, codes::K2604::r_r_need_way_of_axis());
        }
        if machine && (!is_line || !w.incremental.is_empty()) {
            return self.core.refuse(w.axes_span, codes::K9008::machine_coordinates());
        }
        self.switch_side(w, motion.is_arc())?;
        if let Err(reported) = self.shape_corners(w) {
            // The contour lacks this element.
            self.st.end_compensation();
            self.st.contour = None;
            self.st.compensation.lose();
            return Err(reported);
        }
        // M functions and the feed act before the end point is computed: M94 and M126 change what it means.
        let moves = !is_line || !w.axes.known().is_empty();
        if w.m().is_empty() {
            self.set_feed(w)?;
        } else {
            self.m_at_start(w, moves)?;
            if self.core.has_ended() {
                return Err(Reported);
            }
            self.set_feed(w)?;
        }
        if let Some(speed) = w.speed {
            self.core
                .job
                .diags
                .push_once(codes::K1015::s_stands_in_positioning_block().at(self.core.loc(w.speed_span)));
            self.spindle_speed(speed, w.speed_span)?;
        }
        if machine && moves {
            self.machine_move(w)?;
        } else if machine {
            w.any_m(&[91, 92]).into_iter().for_each(|m| self.note_m(m));
        } else if moves {
            self.go(motion, w)?;
        }
        if w.m().is_empty() && !self.cycles.modal() {
            return Ok(());
        }
        self.after_motion(w, moves)
    }

    fn go(&mut self, motion: Motion, w: &Words) -> Outcome {
        match motion {
            Motion::Programmed(PathFn::Line) => match w.comp {
                Some(Comp::Paraxial(longer)) => self.lengthened(w, longer),
                _ => self.line(w),
            },
            Motion::Programmed(PathFn::Circle) => self.circle(w),
            Motion::Programmed(PathFn::CircleRadius) => self.circle_by_radius(w),
            Motion::Programmed(PathFn::CircleTangent) => self.tangent(w),
            Motion::Programmed(PathFn::LinePolar) => self.polar_line(w),
            Motion::Programmed(PathFn::TangentPolar) => self.tangent_polar(w),
            Motion::Programmed(PathFn::CirclePolar) => self.polar_arc(w),
            Motion::Solved { center, ccw } => self.solved_arc(w, center, ccw),
        }
    }

    /// M functions at the end of the block, among them the cycle call of M99 and M89: in the order of the block.
    pub(super) fn after_motion(&mut self, w: &Words, moves: bool) -> Outcome {
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
            return self.core.refuse(w.any_m(&[2, 30]).map_or(w.m()[0].span, |m| m.span), codes::P1005::cycle_call());
        }
        let call = w.m().iter().position(|m| matches!(m.number, 89 | 99));
        let (before, after) = match call {
            _ if !calls => (w.m(), &w.m()[..0]),
            Some(at) => w.m().split_at(at),
            // A block under M89 is complete with its cycle.
            None => w.m().split_at(0),
        };
        self.these_at_end(before)?;
        if calls && !self.core.has_ended() {
            return self.call_cycle_then(if once { "M99" } else { "M89" }, after);
        }
        Ok(())
    }

    /// A block that holds M functions or a feed only.
    pub(super) fn functions_block(&mut self, block: &Block) -> Outcome {
        let w = self.gather(block, "", Admits::PATH)?;
        if self.contour_waits() {
            self.functions_later(w);
            return Ok(());
        }
        self.run_path(PathFn::Line, &w)
    }

    /// Sends a move and takes over its end.
    #[inline]
    pub(super) fn send(&mut self, end: &Pos, path: Path) {
        if self.st.left_by.is_some() {
            self.leave_open_end(end.known(), path.is_rapid() || self.rises(end));
        }
        let mv = Move { end: *end, path, side: self.st.compensation.side(), coords: Coords::Frame };
        if self.approach.is_none() || !self.wait_for_contour(&mv) {
            self.movement(&mv);
        }
        self.note_contour(end, &path);
        if matches!(path, Path::Arc(Arc { shape: ArcShape::Tangent, .. }, _)) {
            self.st.last_entry = self.last_direction();
        }
        self.st.last_path = path;
        self.st.feed.last_rapid = path.is_rapid();
        self.st.position.move_to(end);
        self.st.moved = true;
    }

    pub(super) fn line(&mut self, w: &Words) -> Outcome {
        let end = self.absolute(w)?;
        self.line_to(w, end)
    }

    pub(super) fn line_to(&mut self, w: &Words, end: Pos) -> Outcome {
        let feed = self.move_feed(w)?;
        let end = self.check_axes(w, end, feed.is_some())?;
        let feed = self.rotary_only_feed(feed, &end);
        let feed = self.plunge_feed(w, feed, &end, None);
        self.st.polar.forget_last_of(end.known());
        self.send(&end, Path::straight(feed));
        Ok(())
    }

    /// Rotary axes and parallel axes have rules of their own.
    #[inline]
    pub(super) fn check_axes(&mut self, w: &Words, end: Pos, cuts: bool) -> Outcome<Pos> {
        if end.known().without(AxisSet::MAIN).is_empty() {
            return Ok(end);
        }
        self.rare_axes(w, end, cuts)
    }

    /// A move in machine coordinates: afterwards the workpiece position of its axes is not known.
    pub(super) fn machine_move(&mut self, w: &Words) -> Outcome {
        let feed = self.move_feed(w)?;
        let end = if w.has_m(92) { self.by_builders_datum(w)? } else { w.axes };
        self.no_rotary_move_under_turn(end.known(), w.axes_span)?;
        for axis in end.known().iter().filter(|axis| axis.is_rotary()) {
            self.check_tip(w, axis, None)?;
            self.st.rotary.moves(axis);
        }
        let (path, coords) = (Path::straight(feed), Coords::Machine);
        self.forbid_open_approach()?;
        self.leave_open_end(end.known(), feed.is_none());
        self.movement(&Move { end, path, side: self.st.compensation.side(), coords });
        self.moved_by_machine(&end);
        self.st.feed.last_rapid = feed.is_none();
        Ok(())
    }

    /// M140: away from the workpiece along the tool axis, before the block moves.
    pub(super) fn retract(&mut self, m: &MWord) -> Outcome {
        let axis = self.st.axis();
        let Args { feed, value, max, .. } = m.args;
        if feed.is_some_and(|feed| feed <= 0.0) {
            return self.core.refuse(m.span, codes::O1001::feed_of_m140_is_not_above_zero());
        }
        let feed = feed.map(|f| self.feed_of(f));
        let path = Path::straight(feed);
        let mut end = Pos::UNKNOWN;
        if max {
            let Some(top) = self.core.job.settings.control.retract_max else {
                return self.core.refuse(
                    m.span,
                    codes::K2705::m140_mb_max_retracts_to_end().answer(Answer::key("control", "retract_max")),
                );
            };
            self.core.job.diags.push_once(
                codes::K2704::m140_mb_max_goes_to_machine_coordinate(&axis.letter(), &top).at(self.core.loc(m.span)),
            );
            end.set(axis, top);
            let coords = Coords::Machine;
            self.forbid_open_approach()?;
            self.movement(&Move { end, path, side: self.st.compensation.side(), coords });
            self.moved_by_machine(&end);
            return Ok(());
        }
        let way = value.unwrap_or(0.0);
        if way <= 0.0 {
            return self.core.refuse(m.span, codes::K2707::path_of_m140_is_not_above_zero());
        }
        // The path is a real one: no scaling acts on it, and it leads away from the workpiece.
        let column = self.st.ctx.frame.linear().column(axis.index()).into_owned();
        let factor = column[axis.index()];
        if !(factor > 0.0 && AxisSet::MAIN.iter().all(|other| other == axis || column[other.index()] == 0.0)) {
            return self.core.refuse(m.span, codes::K9008::m140_retracts_along(&axis.letter()));
        }
        let from = match self.st.position.get(axis) {
            Some(from) => from,
            None => self.position_of(axis, m.span, "M140")?,
        };
        end.set(axis, from + way / factor);
        self.send(&end, path);
        Ok(())
    }

    pub(super) fn corner_block(&mut self, block: &Block) -> Outcome {
        let rounding = block.stmt == Stmt::Rounding;
        let head = if rounding { "RND" } else { "CHF" };
        let w = self.gather(block, head, corner_words(rounding))?;
        if self.contour_waits() {
            self.corner_later(rounding, w);
            return Ok(());
        }
        let result = self.make_corner(rounding, &w);
        self.put_back(w);
        result
    }

    pub(super) fn make_corner(&mut self, rounding: bool, w: &Words) -> Outcome {
        let head = if rounding { "RND" } else { "CHF" };
        let mm = self.core.level().frame.unit.mm();
        let size = w.radius.or(w.number.map(|n| n * mm));
        let Some(size) = size.filter(|size| *size > 0.0) else {
            let fault = if rounding { codes::P1004::rnd_needs_radius() } else { codes::P1004::chf_needs_length() };
            return self.core.refuse(self.core.block_span(), fault);
        };
        let feed = match w.feed {
            FeedWord::None => self.feed_in_force()?,
            FeedWord::Value(f) if f > 0.0 => {
                self.large_per_revolution(self.core.loc(w.feed_span), f);
                self.feed_of(f)
            }
            FeedWord::PerRevolution(f) if f > 0.0 => Feed::PerRevolution(f),
            FeedWord::PerTooth(f) if f > 0.0 => self.feed_of_teeth(f, w.feed_span)?,
            FeedWord::Value(f) | FeedWord::PerRevolution(f) | FeedWord::PerTooth(f) => {
                return self.feed_not_positive(w.feed_span, f);
            }
            FeedWord::Max | FeedWord::Auto => {
                let text = self.word_text(w.feed_span);
                return self.core.refuse(w.feed_span, codes::P1003::has_no_place_in_block(&text, &head));
            }
        };
        if rounding {
            self.check_edge_feed(self.st.compensation.side())?;
        }
        let shape = if rounding { CornerShape::Rounding { radius: size } } else { CornerShape::Chamfer { side: size } };
        if let Some(contour) = &mut self.st.contour {
            let begins = !contour.begun && contour.side != Side::None;
            // What stands behind a corner begins at its cut.
            contour.last = None;
            if begins {
                self.round_border(if rounding { "RND" } else { "CHF" }, false)?;
            }
        }
        self.st.corner =
            Some(CornerMade { rounding, side: self.st.compensation.side(), loc: self.core.here.origin.loc });
        self.core.send_corner(
            &Corner {
                shape,
                feed: Some(feed),
                early: false,
                modal: false,
                large: LargeCorner::Refuse,
                at_arc: ArcChamfer::Refuse,
                blocks: Blocks::Unconfirmed,
            },
            &self.st.ctx,
        );
        Ok(())
    }

    /// The element after a chamfer or rounding: the compensation goes on as it was in front of it.
    #[cold]
    pub(super) fn side_at_corner(&mut self, made: &CornerMade, side: Side) {
        if side == made.side {
            return;
        }
        let word = |side| match side {
            Side::None => "R0",
            Side::Left => "RL",
            Side::Right => "RR",
        };
        let change = format!("the compensation changes from {} to {}", word(made.side), word(side));
        let here = self.core.here.origin.loc;
        if !made.rounding {
            self.core.report(codes::K2891::at_this_chamfer(&change).at(made.loc).also(here, Label::InThisBlock));
        } else if side != Side::None {
            self.core.report(
                codes::K2892::at_this_rounding_it_is_made_all(&change).at(made.loc).also(here, Label::InThisBlock),
            );
        } else if self.round_border("RND", true).is_err() {
            // A rounding from a compensated contour into R0 is the departure on an arc.
            self.lose_all();
        }
    }

    /// `X+50 R+ F200`: one axis.
    pub(super) fn paraxial_block(&mut self, block: &Block) -> Outcome {
        let result = self.gather(block, "positioning", Admits::PATH.and(Admits::PARAXIAL)).and_then(|w| {
            let paraxial = matches!(w.comp, Some(Comp::Paraxial(_)));
            if w.axes.known().len() > 1 && !paraxial {
                return self.core.refuse(w.axes_span, codes::P1003::block_without_function_word_moves_one_axis());
            }
            let result = self.run_path(PathFn::Line, &w);
            self.put_back(w);
            result
        });
        if result.is_err() {
            self.lose_after(PathFn::Line, block);
        }
        result
    }

    /// R+ makes the way longer by the tool radius, R- shorter.
    fn lengthened(&mut self, w: &Words, longer: bool) -> Outcome {
        let mut axes = w.axes.known().iter();
        let axis = match (axes.next(), axes.next(), self.st.compensation.side()) {
            (Some(axis), None, Side::None) if axis.is_main() => axis,
            _ => {
                return self.core.refuse(w.comp_span, codes::K2604::r_r_belong_to_block_that_moves());
            }
        };
        let name = if longer { "R+" } else { "R-" };
        let radius = self.tool_radius(w.comp_span)?;
        let from = self.position_of(axis, w.axes_span, name)?;
        let stands = self.st.position.get(axis).unwrap_or(from);
        let target = self.absolute(w)?.get(axis).unwrap_or(from);
        let way = target - from;
        // Where the tool stands beside its nominal position, both have to agree on the direction.
        if way == 0.0 || way * (target - stands) <= 0.0 {
            return self.core.refuse(w.comp_span, codes::K2604::is_there_already(&axis.letter(), &name));
        }
        let sign = if (way < 0.0) == longer { -1.0 } else { 1.0 };
        // The radius is a real one: no scaling acts on it.
        let scale = self.st.ctx.frame.linear().column(axis.index()).norm();
        let mut end = Pos::UNKNOWN;
        end.set(axis, target + sign * radius / scale);
        self.line_to(w, end)?;
        self.st.position.leave_beside(axis, target);
        Ok(())
    }
}

/// The words that a path function takes.
pub(super) fn path_words(function: PathFn) -> Admits {
    match function {
        PathFn::Line | PathFn::CircleTangent => Admits::PATH,
        PathFn::Circle => Admits::PATH.and(Admits::TURN),
        PathFn::CircleRadius => Admits::PATH.and(Admits::TURN).and(Admits::RADIUS),
        PathFn::LinePolar | PathFn::TangentPolar => Admits::PATH.and(Admits::POLAR),
        PathFn::CirclePolar => Admits::PATH.and(Admits::POLAR).and(Admits::TURN),
    }
}

/// The words of RND (true) or CHF: no M function, which would have no place to act at.
pub(super) fn corner_words(rounding: bool) -> Admits {
    let admits = Admits::FEED.and(Admits::NUMBER);
    if rounding { admits.and(Admits::RADIUS) } else { admits }
}
