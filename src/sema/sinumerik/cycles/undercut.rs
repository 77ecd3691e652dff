//! Undercut cycles: CYCLE94, CYCLE96, CYCLE940. What their arguments mean is in `undercut_call`.
//!
//! Source: C 4.1, 5.1 and 5.7 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::ir::cycle::undercut::{UndercutCycle, UndercutFault};
use crate::ir::cycle::{Cycle, Family};
use crate::ir::undercut::Surface;
use crate::machine::MachineKind;
use crate::standard::din13::proposed_pitch;

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{
    AMODE, Arguments, DIATH, DMODE, EPD, EPL, FAL, FALX, FALZ, FFP, FORM, Key, LAGE, MID, PITI, PTABA, R1, R2, SDIS,
    SPD, SPL, STA, VARI, VRT,
};
use super::call::CycleCall;
use super::undercut_call::{
    CallFault, Classic, Cycle940, Rests, cycle94, cycle96, cycle940, proposed_index, proposed_size,
};

/// Safety clearance of the classic cycles, in mm.
const CLEARANCE: f64 = 1.0;
/// Arguments of CYCLE940 that only some forms use, and the forms.
const OF_FORMS: [(Key, &str); 11] = [
    (VARI, "ABCDT"),
    (EPD, "EFT"),
    (EPL, "EFT"),
    (R1, "T"),
    (R2, "T"),
    (STA, "ABCDT"),
    (MID, "ABCDT"),
    (FAL, "ABCDT"),
    (FALX, "ABCDT"),
    (FALZ, "ABCDT"),
    (PITI, "ABCDEF"),
];

/// The form: one letter.
fn one_letter(args: &Arguments) -> Option<u8> {
    let form = args.text(FORM)?;
    Some(if form.len() == 1 { form.as_bytes()[0] } else { b'?' })
}

impl CycleCall<'_, '_> {
    /// CYCLE940
    pub(super) fn undercut_940(&mut self) -> Outcome {
        self.undercut_conditions()?;
        self.undercut_arguments()?;
        let made = cycle940(&self.call_940(), &self.job.settings.undercut);
        self.cut_undercut(made)
    }

    /// CYCLE94
    pub(super) fn undercut_by_diameter(&mut self) -> Outcome {
        self.undercut_conditions()?;
        let call = self.classic_call(SPD)?;
        let made = cycle94(&call, &self.job.settings.undercut);
        self.cut_undercut(made)
    }

    /// CYCLE96
    pub(super) fn undercut_of_thread(&mut self) -> Outcome {
        self.undercut_conditions()?;
        let call = self.classic_call(DIATH)?;
        let made = cycle96(&call, &self.job.settings.undercut);
        self.cut_undercut(made)
    }

    fn cut_undercut(&mut self, made: Result<(UndercutCycle, Rests), CallFault>) -> Outcome {
        match made {
            Ok((cycle, rests)) => {
                self.undercut_notes(&rests);
                self.send_undercut(cycle)
            }
            Err(fault) => self.undercut_fault(fault),
        }
    }

    /// Undercuts belong to turning, in the plane of the diameter axis.
    fn undercut_conditions(&self) -> Outcome {
        let args = self.args;
        let machine = &self.job.settings.machine;
        if machine.kind != MachineKind::Lathe {
            let help = Answer::key("machine", "kind").one_of(&["\"lathe\""]).help("set `[machine] kind = \"lathe\"`");
            return self.cycle_fault(args.span, None, "undercuts need turning technology", help);
        }
        self.in_turning_plane()?;
        self.no_normal_offset()?;
        let [first, second, _] = self.st.roles();
        if machine.diameter_axis != Some(second) && machine.diameter_axis != Some(first) {
            return self.cycle_fault(
                args.span,
                16510,
                "machine datum 20100 names no axis of G18, so there are no undercuts",
                Answer::key("machine", "diameter_axis").help("set `[machine] diameter_axis = \"X\"`"),
            );
        }
        Ok(())
    }

    /// Arguments that change the cut and are not known.
    fn undercut_arguments(&self) -> Outcome {
        let args = self.args;
        if args.text(FORM).is_none() {
            return self.undercut_fault(CallFault::Missing("_FORM"));
        }
        if args.text(PTABA).is_some_and(|text| !text.is_empty()) {
            return self.not_built(PTABA, "a thread by the name of a table (`_PTAB`, `_PTABA`)");
        }
        if self.names_other_plane(args) {
            return self.not_built(DMODE, "a plane other than the active one (`_DMODE`)");
        }
        // 0 and 1 up to the thousands were seen in stored calls; of the tens of `_VARI` both are cut in one way here.
        if (0..10).any(|place| args.digit(AMODE, place) > i32::from(place < 4)) {
            return self.not_built(AMODE, "another reading of an argument (`_AMODE`)");
        }
        if (1..10).any(|place| args.digit(VARI, place) > i32::from(place < 2)) {
            return self.not_built(VARI, "this kind of machining (`_VARI`)");
        }
        let form = args.text(FORM).unwrap_or_default();
        let known = OF_FORMS.iter().any(|(_, forms)| forms.contains(form.as_str()));
        for (key, forms) in OF_FORMS {
            if args.or_zero(key) != 0.0 && known && !form.is_empty() && !forms.contains(form.as_str()) {
                let message = format!("{}: form {form} does not use `{}`", args.name(), args.written(key));
                self.report(Diagnostic::new(codes::S8035, self.loc(args.span_of(key)), message));
            }
        }
        let internal = args.or_zero(LAGE) >= 2.0;
        if matches!(form.as_str(), "A" | "B") && internal || matches!(form.as_str(), "C" | "D") && !internal {
            let help = "forms A and B are external, C and D internal";
            return self.cycle_fault(args.span_of(LAGE), 61613, "the position contradicts the form", help);
        }
        if !matches!(form.as_str(), "E" | "F") && !(1..=3).contains(&args.digit(VARI, 0)) {
            let help = "1 roughs, 2 finishes, 3 does both";
            return self.cycle_fault(args.span_of(VARI), 61002, "`_VARI` is 1, 2 or 3", help);
        }
        if args.number(STA) == Some(0.0) && matches!(form.as_str(), "A" | "B" | "C" | "D" | "T") {
            return self.cycle_fault(args.span_of(STA), None, "the entry angle `_STA` is 0", "give 30 to 90 degrees");
        }
        if args.digit(VARI, 0) == 2 && "ABCDT".contains(form.as_str()) {
            for key in [MID, FAL, FALX, FALZ].into_iter().filter(|key| args.or_zero(*key) != 0.0) {
                self.unused(key, &args.written(key), "while finishing alone (`_VARI` 2)");
            }
        }
        let form_e = form == "E" || form == "F";
        for (key, digit) in [(EPD, 0), (EPL, 1)] {
            let negative = args.digit(AMODE, digit) == 1 && args.or_zero(key) < 0.0;
            if form_e && negative {
                let message = format!("the allowance `{}` is negative", args.written(key));
                return self.cycle_fault(args.span_of(key), None, &message, "give an allowance above 0, or none");
            }
        }
        if form_e && args.digit(AMODE, 0) != 1 && args.or_zero(EPD) != 0.0 {
            let inwards =
                (args.or_zero(EPD) - args.or_zero(SPD)) * if args.or_zero(LAGE) < 2.0 { 1.0 } else { -1.0 } < 0.0;
            if inwards {
                let help = "an allowance lies outside the finished part";
                return self.cycle_fault(
                    args.span_of(EPD),
                    None,
                    "the diameter with allowance `_EPD` lies inside the part",
                    help,
                );
            }
        }
        if form == "E" && args.or_zero(EPL) != 0.0 {
            return self.cycle_fault(
                args.span_of(EPL),
                None,
                "form E has no allowance along Z (`_EPL`)",
                "leave it out; form F relieves the face, too",
            );
        }
        Ok(())
    }

    fn call_940(&self) -> Cycle940 {
        let args = self.args;
        let mm = |key: Key| self.length_of(args, key);
        Cycle940 {
            spd: mm(SPD),
            spl: mm(SPL),
            form: one_letter(args),
            lage: args.number(LAGE),
            sdis: mm(SDIS),
            ffp: args.number(FFP).map(|feed| feed * self.st.feed_unit()),
            vari: args.number(VARI),
            epd: mm(EPD),
            epl: mm(EPL),
            r1: mm(R1),
            r2: mm(R2),
            sta: args.number(STA),
            vrt: mm(VRT),
            mid: mm(MID),
            fal: mm(FAL),
            falx: mm(FALX),
            falz: mm(FALZ),
            piti: args.number(PITI),
            amode: args.number(AMODE),
        }
    }

    /// The corner to which the active edge points, 1 to 4: what the program wrote goes before the table.
    fn corner_of_edge(&self) -> Option<u8> {
        let number = self.st.tool.active().filter(|_| !self.st.tool.edge_in_doubt())?;
        let position = self.edge_position(number, self.st.tool.edge_or_first()).and_then(whole)?;
        u8::try_from(position).ok().filter(|position| (1..=4).contains(position))
    }

    fn classic_call(&mut self, diameter: Key) -> Outcome<Classic> {
        let args = self.args;
        let edge = self.corner_of_edge();
        let position = match args.or_zero(VARI) {
            0.0 => edge,
            given if (1.0..=4.0).contains(&given) && given.fract() == 0.0 => Some(given as u8),
            _ => Some(0),
        };
        let by_tool = args.or_zero(VARI) == 0.0;
        if let (false, Some(edge), Some(given)) = (by_tool, edge, position.filter(|given| (1..=4).contains(given)))
            && edge != given
        {
            let message =
                format!("the position `_VARI` {given} contradicts the edge of the tool, which lies at {edge}");
            let help = "give the position of the tool that cuts the undercut, or leave the argument out";
            return self.cycle_fault(args.span_of(VARI), 61608, &message, help);
        }
        let Some(position) = position else {
            return self.cycle_fault(
                args.span,
                61608,
                "the edge of the tool does not lie in a corner, so the position of the undercut is not known",
                "give 1 to 4 as the last argument, `orientation` 1 to 4 of the tool in [tools], or `$TC_DP2` of the edge before the cycle",
            );
        };
        Ok(Classic {
            diameter: self.needed_length(diameter, "the diameter")?,
            spl: self.needed_length(SPL, "the corner along Z")?,
            form: one_letter(args).unwrap_or(b'?'),
            position,
            feed: self.cycle_feed()?,
            clearance: CLEARANCE,
        })
    }

    fn undercut_fault<T>(&self, fault: CallFault) -> Outcome<T> {
        let args = self.args;
        let new = args.place(LAGE) > 0;
        let corner = if args.place(DIATH) > 0 { DIATH } else { SPD };
        match fault {
            CallFault::Missing(name) => {
                let message = format!("`{name}` is missing");
                let help = match name {
                    "_LAGE" => "0 is external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z",
                    "_STA" if new && matches!(one_letter(args), Some(b'A'..=b'D' | b'a'..=b'd')) => {
                        "DIN 76 has 30 degrees: give 30 to 90"
                    }
                    "_FORM" => "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free",
                    _ => "arguments are counted by their commas",
                };
                self.cycle_fault(args.span, None, &message, help)
            }
            CallFault::Range(name) => {
                let message = format!("`{name}` is out of range");
                let help = match name {
                    "_EPD" => {
                        "an absolute diameter lies inside the material of the cylinder; `_AMODE` 1 reads an increment"
                    }
                    "_EPL" => "an absolute Z lies in front of the face; `_AMODE` 10 reads an increment",
                    _ => "`_STA` is 30 to 90 degrees; clearance, feed and infeed are above 0",
                };
                self.cycle_fault(args.span_of(Key(name.trim_start_matches('_'))), 61019, &message, help)
            }
            CallFault::Form => {
                let help = "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free (CYCLE940)";
                self.cycle_fault(args.span_of(FORM), 61609, "there is no such form", help)
            }
            CallFault::Position => {
                let help = "forms A and B are external, C and D internal";
                self.cycle_fault(
                    args.span_of(if new { LAGE } else { VARI }),
                    61613,
                    "the position does not exist or contradicts the form",
                    help,
                )
            }
            CallFault::Diameter => {
                let diameter = args.or_zero(corner) * self.st.length_unit();
                let help = match proposed_pitch(diameter) {
                    _ if !new && corner == SPD => "give a diameter from 3 mm".to_owned(),
                    Some(pitch) => format!("the pitch {pitch} is usual for this diameter: CYCLE940 takes it"),
                    None => "give a diameter from 3 mm, for CYCLE96 a metric size from M3 to M68".to_owned(),
                };
                self.cycle_fault(
                    args.span_of(corner),
                    61601,
                    &format!("the diameter {diameter} has no undercut"),
                    &help,
                )
            }
            CallFault::Size => {
                let at = args.span_of(if new { PITI } else { corner });
                let help = if new {
                    "`_PITI` is 0 to 9 for forms E and F, 0 to 23 for A to D"
                } else {
                    "add it under [undercut]"
                };
                self.cycle_fault(at, 61001, "the table has no such size or pitch", help)
            }
            CallFault::Pitch => {
                let inside = matches!(one_letter(args), Some(b'C' | b'D'));
                let surface = if inside { Surface::Internal } else { Surface::External };
                let help = match proposed_index(
                    &self.job.settings.undercut,
                    surface,
                    args.or_zero(corner) * self.st.length_unit(),
                ) {
                    Some((pitch, at)) => format!("{pitch} is usual for this diameter: `_PITI` {at}"),
                    None => "`_PITI` counts the pitches of DIN 76 from 0.2 on: 0 to 23".to_owned(),
                };
                self.cycle_fault(args.span, 61001, "the pitch `_PITI` (argument 18) is missing", &help)
            }
            CallFault::SizeMissing => {
                let help =
                    match proposed_size(&self.job.settings.undercut, args.or_zero(corner) * self.st.length_unit()) {
                        Some((size, at)) => format!("{size} is usual for this diameter: `_PITI` {at}"),
                        None => "`_PITI` counts the sizes of DIN 509: 0 to 9, 0 is 0.6x0.3".to_owned(),
                    };
                self.cycle_fault(args.span, 61001, "the size `_PITI` (argument 18) is missing", &help)
            }
            CallFault::BothAllowances => {
                let help = "the control takes either `_FAL` or `_FALX` and `_FALZ`: give one of them";
                let message = "an allowance on all sides stands beside one along an axis";
                self.cycle_fault(args.span_of(FAL), None, message, help)
            }
        }
    }

    fn send_undercut(&mut self, mut cycle: UndercutCycle) -> Outcome {
        let args = self.args;
        cycle.compensated = self.job.settings.output.compensation == crate::machine::Compensation::Control;
        if cycle.compensated {
            self.select_cutter(args.span)?;
        } else {
            if self.known_radius().is_some_and(|radius| radius > 0.0) {
                self.frame_is_not_scaled()?;
            }
            cycle.nose = self.nose_of_edge()?;
        }
        let internal = cycle.orientation.second < 0.0;
        let inside = cycle.corner.y - cycle.clearance;
        let face = cycle.face_end.unwrap_or(cycle.corner.y);
        if cycle.corner.y <= 0.0 || face < 0.0 || (internal && inside <= 0.0) {
            let help = "check the diameter, the end of the face and the clearance";
            return self.cycle_fault(args.span, None, "the cycle would go beyond the turning centre", help);
        }
        match cycle.check() {
            Ok(()) => {}
            Err(fault @ UndercutFault::Edge) => {
                let help = "take the tool whose edge points to the cylinder and to the face, or correct its position in the tool data";
                return self.cycle_fault(args.span, 61608, &fault.to_string(), help);
            }
            Err(fault) => {
                return self.cycle_fault(args.span, None, &fault.to_string(), "check the arguments of the cycle");
            }
        }
        self.send_from(self.in_front_of(&cycle), |_| Cycle::Undercut(cycle))
    }

    /// What is not confirmed, and what the control would choose.
    fn undercut_notes(&self, rests: &Rests) {
        let args = self.args;
        if rests.thread.any() {
            let message = format!("the undercut rests on facts that are not confirmed: {}", rests.thread);
            self.note_once(codes::S8022, args.span, message);
        } else if rests.size_index || rests.size_by_diameter || rests.convention {
            let what: Vec<&str> = [
                (rests.convention, "the reading of the position or of form T"),
                (rests.size_index, "the size by its index (`[undercut] din509_in_cycle`)"),
                (rests.size_by_diameter, "the size by the diameter (`[undercut] din509_by_diameter`)"),
            ]
            .into_iter()
            .filter_map(|(holds, text)| holds.then_some(text))
            .collect();
            let verb = if what.len() == 1 { "is" } else { "are" };
            let message = format!("{} {verb} not confirmed: compare with the drawing", what.join(" and "));
            self.note_once(codes::S8022, args.span, message);
        }
        if rests.allowance_along_x {
            self.reading(FALX, "`_FALX` counts on the radius");
        }
        if rests.other_allowance {
            let key = if args.or_zero(FAL) != 0.0 { FAL } else { FALZ };
            self.reading(
                key,
                "the thousands of `_AMODE` (1 for `_FAL`, else `_FALX` and `_FALZ`) choose the other allowance, and roughing leaves this one",
            );
        }
        if rests.roughing {
            self.note_once(
                codes::S8023,
                args.span_of(MID),
                "roughing of the undercut is up to the control; it is cut in equal steps parallel to its floor",
            );
        }
    }
}
