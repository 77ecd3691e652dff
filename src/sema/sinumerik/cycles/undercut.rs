//! Undercut cycles: CYCLE94, CYCLE96, CYCLE940.
//!
//! Source: reference sections 4, 5.1 and 5.7.

use crate::diag::codes;
use crate::geo::undercut::{Allowance, Orientation, Shape};
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::undercut::UndercutCycle;
use crate::ir::undercut::{ThreadForm, form_e, form_f, thread};
use crate::machine::MachineKind;
use crate::machine::undercut::{Din76, Din509};

use super::super::value::whole;
use super::super::{Outcome, Run};
use super::Arguments;

/// Entry angle of thread undercuts where none is given.
const ENTRY: Deg = Deg(30.0);
/// Safety clearance of the classic cycles, in mm.
const CLEARANCE: f64 = 1.0;
/// Sizes of CYCLE940 for forms E and F, as radius and depth, by index.
const SIZES: [(f64, f64); 10] = [
    (0.6, 0.3),
    (1.0, 0.4),
    (1.0, 0.2),
    (1.6, 0.3),
    (2.5, 0.4),
    (4.0, 0.5),
    (0.4, 0.2),
    (0.6, 0.2),
    (0.1, 0.1),
    (0.2, 0.1),
];

impl Run<'_> {
    pub(super) fn undercut_cycle(&mut self, args: &Arguments) -> Outcome {
        self.undercut_conditions(args)?;
        match args.name.as_str() {
            "CYCLE940" => self.new_undercut(args),
            _ => self.classic_undercut(args),
        }
    }

    /// Undercuts belong to turning, in the plane of the diameter axis.
    fn undercut_conditions(&self, args: &Arguments) -> Outcome {
        let machine = &self.job.settings.machine;
        if machine.kind != MachineKind::Lathe {
            return self.cycle_fault(
                args,
                args.span,
                0,
                "undercuts need turning technology",
                "set `[machine] kind = \"lathe\"`",
            );
        }
        self.in_turning_plane(args)?;
        let [first, second, _] = self.st.roles();
        if machine.diameter_axis != Some(second) && machine.diameter_axis != Some(first) {
            return self.cycle_fault(
                args,
                args.span,
                16510,
                "machine datum 20100 names no axis of G18, so there are no undercuts",
                "set `[machine] diameter_axis = \"X\"`",
            );
        }
        Ok(())
    }

    /// `CYCLE94(SPD, SPL, FORM, VARI)`, `CYCLE96(DIATH, SPL, FORM, VARI)`
    fn classic_undercut(&mut self, args: &Arguments) -> Outcome {
        let diameter = self.needed_length(args, 1, "the diameter")?;
        let z = self.needed_length(args, 2, "the corner along Z")?;
        let form = args.text(3).unwrap_or_default();
        let orientation = self.classic_position(args)?;
        let tables = self.job.settings.undercut.clone();
        let (shape, corner) = if args.name == "CYCLE94" {
            if diameter < 3.0 {
                return self.cycle_fault(
                    args,
                    args.span_of(1),
                    61601,
                    "the finished diameter is below 3 mm",
                    "check SPD",
                );
            }
            let Some(size) = tables.size_for(diameter) else {
                return self.cycle_fault(
                    args,
                    args.span_of(1),
                    61601,
                    "the table has no size for this diameter",
                    "add it to `[undercut] din509`",
                );
            };
            self.note_once(
                codes::S8022,
                args.span,
                "sizes of DIN 509 overlap; the row by diameter is taken as `[undercut]` lists it",
            );
            (self.form_of(args, &form, size)?, Point2::new(z, diameter / 2.0))
        } else {
            let pitch = self.pitch_of_size(args, diameter)?;
            let Some(row) = tables.thread(pitch) else {
                return self.cycle_fault(
                    args,
                    args.span_of(1),
                    61001,
                    "the table has no row for this pitch",
                    "add it to `[undercut] din76`",
                );
            };
            let (shape, internal) = self.thread_form(args, 3, &form, row, ENTRY)?;
            // An internal undercut starts from the bore.
            let bore = diameter - 1.08253 * pitch;
            (shape, Point2::new(z, if internal { bore } else { diameter } / 2.0))
        };
        let feed = self.cycle_feed(args)?;
        self.send_undercut(args, corner, orientation, shape, feed, CLEARANCE, None, None, 0.0, Allowance::default())
    }

    fn pitch_of_size(&self, args: &Arguments, diameter: f64) -> Outcome<f64> {
        match crate::machine::undercut::coarse_pitch(diameter) {
            Some(pitch) if (3.0..=68.0).contains(&diameter) => Ok(pitch),
            _ => {
                let near = crate::machine::undercut::proposed_pitch(diameter);
                let help = match near {
                    Some(pitch) => format!("the pitch {pitch} fits this diameter: use CYCLE940 with it"),
                    None => "give a metric size from M3 to M68".to_owned(),
                };
                self.cycle_fault(args, args.span_of(1), 61601, &format!("M{diameter} is no metric size"), &help)
            }
        }
    }

    /// Where the corner lies: by `_VARI`, or by the cutting-edge position of the tool.
    fn classic_position(&self, args: &Arguments) -> Outcome<Orientation> {
        let position = match args.or_zero(4) {
            0.0 => self.active_tool().and_then(|tool| tool.orientation).map(f64::from).unwrap_or(0.0),
            given => given,
        };
        let (first, second) = match position {
            1.0 => (-1.0, -1.0),
            2.0 => (1.0, -1.0),
            3.0 => (1.0, 1.0),
            4.0 => (-1.0, 1.0),
            _ => {
                let alarm = if args.or_zero(4) == 0.0 { 61608 } else { 61613 };
                return self.cycle_fault(
                    args,
                    args.span_of(4),
                    alarm,
                    "the position of the undercut is not known",
                    "give 1 to 4 as the last argument, or `orientation` of the tool in [tools]",
                );
            }
        };
        Ok(Orientation { first, second, first_leads: true })
    }

    fn form_of(&self, args: &Arguments, form: &str, size: &Din509) -> Outcome<Shape> {
        match form {
            "E" => Ok(form_e(size)),
            "F" => Ok(form_f(size)),
            _ => self.cycle_fault(
                args,
                args.span_of(3),
                61609,
                &format!("there is no form `{form}`"),
                "give \"E\" or \"F\"",
            ),
        }
    }

    /// Shape of a thread undercut, and whether it is internal.
    fn thread_form(
        &self,
        args: &Arguments,
        place: usize,
        form: &str,
        row: &Din76,
        entry: Deg,
    ) -> Outcome<(Shape, bool)> {
        let form = match form {
            "A" => ThreadForm::A,
            "B" => ThreadForm::B,
            "C" => ThreadForm::C,
            "D" => ThreadForm::D,
            _ => {
                let message = format!("there is no form `{form}`");
                return self.cycle_fault(args, args.span_of(place), 61609, &message, "give \"A\" to \"D\"");
            }
        };
        let (shape, doubts) = thread(&self.job.settings.undercut, row, form, entry);
        if doubts.any() {
            self.note_once(
                codes::S8022,
                args.span,
                format!("the undercut rests on facts that are not confirmed: {doubts}"),
            );
        }
        Ok((shape, form == ThreadForm::C || form == ThreadForm::D))
    }

    fn new_undercut(&mut self, args: &Arguments) -> Outcome {
        let x = self.needed_length(args, 1, "the corner _SPD")? / 2.0;
        let z = self.needed_length(args, 2, "the corner _SPL")?;
        let form = args.text(3).unwrap_or_default();
        let (first, second) = match args.or_zero(4) {
            0.0 => (-1.0, 1.0),
            1.0 => (1.0, 1.0),
            2.0 => (-1.0, -1.0),
            3.0 => (1.0, -1.0),
            _ => {
                return self.cycle_fault(
                    args,
                    args.span_of(4),
                    61613,
                    "_LAGE is 0 to 3",
                    "0 and 1 external, 2 and 3 internal",
                );
            }
        };
        let orientation = Orientation { first, second, first_leads: true };
        let clearance = self.needed_length(args, 5, "the safety clearance _SDIS")?;
        let feed = self.needed(args, 6, "the feed _FFP")?;
        let corner = Point2::new(z, x);
        let entry = args.number(12).map_or(ENTRY, Deg);
        let mut allowance = Allowance::default();
        let shape = match form.as_str() {
            "E" | "F" => {
                let Some(size) = self.size_of_index(args) else {
                    return self.cycle_fault(
                        args,
                        args.span_of(18),
                        0,
                        "the size _PITI is not in the table",
                        "give 0 to 9",
                    );
                };
                let incremental_x = args.digit(22, 0) == 1;
                if let Some(value) = self.length_of(args, 8) {
                    allowance.reference = if incremental_x { value } else { (value / 2.0 - x) * second };
                }
                if let Some(value) = self.length_of(args, 9) {
                    allowance.other = if args.digit(22, 1) == 1 { value } else { (value - z) * first };
                }
                self.form_of(args, &form, &size)?
            }
            "T" => self.free_form(args, entry, x)?,
            _ => {
                let pitches = self.job.settings.undercut.threads();
                let index = args.number(18).and_then(whole).and_then(|n| usize::try_from(n).ok());
                let Some(row) = index.and_then(|at| pitches.get(at)).copied() else {
                    return self.cycle_fault(
                        args,
                        args.span_of(18),
                        61001,
                        "the pitch _PITI is not in the table",
                        "give the index in the list of pitches",
                    );
                };
                if !(30.0..=90.0).contains(&entry.0) {
                    return self.cycle_fault(
                        args,
                        args.span_of(12),
                        0,
                        "the entry angle lies outside 30 to 90 degrees",
                        "give _STA from 30 to 90",
                    );
                }
                let (shape, internal) = self.thread_form(args, 3, &form, &row, entry)?;
                if internal != (second < 0.0) {
                    return self.cycle_fault(
                        args,
                        args.span_of(4),
                        0,
                        "form and position contradict each other",
                        "A and B are external, C and D internal",
                    );
                }
                shape
            }
        };
        let face_end = self.length_of(args, 13).map(|diameter| diameter / 2.0);
        let step = match form.as_str() {
            "E" | "F" => None,
            _ => match args.digit(7, 0) {
                2 => None,
                1 | 3 => Some(self.needed_length(args, 14, "the infeed `_MID`")?),
                _ => return self.cycle_fault(args, args.span_of(7), 61002, "_VARI is 1, 2 or 3", "2 finishes only"),
            },
        };
        if step.is_some() {
            self.note_once(
                codes::S8023,
                args.span_of(14),
                "roughing of the undercut is up to the control; it is cut in equal steps parallel to its floor",
            );
        }
        if args.digit(7, 0) == 1 && step.is_some() && form != "E" && form != "F" {
            return self.not_built(args, 7, "roughing without finishing");
        }
        let finish = self.length_of(args, 15).unwrap_or(0.0);
        let feed = Feed::PerRevolution(feed * self.st.feed_unit());
        self.send_undercut(args, corner, orientation, shape, feed, clearance, face_end, step, finish, allowance)
    }

    fn size_of_index(&self, args: &Arguments) -> Option<Din509> {
        let index = args.number(18).and_then(whole).and_then(|n| usize::try_from(n).ok())?;
        let (radius, depth) = *SIZES.get(index)?;
        self.job.settings.undercut.size(radius, depth).copied()
    }

    /// Form T: free dimensions.
    fn free_form(&self, args: &Arguments, entry: Deg, x: f64) -> Outcome<Shape> {
        let depth = self.needed_length(args, 8, "the depth _EPD")?;
        let depth = if args.digit(22, 0) == 1 { depth.abs() } else { (x - depth / 2.0).abs() };
        let length = self.needed_length(args, 9, "the width _EPL")?;
        if args.digit(22, 1) != 1 {
            return self.not_built(args, 22, "an absolute width (`_AMODE`)");
        }
        self.note_once(
            codes::S8022,
            args.span,
            "form T is read with the width from the corner to the start of the slope, R1 at the slope and R2 at the face",
        );
        Ok(Shape::Square {
            length: length.abs(),
            depth,
            entry,
            entry_radius: self.length_of(args, 10).unwrap_or(0.0),
            corner_radius: self.length_of(args, 11).unwrap_or(0.0),
        })
    }

    #[allow(clippy::too_many_arguments)]
    fn send_undercut(
        &mut self,
        args: &Arguments,
        corner: Point2,
        orientation: Orientation,
        shape: Shape,
        feed: Feed,
        clearance: f64,
        face_end: Option<f64>,
        step: Option<f64>,
        finish: f64,
        allowance: Allowance,
    ) -> Outcome {
        self.turning_position(args.span)?;
        let compensated = self.job.settings.output.compensation == crate::machine::Compensation::Control;
        if compensated {
            self.select_cutter(args.span)?;
        } else {
            self.note_once(
                codes::S8024,
                args.span,
                "the undercut is cut with the programmed point of the tool: the control would compensate the nose radius",
            );
        }
        let cycle = UndercutCycle {
            corner,
            orientation,
            shape,
            allowance,
            clearance,
            face_end,
            feed,
            step,
            finish,
            finishing: true,
            compensated,
        };
        if let Err(fault) = cycle.check() {
            return self.cycle_fault(args, args.span, 0, &fault.to_string(), "check the arguments of the cycle");
        }
        self.send_cycle(Cycle::Undercut(cycle));
        Ok(())
    }
}
