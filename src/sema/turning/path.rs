//! Path blocks: straight moves, arcs, moves in machine coordinates.
//!
//! Source: T 4 and 5 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::open::{Rules, Solution, Solutions, Start};
use crate::geo::{Plane, Point2, SAME_POINT, Vec2, distance};
use crate::ir::contour::{
    Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path, Thread,
};
use crate::ir::{Feed, Origin, Pos, Side};
use crate::machine::{Axis, Settings};
use crate::sema::common::hidden::By;
use crate::sema::common::position::Position;
use crate::sema::run::Where;
use crate::sema::run::place::{Lack, Unknown};
use crate::sema::run::refusal::{Made, refused};

use super::chain::{AGREES, Choice, Coord, Data, Fault, RULES, Solved, by_distance, not_determined};
use super::element_data::{Follows, Transition};
use super::program_parts::Family;
use super::spindle::turns;
use super::words::{Measure, Words};
use super::{Core, Outcome, Reported, Run};

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

impl Core<'_> {
    /// Where the tool stands on an axis.
    fn stands(&self, position: &Position, axis: Axis, place: Where) -> Outcome<f64> {
        let asked = Unknown { position, axis, lack: &|| Lack::Nothing, otherwise: "" };
        self.place_of(place, asked, codes::P2001::it_is_not_known_where_tool_stands)
    }

    /// Where the tool stands, as (Z, X).
    pub(super) fn tip(&self, position: &Position) -> Outcome<Point2> {
        let z = self.stands(position, Axis::Z, Where::Block)?;
        let x = self.stands(position, Axis::X, Where::Block)?;
        Ok(Point2::new(z, x))
    }

    /// The end of a straight move along an axis, as far as it is not open.
    #[inline]
    fn end_on(&self, axis: Axis, coord: Coord, w: &Words, position: &Position, end: &mut Pos) -> Outcome {
        match coord {
            Coord::At(v) => end.set(axis, v),
            Coord::By(d) => end.set(axis, self.stands(position, axis, w.place(axis.letter() as u8))? + d),
            Coord::Stay | Coord::Open => {}
        }
        Ok(())
    }
}

impl Words {
    /// E: feed of a chamfer or rounding on the 4110, its share of the `feed` on later controls.
    fn corner_feed(&self, feed: Feed, measure: Measure) -> Made<Option<Feed>> {
        let Some(num) = self.get(b'E') else { return Ok(Some(feed)) };
        if num.value <= 0.0 {
            return refused(num.span, codes::T1007::e_has_to_be_above_zero());
        }
        if measure.family == Family::Basic {
            return Ok(Some(feed.with_value(num.value * measure.mm)));
        }
        if num.value > 1.0 {
            return refused(num.span, codes::T1007::e_is_no_share_of_feed(&num.value));
        }
        Ok(Some(feed.with_value(feed.value() * num.value)))
    }

    /// E without a chamfer or rounding.
    #[inline]
    fn no_e(&self) -> Made {
        if !self.has(b'E') {
            return Ok(());
        }
        refused(self.place(b'E'), codes::P1003::e_is_feed_of_chamfer_or_rounding())
    }

    /// Words of G33 that no target can do.
    fn plain_thread(&self) -> Made {
        for (letter, what) in [(b'C', "start angle of a thread"), (b'E', "variable pitch")] {
            if let Some(num) = self.get(letter).filter(|num| num.value != 0.0) {
                return refused(num.span, codes::T9007::target_cannot_cut(&what));
            }
        }
        Ok(())
    }

    /// The axis along which the pitch of a thread counts: that which moves most, so the target and the control agree on it.
    fn pitch_along(&self, way: Vec2) -> Made<Option<Axis>> {
        match self.choice(b'H', 0, 3)? {
            0 if way.y.abs() <= way.x.abs() + AGREES => Ok(Some(Axis::Z)),
            1 if way.x.abs() <= way.y.abs() + AGREES => Ok(Some(Axis::X)),
            3 => Ok(None),
            2 => refused(self.place(b'H'), codes::T1007::h_is_0_for_z_1()),
            _ => refused(self.place(b'H'), codes::T1007::thread_leans_more_than_45_degrees_out()),
        }
    }

    /// G701: where it goes in machine coordinates.
    pub(super) fn machine_place(&self, mm: f64) -> Made<Pos> {
        let mut end = Pos::UNKNOWN;
        for axis in [Axis::X, Axis::Z] {
            match self.coord(axis, mm) {
                Coord::At(v) => end.set(axis, v),
                Coord::Stay => {}
                Coord::By(_) | Coord::Open => {
                    let place = self.place(axis.letter() as u8);
                    return refused(place, codes::T1007::g701_takes_absolute_machine_coordinates());
                }
            }
        }
        if end.known().is_empty() {
            return refused(Where::Block, codes::P1004::block_names_no_end_point());
        }
        Ok(end)
    }

    /// G14: the steps to the tool change point, which only the machine knows.
    pub(super) fn to_change_point(&self, settings: &Settings) -> Made<Vec<Pos>> {
        let order = self.choice(b'Q', 0, 4)?;
        if let Some(num) = self.get(b'D').filter(|num| num.value != 0.0) {
            return refused(num.span, codes::T2006::only_first_tool_change_point_is_known());
        }
        let Some((x, z)) = settings.control.turning.change_point else {
            let answer = |axis| Answer::entry("control", "tool_change_point", axis);
            let asking = codes::T2006::where_tool_change_point_lies_only_machine();
            return refused(Where::Block, asking.answers([answer("X"), answer("Z")]));
        };
        let (x, z) = ((Axis::X, x / 2.0), (Axis::Z, z));
        let steps: &[&[(Axis, f64)]] = match order {
            0 => &[&[x, z]],
            1 => &[&[x], &[z]],
            2 => &[&[z], &[x]],
            3 => &[&[x]],
            _ => &[&[z]],
        };
        let on = |axes: &&[(Axis, f64)]| {
            let mut end = Pos::UNKNOWN;
            axes.iter().for_each(|(axis, v)| end.set(*axis, *v));
            end
        };
        Ok(steps.iter().map(on).collect())
    }
}

impl Run<'_> {
    /// Nobody knows where the tool is.
    pub(super) fn lose_all(&mut self) {
        self.chain.clear();
        self.st.lose();
        self.core.send_lost(&self.st.ctx);
    }

    /// How the numbers of words count now.
    #[inline]
    pub(super) fn measure(&self) -> Measure {
        Measure { mm: self.st.mm(), family: self.sections.family() }
    }

    /// G0 and G1.
    #[inline]
    pub(super) fn straight(&mut self, w: &Words, rapid: bool) -> Outcome {
        let feed = if rapid { None } else { Some(self.core.cutting_feed(&mut self.st.feed)?) };
        self.st.compensation.moves();
        let measure = self.measure();
        let (data, follows) = self.core.element_of(w, None, measure)?;
        let open = data.entry.is_some() || data.x == Coord::Open || data.y == Coord::Open;
        if open || !self.chain.is_empty() {
            return self.chained(data, follows, feed, w);
        }
        let transition = follows.transition;
        let mut end = Pos::UNKNOWN;
        self.core.end_on(Axis::X, data.y, w, &self.st.position, &mut end)?;
        self.core.end_on(Axis::Z, data.x, w, &self.st.position, &mut end)?;
        if end.known().is_empty() {
            return self.core.refuse(Where::Block, codes::P1004::block_names_no_end_point());
        }
        let corner = matches!(transition, Transition::Rounding(_) | Transition::Chamfer(_));
        // A corner needs the direction of its first element, so its start.
        let from = if corner { Some(self.core.tip(&self.st.position)?) } else { self.st.at() };
        let (path, side, coords) = (Path::straight(feed), self.st.compensation.side(), Coords::Frame);
        self.core.send_move(&Move { end, path, side, coords }, &self.st.ctx);
        self.st.position.move_to(&end);
        self.st.moved = true;
        let to = self.st.at();
        if let (false, Some(to)) = (rapid, to) {
            self.st.stock.cut_to(to, self.geometry.blank);
        }
        match (from, to) {
            (Some(from), Some(to)) => self.st.last.follow(Solved { from, to, arc: None }, transition),
            _ => self.st.last.forget(),
        }
        if !corner {
            return self.core.made(w.no_e());
        }
        let feed = self.core.cutting_feed(&mut self.st.feed)?;
        let feed = self.core.made(w.corner_feed(feed, measure))?;
        if let Some(corner) = corner_of(transition, feed) {
            self.core.send_corner(&corner, &self.st.ctx);
        }
        Ok(())
    }

    /// G2, G3, G12, G13.
    pub(super) fn arc(&mut self, w: &Words, ccw: bool, absolute: bool) -> Outcome {
        if self.st.compensation.is_fresh() {
            return self.core.refuse(Where::Block, codes::T2021::nose_radius_compensation_begins_or_ends());
        }
        let feed = Some(self.core.cutting_feed(&mut self.st.feed)?);
        let (data, follows) = self.core.element_of(w, Some((ccw, absolute)), self.measure())?;
        self.chained(data, follows, feed, w)
    }

    /// An element that may need the next one.
    fn chained(&mut self, data: Data, follows: Follows, feed: Option<Feed>, w: &Words) -> Outcome {
        self.core.tip(&self.st.position)?;
        let corner_feed = if matches!(follows.transition, Transition::Rounding(_) | Transition::Chamfer(_)) {
            let feed = self.core.cutting_feed(&mut self.st.feed)?;
            self.core.made(w.corner_feed(feed, self.measure()))?
        } else {
            self.core.made(w.no_e())?;
            None
        };
        let tag = Tag { feed, side: self.st.compensation.side(), follows, corner_feed, origin: self.core.here.origin };
        self.chain.push(data, tag);
        self.drain_chain(false)
    }

    /// Sends the elements that can be completed by now.
    fn drain_chain(&mut self, closed: bool) -> Outcome {
        while !self.chain.is_empty() {
            let at = self.core.tip(&self.st.position)?;
            let dir = self.st.last.direction();
            match self.chain.next(&Start { at, dir, goes_on: true }, closed) {
                Ok(Some((solution, tag))) => self.send_solved(solution.solved, &tag),
                Ok(None) => return Ok(()),
                Err((fault, tag)) => {
                    let Origin { loc, call } = tag.origin;
                    self.core.report(not_determined(fault).at(loc).called(call));
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

    fn send_solved(&mut self, solved: Solved, tag: &Tag) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, solved.to);
        let path = match (solved.arc, tag.feed) {
            (Some((center, ccw)), Some(feed)) => {
                let shape = ArcShape::Center { center, ccw, tol: self.core.arc_tolerance() };
                Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 }, feed)
            }
            // Arcs always have one.
            (_, feed) => Path::straight(feed),
        };
        let mv = Move { end, path, side: tag.side, coords: Coords::Frame };
        self.core.send_move_of(&mv, &self.st.ctx, &tag.origin);
        if tag.feed.is_some() {
            self.st.stock.cut_to(solved.to, self.geometry.blank);
        }
        self.st.position.move_in_plane(Plane::Zx, solved.to);
        self.st.moved = true;
        self.st.last.follow(solved, tag.follows.transition);
        if let Some(corner) = corner_of(tag.follows.transition, tag.corner_feed) {
            self.core.send_corner_of(&corner, &self.st.ctx, &tag.origin);
        }
    }

    /// G33: one thread cut, from where the tool stands.
    pub(super) fn single_thread(&mut self, w: &Words) -> Outcome {
        self.core.made(w.plain_thread())?;
        self.core.without_effect(w, b"BP", codes::T8017::run_in_of_g33_lies_inside);
        self.core.without_effect(w, b"IK", codes::T8017::retraction_of_g33_belongs_to_stop);
        let from = self.core.tip(&self.st.position)?;
        self.core.accept(Where::Block, turns(&self.st.spindle, 33))?;
        let mm = self.st.mm();
        let lead = self.core.made(w.needed_length(b'F', mm, "the pitch of the thread"))?;
        let (x, z) = (w.coord(Axis::X, mm), w.coord(Axis::Z, mm));
        let mut end = Pos::UNKNOWN;
        self.core.end_on(Axis::X, x, w, &self.st.position, &mut end)?;
        self.core.end_on(Axis::Z, z, w, &self.st.position, &mut end)?;
        let to = Point2::new(end.get(Axis::Z).unwrap_or(from.x), end.get(Axis::X).unwrap_or(from.y));
        if x == Coord::Open || z == Coord::Open || distance(from, to) <= SAME_POINT {
            return self.core.refuse(Where::Block, codes::P1004::thread_needs_end_point());
        }
        let along = self.core.made(w.pitch_along(to - from))?;
        end.set_in_plane(Plane::Zx, to);
        let (path, side, coords) = (Path::Thread(Thread { lead, along }), self.st.compensation.side(), Coords::Frame);
        self.core.send_move(&Move { end, path, side, coords }, &self.st.ctx);
        self.st.position.move_in_plane(Plane::Zx, to);
        self.st.moved = true;
        self.st.last.follow(Solved { from, to, arc: None }, Transition::Sharp);
        Ok(())
    }

    /// A rapid move in machine coordinates: afterwards the workpiece position of its axes is not known.
    pub(super) fn machine_move(&mut self, end: Pos) {
        let (path, side, coords) = (Path::Rapid, self.st.compensation.side(), Coords::Machine);
        self.core.send_move(&Move { end, path, side, coords }, &self.st.ctx);
        self.st.position.forget(end.known());
        self.st.position.hide(end.known(), By::Machine(None), self.core.here.origin.loc);
        self.st.last.forget();
        self.st.moved = true;
    }
}

/// The chamfer or rounding at the end of an element.
fn corner_of(transition: Transition, feed: Option<Feed>) -> Option<Corner> {
    let shape = match transition {
        Transition::Open | Transition::Sharp => return None,
        Transition::Rounding(radius) => CornerShape::Rounding { radius },
        Transition::Chamfer(side) => CornerShape::Chamfer { side },
    };
    let (large, at_arc, blocks) = (LargeCorner::Refuse, ArcChamfer::Refuse, Blocks::PassedOver);
    Some(Corner { shape, feed, early: false, modal: false, large, at_arc, blocks })
}
