//! What is put between two elements.

use crate::geo::joint::Joint;
use crate::geo::{Element, Point2, arc, distance, joint};
use crate::ir::compensation::Inside;

use super::piece::{Kind, Piece};
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

impl Compensator {
    /// The next element of the contour.
    pub(super) fn join(&mut self, mut next: Piece, out: &mut Out<'_>) -> Result<(), Refused> {
        if !self.ahead.is_empty() {
            self.look_ahead(next)?;
            return self.search(out);
        }
        let Some(last) = self.path.back_mut() else {
            self.append(next);
            return Ok(());
        };
        match between(last, &mut next, self.d, &mut self.made)? {
            Made::At(p) => {
                last.stop = Some(p);
                next.curve = joint::from_point(&next.curve, p);
            }
            Made::Between => {
                if last.rules.inside == Inside::Open {
                    self.damage.is_wanted();
                }
                reports::open_turn(last, &next, out.diags);
                let arc = self.made.iter().any(|piece| matches!(piece.curve, Element::Arc { .. }));
                if arc && !last.rules.joints_are_documented {
                    reports::reading(last, &next, out.diags);
                }
                self.path.extend(self.made.drain(..));
            }
            Made::NoRoom => {
                if next.rules.search.elements == 0 && !next.may_grow() {
                    return Err(reports::no_room(last, &next));
                }
                self.ahead.push_back(next);
                return self.search(out);
            }
        }
        self.append(next);
        Ok(())
    }

    pub(super) fn append(&mut self, piece: Piece) {
        self.elements += u32::from(piece.kind.is_of_contour());
        self.path.push_back(piece);
    }
}

/// Joins two neighbours; both may get longer. What comes between them is added to `made`.
pub fn between(last: &mut Piece, next: &mut Piece, d: f64, made: &mut Vec<Piece>) -> Result<Made, Refused> {
    if last.kind == Kind::Gone || next.kind == Kind::Gone {
        return Ok(Made::NoRoom);
    }
    let Some(turn) = joint::turn(&last.contour, &next.contour) else { return Ok(Made::NoRoom) };
    match joint::joint(&last.curve, &next.curve, turn, d) {
        Joint::Tangential(p) => Ok(Made::At(p)),
        Joint::Inside(_) | Joint::NoRoom if last.rules.inside == Inside::Open => {
            let curve = Element::Line { from: last.curve.to(), to: next.curve.from() };
            made.push(last.joint_to(next, curve));
            Ok(Made::Between)
        }
        Joint::Inside(p) => Ok(Made::At(p)),
        Joint::NoRoom => Ok(Made::NoRoom),
        Joint::Outside { turn } => outside(last, next, turn, d, made),
    }
}

fn outside(last: &mut Piece, next: &mut Piece, turn: f64, d: f64, made: &mut Vec<Piece>) -> Result<Made, Refused> {
    let rules = last.rules.outside;
    if let Some(by) = rules.by {
        return shortened(last, next, turn, (d, by), made);
    }
    if turn.abs() <= rules.prolonged.radians()
        && let Some(p) = joint::prolonged(&last.curve, &next.curve)
    {
        last.curve = joint::prolonged_to(&last.curve, p);
        next.curve = joint::prolonged_from(&next.curve, p);
        return Ok(Made::Between);
    }
    let (from, to) = (last.curve.to(), next.curve.from());
    made.extend(about(last, next, from, to, last.contour.to(), turn > 0.0)?);
    Ok(Made::Between)
}

/// An arc about `center`, if it is long enough to be one.
fn about(
    last: &Piece,
    next: &mut Piece,
    from: Point2,
    to: Point2,
    center: Point2,
    ccw: bool,
) -> Result<Option<Piece>, Refused> {
    let chord = distance(from, to);
    let sweep = arc::sweep(from, to, center, ccw);
    if chord < NO_ARC && sweep.abs() < 1.0 {
        return Ok(Some(last.joint_to(next, Element::Line { from, to })));
    }
    let piece = last.joint_to(next, Element::Arc { from, to, center, sweep });
    if piece.has_feed() { Ok(Some(piece)) } else { Err(reports::no_feed(last, next)) }
}

/// M197: both are prolonged by a length along their tangents, and a smaller arc touches both.
fn shortened(
    last: &mut Piece,
    next: &mut Piece,
    turn: f64,
    (d, by): (f64, f64),
    made: &mut Vec<Piece>,
) -> Result<Made, Refused> {
    let half = libm::tan(turn.abs() / 2.0);
    let whole = d.abs() * half;
    if !whole.is_finite() || by > whole + 1e-9 {
        return Err(reports::too_long(last, next, by, whole));
    }
    let (Some(t), Some(u)) = (last.contour.end_direction(), next.contour.start_direction()) else {
        return Ok(Made::NoRoom);
    };
    let (from, to) = (last.curve.to() + t * by, next.curve.from() - u * by);
    match last.curve {
        Element::Line { .. } => last.curve = joint::prolonged_to(&last.curve, from),
        Element::Arc { .. } => made.push(last.joint_to(next, Element::Line { from: last.curve.to(), to: from })),
    }
    let center = from - joint::towards(t, d) * (d.abs() - by / half);
    made.extend(about(last, next, from, to, center, turn > 0.0)?);
    match next.curve {
        Element::Line { .. } => next.curve = joint::prolonged_from(&next.curve, to),
        Element::Arc { .. } => made.push(last.joint_to(next, Element::Line { from: to, to: next.curve.from() })),
    }
    Ok(Made::Between)
}
