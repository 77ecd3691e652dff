//! Blocks that are no moves: dwell, reference points, limits, frames, calls and procedures.
//!
//! Source: reference sections 1.5, 2.1, 4.2, 5.6 and 6.

use crate::diag::codes;
use crate::ir::contour::{Coords, EndPoint, Move, Path};
use crate::ir::{Function, Pos, Side};
use crate::machine::Axis;
use crate::parser::sinumerik::ast::{Block, Formula};
use crate::text::Span;

use super::frames::FrameValue;
use super::value::{Val, to_text, whole};
use super::vocabulary::{Address, Code, Meaning, Procedure, word};
use super::words::{CallWord, Words};
use super::{Outcome, Run};

/// Longest dwell.
const MOST_SECONDS: f64 = 1e5;

impl Run<'_> {
    /// A code of group 2.
    pub(super) fn special_block(&mut self, code: Code, span: Span, w: &mut Words, block: &Block) -> Outcome {
        match code {
            Code::G4 => self.dwell(span, w)?,
            Code::G63 => {
                self.technology(w)?;
                self.early_functions(w)?;
                let feed = self.path_feed(w, false)?;
                let end = self.targets(w)?;
                self.pending_must_be_done(span)?;
                self.send(&end, Path::Line, feed);
            }
            Code::G74 | Code::G75 => self.fixed_point(code, span, w)?,
            _ => {
                let message = format!("{} is not supported", word(code));
                return self.fail_help(
                    codes::S9001,
                    0,
                    span,
                    message,
                    "program the approach and the retraction by plain moves",
                );
            }
        }
        self.nothing_left(w, block)?;
        self.late_functions(w)
    }

    fn nothing_left(&self, w: &Words, block: &Block) -> Outcome {
        if let Some(given) = w.left() {
            return self.not_alone(given.span);
        }
        if let Some(s) = w.s.first() {
            return self.not_alone(s.span);
        }
        let _ = block;
        Ok(())
    }

    fn not_alone<T>(&self, span: Span) -> Outcome<T> {
        self.fail_help(
            codes::S2013,
            12120,
            span,
            "this word cannot stand beside the code that shapes the block",
            "give it a block of its own",
        )
    }

    fn dwell(&mut self, span: Span, w: &mut Words) -> Outcome {
        if let Some(axis) = w.axes.iter().next().and_then(|axis| w.axis(axis)) {
            return self.not_alone(axis.span);
        }
        let seconds = match (w.take(Address::F), w.s.pop()) {
            (Some(f), None) => f.value,
            (None, Some(s)) => {
                let speed = self.st.speed.filter(|speed| *speed > 0.0 && !self.st.constant_cut);
                match speed {
                    Some(speed) => s.value * 60.0 / speed,
                    None => {
                        let help = "give the time in seconds: G4 F1.5";
                        return self.fail_help(
                            codes::S2045,
                            10900,
                            s.span,
                            "a dwell in turns needs a fixed spindle speed",
                            help,
                        );
                    }
                }
            }
            _ => {
                let help = "G4 F1.5 waits seconds, G4 S20 turns of the spindle; G4 P is of another language";
                return self.fail_help(codes::S2013, 12120, span, "G4 takes F or S", help);
            }
        };
        if !(0.0..=MOST_SECONDS).contains(&seconds) {
            return self.fail(codes::S2041, 0, span, "a dwell lies between 0 and 100000 seconds");
        }
        self.function(Function::Dwell(seconds));
        Ok(())
    }

    /// G74 and G75: points that are machine data.
    fn fixed_point(&mut self, code: Code, span: Span, w: &mut Words) -> Outcome {
        self.pending_must_be_done(span)?;
        w.take(Address::Fp);
        let named: Vec<Axis> = w.axes.iter().chain(w.machine_axes.iter().map(|(axis, _)| *axis)).collect();
        let machine = &self.job.settings.machine;
        let (points, key) = if code == Code::G74 {
            (&machine.reference_point, "reference_point")
        } else {
            (&machine.fixed_point, "fixed_point")
        };
        let mut end = Pos::UNKNOWN;
        for axis in &named {
            match points.get(axis) {
                Some(value) => end.set(*axis, *value),
                None => {
                    let letter = axis.letter();
                    return self.fail_help(
                        codes::S9008,
                        0,
                        span,
                        format!("where {} moves {letter} to is a machine datum", word(code)),
                        &format!("give it in machine coordinates: `[machine] {key} = {{ {letter} = 0.0 }}`"),
                    );
                }
            }
        }
        if self.st.side() != Side::None {
            return self.fail(codes::S2080, 14091, span, "a fixed point is approached under radius compensation");
        }
        let mv = Move {
            end: EndPoint::Cartesian(end),
            path: Path::Rapid,
            feed: None,
            side: Side::None,
            coords: Coords::Machine,
        };
        self.out.movement(&mv, &self.st.ctx, &self.here.origin);
        for axis in named {
            self.st.forget(axis);
        }
        Ok(())
    }

    // Frames, poles and limits.

    /// A code of group 3.
    pub(super) fn frame_block(&mut self, code: Code, span: Span, w: &mut Words, block: &Block) -> Outcome {
        match code {
            Code::G110 | Code::G111 | Code::G112 => self.pole_block(code, span, w)?,
            Code::G25 | Code::G26 => {
                w.s.clear();
                self.note_once(codes::S8013, span, "working-area and spindle limits (G25, G26) are left out");
            }
            Code::G58 | Code::G59 => self.axial_shift(code, span, w)?,
            _ => {
                self.pending_must_be_done(span)?;
                self.frame_statement(code, span, w)?;
            }
        }
        if let Some(m) = w.m.first() {
            return self.not_alone(m.span);
        }
        self.nothing_left(w, block)
    }

    fn frame_statement(&mut self, code: Code, span: Span, w: &mut Words) -> Outcome {
        let adds = matches!(code, Code::ATRANS | Code::AROT | Code::ASCALE | Code::AMIRROR);
        if self.st.side() != Side::None {
            return self.fail_help(
                codes::S2080,
                0,
                span,
                "the frame changes while radius compensation is on",
                "program G40 in a block in front of it",
            );
        }
        let rpl = w.take(Address::Rpl);
        let bare = w.axes.is_empty() && rpl.is_none();
        let frame = match code {
            Code::TRANS | Code::ATRANS => {
                let mut values = Vec::new();
                for axis in w.axes.iter() {
                    let Some(given) = w.axis(axis) else { continue };
                    let unit = if axis.is_rotary() { 1.0 } else { self.st.length_unit() };
                    values.push((axis, given.value * unit));
                }
                if adds {
                    self.st.programmable = self.st.programmable.translated(&values);
                    self.refresh_frame();
                    return Ok(());
                }
                FrameValue::shifted(&values)
            }
            Code::ROT | Code::AROT => {
                let mut angles = self.geometry_values(w, 0.0)?;
                if let Some(rpl) = rpl {
                    if !w.axes.is_empty() {
                        return self.not_alone(rpl.span);
                    }
                    let [_, _, third] = self.st.roles();
                    if let Some(angle) = angles.get_mut(third.index()) {
                        *angle = rpl.value;
                    }
                }
                FrameValue::rotated(angles)
            }
            Code::SCALE | Code::ASCALE => {
                let scale = self.geometry_values(w, 1.0)?;
                if scale.contains(&0.0) {
                    return self.fail(codes::S2034, 0, span, "a scaling factor is 0");
                }
                FrameValue::scaled(scale)
            }
            Code::MIRROR | Code::AMIRROR => {
                self.geometry_values(w, 0.0)?;
                let mut mirror = [false; 3];
                for axis in w.axes.iter() {
                    if let Some(place) = mirror.get_mut(axis.index()) {
                        *place = true;
                    }
                }
                FrameValue::mirrored(mirror)
            }
            _ => {
                let message = format!("{} turns the plane by solid angles, which is not supported", word(code));
                return self.fail_help(codes::S9001, 0, span, message, "use ROT with angles about the axes");
            }
        };
        self.st.programmable = match (adds, bare) {
            (true, true) => return Ok(()),
            (true, false) => self.st.programmable.chain(&frame),
            // Without axes the whole programmable frame goes.
            (false, true) => FrameValue::default(),
            (false, false) => frame,
        };
        self.refresh_frame();
        Ok(())
    }

    fn geometry_values(&self, w: &Words, neutral: f64) -> Outcome<[f64; 3]> {
        let mut values = [neutral; 3];
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            match values.get_mut(axis.index()) {
                Some(place) => *place = given.value,
                None => {
                    let message = format!("{} is no geometry axis", axis.letter());
                    return self.fail(codes::S2031, 16440, given.span, message);
                }
            }
        }
        Ok(values)
    }

    /// G58 and G59: parts of the programmable shift; settable offsets on small controls.
    fn axial_shift(&mut self, code: Code, span: Span, w: &mut Words) -> Outcome {
        let small = self.job.settings.control.sinumerik == "802d";
        if w.axes.is_empty() && !small {
            let message = format!("{} has no axes", word(code));
            let help = "on an 802D it selects a work offset: set `[control] sinumerik = \"802d\"`";
            return self.fail_help(codes::S2013, 12120, span, message, help);
        }
        if small && !w.axes.is_empty() {
            let message = format!("{} selects a work offset on an 802D and moves in the same block", word(code));
            return self.fail_help(codes::S2013, 0, span, message, "give the selection a block of its own");
        }
        if w.axes.is_empty() && small {
            let number = if code == Code::G58 { 5 } else { 6 };
            return self.work_offset(number + 1, span);
        }
        self.pending_must_be_done(span)?;
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            let unit = if axis.is_rotary() { 1.0 } else { self.st.length_unit() };
            let place =
                if code == Code::G58 { &mut self.st.programmable.shift } else { &mut self.st.programmable.fine };
            if let Some(place) = place.get_mut(axis.index()) {
                *place = given.value * unit;
            }
        }
        self.refresh_frame();
        Ok(())
    }

    // Calls.

    /// A block with a call: of a procedure of the language or of a program.
    pub(super) fn call_block(&mut self, w: &mut Words, block: &Block, text: &[u8]) -> Outcome {
        let passes = w.passes.take();
        if let Some((name, span)) = w.l.take() {
            if w.call.is_some() || self.has_other_words(w) {
                return self.call_not_alone(span);
            }
            return self.call_program(&name, span, None, passes, block, text);
        }
        let Some(call) = w.call else { return Ok(()) };
        if let Meaning::Procedure(procedure) = call.meaning {
            w.passes = passes;
            let alone = matches!(
                procedure,
                Procedure::ExecString | Procedure::Return | Procedure::SetAlarm | Procedure::Refused(_)
            );
            if alone && (self.has_other_words(w) || w.passes.is_some()) {
                return self.call_not_alone(call.span);
            }
            self.procedure(procedure, call, w, block, text)?;
            return self.rest_of_block(w, block);
        }
        // A name in a definition file may be a macro.
        if !self.definitions_known() && self.macros.contains_key(&call.name) {
            return self.again(block, text);
        }
        self.begins_executing();
        if self.has_other_words(w) {
            // Modal words beside the name of a program: an unknown word most often.
            return self.unknown_word(call);
        }
        let name = self.symbols.name(call.name).to_owned();
        self.call_program(&name, call.span, Some(call), passes, block, text)
    }

    /// A program of the user with the name of a cycle goes before it.
    pub(super) fn own_program(&mut self, name: &str) -> bool {
        let file = self.programs.units[self.unit()].file;
        let listed = self.programs.list(&self.job, file).is_ok();
        if listed && (self.programs.find_in_file(file, name).is_some() || self.programs.find_in_file(0, name).is_some())
        {
            return true;
        }
        let identity = self.job.sources.identity(self.here.file);
        let request = crate::text::Request { from: &identity, name, extensions: &["SPF"] };
        self.job.files.open(&request).is_ok()
    }

    fn has_other_words(&self, w: &Words) -> bool {
        !w.axes.is_empty()
            || !w.codes.is_empty()
            || !w.m.is_empty()
            || !w.s.is_empty()
            || w.has_addresses()
            || w.h.is_some()
    }

    fn call_not_alone<T>(&self, span: Span) -> Outcome<T> {
        self.fail_help(
            codes::S2013,
            12120,
            span,
            "a call stands beside other words",
            "give the call a block of its own",
        )
    }

    fn unknown_word<T>(&self, call: CallWord) -> Outcome<T> {
        let name = self.symbols.name(call.name);
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        if letters.len() < name.len() && matches!(self.vocabulary.get(letters), Some(Meaning::Address(_))) {
            let digits = &name[letters.len()..];
            return self.fail_help(
                codes::S1001,
                12080,
                call.span,
                format!("`=` is missing in `{name}`"),
                &format!("an address of more than one letter takes `=`: {letters}={digits}"),
            );
        }
        let mut known: Vec<&str> = self.vocabulary.keys().copied().collect();
        known.sort_unstable();
        let like = crate::machine::tree::did_you_mean(name, known);
        let help = match like {
            Some(like) => format!("did you mean `{like}`?"),
            None => "a call needs a block of its own; an address takes `=`".to_owned(),
        };
        self.fail_help(codes::S2001, 12550, call.span, format!("the word `{name}` is not known here"), &help)
    }

    fn call_program(
        &mut self,
        name: &str,
        span: Span,
        call: Option<CallWord>,
        passes: Option<super::words::Given>,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let passes = match passes {
            Some(given) => self.check_passes(given.value, given.span)?,
            None => 1,
        };
        let arguments = match call.and_then(|call| call.args) {
            Some(args) => self.arguments(args, block, text)?,
            None => Vec::new(),
        };
        self.pending_must_be_done(span)?;
        let result = self.find_program(name, span);
        let unit = match result {
            Ok(unit) => unit,
            Err(reported) => {
                // What it would have done is not known.
                self.st.lose(Axis::ALL.into_iter().collect());
                self.lost();
                return Err(reported);
            }
        };
        self.call_unit(unit, arguments, passes, false)
    }

    /// A word of the language that is written like a call.
    fn procedure(
        &mut self,
        procedure: Procedure,
        call: CallWord,
        w: &mut Words,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let name = self.symbols.name(call.name).to_owned();
        let formulas: Vec<Formula> = call.args.map(|args| block.arguments(args).to_vec()).unwrap_or_default();
        if let Some(result) = self.machining_cycle(&name, call, block, text) {
            if self.has_other_words(w) {
                return self.call_not_alone(call.span);
            }
            return result;
        }
        match procedure {
            Procedure::NoEffect => Ok(()),
            Procedure::Dynamics => {
                self.note_once(codes::S8002, call.span, "words that only shape speed and accuracy are left out");
                Ok(())
            }
            Procedure::Message => self.message(&formulas, block, text),
            Procedure::SetAlarm => {
                let mut shown = String::new();
                if let Some(formula) = formulas.first()
                    && let Ok(number) = self.number(*formula, block, text)
                    && !(60_000.0..70_000.0).contains(&number)
                {
                    self.ended.set(true);
                    let message = format!("SETAL({number}) is no alarm of a program");
                    return self.fail_help(
                        codes::S2027,
                        15700,
                        call.span,
                        message,
                        "programs have the alarms 60000 to 69999",
                    );
                }
                for formula in &formulas {
                    let value = self.eval(*formula, block, text)?;
                    if let Some(text) = to_text(&value) {
                        shown = format!("{shown} {}", String::from_utf8_lossy(&text));
                    }
                }
                self.ended.set(true);
                self.fail_help(
                    codes::S2027,
                    0,
                    call.span,
                    format!("the program raises alarm{shown}"),
                    "it found its own data wrong: look at the conditions in front of SETAL",
                )
            }
            Procedure::SetMaster => {
                let n = match formulas.first() {
                    Some(formula) => self.number(*formula, block, text)?,
                    None => 1.0,
                };
                match whole(n).and_then(|n| u8::try_from(n).ok()).filter(|n| (1..=20).contains(n)) {
                    Some(n) => {
                        self.st.master = n;
                        if n != 1 {
                            self.note_once(
                                codes::S8014,
                                call.span,
                                format!("spindle {n} is the master: it is printed as the main spindle"),
                            );
                        }
                        Ok(())
                    }
                    None => self.fail(codes::S2045, 0, call.span, format!("there is no spindle {n}")),
                }
            }
            Procedure::Channel => {
                self.note_once(
                    codes::S8015,
                    call.span,
                    "words that synchronize channels are left out: the output has one channel",
                );
                Ok(())
            }
            Procedure::Interrupt => {
                self.note_once(codes::S8016, call.span, "interrupt programs are left out");
                Ok(())
            }
            Procedure::FileAccess => {
                self.note_once(codes::S8017, call.span, "reading and writing files of the control is left out");
                if name == "READ" {
                    return self.fail(codes::S9001, 0, call.span, "READ takes values from a file of the control");
                }
                Ok(())
            }
            Procedure::CallPath => Ok(()),
            Procedure::ExecString => self.exec_string(&formulas, call.span, block, text),
            Procedure::Return => self.return_block(&formulas, call.span),
            Procedure::TransformationOff if formulas.is_empty() => Ok(()),
            Procedure::TransformationOff => {
                self.fail(codes::S2021, 12090, call.span, format!("{name} takes no argument"))
            }
            Procedure::Swivel if formulas.is_empty() => Ok(()),
            Procedure::Swivel => self.fail_help(
                codes::S9006,
                0,
                call.span,
                "CYCLE800 swivels the working plane, which plain G-code in three axes cannot say",
                "have the CAM system put out the swivelled part by itself",
            ),
            Procedure::GeoAxes => self.geo_axes(&formulas, call.span, block, text),
            Procedure::EndLabel => Ok(()),
            Procedure::DiameterChannel => {
                self.st.diameter = None;
                Ok(())
            }
            Procedure::Refused(_) if self.own_program(&name) => {
                self.call_program(&name, call.span, Some(call), None, block, text)
            }
            Procedure::Refused(what) => {
                self.st.lose(Axis::ALL.into_iter().collect());
                self.lost();
                let code = if what.contains("transformation") { codes::S9006 } else { codes::S9005 };
                self.fail_help(
                    code,
                    0,
                    call.span,
                    format!("{name} ({what}) is not supported"),
                    "replace it by plain moves, or compile the program without it",
                )
            }
        }
    }

    /// Words beside a procedure that has no effect.
    fn rest_of_block(&mut self, w: &mut Words, block: &Block) -> Outcome {
        if self.has_other_words(w) || w.passes.is_some() {
            w.call = None;
            self.begins_executing();
            return self.words_again(w, block);
        }
        Ok(())
    }

    fn message(&mut self, formulas: &[Formula], block: &Block, text: &[u8]) -> Outcome {
        let Some(formula) = formulas.first().filter(|formula| !formula.is_missing()) else { return Ok(()) };
        let value = self.eval(*formula, block, text)?;
        if self.job.settings.output.comments
            && let Some(shown) = to_text(&value)
            && !shown.is_empty()
        {
            self.function(Function::Comment(shown));
        }
        Ok(())
    }

    fn return_block(&mut self, formulas: &[Formula], span: Span) -> Outcome {
        if !formulas.is_empty() {
            return self.fail_help(
                codes::S9001,
                0,
                span,
                "RET with a jump target is not supported",
                "return, and jump in the calling program",
            );
        }
        // A subprogram that is compiled by itself ends here.
        if self.in_main() && self.programs.units[self.unit()].kind == super::programs::UnitKind::Sub {
            self.pending_must_be_done(span)?;
            self.function(Function::End { rewind: false });
            self.ended.set(true);
            return Ok(());
        }
        if self.in_main() {
            return self.fail_help(codes::S2020, 14091, span, "RET stands in the main program", "end it by M30");
        }
        self.pending_must_be_done(span)?;
        self.leave_program();
        Ok(())
    }

    fn exec_string(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let [formula] = *formulas else {
            return self.fail(codes::S2021, 14021, span, "EXECSTRING takes one text");
        };
        match self.eval(formula, block, text)? {
            Val::Text(line) => self.execute_line(&line, span),
            other => {
                self.fail(codes::S2005, 12150, formula.span, format!("a text is needed, this is {}", other.what()))
            }
        }
    }

    fn geo_axes(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        for pair in formulas.chunks(2) {
            let [number, axis] = pair else { break };
            let n = self.number(*number, block, text)?;
            let place = whole(n).and_then(|n| usize::try_from(n).ok()).and_then(|n| n.checked_sub(1));
            let same =
                match (place.and_then(|at| self.st.geometry_axes.get(at)).copied(), self.eval(*axis, block, text)?) {
                    (Some(known), Val::Axis(axis)) => known == axis,
                    _ => false,
                };
            if !same {
                return self.fail_help(
                    codes::S9001,
                    0,
                    span,
                    "GEOAX gives the geometry axes other names",
                    "name the axes of the machine by `[machine] geometry_axes`",
                );
            }
        }
        Ok(())
    }
}
