//! Datums and rotations that touch probe cycles set, where the cycles themselves are left out.
//!
//! A datum that the control sets in the middle of a program makes two systems: blocks in front of the cycle count in the one,
//! blocks behind it in the other, and all of them are printed into one work offset. Only where the cycle sets what the
//! feature reads already, or where nothing moved in front but the probe, is that one system.
//!
//! Source: K 7.1 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::Deg;
use crate::geo::tolerance;
use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::probing::Probe;
use super::reading::Reading;
use super::words::MWord;
use super::{Outcome, Reported, Run};

/// Parameters by number: the row of the table that takes the datum, and which table it is.
const ROW: u32 = 305;
const TABLE: u32 = 303;
/// The tool axis is set, too.
const TOOL_AXIS_TOO: u32 = 381;
/// The axis of a cycle with one: 1, 2, 3.
const ONE_AXIS: u32 = 272;
/// Basic rotation.
const ANGLE: u32 = 307;
/// Cycles 14xx: what they correct.
const CORRECTS: [u32; 2] = [1120, 1121];

/// What a cycle sets that is left out.
#[derive(Debug)]
pub(super) enum Setting {
    /// Nothing, or what the feature reads already, or a row that a later cycle 247 selects.
    Nothing,
    /// The datum of these axes; where each of them lay and what it reads then, in mm, where the parameters say so.
    Datum { axes: AxisSet, reads: Vec<(Axis, f64, f64)> },
    /// A basic rotation or the turn of a table, by what is measured.
    Rotation,
    /// The machine's builder knows.
    Unknown,
}

impl Setting {
    /// May a basic rotation that is measured be in force after the cycle, or wait for its preset?
    pub(super) fn may_turn(&self, number: u32) -> bool {
        matches!(self, Setting::Rotation | Setting::Unknown) || matches!(number, 400..=405)
    }
}

/// A feature with a place by its parameters: the place, and what it reads then.
#[derive(Debug, Clone, Copy)]
struct Feature {
    /// First axis and second one.
    at: [u32; 2],
    reads: [u32; 2],
}

impl Probe {
    /// TCH PROBE 404 measures nothing and moves nothing.
    pub(super) fn sets_rotation(&self) -> bool {
        self.number == 404
    }

    /// What a cycle sets that is left out.
    pub(super) fn setting(&self, reading: Reading<'_, '_>, span: Span) -> Outcome<Setting> {
        let plane = AxisSet::MAIN.without(AxisSet::of(reading.st.axis()));
        Ok(match self.number {
            408..=419 if self.waits_in_a_row(reading, span)? => Setting::Nothing,
            408 | 409 => self.one_axis(reading, [321, 322, 0], 405, span)?,
            410..=413 => self.feature(reading, Feature { at: [321, 322], reads: [331, 332] }, span)?,
            416 => self.feature(reading, Feature { at: [273, 274], reads: [331, 332] }, span)?,
            417 => {
                let axis = reading.st.axis();
                self.datum(reading, &[(axis, 294, 333)], span)?
            }
            419 => self.one_axis(reading, [263, 264, 261], 333, span)?,
            414 | 415 | 418 => Setting::Datum { axes: plane, reads: Vec::new() },
            400..=402 if self.waits_in_a_row(reading, span)? => Setting::Nothing,
            400..=403 | 405 => Setting::Rotation,
            1400..=1499 => self.correction(reading, plane, span)?,
            0..=4 | 9 | 30..=33 | 420..=499 | 600 | 601 => Setting::Nothing,
            _ => Setting::Unknown,
        })
    }

    /// Does the datum wait in a row of the preset table for a cycle 247, and is another row in force?
    fn waits_in_a_row(&self, reading: Reading<'_, '_>, span: Span) -> Outcome<bool> {
        let row = self.value(reading, ROW, span)?.unwrap_or(0.0);
        let presets = self.value(reading, TABLE, span)? == Some(1.0);
        // The row that is in force may take it at once.
        let other = reading.st.frames.preset_row().is_some_and(|now| f64::from(now) != row);
        Ok(row > 0.0 && presets && other)
    }

    /// Q272 says which axis.
    fn one_axis(&self, reading: Reading<'_, '_>, at: [u32; 3], reads: u32, span: Span) -> Outcome<Setting> {
        let number = self.value(reading, ONE_AXIS, span)?;
        match (1..=3u32).find(|n| number == Some(f64::from(*n))) {
            Some(n) => {
                let i = n as usize - 1;
                self.datum(reading, &[(Axis::ALL[i], at[i], reads)], span)
            }
            None => Ok(Setting::Datum { axes: AxisSet::MAIN, reads: Vec::new() }),
        }
    }

    fn feature(&self, reading: Reading<'_, '_>, feature: Feature, span: Span) -> Outcome<Setting> {
        let (first, second, third) = reading.st.plane().axes();
        let [first, second, third] = [first, second, third].map(|i| Axis::ALL[i]);
        let mut axes = vec![(first, feature.at[0], feature.reads[0]), (second, feature.at[1], feature.reads[1])];
        if self.value(reading, TOOL_AXIS_TOO, span)? == Some(1.0) {
            axes.push((third, 384, 333));
        }
        self.datum(reading, &axes, span)
    }

    /// The datum of axes by the parameters of their places and of what they read then.
    fn datum(&self, reading: Reading<'_, '_>, list: &[(Axis, u32, u32)], span: Span) -> Outcome<Setting> {
        let mm = reading.core.mm();
        let mut reads = Vec::new();
        for &(axis, at, then) in list {
            if let (Some(at), Some(then)) = (self.value(reading, at, span)?, self.value(reading, then, span)?) {
                reads.push((axis, at * mm, then * mm));
            }
        }
        if reads.len() < list.len() {
            reads.clear();
        } else if reads.iter().all(|(_, at, then)| (at - then).abs() <= tolerance::SAME) {
            return Ok(Setting::Nothing);
        }
        let axes = list.iter().map(|(axis, ..)| *axis).collect();
        Ok(Setting::Datum { axes, reads })
    }

    /// 14xx correct the preset in force, and a rotation, where they are told to.
    fn correction(&self, reading: Reading<'_, '_>, plane: AxisSet, span: Span) -> Outcome<Setting> {
        let [datum, rotation] = CORRECTS;
        if self.value(reading, rotation, span)?.is_some_and(|value| value != 0.0) {
            return Ok(Setting::Rotation);
        }
        let shifts = self.value(reading, datum, span)?.is_some_and(|value| value != 0.0);
        Ok(if shifts { Setting::Datum { axes: plane, reads: Vec::new() } } else { Setting::Nothing })
    }
}

impl Run<'_> {
    /// Says what becomes of a datum that is set while its cycle is left out.
    pub(super) fn tell_of_setting(&mut self, probe: &Probe, setting: &Setting, span: Span) -> Outcome {
        let number = probe.number;
        // 400 to 405 and 420 to 431 may end the one in force.
        if self.st.frames.transform().is_turned_as_a_whole() && matches!(number, 400..=405 | 420..=431) {
            self.st.lose_all(&mut self.core);
            return self.core.refuse(span, codes::K9005::ends_basic_rotation_or_goes_on(&number));
        }
        let (axes, asking) = match setting {
            Setting::Nothing => return Ok(()),
            Setting::Datum { axes, reads } if reads.is_empty() => {
                (*axes, codes::K9005::sets_datum_by_what_it_measures(&number))
            }
            Setting::Datum { axes, reads } => {
                let (lay, read) =
                    (in_words(self.core.mm(), reads, |one| one.1), in_words(self.core.mm(), reads, |one| one.2));
                (*axes, codes::K9005::sets_datum_at_known_place(&number, &lay, &read))
            }
            Setting::Rotation => (AxisSet::MAIN, codes::K9005::turns_part_or_its_coordinates(&number)),
            Setting::Unknown => (AxisSet::MAIN, codes::K9005::is_cycle_of_machines_builder(&number)),
        };
        let refused = asking.answer(Answer::key("control", "probing_datum").one_of(&["\"set\""]));
        let worked = letters(axes.common(self.st.tool.worked));
        match self.core.job.settings.control.klartext_choices.probing_datum {
            Some(true) if worked.is_empty() => Ok(()),
            // A check of a tool between two tools is no datum.
            Some(true) if !matches!(setting, Setting::Unknown) => {
                self.st.lose_all(&mut self.core);
                self.core.refuse(span, codes::K2856::moved_in_front_of_it_with_another(&refused.message(), &worked))
            }
            Some(false) => {
                self.st.lose_all(&mut self.core);
                self.core.refuse(span, refused)
            }
            None | Some(true) => {
                let asking = codes::K2854::blocks_in_front(&refused.message());
                self.core.say(span, asking.answer(Answer::key("control", "probing_datum")));
                Ok(())
            }
        }
    }

    /// TCH PROBE 404: the basic rotation is a parameter. Nothing is measured, and nothing moves.
    pub(super) fn set_basic_rotation(&mut self, probe: &Probe, span: Span) -> Outcome {
        let Some(angle) = probe.value(self.reading(), ANGLE, span)? else {
            return self.core.refuse(span, codes::K2402::tch_probe_404_lacks_its_angle_q307());
        };
        if probe.value(self.reading(), ROW, span)?.unwrap_or(0.0) != 0.0 {
            self.st.lose_all(&mut self.core);
            return self.core.refuse(span, codes::K9005::writes_basic_rotation_into_preset_table());
        }
        if self.st.axis() != Axis::Z {
            self.st.lose_all(&mut self.core);
            return self.core.refuse(span, codes::K9005::turns_coordinates_about_z(&self.st.axis().letter()));
        }
        self.st.refuse_compensated(&mut self.core, "the basic rotation changes");
        let mut next = self.st.frames.transform().clone();
        next.basic = Some(Deg(angle));
        if angle != 0.0 {
            self.core.say(span, codes::K2853::tch_probe_404_turns_coordinates_by_about(&angle));
        }
        self.set_transformation(next)
    }

    /// M143: ends the basic rotation, as far as it is known.
    pub(super) fn end_basic_rotation(&mut self, m: &MWord) -> Outcome {
        if let Some(probed) = self.st.frames.probed() {
            self.st.lose_all(&mut self.core);
            let found =
                codes::K9008::m143_ends_basic_rotation().at(self.core.loc(m.span)).also(probed, Label::CycleLeftOut);
            self.core.report(found);
            return Err(Reported);
        }
        let mut next = self.st.frames.transform().clone();
        match next.basic.replace(Deg(0.0)) {
            Some(angle) if angle.0 != 0.0 => self.set_transformation(next),
            Some(_) => Ok(()),
            None => {
                self.core.note(m.span, codes::K2710::basic_rotation_of_preset());
                Ok(())
            }
        }
    }
}

/// Coordinates by axis, in the unit of the program.
fn in_words(mm: f64, reads: &[(Axis, f64, f64)], pick: fn(&(Axis, f64, f64)) -> f64) -> String {
    let shown = |value: f64| libm::round(value / mm * 1e4) / 1e4 + 0.0;
    let list: Vec<String> = reads.iter().map(|one| format!("{}{}", one.0.letter(), shown(pick(one)))).collect();
    list.join(" ")
}

fn letters(axes: AxisSet) -> String {
    let letters: Vec<String> = axes.iter().map(|axis| axis.letter().to_string()).collect();
    letters.join(" and ")
}
