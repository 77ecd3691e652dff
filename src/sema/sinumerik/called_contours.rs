//! Cycles that take a contour: CYCLE62 calls it, CYCLE95, CYCLE952, CYCLE63, CYCLE64 and CYCLE72 work along it.
//!
//! The contour is run and checked, and the arguments are; then the cycle is refused by name, because its tracks are not
//! published. Source: C 1.12, 5.2 to 5.6 and 7 (docs/sources.md).

use crate::diag::{Diagnostic, Fault, Label, codes};
use crate::geo::arc::Closing;
use crate::geo::{Element, Plane};
use crate::ir::captured::{Captured, CapturedKind, Unfit};
use crate::parser::sinumerik::ast::Search;
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row::{Kind, Name};
use crate::sema::run::{Where, step};

use super::capture::Capture;
use super::cycles::{KNAME, LAB1, LAB2, NPP, Source, TYPE};
use super::named_contour::{CalledContour, ContourCall, MOST_ELEMENTS};
use super::programs::Units;
use super::{Core, Outcome, Reported, Run, levels};

/// Most contours of one machining cycle.
const MOST_CONTOURS: usize = 100;
/// Blocks of a contour for stock removal, its start counted (alarm 10933).
const LEAST_BLOCKS: usize = 3;

/// The contours that the next machining cycle takes.
#[derive(Debug, Default)]
pub(super) struct Contours {
    list: Vec<ContourCall>,
    /// A machining cycle took them: the next call begins a new list.
    taken: bool,
}

impl Contours {
    /// CYCLE62: one more contour, or the first of the next cycle.
    pub fn add(&mut self, call: &ContourCall) -> Result<(), Fault> {
        if std::mem::take(&mut self.taken) {
            self.list.clear();
        }
        if self.list.len() >= MOST_CONTOURS {
            return Err(codes::P2090::there_are_too_many_contours());
        }
        self.list.push(call.clone());
        Ok(())
    }
}

/// A cycle whose tracks the control keeps to itself.
pub(super) fn unpublished(given: &Given, contours: &[CalledContour]) -> Fault {
    let what = given.signature.what;
    let shown = contours.iter().map(|of| shape(&of.call.name, &of.made)).collect::<Vec<_>>().join("; ");
    if contours.is_empty() {
        codes::S9020::cycle_is_not_supported(&given.called, &what)
    } else {
        codes::S9020::cycle_is_read_without_fault(&given.called, &what, &shown)
    }
}

impl Run<'_> {
    /// Runs the blocks of a contour. Afterwards everything is as before, and the position in it is its own: a contour does not depend
    /// on where the tool stands.
    pub(super) fn capture(&mut self, call: &ContourCall) -> Outcome<Captured> {
        let channel = &mut self.channel;
        let here = channel.core.here;
        let back = channel.core.program().source.cursor.place();
        let (state, vars) = (channel.st.clone(), self.vars.clone());
        channel.st.begin_contour();
        channel.capture = Some(Capture::above(channel.core.levels.len(), &call.name));
        let counted = channel.core.contour_begins(MOST_ELEMENTS, &channel.st.ctx);
        let entered = match call.part {
            // Blocks of the program that calls see its variables.
            Some((from, stop)) if call.unit == levels::unit(&channel.core.levels) => {
                channel.core.enter_section(from, stop, 1)
            }
            part => self.call(call.unit, Vec::new(), 1, false, part),
        };
        while entered.is_ok()
            && self.channel.capture.as_ref().is_some_and(|capture| capture.goes_on(&self.channel.core))
            && !self.channel.core.has_ended()
        {
            step(self);
        }
        let pending = self.channel.pending_must_be_done(Where::Block);
        let capture = self.channel.capture.take();
        let core = &mut self.channel.core;
        let made = core.contour_ends(counted, &here.origin);
        core.here = here;
        self.channel.st = state;
        self.vars.restore(vars);
        entered?;
        pending?;
        let complete =
            capture.and_then(|capture| capture.is_complete()).filter(|_| !core.has_ended()).ok_or(Reported)?;
        if !complete || core.program().source.cursor.place() != back {
            core.stop_run();
            return core.refuse(Where::Block, call.fault("the program jumps out of the contour"));
        }
        made.map_err(|unfit| {
            if let Some(found) = call.unfit(unfit) {
                core.report(found);
            }
            Reported
        })
    }

    /// The contours of a cycle, each run and checked.
    pub(super) fn contours_of(&mut self, given: &Given, source: Source) -> Outcome<Vec<CalledContour>> {
        let core = &mut self.channel.core;
        let named = match source {
            Source::Argument => true,
            Source::Single => given.text(KNAME).is_some(),
            Source::Turned | Source::Milled => false,
        };
        let calls = if named {
            vec![self.units.named_contour(core, given)?]
        } else {
            self.contours.taken = true;
            self.contours.list.clone()
        };
        if let Err(fault) = fits(source, calls.len()) {
            // An argument may name it.
            let place = if source == Source::Single && calls.is_empty() { given.place_of(KNAME) } else { given.place };
            return core.refuse(place, fault.of(&given.called));
        }
        let count = calls.len();
        let mut made = Vec::with_capacity(count);
        for (at, call) in calls.into_iter().enumerate() {
            let closed = match source {
                Source::Turned if count == 2 && at == 0 => Some(61739),
                Source::Milled => Some(61931),
                _ => None,
            };
            let captured = self.capture(&call);
            let core = &self.channel.core;
            let checked = captured.and_then(|contour| match check_contour(source, &call, &contour, closed) {
                Ok(()) => Ok(contour),
                Err(Wrong::Contour(fault)) => core.refuse(given.place, fault),
                Err(Wrong::Element(found)) => {
                    core.report(*found);
                    Err(Reported)
                }
            });
            match checked {
                Ok(contour) => made.push(CalledContour { call, made: contour }),
                // The next one may show more.
                Err(Reported) if !core.has_ended() => {}
                Err(reported) => return Err(reported),
            }
        }
        if made.len() < count { Err(Reported) } else { Ok(made) }
    }
}

impl Units {
    /// The contour that CYCLE62 names: a program, or the blocks between two labels.
    pub(super) fn contour_of_call(&mut self, core: &mut Core<'_>, given: &Given) -> Outcome<ContourCall> {
        let (name, first, last) = (given.text(KNAME), given.text(LAB1), given.text(LAB2));
        match (given.whole(TYPE), name, first, last) {
            (0, Some(name), None, None) => self.contour_program(core, given, KNAME, name),
            (1, Some(name), None, None) => {
                let labels = (format!("E_LAB_A_{name}"), format!("E_LAB_E_{name}"));
                let unit = levels::unit(&core.levels);
                self.contour_between(core, given, unit, name, (&labels.0, &labels.1), KNAME)
            }
            (2, None, Some(first), Some(last)) => {
                let unit = levels::unit(&core.levels);
                self.contour_between(core, given, unit, &format!("{first} to {last}"), (first, last), LAB1)
            }
            (3, Some(name), Some(first), Some(last)) => {
                let unit = self.find_program(core, name, given.place_of(KNAME).span())?;
                self.contour_between(core, given, unit, &format!("{first} to {last} of {name}"), (first, last), LAB1)
            }
            _ => core.refuse(given.place_of(TYPE), codes::P2090::type_name().of(&given.called)),
        }
    }

    /// `"NAME"` or `"LABEL1:LABEL2"`.
    fn named_contour(&mut self, core: &mut Core<'_>, given: &Given) -> Outcome<ContourCall> {
        let key = if given.takes(NPP) { NPP } else { KNAME };
        let Some(name) = given.text(key) else {
            return core.refuse(given.place_of(key), codes::P2090::no_contour_is_named().of(&given.called));
        };
        match name.split_once(':') {
            None => self.contour_program(core, given, key, name),
            Some((first, last)) => {
                let unit = levels::unit(&core.levels);
                self.contour_between(core, given, unit, name, (first.trim(), last.trim()), key)
            }
        }
    }

    fn contour_program(&mut self, core: &mut Core<'_>, given: &Given, key: Name, name: &str) -> Outcome<ContourCall> {
        let unit = self.find_program(core, name, given.place_of(key).span())?;
        Ok(ContourCall { unit, part: None, name: name.to_owned(), loc: core.loc(given.place) })
    }

    /// The blocks from one label to another of a program. The block of the last label belongs to it.
    fn contour_between(
        &mut self,
        core: &mut Core<'_>,
        given: &Given,
        unit: usize,
        name: &str,
        labels: (&str, &str),
        key: Name,
    ) -> Outcome<ContourCall> {
        let skeleton = self.skeleton_of(core, unit, given.place)?;
        let mut find = |label: &str, from: u32| {
            let name = core.symbols.intern(label.as_bytes());
            skeleton
                .label(name, from, Search::Forward)
                .or_else(|| skeleton.label(name, from, Search::Backward).filter(|mark| mark.place.at >= from))
        };
        let start = find(labels.0, self.list[unit].start.at);
        let end = start.and_then(|start| find(labels.1, start.place.at));
        if let (Some(start), Some(end)) = (start, end) {
            let part = Some((start.place, end.after.at));
            return Ok(ContourCall { unit, part, name: name.to_owned(), loc: core.loc(given.place) });
        }
        let missing = if start.is_none() { labels.0 } else { labels.1 };
        let known: Vec<&str> = skeleton.labels().map(|label| core.symbols.name(label)).collect();
        let help = match crate::machine::tree::did_you_mean(missing, known) {
            Some(like) if like == missing => "it stands before the label of the start".to_owned(),
            Some(like) => format!("did you mean `{like}`?"),
            None => format!("write `{missing}:` before the contour, or after it"),
        };
        let behind = if start.is_some() { " after the label of the start" } else { "" };
        let fault = codes::S2091::there_is_no_label(&missing, &behind, &self.list[unit].name);
        core.refuse(given.place_of(key), fault.help(help))
    }
}

/// Does the cycle take that many contours?
fn fits(source: Source, count: usize) -> Result<(), Fault> {
    Err(match (source, count) {
        (Source::Single, 0) => codes::P2090::no_contour_is_named(),
        (Source::Single, 2..) => codes::P2090::more_than_one_contour_is_called(),
        (Source::Turned, 0) => codes::P2090::no_contour_is_called().alarm(61701),
        (_, 0) => codes::P2090::no_contour_is_called().alarm(61930),
        (Source::Turned, 3..) => codes::P2090::more_than_two_contours_are_called(),
        _ => return Ok(()),
    })
}

/// Is the contour one that a cycle of `source` takes? `closed` is the alarm of one that has to be closed.
fn check_contour(source: Source, call: &ContourCall, contour: &Captured, closed: Option<u32>) -> Result<(), Wrong> {
    let turned = matches!(source, Source::Argument | Source::Turned);
    if turned && contour.plane != Plane::Zx {
        return Err(Wrong::Contour(call.fault("it does not lie in the plane of Z and X (G18)")));
    }
    if source == Source::Argument && contour.pieces.len() + 1 < LEAST_BLOCKS {
        return Err(Wrong::Contour(call.fault("it has fewer than 3 blocks with moves").alarm(10933)));
    }
    if contour.pieces.is_empty() {
        return Err(Wrong::Contour(call.fault("it has no element").alarm(61930)));
    }
    check_elements(call, contour).map_err(Wrong::Element)?;
    match closed {
        Some(alarm) if !contour.is_closed() => {
            let what = if turned { "the contour of the blank is not closed" } else { "it is not closed" };
            Err(Wrong::Contour(call.fault(what).alarm(alarm)))
        }
        _ => Ok(()),
    }
}

/// What is wrong with a contour: as the cycle takes it, or at one of its elements.
enum Wrong {
    Contour(Fault),
    Element(Box<Diagnostic>),
}

/// Lines and arcs at feed that do not cross.
pub(super) fn check_elements(call: &ContourCall, contour: &Captured) -> Result<(), Box<Diagnostic>> {
    let turned = contour.plane == Plane::Zx;
    for piece in &contour.pieces {
        let full = matches!(piece.element, Element::Arc { from, to, .. }
            if crate::geo::arc::closing(to - from) == Closing::Closed);
        let fault = match piece.kind {
            CapturedKind::Rapid => codes::S2091::rapid_traverse_inside_contour(),
            CapturedKind::Thread => codes::S2091::thread_inside_contour(),
            CapturedKind::Cut if turned && full => codes::S2091::full_circle_inside_turned_contour(),
            CapturedKind::Cut => continue,
        };
        let found = fault.at(piece.origin.loc).called(piece.origin.call);
        return Err(Box::new(found.also(call.loc, Label::ContourCalled)));
    }
    if let Some((first, second)) = contour.crossing()
        && let (Some(a), Some(b)) = (contour.pieces.get(first), contour.pieces.get(second))
    {
        let alarm = if turned { 10931 } else { 61932 };
        let found = codes::S2091::contour_crosses_itself().alarm(alarm).at(b.origin.loc);
        let found = found.called(b.origin.call).also(a.origin.loc, Label::Crosses);
        return Err(Box::new(found.help("check the end points of both")));
    }
    Ok(())
}

impl ContourCall {
    /// A fault of a contour, reported at its call.
    fn fault(&self, what: &str) -> Fault {
        codes::S2091::contour(&self.name, &what)
    }

    /// Why a contour cannot be described; `None` where that was reported.
    fn unfit(&self, unfit: Unfit) -> Option<Diagnostic> {
        let (origin, fault) = match unfit {
            Unfit::Reported => return None,
            Unfit::TooMany(origin) => {
                let fault = codes::S4001::contour_has_more_than_elements(&MOST_ELEMENTS);
                (origin, fault.help("split it, or take splines of lines apart"))
            }
            Unfit::NoStart(origin) => (origin, codes::S2091::contour_has_no_start_point()),
            Unfit::Plane(origin) => (origin, codes::S2091::working_plane_changes_inside_contour()),
            Unfit::Frame(origin) => (origin, codes::S2091::coordinate_system_changes_inside_contour()),
            Unfit::Leaves(origin) => (origin, codes::S2091::block_of_contour_leaves_its_plane()),
        };
        Some(fault.at(origin.loc).called(origin.call).also(self.loc, Label::CalledHere))
    }
}

/// A contour in a few words.
fn shape(name: &str, made: &Captured) -> String {
    let [first, second] = {
        let (first, second, _) = made.plane.axes();
        [first, second].map(|at| crate::machine::Axis::ALL[at].letter())
    };
    let (low, high) = made.extent();
    let count = made.pieces.len();
    let closed = if made.is_closed() { ", closed" } else { "" };
    let radius = if made.plane == Plane::Zx { " (radius)" } else { "" };
    format!(
        "contour `{name}`, {count} element{} within {first} {} to {}, {second} {} to {}{radius}{closed}",
        if count == 1 { "" } else { "s" },
        number(low.x),
        number(high.x),
        number(low.y),
        number(high.y),
    )
}

fn number(mm: f64) -> String {
    let text = format!("{mm:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The arguments by their names.
pub(super) fn named(given: &Given) -> String {
    let mut shown = Vec::new();
    for parameter in given.signature.parameters {
        let text = match given.value(parameter.name) {
            Value::Text(text) if matches!(parameter.kind, Kind::Text) => format!("\"{text}\""),
            Value::Text(text) => text.clone(),
            Value::Number(value) => value.to_string(),
            Value::Missing | Value::Word(_) | Value::Other => continue,
        };
        if !text.is_empty() {
            shown.push(format!("`{}` {text}", parameter.name));
        }
    }
    shown.join(", ")
}
