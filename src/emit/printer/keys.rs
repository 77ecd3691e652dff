//! Keys of `[output]` that change nothing on the target: said, so that nobody counts on them.

use crate::diag::codes;
use crate::machine::Axis;
use crate::machine::settings::Compensation;
use crate::target::{DwellUnit, EVERY_PLANE, Form, Length, ProgramName, RigidTap, Sequence};
use crate::text::Loc;

use super::Printer;

impl Printer<'_> {
    /// Says which keys the target does not use.
    pub(super) fn unused_keys(&self, lathe: bool) {
        let start = Loc { line: 1, ..Loc::default() };
        let name = self.target.name;
        let numbers = match self.target.line.sequence {
            Sequence::Address(..) => None,
            Sequence::Blocks => Some("numbers every block by itself"),
            Sequence::None => Some("takes no numbers of blocks"),
        };
        if let Some(why) = numbers
            && self.settings.line_numbers > 0
        {
            self.diags.push(codes::O9329::line_numbers(&name, &why).at(start));
        }
        for (key, spot) in &self.settings.stated.0 {
            let Some(why) = self.unused(key, lathe) else { continue };
            let mut help = "leave the key away".to_owned();
            if !spot.file.is_empty() {
                help = format!("{help}: {}:{}", spot.file, spot.line);
            }
            self.diags.push(codes::O9336::changes_nothing(&key, &name, &why).at(start).help(help));
        }
    }

    /// Why the target does not use this key. What it cannot say is refused where the program asks for it.
    fn unused(&self, key: &str, lathe: bool) -> Option<&'static str> {
        let (target, settings) = (self.target, self.settings);
        match key {
            "program_number" => {
                let in_comments = settings.header.iter().chain(&settings.footer).any(|line| line.contains("{number}"));
                match target.frame.name {
                    ProgramName::Number { .. } => None,
                    _ if in_comments => None,
                    ProgramName::Text { .. } => Some("names a program by its source"),
                    ProgramName::None => Some("does not name programs"),
                }
            }
            "dwell_unit" => match target.dwell.unit {
                unit if settings.dwell_unit == Some(unit) => None,
                DwellUnit::Setting => None,
                DwellUnit::Seconds => Some("counts waits in seconds"),
                DwellUnit::Milliseconds => Some("counts waits in milliseconds"),
            },
            "rapid_feed" => (!target.motion.rapid_at_feed).then_some("has a rapid traverse of its own"),
            "arc_fallback_tolerance" => {
                let every = target.arcs.helices && target.arcs.planes == EVERY_PLANE;
                (every && matches!(target.form, Form::Words)).then_some("goes round in every plane")
            }
            "tapping" => match target.motion.rigid_tap {
                None => Some("has no tap without a compensating chuck"),
                // Its blocks say everything.
                Some(RigidTap::InAndOut { .. }) => Some("says every tap as it is"),
                Some(RigidTap::Return { .. } | RigidTap::Cycle(_) | RigidTap::Dialog(_)) => None,
            },
            "tool_length" => match target.tool.length {
                // "G43" is refused where a tool is called.
                Length::None => Some("has no table of tool lengths"),
                Length::WithTool if settings.tool_length == Some(false) => Some("brings the length with the tool"),
                Length::WithTool | Length::Words(_) => None,
            },
            "tool_offsets" => {
                target.tool.most_offset.is_none().then_some("has no such limit, or no numbers of offsets")
            }
            "decimals.angle" => {
                let turns = self.axes.iter().any(Axis::is_rotary) || target.spindle.orient.is_some();
                (!turns).then_some("prints no angles by themselves")
            }
            "decimals.time" => settings.waits_in_milliseconds().then_some("counts waits in whole milliseconds"),
            "pass_m" => (!target.m.open && !target.m.listed).then_some("takes no M functions but its own"),
            "compensation" => {
                let control = settings.compensation == Compensation::Control;
                (control && target.compensation.is_none()).then_some("does not compensate the radius of a tool")
            }
            "diameter" => (!lathe).then_some("prints a mill, which has no diameters"),
            _ => None,
        }
    }
}
