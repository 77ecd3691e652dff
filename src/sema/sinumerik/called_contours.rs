//! Cycles that take a contour: CYCLE62 calls it, CYCLE95, CYCLE952, CYCLE63, CYCLE64 and CYCLE72 work along it.
//!
//! The contour is run and checked, and the arguments are; then the cycle is refused by name, because its tracks are not
//! published. Source: C 1.12, 5.2 to 5.6 and 7 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::geo::arc::Closing;
use crate::geo::{Element, Plane};
use crate::ir::captured::{Captured, CapturedKind};
use crate::parser::sinumerik::ast::Search;
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row::{Kind, Name};
use crate::sema::run::Where;

use super::cycles::{KNAME, LAB1, LAB2, NPP, Source, TYPE};
use super::named_contour::{CalledContour, ContourCall};
use super::{Core, Outcome, Reported, Run};

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

impl Run<'_> {
    /// `CYCLE62(name, type, label, label)`
    pub(super) fn contour_call(&mut self, given: &Given) -> Outcome {
        let (name, first, last) = (given.text(KNAME), given.text(LAB1), given.text(LAB2));
        let call = match (given.whole(TYPE), name, first, last) {
            (0, Some(name), None, None) => self.contour_program(given, KNAME, name)?,
            (1, Some(name), None, None) => {
                let labels = (format!("E_LAB_A_{name}"), format!("E_LAB_E_{name}"));
                let unit = self.unit();
                self.contour_between(given, unit, name, (&labels.0, &labels.1), KNAME)?
            }
            (2, None, Some(first), Some(last)) => {
                let unit = self.unit();
                let name = format!("{first} to {last}");
                self.contour_between(given, unit, &name, (first, last), LAB1)?
            }
            (3, Some(name), Some(first), Some(last)) => {
                let unit = self.find_program(name, given.place_of(KNAME).span())?;
                let shown = format!("{first} to {last} of {name}");
                self.contour_between(given, unit, &shown, (first, last), LAB1)?
            }
            _ => return self.channel.core.refuse(given.place_of(TYPE), codes::P2090::type_name().of(&given.called)),
        };
        if std::mem::take(&mut self.contours.taken) {
            self.contours.list.clear();
        }
        if self.contours.list.len() >= MOST_CONTOURS {
            return self
                .channel
                .core
                .refuse(given.place, codes::P2090::there_are_too_many_contours().of(&given.called));
        }
        // What is wrong with it shows here, also where no cycle follows that is built.
        self.contours.list.push(call.clone());
        let made = self.capture(&call)?;
        self.channel.core.check_elements(&call, &made)
    }

    fn contour_program(&mut self, given: &Given, key: Name, name: &str) -> Outcome<ContourCall> {
        let unit = self.find_program(name, given.place_of(key).span())?;
        Ok(ContourCall { unit, part: None, name: name.to_owned(), loc: self.channel.core.loc(given.place) })
    }

    /// The blocks from one label to another of a program. The block of the last label belongs to it.
    fn contour_between(
        &mut self,
        given: &Given,
        unit: usize,
        name: &str,
        labels: (&str, &str),
        key: Name,
    ) -> Outcome<ContourCall> {
        let skeleton = match self.skeleton_of(unit) {
            Ok(made) => made,
            Err(error) => return self.channel.core.refuse(given.place, codes::P0105::file_cannot_be_read(&error)),
        };
        let mut find = |label: &str, from: u32| {
            let name = self.channel.core.symbols.intern(label.as_bytes());
            skeleton
                .label(name, from, Search::Forward)
                .or_else(|| skeleton.label(name, from, Search::Backward).filter(|mark| mark.place.at >= from))
        };
        let start_of_program = self.units.list[unit].start.at;
        let start = find(labels.0, start_of_program);
        let end = start.and_then(|start| find(labels.1, start.place.at));
        if let (Some(start), Some(end)) = (start, end) {
            let part = Some((start.place, end.after.at));
            return Ok(ContourCall { unit, part, name: name.to_owned(), loc: self.channel.core.loc(given.place) });
        }
        let missing = if start.is_none() { labels.0 } else { labels.1 };
        let program = self.units.list[unit].name.clone();
        let known: Vec<&str> = skeleton.labels().map(|label| self.channel.core.symbols.name(label)).collect();
        let like = crate::machine::tree::did_you_mean(missing, known);
        let help = match like {
            Some(like) if like == missing => "it stands before the label of the start".to_owned(),
            Some(like) => format!("did you mean `{like}`?"),
            None => format!("write `{missing}:` before the contour, or after it"),
        };
        let behind = if start.is_some() { " after the label of the start" } else { "" };
        let found =
            codes::S2091::there_is_no_label(&missing, &behind, &program).at(self.channel.core.loc(given.place_of(key)));
        self.channel.core.report(found.help(help));
        Err(Reported)
    }

    /// A cycle whose tracks the control keeps to itself.
    pub(super) fn unpublished_cycle(&mut self, given: &Given, source: Source) -> Outcome {
        let what = given.signature.what;
        let contours = self.contours_of(given, source)?;
        let shown = contours.iter().map(|of| shape(&of.call.name, &of.made)).collect::<Vec<_>>().join("; ");
        let fault = if contours.is_empty() {
            codes::S9020::cycle_is_not_supported(&given.called, &what)
        } else {
            codes::S9020::cycle_is_read_without_fault(&given.called, &what, &shown)
        };
        self.channel.core.report(fault.at(self.channel.core.loc(given.place)).here(named(given)));
        Err(Reported)
    }

    /// The contours of a cycle, each run and checked.
    pub(super) fn contours_of(&mut self, given: &Given, source: Source) -> Outcome<Vec<CalledContour>> {
        let calls = match source {
            Source::Argument => vec![self.named_contour(given)?],
            Source::Single if given.text(KNAME).is_some() => vec![self.named_contour(given)?],
            Source::Single | Source::Turned | Source::Milled => {
                self.contours.taken = true;
                self.contours.list.clone()
            }
        };
        let refused = match (source, calls.len()) {
            (Source::Single, 0) => {
                return self
                    .channel
                    .core
                    .refuse(given.place_of(KNAME), codes::P2090::no_contour_is_named().of(&given.called));
            }
            (Source::Single, 2..) => Some(codes::P2090::more_than_one_contour_is_called()),
            (Source::Turned, 0) => Some(codes::P2090::no_contour_is_called().alarm(61701)),
            (_, 0) => Some(codes::P2090::no_contour_is_called().alarm(61930)),
            (Source::Turned, 3..) => Some(codes::P2090::more_than_two_contours_are_called()),
            _ => None,
        };
        if let Some(fault) = refused {
            return self.channel.core.refuse(given.place, fault.of(&given.called));
        }
        let mut made = Vec::with_capacity(calls.len());
        let mut failed = false;
        let count = calls.len();
        for (at, call) in calls.into_iter().enumerate() {
            let closed = match source {
                Source::Turned if count == 2 && at == 0 => Some(61739),
                Source::Milled => Some(61931),
                _ => None,
            };
            let result = self.capture(&call).and_then(|contour| {
                self.check_contour(given.place, source, &call, &contour, closed)?;
                Ok(contour)
            });
            match result {
                Ok(contour) => made.push(CalledContour { call, made: contour }),
                // The next one may show more.
                Err(Reported) if !self.channel.core.has_ended() => failed = true,
                Err(reported) => return Err(reported),
            }
        }
        if failed { Err(Reported) } else { Ok(made) }
    }

    /// `"NAME"` or `"LABEL1:LABEL2"`.
    fn named_contour(&mut self, given: &Given) -> Outcome<ContourCall> {
        let key = if given.takes(NPP) { NPP } else { KNAME };
        let Some(name) = given.text(key) else {
            return self
                .channel
                .core
                .refuse(given.place_of(key), codes::P2090::no_contour_is_named().of(&given.called));
        };
        match name.split_once(':') {
            None => self.contour_program(given, key, name),
            Some((first, last)) => {
                let unit = self.unit();
                self.contour_between(given, unit, name, (first.trim(), last.trim()), key)
            }
        }
    }

    fn check_contour(
        &self,
        place: Where,
        source: Source,
        call: &ContourCall,
        contour: &Captured,
        closed: Option<u32>,
    ) -> Outcome {
        let turned = matches!(source, Source::Argument | Source::Turned);
        if turned && contour.plane != Plane::Zx {
            return self.channel.core.contour_fault(call, place, None, "it does not lie in the plane of Z and X (G18)");
        }
        if source == Source::Argument && contour.pieces.len() + 1 < LEAST_BLOCKS {
            return self.channel.core.contour_fault(call, place, 10933, "it has fewer than 3 blocks with moves");
        }
        if contour.pieces.is_empty() {
            return self.channel.core.contour_fault(call, place, 61930, "it has no element");
        }
        self.channel.core.check_elements(call, contour)?;
        match closed {
            Some(alarm) if !contour.is_closed() => {
                let what = if turned { "the contour of the blank is not closed" } else { "it is not closed" };
                self.channel.core.contour_fault(call, place, alarm, what)
            }
            _ => Ok(()),
        }
    }
}

impl Core<'_> {
    /// Lines and arcs at feed that do not cross.
    fn check_elements(&self, call: &ContourCall, contour: &Captured) -> Outcome {
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
            self.report(found.also(call.loc, Label::ContourCalled));
            return Err(Reported);
        }
        if let Some((first, second)) = contour.crossing()
            && let (Some(a), Some(b)) = (contour.pieces.get(first), contour.pieces.get(second))
        {
            let alarm = if turned { 10931 } else { 61932 };
            let found = codes::S2091::contour_crosses_itself().alarm(alarm).at(b.origin.loc);
            let found = found.called(b.origin.call).also(a.origin.loc, Label::Crosses);
            self.report(found.help("check the end points of both"));
            return Err(Reported);
        }
        Ok(())
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
fn named(given: &Given) -> String {
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
