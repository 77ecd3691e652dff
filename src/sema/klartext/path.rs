//! Path blocks: what they have in common, straight lines, single-axis blocks, chamfers and roundings.
//!
//! Source: K 2.1, 2.6, 2.7, 2.13, 2.14 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::contour::{ArcChamfer, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::lexer::klartext::Value;
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Block, PathFn, Stmt};
use crate::sema::run::Where;

use super::compensation::round_border;
use super::contour::OwnCorner;
use super::known::Known;
use super::state::CornerMade;
use super::tilt_state::{Stand, is_angle_of};
use super::words::{Admits, Comp, FeedWord, Words};
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
    /// A path function, or `X+50 R+ F200`: one axis.
    pub(super) fn path_block(&mut self, function: PathFn, block: &Block) -> Outcome {
        if !self.st.tilt.is_upright() && function == PathFn::Line && self.turns_into_plane(block)? {
            return Ok(());
        }
        let paraxial = block.stmt == Stmt::Paraxial;
        let (head, admits) = match paraxial {
            true => ("positioning", Admits::PATH.and(Admits::PARAXIAL)),
            false => (function.word(), path_words(function)),
        };
        let result = self.gather(block, head, admits).and_then(|w| {
            if paraxial && w.axes.known().len() > 1 && !matches!(w.comp, Some(Comp::Paraxial(_))) {
                return self.core.refuse(w.axes_span, codes::P1003::block_without_function_word_moves_one_axis());
            }
            let result = self.run_motion(Motion::Programmed(function), &w);
            self.words = Some(w);
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
                Addr::Axis { axis, .. } => Some(axis),
                _ => None,
            })
            .collect();
        if function != PathFn::Line {
            axes = axes.union(AxisSet::MAIN);
        }
        self.st.lose(axes);
        self.st.lost(&mut self.core);
    }

    /// `L A+Q120 C+Q122 R0 FMAX`: the rotary axes go where the plane that STAY defined wants them. False for another block.
    fn turns_into_plane(&mut self, block: &Block) -> Outcome<bool> {
        if !self.st.tilt.turns_by_name() {
            return Ok(false);
        }
        let mut axes = AxisSet::EMPTY;
        for word in &block.words {
            match (word.addr, word.value) {
                (Addr::Axis { axis, incremental: false }, Value::Param { negative: false, q })
                    if is_angle_of(axis, q) =>
                {
                    axes.insert(axis);
                }
                (Addr::Axis { .. }, _) => return Ok(false),
                _ => {}
            }
        }
        if axes.is_empty() {
            return Ok(false);
        }
        // The rest of the block acts as it does without its axes.
        let mut rest = block.clone();
        rest.words.retain(|word| !matches!(word.addr, Addr::Axis { .. }));
        let words = self.gather(&rest, "L", Admits::PATH)?;
        self.run_motion(Motion::Programmed(PathFn::Line), &words)?;
        if self.core.has_ended() {
            return Err(Reported);
        }
        self.contours.roughed = Known::Nothing;
        match self.st.tilt.stand {
            Stand::Left(_) => {
                self.turn_back();
                self.leave_plane();
            }
            _ => {
                self.st.tilt.turned = axes;
                self.arrive();
            }
        }
        Ok(true)
    }

    pub(super) fn run_motion(&mut self, motion: Motion, w: &Words) -> Outcome {
        let result = self.run_words(motion, w);
        match self.st.contour.own_corner {
            OwnCorner::No => result,
            _ => {
                let st = &mut self.st;
                result.and(st.contour.end_own_corner(&self.core, &mut st.ctx, st.feed.at, w))
            }
        }
    }

    fn run_words(&mut self, motion: Motion, w: &Words) -> Outcome {
        let is_line = motion == Motion::Programmed(PathFn::Line);
        self.view().check_m(w)?;
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
            self.st.lose_contour();
            return Err(reported);
        }
        // M functions and the feed act before the end point is computed: M94 and M126 change what it means.
        let moves = !is_line || !w.axes.known().is_empty();
        if w.m().is_empty() {
            self.st.set_feed(&self.core, w)?;
        } else {
            self.m_at_start(w, moves)?;
            if self.core.has_ended() {
                return Err(Reported);
            }
            self.st.set_feed(&self.core, w)?;
        }
        if let Some(speed) = w.speed {
            self.core.note(w.speed_span, codes::K1015::s_stands_in_positioning_block());
            let function = self.st.spindle.set_speed(&self.core, speed, w.speed_span)?;
            self.function(function);
        }
        if machine && moves {
            self.machine_move(w)?;
        } else if machine {
            w.any_m(&[91, 92]).into_iter().for_each(|m| self.noted.note(&self.core, m.number, m.span));
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
                _ => {
                    let end = self.view().absolute(w)?;
                    self.line_to(w, end)
                }
            },
            Motion::Programmed(function @ (PathFn::Circle | PathFn::CircleRadius | PathFn::CircleTangent)) => {
                self.arc(w, function)
            }
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
        self.m_at_end(before)?;
        if calls && !self.core.has_ended() {
            return self.call_cycle_then(if once { "M99" } else { "M89" }, after);
        }
        Ok(())
    }

    fn line_to(&mut self, w: &Words, end: Pos) -> Outcome {
        let feed = self.st.feed.of_move(&self.core, w)?;
        let end = self.check_axes(w, end, feed.is_some())?;
        if end.known().is_empty() {
            // It only turned the axes back out of a plane.
            return Ok(());
        }
        let feed = self.st.feed.of_rotary(feed, &end, &self.st.position, self.core.unit());
        let feed = feed.map(|feed| self.view().plunged(w, feed, &end, None));
        self.st.polar.forget_last_of(end.known());
        self.send(&end, Path::straight(feed));
        Ok(())
    }

    /// A move in machine coordinates: afterwards the workpiece position of its axes is not known.
    fn machine_move(&mut self, w: &Words) -> Outcome {
        let feed = self.st.feed.of_move(&self.core, w)?;
        let end = if w.has_m(92) { self.view().by_builders_datum(w)? } else { w.axes };
        self.st.frames.no_rotary_move_under_turn(&self.core, end.known(), w.axes_span)?;
        for axis in end.known().iter().filter(|axis| axis.is_rotary()) {
            if let Err(fault) = self.st.tilt.admits_rotary(axis) {
                return self.core.refuse(w.axes_span, fault);
            }
            self.st.rotary.check_tip(&self.core, &self.st.position, axis, None, w.axes_span)?;
            self.st.rotary.moves(axis);
        }
        let (path, coords) = (Path::straight(feed), Coords::Machine);
        self.forbid_open_approach()?;
        self.st.leave_open_end(&self.core, end.known(), feed.is_none());
        self.movement(&Move { end, path, side: self.st.compensation.side(), coords });
        self.moved_by_machine(&end);
        self.st.feed.last_rapid = feed.is_none();
        Ok(())
    }

    pub(super) fn make_corner(&mut self, rounding: bool, w: &Words) -> Outcome {
        let head = corner_head(rounding);
        let size = w.radius.or(w.number.map(|n| n * self.core.mm()));
        let Some(size) = size.filter(|size| *size > 0.0) else {
            let fault = if rounding { codes::P1004::rnd_needs_radius() } else { codes::P1004::chf_needs_length() };
            return self.core.refuse(Where::Block, fault);
        };
        let feed = match w.feed {
            FeedWord::None => self.st.feed.in_force(&self.core)?,
            FeedWord::Value(f) if f > 0.0 => {
                self.st.feed.warn_of_large(&self.core, w.feed_span, f);
                self.st.feed.counted(f, self.core.unit())
            }
            FeedWord::PerRevolution(f) if f > 0.0 => Feed::PerRevolution(f),
            FeedWord::PerTooth(f) if f > 0.0 => self.st.tool.feed_of_teeth(&self.core, f, w.feed_span)?,
            FeedWord::Value(f) | FeedWord::PerRevolution(f) | FeedWord::PerTooth(f) => {
                return self.core.feed_not_positive(w.feed_span, f);
            }
            FeedWord::Max | FeedWord::Auto => {
                let text = self.core.word_text(w.feed_span);
                return self.core.refuse(w.feed_span, codes::P1003::has_no_place_in_block(&text, &head));
            }
        };
        if rounding {
            self.st.feed.check_edge(&self.core, self.st.compensation.side())?;
        }
        let shape = if rounding { CornerShape::Rounding { radius: size } } else { CornerShape::Chamfer { side: size } };
        if let Some(contour) = &mut self.st.contour.now {
            let begins = !contour.begun && contour.side != Side::None;
            // What stands behind a corner begins at its cut.
            contour.last = None;
            if begins {
                round_border(&self.core, head, false)?;
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
        let radius = self.st.tool.radius(&self.core, w.comp_span)?;
        let from = self.view().position_of(axis, w.axes_span, name)?;
        let stands = self.st.position.get(axis).unwrap_or(from);
        let target = self.view().absolute(w)?.get(axis).unwrap_or(from);
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

pub(super) fn corner_head(rounding: bool) -> &'static str {
    if rounding { "RND" } else { "CHF" }
}

/// The words of RND (true) or CHF: no M function, which would have no place to act at.
pub(super) fn corner_words(rounding: bool) -> Admits {
    let admits = Admits::FEED.and(Admits::NUMBER);
    if rounding { admits.and(Admits::RADIUS) } else { admits }
}
