//! The way to a contour, and from it.

use crate::geo::tolerance;
use crate::geo::{Element, Point2, Vec2, arc, distance, joint};
use crate::ir::compensation::{Border, Compensation, Ends};
use crate::ir::motion::{Move, Path};
use crate::ir::{Origin, Pos, Side};
use std::rc::Rc;

use super::super::step::plane_axes;
use super::piece::{Kind, Piece, aside, with_plane};
use super::reports::{self, Refused};
use super::{Compensator, Out, Stage, Way};

impl Compensator {
    /// The first block on a side: the way to the contour.
    pub(super) fn begin(
        &mut self,
        mv: &Move,
        start: &Pos,
        rules: &Rc<Compensation>,
        origin: &Origin,
    ) -> Result<(), Refused> {
        reports::admit(mv, origin)?;
        if matches!(mv.path, Path::Arc(..)) || !Way::of(mv, start).moves() {
            return Err(reports::no_line(true, matches!(mv.path, Path::Arc(..)), rules, origin));
        }
        let Some(to) = mv.end.in_plane(mv.plane) else { return Err(reports::start_unknown(origin)) };
        if self.stage == Stage::Off {
            self.at = *start;
        }
        self.stage = Stage::Entering;
        (self.side, self.plane) = (mv.side, mv.plane);
        self.d = if mv.side == Side::Right { -rules.radius } else { rules.radius };
        let point = Element::Line { from: to, to };
        let mut entry = self.scratch.pool.take(rules);
        (entry.kind, entry.contour, entry.curve) = (Kind::Entry, point, point);
        (entry.stop, entry.mv, entry.origin) = (None, *mv, *origin);
        self.entry = Some(entry);
        Ok(())
    }

    /// The first element of the contour is known, and with it where the path begins.
    pub(super) fn enter(&mut self, first: Box<Piece>, out: &mut Out<'_>) -> Result<(), Refused> {
        let Some(mut entry) = self.entry.take() else { return Ok(()) };
        self.stage = Stage::Contour;
        let edge = first.curve.from();
        let corner = first.contour.from();
        // What the block says that begins the compensation.
        let rules = Rc::clone(&entry.rules);
        let Some(heading) = first.contour.start_direction() else { return Err(reports::start_unknown(&first.origin)) };
        if first.kind == Kind::Gone {
            return Err(reports::arc_too_small(&first.contour, &rules, &first.origin));
        }
        entry.curve = Element::Line { from: edge, to: edge };
        let mut around = None;
        if rules.approach != Border::Perpendicular
            && let Some(start) = self.at.in_plane(self.plane)
            && self.is_behind(start + rules.nose, edge, heading)
        {
            let from = start + rules.nose;
            let border = Piece { rules: Rc::clone(&rules), ..(*first).clone() };
            around = Some(self.around(from, corner, edge, &border, false)?);
            if (from - corner).dot(&joint::towards(heading, self.d)) > 0.0 {
                out.diags.push(*reports::nearly_behind(false, &entry.origin));
            }
        }
        match rules.ends {
            Ends::AsTheyAre => {}
            // From its far end: what is nearest to the programmed element is met last.
            Ends::Circle => {
                let ccw = self.d < 0.0;
                let sweep = arc::sweep(edge, edge, corner, ccw);
                entry.curve = Element::Arc { from: edge, to: edge, center: corner, sweep };
            }
            Ends::Tangent => {
                entry.curve = Element::Line { from: edge - heading * LONG, to: edge };
            }
        }
        self.gouges.forget(&mut self.scratch.pool);
        self.gouges.refuses = first.rules.search.bottlenecks;
        if let Some(mut arc) = around {
            entry.curve = Element::Line { from: arc.curve.from(), to: arc.curve.from() };
            arc.items = std::mem::take(&mut entry.items);
            self.path.push_back(entry);
            self.path.push_back(arc);
        } else {
            self.path.push_back(entry);
        }
        self.append(first);
        self.watch_contour(out.diags);
        Ok(())
    }

    /// Would the straight way between `far` and the point beside the border come nearer to the border than the radius?
    fn is_behind(&self, far: Point2, edge: Point2, heading: Vec2) -> bool {
        (far - edge).dot(&joint::towards(heading, self.d)) < -tolerance::LOST
    }

    /// The circle about the border point between a tangent from or to `far` and `edge`.
    fn around(
        &self,
        far: Point2,
        corner: Point2,
        edge: Point2,
        border: &Piece,
        leaves: bool,
    ) -> Result<Box<Piece>, Refused> {
        let rules = &border.rules;
        let kind = if leaves { rules.retract } else { rules.approach };
        if kind == Border::AroundOtherwise {
            return Err(reports::around_otherwise(leaves, &border.origin));
        }
        let ccw = self.d < 0.0;
        let touch = joint::tangent_point(far, corner, self.d.abs(), if leaves { !ccw } else { ccw });
        let Some(touch) = touch else { return Err(reports::inside_circle(leaves, rules, &border.origin)) };
        let (from, to) = if leaves { (edge, touch) } else { (touch, edge) };
        let curve = Element::Arc { from, to, center: corner, sweep: arc::sweep(from, to, corner, ccw) };
        let made = border.joint_to(border, curve);
        if made.has_feed() { Ok(made) } else { Err(reports::no_feed(border, border)) }
    }

    /// A move without compensation.
    pub(super) fn uncompensated(
        &mut self,
        mv: &Move,
        rules: Option<&Rc<Compensation>>,
        origin: &Origin,
        out: &mut Out<'_>,
    ) -> Result<(), Refused> {
        match self.stage {
            Stage::Off => {
                out.movement(mv, origin);
                return Ok(());
            }
            Stage::Refused => {
                self.forget();
                out.movement(mv, origin);
                return Ok(());
            }
            Stage::Entering => {
                let of = self.last_origin();
                return Err(reports::no_contour(&of, origin));
            }
            Stage::Contour => {
                self.end_as(rules);
                self.end_of_contour(mv, origin, out)?;
            }
            Stage::Constant(_) | Stage::Leaving => {}
        }
        self.leave(mv, origin, out)
    }

    /// Is the move about an axis of the plane? Its end is where the tool goes, even if the contour ends there.
    fn names_plane(&self, mv: &Move) -> bool {
        !plane_axes(self.plane).common(mv.axes).is_empty()
    }

    /// The tool leaves the contour, or changes its place beside it.
    fn leave(&mut self, mv: &Move, origin: &Origin, out: &mut Out<'_>) -> Result<(), Refused> {
        let arc = matches!(mv.path, Path::Arc(..));
        if !mv.machine && (arc || matches!(mv.path, Path::Thread { .. })) {
            return Err(reports::leaves_on_arc(arc, origin));
        }
        if mv.machine || !self.names_plane(mv) {
            if self.stage != Stage::Leaving && !mv.machine {
                out.diags.push(*reports::offset_stays(self.at.in_plane(self.plane), self.plane, origin));
            }
            self.stage = Stage::Leaving;
            let mv = aside(mv, &self.at, self.plane);
            self.send(&mv, origin, out);
            if mv.machine {
                mv.axes.iter().for_each(|axis| self.at.forget(axis));
            }
            return Ok(());
        }
        let mv = with_plane(mv, self.plane);
        if !self.stands_at_end(&mv) {
            self.send(&mv, origin, out);
        }
        self.forget();
        Ok(())
    }

    /// What the block says that ends the compensation.
    fn end_as(&mut self, rules: Option<&Rc<Compensation>>) {
        if let (Some(rules), Some(last)) = (rules, self.last_mut())
            && (last.rules.retract, last.rules.ends) != (rules.retract, rules.ends)
        {
            let own = Rc::make_mut(&mut last.rules);
            (own.retract, own.ends) = (rules.retract, rules.ends);
        }
    }

    /// Settles and prints the contour; `mv` leads away from it.
    fn end_of_contour(&mut self, mv: &Move, origin: &Origin, out: &mut Out<'_>) -> Result<(), Refused> {
        self.close(out)?;
        if let Some(last) = self.path.back() {
            reports::last_corner(last, origin, out.diags);
        }
        let around = match self.path.back() {
            Some(last) if last.rules.retract != Border::Perpendicular && !mv.machine => {
                let (edge, corner) = (last.curve.to(), last.contour.to());
                let to = mv.end.in_plane(self.plane).map(|p| p + last.rules.nose);
                match (to, last.contour.end_direction()) {
                    (Some(to), Some(heading))
                        if distance(to, corner) > tolerance::LOST && self.is_behind(to, edge, heading) =>
                    {
                        if (to - corner).dot(&joint::towards(heading, self.d)) > 0.0 {
                            out.diags.push(*reports::nearly_behind(true, origin));
                        }
                        Some(self.around(to, corner, edge, last, true)?)
                    }
                    _ => None,
                }
            }
            _ => None,
        };
        if let Some(mut arc) = around {
            arc.origin = *origin;
            self.path.push_back(arc);
        }
        self.print_all(out);
        Ok(())
    }

    /// No element follows: what waits has to fit.
    fn close(&mut self, out: &mut Out<'_>) -> Result<(), Refused> {
        if self.ahead.is_empty() {
            return Ok(());
        }
        if let Some(exit) = self.prolonged_end() {
            self.ahead.push_back(exit);
            self.search(out)?;
            if self.path.back().is_some_and(|last| last.kind == Kind::Exit)
                && let Some(exit) = self.path.pop_back()
                && let Some(last) = self.path.back_mut()
            {
                last.items.extend(exit.items);
            }
        }
        match (self.path.back(), self.ahead.front()) {
            (Some(last), Some(first)) => Err(reports::no_room(last, first)),
            _ => Ok(()),
        }
    }

    /// The end of the last element, prolonged as the control does.
    fn prolonged_end(&self) -> Option<Box<Piece>> {
        let last = self.ahead.back().filter(|last| last.kind == Kind::Element)?;
        let (edge, corner) = (last.curve.to(), last.contour.to());
        let curve = match last.rules.ends {
            Ends::AsTheyAre => return None,
            Ends::Circle => Element::Arc {
                from: edge,
                to: edge,
                center: corner,
                sweep: arc::sweep(edge, edge, corner, self.d < 0.0),
            },
            Ends::Tangent => Element::Line { from: edge, to: edge + last.contour.end_direction()? * LONG },
        };
        Some(Box::new(Piece { kind: Kind::Exit, curve, stop: None, items: Vec::new(), ..(**last).clone() }))
    }

    /// The offset from now on: that of the end of the last element, which is printed.
    pub(super) fn hold_offset(&mut self, out: &mut Out<'_>) -> Result<Vec2, Refused> {
        self.close(out)?;
        let offset =
            self.path.back().map_or(Vec2::zeros(), |last| last.curve.to() - last.contour.to() - last.rules.nose);
        self.print_all(out);
        Ok(offset)
    }

    /// The offset is computed again, from `first` on.
    pub(super) fn resume(&mut self, first: Box<Piece>, by: Vec2, out: &Out<'_>) -> Result<(), Refused> {
        let corner = first.contour.from();
        let (from, edge) = (corner + by + first.rules.nose, first.curve.from());
        if first.kind == Kind::Gone {
            return Err(reports::arc_too_small(&first.contour, &first.rules, &first.origin));
        }
        if distance(from, edge) > tolerance::LOST {
            let round = first.rules.approach == Border::Around && (distance(from, corner) - self.d.abs()).abs() < 1e-6;
            let curve = if round {
                Element::Arc { from, to: edge, center: corner, sweep: arc::sweep(from, edge, corner, self.d < 0.0) }
            } else {
                Element::Line { from, to: edge }
            };
            let made = first.joint_to(&first, curve);
            if round && !made.has_feed() {
                return Err(reports::no_feed(&first, &first));
            }
            self.path.push_back(made);
        }
        self.append(first);
        self.watch_contour(out.diags);
        Ok(())
    }
}

/// Farther than any machine moves, in mm.
const LONG: f64 = 1e5;
