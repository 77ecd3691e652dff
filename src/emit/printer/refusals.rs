//! What the target has no word for: each refused with its place, and with what to do.

use crate::diag::{Answer, Fault, codes};
use crate::ir::motion::{Move, Path};
use crate::ir::{Origin, Side};
use crate::machine::settings::Quantity;
use crate::machine::{Axis, AxisSet};
use crate::text::Loc;

use super::super::compensation::resolved;
use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// Rounding of a feed or a speed by more than this part of it is told, and by more than that is refused. Where one ends and
/// the other begins is a matter of taste: overrides go in steps of ten per cent, tables of cutting data hardly say one.
const NOTICED: f64 = 0.01 + 1e-9;
/// The same of a feed per revolution, whose few places say less: 0.1016 is no 0.102.
const NOTICED_A_TURN: f64 = 0.001 + 1e-9;
const ANOTHER: f64 = 0.1 + 1e-9;

/// What helps where inches do not do.
pub(super) fn in_millimetres() -> Answer {
    Answer::key("output", "units").one_of(&["\"mm\""])
}

/// Where no block asks for something, but the configuration.
fn at_start() -> Origin {
    Origin { loc: Loc { line: 1, ..Loc::default() }, ..Origin::default() }
}

impl Printer<'_> {
    /// Refuses what the target has no word for.
    #[cold]
    pub(super) fn deny(&mut self, origin: &Origin, fault: Fault) {
        self.lines.text.drop_line();
        self.say(origin, fault);
    }

    /// Diameters are a wish of the configuration: no block asks for them.
    #[cold]
    pub(super) fn lacks_diameters(&mut self) {
        let radius = Answer::key("output", "diameter").one_of(&["false"]);
        self.deny(&at_start(), codes::O9315::target_has_no_word_for_x_as_diameter(&self.target.name).answer(radius));
    }

    /// The kind of machine is a wish of the configuration, too.
    #[cold]
    pub(super) fn lacks_machine(&mut self, lathe: bool) {
        let name = &self.target.name;
        let kind = Answer::key("machine", "kind");
        let fault = match (lathe, self.target.frame.lathe_diameter) {
            (true, Some(_)) => codes::O9317::target_has_no_word_for_x_as_radius(name)
                .answer(Answer::key("output", "diameter").one_of(&["true"])),
            (true, None) => codes::O9317::target_has_no_word_for_lathe(name).answer(kind.one_of(&["\"mill\""])),
            (false, _) => codes::O9317::target_has_no_word_for_mill(name).answer(kind.one_of(&["\"lathe\""])),
        };
        self.deny(&at_start(), fault);
    }

    /// The length of a tool that would begin in an arc or a thread, or degrees a minute where F counts inches.
    #[cold]
    pub(super) fn lacks_form(&mut self, mv: &Move, origin: &Origin) {
        let name = &self.target.name;
        let fault = if self.length.waits {
            codes::O9318::target_has_no_word_for_length(name)
        } else {
            codes::O9319::target_has_no_word_for_rotary_axis_in_inches(name).answer(in_millimetres())
        };
        self.deny(origin, fault);
        self.pretend(mv);
    }

    /// A move under compensation, or the one that ends it.
    #[cold]
    pub(super) fn lacks_compensation(&mut self, mv: &Move, origin: &Origin) {
        if self.compensation.refuse_contour() {
            self.deny(origin, codes::O9308::target_has_no_word_for_radius_compensation(&self.target.name));
        }
        self.pretend(mv);
    }

    /// A radius that the table of the target does not have, or that nothing has selected there.
    #[cold]
    pub(super) fn lacks_radius(&mut self, oversize: bool, of_length: bool, mv: &Move, origin: &Origin) {
        if self.compensation.refuse_contour() {
            let name = &self.target.name;
            let fault = match (oversize, of_length) {
                (true, _) => codes::O9308::target_has_no_word_for_tool_radius_with_oversize(name).answer(resolved()),
                (false, true) => codes::O9308::target_has_no_word_for_radius_of_tool_without_d(name)
                    .answer(Answer::key("output", "tool_length").one_of(&["\"off\""])),
                (false, false) => codes::O9308::target_has_no_word_for_radius_of_tool_0(name),
            };
            self.deny(origin, fault);
        }
        self.pretend(mv);
    }

    /// The compensation would end in a block without a move.
    #[cold]
    pub(super) fn lacks_end_of_compensation(&mut self, origin: &Origin) {
        self.compensation.switched(Side::None);
        if self.compensation.refuse_contour() {
            self.say(origin, codes::O9003::radius_compensation_is_on_at_block());
        }
    }

    /// An arc that the target cannot say, and that may not become lines either.
    #[cold]
    pub(super) fn lacks_arc(&mut self, helix: bool, mv: &Move, origin: &Origin) {
        let name = &self.target.name;
        let asking = match (helix, self.target.arcs.helices) {
            (true, true) => codes::O9328::target_has_no_word_for_helix_in_this_plane(name),
            (true, false) => codes::O9328::target_has_no_word_for_helix_in_every_build(name),
            (false, _) => codes::O9328::target_has_no_word_for_arc_in_this_plane(name),
        };
        self.deny(origin, asking.answer(Answer::key("output", "arc_fallback_tolerance")));
        self.pretend(mv);
    }

    /// An arc, or the lines that may stand for it, off by so many mm for want of printed places.
    #[cold]
    pub(super) fn too_coarse(&mut self, mm: f64, mv: &Move, origin: &Origin) {
        let places = self.settings.places(Quantity::Length);
        let unit = if self.measures.inches { "an inch" } else { "a millimetre" };
        let more = (places + 1).to_string();
        let asking = codes::O9335::printed_with_places(&places, &unit, &mm, &more);
        self.deny(origin, asking.answer(Answer::key("output", "decimals").one_of(&[more])));
        self.pretend(mv);
    }

    /// Inches are a wish of the configuration.
    #[cold]
    pub(super) fn lacks_inches(&mut self) {
        let asking = codes::O9332::target_has_no_word_for_inches(&self.target.name);
        self.deny(&at_start(), asking.answer(in_millimetres()));
    }

    /// Rapid traverse goes at the last F, and nobody said at which.
    #[cold]
    pub(super) fn lacks_rapid_feed(&mut self, origin: &Origin) {
        let asking = codes::O9333::on_target_rapid_traverse_goes_at_last(&self.target.name);
        self.say(origin, asking.answer(Answer::key("output", "rapid_feed")));
    }

    /// May this M function of spindle, coolant or stops be printed? Some receivers have them as macros alone.
    pub(super) fn has_m(&mut self, number: u32, origin: &Origin) -> bool {
        let there = !self.target.m.listed || self.settings.pass_m.contains(&number);
        if !there {
            let asking = codes::O9334::target_has_m_as_macro(&self.target.name, &number);
            self.say(origin, asking.answer(Answer::pass_m(number)));
        }
        there
    }

    /// Does the receiver have a length or a radius of this number? How many there are is an option of some.
    pub(super) fn has_offset(&mut self, number: u32, letter: u8, origin: &Origin) -> bool {
        let Some(usual) = self.target.tool.most_offset else { return true };
        let most = self.settings.tool_offsets.unwrap_or(usual);
        if number > most {
            let (name, letter) = (self.target.name, letter as char);
            let asking = codes::O9337::target_is_taken_to_have_offsets(&letter, &number, &name, &most);
            self.deny(origin, asking.answer(Answer::key("output", "tool_offsets")));
        }
        number <= most
    }

    /// What the number of a wait counts is a setting of the receiver.
    #[cold]
    pub(super) fn lacks_dwell_unit(&mut self, origin: &Origin) {
        let unit = Answer::key("output", "dwell_unit").one_of(&["\"seconds\"", "\"milliseconds\""]);
        self.say(origin, codes::O9331::seconds_or_milliseconds(&self.target.name).answer(unit));
    }

    /// The target may choose a place farther along the contour as the end of its way there.
    pub(super) fn begins_at_rapid(&self, mv: &Move, origin: &Origin) {
        if mv.side != Side::None && matches!(mv.path, Path::Rapid) && self.diags.first_time(codes::O4005, ()) {
            self.say(origin, codes::O4005::radius_compensation_begins_in_rapid_move().answer(resolved()));
        }
    }

    /// Does a printed feed or speed say what the program says? Reported where rounding to its places takes or adds much
    /// of it; false where it is another one.
    #[inline]
    pub(super) fn is_near(&self, what: &str, value: f64, units: i64, places: Places, origin: &Origin) -> bool {
        let off = units as f64 / (value * places.scale()) - 1.0;
        let noticed = if what == FeedKind::PerRevolution.name() { NOTICED_A_TURN } else { NOTICED };
        value == 0.0 || off.abs() <= noticed || self.is_rounded(what, off, units, places, origin)
    }

    #[cold]
    fn is_rounded(&self, what: &str, off: f64, units: i64, places: Places, origin: &Origin) -> bool {
        let another = off.abs() > ANOTHER;
        let code = if another { codes::O1007 } else { codes::O1006 };
        if another || self.diags.first_time(code, (what, units)) {
            let printed = units as f64 / places.power() as f64;
            let (percent, more) = (off.abs() * 100.0, if off > 0.0 { "more" } else { "less" });
            let key = match what {
                "speed" => "decimals.speed",
                "lead" => "decimals",
                _ => "decimals.feed",
            };
            let asking = if another {
                codes::O1007::prints_as(&what, &printed, &percent, &more, &key)
            } else {
                codes::O1006::prints_as(&what, &printed, &percent, &more, &key)
            };
            self.say(origin, asking.answer(Answer::key("output", "decimals")));
        }
        !another
    }

    /// A wait that is shorter than half of its last place.
    #[cold]
    pub(super) fn wait_is_lost(&mut self, seconds: f64, origin: &Origin) {
        let fault = if self.settings.waits_in_milliseconds() {
            codes::O1005::wait_of_s_prints_as_zero_milliseconds(&seconds)
        } else {
            codes::O1005::wait_of_s_prints_as_zero(&seconds)
                .answer(Answer::key("output", "decimals").one_of(&["{ time = 3 }"]))
        };
        self.say(origin, fault);
    }

    #[cold]
    pub(super) fn lacks_axes(&mut self, lacking: AxisSet, mv: &Move, origin: &Origin) {
        self.axes = self.axes.union(lacking);
        let letters: String = lacking.iter().map(Axis::letter).collect();
        let name = &self.target.name;
        let fault = match lacking.len() {
            1 => codes::O9309::target_has_no_word_for_axis(name, &letters),
            _ => codes::O9309::target_has_no_word_for_axes(name, &letters),
        };
        self.deny(origin, fault);
        self.pretend(mv);
    }

    /// A move that was refused has led to its end all the same.
    #[cold]
    pub(super) fn pretend(&mut self, mv: &Move) {
        for axis in mv.axes.iter() {
            let units = mv.end.get(axis).filter(|_| !mv.machine).and_then(|value| self.places_of(axis).units(value));
            self.modal.pretend(axis, units);
        }
    }
}
