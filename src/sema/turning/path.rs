//! Path blocks: straight moves, arcs, moves in machine coordinates.
//!
//! Source: T 4 and 5 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::geo::open::{Rules, Solution, Solutions, Start};
use crate::geo::{Plane, Point2, SAME_POINT, Vec2, distance};
use crate::ir::contour::{
    Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path, Thread,
};
use crate::ir::{Feed, Origin, Pos, Side};
use crate::machine::Axis;
use crate::sema::common::hidden::By;
use crate::sema::common::position::Missing;
use crate::sema::run::place::{Lack, Unknown};
use crate::text::Span;

use super::chain::{AGREES, Choice, Coord, Data, Fault, RULES, Solved, by_distance, not_determined};
use super::element_data::{Follows, Transition};
use super::program_parts::Family;
use super::words::Words;
use super::{Outcome, Reported, Run};

/// What is known of the block of an element besides its geometry.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tag {
    feed: Option<Feed>,
    side: Side,
    follows: Follows,
    corner_feed: Option<Feed>,
    origin: Origin,
}

impl Choice for Tag {
    const RULES: Rules = RULES;

    fn choose(&self, start: &Start, _: Option<&Tag>, among: &Solutions) -> Result<Solution, Fault> {
        by_distance(start, self.follows.far, among)
    }
}

impl Run<'_> {
    /// G0 and G1.
    #[inline]
    pub(super) fn straight(&mut self, w: &Words, rapid: bool) -> Outcome {
        let feed = if rapid { None } else { Some(self.cutting_feed()?) };
        self.st.compensation.moves();
        let (data, follows) = self.element_of(w, None)?;
        let open = data.entry.is_some() || data.x == Coord::Open || data.y == Coord::Open;
        if open || !self.chain.is_empty() {
            return self.chained(data, follows, feed, w);
        }
        let transition = follows.transition;
        let mut end = Pos::UNKNOWN;
        self.end_on(Axis::X, data.y, w, &mut end)?;
        self.end_on(Axis::Z, data.x, w, &mut end)?;
        if end.known().is_empty() {
            return self.core.refuse(self.core.block_span(), codes::P1004::block_names_no_end_point());
        }
        let corner = matches!(transition, Transition::Rounding(_) | Transition::Chamfer(_));
        // A corner needs the direction of its first element, so its start.
        let from = if corner { Some(self.stand()?) } else { self.st.at() };
        let (side, coords) = (self.st.compensation.side(), Coords::Frame);
        self.movement(&Move { end, path: Path::straight(feed), side, coords });
        self.st.position.move_to(&end);
        self.st.moved = true;
        let to = self.st.at();
        if let (false, Some(to)) = (rapid, to) {
            self.cuts(to);
        }
        match (from, to) {
            (Some(from), Some(to)) => self.follow(Solved { from, to, arc: None }, transition),
            _ => self.st.last = None,
        }
        if corner {
            let corner_feed = self.corner_feed(w)?;
            let origin = self.core.here.origin;
            self.send_corner(transition, corner_feed, &origin);
        } else if w.has(b'E') {
            return self.stray_e(w);
        }
        Ok(())
    }

    #[inline]
    fn end_on(&mut self, axis: Axis, coord: Coord, w: &Words, end: &mut Pos) -> Outcome {
        match coord {
            Coord::At(v) => end.set(axis, v),
            Coord::By(d) => {
                let from = self.position_of(axis, w.span(axis.letter() as u8, self.core.block_span()))?;
                end.set(axis, from + d);
            }
            Coord::Stay | Coord::Open => {}
        }
        Ok(())
    }

    /// Where the tool stands on an axis.
    pub(super) fn position_of(&self, axis: Axis, span: Span) -> Outcome<f64> {
        match self.st.position.require(axis) {
            Ok(v) => Ok(v),
            Err(Missing::Lost) => Err(Reported),
            Err(Missing::Unknown) => {
                let unknown = Unknown { position: &self.st.position, axis, lack: &|| Lack::Nothing, otherwise: "" };
                self.core.position_unknown(span, unknown, codes::P2001::it_is_not_known_where_tool_stands)
            }
        }
    }

    /// Where the tool stands, as (Z, X).
    pub(super) fn stand(&self) -> Outcome<Point2> {
        let span = self.core.block_span();
        let z = self.position_of(Axis::Z, span)?;
        let x = self.position_of(Axis::X, span)?;
        Ok(Point2::new(z, x))
    }

    /// G2, G3, G12, G13.
    pub(super) fn arc(&mut self, w: &Words, ccw: bool, absolute: bool) -> Outcome {
        if self.st.compensation.is_fresh() {
            return self.core.refuse(self.core.block_span(), codes::T2021::nose_radius_compensation_begins_or_ends());
        }
        let feed = Some(self.cutting_feed()?);
        let (data, follows) = self.element_of(w, Some((ccw, absolute)))?;
        self.chained(data, follows, feed, w)
    }

    /// An element that may need the next one.
    fn chained(&mut self, data: Data, follows: Follows, feed: Option<Feed>, w: &Words) -> Outcome {
        self.stand()?;
        let corner = matches!(follows.transition, Transition::Rounding(_) | Transition::Chamfer(_));
        if w.has(b'E') && !corner {
            return self.stray_e(w);
        }
        let corner_feed = if corner { self.corner_feed(w)? } else { None };
        let tag = Tag { feed, side: self.st.compensation.side(), follows, corner_feed, origin: self.core.here.origin };
        self.chain.push(data, tag);
        self.drain_chain(false)
    }

    fn stray_e(&self, w: &Words) -> Outcome {
        self.core.refuse(w.span(b'E', self.core.block_span()), codes::P1003::e_is_feed_of_chamfer_or_rounding())
    }

    /// Sends the elements that can be completed by now.
    fn drain_chain(&mut self, closed: bool) -> Outcome {
        while !self.chain.is_empty() {
            let at = self.stand()?;
            let dir = self.direction();
            match self.chain.next(&Start { at, dir, goes_on: true }, closed) {
                Ok(Some((solution, tag))) => self.send_solved(solution.solved, &tag),
                Ok(None) => return Ok(()),
                Err((fault, tag)) => {
                    self.chain.clear();
                    self.core.report(fault_of(fault, &tag.origin));
                    self.lose_all();
                    return Err(Reported);
                }
            }
        }
        Ok(())
    }

    /// Something other than a path element follows: what waits has to be complete.
    #[inline]
    pub(super) fn settle_chain(&mut self) -> Outcome {
        if self.chain.is_empty() { Ok(()) } else { self.drain_chain(true) }
    }

    /// The direction in which a tangential element goes on.
    fn direction(&self) -> Option<Vec2> {
        if self.st.cornered { None } else { self.st.last.and_then(|last| last.end_direction()) }
    }

    #[inline]
    fn follow(&mut self, solved: Solved, transition: Transition) {
        if solved.arc.is_some() || distance(solved.from, solved.to) > SAME_POINT {
            self.st.last = Some(solved);
        }
        self.st.cornered = transition != Transition::Open;
    }

    fn send_solved(&mut self, solved: Solved, tag: &Tag) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, solved.to);
        let path = match (solved.arc, tag.feed) {
            (Some((center, ccw)), Some(feed)) => {
                let shape = ArcShape::Center { center, ccw, tol: self.arc_tolerance() };
                Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 }, feed)
            }
            // Arcs always have one.
            (_, feed) => Path::straight(feed),
        };
        let mv = Move { end, path, side: tag.side, coords: Coords::Frame };
        self.core.send_move_of(&mv, &self.st.ctx, &tag.origin);
        if tag.feed.is_some() {
            self.cuts(solved.to);
        }
        self.st.stands(solved.to);
        self.st.moved = true;
        self.follow(solved, tag.follows.transition);
        self.send_corner(tag.follows.transition, tag.corner_feed, &tag.origin);
    }

    fn send_corner(&mut self, transition: Transition, feed: Option<Feed>, origin: &Origin) {
        let shape = match transition {
            Transition::Open | Transition::Sharp => return,
            Transition::Rounding(radius) => CornerShape::Rounding { radius },
            Transition::Chamfer(side) => CornerShape::Chamfer { side },
        };
        self.core.out.corner(
            &Corner {
                shape,
                feed,
                early: false,
                modal: false,
                large: LargeCorner::Refuse,
                at_arc: ArcChamfer::Refuse,
                blocks: Blocks::PassedOver,
            },
            &self.st.ctx,
            origin,
        );
    }

    /// E: feed of a chamfer or rounding on the 4110, its share of the feed on later controls.
    fn corner_feed(&mut self, w: &Words) -> Outcome<Option<Feed>> {
        let feed = self.cutting_feed()?;
        let Some(num) = w.get(b'E') else { return Ok(Some(feed)) };
        if num.value <= 0.0 {
            return self.core.refuse(num.span, codes::T1007::e_has_to_be_above_zero());
        }
        if self.sections.family() == Family::Basic {
            let unit = self.st.mm();
            return Ok(Some(feed.with_value(num.value * unit)));
        }
        if num.value > 1.0 {
            return self.core.refuse(num.span, codes::T1007::e_is_no_share_of_feed(&num.value));
        }
        Ok(Some(feed.with_value(feed.value() * num.value)))
    }

    /// G33: one thread cut, from where the tool stands.
    pub(super) fn single_thread(&mut self, w: &Words) -> Outcome {
        for (letter, what) in [(b'C', "start angle of a thread"), (b'E', "variable pitch")] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                return self.core.refuse(num.span, codes::T9007::target_cannot_cut(&what));
            }
        }
        self.without_effect(w, b"BP", codes::T8017::run_in_of_g33_lies_inside);
        self.without_effect(w, b"IK", codes::T8017::retraction_of_g33_belongs_to_stop);
        let from = self.stand()?;
        let span = self.core.block_span();
        self.spindle_turns(33)?;
        let pitch = self.needed(w, b'F', "the pitch of the thread", span)?;
        let lead = self.above_zero(pitch, "the pitch of the thread")?;
        let (x, z) = (self.coord(w.get(b'X'), Axis::X), self.coord(w.get(b'Z'), Axis::Z));
        let mut end = Pos::UNKNOWN;
        self.end_on(Axis::X, x, w, &mut end)?;
        self.end_on(Axis::Z, z, w, &mut end)?;
        let to = Point2::new(end.get(Axis::Z).unwrap_or(from.x), end.get(Axis::X).unwrap_or(from.y));
        if x == Coord::Open || z == Coord::Open || distance(from, to) <= SAME_POINT {
            return self.core.refuse(span, codes::P1004::thread_needs_end_point());
        }
        // The pitch counts along the axis that moves most, so the target and the control agree on it.
        let way = to - from;
        let along = match self.choice(w, b'H', 0, 3)? {
            0 if way.y.abs() <= way.x.abs() + AGREES => Some(Axis::Z),
            1 if way.x.abs() <= way.y.abs() + AGREES => Some(Axis::X),
            3 => None,
            2 => return self.core.refuse(w.span(b'H', span), codes::T1007::h_is_0_for_z_1()),
            _ => {
                return self.core.refuse(w.span(b'H', span), codes::T1007::thread_leans_more_than_45_degrees_out());
            }
        };
        end.set_in_plane(Plane::Zx, to);
        let (side, coords) = (self.st.compensation.side(), Coords::Frame);
        let path = Path::Thread(Thread { lead, along });
        self.movement(&Move { end, path, side, coords });
        self.st.stands(to);
        self.st.moved = true;
        self.follow(Solved { from, to, arc: None }, Transition::Sharp);
        Ok(())
    }

    /// G701: rapid traverse in machine coordinates.
    pub(super) fn machine_rapid(&mut self, w: &Words) -> Outcome {
        let mut end = Pos::UNKNOWN;
        for axis in [Axis::X, Axis::Z] {
            match self.coord(w.get(axis.letter() as u8), axis) {
                Coord::At(v) => end.set(axis, v),
                Coord::Stay => {}
                Coord::By(_) | Coord::Open => {
                    let span = w.span(axis.letter() as u8, self.core.block_span());
                    return self.core.refuse(span, codes::T1007::g701_takes_absolute_machine_coordinates());
                }
            }
        }
        if end.known().is_empty() {
            return self.core.refuse(self.core.block_span(), codes::P1004::block_names_no_end_point());
        }
        self.machine_move(end);
        Ok(())
    }

    /// A rapid move in machine coordinates: afterwards the workpiece position of its axes is not known.
    fn machine_move(&mut self, end: Pos) {
        let (side, coords) = (self.st.compensation.side(), Coords::Machine);
        self.movement(&Move { end, path: Path::Rapid, side, coords });
        self.st.position.forget(end.known());
        self.st.position.hide(end.known(), By::Machine(None), self.core.here.origin.loc);
        self.st.last = None;
        self.st.moved = true;
    }

    /// G14: to the tool change point, which only the machine knows.
    pub(super) fn change_point(&mut self, w: &Words) -> Outcome {
        let order = self.choice(w, b'Q', 0, 4)?;
        if let Some(num) = w.get(b'D').filter(|num| num.value != 0.0) {
            return self.core.refuse(num.span, codes::T2006::only_first_tool_change_point_is_known());
        }
        let Some((x, z)) = self.core.job.settings.control.turning.change_point else {
            return self.core.refuse(
                self.core.block_span(),
                codes::T2006::where_tool_change_point_lies_only_machine().answers([
                    Answer::entry("control", "tool_change_point", "X"),
                    Answer::entry("control", "tool_change_point", "Z"),
                ]),
            );
        };
        let on = |axes: &[(Axis, f64)]| {
            let mut end = Pos::UNKNOWN;
            for (axis, v) in axes {
                end.set(*axis, *v);
            }
            end
        };
        let (x, z) = ((Axis::X, x / 2.0), (Axis::Z, z));
        let steps: &[Pos] = match order {
            0 => &[on(&[x, z])],
            1 => &[on(&[x]), on(&[z])],
            2 => &[on(&[z]), on(&[x])],
            3 => &[on(&[x])],
            _ => &[on(&[z])],
        };
        for step in steps {
            self.machine_move(*step);
        }
        Ok(())
    }
}

/// The finding for an element that cannot be completed.
pub(super) fn fault_of(fault: Fault, origin: &Origin) -> Diagnostic {
    not_determined(fault).at(origin.loc).called(origin.call)
}
