//! Moves as they go out: in the frame, in machine coordinates, of single axes.
//!
//! Source: S 2.1, 4.8 and 5.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Plane;
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Feed, Pos, Side};

use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::offsets::Outer;
use super::vocabulary::Address;
use super::words::{Mode, Words};
use super::{Channel, Core, Outcome};

impl Channel<'_> {
    /// Sends a move to the named axes of `end`.
    #[inline]
    pub(super) fn send(&mut self, end: &Pos, path: Path) {
        if !matches!(path, Path::Rapid) {
            self.left.cuts(self.capture.is_some());
        }
        let somewhere = self.st.touched.is_some() || !self.st.position.left_by_calls().is_empty();
        if somewhere && self.leaves_touched(end.known(), matches!(path, Path::Rapid)).is_err() {
            return;
        }
        if self.stands_right(end, Coords::Frame).is_err() {
            return;
        }
        if self.st.offsets.in_machine() {
            return self.send_in_machine(end, path);
        }
        if self.soft.is_some() && self.soft_element(end, &path) {
            return;
        }
        self.st.offsets.note_move(&self.core);
        if self.st.plane() != Plane::Xy {
            self.st.length_acts_along_z(&self.core);
        }
        if self.st.stored.is_some() {
            self.st.note_stored(&self.core, end, &path);
        }
        self.st.heading.follow(&self.st.position, end, &path);
        let mv = Move { end: *end, path, side: self.st.side_of_move(), coords: Coords::Frame };
        self.core.send_move(&mv, &self.st.ctx);
        self.st.position.move_to(end);
    }

    /// G500 is in force beside offsets of the machine: the coordinates are the machine's.
    pub(super) fn send_in_machine(&mut self, end: &Pos, path: Path) {
        if self.st.offsets.outer() == Outer::Unrelated {
            let _: Outcome = self.core.unrelated(Where::Block, "G500 stands beside");
            self.st.position.lose(end.known());
            return;
        }
        let wrong = if !matches!(path, Path::Rapid | Path::Line(_)) {
            "an arc cannot be printed in machine coordinates"
        } else if !self.st.ctx.frame.is_shift() {
            "a move in a rotated or scaled frame cannot be printed in machine coordinates"
        } else if self.st.side() != Side::None {
            "radius compensation cannot be printed in machine coordinates"
        } else {
            ""
        };
        if !wrong.is_empty() {
            let _: Outcome = self.core.in_machine_only_lines(Where::Block, wrong);
            return;
        }
        // What is printed with G53 and what the program writes itself count from different places.
        self.st.offsets.prints_offset();
        let mut machine = self.st.ctx.frame.apply(end);
        for axis in machine.known().iter() {
            let Ok(place) = self.st.machine_place(&self.core, axis, machine.get(axis).unwrap_or(0.0), Where::Block)
            else {
                return;
            };
            machine.set(axis, place);
        }
        let mv = Move { end: machine, path, side: Side::None, coords: Coords::Machine };
        self.core.send_move(&mv, &self.st.ctx);
        self.st.position.move_to(end);
    }

    /// A block under G53, G153 or SUPA.
    pub(super) fn machine_move(&mut self, w: &mut Words, code: GCode, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if !matches!(code, GCode::G0 | GCode::G1) || w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some() {
            return self.core.refuse(span, codes::S9011::in_machine_coordinates_only_straight_moves_can());
        }
        if self.st.side() != Side::None {
            return self.core.refuse(span, codes::S2080::block_in_machine_coordinates_under_radius_compensation());
        }
        let feed = self.path_feed(w, code == GCode::G0)?;
        // Where the tip goes; nothing where the spindle nose does.
        let (mut end, mut tip) = (Pos::UNKNOWN, Pos::UNKNOWN);
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            let incremental = match given.mode {
                Mode::Plain => self.st.is(GCode::G91),
                Mode::Ic | Mode::Dic | Mode::Ric => true,
                _ => false,
            };
            if incremental {
                return self
                    .core
                    .refuse(given.span, codes::S9011::increment_in_machine_coordinates_starts_from_place());
            }
            let directed = matches!(given.mode, Mode::Dc | Mode::Acp | Mode::Acn);
            if axis.is_rotary() && (directed || self.st.machine.modulo.contains(axis)) {
                let letter = axis.letter();
                self.core.say_once(given.span, codes::S8044::way_of_to_machine_position_is_left(&letter));
            }
            let mut value =
                if axis.is_rotary() { given.value } else { self.st.length(&self.core, axis, given, false)? };
            if !self.core.job.settings.control.sinumerik.machine_moves_without_tool {
                tip.set(axis, value);
                value = self.st.machine_place(&self.core, axis, value, given.span)?;
            }
            end.set(axis, value);
        }
        self.leaves_touched(end.known(), code == GCode::G0)?;
        self.stands_right(&end, Coords::Machine)?;
        self.st.offsets.moves_in_machine();
        self.st.offsets.machine_moves_beside_g500(&self.core, span);
        let mv = Move { end, path: Path::straight(feed), side: Side::None, coords: Coords::Machine };
        self.core.send_move(&mv, &self.st.ctx);
        if self.core.resolves() {
            self.st.compensation.is_over();
        }
        self.moved_by_machine(&end, &tip);
        Ok(())
    }

    /// `POS[X]=10 FA[X]=500`
    pub(super) fn positioning(&mut self, w: &mut Words) -> Outcome {
        if !w.axes.is_empty() || w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some() {
            let span = w.beside.positioning[0].given.span;
            return self.core.refuse(span, codes::S9008::pos_beside_path_motion());
        }
        // An axis that moves by itself is no path.
        if let (Some(first), Some(capture)) = (w.beside.positioning.first(), &mut self.capture) {
            let fault = |name: &str| codes::S2091::positioning_axis_moves_in_contour(&name);
            return capture.refuse(&self.core, first.given.span, fault);
        }
        if let Some((_, span)) = w.code_of(Group::Suppression) {
            return self.core.refuse(span, codes::S9011::positioning_axis_in_machine_coordinates());
        }
        for at in 0..w.beside.positioning.len() {
            let positioning = w.beside.positioning[at];
            let axis = positioning.axis;
            if axis.is_main() && !self.st.ctx.frame.is_shift() {
                return self.core.refuse(
                    positioning.given.span,
                    codes::S9008::is_positioning_axis_while_frame_is_turned(&axis.letter()),
                );
            }
            let value = self.st.target(&self.core, axis, positioning.given)?;
            let Some(feed) = self.st.feed.of_axis(axis) else {
                return self.core.refuse(
                    positioning.given.span,
                    codes::P2002::feed_of_as_positioning_axis_is_machine(&axis.letter()),
                );
            };
            let unit = if axis.is_rotary() { 1.0 } else { self.st.feed_unit() };
            let mut end = Pos::UNKNOWN;
            end.set(axis, value);
            self.send(&end, Path::Line(Feed::PerMinute(feed * unit)));
        }
        Ok(())
    }
}

impl Core<'_> {
    pub(super) fn in_machine_only_lines<T>(&self, place: impl Into<Where>, message: &str) -> Outcome<T> {
        self.refuse(place, codes::S9011::as_g500_wants(&message).answer(Answer::key("datums", "G500")))
    }
}
