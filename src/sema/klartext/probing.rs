//! Touch probe cycles that are left out: what they would have set is unknown from there on.
//!
//! Source: K 1.3, 5.6, 6.9 (docs/sources.md). Q115 to Q199 take results in every cycle, further parameters where the block
//! names them; the probe moves every axis, and datum, rotation and tool data may be others afterwards.

use crate::diag::{Answer, codes};
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::{Axis, AxisSet};
use crate::parser::klartext::ast::{Block, Refused, Stmt};
use crate::sema::common::hidden::By;
use crate::text::Span;
use crate::text::decode::readable;

use super::block_text::block_name;
use super::cycles::find;
use super::reading::Reading;
use super::vars::{Slot, exists, named};
use super::{Outcome, Run};

/// Parameters that a block of results fills from the one it names.
const RESULTS: u32 = 4;

/// A TCH PROBE block as far as it says what it changes.
#[derive(Debug, PartialEq)]
pub(super) struct Probe {
    pub number: u32,
    /// Not the first block of an old cycle (0.1).
    goes_on: bool,
    /// Parameters named as such: results, or inputs that the control keeps.
    parameters: Vec<QRef>,
    /// What its own parameters are set to, as written.
    given: Vec<(u32, String)>,
    /// The first word that belongs neither to its name nor to a parameter.
    stray: Option<String>,
}

impl Probe {
    /// Reads `TCH PROBE 419 NAME ~ Q263=+25 ;…` with all its lines.
    fn read(code: &[u8]) -> Probe {
        let mut lines = code.split(|b| *b == b'\n').map(|line| readable(line).to_ascii_uppercase());
        let first = lines.next().unwrap_or_default();
        let body = first.split_once("PROBE").map_or("", |(_, body)| body);
        let digits: String = body.trim_start().chars().take_while(char::is_ascii_digit).collect();
        let part = body.trim_start()[digits.len()..].strip_prefix('.').unwrap_or_default();
        let goes_on = part.starts_with(|c: char| ('1'..='9').contains(&c));
        let mut probe = Probe {
            number: digits.parse().unwrap_or(u32::MAX),
            goes_on,
            parameters: Vec::new(),
            given: Vec::new(),
            stray: None,
        };
        let mut parameters_begin = false;
        for line in std::iter::once(body.to_owned()).chain(lines) {
            let line = line.split(';').next().unwrap_or_default();
            probe.given.extend(assignments(line));
            if probe.stray.is_none() {
                probe.stray = stray(line, !part.is_empty(), &mut parameters_begin);
            }
            parameters_begin = true;
            // What stands behind the sign is read, not written.
            let line = line.split('=').next().unwrap_or_default();
            for word in line.split_whitespace() {
                probe.parameters.extend(named(word).filter(|q| !q.is_text() && exists(*q)));
            }
        }
        probe
    }

    /// What stands behind `Q305=`.
    pub(super) fn text_of(&self, parameter: u32) -> Option<&str> {
        self.given.iter().rev().find(|(q, _)| *q == parameter).map(|(_, text)| text.as_str())
    }

    /// A value that the cycle takes.
    pub(super) fn value(&self, reading: Reading<'_, '_>, parameter: u32, span: Span) -> Outcome<Option<f64>> {
        let Some(text) = self.text_of(parameter) else { return Ok(None) };
        reading.written(text, span).transpose()
    }

    /// Measuring in a direction fills a run of parameters.
    fn fills_a_run(&self) -> bool {
        matches!(self.number, 3 | 4 | 9 | 441 | 444)
    }

    /// Writes to the tool table.
    fn measures_tools(&self) -> bool {
        // 420 to 431 correct the table where they watch a tool (Q330).
        let watches = self.parameters.iter().any(|q| q.kind == QKind::Q && q.number == 330);
        watches || matches!(self.number, 30..=33 | 480..=499)
    }

    /// Turns the table.
    fn turns(&self) -> bool {
        !matches!(self.number, 0 | 1 | 3 | 4 | 9 | 400 | 401 | 402 | 404 | 408..=431)
    }
}

/// Is the block one that measures nothing, so that it is compiled?
pub(super) fn is_computed(code: &[u8]) -> bool {
    Probe::read(code).sets_rotation()
}

/// `Q263=+25`: the parameters that a line sets, and to what.
fn assignments(line: &str) -> impl Iterator<Item = (u32, String)> {
    line.match_indices('=').filter_map(|(at, _)| {
        let name = line[..at].split_whitespace().next_back()?;
        let number = name.strip_prefix('Q')?.parse().ok()?;
        let value = line[at + 1..].trim_start().split(|c: char| c.is_whitespace() || c == '~').next()?;
        Some((number, value.to_owned()))
    })
}

/// A word of a line that is no parameter, where the name of the cycle is over. The old cycles, with `dotted` numbers, have places of axes
/// and feeds, but no M function.
fn stray(line: &str, dotted: bool, parameters_begin: &mut bool) -> Option<String> {
    if line.contains('"') {
        return None;
    }
    let joined = line.replace(" =", "=").replace("= ", "=");
    joined.split_whitespace().filter(|word| *word != "~").map(|word| word.trim_end_matches('~')).find_map(|word| {
        let is_m =
            word.strip_prefix('M').is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()));
        *parameters_begin |= word.contains('=');
        (is_m || !dotted && *parameters_begin && !word.contains('=')).then(|| word.to_owned())
    })
}

/// A definition that was skipped: the lines of parameters behind it, which belong to it, go with it.
#[derive(Debug, Default)]
pub(super) struct Skipped {
    /// Number of its cycle, while lines of its parameters may follow.
    number: Option<u32>,
}

impl Skipped {
    #[inline]
    pub fn is_open(&self) -> bool {
        self.number.is_some()
    }

    /// The block in hand is skipped.
    pub fn skip(&mut self, block: &Block, text: &[u8]) {
        self.number = match block.stmt {
            Stmt::Cycle { number, part: None } => Some(number),
            Stmt::Refused(Refused::TouchProbe, _) => Some(Probe::read(block.span.of(text)).number),
            _ => None,
        };
    }

    /// Is the block a line of parameters of it?
    pub fn takes(&mut self, block: &Block) -> bool {
        let Some(number) = self.number else { return false };
        let belongs = match block.stmt {
            Stmt::Assign(q) => block.number.is_none() && find(number).takes(number, q),
            // Blank lines and comments may stand between.
            Stmt::Empty => return false,
            _ => false,
        };
        if !belongs {
            self.number = None;
        }
        belongs
    }
}

impl Run<'_> {
    /// TCH PROBE: refused, or left out with everything it touches unknown.
    pub(super) fn probe(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let (name, span) = block_name(block, text, 2);
        let probe = Probe::read(block.span.of(text));
        if let Some(stray) = &probe.stray {
            self.core.say(span, codes::P1003::has_no_place_in_cycle(stray, &probe.number));
        }
        if probe.sets_rotation() {
            return self.set_basic_rotation(&probe, span);
        }
        if !self.core.job.settings.control.klartext_choices.probing_left_out {
            let fault = codes::K9005::touch_probe_cycles_run_only_at_machine();
            return self.st.refuse_motion(&mut self.core, span, fault.answer(Answer::key("control", "probing")));
        }
        let setting = probe.setting(self.reading(), span)?;
        let here = self.core.here.origin.loc;
        let run = if probe.fills_a_run() { RESULTS } else { 1 };
        let named = probe.parameters.iter().flat_map(|q| (q.number..q.number + run).map(|n| QRef { number: n, ..*q }));
        let own = (115..200).map(|number| QRef { kind: QKind::Q, number });
        for q in named.chain(own).filter(|q| exists(*q)) {
            self.vars.put(&mut self.core, q, Slot::AtMachine(here));
        }
        if setting.may_turn(probe.number) {
            self.st.frames.may_be_turned(here);
        }
        self.tell_of_setting(&probe, &setting, span)?;
        // The probe moved, and the datum may be another: the next block of each axis has to be absolute.
        self.st.position.clear();
        self.st.position.hide(AxisSet::MAIN, By::Probe, here);
        self.st.polar.forget_last();
        self.st.contour.now = None;
        if probe.turns() {
            self.st.rotary.turned_by_machine([Axis::A, Axis::B, Axis::C].into_iter().collect());
        }
        self.st.lost(&mut self.core);
        if probe.measures_tools() {
            self.st.tool.measure();
        }
        if !probe.goes_on {
            let what = if probe.measures_tools() { "the tool data" } else { "datum, rotation and results" };
            self.core.say(span, codes::K2851::is_left_out(&name, &probe.number, &what));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_probe_names() {
        let q = |number| QRef { kind: QKind::Q, number };
        let probe = Probe::read(b"TCH PROBE 419 DATUM Q ~\n Q263=+Q7 ;1ST POINT Q8 ~\n Q303=+1");
        let given = vec![(263, "+Q7".to_owned()), (303, "+1".to_owned())];
        assert_eq!(probe, Probe { number: 419, goes_on: false, parameters: vec![q(263), q(303)], given, stray: None });
        assert_eq!((probe.text_of(303), probe.text_of(305)), (Some("+1"), None));
        assert!(!probe.measures_tools() && !probe.turns() && !probe.fills_a_run());
        let stray = |code: &[u8]| Probe::read(code).stray;
        let stray_of_404 = stray(b"TCH PROBE 404 SET BASIC ROTATION ~\n Q307 = +0 CCA30 ;X ~\n Q305=0");
        assert_eq!(stray_of_404.as_deref(), Some("CCA30"));
        assert_eq!(stray(b"TCH PROBE 404 SET M8 ~\n Q307=+0").as_deref(), Some("M8"));
        assert_eq!(stray(b"TCH PROBE 0.1 X+5 Y+5 Z-10 M8").as_deref(), Some("M8"));
        assert_eq!(stray(b"TCH PROBE 1.1 X+5 F200"), None);
        let probe = Probe::read(b"tch probe 0.0 REF. PLANE Q5 X-");
        assert_eq!(probe, Probe { number: 0, goes_on: false, parameters: vec![q(5)], given: vec![], stray: None });
        assert!(Probe::read(b"TCH PROBE 481 TOOL LENGTH ~\n Q340=+1").measures_tools());
        assert!(Probe::read(b"TCH PROBE 421 ~\n Q330=5").measures_tools());
        assert!(Probe::read(b"TCH PROBE 403 ~").turns());
    }
}
