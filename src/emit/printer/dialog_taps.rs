//! Taps of a dialog: a cycle in one go, or one in steps, each with its call.

use crate::geo::tolerance;
use crate::ir::function::{Function, Turn};
use crate::ir::{Origin, Tap};
use crate::target::TapDialog;

use super::super::number::Places;
use super::Printer;
use super::taps::{Hole, Unfit};

/// Factors on the speed of the way back that the cycle takes.
const FACTORS: std::ops::RangeInclusive<f64> = 0.0001..=10.0;
/// Parameters behind those of the plain cycle: depth of a step, way back in pitches, angle, factor on the speed.
const MORE: usize = 4;

/// Steps of a cycle: how deep each of them is, and the way back between them.
#[derive(Debug, Clone, Copy)]
struct Steps {
    way: f64,
    /// `None` for out of the hole.
    back: Option<f64>,
}

impl Printer<'_> {
    pub(super) fn dialog_taps(&mut self, hole: &Hole<'_>, words: &TapDialog, origin: &Origin) -> Result<(), Unfit> {
        let tap = hole.tap;
        self.goes_down(tap)?;
        let factor = tap.factor();
        let taken = FACTORS.contains(&factor);
        self.leaves_out(&self.lost_details(tap, true, !taken), origin);
        let steps = even_steps(tap).filter(|steps| tap.pause == 0.0 && self.says_steps(tap, *steps));
        let strokes = if steps.is_some() {
            let last = hole.strokes.last().copied();
            if last.is_none_or(|(_, back)| back != hole.start) {
                return self.returns(hole, origin);
            }
            last.into_iter().collect()
        } else {
            self.returns(hole, origin)?;
            hole.strokes.clone()
        };
        if self.tap_speed(tap, true, origin)?.is_none() {
            return Err(self.speed_not_known());
        }
        let factor = if taken { factor } else { 1.0 };
        let alone = strokes.len() == 1;
        for (at, (to, _)) in strokes.into_iter().enumerate() {
            if at > 0 && tap.pause > 0.0 {
                self.print_function(&Function::Dwell(tap.pause), origin);
            }
            self.dialog_tap(hole, to, (steps, alone), factor, words, origin)?;
        }
        self.stated.turn = None;
        Ok(())
    }

    /// Do the printed numbers of the steps lead where they are meant to?
    fn says_steps(&self, tap: &Tap, steps: Steps) -> bool {
        let places = self.places_of(tap.axis);
        let exact = |value: f64| {
            places
                .units(value)
                .is_some_and(|units| (units as f64 / places.scale() - value).abs() <= tolerance::SAME / places.scale())
        };
        // The last step is one in the printed numbers, too.
        let last = places.units(tap.surface).zip(places.units(tap.bottom())).zip(places.units(steps.way));
        let goes_deeper =
            last.is_some_and(|((surface, to), way)| surface - to > way.saturating_mul(tap.strokes.len() as i64 - 1));
        exact(steps.way) && goes_deeper && steps.back.is_none_or(|back| exact(back) && back > 0.0)
    }

    /// One cycle down to `to`. Where it is not `alone` it begins at an angle that is said, so that all cut one thread.
    fn dialog_tap(
        &mut self,
        hole: &Hole<'_>,
        to: i64,
        (steps, alone): (Option<Steps>, bool),
        factor: f64,
        words: &TapDialog,
        origin: &Origin,
    ) -> Result<(), Unfit> {
        let tap = hole.tap;
        let lead = self.tap_lead(tap, origin)?;
        let lead = if tap.turn == Turn::Clockwise { lead } else { -lead };
        let (places, factors) = (self.places_of(tap.axis), Places::new(words.places));
        let plain = alone && steps.is_none() && tap.orient.is_none() && factor == 1.0;
        let numbers = (
            places.units(tap.surface),
            steps.map_or(Some(0), |steps| places.units(steps.way)),
            factors.units(steps.and_then(|steps| steps.back).unwrap_or(0.0) / tap.lead),
            self.measures.angle.units(tap.orient.unwrap_or(0.0)),
            factors.units(factor),
        );
        let (Some(surface), Some(way), Some(back), Some(angle), Some(factor)) = numbers else {
            self.unprintable(origin);
            return Err(None);
        };
        // Rounded, the depth may be a unit more than its steps, and the cycle would make another one.
        let over = surface - to - way.saturating_mul(tap.strokes.len() as i64);
        let surface = if steps.is_some() && over == 1 { surface - 1 } else { surface };
        let clearance = hole.start - surface;
        let of_plain = [
            (clearance, places),
            (to - surface, places),
            (lead, self.measures.lead),
            (surface, places),
            (clearance, places),
        ];
        let more: [_; MORE] = [(way, places), (back, factors), (angle, self.measures.angle), (factor, factors)];
        let taken = if plain { words.of_plain } else { words.parameters.len() };
        self.lines.words(&format!("{} ~", if plain { words.plain } else { words.stepped }), origin);
        for (at, ((units, places), (name, what))) in
            of_plain.into_iter().chain(more).zip(words.parameters).take(taken).enumerate()
        {
            self.lines.text.raw(b"  ").raw(name.as_bytes()).raw(b"=").signed(units, places);
            let goes_on = if at + 1 < taken { " ~" } else { "" };
            self.lines.continued(format!(" ;{what}{goes_on}").as_bytes(), origin);
        }
        self.lines.words(words.call, origin);
        Ok(())
    }
}

/// The steps of a tap, where all are alike and the last one is no deeper.
fn even_steps(tap: &Tap) -> Option<Steps> {
    let (_, others) = tap.strokes.split_last()?;
    let first = others.first()?;
    let out = tap.outward();
    let deep = |height: f64| (tap.surface - height) * out;
    let way = deep(first.to);
    let even =
        (1..).zip(others).all(|(step, stroke)| (deep(stroke.to) - way * f64::from(step)).abs() <= tolerance::SAME);
    let rest = deep(tap.bottom()) - way * others.len() as f64;
    let leaves = others.iter().all(|stroke| stroke.back == tap.start);
    let back = (first.back - first.to) * out;
    let alike = others.iter().all(|stroke| ((stroke.back - stroke.to) * out - back).abs() <= tolerance::SAME);
    let whole = even && way > 0.0 && rest > tolerance::SAME && rest <= way + tolerance::SAME && (leaves || alike);
    whole.then_some(Steps { way, back: (!leaves).then_some(back) })
}
