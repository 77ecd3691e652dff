//! Machining cycles of the control: their parameters become the arguments of `ir::cycle`.
//!
//! Source: `reference/sinumerik-contours-undercuts-cycles` sections 5 and 6.

mod alarms;
mod contours;
mod drilling;
mod modes;
mod pattern;
mod signatures;
mod thread;
mod undercut;
mod undercut_call;

use crate::diag::{Code, Diagnostic, codes};
use crate::geo::{Plane, Point2};
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::{Spindle, Turn};
use crate::ir::{Feed, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Args, Block, Formula};
use crate::text::Span;

use super::offsets::Outer;
use super::state::{Diameter, State};
use super::value::{Val, to_text, whole};
use super::vocabulary::{Meaning, Procedure};
use super::words::CallWord;
use super::{Outcome, Reported, Run};
use crate::sema::run::Site;

pub(super) use alarms::meaning as alarm_meaning;
pub(super) use contours::Contours;

/// A drilling cycle that runs behind every positioning block.
#[derive(Debug, Clone)]
pub(super) struct ModalCycle {
    hole: Drilling,
    args: Arguments,
    /// Where MCALL stands.
    here: Site,
    /// The spindle as the hole was made of it: a dwell in turns, a tap and a feed of its own depend on it.
    spindle: SpindleState,
    /// The feed is the one that is modal when the hole is drilled.
    feed_of_block: bool,
    /// Plane and unit of the call: the axis and the lengths of the hole were taken under them.
    under: (Plane, f64),
    /// Why it cannot be drilled was reported.
    refused: bool,
}

/// What holes take from the spindle: speed, sense, whether the speed follows the diameter, whether feeds count per turn; and
/// the tool and its edge, whose tip a depth may count for.
type SpindleState = (Option<f64>, Option<Turn>, bool, bool, Option<u32>, Option<u32>);

/// The arguments of a call, counted from 1 as the manuals do.
#[derive(Debug, Clone)]
struct Arguments {
    name: String,
    span: Span,
    list: Vec<(Val, Span)>,
}

impl Arguments {
    /// What was given in a place; `None` for an empty or missing argument.
    fn value(&self, place: usize) -> Option<&(Val, Span)> {
        self.list.get(place - 1).filter(|(value, _)| *value != Val::Missing)
    }

    fn span_of(&self, place: usize) -> Span {
        self.value(place).map_or(self.span, |(_, span)| *span)
    }

    fn number(&self, place: usize) -> Option<f64> {
        self.value(place).and_then(|(value, _)| value.number())
    }

    fn or_zero(&self, place: usize) -> f64 {
        self.number(place).unwrap_or(0.0)
    }

    fn text(&self, place: usize) -> Option<String> {
        let (value, _) = self.value(place)?;
        let text = to_text(value)?;
        Some(String::from_utf8_lossy(&text).trim().to_ascii_uppercase())
    }

    /// A decimal digit of a coded number, from the right: 0 is the units.
    fn digit(&self, place: usize, position: u32) -> i32 {
        let value = self.number(place).and_then(whole).unwrap_or(0);
        value.unsigned_abs().checked_div(10u32.saturating_pow(position)).map_or(0, |v| (v % 10) as i32)
    }
}

/// Places whose digits each mean something.
fn codes_of(name: &str) -> &'static [usize] {
    match name {
        "CYCLE81" | "CYCLE89" => &[7, 8, 9],
        "CYCLE82" => &[7, 8, 9, 10],
        "CYCLE83" => &[18, 19, 20],
        "CYCLE84" => &[16, 22, 23, 24],
        "CYCLE840" => &[18, 19, 20],
        "CYCLE85" => &[9, 10, 11],
        "CYCLE86" => &[12, 13, 14],
        "CYCLE940" => &[7, 21, 22],
        "CYCLE98" => &[30, 31],
        "CYCLE99" => &[14, 28, 29],
        "HOLES1" | "HOLES2" => &[7, 11],
        "CYCLE801" => &[8, 14],
        "CYCLE802" => &[1, 2, 21, 23],
        _ => &[],
    }
}

/// Is the argument a text? Contour cycles check theirs by their signature.
fn takes_text(name: &str, place: usize) -> bool {
    match name {
        "CYCLE84" => (19..=21).contains(&place),
        "CYCLE840" => (15..=17).contains(&place),
        "CYCLE94" | "CYCLE96" => place == 3,
        "CYCLE940" => matches!(place, 3 | 18..=20),
        "CYCLE98" => (27..=29).contains(&place),
        "CYCLE99" => (25..=27).contains(&place),
        "HOLES1" | "HOLES2" => place == 9,
        "CYCLE801" => place == 12,
        _ => signatures::of(name).is_some(),
    }
}

/// Names of threads and tables, and texts of the editor beside a number.
fn only_text(name: &str, place: usize) -> bool {
    match name {
        "CYCLE84" => (19..=21).contains(&place),
        "CYCLE840" => (15..=17).contains(&place),
        "CYCLE940" => matches!(place, 19 | 20),
        "CYCLE98" => (27..=29).contains(&place),
        "CYCLE99" => (25..=27).contains(&place),
        _ => false,
    }
}

impl Run<'_> {
    /// Runs a machining cycle; `None` for a name that is none, or that is not built.
    pub(super) fn machining_cycle(
        &mut self,
        name: &str,
        call: CallWord,
        block: &Block,
        text: &[u8],
    ) -> Option<Outcome> {
        let front_end = signatures::of(name).is_some();
        if !is_built(name) && !front_end || front_end && self.own_program(name) {
            return None;
        }
        let result =
            self.cycle_arguments(name, call.args, call.span, block, text).and_then(|args| self.run_cycle(&args));
        if result.is_err() {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
        }
        Some(result)
    }

    fn cycle_arguments(
        &mut self,
        name: &str,
        args: Option<Args>,
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome<Arguments> {
        self.no_cycle_in_contour(name, span)?;
        let formulas: Vec<Formula> = args.map(|args| block.arguments(args).to_vec()).unwrap_or_default();
        let mut list = Vec::with_capacity(formulas.len());
        for formula in formulas {
            let value = self.eval(formula, block, text)?;
            list.push((value, formula.span));
        }
        if list.len() > most_arguments(name) {
            let at = list.get(most_arguments(name)).map_or(span, |(_, span)| *span);
            let message = format!("{name} takes {} arguments", most_arguments(name));
            return self.fail(codes::S2021, 12340, at, message);
        }
        let args = Arguments { name: name.to_owned(), span, list };
        self.check_values(&args)?;
        Ok(args)
    }

    fn check_values(&self, args: &Arguments) -> Outcome {
        let name = args.name.as_str();
        for (place, (value, at)) in (1..).zip(&args.list) {
            if *value != Val::Missing && value.number().is_none() && !takes_text(name, place) {
                let message = format!("argument {place} of {name} has to be a number");
                return self.fail_help(codes::S2090, 12150, *at, message, "a number in quotation marks is a text");
            }
            // A number among the texts is a sign of a comma too many or too few.
            if only_text(name, place) && value.number().is_some_and(|v| v != 0.0) {
                let message = format!("argument {place} of {name} has to be a text");
                return self.fail_help(codes::S2090, 12150, *at, message, "arguments are counted by their commas");
            }
            if value.number().is_some_and(|v| !v.is_finite() || v.abs() > 1e9) {
                return self.fail(codes::S2090, 0, *at, format!("an argument of {name} is out of all range"));
            }
            if let Some(coded) = value.number()
                && codes_of(name).contains(&place)
                && (coded < 0.0 || coded.fract() != 0.0)
            {
                let message = format!("argument {place} is a code of digits, which {coded} is not");
                let help = "give a whole number from 0 on, or leave it out";
                return self.cycle_fault(args, *at, 0, &message, help);
            }
        }
        Ok(())
    }

    fn run_cycle(&mut self, args: &Arguments) -> Outcome {
        self.begins_executing();
        self.pending_must_be_done(args.span)?;
        if self.st.side() != Side::None {
            return self.cycle_fault(
                args,
                args.span,
                61815,
                "radius compensation is on",
                "program G40 before the cycle",
            );
        }
        match self.st.outer {
            Outer::Machine => {
                return self.in_machine_only_lines(args.span, "a cycle cannot be printed in machine coordinates");
            }
            Outer::Unrelated => return self.unrelated(args.span, "G500 stands beside"),
            Outer::Basic | Outer::Printed(_) => self.note_outer(),
        }
        self.no_cycle_by_time(args.span)?;
        if let Some(signature) = signatures::of(&args.name) {
            return self.contour_cycle(args, signature);
        }
        self.speed_is_known()?;
        if self.st.per_revolution() {
            self.master_is_main(args.span, "a feed per revolution")?;
        }
        match args.name.as_str() {
            "HOLES1" | "HOLES2" | "CYCLE801" | "CYCLE802" => self.pattern(args),
            "CYCLE97" | "CYCLE98" | "CYCLE99" => self.thread_cycle(args),
            "CYCLE94" | "CYCLE96" | "CYCLE940" => self.undercut_cycle(args),
            _ => {
                let hole = self.hole(args)?;
                self.drill(&hole)
            }
        }
    }

    /// `MCALL CYCLE81(…)`; `None` for a name that is no cycle.
    pub(super) fn modal_machining_cycle(
        &mut self,
        name: &str,
        args: Args,
        block: &Block,
        text: &[u8],
    ) -> Option<Outcome> {
        if drilling::is_hole(name) {
            let result = self.cycle_arguments(name, Some(args), block.span, block, text).and_then(|args| {
                self.modal_cycle = None;
                self.modal = None;
                let hole = self.hole(&args)?;
                let feed_of_block = !matches!(name, "CYCLE85");
                let under = (self.st.plane(), self.st.length_unit());
                let (here, spindle) = (self.here, self.spindle_state());
                let refused = false;
                self.modal_cycle =
                    Some(Box::new(ModalCycle { hole, args, here, spindle, feed_of_block, under, refused }));
                Ok(())
            });
            return Some(result);
        }
        match self.vocabulary.get(name) {
            Some(Meaning::Procedure(Procedure::Refused(what))) => Some(self.fail_help(
                codes::S9005,
                0,
                block.span,
                format!("{name} ({what}) is not supported as a modal call"),
                "replace it by plain moves, or compile the program without it",
            )),
            _ => None,
        }
    }

    /// Drills the modal hole where the tool stands. Why it cannot is said once, and the tool goes on to the next place:
    /// the other places of a pattern are worth no other finding.
    pub(super) fn drill_modal(&mut self) -> Outcome {
        let Some(modal) = self.modal_cycle.clone().filter(|modal| !modal.refused) else { return Ok(()) };
        if self.drill_here(modal).is_err()
            && let Some(modal) = &mut self.modal_cycle
        {
            modal.refused = true;
        }
        Ok(())
    }

    fn no_cycle_by_time(&self, span: Span) -> Outcome {
        if !self.st.is(super::g_groups::Code::G93) {
            return Ok(());
        }
        self.not_by_time(span, "the moves of a cycle have no share of the time that G93 gives the blocks")
    }

    fn drill_here(&mut self, modal: Box<ModalCycle>) -> Outcome {
        self.no_cycle_by_time(Span::default())?;
        self.speed_is_known()?;
        if self.st.per_revolution() {
            self.master_is_main(Span::default(), "a feed per revolution")?;
        }
        if modal.under != (self.st.plane(), self.st.length_unit()) {
            return self.fail_help(
                codes::S9015,
                0,
                Span::default(),
                "the plane or the unit was changed since MCALL: the hole would go elsewhere",
                "call the cycle again behind G17, G18, G19, G70 or G71",
            );
        }
        let feed_of_block = modal.feed_of_block;
        self.no_diameters(&modal.args.name, modal.hole.axis, Span::default())?;
        let mut hole = if modal.spindle == self.spindle_state() { modal.hole } else { self.hole_made_anew(modal)? };
        if feed_of_block && let Some(feed) = self.st.feed {
            hole.feed = feed;
        }
        self.drill(&hole)
    }

    fn spindle_state(&self) -> SpindleState {
        let State { speed, turn, constant_cut, ref tool, .. } = self.st;
        (speed, turn, constant_cut, self.st.per_revolution(), tool.active, tool.edge)
    }

    /// The hole of the modal call under the spindle of now.
    fn hole_made_anew(&mut self, mut modal: Box<ModalCycle>) -> Outcome<Drilling> {
        let here = std::mem::replace(&mut self.here, modal.here);
        let made = self.hole(&modal.args);
        self.here = here;
        let hole = made?;
        modal.hole = hole.clone();
        modal.spindle = self.spindle_state();
        self.modal_cycle = Some(modal);
        Ok(hole)
    }

    fn drill(&mut self, hole: &Drilling) -> Outcome {
        self.send_cycle(Cycle::Drilling(hole.clone()));
        Ok(())
    }

    fn send_cycle(&mut self, cycle: Cycle) {
        self.length_acts_along_z();
        let end = cycle.leaves(self.st.position.at());
        self.st.heading = super::tangent::Heading::Later;
        self.thread_chain = None;
        self.out.cycle(&cycle, &self.st.ctx, &self.here.origin);
        self.st.position.move_to(&end);
        if let Cycle::Drilling(hole) = &cycle
            && let Some(after) = hole.spindle_after()
        {
            self.st.turn = match after {
                Spindle::Start(turn) => Some(turn),
                _ => None,
            };
        }
    }

    /// The feed in force, for a cycle.
    fn cycle_feed(&mut self, args: &Arguments) -> Outcome<Feed> {
        self.speed_is_known()?;
        if self.st.feed_lost {
            return Err(Reported);
        }
        match self.st.feed {
            Some(feed) => {
                self.feed_kind_is_said();
                Ok(feed)
            }
            None => {
                self.st.feed_lost = true;
                self.fail_help(codes::S2040, 10860, args.span, "the cycle has no feed", "program F before the cycle")
            }
        }
    }

    /// Refuses the arguments of a cycle.
    fn cycle_fault<T>(&self, args: &Arguments, span: Span, alarm: u32, what: &str, help: &str) -> Outcome<T> {
        let code: &'static Code = codes::S2090;
        self.fail_help(code, alarm, span, format!("{}: {what}", args.name), help)
    }

    /// The cycles program their axes as any block does, so that lengths along X are diameters under DIAMON in some versions
    /// and radii in others.
    fn no_diameters(&self, name: &str, axis: Axis, span: Span) -> Outcome {
        if !self.is_diameter_axis(axis) || self.st.diameter_mode() == Diameter::Off {
            return Ok(());
        }
        self.fail_help(
            codes::S9015,
            0,
            span,
            format!("{name}: whether its lengths along {} are diameters under DIAMON is not documented", axis.letter()),
            "program DIAMOF before the cycle, and radii in it",
        )
    }

    /// A variant that is known, but not built.
    fn not_built<T>(&self, args: &Arguments, place: usize, what: &str) -> Outcome<T> {
        self.fail_help(
            codes::S9015,
            0,
            args.span_of(place),
            format!("{}: {what} is not supported", args.name),
            "use the plain variant of the cycle, or plain moves",
        )
    }

    /// An argument that the call gives and the cycle does not use.
    fn unused(&self, args: &Arguments, place: usize, name: &str, why: &str) {
        let message = format!("{}: `{name}` is not used {why}", args.name);
        self.report(Diagnostic::new(codes::S8035, self.loc(args.span_of(place)), message));
    }

    /// A reading of an argument that is not confirmed.
    fn reading(&self, args: &Arguments, place: usize, what: &str) {
        let message = format!("{}: {what}; this is not confirmed", args.name);
        let found = Diagnostic::new(codes::S8162, self.loc(args.span_of(place)), message);
        self.report(found.help("compare with what the machine does"));
    }

    /// A number that has to be there.
    fn needed(&self, args: &Arguments, place: usize, name: &str) -> Outcome<f64> {
        match args.number(place) {
            Some(value) => Ok(value),
            None if args.value(place).is_some() => self.cycle_fault(
                args,
                args.span_of(place),
                0,
                &format!("{name} (argument {place}) has to be a number"),
                "a number in quotation marks is a text",
            ),
            None => self.cycle_fault(
                args,
                args.span,
                0,
                &format!("{name} (argument {place}) is missing"),
                "arguments are counted by their commas",
            ),
        }
    }

    /// A length in mm that has to be there.
    fn needed_length(&self, args: &Arguments, place: usize, name: &str) -> Outcome<f64> {
        Ok(self.needed(args, place, name)? * self.st.length_unit())
    }

    fn length_of(&self, args: &Arguments, place: usize) -> Option<f64> {
        args.number(place).map(|value| value * self.st.length_unit())
    }

    /// Seconds from a dwell that is negative for turns of the spindle.
    fn dwell_of(&self, args: &Arguments, place: usize) -> Outcome<f64> {
        let value = args.or_zero(place);
        if value >= 0.0 { Ok(value) } else { self.spindle_turns_of(args, place, -value) }
    }

    /// Seconds that so many turns of the spindle take.
    fn spindle_turns_of(&self, args: &Arguments, place: usize, turns: f64) -> Outcome<f64> {
        if turns == 0.0 {
            return Ok(0.0);
        }
        match self.st.speed.filter(|speed| *speed > 0.0 && !self.st.constant_cut) {
            Some(speed) => Ok(turns * 60.0 / speed),
            None => self.cycle_fault(
                args,
                args.span_of(place),
                0,
                "a dwell in turns needs a fixed spindle speed",
                "program S before the cycle, or give the dwell in seconds",
            ),
        }
    }

    /// Where the tool stands in the turning plane: Z and the radius.
    fn turning_position(&mut self, span: Span) -> Outcome<Point2> {
        let plane = crate::geo::Plane::Zx;
        match self.st.position.in_plane(plane) {
            Some(at) => Ok(at),
            None => {
                let axis = if self.st.position.get(Axis::X).is_none() { Axis::X } else { Axis::Z };
                self.unknown_axis(axis, span)
            }
        }
    }

    /// Turning cycles work in G18.
    fn in_turning_plane(&self, args: &Arguments) -> Outcome {
        if self.st.plane() == crate::geo::Plane::Zx {
            return Ok(());
        }
        self.cycle_fault(args, args.span, 61101, "turning cycles work in G18", "program G18 before the cycle")
    }

    fn moved_in_plane(&mut self, point: Point2) -> Pos {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(self.st.plane(), point);
        end
    }
}

/// Cycles that are expanded.
pub(super) fn is_built(name: &str) -> bool {
    drilling::is_hole(name)
        || matches!(
            name,
            "HOLES1"
                | "HOLES2"
                | "CYCLE801"
                | "CYCLE802"
                | "CYCLE94"
                | "CYCLE96"
                | "CYCLE940"
                | "CYCLE97"
                | "CYCLE98"
                | "CYCLE99"
        )
}

fn most_arguments(name: &str) -> usize {
    if let Some(signature) = signatures::of(name) {
        return signature.parameters.len();
    }
    match name {
        "CYCLE81" => 9,
        "CYCLE82" => 14,
        "CYCLE83" => 20,
        "CYCLE84" => 24,
        "CYCLE840" => 20,
        "CYCLE85" => 11,
        "CYCLE86" => 14,
        "CYCLE87" => 6,
        "CYCLE88" => 7,
        "CYCLE89" => 9,
        "CYCLE94" | "CYCLE96" => 4,
        "CYCLE940" => 22,
        "CYCLE97" => 17,
        "CYCLE98" => 31,
        "CYCLE99" => 30,
        "HOLES1" => 11,
        "HOLES2" => 11,
        "CYCLE801" => 14,
        "CYCLE802" => 33,
        _ => 31,
    }
}
