//! Leaving out elements for which there is no room: the path goes on where it meets a later one.

use crate::geo::{Element, Point2, clearance, joint};

use super::joints::{Made, between};
use super::piece::{Kind, Piece};
use super::reports::{self, Refused};
use super::{Compensator, Out};

/// How much nearer to the contour than the radius the path may come, in mm: what tangential joints lose.
const NEARER: f64 = 1e-5;

impl Compensator {
    /// Adds an element behind those that wait.
    #[cold]
    pub(super) fn look_ahead(&mut self, mut next: Box<Piece>) -> Result<(), Refused> {
        if let Some(last) = self.ahead.back_mut()
            && let Made::Between = between(last, &mut next, self.d, &mut self.scratch)?
        {
            self.ahead.extend(self.scratch.made.drain(..));
        }
        self.ahead.push_back(next);
        Ok(())
    }

    /// Does the path meet one of the pieces that wait?
    #[cold]
    pub(super) fn search(&mut self, out: &mut Out<'_>) -> Result<(), Refused> {
        let Some(most) = self.ahead.back().map(|last| last.rules.search.elements) else { return Ok(()) };
        let Some((of_path, of_ahead, p)) = self.meeting(most) else {
            let waiting = self.ahead.iter().filter(|piece| piece.kind.is_of_contour()).count();
            let (Some(last), Some(first)) = (self.path.back(), self.ahead.front()) else { return Ok(()) };
            if waiting as u64 > u64::from(most) + u64::from(first.may_grow()) {
                return Err(reports::no_room(last, first));
            }
            return Ok(());
        };
        self.go_on_at(of_path, of_ahead, p, out)
    }

    /// Everything between the two pieces is left out.
    fn go_on_at(&mut self, of_path: usize, of_ahead: usize, p: Point2, out: &mut Out<'_>) -> Result<(), Refused> {
        let mut waiting = std::mem::take(&mut self.ahead);
        let mut left_out = self.path.split_off(of_path + 1);
        left_out.extend(waiting.drain(..of_ahead));
        let gone = left_out.iter().map(Box::as_ref).filter(|piece| piece.kind.is_of_contour());
        self.elements = self.path.iter().filter(|piece| piece.kind.is_of_contour()).count() as u32;
        if let (Some(last), Some(next)) = (self.path.back(), waiting.front())
            && gone.clone().next().is_some()
        {
            out.diags.push(*reports::left_out(gone, last, next));
        }
        if let Some(last) = self.path.back_mut() {
            last.stop = Some(p);
            for mut piece in left_out {
                last.items.extend(piece.other_axes());
                last.items.append(&mut piece.items);
                if piece.kind.is_of_contour() {
                    piece.kind = Kind::Gone;
                    self.gouges.keep(piece, &mut self.scratch.pool);
                }
            }
        }
        let mut at_start = true;
        for mut piece in waiting {
            if at_start {
                let first = self.path.len() == of_path + 1;
                if first {
                    piece.begin_at(p);
                }
                // Behind a joint comes the element that it leads to.
                at_start = piece.kind == Kind::Joint;
                self.append(piece);
            } else if piece.kind != Kind::Joint {
                self.join(piece, out)?;
            }
        }
        Ok(())
    }

    /// The pieces that meet with the fewest elements between them, and where.
    fn meeting(&self, most: u32) -> Option<(usize, usize, Point2)> {
        let mut best: Option<(u32, usize, usize, Point2)> = None;
        let mut skipped_ahead = 0;
        for (j, next) in self.ahead.iter().enumerate() {
            let mut skipped = skipped_ahead;
            for (i, last) in self.path.iter().enumerate().rev() {
                if skipped > most || best.is_some_and(|(fewest, ..)| skipped >= fewest) {
                    break;
                }
                if let Some(p) = self.meet_at(i, j, last, next) {
                    best = Some((skipped, i, j, p));
                    break;
                }
                skipped += u32::from(last.kind.is_of_contour());
            }
            skipped_ahead += u32::from(next.kind.is_of_contour());
        }
        best.map(|(_, i, j, p)| (i, j, p))
    }

    fn meet_at(&self, i: usize, j: usize, last: &Piece, next: &Piece) -> Option<Point2> {
        if last.kind == Kind::Gone || next.kind == Kind::Gone {
            return None;
        }
        let p = joint::first_crossing(&last.curve, &next.curve)?;
        let r = self.d.abs() - NEARER;
        let clear = |way: &Element, pieces: &mut dyn Iterator<Item = &Box<Piece>>| {
            pieces.filter(|piece| piece.kind.is_of_contour()).all(|piece| clearance::between(way, &piece.contour) >= r)
        };
        let (before, behind) = (joint::up_to_point(&last.curve, p), joint::from_point(&next.curve, p));
        let point = Element::Line { from: p, to: p };
        let free = clear(&point, &mut self.path.iter().chain(&self.ahead))
            && (last.kind == Kind::Entry
                || clear(&before, &mut self.path.iter().skip(i + 1).chain(self.ahead.iter().take(j + 1))))
            && (next.kind == Kind::Exit
                || clear(&behind, &mut self.path.iter().skip(i).chain(self.ahead.iter().take(j))));
        free.then_some(p)
    }
}
