//! Blocks of words: modal codes, then technology, then the motion, then what acts behind it.
//!
//! Source: S 0, 2.1, 2.6, 2.8 and 2.9 (docs/sources.md).

use crate::diag::{Diagnostic, codes};
use crate::ir::Pos;
use crate::ir::contour::Path;
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Block, Target};
use crate::sema::run::Where;
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::g_groups::{Code, Group};
use super::state::Diameter;
use super::vocabulary::{Address, Meaning};
use super::words::{Given, Mode, Words};
use super::{Outcome, Reported, Run};

/// Addresses that shape an arc.
const ARC_ADDRESSES: [Address; 9] = [
    Address::I,
    Address::J,
    Address::K,
    Address::I1,
    Address::J1,
    Address::K1,
    Address::Cr,
    Address::Ar,
    Address::Turn,
];

impl Run<'_> {
    pub(super) fn words_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mut words = self.words.take().unwrap_or_else(|| Box::new(Words::new()));
        words.clear();
        let result = self.sort_words(&mut words, block, text).and_then(|()| {
            if words.is_empty() {
                return Ok(());
            }
            if words.calls.word.is_some() || words.calls.number.is_some() {
                return self.call_block(&mut words, block, text);
            }
            self.begins_executing();
            self.run_words_of(&mut words, block)
        });
        if result.is_err() {
            self.lose_block(&words, block);
        }
        self.words = Some(words);
        result
    }

    /// After an error nobody knows where the axes of the block are.
    fn lose_block(&mut self, words: &Words, block: &Block) {
        let mut axes = words.axes;
        for word in &block.words {
            match word.target {
                Target::Letter(letter) => {
                    if let Some(axis) = self.axis_names.letter(letter).and_then(|named| named.axis) {
                        axes.insert(axis);
                    }
                }
                Target::Numbered(_, _, name) | Target::Name(name) => {
                    if let Meaning::Axis(NamedAxis { axis: Some(axis), .. }) = self.meaning(name) {
                        axes.insert(axis);
                    }
                }
                Target::Indexed(..) => axes = axes.union(AxisSet::MAIN),
                _ => {}
            }
        }
        let more = [Address::Ap, Address::Rp, Address::Ang, Address::Ar, Address::F];
        if ARC_ADDRESSES.iter().chain(&more).any(|address| words.get(*address).is_some()) {
            axes = axes.union(AxisSet::MAIN);
        }
        if words.get(Address::F).is_some() {
            self.st.feed.lose();
        }
        if words.get(Address::Ang).is_some() {
            self.st.pair.lose();
        }
        if !axes.is_empty() {
            self.st.position.lose(axes);
            self.st.pair.drop_first();
            self.lost();
        }
    }

    /// The words of a block that holds no call.
    pub(super) fn run_words_of(&mut self, w: &mut Words, block: &Block) -> Outcome {
        if self.st.threads.are_open() {
            self.beside_threads(w);
        }
        let triggers = self.st.modal_call.cycle().is_some()
            && (w.code_of(Group::Motion).is_some() || w.get(Address::F).is_some() || !w.s.is_empty());
        if !w.codes.is_empty() || w.diameter.is_some() || w.dynamics.is_some() {
            self.check_codes(w)?;
            if let Some((code, span)) = w.code_of(Group::Nonmodal) {
                self.modal_codes(w)?;
                return self.special_block(code, span, w);
            }
            if let Some((code, span)) = w.code_of(Group::Frame) {
                self.modal_codes(w)?;
                return self.frame_block(code, span, w);
            }
            self.modal_codes(w)?;
            if let Some((code, span)) = w.code_of(Group::Buffer).filter(|(code, _)| *code != Code::FIFOCTRL) {
                return self.buffer_code(code, span, w);
            }
        }
        if self.st.codes.of(Group::Motion).is_tapping() && !w.axes.is_empty() {
            self.only_tapping(w)?;
        }
        self.technology(w)?;
        self.early_functions(w)?;
        let corner_before = self.st.corners.open.site();
        let moved = self.motion(w, block)?;
        if moved && self.st.corners.open.site() == corner_before {
            self.st.corners.open.close();
        }
        self.block_behind_corner(moved)?;
        if let Some(left) = w.left() {
            // The control tells a code that is written from one that holds on.
            let alarm = if w.code_of(Group::Motion).is_some() { 12110 } else { 15460 };
            return self.does_not_fit_code(left.span, alarm);
        }
        if let Some(axis) = w.beside.machine.first() {
            return self.unnamed_axis(*axis);
        }
        if let Some(passes) = w.calls.passes {
            return self.does_not_fit(passes.span);
        }
        self.left_out_under_modal_call(w)?;
        self.late_functions(w)?;
        if moved && !self.has_ended() {
            self.call_modal()?;
        } else if triggers && !moved {
            self.warn_of_trigger(block.span);
        }
        Ok(())
    }

    /// A control may drill behind a bare G0 or F, too; read here: behind blocks that name an axis only.
    fn warn_of_trigger(&self, span: Span) {
        if self.job.diags.first_time(codes::S8033) {
            let message =
                "under MCALL of a drilling cycle this block moves no axis; it is read as one that drills nothing";
            let found = Diagnostic::new(codes::S8033, self.loc(span), message);
            self.report(found.help("put it in front of MCALL: some controls drill behind it once more"));
        }
    }

    pub(super) fn does_not_fit<T>(&self, span: Span) -> Outcome<T> {
        self.does_not_fit_code(span, 12110)
    }

    fn does_not_fit_code<T>(&self, span: Span, alarm: u32) -> Outcome<T> {
        self.fail_help(
            codes::S2012.alarm(alarm),
            span,
            "the word does not fit the other words of the block",
            "check which G code of group 1 is in force, and what it takes",
        )
    }

    // Motion.

    /// The motion of the block. True if axes moved along a path.
    fn motion(&mut self, w: &mut Words, block: &Block) -> Outcome<bool> {
        let interpolation = self.st.codes.of(Group::Motion);
        self.modal_contour_words(w)?;
        let suppressed = w.code_of(Group::Suppression).filter(|(code, _)| *code != Code::SUPD);
        let polar = w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some();
        let round = matches!(interpolation, Code::G2 | Code::G3);
        let arc = round && ARC_ADDRESSES.iter().any(|address| w.get(*address).is_some());
        let moves = !w.axes.is_empty() || polar || arc || w.get(Address::Ang).is_some();
        if !w.beside.positioning.is_empty() {
            self.st.threads.end_chain();
            self.positioning(w)?;
        }
        if let Some(angle) = w.get(Address::Ang)
            && !matches!(interpolation, Code::G0 | Code::G1)
        {
            let help = "program G1 or G0 in front of it";
            self.st.pair.drop_first();
            return self.fail_help(codes::S2070.alarm(10792), angle.span, "ANG= is for straight lines only", help);
        }
        if !moves && matches!(interpolation, Code::G33 | Code::G331 | Code::G332) {
            let lead = [Address::I, Address::J, Address::K].into_iter().find_map(|address| w.get(address));
            if let Some(lead) = lead {
                let help = "program the end point of the thread with it";
                return self.fail_help(codes::S2081.alarm(16740), lead.span, "the thread block moves no axis", help);
            }
        }
        if !moves {
            if self.has_corner_words(w) {
                return self.no_corner(block.span);
            }
            if let Some((_, span)) = w.code_of(Group::Suppression).filter(|_| w.beside.positioning.is_empty()) {
                self.control_words_are_left_out(span);
            }
            return Ok(false);
        }
        if interpolation != Code::G33 {
            self.st.threads.end_chain();
        }
        if let Some((_, span)) = suppressed {
            return self.machine_move(w, interpolation, span).map(|()| true);
        }
        if let Some((_, span)) = w.code_of(Group::Suppression) {
            self.suppressed_tool(w, span)?;
        }
        let in_plane = polar || w.get(Address::Ang).is_some() || {
            let [first, second, _] = self.st.roles();
            w.axes.contains(first) || w.axes.contains(second)
        };
        self.check_offsets(w)?;
        self.check_start_of_compensation(interpolation, in_plane, block.span)?;
        if interpolation == Code::G33 {
            self.no_corner_at_thread(w, block.span)?;
        }
        let corner = self.corner_words(w)?;
        if !matches!(interpolation, Code::G0 | Code::G1) {
            self.only_lines_in_a_pair(block.span)?;
        }
        match interpolation {
            Code::G0 | Code::G1 => self.line_block(w, interpolation, polar, corner.as_ref())?,
            Code::G2 | Code::G3 => self.circle_block(w, interpolation == Code::G3, polar)?,
            Code::CIP => self.via_block(w)?,
            Code::CT => self.tangent_block(w)?,
            Code::G33 => self.thread_block(w, block.span)?,
            Code::G331 | Code::G332 => {
                self.tap_block(w, interpolation, block.span)?;
                return Ok(true);
            }
            _ => return self.check_interpolation(interpolation, block.span).and(Err(Reported)),
        }
        // The first line of a pair sends its corner when its end is known.
        if !self.st.pair.is_open() {
            self.send_corner(corner);
        }
        Ok(true)
    }

    /// Under D0 the control counts from the spindle nose, which the target cannot say.
    fn check_offsets(&self, w: &Words) -> Outcome {
        // A contour is a shape: no tool follows it.
        let off = !self.is_capturing() && self.st.tool.is_without_offset();
        if !off || self.st.offsets.in_machine() {
            return Ok(());
        }
        let [_, _, third] = self.st.roles();
        let lengths = if self.st.channel.lathe { [Axis::X, Axis::Z] } else { [third, third] };
        match w.axes.iter().find(|axis| lengths.contains(axis)).and_then(|axis| w.axis(axis)) {
            Some(given) => self.fail_help(
                codes::S9016,
                given.span,
                "under D0 the position counts without the length of the tool",
                "program the retraction in machine coordinates (SUPA, G53), or select D1 before",
            ),
            None => Ok(()),
        }
    }

    pub(super) fn check_interpolation(&self, code: Code, span: Span) -> Outcome {
        let what = match code {
            Code::G0 | Code::G1 | Code::G2 | Code::G3 | Code::CIP | Code::CT => return Ok(()),
            Code::G33 | Code::G331 | Code::G332 => return Ok(()),
            Code::G34 | Code::G35 => "a thread of changing lead",
            Code::ASPLINE | Code::BSPLINE | Code::CSPLINE | Code::POLY => "a spline or polynomial",
            Code::INVCW | Code::INVCCW => "an involute",
            Code::G335 | Code::G336 => "a thread on an arc",
            _ => "an interpolation of the machine builder",
        };
        let message = format!("{} is {what}, which plain G-code cannot say", code.word());
        self.fail_help(codes::S9002, span, message, "have the CAM system put out lines and arcs")
    }

    fn line_block(
        &mut self,
        w: &mut Words,
        code: Code,
        polar: bool,
        corner: Option<&crate::ir::contour::Corner>,
    ) -> Outcome {
        let path = Path::straight(self.path_feed(w, code == Code::G0)?);
        if w.get(Address::Ang).is_some() || self.st.pair.is_open() {
            return self.angle_block(w, path, corner);
        }
        let end = if polar { self.polar_end(w)? } else { self.targets(w)? };
        self.send(&end, path);
        Ok(())
    }

    /// The programmed end points of all axes of the block.
    #[inline]
    pub(super) fn targets(&mut self, w: &Words) -> Outcome<Pos> {
        let mut end = Pos::UNKNOWN;
        for axis in w.axes.iter() {
            if let Some(given) = w.axis(axis) {
                let value = self.target(axis, given)?;
                end.set(axis, value);
            }
        }
        Ok(end)
    }

    /// The end point of one axis in mm (radius) or degrees.
    #[inline]
    pub(super) fn target(&mut self, axis: Axis, given: Given) -> Outcome<f64> {
        if axis.is_rotary() {
            return self.rotary_target(axis, given);
        }
        let incremental = match given.mode {
            Mode::Plain => self.st.is(Code::G91),
            Mode::Ac | Mode::Dac | Mode::Rac => false,
            Mode::Ic | Mode::Dic | Mode::Ric => true,
            Mode::Dc | Mode::Acp | Mode::Acn => {
                let message = format!("{} is no rotary axis", axis.letter());
                let alarm = match given.mode {
                    Mode::Dc => 16800,
                    Mode::Acp => 16810,
                    _ => 16820,
                };
                return self.fail_help(
                    codes::S2061.alarm(alarm),
                    given.span,
                    message,
                    "DC, ACP and ACN are for rotary axes",
                );
            }
            Mode::Quick => return self.does_not_fit(given.span),
        };
        let value = self.length(axis, given, incremental)?;
        if incremental { Ok(self.increment_base(axis, given.span)? + value) } else { Ok(value) }
    }

    /// A length along an axis as a radius in mm.
    #[inline]
    pub(super) fn length(&self, axis: Axis, given: Given, incremental: bool) -> Outcome<f64> {
        let value = given.value * self.st.length_unit();
        let diameter = match given.mode {
            Mode::Dac | Mode::Dic | Mode::Rac | Mode::Ric => {
                if !self.is_diameter_axis(axis) {
                    return self.no_diameter_axis(given.span);
                }
                matches!(given.mode, Mode::Dac | Mode::Dic)
            }
            _ if !self.is_diameter_axis(axis) => false,
            _ => match self.st.diameter_mode() {
                Diameter::Off => false,
                Diameter::On => true,
                Diameter::Absolute => !incremental,
            },
        };
        Ok(if diameter { value / 2.0 } else { value })
    }

    #[inline]
    pub(super) fn is_diameter_axis(&self, axis: Axis) -> bool {
        self.job.settings.machine.diameter_axis == Some(axis)
    }

    pub(super) fn no_diameter_axis<T>(&self, span: Span) -> Outcome<T> {
        if let Some(axis) = self.job.settings.machine.diameter_axis {
            let message = format!("only {} counts in diameters (MD 20100)", axis.letter());
            let help = "DAC, DIC, RAC, RIC and DIAMONA[…] are for this axis; program the other one as it is";
            return self.fail_help(codes::S2060.alarm(16510), span, message, help);
        }
        self.fail_help(
            codes::S2060.alarm(16510),
            span,
            "no diameter axis is configured (MD 20100)",
            "set `[machine] diameter_axis = \"X\"`, and `kind = \"lathe\"` for a lathe",
        )
    }

    /// What an increment counts from: the value last programmed, or where the axis stands (SD 42440).
    pub(super) fn increment_base(&mut self, axis: Axis, span: Span) -> Outcome<f64> {
        if self.st.position.is_lost(axis) {
            return Err(Reported);
        }
        let Some(at) = self.st.position.get(axis) else { return self.unknown_axis(axis, span) };
        let programmed = self.st.position.programmed(axis).unwrap_or(at);
        if (programmed - at).abs() <= 1e-9 {
            return Ok(at);
        }
        let with_offset = match self.vars.system.get("$SC_FRAME_OFFSET_INCR_PROG").and_then(super::value::Val::truth) {
            Some(set) => set,
            None => self.job.settings.control.siemens.frame_offset_incremental.unwrap_or(true),
        };
        let chosen = if with_offset { programmed } else { at };
        if self.job.settings.control.siemens.frame_offset_incremental.is_some() {
            return Ok(chosen);
        }
        let found = Diagnostic::new(
            codes::S8007,
            self.loc(span),
            format!("the increment of {} follows a change of the frame", axis.letter()),
        );
        let how = if with_offset {
            "the frame is travelled, too (SD 42440 = 1)"
        } else {
            "only the increment is travelled (SD 42440 = 0)"
        };
        self.report(found.here(how).help("set `[control] sd42440`, or program the position absolutely"));
        Ok(chosen)
    }

    pub(super) fn unknown_axis<T>(&self, axis: Axis, place: impl Into<Where>) -> Outcome<T> {
        if self.st.position.is_lost(axis) {
            return Err(Reported);
        }
        self.fail_help(
            codes::S2042,
            place,
            format!("where {} stands is not known", axis.letter()),
            self.st.position.help(axis, "program the axis once in absolute coordinates in front of this block"),
        )
    }
}
