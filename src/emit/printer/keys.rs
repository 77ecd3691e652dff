//! Keys of `[output]` that change nothing on the target: said, so that nobody counts on them.

use std::fmt::Display;

use crate::diag::{Fault, codes};
use crate::machine::Axis;
use crate::machine::settings::Compensation;
use crate::target::{DwellUnit, EVERY_PLANE, Form, Length, ProgramName, RigidTap, Sequence};
use crate::text::Loc;

use super::Printer;

/// What is said of a key that the target does not use: by the key, the target and where it is written.
type Unused = fn(&dyn Display, &dyn Display, &dyn Display) -> Fault;

impl Printer<'_> {
    /// Says which keys the target does not use.
    pub(super) fn unused_keys(&self, lathe: bool) {
        let start = Loc { line: 1, ..Loc::default() };
        let name = self.target.name;
        let unused = match self.target.line.sequence {
            _ if self.settings.line_numbers == 0 => None,
            Sequence::Address(..) => None,
            Sequence::Blocks => Some(codes::O9329::target_numbers_every_block(&name)),
            Sequence::None => Some(codes::O9329::target_takes_no_numbers_of_blocks(&name)),
        };
        if let Some(fault) = unused {
            self.diags.push(fault.at(start));
        }
        for (key, spot) in &self.settings.stated.0 {
            let Some(unused) = self.unused(key, lathe) else { continue };
            let spot = if spot.file.is_empty() { String::new() } else { format!(": {}:{}", spot.file, spot.line) };
            self.diags.push(unused(&key, &name, &spot).at(start));
        }
    }

    /// Why the target does not use this key. What it cannot say is refused where the program asks for it.
    fn unused(&self, key: &str, lathe: bool) -> Option<Unused> {
        let (target, settings) = (self.target, self.settings);
        let (applies, unused): (bool, Unused) = match key {
            "program_number" => {
                let in_comments = settings.header.iter().chain(&settings.footer).any(|line| line.contains("{number}"));
                match target.frame.name {
                    ProgramName::Number { .. } => return None,
                    ProgramName::Text { .. } => (!in_comments, codes::O9336::names_program_by_its_source),
                    ProgramName::None => (!in_comments, codes::O9336::does_not_name_programs),
                }
            }
            "dwell_unit" => match target.dwell.unit {
                DwellUnit::Setting => return None,
                unit @ DwellUnit::Seconds => (settings.dwell_unit != Some(unit), codes::O9336::counts_waits_in_seconds),
                unit @ DwellUnit::Milliseconds => {
                    (settings.dwell_unit != Some(unit), codes::O9336::counts_waits_in_milliseconds)
                }
            },
            "rapid_feed" => (!target.motion.rapid_at_feed, codes::O9336::has_rapid_traverse_of_its_own),
            "arc_fallback_tolerance" => {
                let every = target.arcs.helices && target.arcs.planes == EVERY_PLANE;
                (every && matches!(target.form, Form::Words), codes::O9336::goes_round_in_every_plane)
            }
            "tapping" => match target.motion.rigid_tap {
                None => (true, codes::O9336::has_no_tap_without_chuck),
                // Its blocks say everything.
                Some(RigidTap::InAndOut { .. }) => (true, codes::O9336::says_every_tap_as_it_is),
                Some(RigidTap::Return { .. } | RigidTap::Cycle(_) | RigidTap::Dialog(_)) => return None,
            },
            "tool_length" => match target.tool.length {
                // "G43" is refused where a tool is called.
                Length::None => (true, codes::O9336::has_no_table_of_tool_lengths),
                Length::WithTool => (settings.tool_length == Some(false), codes::O9336::brings_length_with_tool),
                Length::Words(_) => return None,
            },
            "tool_offsets" => (target.tool.most_offset.is_none(), codes::O9336::has_no_such_limit),
            "decimals.angle" => {
                let turns = self.axes.iter().any(Axis::is_rotary) || target.spindle.orient.is_some();
                (!turns, codes::O9336::prints_no_angles)
            }
            "decimals.time" => (settings.waits_in_milliseconds(), codes::O9336::counts_waits_in_whole_milliseconds),
            "pass_m" => (!target.m.open && !target.m.listed, codes::O9336::takes_no_other_m_functions),
            "compensation" => {
                let control = settings.compensation == Compensation::Control;
                (control && target.compensation.is_none(), codes::O9336::does_not_compensate)
            }
            "diameter" => (!lathe, codes::O9336::prints_mill),
            _ => return None,
        };
        applies.then_some(unused)
    }
}
