//! Undercut cycles: CYCLE94, CYCLE96, CYCLE940. What their arguments mean is in `undercut_call`.
//!
//! Source: C 4.1, 5.1 and 5.7 (docs/sources.md).

use core::fmt;

use crate::diag::{Fault, codes};
use crate::ir::cycle::undercut::{UndercutCycle, UndercutFault};
use crate::ir::cycle::{Cycle, Family};
use crate::ir::undercut::Surface;
use crate::standard::din13::proposed_pitch;

use super::super::value::whole;
use super::call::{Acts, CycleCall};
use super::names::{
    AMODE, DIATH, EPD, EPL, FAL, FALX, FALZ, FFP, FORM, LAGE, MID, PITI, PTABA, R1, R2, SDIS, SPD, SPL, STA, VARI, VRT,
};
use super::undercut_call::{
    CallFault, Classic, Cycle940, Rests, cycle94, cycle96, cycle940, proposed_index, proposed_size,
};
use crate::geo::Point2;
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::given::Given;
use crate::sema::cycle::row::Name;

/// Safety clearance of the classic cycles, in mm.
const CLEARANCE: f64 = 1.0;
/// Arguments of CYCLE940 that only some forms use, and the forms.
const OF_FORMS: [(Name, &str); 11] = [
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

/// A size as standards write it, with a decimal: `1.0x0.2`.
struct Plain(f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

/// The form: one letter.
fn one_letter(given: &Given) -> Option<u8> {
    let form = given.text(FORM)?;
    Some(if form.len() == 1 { form.as_bytes()[0] } else { b'?' })
}

impl CycleCall<'_> {
    /// CYCLE940
    pub(super) fn undercut_940(&self) -> Made<Acts> {
        self.undercut_arguments()?;
        let made = cycle940(&self.call_940(), &self.settings.undercut);
        self.cut_undercut(made)
    }

    /// CYCLE94
    pub(super) fn undercut_by_diameter(&self) -> Made<Acts> {
        let call = self.classic_call(SPD)?;
        let made = cycle94(&call, &self.settings.undercut);
        self.cut_undercut(made)
    }

    /// CYCLE96
    pub(super) fn undercut_of_thread(&self) -> Made<Acts> {
        let call = self.classic_call(DIATH)?;
        let made = cycle96(&call, &self.settings.undercut);
        self.cut_undercut(made)
    }

    fn cut_undercut(&self, made: Result<(UndercutCycle, Rests), CallFault>) -> Made<Acts> {
        match made {
            Ok((cycle, rests)) => {
                self.undercut_notes(&rests);
                self.send_undercut(cycle)
            }
            Err(fault) => self.undercut_fault(fault),
        }
    }

    /// Arguments that change the cut and are not known.
    fn undercut_arguments(&self) -> Made {
        let given = self.given;
        if given.text(PTABA).is_some() {
            return self.refuse_argument(PTABA, codes::S9015::thread_by_name_of_table());
        }
        // 0 and 1 up to the thousands were seen in stored calls; of the tens of `_VARI` both are cut in one way here.
        if (0..10).any(|place| given.digit(AMODE, place) > i32::from(place < 4)) {
            return self.refuse_argument(AMODE, codes::S9015::another_reading_of_argument());
        }
        if (1..10).any(|place| given.digit(VARI, place) > i32::from(place < 2)) {
            return self.refuse_argument(VARI, codes::S9015::this_kind_of_machining());
        }
        let form = given.text(FORM).unwrap_or_default();
        let known = OF_FORMS.iter().any(|(_, forms)| forms.contains(form));
        for (key, forms) in OF_FORMS {
            if given.or_zero(key) != 0.0 && known && !form.is_empty() && !forms.contains(form) {
                let fault = codes::S8035::form_does_not_use(&given.called, &form, &given.written(key));
                self.note(given.place_of(key), fault, Kind::Each);
            }
        }
        let internal = given.or_zero(LAGE) >= 2.0;
        if matches!(form, "A" | "B") && internal || matches!(form, "C" | "D") && !internal {
            return self.refuse_argument(LAGE, codes::P2090::position_contradicts_form());
        }
        if !matches!(form, "E" | "F") && !(1..=3).contains(&given.digit(VARI, 0)) {
            return self.refuse_argument(VARI, codes::P2090::vari_is_1_2_or_3());
        }
        if given.number(STA) == Some(0.0) && matches!(form, "A" | "B" | "C" | "D" | "T") {
            return self.refuse_argument(STA, codes::P2090::entry_angle_sta_is_0());
        }
        if given.digit(VARI, 0) == 2 && "ABCDT".contains(form) {
            for key in [MID, FAL, FALX, FALZ].into_iter().filter(|key| given.or_zero(*key) != 0.0) {
                self.unused(key, "while finishing alone (`_VARI` 2)");
            }
        }
        let form_e = form == "E" || form == "F";
        for (key, digit) in [(EPD, 0), (EPL, 1)] {
            let negative = given.digit(AMODE, digit) == 1 && given.or_zero(key) < 0.0;
            if form_e && negative {
                return self.refuse_argument(key, codes::P2090::allowance_is_negative(&given.written(key)));
            }
        }
        if form_e && given.digit(AMODE, 0) != 1 && given.or_zero(EPD) != 0.0 {
            let inwards =
                (given.or_zero(EPD) - given.or_zero(SPD)) * if given.or_zero(LAGE) < 2.0 { 1.0 } else { -1.0 } < 0.0;
            if inwards {
                return self.refuse_argument(EPD, codes::P2090::diameter_with_allowance_epd_lies_inside_part());
            }
        }
        if form == "E" && given.or_zero(EPL) != 0.0 {
            return self.refuse_argument(EPL, codes::P2090::form_e_has_no_allowance_along_z());
        }
        Ok(())
    }

    fn call_940(&self) -> Cycle940 {
        let given = self.given;
        let mm = |key: Name| given.length_if(key);
        Cycle940 {
            spd: mm(SPD),
            spl: mm(SPL),
            form: one_letter(given),
            lage: given.number(LAGE),
            sdis: mm(SDIS),
            ffp: given.number(FFP).map(|feed| feed * self.st.feed_unit()),
            vari: given.number(VARI),
            epd: mm(EPD),
            epl: mm(EPL),
            r1: mm(R1),
            r2: mm(R2),
            sta: given.number(STA),
            vrt: mm(VRT),
            mid: mm(MID),
            fal: mm(FAL),
            falx: mm(FALX),
            falz: mm(FALZ),
            piti: given.number(PITI),
            amode: given.number(AMODE),
        }
    }

    /// The corner to which the active edge points, 1 to 4: what the program wrote goes before the table.
    fn corner_of_edge(&self) -> Option<u8> {
        let number = self.st.tool.active().filter(|_| !self.st.tool.edge_in_doubt())?;
        let position = self.st.edge_position(self.settings, number, self.st.tool.edge_or_first()).and_then(whole)?;
        u8::try_from(position).ok().filter(|position| (1..=4).contains(position))
    }

    fn classic_call(&self, diameter: Name) -> Made<Classic> {
        let given = self.given;
        let edge = self.corner_of_edge();
        let position = match given.or_zero(VARI) {
            0.0 => edge,
            given if (1.0..=4.0).contains(&given) && given.fract() == 0.0 => Some(given as u8),
            _ => Some(0),
        };
        let by_tool = given.or_zero(VARI) == 0.0;
        if let (false, Some(edge), Some(given)) = (by_tool, edge, position.filter(|given| (1..=4).contains(given)))
            && edge != given
        {
            return self.refuse_argument(VARI, codes::P2090::position_vari_contradicts_edge_of_tool(&given, &edge));
        }
        let Some(position) = position else {
            return self.refuse(codes::P2090::edge_of_tool_does_not_lie());
        };
        Ok(Classic {
            diameter: self.given.length(diameter),
            spl: self.given.length(SPL),
            form: one_letter(given).unwrap_or(b'?'),
            position,
            feed: self.cycle_feed()?,
            clearance: CLEARANCE,
        })
    }

    fn undercut_fault<T>(&self, fault: CallFault) -> Made<T> {
        let given = self.given;
        let new = given.argument(LAGE) > 0;
        let corner = if given.argument(DIATH) > 0 { DIATH } else { SPD };
        match fault {
            CallFault::Missing(name) => {
                let help = self.help_of_missing(name);
                self.refuse(codes::P2090::is_missing_2(&name).help(help))
            }
            CallFault::Range(name) => {
                let help = match name {
                    "_EPD" => {
                        "an absolute diameter lies inside the material of the cylinder; `_AMODE` 1 reads an increment"
                    }
                    "_EPL" => "an absolute Z lies in front of the face; `_AMODE` 10 reads an increment",
                    _ => "`_STA` is 30 to 90 degrees; clearance, feed and infeed are above 0",
                };
                self.refuse_argument(Name::Word(name), codes::P2090::is_out_of_range(&name).help(help))
            }
            CallFault::Form => self.refuse_argument(FORM, codes::P2090::there_is_no_such_form()),
            CallFault::Position => self.refuse_argument(
                if new { LAGE } else { VARI },
                codes::P2090::position_does_not_exist_or_contradicts_form(),
            ),
            CallFault::Diameter => {
                let diameter = given.length(corner);
                let fault = match proposed_pitch(diameter) {
                    _ if !new && corner == SPD => codes::P2090::diameter_has_no_undercut(&diameter),
                    Some(pitch) => codes::P2090::diameter_has_undercut_of_pitch(&diameter, &pitch),
                    None => codes::P2090::diameter_has_no_thread(&diameter),
                };
                self.refuse_argument(corner, fault)
            }
            CallFault::Size => {
                let at = given.place_of(if new { PITI } else { corner });
                let help = if new {
                    "`_PITI` is 0 to 9 for forms E and F, 0 to 23 for A to D"
                } else {
                    "add it under [undercut]"
                };
                self.refuse_at(at, codes::P2090::table_has_no_such_size_or_pitch().help(help))
            }
            CallFault::Pitch => self.refuse(self.pitch_fault(given.length(corner))),
            CallFault::SizeMissing => self.refuse(match proposed_size(&self.settings.undercut, given.length(corner)) {
                Some(([radius, depth], at)) => codes::P2090::size_piti_is_usually(&Plain(radius), &Plain(depth), &at),
                None => codes::P2090::size_piti(),
            }),
            CallFault::BothAllowances => {
                self.refuse_argument(FAL, codes::P2090::allowance_on_all_sides_stands_beside())
            }
        }
    }

    fn help_of_missing(&self, name: &str) -> &'static str {
        match name {
            "_LAGE" => "0 is external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z",
            "_STA"
                if self.given.argument(LAGE) > 0
                    && matches!(one_letter(self.given), Some(b'A'..=b'D' | b'a'..=b'd')) =>
            {
                "DIN 76 has 30 degrees: give 30 to 90"
            }
            "_FORM" => "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free",
            _ => "arguments are counted by their commas",
        }
    }

    fn pitch_fault(&self, diameter: f64) -> Fault {
        let inside = matches!(one_letter(self.given), Some(b'C' | b'D'));
        let surface = if inside { Surface::Internal } else { Surface::External };
        match proposed_index(&self.settings.undercut, surface, diameter) {
            Some((pitch, at)) => codes::P2090::pitch_piti_is_usually(&pitch, &at),
            None => codes::P2090::pitch_piti(),
        }
    }

    fn send_undercut(&self, mut cycle: UndercutCycle) -> Made<Acts> {
        cycle.compensated = self.settings.output.compensation == crate::machine::Compensation::Control;
        if !cycle.compensated {
            if self.known_radius().is_some_and(|radius| radius > 0.0) {
                self.frame_is_not_scaled()?;
            }
            cycle.nose = self.nose_of_edge()?;
        }
        let internal = cycle.orientation.second < 0.0;
        let inside = cycle.corner.y - cycle.clearance;
        let face = cycle.face_end.unwrap_or(cycle.corner.y);
        if cycle.corner.y <= 0.0 || face < 0.0 || (internal && inside <= 0.0) {
            return self.refuse(codes::P2090::cycle_would_go_beyond_turning_centre());
        }
        match cycle.check() {
            Ok(()) => {}
            Err(fault @ UndercutFault::Edge) => {
                let help = "take the tool whose edge points to the cylinder and to the face, or correct its position in the tool data";
                return self.unsound_call(61608, &fault, help);
            }
            Err(fault) => return self.unsound_call(None, &fault, "check the arguments of the cycle"),
        }
        self.begins_at(self.in_front_of(&cycle), |_| Cycle::Undercut(cycle))
    }

    /// What is not confirmed, and what the control would choose.
    fn undercut_notes(&self, rests: &Rests) {
        let given = self.given;
        if rests.thread.any() {
            self.note(given.place, codes::S8022::undercut_rests_on_facts_that_are_not(&rests.thread), Kind::Once);
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
            self.note(given.place, codes::S8022::not_confirmed(&what.join(" and "), &verb), Kind::Once);
        }
        if rests.allowance_along_x {
            self.say_of(FALX, codes::P8106::falx_counts_on_radius_this_is_not());
        }
        if rests.other_allowance {
            let key = if given.or_zero(FAL) != 0.0 { FAL } else { FALZ };
            self.say_of(key, codes::P8106::thousands_of_amode());
        }
        if rests.roughing {
            self.note(given.place_of(MID), codes::S8023::roughing_of_undercut_is_up_to_control(), Kind::Once);
        }
    }

    /// In front of the face and out of the cylinder by the distance of the cycle, whatever the nose of the tool.
    fn in_front_of(&self, cycle: &UndercutCycle) -> Point2 {
        let nose = self.known_radius().unwrap_or(0.0).max(0.0);
        let face = cycle.face_end.map_or(0.0, |end| (end - cycle.corner.y).abs());
        let (along, away) = (cycle.clearance + 2.0 * nose, face + cycle.clearance);
        let (first, second) = (cycle.orientation.first, cycle.orientation.second);
        // Inside, not beyond the turning centre.
        let height = (cycle.corner.y + second * away).max(0.0);
        Point2::new(cycle.corner.x + first * along, height)
    }
}
