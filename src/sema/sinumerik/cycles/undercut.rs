//! Undercut cycles: CYCLE94, CYCLE96, CYCLE940. What their arguments mean is in `undercut_call`.
//!
//! Source: C 4.1, 5.1 and 5.7 (docs/sources.md).

use crate::diag::{Answer, codes};
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
            return self.refuse_cycle(
                args.span,
                codes::P2090::undercuts_need_turning_technology()
                    .answer(Answer::key("machine", "kind").one_of(&["\"lathe\""])),
            );
        }
        self.in_turning_plane()?;
        self.no_normal_offset()?;
        let [first, second, _] = self.st.roles();
        if machine.diameter_axis != Some(second) && machine.diameter_axis != Some(first) {
            return self.refuse_cycle(
                args.span,
                codes::P2090::machine_datum_20100_names_no_axis().answer(Answer::key("machine", "diameter_axis")),
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
            return self.refuse_argument(PTABA, codes::S9015::thread_by_name_of_table());
        }
        if self.names_other_plane(args) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        // 0 and 1 up to the thousands were seen in stored calls; of the tens of `_VARI` both are cut in one way here.
        if (0..10).any(|place| args.digit(AMODE, place) > i32::from(place < 4)) {
            return self.refuse_argument(AMODE, codes::S9015::another_reading_of_argument());
        }
        if (1..10).any(|place| args.digit(VARI, place) > i32::from(place < 2)) {
            return self.refuse_argument(VARI, codes::S9015::this_kind_of_machining());
        }
        let form = args.text(FORM).unwrap_or_default();
        let known = OF_FORMS.iter().any(|(_, forms)| forms.contains(form.as_str()));
        for (key, forms) in OF_FORMS {
            if args.or_zero(key) != 0.0 && known && !form.is_empty() && !forms.contains(form.as_str()) {
                self.report(
                    codes::S8035::form_does_not_use(&args.name(), &form, &args.written(key))
                        .at(self.loc(args.span_of(key))),
                );
            }
        }
        let internal = args.or_zero(LAGE) >= 2.0;
        if matches!(form.as_str(), "A" | "B") && internal || matches!(form.as_str(), "C" | "D") && !internal {
            return self.refuse_cycle(args.span_of(LAGE), codes::P2090::position_contradicts_form());
        }
        if !matches!(form.as_str(), "E" | "F") && !(1..=3).contains(&args.digit(VARI, 0)) {
            return self.refuse_cycle(args.span_of(VARI), codes::P2090::vari_is_1_2_or_3());
        }
        if args.number(STA) == Some(0.0) && matches!(form.as_str(), "A" | "B" | "C" | "D" | "T") {
            return self.refuse_cycle(args.span_of(STA), codes::P2090::entry_angle_sta_is_0());
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
                return self.refuse_cycle(args.span_of(key), codes::P2090::allowance_is_negative(&args.written(key)));
            }
        }
        if form_e && args.digit(AMODE, 0) != 1 && args.or_zero(EPD) != 0.0 {
            let inwards =
                (args.or_zero(EPD) - args.or_zero(SPD)) * if args.or_zero(LAGE) < 2.0 { 1.0 } else { -1.0 } < 0.0;
            if inwards {
                return self
                    .refuse_cycle(args.span_of(EPD), codes::P2090::diameter_with_allowance_epd_lies_inside_part());
            }
        }
        if form == "E" && args.or_zero(EPL) != 0.0 {
            return self.refuse_cycle(args.span_of(EPL), codes::P2090::form_e_has_no_allowance_along_z());
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
            return self
                .refuse_cycle(args.span_of(VARI), codes::P2090::position_vari_contradicts_edge_of_tool(&given, &edge));
        }
        let Some(position) = position else {
            return self.refuse_cycle(args.span, codes::P2090::edge_of_tool_does_not_lie());
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
                let help = match name {
                    "_LAGE" => "0 is external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z",
                    "_STA" if new && matches!(one_letter(args), Some(b'A'..=b'D' | b'a'..=b'd')) => {
                        "DIN 76 has 30 degrees: give 30 to 90"
                    }
                    "_FORM" => "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free",
                    _ => "arguments are counted by their commas",
                };
                self.refuse_cycle(args.span, codes::P2090::is_missing_2(&name).help(help))
            }
            CallFault::Range(name) => {
                let help = match name {
                    "_EPD" => {
                        "an absolute diameter lies inside the material of the cylinder; `_AMODE` 1 reads an increment"
                    }
                    "_EPL" => "an absolute Z lies in front of the face; `_AMODE` 10 reads an increment",
                    _ => "`_STA` is 30 to 90 degrees; clearance, feed and infeed are above 0",
                };
                self.refuse_cycle(
                    args.span_of(Key(name.trim_start_matches('_'))),
                    codes::P2090::is_out_of_range(&name).help(help),
                )
            }
            CallFault::Form => self.refuse_cycle(args.span_of(FORM), codes::P2090::there_is_no_such_form()),
            CallFault::Position => self.refuse_cycle(
                args.span_of(if new { LAGE } else { VARI }),
                codes::P2090::position_does_not_exist_or_contradicts_form(),
            ),
            CallFault::Diameter => {
                let diameter = args.or_zero(corner) * self.st.length_unit();
                let help = match proposed_pitch(diameter) {
                    _ if !new && corner == SPD => "give a diameter from 3 mm".to_owned(),
                    Some(pitch) => format!("the pitch {pitch} is usual for this diameter: CYCLE940 takes it"),
                    None => "give a diameter from 3 mm, for CYCLE96 a metric size from M3 to M68".to_owned(),
                };
                self.refuse_cycle(args.span_of(corner), codes::P2090::diameter_has_no_undercut(&diameter).help(&help))
            }
            CallFault::Size => {
                let at = args.span_of(if new { PITI } else { corner });
                let help = if new {
                    "`_PITI` is 0 to 9 for forms E and F, 0 to 23 for A to D"
                } else {
                    "add it under [undercut]"
                };
                self.refuse_cycle(at, codes::P2090::table_has_no_such_size_or_pitch().help(help))
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
                self.refuse_cycle(args.span, codes::P2090::pitch_piti().help(&help))
            }
            CallFault::SizeMissing => {
                let help =
                    match proposed_size(&self.job.settings.undercut, args.or_zero(corner) * self.st.length_unit()) {
                        Some((size, at)) => format!("{size} is usual for this diameter: `_PITI` {at}"),
                        None => "`_PITI` counts the sizes of DIN 509: 0 to 9, 0 is 0.6x0.3".to_owned(),
                    };
                self.refuse_cycle(args.span, codes::P2090::size_piti().help(&help))
            }
            CallFault::BothAllowances => {
                self.refuse_cycle(args.span_of(FAL), codes::P2090::allowance_on_all_sides_stands_beside())
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
            return self.refuse_cycle(args.span, codes::P2090::cycle_would_go_beyond_turning_centre());
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
            self.say_once(args.span, codes::S8022::undercut_rests_on_facts_that_are_not(&rests.thread));
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
            self.say_once(args.span, codes::S8022::not_confirmed(&what.join(" and "), &verb));
        }
        if rests.allowance_along_x {
            self.reads(FALX, codes::P8106::falx_counts_on_radius_this_is_not());
        }
        if rests.other_allowance {
            let key = if args.or_zero(FAL) != 0.0 { FAL } else { FALZ };
            self.reads(key, codes::P8106::thousands_of_amode());
        }
        if rests.roughing {
            self.say_once(args.span_of(MID), codes::S8023::roughing_of_undercut_is_up_to_control());
        }
    }
}
