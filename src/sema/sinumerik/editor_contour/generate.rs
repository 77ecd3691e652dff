//! From solved elements to the NC blocks that the editor makes of them: transitions, undercuts, grinding allowances.

use crate::geo::undercut::{Allowance, Corner, Orientation, Reference, Shape, vertices};
use crate::geo::{Deg, Point2, SAME_POINT, Vec2, cross, distance, intersect, left};
use crate::ir::undercut::{Surface, ThreadForm, Undercut, form_e, form_f, thread, thread_by_contour};
use crate::machine::Undercuts;
use crate::parser::sinumerik::records::{Record, Undercut as Form};

use super::super::undercut_sizes::editor_size;
use super::made::{Contour, ContourBlock, CornerWord, NoUndercut, Unsolved, Written};
use super::material::Material;
use super::solve::{Begin, Solved, Solver};

/// Most records of a contour.
pub(super) const MOST_RECORDS: usize = 5000;

/// Works out the NC blocks as the editor writes them, in mm.
///
/// # Errors
/// See [`Unsolved`].
pub(super) fn solve(records: &[Record], written: Written, tables: &Undercuts) -> Result<Contour, Unsolved> {
    make(records, written, tables, true)
}

/// The same with undercuts as corners, which lowering makes where their conditions hold.
///
/// # Errors
/// See [`Unsolved`].
pub(super) fn outline(records: &[Record], written: Written, tables: &Undercuts) -> Result<Contour, Unsolved> {
    make(records, written, tables, false)
}

/// Everything is worked out in the unit of the program, since values are rounded to its places.
fn make(records: &[Record], written: Written, tables: &Undercuts, expanded: bool) -> Result<Contour, Unsolved> {
    if records.len() > MOST_RECORDS {
        return Err(Unsolved::TooLong);
    }
    let mut solver = Solver::new(written.diameter);
    let start = solver.read(records)?;
    let (corner, elements) = solver.elements_from(start)?;
    let contour = Generator { records, tables, elements, written, expanded }.blocks(start, corner)?;
    Ok(Contour { chosen: solver.chosen, ..contour.scaled(written.unit) })
}

/// Directions closer than this are the same, in degrees: three decimals of a coordinate over a few mm.
const SAME_ANGLE: f64 = 0.01;
/// Cosine of the largest angle that is a right one.
const SQUARE: f64 = 1e-4;
/// Longer than any undercut: the line in front of a contour has no length.
const LONG: f64 = 1e4;

/// Makes NC blocks of solved elements.
pub(super) struct Generator<'a> {
    pub records: &'a [Record],
    pub tables: &'a Undercuts,
    pub elements: Vec<Solved>,
    pub written: Written,
    /// Undercuts become the blocks that the editor writes.
    pub expanded: bool,
}

impl Generator<'_> {
    pub fn blocks(&mut self, begin: Begin, corner: Point2) -> Result<Contour, Unsolved> {
        self.shift_allowances()?;
        let corner = self
            .elements
            .first()
            .map_or(corner, |first| if first.typed.keys.dst.is_some() { first.from } else { corner });
        let mut contour = Contour { start: corner, start_record: begin.record, ..Contour::default() };
        let mut material = Material::beside(&self.elements);
        self.start_transition(begin, &mut contour, &mut material)?;
        for i in 0..self.elements.len() {
            let Some(element) = self.elements.get(i).copied() else { break };
            let next = self.elements.get(i + 1).copied();
            let transition = element.typed.transition.zip(next);
            let undercut = transition.and_then(|(record, next)| match self.records.get(record) {
                Some(Record::Undercut(undercut)) => Some((record, *undercut, next)),
                _ => None,
            });
            if let Some((record, undercut, next)) = undercut {
                if let Some((u, w)) = element.end_direction().zip(next.start_direction()) {
                    let corner = Corner { from: element.from, at: element.to, to: next.to };
                    self.lies_inside(u, w, record, &corner, &mut material, &mut contour)?;
                }
                self.undercut(&element, record, undercut, &next, &mut contour)?;
                continue;
            }
            if distance(element.from, element.to) <= SAME_POINT && element.arc.is_none() {
                continue;
            }
            let corner = match transition {
                Some((record, next)) => self.corner(&element, record, &next)?,
                None => None,
            };
            contour.blocks.push(ContourBlock {
                end: element.to,
                arc: element.arc,
                radius: None,
                corner,
                record: element.typed.record,
                corner_record: transition.map_or(element.typed.record, |(record, _)| record),
            });
        }
        Ok(contour)
    }

    /// Refuses an undercut at a convex edge, and notes one of which only its turn tells that it is none.
    fn lies_inside(
        &self,
        u: Vec2,
        w: Vec2,
        record: usize,
        corner: &Corner,
        material: &mut Material,
        contour: &mut Contour,
    ) -> Result<(), Unsolved> {
        if self.is_turned() && !material.take(u, w).map_err(|why| Unsolved::Undercut(record, why))? {
            contour.assumed.push((record, surface(corner)));
        }
        Ok(())
    }

    /// In the plane of Z and X; elsewhere lowering refuses undercuts.
    fn is_turned(&self) -> bool {
        let axes = self.records.iter().find_map(|record| match record {
            Record::Header { axes, .. } => *axes,
            _ => None,
        });
        axes.is_none_or(|axes| axes == (b'Z', b'X'))
    }

    /// The start point moves back, and the corner becomes a block of its own.
    fn start_transition(&self, begin: Begin, contour: &mut Contour, material: &mut Material) -> Result<(), Unsolved> {
        let (Some(record), Some(first)) = (begin.transition, self.elements.first()) else { return Ok(()) };
        let (word, back) = match (self.records.get(record), begin.keys.ase) {
            (Some(Record::Chamfer(leg)), Some(_)) if *leg > 0.0 => (CornerWord::Chamfer(*leg), *leg),
            (Some(Record::Rounding(radius)), Some(angle)) if *radius > 0.0 => {
                let Some(w) = first.start_direction() else { return Err(Unsolved::Open(record)) };
                let u = Deg(angle).unit();
                (CornerWord::Radius(*radius), radius * cross(u, w).abs() / (1.0 + u.dot(&w)))
            }
            (Some(Record::Undercut(undercut)), Some(angle)) => {
                return self.start_undercut(*undercut, record, Deg(angle).unit(), first, contour, material);
            }
            (Some(Record::Undercut(_)), None) => return Err(Unsolved::Undercut(record, NoUndercut::Start)),
            (Some(Record::Chamfer(size) | Record::Rounding(size)), None) if *size > 0.0 => {
                return Err(Unsolved::Open(record));
            }
            _ => return Ok(()),
        };
        let u = Deg(begin.keys.ase.unwrap_or(0.0)).unit();
        let corner = contour.start;
        contour.start = corner - u * back;
        contour.blocks.push(ContourBlock {
            end: corner,
            arc: None,
            radius: None,
            corner: Some(word),
            record,
            corner_record: record,
        });
        Ok(())
    }

    /// The contour starts where the undercut leaves the line in front of it; its other vertices are blocks. Of starts with
    /// a rounding or a chamfer the control does the like.
    fn start_undercut(
        &self,
        undercut: Form,
        record: usize,
        u: Vec2,
        first: &Solved,
        contour: &mut Contour,
        material: &mut Material,
    ) -> Result<(), Unsolved> {
        let refuse = |why| Unsolved::Undercut(record, why);
        let w = first.start_direction().filter(|_| first.arc.is_none()).ok_or(refuse(NoUndercut::Place))?;
        let corner = Corner { from: contour.start - u * LONG, at: contour.start, to: first.to };
        self.lies_inside(u, w, record, &corner, material, contour)?;
        let made = self.sized(undercut, &corner).map_err(refuse)?;
        let dst = first.typed.keys.dst.unwrap_or(0.0);
        let allowance = self.allowances(u, w, 0.0, dst);
        let list = self.vertices(&made, &corner, allowance).map_err(refuse)?;
        // On a line that is none a rounding has nowhere to begin.
        let Some(((start, 0.0), rest)) = list.split_first().map(|(first, rest)| (*first, rest)) else {
            return Err(refuse(NoUndercut::StartRounding));
        };
        contour.start = start;
        for (end, radius) in rest {
            let corner = (*radius > 0.0).then_some(CornerWord::Radius(*radius));
            contour.blocks.push(ContourBlock {
                end: *end,
                arc: None,
                radius: None,
                corner,
                record,
                corner_record: record,
            });
        }
        contour.start_undercut = Some(record);
        contour.doubts.extend(self.doubts(undercut, &corner).map(|doubts| (record, doubts)));
        Ok(())
    }

    /// The vertices of an undercut in its corner, each with its rounding, in the unit of the program.
    fn vertices(
        &self,
        made: &Undercut,
        corner: &Corner,
        allowance: Allowance,
    ) -> Result<Vec<(Point2, f64)>, NoUndercut> {
        let refuse = |_| NoUndercut::Corner;
        let orientation = Orientation::of(corner).map_err(refuse)?;
        let shape: Shape = if orientation.second > 0.0 { made.external } else { made.internal };
        let shape = shape.scaled(1.0 / self.written.unit);
        vertices(&shape, corner, Reference::First, allowance).map_err(refuse)
    }

    /// How far the lines at an undercut lie outside of the finished part, along the cylinder and along the face: the
    /// corner turns towards the air, and allowances count to the right.
    fn allowances(&self, u: Vec2, w: Vec2, before: f64, after: f64) -> Allowance {
        let outwards = if cross(u, w) > 0.0 { -1.0 } else { 1.0 };
        // The cylinder is the flatter of the two.
        let (reference, other) = if u.x.abs() >= u.y.abs() { (before, after) } else { (after, before) };
        Allowance { reference: outwards * reference, other: outwards * other }
    }

    fn corner(&self, element: &Solved, record: usize, next: &Solved) -> Result<Option<CornerWord>, Unsolved> {
        let Some((u, w)) = element.end_direction().zip(next.start_direction()) else { return Ok(None) };
        let smooth = Deg::from_radians(libm::atan2(cross(u, w).abs(), u.dot(&w))).0 < SAME_ANGLE;
        let beside = element.typed.keys.dst.unwrap_or(0.0) + next.typed.keys.dst.unwrap_or(0.0);
        Ok(match self.records.get(record) {
            Some(Record::Rounding(radius)) => (*radius > 0.0 && !smooth).then_some(CornerWord::Radius(*radius)),
            // A chamfer keeps its bevel where a neighbour carries an allowance: what was seen is an edge of 90 degrees.
            Some(Record::Chamfer(leg)) if *leg > 0.0 && beside != 0.0 => {
                if u.dot(&w).abs() > SQUARE || cross(u, w) < 0.0 || leg + beside <= 0.0 {
                    return Err(Unsolved::Open(record));
                }
                Some(CornerWord::Chamfer(leg + beside))
            }
            Some(Record::Chamfer(leg)) => (*leg > 0.0).then_some(CornerWord::Chamfer(*leg)),
            _ => None,
        })
    }

    fn undercut(
        &self,
        element: &Solved,
        record: usize,
        undercut: Form,
        next: &Solved,
        contour: &mut Contour,
    ) -> Result<(), Unsolved> {
        let refuse = |why| Unsolved::Undercut(record, why);
        if element.arc.is_some() || next.arc.is_some() {
            return Err(refuse(NoUndercut::Place));
        }
        let corner = Corner { from: element.from, at: element.to, to: next.to };
        let mut made = self.sized(undercut, &corner).map_err(refuse)?;
        let dst = |element: &Solved| element.typed.keys.dst.unwrap_or(0.0);
        let allowance = self.allowances(element.to - element.from, next.to - next.from, dst(element), dst(next));
        let unit = self.written.unit;
        made.allowance = Allowance { reference: unit * allowance.reference, other: unit * allowance.other };
        let block = ContourBlock {
            end: corner.at,
            arc: None,
            radius: None,
            corner: None,
            record: element.typed.record,
            corner_record: record,
        };
        if !self.expanded {
            contour.doubts.extend(self.doubts(undercut, &corner).map(|doubts| (record, doubts)));
            contour.blocks.push(ContourBlock { corner: Some(CornerWord::Undercut(made)), ..block });
            return Ok(());
        }
        for (end, radius) in self.vertices(&made, &corner, allowance).map_err(refuse)? {
            let corner = (radius > 0.0).then_some(CornerWord::Radius(radius));
            contour.blocks.push(ContourBlock { end, corner, ..block });
        }
        Ok(())
    }

    /// What is not confirmed about an undercut.
    fn doubts(&self, undercut: Form, corner: &Corner) -> Option<String> {
        match undercut {
            Form::E(index) | Form::F(index) => {
                let (_, sure) = editor_size(self.tables, index)?;
                (!sure).then(|| "the list of sizes by their index (`[undercut] din509_in_editor`)".to_owned())
            }
            Form::Thread { pitch, entry } => {
                let row = self.tables.thread(pitch?)?;
                let doubts = thread(self.tables, row, ThreadForm::of(surface(corner), false), Deg(entry?)).1;
                doubts.any().then(|| doubts.to_string())
            }
            Form::Free => None,
        }
    }

    /// The undercut with its dimensions.
    fn sized(&self, undercut: Form, corner: &Corner) -> Result<Undercut, NoUndercut> {
        let size = |index: u32| editor_size(self.tables, index).map(|(size, _)| size).ok_or(NoUndercut::Index(index));
        match undercut {
            Form::E(index) => size(index).map(|size| Undercut::new(form_e(size))),
            Form::F(index) => size(index).map(|size| Undercut::new(form_f(size))),
            Form::Thread { pitch, entry } => {
                // In millimetres or as a lead in inches: no contour of inches was ever seen.
                if self.written.unit != 1.0 {
                    return Err(NoUndercut::InchPitch);
                }
                let scale = if self.written.diameter { 2.0 } else { 1.0 };
                let diameter = scale * corner.at.y.abs();
                let pitch = pitch.ok_or(NoUndercut::PitchMissing { diameter, surface: surface(corner) })?;
                let row = self.tables.thread(pitch).ok_or(NoUndercut::Pitch(pitch))?;
                let angle = entry.filter(|angle| (30.0..=90.0).contains(angle)).ok_or(NoUndercut::Entry(entry))?;
                Ok(thread_by_contour(self.tables, row, false, Deg(angle)))
            }
            Form::Free => Err(NoUndercut::Free),
        }
    }

    /// Elements with a grinding allowance move to their right side and meet their neighbours anew.
    fn shift_allowances(&mut self) -> Result<(), Unsolved> {
        if self.elements.iter().all(|element| element.typed.keys.dst.unwrap_or(0.0) == 0.0) {
            return Ok(());
        }
        let lines: Option<Vec<(Point2, Vec2)>> = self
            .elements
            .iter()
            .map(|element| {
                let u = element.start_direction().filter(|_| element.arc.is_none())?;
                Some((element.from - left(u) * element.typed.keys.dst.unwrap_or(0.0), u))
            })
            .collect();
        let record = self.elements.first().map_or(0, |element| element.typed.record);
        // Beside arcs the editor's result was never seen.
        let lines = lines.ok_or(Unsolved::Open(record))?;
        for i in 0..lines.len() {
            let (Some(here), before, after) =
                (lines.get(i), i.checked_sub(1).and_then(|k| lines.get(k)), lines.get(i + 1))
            else {
                break;
            };
            let meet = |other: &(Point2, Vec2)| {
                intersect::lines(here.0, here.1, other.0, other.1, 1e-9).map(|(s, _)| here.0 + here.1 * s)
            };
            let Some(element) = self.elements.get_mut(i) else { break };
            let moved = here.0 - element.from;
            let ends = (before.map(meet), after.map(meet));
            if matches!(ends, (Some(None), _) | (_, Some(None))) {
                return Err(Unsolved::Open(element.typed.record));
            }
            element.to = ends.1.flatten().unwrap_or(element.to + moved);
            element.from = ends.0.flatten().unwrap_or(element.from + moved);
        }
        Ok(())
    }
}

/// The side of the part on which a corner lies; outside where it is none.
fn surface(corner: &Corner) -> Surface {
    match Orientation::of(corner) {
        Ok(orientation) if orientation.second < 0.0 => Surface::Internal,
        _ => Surface::External,
    }
}
