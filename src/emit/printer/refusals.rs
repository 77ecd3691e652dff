//! What the target has no word for: each refused with its place, and with what to do.

use crate::diag::{Answer, Code, Diagnostic, Fault, Help, codes};
use crate::ir::motion::{Move, Path};
use crate::ir::{Origin, Side};
use crate::machine::settings::Quantity;
use crate::machine::{Axis, AxisSet};
use crate::text::Loc;

use super::super::compensation::resolve;
use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// Rounding of a feed or a speed by more than this part of it is told, and by more than that is refused. Where one ends and
/// the other begins is a matter of taste: overrides go in steps of ten per cent, tables of cutting data hardly say one.
const NOTICED: f64 = 0.01 + 1e-9;
/// The same of a feed per revolution, whose few places say less: 0.1016 is no 0.102.
const NOTICED_A_TURN: f64 = 0.001 + 1e-9;
const ANOTHER: f64 = 0.1 + 1e-9;

fn in_millimetres(help: &str) -> Help {
    Answer::key("output", "units").one_of(&["\"mm\""]).help(help)
}

impl Printer<'_> {
    /// Refuses what the target has no word for.
    #[cold]
    pub(super) fn deny(&mut self, origin: &Origin, fault: Fault) {
        self.page.text.drop_line();
        self.diags.push(fault.at(origin.loc).called(origin.call));
    }

    /// The same, of what the target has no word for.
    #[cold]
    pub(super) fn lacks(&mut self, code: &'static Code, origin: &Origin, what: &str, help: impl Into<Help>) {
        self.page.text.drop_line();
        let message = format!("the target {} has no word for {what}", self.target.name);
        self.diags.push(Diagnostic::new(code, origin.loc, message).help(help).called(origin.call));
    }

    /// Diameters are a wish of the configuration: no block asks for them.
    #[cold]
    pub(super) fn lacks_diameters(&mut self) {
        let start = Loc { line: 1, ..Loc::default() };
        let help = "leave `[output] diameter` away: X is printed as a radius";
        let help = Answer::key("output", "diameter").one_of(&["false"]).help(help);
        self.lacks(codes::O9315, &Origin { loc: start, ..Origin::default() }, "X as a diameter", help);
    }

    /// The kind of machine is a wish of the configuration, too.
    #[cold]
    pub(super) fn lacks_machine(&mut self, lathe: bool) {
        let start = Loc { line: 1, ..Loc::default() };
        let diameters = Answer::key("output", "diameter").one_of(&["true"]);
        let kind = Answer::key("machine", "kind");
        let (what, help) = match (lathe, self.target.frame.lathe_diameter) {
            (true, Some(_)) => {
                ("X as a radius", diameters.help("leave `[output] diameter` away: X is printed as a diameter"))
            }
            (true, None) => {
                let help = "take the target for lathes, or set `[machine] kind = \"mill\"`";
                ("a lathe", kind.one_of(&["\"mill\""]).help(help))
            }
            (false, _) => {
                let help = "take the target for mills, or set `[machine] kind = \"lathe\"`";
                ("a mill", kind.one_of(&["\"lathe\""]).help(help))
            }
        };
        self.lacks(codes::O9317, &Origin { loc: start, ..Origin::default() }, what, help);
    }

    /// The length of a tool that would begin in an arc or a thread, or degrees a minute where F counts inches.
    #[cold]
    pub(super) fn lacks_form(&mut self, mv: &Move, origin: &Origin) {
        if self.length.waits {
            self.deny(origin, codes::O9318::target_has_no_word_for_length(&self.target.name));
        } else {
            let help = in_millimetres("set `[output] units = \"mm\"`");
            self.lacks(codes::O9319, origin, "a rotary axis at a feed in inches", help);
        }
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
            let (what, help) = match (oversize, of_length) {
                (true, _) => (
                    "a tool radius with an oversize of the program",
                    resolve("put the oversize into the tool table of the target, or set `[output] compensation = \"resolve\"`"),
                ),
                (false, true) => (
                    "the radius of a tool whose D it does not print",
                    Answer::key("output", "tool_length").one_of(&["\"off\""]).help(
                        "call the tool in the program, and leave `[output] tool_length` away: D1 brings the radius, too",
                    ),
                ),
                (false, false) => ("the radius of tool 0", "call a tool before the contour".into()),
            };
            self.lacks(codes::O9308, origin, what, help);
        }
        self.pretend(mv);
    }

    /// The compensation would end in a block without a move.
    #[cold]
    pub(super) fn lacks_end_of_compensation(&mut self, origin: &Origin) {
        self.compensation.switched(Side::None);
        if self.compensation.refuse_contour() {
            self.diags.push(codes::O9003::radius_compensation_is_on_at_block().at(origin.loc).called(origin.call));
        }
    }

    /// An arc that the target cannot say, and that may not become lines either.
    #[cold]
    pub(super) fn lacks_arc(&mut self, helix: bool, mv: &Move, origin: &Origin) {
        let what = match (helix, self.target.arcs.helices) {
            (true, true) => "a helix in this plane",
            (true, false) => "a helix, in every build",
            (false, _) => "an arc in this plane",
        };
        let help = "set `[output] arc_fallback_tolerance` in partc.toml: how far lines may leave it, in mm";
        let help = Answer::key("output", "arc_fallback_tolerance").help(help);
        self.page.text.drop_line();
        self.diags.push(
            codes::O9328::target_has_no_word(&self.target.name, &what).at(origin.loc).help(help).called(origin.call),
        );
        self.pretend(mv);
    }

    /// An arc, or the lines that may stand for it, off by so many mm for want of printed places.
    #[cold]
    pub(super) fn too_coarse(&mut self, mm: f64, mv: &Move, origin: &Origin) {
        let places = self.settings.places(Quantity::Length);
        let unit = if self.measures.inches { "an inch" } else { "a millimetre" };
        let more = (places + 1).to_string();
        let help = format!("print more places: `[output] decimals = {more}`");
        let help = Answer::key("output", "decimals").one_of(&[more]).help(help);
        self.page.text.drop_line();
        self.diags
            .push(codes::O9335::printed_with_places(&places, &unit, &mm).at(origin.loc).help(help).called(origin.call));
        self.pretend(mv);
    }

    /// Inches are a wish of the configuration.
    #[cold]
    pub(super) fn lacks_inches(&mut self) {
        let start = Loc { line: 1, ..Loc::default() };
        let help = in_millimetres("set `[output] units = \"mm\"`, or leave the key away");
        self.lacks(codes::O9332, &Origin { loc: start, ..Origin::default() }, "inches", help);
    }

    /// Rapid traverse goes at the last F, and nobody said at which.
    #[cold]
    pub(super) fn lacks_rapid_feed(&mut self, origin: &Origin) {
        let help = "set `[output] rapid_feed` in mm/min, such as 3000";
        let help = Answer::key("output", "rapid_feed").help(help);
        self.diags.push(
            codes::O9333::on_target_rapid_traverse_goes_at_last(&self.target.name)
                .at(origin.loc)
                .help(help)
                .called(origin.call),
        );
    }

    /// May this M function of spindle, coolant or stops be printed? Some receivers have them as macros alone.
    pub(super) fn has_m(&mut self, number: u32, origin: &Origin) -> bool {
        let there = !self.target.m.listed || self.settings.pass_m.contains(&number);
        if !there {
            self.diags.push(
                codes::O9334::target_has_m_as_macro(&self.target.name, &number)
                    .answer(Answer::pass_m(number))
                    .at(origin.loc)
                    .called(origin.call),
            );
        }
        there
    }

    /// Does the receiver have a length or a radius of this number? How many there are is an option of some.
    pub(super) fn has_offset(&mut self, number: u32, letter: u8, origin: &Origin) -> bool {
        let Some(usual) = self.target.tool.most_offset else { return true };
        let most = self.settings.tool_offsets.unwrap_or(usual);
        if number > most {
            self.page.text.drop_line();
            let (name, letter) = (self.target.name, letter as char);
            let help = "say how many it has (`[output] tool_offsets`), or give the tool a smaller number (`number` in `[tools]`)";
            let help = Answer::key("output", "tool_offsets").help(help);
            self.diags.push(
                codes::O9337::target_is_taken_to_have_offsets(&letter, &number, &name, &most)
                    .at(origin.loc)
                    .help(help)
                    .called(origin.call),
            );
        }
        number <= most
    }

    /// What the number of a wait counts is a setting of the receiver.
    #[cold]
    pub(super) fn lacks_dwell_unit(&mut self, origin: &Origin) {
        let help = "set `[output] dwell_unit` as the receiver is set";
        let help = Answer::key("output", "dwell_unit").one_of(&["\"seconds\"", "\"milliseconds\""]).help(help);
        self.diags.push(
            codes::O9331::seconds_or_milliseconds(&self.target.name).at(origin.loc).help(help).called(origin.call),
        );
    }

    /// The target may choose a place farther along the contour as the end of its way there.
    pub(super) fn begins_at_rapid(&self, mv: &Move, origin: &Origin) {
        if mv.side != Side::None && matches!(mv.path, Path::Rapid) && self.diags.first_time(codes::O4005, ()) {
            let help = resolve("lead to the contour at a feed, or set `[output] compensation = \"resolve\"`");
            self.diags.push(
                codes::O4005::radius_compensation_begins_in_rapid_move().at(origin.loc).help(help).called(origin.call),
            );
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
            let message =
                format!("the {what} prints as {printed}, which is {percent:.1} % {more} than the program says");
            let key = match what {
                "speed" => "decimals.speed",
                "lead" => "decimals",
                _ => "decimals.feed",
            };
            let help = format!(
                "print more places where the target reads them (`[output] {key}`), or program a {what} that can be said"
            );
            let help = Answer::key("output", "decimals").help(help);
            self.diags.push(Diagnostic::new(code, origin.loc, message).help(help).called(origin.call));
        }
        !another
    }

    /// A wait that is shorter than half of its last place.
    #[cold]
    pub(super) fn wait_is_lost(&mut self, seconds: f64, origin: &Origin) {
        let help = if self.settings.waits_in_milliseconds() {
            "the target counts whole milliseconds: program 0.001 s, or leave the wait out".into()
        } else {
            let help = "print more places (`[output] decimals = { time = 3 }`), or leave the wait out";
            Answer::key("output", "decimals").one_of(&["{ time = 3 }"]).help(help)
        };
        self.diags.push(codes::O1005::wait_of_s_prints_as_zero(&seconds).at(origin.loc).help(help).called(origin.call));
    }

    #[cold]
    pub(super) fn lacks_axes(&mut self, lacking: AxisSet, mv: &Move, origin: &Origin) {
        self.axes = self.axes.union(lacking);
        let letters: String = lacking.iter().map(Axis::letter).collect();
        let what = format!("the {} {letters}", if lacking.len() == 1 { "axis" } else { "axes" });
        let help = "turn the axis by hand between programs, or take another target";
        self.lacks(codes::O9309, origin, &what, help);
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
