//! Cycles that take a contour: CYCLE62 calls it, CYCLE95, CYCLE952, CYCLE63, CYCLE64 and CYCLE72 work along it.
//!
//! The contour is run and checked, and the arguments are; then the cycle is refused by name, because its tracks are not
//! published. Source: C 1.12, 5.2 to 5.6 and 7 (docs/sources.md).

use crate::diag::{Diagnostic, codes};
use crate::geo::arc::Closing;
use crate::geo::{Element, Plane};
use crate::ir::captured::{Captured, CapturedKind};
use crate::parser::sinumerik::ast::Search;
use crate::sema::cycle::row::{Kind, Parameter, Rule};
use crate::text::Loc;
use crate::text::Span;
use crate::text::blocks::Place;

use super::super::value::{Val, to_text, whole};
use super::super::{Core, Outcome, Reported, Run};
use super::arguments::{Arguments, KNAME, Key, LAB1, LAB2, NPP, TYPE};
use super::call::CycleCall;
use super::table::{Source, Unpublished};

/// Most contours of one machining cycle.
const MOST_CONTOURS: usize = 100;
/// Blocks of a contour for stock removal, its start counted (alarm 10933).
const LEAST_BLOCKS: usize = 3;

/// The contours that the next machining cycle takes.
#[derive(Debug, Default)]
pub(in super::super) struct Contours {
    list: Vec<ContourCall>,
    /// A machining cycle took them: the next call begins a new list.
    taken: bool,
}

/// Most elements of a contour, roundings and chamfers counted.
pub(in super::super) const MOST_ELEMENTS: usize = 1000;

/// Where the blocks of a contour are.
#[derive(Debug, Clone)]
pub(in super::super) struct ContourCall {
    /// The program that holds it.
    pub unit: usize,
    /// From this block up to this offset; `None` for the whole program.
    pub part: Option<(Place, u32)>,
    /// What the call names, for findings.
    pub name: String,
    /// The call.
    pub loc: Loc,
}

impl Run<'_> {
    /// `CYCLE62(name, type, label, label)`
    pub(super) fn contour_call(&mut self, args: &Arguments) -> Outcome {
        self.cycle(args).check_parameters()?;
        let text = |key: Key| args.text(key).filter(|text| !text.is_empty());
        let (name, first, last) = (text(KNAME), text(LAB1), text(LAB2));
        let kind = args.number(TYPE).and_then(whole).unwrap_or(0);
        let call = match (kind, name, first, last) {
            (0, Some(name), None, None) => self.contour_program(args, KNAME, &name)?,
            (1, Some(name), None, None) => {
                let labels = (format!("E_LAB_A_{name}"), format!("E_LAB_E_{name}"));
                let unit = self.unit();
                self.contour_between(args, unit, &name, (&labels.0, &labels.1), KNAME)?
            }
            (2, None, Some(first), Some(last)) => {
                let unit = self.unit();
                let name = format!("{first} to {last}");
                self.contour_between(args, unit, &name, (&first, &last), LAB1)?
            }
            (3, Some(name), Some(first), Some(last)) => {
                let unit = self.find_program(&name, args.span_of(KNAME))?;
                let shown = format!("{first} to {last} of {name}");
                self.contour_between(args, unit, &shown, (&first, &last), LAB1)?
            }
            _ => {
                return self.cycle(args).refuse_cycle(args.span_of(TYPE), codes::P2090::type_name());
            }
        };
        if std::mem::take(&mut self.contours.taken) {
            self.contours.list.clear();
        }
        if self.contours.list.len() >= MOST_CONTOURS {
            return self.cycle(args).refuse_cycle(args.span, codes::P2090::there_are_too_many_contours());
        }
        // What is wrong with it shows here, also where no cycle follows that is built.
        self.contours.list.push(call.clone());
        let made = self.capture(&call)?;
        self.check_elements(&call, &made)
    }

    fn contour_program(&mut self, args: &Arguments, key: Key, name: &str) -> Outcome<ContourCall> {
        let unit = self.find_program(name, args.span_of(key))?;
        Ok(ContourCall { unit, part: None, name: name.to_owned(), loc: self.loc(args.span) })
    }

    /// The blocks from one label to another of a program. The block of the last label belongs to it.
    fn contour_between(
        &mut self,
        args: &Arguments,
        unit: usize,
        name: &str,
        labels: (&str, &str),
        key: Key,
    ) -> Outcome<ContourCall> {
        let skeleton = match self.skeleton_of(unit) {
            Ok(made) => made,
            Err(error) => return self.refuse(args.span, codes::P0105::file_cannot_be_read(&error)),
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
            return Ok(ContourCall { unit, part, name: name.to_owned(), loc: self.loc(args.span) });
        }
        let missing = if start.is_none() { labels.0 } else { labels.1 };
        let program = self.units.list[unit].name.clone();
        let known: Vec<&str> = skeleton.labels().map(|label| self.symbols.name(label)).collect();
        let like = crate::machine::tree::did_you_mean(missing, known);
        let help = match like {
            Some(like) if like == missing => "it stands in front of the label of the start".to_owned(),
            Some(like) => format!("did you mean `{like}`?"),
            None => format!("write `{missing}:` in front of the contour, or behind it"),
        };
        let behind = if start.is_some() { " behind the label of the start" } else { "" };
        let found = codes::S2091::there_is_no_label(&missing, &behind, &program).at(self.loc(args.span_of(key)));
        self.report(found.help(help));
        Err(Reported)
    }

    /// A cycle whose tracks the control keeps to itself.
    pub(super) fn unpublished_cycle(&mut self, args: &Arguments, cycle: &Unpublished) -> Outcome {
        self.cycle(args).check_parameters()?;
        if cycle.turned {
            self.cycle(args).in_turning_plane()?;
        }
        let what = args.cycle.signature.what;
        let contours = self.contours_of(args, cycle.contour, cycle.turned)?;
        let shown = contours.iter().map(|(call, made)| shape(&call.name, made)).collect::<Vec<_>>().join("; ");
        let message = if contours.is_empty() {
            format!("{} ({what}) is not supported", args.name())
        } else {
            format!("{} ({what}) is not supported; read without a fault: {shown}", args.name())
        };
        let found = Diagnostic::new(codes::S9020, self.loc(args.span), message).here(named(args));
        let help = cycle
            .advice
            .and_then(|advice| advice(args))
            .unwrap_or_else(|| "replace it by plain moves, or have the CAM system put them out".to_owned());
        self.report(found.help(help));
        Err(Reported)
    }

    /// The contours of a cycle, each run and checked.
    pub(super) fn contours_of(
        &mut self,
        args: &Arguments,
        source: Source,
        turned: bool,
    ) -> Outcome<Vec<(ContourCall, Captured)>> {
        let calls = match source {
            Source::None => return Ok(Vec::new()),
            Source::Argument => vec![self.named_contour(args)?],
            Source::Turned | Source::Milled => {
                self.contours.taken = true;
                self.contours.list.clone()
            }
        };
        if calls.is_empty() {
            let alarm = if source == Source::Turned { 61701 } else { 61930 };
            return self.cycle(args).refuse_cycle(args.span, codes::P2090::no_contour_is_called().alarm(alarm));
        }
        if source == Source::Turned && calls.len() > 2 {
            return self.cycle(args).refuse_cycle(args.span, codes::P2090::more_than_two_contours_are_called());
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
                self.cycle(args).check_contour((source, turned), &call, &contour, closed)?;
                Ok(contour)
            });
            match result {
                Ok(contour) => made.push((call, contour)),
                // The next one may show more.
                Err(Reported) if !self.has_ended() => failed = true,
                Err(reported) => return Err(reported),
            }
        }
        if failed { Err(Reported) } else { Ok(made) }
    }

    /// The contour that a milling cycle goes along: named by it, or called in front of it.
    pub(super) fn contour_to_mill(&mut self, args: &Arguments) -> Outcome<Captured> {
        let call = if args.text(KNAME).is_some_and(|name| !name.is_empty()) {
            self.named_contour(args)?
        } else {
            self.contours.taken = true;
            match &self.contours.list[..] {
                [call] => call.clone(),
                [] => self.named_contour(args)?,
                _ => {
                    return self.cycle(args).refuse_cycle(args.span, codes::P2090::more_than_one_contour_is_called());
                }
            }
        };
        let contour = self.capture(&call)?;
        if contour.pieces.is_empty() {
            return self.contour_fault(&call, args.span, 61930, "it has no element");
        }
        self.check_elements(&call, &contour)?;
        Ok(contour)
    }

    /// `"NAME"` or `"LABEL1:LABEL2"`.
    fn named_contour(&mut self, args: &Arguments) -> Outcome<ContourCall> {
        let key = if args.place(NPP) > 0 { NPP } else { KNAME };
        let Some(name) = args.text(key).filter(|name| !name.is_empty()) else {
            return self.cycle(args).refuse_cycle(args.span_of(key), codes::P2090::no_contour_is_named());
        };
        match name.split_once(':') {
            None => self.contour_program(args, key, &name),
            Some((first, last)) => {
                let unit = self.unit();
                self.contour_between(args, unit, &name, (first.trim(), last.trim()), key)
            }
        }
    }
}

impl CycleCall<'_, '_> {
    fn check_contour(
        &mut self,
        (source, turned): (Source, bool),
        call: &ContourCall,
        contour: &Captured,
        closed: Option<u32>,
    ) -> Outcome {
        let args = self.args;
        let turned = turned && source != Source::None;
        if turned && contour.plane != Plane::Zx {
            return self.contour_fault(call, args.span, None, "it does not lie in the plane of Z and X (G18)");
        }
        if turned && source == Source::Argument && contour.pieces.len() + 1 < LEAST_BLOCKS {
            return self.contour_fault(call, args.span, 10933, "it has fewer than 3 blocks with moves");
        }
        if contour.pieces.is_empty() {
            return self.contour_fault(call, args.span, 61930, "it has no element");
        }
        self.check_elements(call, contour)?;
        match closed {
            Some(alarm) if !contour.is_closed() => {
                let what = if turned { "the contour of the blank is not closed" } else { "it is not closed" };
                self.contour_fault(call, args.span, alarm, what)
            }
            _ => Ok(()),
        }
    }

    /// Every argument against its rule.
    pub(super) fn check_parameters(&mut self) -> Outcome {
        let args = self.args;
        for (place, parameter) in (1..).zip(args.cycle.signature.parameters) {
            let given = args.list.get(place - 1).filter(|(value, _)| *value != Val::Missing);
            let Some((value, span)) = given else {
                if parameter.needed {
                    return self.parameter_fault((place, args.span), parameter, None, "is missing");
                }
                continue;
            };
            if matches!(parameter.kind, Kind::Text) {
                if !matches!(value, Val::Text(_)) {
                    return self.parameter_fault(
                        (place, *span),
                        parameter,
                        None,
                        "has to be a text in quotation marks",
                    );
                }
                continue;
            }
            let Some(number) = value.number() else {
                return self.parameter_fault((place, *span), parameter, None, "has to be a number");
            };
            let wrong = match parameter.rule {
                Rule::Any => None,
                Rule::Unsigned => (number < 0.0).then_some((61019, "must not be negative")),
                // 0 is what an empty field becomes.
                Rule::Above(alarm) | Rule::AboveOrEmpty(alarm) => (number < 0.0).then_some((alarm, "must be above 0")),
                Rule::Below90 => {
                    (!(0.0..90.0).contains(&number)).then_some((61019, "has to be from 0 to below 90 degrees"))
                }
                Rule::OneOf(low, high) => {
                    let fits = whole(number).is_some_and(|n| (low..=high).contains(&n)) && number.fract() == 0.0;
                    (!fits).then_some((61002, "has no such value"))
                }
            };
            if let Some((alarm, what)) = wrong {
                return self.parameter_fault((place, *span), parameter, alarm, what);
            }
        }
        Ok(())
    }

    fn parameter_fault(
        &self,
        (place, span): (usize, Span),
        parameter: &Parameter,
        alarm: impl Into<Option<u32>>,
        what: &str,
    ) -> Outcome {
        let meaning = if parameter.what.is_empty() { String::new() } else { format!(": {}", parameter.what) };
        self.refuse_cycle(span, codes::P2090::argument_is_wrong(&parameter.name, &place, &meaning, &what).alarm(alarm))
    }
}

impl Core<'_> {
    /// Lines and arcs at feed that do not cross.
    fn check_elements(&mut self, call: &ContourCall, contour: &Captured) -> Outcome {
        let turned = contour.plane == Plane::Zx;
        for piece in &contour.pieces {
            let full = matches!(piece.element, Element::Arc { from, to, .. }
                if crate::geo::arc::closing(to - from) == Closing::Closed);
            let (alarm, what) = match piece.kind {
                CapturedKind::Rapid => (61936, "rapid traverse inside a contour"),
                CapturedKind::Thread => (10930, "a thread inside a contour"),
                CapturedKind::Cut if turned && full => (10931, "a full circle inside a turned contour"),
                CapturedKind::Cut => continue,
            };
            let found = Diagnostic::new(codes::S2091.alarm(alarm), piece.origin.loc, what);
            let found = found.called(piece.origin.call).also(call.loc, "the contour is called here");
            self.report(found.help("a contour is made of lines and arcs at feed behind its start point"));
            return Err(Reported);
        }
        if let Some((first, second)) = contour.crossing()
            && let (Some(a), Some(b)) = (contour.pieces.get(first), contour.pieces.get(second))
        {
            let alarm = if turned { 10931 } else { 61932 };
            let found = codes::S2091::contour_crosses_itself().alarm(alarm).at(b.origin.loc);
            let found = found.called(b.origin.call).also(a.origin.loc, "it crosses the element of this block");
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
fn named(args: &Arguments) -> String {
    let mut shown = Vec::new();
    for (parameter, (value, _)) in args.cycle.signature.parameters.iter().zip(&args.list) {
        let text = if *value == Val::Missing { Vec::new() } else { to_text(value).unwrap_or_default() };
        if !text.is_empty() {
            let quote = if matches!(parameter.kind, Kind::Text) { "\"" } else { "" };
            shown.push(format!("`{}` {quote}{}{quote}", parameter.name, String::from_utf8_lossy(&text)));
        }
    }
    shown.join(", ")
}
