//! A contour that is described, not machined: its elements as they are completed, then the outline with recesses,
//! undercuts, chamfers and roundings in it.
//!
//! Points are (Z, X) with X as a radius, in mm.

use crate::diag::{Fault, codes};
use crate::geo::corner::{self, NoCut};
use crate::geo::open::{Rules, Solution, Solutions, Start};
use crate::geo::tolerance;
use crate::geo::{Element, Point2, SAME_POINT, arc, distance};
use crate::text::Loc;

use super::chain::{self, Chain, Choice, Data, RULES, Solved, by_distance, not_determined};
use super::element_data::Transition;
use super::forms::{self, Recess};
use super::sides::Form;
use super::undercuts::{self, Undercut};
use super::{Core, Outcome, Reported};

/// The largest contour a cycle takes.
pub(super) const MOST_EDGES: usize = 1_000;
/// Most elements of a contour.
const MOST: usize = 10_000;
/// How much an element may fall short of a cut, in mm.
const SHORT: f64 = 1e-6;

/// What to do about an element or undercut of a contour.
const CHECK: &str = "check this block and the blocks beside it";

/// What is known of a contour block besides its geometry.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    pub number: Option<u32>,
    pub loc: Loc,
    pub transition: Transition,
    /// Of two solutions the one that lies further from the start.
    pub far: bool,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub arc_tolerance: f64,
}

impl Choice for Mark {
    const RULES: Rules = RULES;

    fn choose(&self, start: &Start, _: Option<&Mark>, among: &Solutions) -> Result<Solution, chain::Fault> {
        by_distance(start, self.far, among)
    }
}

/// What G34 and G37 say of a thread, in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ThreadData {
    pub pitch: f64,
    /// Depth outside and inside.
    pub depth: [f64; 2],
}

/// A complete element, and what belongs to it.
#[derive(Debug, Clone)]
pub(super) struct BuiltElement {
    pub solved: Solved,
    pub mark: Mark,
    pub recesses: Vec<(Recess, Mark)>,
    /// Between this element and the next.
    pub undercut: Option<(Undercut, Mark)>,
    /// Codes of the recesses and of the undercut, by which D of a cycle leaves them out.
    pub codes: (Vec<u32>, u32),
    /// This element is a thread.
    pub thread: Option<ThreadData>,
}

/// A problem with a contour, and where it is.
#[derive(Debug, Clone)]
pub(super) struct Flaw {
    pub loc: Loc,
    pub fault: Fault,
}

impl Core<'_> {
    pub(super) fn flaw(&self, flaw: &Flaw) {
        self.report(flaw.fault.clone().at(flaw.loc));
    }

    /// What was made of a contour; reports the flaw where it was not.
    pub(super) fn flawless<T>(&self, result: Result<T, Flaw>) -> Outcome<T> {
        result.map_err(|flaw| {
            self.flaw(&flaw);
            Reported
        })
    }
}

/// A contour under construction.
#[derive(Debug, Default)]
pub(super) struct Builder {
    start: Option<Point2>,
    chain: Chain<Mark>,
    pub pieces: Vec<BuiltElement>,
    adjusted: Option<(f64, Loc)>,
}

impl Builder {
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty() && self.chain.is_empty()
    }

    pub fn has_start(&self) -> bool {
        self.start.is_some()
    }

    pub fn start(&mut self, at: Point2) {
        self.start = Some(at);
    }

    /// Where the next element starts.
    pub fn end(&self) -> Option<Point2> {
        self.pieces.last().map(|piece| piece.solved.to).or(self.start)
    }

    /// Adds an element.
    pub fn push(&mut self, data: Data, mark: Mark) -> Result<(), Flaw> {
        if self.pieces.len() >= MOST {
            return Err(Flaw { loc: mark.loc, fault: codes::T3003::contour_has_more_than_elements(&MOST) });
        }
        self.chain.push(data, mark);
        self.drain(false)
    }

    /// Nothing of what was pushed waits any more.
    pub fn settle(&mut self) -> Result<(), Flaw> {
        self.drain(true)
    }

    fn drain(&mut self, closed: bool) -> Result<(), Flaw> {
        while !self.chain.is_empty() {
            let Some(at) = self.end() else { return Ok(()) };
            let last = self.pieces.last();
            let open = last.is_none_or(|piece| piece.mark.transition == Transition::Open && piece.undercut.is_none());
            let dir = last.filter(|_| open).and_then(|piece| piece.solved.end_direction());
            match self.chain.next(&Start { at, dir, goes_on: true }, closed) {
                Ok(Some((solution, mark))) => {
                    let settled = self.settled(solution.solved, &mark);
                    if settled.is_err() {
                        self.chain.clear();
                    }
                    let solved = settled?;
                    self.pieces.push(BuiltElement {
                        solved,
                        mark,
                        recesses: Vec::new(),
                        undercut: None,
                        codes: (Vec::new(), 0),
                        thread: None,
                    });
                }
                Ok(None) => return Ok(()),
                Err((fault, mark)) => {
                    self.chain.clear();
                    return Err(Flaw { loc: mark.loc, fault: not_determined(fault).help(CHECK) });
                }
            }
        }
        Ok(())
    }

    /// An arc that is given twice, by its end and by its centre: the centre moves to where both ends lie on the circle.
    fn settled(&mut self, solved: Solved, mark: &Mark) -> Result<Solved, Flaw> {
        let Some((center, ccw)) = solved.arc.filter(|_| distance(solved.from, solved.to) > SAME_POINT) else {
            return Ok(solved);
        };
        let (start, end) = (distance(solved.from, center), distance(solved.to, center));
        let refuse = |fault| Err(Flaw { loc: mark.loc, fault });
        if start <= SAME_POINT || end <= SAME_POINT {
            return refuse(codes::T3051::arc_touches_its_centre());
        }
        let tolerance = mark.arc_tolerance;
        if (end - start).abs() > tolerance + 1e-9 {
            let apart = (end - start).abs();
            return refuse(codes::T3051::ends_of_arc_lie_on_two_circles(&start, &end, &apart, &tolerance));
        }
        let moved = arc::centered_between(solved.from, solved.to, center);
        let shift = distance(moved, center);
        if shift > tolerance::MOST_TURN * start {
            return refuse(codes::T3051::arc_is_nearly_full_circle(&(end - start).abs()));
        }
        if shift > self.adjusted.map_or(tolerance::UNNOTED, |(most, _)| most) {
            self.adjusted = Some((shift, mark.loc));
        }
        Ok(Solved { arc: Some((moved, ccw)), ..solved })
    }

    /// The largest shift of the centre of an arc that is worth a note, in mm, and where it is.
    pub fn adjusted(&self) -> Option<(f64, Loc)> {
        self.adjusted
    }

    /// The finished outline, without the forms whose codes are all in `left_out`.
    pub fn outline(&self, left_out: u32) -> Result<Outline, Flaw> {
        let mut rough = Vec::new();
        let mut skip_start: Option<Point2> = None;
        for (i, piece) in self.pieces.iter().enumerate() {
            let mut line = piece.solved;
            if let Some(from) = skip_start.take() {
                line.from = from;
            }
            let undercut = match &piece.undercut {
                Some(_) if is_left_out(piece.codes.1, left_out) => None,
                None => None,
                Some((undercut, mark)) => {
                    let next = self.pieces.get(i + 1).map(|next| next.solved);
                    let made = undercuts::build(undercut, &line, next.as_ref())
                        .map_err(|fault| Flaw { loc: mark.loc, fault: fault.help(CHECK) })?;
                    Some((made, *mark))
                }
            };
            let mut transition = piece.mark.transition;
            if let Some((made, mark)) = &undercut {
                if matches!(transition, Transition::Rounding(_) | Transition::Chamfer(_)) {
                    let fault = codes::T3004::undercut_after_chamfer_or_rounding();
                    return Err(Flaw { loc: mark.loc, fault });
                }
                line.to = made.leaves;
                transition = made.edge;
            }
            element_with_recesses(piece, line, transition, left_out, &mut rough)?;
            if let Some((made, mark)) = undercut {
                let next = self.pieces.get(i + 1).map(|next| next.solved);
                let form = Form::undercut(&piece.solved, next.as_ref(), mark.loc);
                for (element, transition) in made.elements {
                    rough.push(OutlinePart { element, transition, mark, corner_of: mark.number, form, thread: None });
                }
                skip_start = Some(made.joins);
            }
        }
        let outline = cut_corners(rough)?;
        outline.one_sided()?;
        Ok(outline)
    }
}

/// Is a form with these codes left out?
fn is_left_out(codes: u32, left_out: u32) -> bool {
    codes != 0 && codes & !left_out == 0
}

fn element_with_recesses(
    piece: &BuiltElement,
    line: Solved,
    transition: Transition,
    left_out: u32,
    out: &mut Vec<OutlinePart>,
) -> Result<(), Flaw> {
    let mut recesses: Vec<_> = Vec::new();
    let codes = piece.codes.0.iter().copied();
    for ((recess, mark), _) in piece.recesses.iter().zip(codes).filter(|(_, code)| !is_left_out(*code, left_out)) {
        let made = forms::build(recess, &line).map_err(|fault| Flaw { loc: mark.loc, fault })?;
        recesses.push((made, *mark));
    }
    let part = |element, transition| OutlinePart {
        element,
        transition,
        mark: piece.mark,
        corner_of: piece.mark.number,
        form: None,
        thread: piece.thread,
    };
    let way = |p: Point2| line.element().way_to(p);
    recesses.sort_by(|a, b| way(a.0.from).total_cmp(&way(b.0.from)));
    let mut from = line.from;
    for (made, mark) in recesses {
        if way(made.from) < way(from) - SHORT || way(made.to) > line.element().length() + SHORT {
            let fault = codes::T3004::recess_lies_beside_its_element();
            return Err(Flaw { loc: mark.loc, fault });
        }
        let element = Element::Line { from, to: made.from };
        out.push(OutlinePart { corner_of: mark.number, ..part(element, made.edges.0) });
        let form = Form::recess(&line, &made, mark.loc);
        for (element, transition) in made.elements {
            out.push(OutlinePart { element, transition, mark, corner_of: mark.number, form, thread: None });
        }
        from = made.to;
    }
    let element = if from == line.from { line.element() } else { Element::Line { from, to: line.to } };
    out.push(part(element, transition));
    Ok(())
}

/// An element before its corners are cut.
#[derive(Debug, Clone)]
struct OutlinePart {
    element: Element,
    transition: Transition,
    mark: Mark,
    thread: Option<ThreadData>,
    /// Block to which the chamfer or rounding at its end belongs.
    corner_of: Option<u32>,
    form: Option<Form>,
}

/// An element of the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    pub element: Element,
    /// Number of its block.
    pub number: Option<u32>,
    /// A chamfer or rounding at its end.
    pub corner: bool,
    /// The recess or undercut that it is part of.
    pub form: Option<Form>,
    pub thread: Option<ThreadData>,
}

/// A contour as it is to be machined.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Outline {
    pub edges: Vec<Edge>,
}

/// A part of an outline, in the order in which it is cut.
#[derive(Debug, Clone, Default)]
pub(super) struct Section {
    pub edges: Vec<Edge>,
    /// It is cut against the order of the outline.
    pub backwards: bool,
    /// The whole outline in its own order.
    pub whole: Vec<Element>,
}

impl Section {
    pub fn elements(&self) -> Vec<Element> {
        self.edges.iter().map(|edge| edge.element).collect()
    }
}

impl Outline {
    fn elements(&self) -> Vec<Element> {
        self.edges.iter().map(|edge| edge.element).collect()
    }

    /// All of it.
    pub fn all(&self) -> Section {
        Section { edges: self.edges.clone(), backwards: false, whole: Vec::new() }
    }

    /// The elements from the block `first` to the block `last`, turned around where `last` stands before `first` or
    /// is the same block. The number that is not found is the error.
    pub fn between(&self, first: u32, last: Option<u32>) -> Result<Section, u32> {
        let place = |number: u32| -> Result<(usize, usize), u32> {
            let belongs = |edge: &Edge| edge.number == Some(number);
            let from = self.edges.iter().position(belongs).ok_or(number)?;
            let to = self.edges.iter().rposition(belongs).ok_or(number)?;
            // A number that stands twice names no element.
            let once = self.edges[from..=to].iter().all(|edge| belongs(edge) || edge.form.is_some() || edge.corner);
            if once { Ok((from, to)) } else { Err(number) }
        };
        let (from, to) = place(first)?;
        let (last_from, last_to) = place(last.unwrap_or(first))?;
        let backwards = last == Some(first) || last_from < from;
        // The chamfer or rounding at the first element belongs to the block before it.
        let first = from.min(last_from);
        let first = if first > 0 && self.edges[first - 1].corner && self.edges[first - 1].form.is_none() {
            first - 1
        } else {
            first
        };
        let range = first..=to.max(last_to);
        let edges = self.edges[range].iter();
        let turned = |edge: &Edge| Edge { element: reversed(edge.element), form: edge.form.map(Form::turned), ..*edge };
        let edges = if backwards { edges.rev().map(turned).collect() } else { edges.copied().collect() };
        Ok(Section { edges, backwards, whole: self.elements() })
    }
}

/// The same element travelled the other way.
fn reversed(element: Element) -> Element {
    match element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    }
}

/// Puts the chamfers and roundings in.
fn cut_corners(parts: Vec<OutlinePart>) -> Result<Outline, Flaw> {
    let mut edges: Vec<Edge> = Vec::new();
    let mut parts = parts.into_iter().filter(|part| part.element.length() > SAME_POINT).peekable();
    let mut cut_from: Option<Point2> = None;
    while let Some(part) = parts.next() {
        let mut element = part.element;
        if let Some(from) = cut_from.take() {
            element = element.starting_at(from);
        }
        let edge =
            |element, corner| Edge { element, number: part.mark.number, corner, form: part.form, thread: part.thread };
        let size = match part.transition {
            Transition::Open | Transition::Sharp => {
                edges.push(edge(element, false));
                continue;
            }
            Transition::Rounding(r) | Transition::Chamfer(r) => r,
        };
        let Some(next) = parts.peek() else {
            let fault = codes::T3005::no_element_follows_corner();
            return Err(Flaw { loc: part.mark.loc, fault });
        };
        let result = match part.transition {
            Transition::Rounding(_) => corner::rounding(&element, &next.element, size, SHORT),
            _ => corner::chamfer(&element, &next.element, size, SHORT),
        };
        let made = result.map_err(|why| Flaw { loc: part.mark.loc, fault: no_cut(why) })?;
        let before = element.ending_at(made.leave);
        if before.length() > SAME_POINT {
            edges.push(edge(before, false));
        }
        if distance(made.leave, made.join) > SAME_POINT {
            edges.push(Edge { number: part.corner_of, ..edge(between_cuts(&made), true) });
        }
        cut_from = Some(made.join);
    }
    edges.retain(|edge| edge.element.length() > SAME_POINT);
    Ok(Outline { edges })
}

fn between_cuts(made: &corner::Cut) -> Element {
    let (from, to) = (made.leave, made.join);
    match made.arc {
        Some((center, ccw)) => Element::Arc { from, to, center, sweep: arc::sweep(from, to, center, ccw) },
        None => Element::Line { from, to },
    }
}

fn no_cut(why: NoCut) -> Fault {
    match why {
        NoCut::Straight => codes::T3005::no_corner_for_chamfer_or_rounding(),
        NoCut::Reversal => codes::T3005::contour_turns_back_at_corner(),
        NoCut::TooLarge => codes::T3005::corner_is_larger_than_element(),
        NoCut::Arc => codes::T3005::chamfer_between_lines_only(),
        NoCut::Degenerate => codes::T3005::element_beside_corner_has_no_length(),
    }
}
