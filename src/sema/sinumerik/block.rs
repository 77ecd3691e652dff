//! Blocks of words: modal codes, then technology, then the motion.
//!
//! Source: S 0, 2.1, 2.6, 2.8 and 2.9 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::ir::contour::Path;
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Block, Target};
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::corners::corner_of;
use super::g_functions::Whole;
use super::g_groups::{GCode, Group};
use super::names::Names;
use super::vocabulary::{Address, Meaning};
use super::words::Words;
use super::{Channel, Core, Outcome, Reported, State};

/// Addresses that shape an arc.
pub(super) const ARC_ADDRESSES: [Address; 9] = [
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

/// What is to be done after the words of a block: its M functions, and what runs modally.
pub(super) struct AfterBlock {
    /// Axes moved along a path.
    pub moved: bool,
    /// A control may run what is modal after it, though no axis is named.
    pub triggers: bool,
}

impl Channel<'_> {
    /// Carries out the words of a block that holds no call; `None` where nothing acts after it.
    pub(super) fn run_words(&mut self, w: &mut Words, block: &Block) -> Outcome<Option<AfterBlock>> {
        let motion = self.st.codes.of(Group::Motion);
        if self.st.taps.are_open() && self.st.taps.end_before(w, motion) {
            self.tapping_ends();
        }
        self.st.threads.go_on_beside(&self.core, w);
        if let Some(capture) = &mut self.capture {
            capture.words(&self.core, w)?;
        }
        let triggers = self.st.modal_call.cycle().is_some()
            && (w.code_of(Group::Motion).is_some() || w.get(Address::F).is_some() || !w.s.is_empty());
        if let Some(probe) = w.probe
            && let Some((_, span)) =
                [Group::Nonmodal, Group::Frame, Group::Buffer].into_iter().find_map(|group| w.code_of(group))
        {
            return probe.stands_beside(&self.core, span).map(|()| None);
        }
        match self.codes_of_block(w)? {
            Whole::No => {}
            Whole::Done => return Ok(None),
            Whole::Nonmodal { moved } => return Ok(Some(AfterBlock { moved, triggers: false })),
        }
        let motion = self.st.codes.of(Group::Motion);
        if motion.is_tapping() && !w.axes.is_empty() {
            let st = &mut self.st;
            st.taps.take_only(&self.core, &st.spindles, motion, w)?;
            if !st.describes {
                st.taps.begin(st.spindles.fixed_turns(None));
            }
        }
        self.technology(w)?;
        self.early_functions(w)?;
        let corner_before = self.st.corners.open.site();
        let moved = self.probed_motion(w, block)?;
        if moved && self.st.corners.open.site() == corner_before {
            self.st.corners.open.close();
        }
        self.st.corners.pass_block(&self.core, moved)?;
        if let Err((span, fault)) = w.leftover() {
            return self.core.refuse(span, fault);
        }
        if self.st.modal_call.is_on() {
            w.moves_what_is_left_out(&self.core)?;
        }
        Ok(Some(AfterBlock { moved, triggers }))
    }

    /// After an error nobody knows where the axes of the block are.
    pub(super) fn lose_block(&mut self, names: &mut Names, words: &Words, block: &Block) {
        let of_tap = self.st.codes.of(Group::Motion).is_tapping() && !words.axes.is_empty();
        self.st.taps.block_is_refused(of_tap);
        let mut axes = words.axes;
        for word in &block.words {
            let named = match word.target {
                Target::Letter(letter) => self.axis_names.letter(letter),
                Target::Numbered(_, _, name) | Target::Name(name) => match names.meaning(name, self) {
                    Meaning::Axis(named) => Some(named),
                    _ => None,
                },
                Target::Indexed(..) => {
                    axes = axes.union(AxisSet::MAIN);
                    None
                }
                Target::System(_) => None,
            };
            if let Some(NamedAxis { axis: Some(axis), .. }) = named {
                axes.insert(axis);
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

    // Motion.

    /// The motion of the block. True if axes moved along a path.
    fn motion(&mut self, w: &mut Words, block: &Block) -> Outcome<bool> {
        let interpolation = self.st.codes.of(Group::Motion);
        self.st.modal_contour_words(&self.core, w)?;
        let polar = w.get(Address::Ap).is_some() || w.get(Address::Rp).is_some();
        let round = matches!(interpolation, GCode::G2 | GCode::G3);
        let arc = round && ARC_ADDRESSES.iter().any(|address| w.get(*address).is_some());
        let moves = !w.axes.is_empty() || polar || arc || w.get(Address::Ang).is_some();
        if !w.beside.positioning.is_empty() {
            self.st.threads.end_chain();
            self.positioning(w)?;
        }
        if let Some(angle) = w.get(Address::Ang)
            && !matches!(interpolation, GCode::G0 | GCode::G1)
        {
            self.st.pair.drop_first();
            return self.core.refuse(angle.span, codes::S2070::ang_is_for_straight_lines());
        }
        if !moves && matches!(interpolation, GCode::G33 | GCode::G331 | GCode::G332) {
            let lead = [Address::I, Address::J, Address::K].into_iter().find_map(|address| w.get(address));
            if let Some(lead) = lead {
                return self.core.refuse(lead.span, codes::S2081::thread_block_moves_no_axis());
            }
        }
        if !moves {
            return without_path(&self.core, w, block.span);
        }
        if interpolation != GCode::G33 {
            self.st.threads.end_chain();
        }
        if matches!(interpolation, GCode::G33 | GCode::G331 | GCode::G332)
            && let Some(polar) = w.get(Address::Ap).or(w.get(Address::Rp))
        {
            return self.core.refuse(polar.span, w.misfit_of_motion());
        }
        if let Some((_, span)) = w.code_of(Group::Suppression).filter(|(code, _)| *code != GCode::SUPD) {
            return self.machine_move(w, interpolation, span).map(|()| true);
        }
        if let Some((_, span)) = w.code_of(Group::Suppression) {
            self.st.suppressed_tool(&self.core, w, span)?;
        }
        self.path_block(w, interpolation, polar, block.span).map(|()| true)
    }

    /// Checks the path of a block, sends it, and the corner behind it.
    fn path_block(&mut self, w: &mut Words, interpolation: GCode, polar: bool, span: Span) -> Outcome {
        let in_plane = polar || w.get(Address::Ang).is_some() || {
            let [first, second, _] = self.st.roles();
            w.axes.contains(first) || w.axes.contains(second)
        };
        // A contour is a shape: no tool follows it.
        if self.capture.is_none() {
            check_offsets(&self.core, &self.st, w)?;
        }
        self.st.compensation.moves(&self.core, self.st.side(), interpolation, in_plane, span)?;
        if interpolation == GCode::G33 {
            self.st.corners.none_at_thread(&self.core, w, span)?;
        }
        let corner = corner_of(&self.core, &self.st, w)?;
        if !matches!(interpolation, GCode::G0 | GCode::G1) {
            self.st.pair.only_lines(&self.core, &mut self.st.position, span)?;
        }
        match interpolation {
            GCode::G0 | GCode::G1 => self.line_block(w, interpolation, polar, corner.as_ref())?,
            GCode::G2 | GCode::G3 => self.circle_block(w, interpolation == GCode::G3, polar)?,
            GCode::CIP => self.via_block(w)?,
            GCode::CT => self.tangent_block(w)?,
            GCode::G33 => self.thread_block(w, span)?,
            GCode::G331 | GCode::G332 => return self.tap_block(w, interpolation, span),
            _ => return self.core.accept(span, interpolation.can_be_printed()).and(Err(Reported)),
        }
        // The first line of a pair sends its corner when its end is known.
        if !self.st.pair.is_open() {
            self.send_corner(corner);
        }
        Ok(())
    }

    /// The motion of the block, as far as the probe lets it be printed.
    fn probed_motion(&mut self, w: &mut Words, block: &Block) -> Outcome<bool> {
        match w.probe {
            Some(probe) if !probe.whole_way && !self.core.never_touches() => self.probe_block(w, probe).map(|()| false),
            Some(probe) => {
                self.may_leave_probe_out(probe)?;
                let moved = self.motion(w, block)?;
                self.measured.on_the_way(&self.core, &mut self.st.system, probe, moved);
                Ok(moved)
            }
            None => self.motion(w, block),
        }
    }

    fn line_block(
        &mut self,
        w: &mut Words,
        code: GCode,
        polar: bool,
        corner: Option<&crate::ir::contour::Corner>,
    ) -> Outcome {
        let path = Path::straight(self.path_feed(w, code == GCode::G0)?);
        if w.get(Address::Ang).is_some() || self.st.pair.is_open() {
            return self.angle_block(w, path, corner);
        }
        let end = if polar { self.st.polar_end(&mut self.core, w)? } else { self.st.targets(&self.core, w)? };
        self.send(&end, path);
        Ok(())
    }
}

/// A block of words that names no place to go to.
fn without_path(core: &Core<'_>, w: &Words, span: Span) -> Outcome<bool> {
    if w.shapes_corner() {
        return core.no_corner(span);
    }
    if let Some((_, span)) = w.code_of(Group::Suppression).filter(|_| w.beside.positioning.is_empty()) {
        core.say_once(span, codes::S8103::words_that_only_steer_control());
    }
    Ok(false)
}

/// Under D0 the control counts from the spindle nose, which the target cannot say.
fn check_offsets(core: &Core<'_>, st: &State, w: &Words) -> Outcome {
    let off = st.tool.is_without_offset();
    if !off || st.offsets.in_machine() {
        return Ok(());
    }
    let [_, _, third] = st.roles();
    let lengths = if st.machine.lathe { [Axis::X, Axis::Z] } else { [third, third] };
    match w.axes.iter().find(|axis| lengths.contains(axis)).and_then(|axis| w.axis(axis)) {
        Some(given) => core.refuse(given.span, codes::S9016::under_d0_position_counts_without_length()),
        None => Ok(()),
    }
}

impl GCode {
    /// May plain G code say the interpolation?
    pub(super) fn can_be_printed(self) -> Result<(), Fault> {
        let what = match self {
            GCode::G0 | GCode::G1 | GCode::G2 | GCode::G3 | GCode::CIP | GCode::CT => return Ok(()),
            GCode::G33 | GCode::G331 | GCode::G332 => return Ok(()),
            GCode::G34 | GCode::G35 => "a thread of changing lead",
            GCode::ASPLINE | GCode::BSPLINE | GCode::CSPLINE | GCode::POLY => "a spline or polynomial",
            GCode::INVCW | GCode::INVCCW => "an involute",
            GCode::G335 | GCode::G336 => "a thread on an arc",
            _ => "an interpolation of the machine builder",
        };
        Err(codes::S9002::is_which_plain_g_code_cannot_say(&self.word(), &what))
    }
}
