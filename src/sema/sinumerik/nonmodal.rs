//! Codes of group 2 and their kin: dwell, tapping with a chuck, reference and fixed points.
//!
//! Source: S 1.5, 2.1, 4.2, 5.6 and 6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Function, Pos, Side};
use crate::machine::Axis;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core, Outcome};

/// Longest dwell.
const MOST_SECONDS: f64 = 1e5;

impl Channel<'_> {
    /// A code of group 2. True if it moved the tool as a block of moves does.
    pub(super) fn nonmodal_block(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome<bool> {
        let mut moved = false;
        if let Some((_, suppressed)) = w.code_of(Group::Suppression) {
            return self.core.not_alone(suppressed);
        }
        if code != GCode::G4 {
            self.st.threads.end_chain();
        }
        match code {
            GCode::G4 => {
                if let Some(m) = w.m.first() {
                    return self.core.not_alone(m.span);
                }
                self.dwell(span, w)?;
            }
            GCode::G63 => {
                self.core.say_once(span, codes::S8025::g63_tap_needs_compensating_chuck_on_target());
                self.technology(w)?;
                self.early_functions(w)?;
                moved = true;
                let feed = self.cutting_feed(w)?;
                let end = self.st.targets(&self.core, w)?;
                self.pending_must_be_done(span)?;
                if !end.known().is_empty() {
                    self.send(&end, Path::Line(feed));
                }
                w.beside.left_out.clear();
            }
            GCode::G74 | GCode::G75 => {
                self.technology(w)?;
                self.early_functions(w)?;
                self.fixed_point(code, span, w)?;
                w.beside.machine.clear();
                w.beside.left_out.clear();
            }
            _ => {
                let rapid = self.st.is(GCode::G0);
                let before = Path::straight(self.st.feed.word().filter(|_| !rapid));
                self.technology(w)?;
                self.early_functions(w)?;
                self.soft_block(code, span, w, before)?;
            }
        }
        self.core.nothing_left(w)?;
        Ok(moved)
    }

    /// STARTFIFO and STOPFIFO only steer the buffer of the control.
    pub(super) fn buffer_code(&mut self, code: GCode, span: Span, w: &Words) -> Outcome {
        let axis = w.axes.iter().next().and_then(|axis| w.axis(axis)).map(|given| given.span);
        if let Some(other) = axis.or(w.m.first().map(|m| m.span)) {
            return self.core.not_alone(other);
        }
        self.core.nothing_left(w)?;
        self.core.say_once(span, codes::S8002::words_that_only_shape_speed());
        self.st.codes.activate(code);
        Ok(())
    }

    fn dwell(&mut self, span: Span, w: &mut Words) -> Outcome {
        if let Some(axis) = w.axes.iter().next().and_then(|axis| w.axis(axis)) {
            return self.core.not_alone(axis.span);
        }
        let seconds = match (w.take(Address::F), w.s.pop()) {
            (Some(f), None) => f.value,
            (None, Some(s)) => {
                self.left.speed_is_known(&self.core, self.capture.is_some(), "this waits for turns of the spindle")?;
                let turns = self.st.spindles.fixed_turns(s.spindle);
                let speed = turns.filter(|speed| *speed > 0.0);
                match speed {
                    Some(speed) => s.value * 60.0 / speed,
                    None => {
                        return self.core.refuse(s.span, codes::S2045::dwell_in_turns_needs_fixed_spindle_speed());
                    }
                }
            }
            _ => {
                return self.core.refuse(span, codes::S2013::g4_takes_f_or_s());
            }
        };
        if !(0.0..=MOST_SECONDS).contains(&seconds) {
            return self.core.refuse(span, codes::P2003::dwell_lies_between_0());
        }
        if !self.st.taps.wait(seconds) {
            self.function(Function::Dwell(seconds));
        }
        Ok(())
    }

    /// A rapid to a place in machine coordinates, behind which its axes stand at no known place of the workpiece.
    pub(super) fn machine_rapid(&mut self, end: Pos) {
        if self.leaves_touched(end.known(), true).is_err() || self.stands_right(&end, Coords::Machine).is_err() {
            return;
        }
        let mv = Move { end, path: Path::Rapid, side: Side::None, coords: Coords::Machine };
        self.core.send_move(&mv, &self.st.ctx);
        if self.core.resolves() {
            self.st.compensation.is_over();
        }
        self.moved_by_machine(&end, &Pos::UNKNOWN);
    }

    /// G74 and G75: points that are machine data.
    fn fixed_point(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome {
        self.pending_must_be_done(span)?;
        let number = if code == GCode::G75 { self.core.fixed_point_number(w)? } else { 0 };
        let mut named: Vec<Axis> = w.axes.iter().collect();
        for machine_axis in &w.beside.machine {
            named.extend(self.axis_names.machine_axis(&self.core, *machine_axis)?);
        }
        let machine = &self.core.job.settings.machine;
        let (points, key) = match number {
            0 => (&machine.reference_point, "reference_point"),
            1 => (&machine.fixed_point[0], "fixed_point"),
            2 => (&machine.fixed_point[1], "fixed_point_2"),
            3 => (&machine.fixed_point[2], "fixed_point_3"),
            _ => (&machine.fixed_point[3], "fixed_point_4"),
        };
        let mut end = Pos::UNKNOWN;
        for axis in &named {
            match points.get(axis) {
                Some(value) => end.set(*axis, *value),
                None => {
                    let letter = axis.letter();
                    return self.core.refuse(
                        span,
                        codes::S9008::where_moves_to_is_machine_datum(&code.word(), &letter, &key)
                            .answer(Answer::entry("machine", key, letter)),
                    );
                }
            }
        }
        if self.st.side() != Side::None {
            return self.core.refuse(span, codes::S2080::fixed_point_is_approached_under_radius_compensation());
        }
        if named.is_empty() && w.beside.machine.is_empty() && w.beside.left_out.is_empty() {
            let found = codes::S8192::names_no_axis(&code.word()).at(self.core.loc(span));
            self.core.report(found.help(format!("name the axes, as in {} X1=0 Z1=0", code.word())));
        } else if !named.is_empty() {
            self.machine_rapid(end);
        }
        Ok(())
    }
}

impl Core<'_> {
    pub(super) fn nothing_left(&self, w: &Words) -> Outcome {
        let s = w.s.first().map(|s| s.span);
        let words = w.left().or(w.calls.passes).map(|given| given.span).or(s).or(w.h);
        match words.or(w.axis_word_left()).or(w.diameter.map(|(_, _, span)| span)) {
            Some(span) => self.not_alone(span),
            None => Ok(()),
        }
    }

    pub(super) fn not_alone<T>(&self, span: Span) -> Outcome<T> {
        self.refuse(span, codes::S2013::this_word_cannot_stand_beside_code())
    }

    /// FP of G75; without it the first fixed point is meant (MD 30600).
    fn fixed_point_number(&self, w: &mut Words) -> Outcome<u8> {
        let Some(given) = w.take(Address::Fp) else { return Ok(1) };
        match super::value::whole(given.value).and_then(|n| u8::try_from(n).ok()) {
            Some(n @ 1..=4) if f64::from(n) == given.value => Ok(n),
            _ => self.refuse(given.span, codes::P1003::there_is_no_fixed_point(&given.value)),
        }
    }
}
