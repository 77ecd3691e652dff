//! Pass 2: chamfers and roundings between two elements. Holds back one element.

use crate::diag::{Code, Diagnostic, Diags, Fault, Label, codes};
use crate::geo::corner::{self, Cut, NoCut, Size};
use crate::geo::{Element, SAME_POINT, arc, distance};
use crate::ir::contour::{ArcChamfer, Blocks, Corner, CornerShape, LargeCorner};
use crate::ir::function::Spindle;
use crate::ir::motion::{Arc, Path};
use crate::ir::undercut::Undercut;
use crate::ir::{Feed, Function, Origin, Side};

use super::step::{Event, Step, plane_axes};
use super::{at, undercut};

/// How much an element may fall short of the cut, in mm: what rounding of the source loses.
const SHORT: f64 = 1e-6;
/// How much of a corner may be missing in any program, in mm: what a source rounded to three decimals loses.
const HAIR: f64 = 1e-3;
/// Functions and comments that may stand on either side of a corner.
const MOST_BETWEEN: usize = 256;

/// The element before a corner, what is put between, and the element after.
type Pieces = (Step, Option<Step>, Step);

/// The element that waits for its successor, and the corner between them.
#[derive(Debug, Default)]
pub struct Corners {
    /// One waits, the other is being made; which is which alternates, so that none is copied.
    steps: [Step; 2],
    /// Index of the one that waits.
    waiting: usize,
    held: bool,
    corner: Option<(Corner, Origin)>,
    /// What came after the element that waits: a corner may follow.
    behind: Vec<(Function, Origin)>,
    /// What came after the corner.
    between: Vec<(Function, Origin)>,
    /// The element before was refused: that a corner misses it is not worth another error.
    orphaned: bool,
    /// The element that waits was shortened by the corner before it.
    trimmed: bool,
    /// The element that waits is the first one on its side.
    begins: bool,
}

impl Corners {
    /// Where the next element is made.
    #[inline]
    pub fn slot(&mut self) -> &mut Step {
        &mut self.steps[self.waiting ^ 1]
    }

    /// The element in [`Corners::slot`] is complete. The tool may stand `beside` where the last one ended.
    #[inline(always)]
    pub fn push(&mut self, beside: bool, diags: &Diags, out: &mut impl FnMut(Event<'_>)) {
        // An element that goes nowhere is no neighbour of a corner. Where the tool stands beside the contour, it goes there.
        let slot = &self.steps[self.waiting ^ 1];
        let goes_there = beside && slot.mv.side == Side::None;
        if self.held && !goes_there && self.steps[self.waiting ^ 1].rests_behind(&self.steps[self.waiting]) {
            return;
        }
        if self.corner.is_some() {
            self.cut(diags, out);
            return;
        }
        self.trimmed = false;
        self.orphaned = false;
        self.begins = self.steps[self.waiting ^ 1].mv.side != self.steps[self.waiting].mv.side;
        if self.held {
            out(Event::Step(&self.steps[self.waiting]));
            send(&mut self.behind, out);
        }
        self.waiting ^= 1;
        self.held = true;
    }

    pub fn corner(&mut self, corner: Corner, origin: Origin, diags: &Diags, out: &mut impl FnMut(Event<'_>)) {
        if !self.held {
            if corner.modal || self.orphaned {
                return;
            }
            diags.push(at(origin, codes::G3007::no_contour_element_stands_before_this_chamfer()));
            return;
        }
        if let Some((_, first)) = self.corner {
            diags.push(
                at(origin, codes::G3007::two_chamfers_or_roundings_follow_each_other())
                    .also(first.loc, Label::FirstOne),
            );
            self.drop_corner(out);
            return;
        }
        self.corner = Some((corner, origin));
    }

    pub fn function(&mut self, function: &Function, origin: &Origin, diags: &Diags, out: &mut impl FnMut(Event<'_>)) {
        let breaks = matches!(
            function,
            Function::ToolChange { .. }
                | Function::End { .. }
                | Function::WorkOffset(_)
                | Function::Plane(_)
                | Function::Transformation(_)
                | Function::Tilt(_)
        );
        let waiting = if self.corner.is_some() { &mut self.between } else { &mut self.behind };
        if self.held && !breaks && waiting.len() < MOST_BETWEEN {
            waiting.push((function.clone(), *origin));
            return;
        }
        self.flush(diags, out);
        out(Event::Function(function, *origin));
    }

    /// Sends what is held; a corner that waits has no second neighbour.
    pub fn flush(&mut self, diags: &Diags, out: &mut impl FnMut(Event<'_>)) {
        if let Some((_, origin)) = self.corner.filter(|(corner, _)| !corner.modal) {
            diags.push(at(origin, codes::G3007::no_contour_element_stands_behind_this_chamfer()));
        }
        self.drop_corner(out);
    }

    /// Sends what is held after an error: a corner that waits goes with it.
    pub fn abandon(&mut self, out: &mut impl FnMut(Event<'_>)) {
        self.orphaned = true;
        self.drop_corner(out);
    }

    fn drop_corner(&mut self, out: &mut impl FnMut(Event<'_>)) {
        self.corner = None;
        if std::mem::take(&mut self.held) {
            out(Event::Step(&self.steps[self.waiting]));
        }
        send(&mut self.behind, out);
        send(&mut self.between, out);
    }

    /// The second neighbour is here.
    fn cut(&mut self, diags: &Diags, out: &mut impl FnMut(Event<'_>)) {
        let Some((corner, origin)) = self.corner.take() else { return };
        if let Some(found) = self.at_border(origin) {
            diags.push(found);
        }
        self.begins = false;
        if let CornerShape::Undercut(undercut) = corner.shape {
            self.undercut(&undercut, corner.feed, origin, diags, out);
            return;
        }
        let (before, after) = (self.waiting, self.waiting ^ 1);
        let trimmed = std::mem::take(&mut self.trimmed);
        let made = self
            .admit_blocks(&corner, origin, diags)
            .and_then(|()| cut(&self.steps[before], &self.steps[after], &corner, origin, trimmed, diags))
            .and_then(|made| exact(made, origin));
        match made {
            Ok((shortened, inserted, rest)) => {
                self.trimmed = true;
                out(Event::Step(&shortened));
                send(&mut self.behind, out);
                if corner.early {
                    send(&mut self.between, out);
                }
                if let Some(inserted) = inserted {
                    out(Event::Step(&inserted));
                }
                self.steps[after] = rest;
            }
            Err(found) => {
                // Where a refused block left no start, that was said already.
                let suffers = diags.has_errors() && !self.steps[before].start_is_known();
                if !(suffers || corner.modal && silent(found.code)) {
                    diags.push(*found);
                }
                out(Event::Step(&self.steps[before]));
                send(&mut self.behind, out);
            }
        }
        send(&mut self.between, out);
        self.waiting = after;
    }

    /// A corner beside the way to a contour whose path is computed, or beside the way from it: whether the control offsets
    /// that way like an element is not known.
    fn at_border(&self, origin: Origin) -> Option<Diagnostic> {
        let (before, after) = (&self.steps[self.waiting], &self.steps[self.waiting ^ 1]);
        let on = if before.mv.side == Side::None { after } else { before };
        let rules = on.ctx.compensation.as_ref().filter(|rules| !rules.rounded_border && rules.radius > 0.0);
        let enters = self.begins && before.mv.side != Side::None;
        if rules.is_none() || !enters && before.mv.side == after.mv.side {
            return None;
        }
        let what = if enters { "first" } else { "last" };
        let found = at(origin, codes::G3217::chamfer_or_rounding_stands_at_point(&what));
        Some(found.also(before.origin.loc, Label::ElementBefore))
    }

    /// Looks at the blocks between the corner and its elements that move nothing.
    fn admit_blocks(&self, corner: &Corner, origin: Origin, diags: &Diags) -> Result<(), Box<Diagnostic>> {
        match corner.blocks {
            Blocks::PassedOver => return Ok(()),
            Blocks::Unconfirmed => {}
        }
        let element = |step: &Step| step.origin.loc;
        let (before, after) = (&self.steps[self.waiting], &self.steps[self.waiting ^ 1]);
        let of_its_own = |(function, at): &&(Function, Origin)| {
            let loc = at.loc;
            loc != element(before)
                && loc != element(after)
                && loc != origin.loc
                && !matches!(function, Function::Comment(_) | Function::Remark(_) | Function::PathControl(_))
        };
        let found: Vec<_> = self.behind.iter().chain(&self.between).filter(of_its_own).collect();
        let plain = |(function, _): &&&(Function, Origin)| {
            matches!(
                function,
                Function::Coolant(_) | Function::Aux(_) | Function::Spindle(Spindle::Start(_) | Spindle::Stop)
            )
        };
        if let Some((_, block)) = found.iter().find(|entry| !plain(entry)) {
            let found = at(origin, codes::G3007::block_that_does_not_move_stands_between());
            return Err(Box::new(found.also(block.loc, Label::ThisBlock)));
        }
        if let Some((_, block)) = found.first() {
            let found = at(origin, codes::G3090::block_of_m_functions_stands_between_chamfer());
            diags.push(found.also(block.loc, Label::ThisBlock));
        }
        Ok(())
    }
}

impl Corners {
    /// The second neighbour of an undercut is here.
    fn undercut(
        &mut self,
        undercut: &Undercut,
        feed: Option<Feed>,
        origin: Origin,
        diags: &Diags,
        out: &mut impl FnMut(Event<'_>),
    ) {
        let (before, after) = (self.waiting, self.waiting ^ 1);
        self.trimmed = false;
        let made = undercut::relieve(&self.steps[before], &self.steps[after], undercut, feed, origin, diags);
        let exact = |(steps, rest): (Vec<Step>, Step)| {
            steps.iter().chain([&rest]).try_for_each(|step| step.is_exact(origin))?;
            Ok((steps, rest))
        };
        match made.and_then(exact) {
            Ok((steps, rest)) => {
                for step in &steps {
                    out(Event::Step(step));
                    // The first one is what is left of the element before.
                    send(&mut self.behind, out);
                }
                self.trimmed = true;
                self.steps[after] = rest;
            }
            Err(found) => {
                diags.push(*found);
                out(Event::Step(&self.steps[before]));
            }
        }
        send(&mut self.behind, out);
        send(&mut self.between, out);
        self.waiting = after;
    }
}

/// Sends what waited, in its order.
#[inline(always)]
fn send(waiting: &mut Vec<(Function, Origin)>, out: &mut impl FnMut(Event<'_>)) {
    if !waiting.is_empty() {
        send_all(waiting, out);
    }
}

#[inline(never)]
fn send_all(waiting: &mut Vec<(Function, Origin)>, out: &mut impl FnMut(Event<'_>)) {
    for (function, origin) in waiting.drain(..) {
        out(Event::Function(&function, origin));
    }
}

/// Reasons for which a rounding at every corner leaves one out without a word: there is no corner in the plane.
fn silent(code: &Code) -> bool {
    [codes::G3007, codes::G3009, codes::G3016].contains(&code)
}

/// Looks at what a corner made of elements that lie far out.
fn exact(made: Pieces, origin: Origin) -> Result<Pieces, Box<Diagnostic>> {
    let (shortened, inserted, rest) = &made;
    [shortened, rest].into_iter().chain(inserted).try_for_each(|step| step.is_exact(origin))?;
    Ok(made)
}

/// The element before, what is put between, and the element after.
fn cut(
    before: &Step,
    after: &Step,
    corner: &Corner,
    origin: Origin,
    trimmed: bool,
    diags: &Diags,
) -> Result<Pieces, Box<Diagnostic>> {
    let plane = after.ctx.plane;
    let name = match corner.shape {
        CornerShape::Rounding { .. } => &"rounding",
        CornerShape::Chamfer { .. } | CornerShape::ChamferLength { .. } => &"chamfer",
        CornerShape::Undercut(_) => &"undercut",
    };
    let refuse = |fault| {
        let found = at(origin, fault);
        Err(Box::new(found.also(before.origin.loc, Label::ElementBefore).also(after.origin.loc, Label::ElementAfter)))
    };
    if before.ctx.frame != after.ctx.frame {
        return refuse(codes::G3019::coordinate_system_changes(name));
    }
    if before.plane() != plane || after.plane() != plane {
        return refuse(codes::G3016::elements_lie_in_different_planes(name));
    }
    if before.mv.machine || after.mv.machine {
        return refuse(codes::G3007::block_in_machine_coordinates_cannot_be_next(name));
    }
    for (step, which) in [(before, "before"), (after, "after")] {
        if step.leaves(plane) {
            return refuse(codes::G3007::block_moves_axis_outside_working_plane(&which, name));
        }
        if matches!(step.mv.path, Path::Thread { .. }) {
            return refuse(codes::G3007::block_is_thread(&which, name));
        }
    }
    let (Some(a), Some(b)) = (before.element(plane), after.element(plane)) else {
        return refuse(codes::G3007::start_of_element_before_is_not_known(name));
    };
    let mut result = make(&a, &b, corner.shape, corner.at_arc);
    if result == Err(NoCut::TooLarge)
        && let Some(shape) = shortened(&a, &b, corner)
    {
        result = make(&a, &b, shape, corner.at_arc);
        if result.is_ok() {
            let less = extent(corner.shape) - extent(shape);
            let fault = if less <= HAIR {
                codes::G3025::is_larger_than_its_neighbours_allow(name, &less)
            } else {
                let large = too_large(corner, &a, &b, trimmed).into_parts().message;
                codes::G3025::is_made_smaller(&large, &length(extent(shape)))
            };
            diags.push(at(origin, fault));
        }
    }
    let made = match result {
        Ok(made) => made,
        Err(NoCut::TooLarge) => {
            let fault = too_large(corner, &a, &b, trimmed);
            return refuse(match corner.large {
                LargeCorner::Ask(ask) => fault.help(ask.help()),
                LargeCorner::Refuse | LargeCorner::Shorten => fault,
            });
        }
        Err(NoCut::Arc) => {
            let fault = codes::G3010::chamfer_is_possible_between_straight_lines();
            return refuse(match corner.at_arc {
                ArcChamfer::Ask(ask) => fault.help(ask.help()),
                ArcChamfer::Refuse | ArcChamfer::AcrossBisector | ArcChamfer::Along => fault,
            });
        }
        Err(NoCut::Reversal) => return refuse(codes::G3017::contour_turns_back_on_itself(name)),
        Err(NoCut::Degenerate) if trimmed && corner.large == LargeCorner::Shorten => {
            return refuse(codes::G3025::corner_before_left_nothing(name));
        }
        Err(NoCut::Degenerate) => return refuse(codes::G3007::element_has_no_length_in_plane(name)),
        Err(NoCut::Straight) => return refuse(codes::G3009::there_is_no_corner(name)),
    };
    let feed = corner.feed.or(after.mv.path.feed()).or(before.mv.path.feed());
    if feed.is_none() && made.arc.is_some() {
        return refuse(codes::G3024::lies_between_two_blocks_at_rapid(name));
    }
    Ok(pieces(before, after, feed, origin, &made))
}

fn make(before: &Element, after: &Element, shape: CornerShape, at_arc: ArcChamfer) -> Result<Cut, NoCut> {
    let lines = matches!((before, after), (Element::Line { .. }, Element::Line { .. }));
    let across = !lines && at_arc == ArcChamfer::AcrossBisector;
    match shape {
        CornerShape::Chamfer { side } if across => corner::chamfer_at_arc(before, after, Size::Side(side), SHORT),
        CornerShape::ChamferLength { length } if across => {
            corner::chamfer_at_arc(before, after, Size::Length(length), SHORT)
        }
        CornerShape::Chamfer { side } if !lines && at_arc == ArcChamfer::Along => {
            corner::chamfer_along(before, after, side, SHORT)
        }
        CornerShape::Rounding { radius } => corner::rounding(before, after, radius, SHORT),
        CornerShape::Chamfer { side } => corner::chamfer(before, after, side, SHORT),
        CornerShape::ChamferLength { length } => corner::chamfer_of_length(before, after, length, SHORT),
        // Undercuts take another way, which puts in more than one element.
        CornerShape::Undercut(_) => Err(NoCut::Degenerate),
    }
}

/// The largest corner of this kind that fits; `None` where it may not be made smaller that far.
#[cold]
fn shortened(before: &Element, after: &Element, corner: &Corner) -> Option<CornerShape> {
    let size = match corner.shape {
        CornerShape::Rounding { radius } => Size::Radius(radius),
        CornerShape::Chamfer { side } => Size::Side(side),
        CornerShape::ChamferLength { length } => Size::Length(length),
        CornerShape::Undercut(_) => return None,
    };
    let whole = extent(corner.shape);
    let left = whole * corner::largest(before, after, size, SHORT);
    if left <= SHORT || corner.large != LargeCorner::Shorten && whole - left > HAIR {
        return None;
    }
    Some(match size {
        Size::Radius(_) => CornerShape::Rounding { radius: left },
        Size::Side(_) => CornerShape::Chamfer { side: left },
        Size::Length(_) => CornerShape::ChamferLength { length: left },
    })
}

/// The number that gives the size of a corner.
fn extent(shape: CornerShape) -> f64 {
    match shape {
        CornerShape::Rounding { radius: size }
        | CornerShape::Chamfer { side: size }
        | CornerShape::ChamferLength { length: size } => size,
        CornerShape::Undercut(_) => 0.0,
    }
}

/// What a corner would need, and what there is.
#[cold]
fn too_large(corner: &Corner, before: &Element, after: &Element, trimmed: bool) -> Fault {
    let (a, b) = (length(before.length()), length(after.length()));
    let (name, cut) = match corner.shape {
        CornerShape::Rounding { radius } => (format!("rounding of radius {}", length(radius)), Size::Radius(radius)),
        CornerShape::Chamfer { side } => (format!("chamfer of {}", length(side)), Size::Side(side)),
        CornerShape::ChamferLength { length: own } => (format!("chamfer of {}", length(own)), Size::Length(own)),
        // Undercuts say themselves what they need.
        CornerShape::Undercut(_) => return codes::G3008::does_not_fit(&"undercut", &a, &b),
    };
    match (corner::cut_off(before, after, cut).map(length), trimmed) {
        (Some(back), false) => codes::G3008::needs_mm_of_each_neighbour(&name, &back, &a, &b),
        (Some(back), true) => codes::G3008::needs_mm_of_each_neighbour_after_corner(&name, &back, &a, &b),
        (None, false) => codes::G3008::does_not_fit(&name, &a, &b),
        (None, true) => codes::G3008::does_not_fit_after_corner(&name, &a, &b),
    }
}

/// A length for a message: four decimals, no trailing zeros.
fn length(mm: f64) -> String {
    let text = format!("{mm:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn pieces(before: &Step, after: &Step, feed: Option<Feed>, origin: Origin, made: &Cut) -> Pieces {
    let plane = after.ctx.plane;
    let trim = |step: &Step, element: Element| {
        let mut step = step.clone();
        step.start.set_in_plane(plane, element.from());
        step.mv.end.set_in_plane(plane, element.to());
        step.mv.axes = step.mv.axes.union(plane_axes(plane));
        if let (Path::Arc(arc, _), Element::Arc { from, sweep, .. }) = (&mut step.mv.path, element) {
            arc.from = from;
            arc.sweep = sweep;
        }
        step
    };
    // Both were looked at in this plane before the cut was made.
    let (Some(a), Some(b)) = (before.element(plane), after.element(plane)) else {
        return (before.clone(), None, after.clone());
    };
    let first = trim(before, a.ending_at(made.leave));
    let rest = trim(after, b.starting_at(made.join));
    let mut inserted = first.clone();
    inserted.start = first.mv.end;
    inserted.mv.end.set_in_plane(plane, made.join);
    inserted.mv.axes = plane_axes(plane);
    inserted.origin = origin;
    inserted.mv.path = match (made.arc, feed) {
        (Some((center, ccw)), Some(feed)) => {
            let sweep = arc::sweep(made.leave, made.join, center, ccw);
            Path::Arc(Arc { plane, from: made.leave, center, sweep }, feed)
        }
        // An arc without a feed was refused before.
        (_, feed) => Path::straight(feed),
    };
    let any = distance(made.leave, made.join) > SAME_POINT;
    (first, any.then_some(inserted), rest)
}
