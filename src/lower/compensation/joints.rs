//! What is put between two elements.

use crate::geo::joint::Joint;
use crate::geo::{Deg, Element, Point2, arc, joint};
use crate::ir::compensation::Inside;

use super::piece::{Kind, Piece, PiecePool};
use super::reports::{self, Refused};
use super::{Compensator, Out};

/// Arcs with a shorter chord are lines, in mm: printed, their ends might be taken for a full circle's.
const NO_ARC: f64 = 2e-3;

/// How two pieces are joined, and what comes between them.
pub enum Made {
    /// The first is left at this point, the second begins there.
    At(Point2),
    /// Both as they are, with the pieces made between them.
    Between,
    NoRoom,
}

/// What comes between two elements while they are joined, and what it is made of.
#[derive(Debug, Default)]
pub struct JointScratch {
    // They go from hand to hand, as they are.
    #[allow(clippy::vec_box)]
    pub made: Vec<Box<Piece>>,
    pub pool: PiecePool,
    /// The last joint is one of the plain parallel: tangential, at the crossing of two lines, or about the corner.
    pub regular: bool,
}

impl Compensator {
    /// The next element of the contour.
    #[inline]
    pub(super) fn join(&mut self, mut next: Box<Piece>, out: &mut Out<'_>) -> Result<(), Refused> {
        if !self.ahead.is_empty() {
            self.look_ahead(next)?;
            return self.search(out);
        }
        let Some(last) = self.path.back_mut() else {
            self.append(next);
            return Ok(());
        };
        match between(last, &mut next, self.d, &mut self.scratch)? {
            Made::At(p) => {
                reports::corner_without_effect(last, &next, out.diags);
                last.stop = Some(p);
                next.begin_at(p);
            }
            Made::Between => {
                if last.rules.inside == Inside::Open {
                    self.gouges.is_wanted();
                }
                reports::open_turn(last, &next, out.diags);
                if !last.rules.joints_are_documented
                    && self.scratch.made.iter().any(|piece| matches!(piece.curve, Element::Arc { .. }))
                {
                    reports::reading(last, &next, out.diags);
                }
                self.path.extend(self.scratch.made.drain(..));
            }
            Made::NoRoom => {
                if next.rules.search.elements == 0 && !next.may_grow() {
                    return Err(reports::no_room(last, &next));
                }
                self.ahead.push_back(next);
                return self.search(out);
            }
        }
        next.joined = self.scratch.regular;
        self.append(next);
        Ok(())
    }

    #[inline]
    pub(super) fn append(&mut self, piece: Box<Piece>) {
        self.elements += u32::from(piece.kind.is_of_contour());
        self.path.push_back(piece);
    }
}

/// Joins two neighbours; both may get longer. What comes between them is added to what is made.
#[inline(always)]
pub fn between(last: &mut Piece, next: &mut Piece, d: f64, scratch: &mut JointScratch) -> Result<Made, Refused> {
    scratch.regular = false;
    if last.kind == Kind::Gone || next.kind == Kind::Gone {
        return Ok(Made::NoRoom);
    }
    match joint::joint(&last.curve, &next.curve, last.headings.end, next.headings.start, d) {
        Joint::Tangential(p) => {
            scratch.regular = true;
            Ok(Made::At(p))
        }
        Joint::Inside(_) | Joint::NoRoom if last.rules.inside == Inside::Open => {
            let curve = Element::Line { from: last.curve.to(), to: next.curve.from() };
            scratch.made.push(scratch.pool.joint(last, next, curve));
            Ok(Made::Between)
        }
        Joint::Inside(p) => {
            scratch.regular = matches!((&last.contour, &next.contour), (Element::Line { .. }, Element::Line { .. }));
            Ok(Made::At(p))
        }
        Joint::NoRoom => Ok(Made::NoRoom),
        Joint::Outside => outside(last, next, d, scratch),
    }
}

#[inline(never)]
fn outside(last: &mut Piece, next: &mut Piece, d: f64, scratch: &mut JointScratch) -> Result<Made, Refused> {
    let rules = last.rules.outside;
    if let Some(by) = rules.by {
        return shortened(last, next, (d, by), scratch);
    }
    if rules.prolonged > Deg(0.0)
        && turn(last, next) <= rules.prolonged.radians()
        && let Some(p) = joint::prolonged(&last.curve, &next.curve)
    {
        last.curve = joint::prolonged_to(&last.curve, p);
        next.curve = joint::prolonged_from(&next.curve, p);
        return Ok(Made::Between);
    }
    let (from, to) = (last.curve.to(), next.curve.from());
    let mut about = about(last, next, [from, to], last.contour.to(), d < 0.0, scratch)?;
    about.regular = true;
    scratch.made.push(about);
    scratch.regular = true;
    Ok(Made::Between)
}

/// By how much the contour turns, in rad.
fn turn(last: &Piece, next: &Piece) -> f64 {
    joint::turn(last.headings.end, next.headings.start).abs()
}

/// An arc about `center`, or a line where it is too short to be one.
fn about(
    last: &Piece,
    next: &Piece,
    [from, to]: [Point2; 2],
    center: Point2,
    ccw: bool,
    scratch: &mut JointScratch,
) -> Result<Box<Piece>, Refused> {
    let sweep = arc::sweep(from, to, center, ccw);
    if sweep.abs() < 1.0 && (to - from).norm_squared() < NO_ARC * NO_ARC {
        return Ok(scratch.pool.joint(last, next, Element::Line { from, to }));
    }
    let piece = scratch.pool.joint(last, next, Element::Arc { from, to, center, sweep });
    if piece.has_feed() { Ok(piece) } else { Err(reports::no_feed(last, next)) }
}

/// M197: both are prolonged by a length along their tangents, and a smaller arc touches both.
fn shortened(
    last: &mut Piece,
    next: &mut Piece,
    (d, by): (f64, f64),
    scratch: &mut JointScratch,
) -> Result<Made, Refused> {
    let half = libm::tan(turn(last, next) / 2.0);
    let whole = d.abs() * half;
    if !whole.is_finite() || by > whole + 1e-9 {
        return Err(reports::too_long(last, next, by, whole));
    }
    let (t, u) = (last.headings.end, next.headings.start);
    let (from, to) = (last.curve.to() + t * by, next.curve.from() - u * by);
    match last.curve {
        Element::Line { .. } => last.curve = joint::prolonged_to(&last.curve, from),
        Element::Arc { .. } => {
            let line = Element::Line { from: last.curve.to(), to: from };
            scratch.made.push(scratch.pool.joint(last, next, line));
        }
    }
    let center = from - joint::towards(t, d) * (d.abs() - by / half);
    let arc = about(last, next, [from, to], center, d < 0.0, scratch)?;
    scratch.made.push(arc);
    match next.curve {
        Element::Line { .. } => next.curve = joint::prolonged_from(&next.curve, to),
        Element::Arc { .. } => {
            let line = Element::Line { from: to, to: next.curve.from() };
            scratch.made.push(scratch.pool.joint(last, next, line));
        }
    }
    Ok(Made::Between)
}
