//! Technology: feed, spindle, tool, M functions, compensation, work offsets.
//!
//! Source: reference sections 0, 2.12, 2.15, 4.7.

use crate::diag::{Diagnostic, codes};
use crate::ir::function::{Coolant, CutterData, Spindle, Turn};
use crate::ir::{Feed, Function, Side};
use crate::machine::{Axis, Compensation, Tool};
use crate::text::Span;

use super::frames::FrameValue;
use super::system::offset_word;
use super::vocabulary::{Address, Code, Indexed};
use super::words::{Given, MWord, SWord, Words};
use super::{Outcome, Reported, Run};

/// M functions of a block.
const MOST_M: usize = 5;
/// Highest spindle number that is a spindle.
const MOST_SPINDLES: u8 = 20;

impl Run<'_> {
    // Feed.

    /// A programmed feed with the kind that is in force.
    pub(super) fn feed_of(&self, value: f64) -> Feed {
        let value = value * self.st.feed_unit();
        if self.st.per_revolution() { Feed::PerRevolution(value) } else { Feed::PerMinute(value) }
    }

    /// The feed of a path block.
    pub(super) fn path_feed(&mut self, w: &mut Words, rapid: bool) -> Outcome<Option<Feed>> {
        if let Some(fb) = w.take(Address::Fb) {
            if fb.value <= 0.0 {
                return self.fail(codes::S2041, 14800, fb.span, format!("the feed FB={} is not above 0", fb.value));
            }
            return Ok((!rapid).then(|| self.feed_of(fb.value)));
        }
        if rapid {
            return Ok(None);
        }
        if self.st.feed_lost && !self.is_capturing() {
            return Err(Reported);
        }
        if self.cut_speed_open.take().is_some() {
            return self.fail_help(
                codes::S2045,
                10900,
                Span::default(),
                "G96 has no cutting speed",
                "program S in m/min with G96; the S of before is a speed in turns",
            );
        }
        match self.st.feed {
            Some(feed) => {
                let rotary_only = !w.axes.is_empty() && w.axes.iter().all(Axis::is_rotary);
                if rotary_only && let Feed::PerMinute(f) = feed {
                    // Degrees have no unit of length.
                    return Ok(Some(Feed::PerMinute(f / self.st.feed_unit())));
                }
                Ok(Some(feed))
            }
            // The cycle that takes the contour has the feeds.
            None if self.is_capturing() => Ok(Some(Feed::PerRevolution(1.0))),
            None => {
                // Once is enough.
                self.st.feed_lost = true;
                self.fail_help(
                    codes::S2040,
                    10860,
                    Span::default(),
                    "no feed is programmed",
                    "program F in this block or before, again after G94, G95 and G96; a contour by itself takes `[control] feed`",
                )
            }
        }
    }

    pub(super) fn feed_code(&mut self, code: Code, span: Span) -> Outcome {
        let old = self.st.groups[15];
        match code.index {
            1 | 6 | 9.. => {
                let message = format!("{} gives feeds that plain G-code cannot say", super::vocabulary::word(code));
                return self.fail_help(codes::S9009, 0, span, message, "program the feed by G94 or G95");
            }
            _ => {}
        }
        if matches!(code.index, 4 | 7) && self.job.settings.machine.diameter_axis.is_none() {
            let message = "constant cutting speed needs a diameter axis (MD 20100)";
            return self.fail_help(codes::S2060, 10870, span, message, "set `[machine] diameter_axis = \"X\"`");
        }
        self.st.groups[15] = code.index;
        if old != code.index {
            self.feed_mode_changed();
        }
        Ok(())
    }

    /// F means something else now.
    pub(super) fn feed_mode_changed(&mut self) {
        let fits = match self.st.feed {
            Some(Feed::PerRevolution(_)) => self.st.per_revolution(),
            Some(Feed::PerMinute(_)) => !self.st.per_revolution(),
            None => true,
        };
        if !fits {
            self.st.feed = None;
        }
    }

    // F, S, T, D.

    pub(super) fn technology(&mut self, w: &mut Words) -> Outcome {
        if let Some(f) = w.take(Address::F) {
            if f.value <= 0.0 {
                self.st.feed_lost = true;
                return self.fail_help(
                    codes::S2041,
                    14800,
                    f.span,
                    format!("the feed F{} is not above 0", f.value),
                    "program a feed above 0",
                );
            }
            self.st.feed = Some(self.feed_of(f.value));
            self.st.feed_lost = false;
        }
        if let Some(t) = w.take(Address::T) {
            self.tool_word_given(t, w)?;
        }
        if let Some(d) = w.take(Address::D) {
            self.edge(d)?;
        }
        if let Some(lims) = w.take(Address::Lims) {
            if lims.value < 0.0 {
                return self.fail(codes::S2045, 14820, lims.span, "the speed limit LIMS= is negative");
            }
            self.st.speed_limit = Some(lims.value);
            if self.st.constant_cut && w.s.is_empty() {
                self.send_cutting_speed();
            }
        }
        let constant = matches!(self.st.groups[15], 4 | 7);
        if !constant && self.st.constant_cut && w.s.is_empty() {
            let span = w.code_of(15).map(|(_, span)| span).unwrap_or_default();
            // Once is enough.
            self.st.constant_cut = false;
            return self.fail_help(
                codes::S2045,
                0,
                span,
                "G97 keeps the speed that the spindle happens to have",
                "program the speed with it: G97 S1000",
            );
        }
        for at in 0..w.s.len() {
            self.speed(w.s[at], constant)?;
        }
        if !constant {
            self.cut_speed_open = None;
        } else if !self.st.constant_cut && self.cut_speed_open.is_none() {
            self.cut_speed_open = Some(w.code_of(15).map(|(_, span)| span).unwrap_or_default());
        }
        if self.st.constant_cut {
            self.cut_speed_open = None;
        }
        if let Some(spos) = w.take(Address::Spos).or(w.take(Address::Sposa)) {
            self.function(Function::Spindle(Spindle::Orient(spos.value)));
        }
        for address in [Address::Dl, Address::Toff, Address::Toffl, Address::Toffr, Address::Offn] {
            if let Some(given) = w.take(address)
                && given.value != 0.0
            {
                return self.fail_help(
                    codes::S9010,
                    0,
                    given.span,
                    "an offset of the tool that the program adds cannot be printed",
                    "put it into the tool data",
                );
            }
        }
        if let Some(given) = w.take(Address::Tcarr)
            && given.value != 0.0
        {
            return self.fail(codes::S9001, 0, given.span, "orientable tool carriers cannot be printed");
        }
        // They matter for compensated corners only.
        w.take(Address::Disc);
        if let Some(span) = w.h {
            self.note_once(codes::S8005, span, "H functions are for the machine's own control and are left out");
        }
        Ok(())
    }

    fn speed(&mut self, s: SWord, constant: bool) -> Outcome {
        if s.value > 1e6 {
            return self.fail(codes::S2045, 0, s.span, format!("the speed S{} is out of all range", s.value));
        }
        if s.value < 0.0 {
            let help = "the sense of rotation comes from M3 or M4";
            return self.fail_help(codes::S2045, 14840, s.span, format!("the speed S{} is negative", s.value), help);
        }
        match s.spindle {
            Some(n) if n != self.st.master => {
                self.spindle_number(n, s.span)?;
                self.function(Function::SpindleOf { number: n, spindle: Spindle::Speed(s.value) });
            }
            _ if constant => {
                let feet = self.st.feed_unit() != 1.0;
                self.st.speed = Some(if feet { s.value * 0.3048 } else { s.value });
                self.st.constant_cut = true;
                self.send_cutting_speed();
            }
            _ => {
                self.st.speed = Some(s.value);
                self.st.constant_cut = false;
                self.function(Function::Spindle(Spindle::Speed(s.value)));
            }
        }
        Ok(())
    }

    fn spindle_number(&self, n: u8, span: Span) -> Outcome {
        if (1..=MOST_SPINDLES).contains(&n) {
            Ok(())
        } else {
            self.fail(codes::S2045, 0, span, format!("there is no spindle {n}"))
        }
    }

    fn send_cutting_speed(&mut self) {
        if let Some(speed) = self.st.speed {
            let limit = self.st.speed_limit;
            self.function(Function::Spindle(Spindle::CuttingSpeed { speed, limit }));
        }
    }

    fn tool_word_given(&mut self, t: Given, w: &mut Words) -> Outcome {
        let number = match w.tool_name.take() {
            Some(name) => self.tool_by_name(&name, t.span)?,
            None if t.value.fract() == 0.0 && (0.0..=32_000.0).contains(&t.value) => t.value as u32,
            None => return self.fail(codes::S2043, 17190, t.span, format!("T{} is no tool number", t.value)),
        };
        self.st.tool.next = Some(number);
        self.st.tool.lost = false;
        let settings = &self.job.settings.tools;
        if settings.complete && number != 0 && settings.by_number(number, 0).is_none() {
            let found =
                Diagnostic::new(codes::S8009, self.loc(t.span), format!("tool {number} is not in the tool table"));
            self.report(found.help("add it to the table, or check the number"));
        }
        if self.changes_by_t() {
            return self.change_tool();
        }
        if !w.m.iter().any(|m| m.number == 6) {
            self.function(Function::ToolPrepare { number });
        }
        Ok(())
    }

    /// Turrets change with T (MD 22550 = 0), mills with M6.
    fn changes_by_t(&self) -> bool {
        self.job.settings.control.siemens.tool_change_by_t.unwrap_or(self.st.lathe)
    }

    fn tool_by_name(&mut self, name: &str, span: Span) -> Outcome<u32> {
        let tools = &self.job.settings.tools;
        match tools.by_name(name) {
            Some((Some(number), _)) => Ok(number),
            _ => {
                self.st.tool.lost = true;
                let known: Vec<String> = tools.table.values().filter_map(|tool| tool.name.clone()).collect();
                let like = crate::machine::tree::did_you_mean(name, known.iter().map(String::as_str));
                let help = match like {
                    Some(like) => format!("did you mean `{like}`?"),
                    None => format!("give its number: `[tools.1]` with `name = \"{name}\"`"),
                };
                self.fail_help(codes::S2043, 17191, span, format!("the tool `{name}` has no number"), &help)
            }
        }
    }

    fn change_tool(&mut self) -> Outcome {
        let Some(number) = self.st.tool.next else {
            return self.fail_help(codes::S2043, 0, Span::default(), "no tool is chosen", "program T in front of M6");
        };
        if self.st.side() != Side::None {
            return self.fail_help(
                codes::S2080,
                10780,
                Span::default(),
                "the tool changes while radius compensation is on",
                "program G40 in a block in front of it",
            );
        }
        self.st.tool.active = Some(number);
        self.st.tool.edge = Some(1);
        self.function(Function::ToolChange { number });
        // A tool of another length.
        let [_, _, third] = self.st.roles();
        if self.st.lathe {
            self.st.forget(Axis::X);
            self.st.forget(Axis::Z);
        } else {
            self.st.forget(third);
        }
        Ok(())
    }

    fn edge(&mut self, d: Given) -> Outcome {
        if d.value.fract() != 0.0 || !(0.0..=32_000.0).contains(&d.value) {
            return self.fail(codes::S2043, 17180, d.span, format!("D{} is no edge number", d.value));
        }
        let edge = d.value as u32;
        if self.st.tool.edge.is_some_and(|old| old != edge) {
            let [_, _, third] = self.st.roles();
            let axes = if self.st.lathe { vec![Axis::X, Axis::Z] } else { vec![third] };
            for axis in axes {
                self.st.forget(axis);
            }
        }
        self.st.tool.edge = Some(edge);
        if edge > 1 {
            self.note_once(
                codes::S8010,
                d.span,
                "cutting edges other than D1 are not printed: the target knows one offset a tool",
            );
        }
        Ok(())
    }

    pub(super) fn active_tool(&self) -> Option<Tool> {
        let number = self.st.tool.active?;
        let mut tool = self.job.settings.tools.by_number(number, 0).cloned().unwrap_or_default();
        let edge = self.st.tool.edge.unwrap_or(1);
        let written = self.system.get(&format!("$TC_DP6[{number},{edge}]")).and_then(super::value::Val::number);
        tool.radius = written.or(tool.radius);
        Some(tool)
    }

    // M functions.

    /// What acts in front of the motion.
    pub(super) fn early_functions(&mut self, w: &Words) -> Outcome {
        // The tool is changed before the spindle starts.
        if w.m.iter().any(|m| m.number == 6) {
            self.change_tool()?;
        }
        let turning = |m: &&MWord| matches!(m.number, 3..=5);
        let spindles: Vec<&MWord> = w.m.iter().filter(turning).collect();
        if let [first, second, ..] = spindles.as_slice()
            && first.spindle == second.spindle
        {
            let message = format!("M{} and M{} stand in one block", first.number, second.number);
            return self.fail_help(codes::S2045, 14760, second.span, message, "give each a block of its own");
        }
        if let Some(sixth) = w.m.get(MOST_M) {
            return self.fail_help(
                codes::S2007,
                12010,
                sixth.span,
                "a block has at most five M functions",
                "divide the block",
            );
        }
        for m in &w.m {
            self.early_function(*m)?;
        }
        Ok(())
    }

    fn early_function(&mut self, m: MWord) -> Outcome {
        let spindle = match m.number {
            3 => Spindle::Start(Turn::Clockwise),
            4 => Spindle::Start(Turn::CounterClockwise),
            5 => Spindle::Stop,
            19 => Spindle::Orient(0.0),
            _ => return self.other_function(m),
        };
        match m.spindle {
            Some(n) if n != self.st.master => {
                self.spindle_number(n, m.span)?;
                self.function(Function::SpindleOf { number: n, spindle });
            }
            _ => {
                self.st.turn = match spindle {
                    Spindle::Start(turn) => Some(turn),
                    _ => None,
                };
                self.function(Function::Spindle(spindle));
            }
        }
        Ok(())
    }

    fn other_function(&mut self, m: MWord) -> Outcome {
        match m.number {
            0 | 1 | 2 | 6 | 17 | 30 => {}
            7 => self.function(Function::Coolant(Coolant::Mist)),
            8 => self.function(Function::Coolant(Coolant::Flood)),
            9 => self.function(Function::Coolant(Coolant::Off)),
            number if self.job.settings.output.pass_m.contains(&number) => self.function(Function::Aux(number)),
            40..=45 => self.note_once(codes::S8004, m.span, "gear steps M40 to M45 are left out"),
            96..=99 => {
                return self.fail_help(
                    codes::S2044,
                    0,
                    m.span,
                    format!("M{} calls programs in ISO dialect only", m.number),
                    "a subprogram is called by its name, as in L100 or POCKET",
                );
            }
            number => {
                return self.fail_help(
                    codes::S2044,
                    0,
                    m.span,
                    format!("what M{number} does is up to the machine builder"),
                    &format!("if it may be printed as it stands, list it: `[output] pass_m = [{number}]`"),
                );
            }
        }
        Ok(())
    }

    /// What acts behind the motion.
    pub(super) fn late_functions(&mut self, w: &Words) -> Outcome {
        for m in &w.m {
            match m.number {
                0 | 1 => {
                    self.function(if m.number == 0 { Function::Stop } else { Function::OptionalStop });
                }
                2 | 17 | 30 => {
                    if self.in_main() {
                        if self.ends_inside_contour() {
                            return Err(Reported);
                        }
                        let done = self.pending_must_be_done(m.span);
                        self.function(Function::End { rewind: m.number == 30 });
                        self.ended.set(true);
                        done?;
                    } else {
                        self.leave_program();
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    // Compensation.

    pub(super) fn compensation_code(&mut self, code: Code, span: Span) -> Outcome {
        if code != Code::G40 {
            if self.job.settings.output.compensation == Compensation::Resolve {
                return self.fail_help(
                    codes::S9010,
                    0,
                    span,
                    "computing the tool-centre path is not built yet",
                    "print the contour with G41/G42: `[output] compensation = \"control\"`",
                );
            }
            self.select_cutter(span)?;
        }
        self.compensation_starts = code.index != self.st.groups[7];
        self.st.groups[7] = code.index;
        Ok(())
    }

    /// Tells the target which tool is compensated.
    pub(super) fn select_cutter(&mut self, span: Span) -> Outcome {
        let help = if self.st.tool.next.is_some() {
            "the tool is chosen, not changed: M6 is missing, or set `[control] tool_change = \"t\"`"
        } else {
            "select a tool before"
        };
        let Some(number) = self.st.tool.active.filter(|n| *n != 0) else {
            return self.fail_help(codes::S2080, 10750, span, "radius compensation without a tool", help);
        };
        let edge = self.st.tool.edge.unwrap_or(1);
        let written = self.system.get(&format!("$TC_DP6[{number},{edge}]")).and_then(super::value::Val::number);
        self.function(Function::Cutter(CutterData { number, radius: written }));
        Ok(())
    }

    /// Compensation starts and ends on a straight line.
    pub(super) fn check_start_of_compensation(&mut self, code: Code, in_plane: bool, span: Span) -> Outcome {
        if std::mem::take(&mut self.compensation_starts) && !(matches!(code, Code::G0 | Code::G1) && in_plane) {
            let on = self.st.side() != Side::None;
            let alarm = if on { 10753 } else { 10754 };
            let what = if in_plane { "on an arc" } else { "without a move in the plane" };
            let message = format!("radius compensation {} {what}", if on { "starts" } else { "ends" });
            return self.fail_help(
                codes::S2080,
                alarm,
                span,
                message,
                "program G41, G42 or G40 with G0 or G1 and an axis of the plane",
            );
        }
        Ok(())
    }

    pub(super) fn axis_diameter(&mut self, indexed: Indexed, axis: Axis, span: Span) -> Outcome {
        if !self.is_diameter_axis(axis) {
            return self.no_diameter_axis(span);
        }
        use super::state::Diameter;
        self.st.diameter = match indexed {
            Indexed::DiameterOn => Some(Diameter::On),
            Indexed::Diameter90 => Some(Diameter::Absolute),
            Indexed::DiameterOff => Some(Diameter::Off),
            _ => None,
        };
        Ok(())
    }

    // Work offsets.

    /// A code of group 8: number 0 is G500, 1 is G54.
    pub(super) fn work_offset(&mut self, index: u8, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        let number = index - 1;
        self.st.groups[8] = index;
        self.st.offset = number;
        if self.st.side() != Side::None {
            return self.fail(codes::S2080, 0, span, "the work offset changes while radius compensation is on");
        }
        if let Some(frame) = self.st.written.get(&number).cloned() {
            self.st.machine_coordinates = false;
            self.resolved_offset_note(span);
            self.resolves_offsets(span)?;
            self.switch_offset(Some(frame));
            return Ok(());
        }
        let mapped = self.job.settings.datums.words.get(&offset_word(number)).copied();
        let printed = match (mapped, number) {
            (Some(printed), _) => Some(printed),
            (None, 0) => None,
            (None, 1..=9) => Some(number),
            _ => {
                let word = offset_word(number);
                return self.fail_help(
                    codes::S9014,
                    0,
                    span,
                    format!("{word} has no counterpart on the target"),
                    &format!("name one: `[datums] {word} = \"G55\"`"),
                );
            }
        };
        let was_machine = self.st.machine_coordinates;
        self.st.machine_coordinates = printed.is_none();
        if self.st.settable.take().is_some() {
            self.refresh_frame();
        }
        if let Some(number) = printed {
            self.st.offsets_printed = true;
            if self.st.offsets_resolved {
                return self.mixed_offsets(span);
            }
            self.function(Function::WorkOffset(number));
        }
        if printed.is_some() || !was_machine {
            self.forget_all();
        }
        if printed.is_none() {
            self.note_once(
                codes::S8011,
                span,
                "under G500 positions count in machine coordinates and are printed with G53",
            );
        }
        Ok(())
    }

    /// A written offset counts from the basic system, a printed one from where the machine has it: nobody knows the
    /// way between the two.
    pub(super) fn resolves_offsets(&mut self, span: Span) -> Outcome {
        self.st.offsets_resolved = true;
        if self.st.offsets_printed { self.mixed_offsets(span) } else { Ok(()) }
    }

    fn mixed_offsets(&mut self, span: Span) -> Outcome {
        self.forget_all();
        self.fail_help(
            codes::S9017,
            0,
            span,
            "the program uses a work offset that it writes itself beside one of the machine",
            "let it write all the offsets it uses, or none",
        )
    }

    /// A work offset whose values are known goes into the coordinates.
    pub(super) fn switch_offset(&mut self, frame: Option<FrameValue>) {
        let known = self.st.settable.is_some() || self.st.offset == 0 || self.st.written.contains_key(&self.st.offset);
        self.st.settable = frame;
        if !known {
            self.forget_all();
        }
        self.refresh_frame();
    }

    fn forget_all(&mut self) {
        for axis in Axis::ALL {
            self.st.forget(axis);
        }
    }

    pub(super) fn resolved_offset_note(&self, span: Span) {
        self.note_once(
            codes::S8012,
            span,
            "a work offset that the program writes itself is put into the coordinates; no G54 is printed for it",
        );
    }
}
