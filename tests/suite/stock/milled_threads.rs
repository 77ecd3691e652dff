//! Milled threads with sizes at random: one pitch and one hand all over, nothing beyond root and depth, rapid traverse where
//! the thread is not.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use partc::Settings;

use super::super::common::settings;
use super::super::damage::Dice;
use super::milling::{Cut, EXACT, track};
use super::pockets::number;

#[derive(Debug)]
struct Case {
    text: String,
    at: [f64; 2],
    external: bool,
    radius: f64,
    nominal: f64,
    core: f64,
    pitch: f64,
    left_hand: bool,
    depth: f64,
    teeth: usize,
    /// Greatest infeed towards the root; none for one pass.
    infeed: Option<f64>,
    /// What the last pass leaves.
    rest: f64,
}

impl Case {
    fn distance_of(&self, p: [f64; 3]) -> f64 {
        (p[0] - self.at[0]).hypot(p[1] - self.at[1])
    }

    fn judge(&self, settings: &Settings) -> Result<(), String> {
        let cuts = track(&self.text, settings).map_err(|codes| format!("refused: {codes:?}"))?;
        let mut helices: Vec<&Cut> = Vec::new();
        for cut in &cuts {
            let ways = (0..=24).map(|i| self.distance_of(cut.at(f64::from(i) / 24.0)));
            let (least, most) = ways.fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)));
            let below = cut.from[2].min(cut.to[2]) < 0.0;
            if !below {
                continue;
            }
            let free = match (self.external, cut.is_rapid()) {
                (false, true) => most + self.radius <= self.core + EXACT,
                (false, false) => most + self.radius <= self.nominal - self.rest + EXACT,
                (true, true) => least - self.radius >= self.nominal - EXACT,
                (true, false) => least - self.radius >= self.core + self.rest - EXACT,
            };
            if !free {
                return Err(format!("comes too near, {least} to {most} from the middle: {cut:?}"));
            }
            if cut.from[2].min(cut.to[2]) < -self.depth - EXACT {
                return Err(format!("goes below the depth: {cut:?}"));
            }
            let Some((center, sweep)) = cut.arc else { continue };
            if (center[0] - self.at[0]).hypot(center[1] - self.at[1]) > EXACT {
                let lead = (cut.to[2] - cut.from[2]) / sweep.abs() * TAU;
                if (lead.abs() - self.pitch).abs() > EXACT {
                    return Err(format!("a way with a lead of {lead}: {cut:?}"));
                }
                continue;
            }
            let lead = (cut.to[2] - cut.from[2]) / sweep * TAU;
            let wanted = if self.left_hand { -self.pitch } else { self.pitch };
            if (lead - wanted).abs() > EXACT {
                return Err(format!("a lead of {lead}, not {wanted}: {cut:?}"));
            }
            helices.push(cut);
        }
        self.complete(&helices)
    }

    /// All turns lie in one thread, reach its whole length, and the passes get closer by at most the infeed.
    fn complete(&self, helices: &[&Cut]) -> Result<(), String> {
        let Some(first) = helices.first() else { return Err("no turn of the thread".into()) };
        let beside = |cut: &&&Cut| {
            let turns = (cut.from[2] - first.from[2]) / self.pitch;
            (turns - turns.round()).abs() > EXACT
        };
        if let Some(cut) = helices.iter().find(beside) {
            return Err(format!("beside the thread: {cut:?}"));
        }
        let last = self.radius_of(helices[helices.len() - 1]);
        let root =
            if self.external { self.core + self.rest + self.radius } else { self.nominal - self.rest - self.radius };
        if (last - root).abs() > EXACT {
            return Err(format!("ends {last} from the middle, not {root}"));
        }
        let mut radius = if self.external { self.nominal + self.radius } else { self.core - self.radius };
        for cut in helices {
            let next = self.radius_of(cut);
            if self.infeed.is_some_and(|most| (next - radius).abs() > most + EXACT) {
                return Err(format!("an infeed from {radius} to {next}"));
            }
            radius = next;
        }
        let finish: Vec<&&Cut> = helices.iter().filter(|cut| (self.radius_of(cut) - root).abs() < EXACT).collect();
        let low = finish.iter().map(|cut| cut.from[2].min(cut.to[2])).fold(f64::MAX, f64::min);
        let high = finish.iter().map(|cut| cut.from[2].max(cut.to[2])).fold(f64::MIN, f64::max);
        // The teeth above the lowest one cut further turns.
        let high = high + (self.teeth as f64 - 1.0) * self.pitch;
        if low > -self.depth + self.pitch / 2.0 + EXACT || high < -EXACT {
            return Err(format!("reaches from {low} to {high} only"));
        }
        Ok(())
    }

    fn radius_of(&self, cut: &Cut) -> f64 {
        self.distance_of(cut.from)
    }
}

fn random(dice: &mut Dice) -> Case {
    let radius = number(dice, 1.0, 12.0);
    let external = dice.roll(2) == 0;
    let pitch = number(dice, 0.3, 4.0);
    let height = number(dice, 0.2 * pitch, 0.65 * pitch);
    let core = if external { number(dice, 2.0, 40.0) } else { radius + number(dice, 0.05, 20.0) };
    let nominal = core + height;
    let depth = number(dice, 0.5 * pitch, 30.0);
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let (clearance, kind) = (number(dice, 0.5, 3.0), usize::from(external));
    let mut text = format!("G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X7 Y3 Z80\n");
    let [x, y] = at;
    let mut case = Case {
        text: String::new(),
        at,
        external,
        radius,
        nominal,
        core,
        pitch,
        left_hand: false,
        depth,
        teeth: 1,
        infeed: None,
        rest: 0.0,
    };
    if dice.roll(4) == 0 {
        // Down from the surface: clockwise makes a right-hand thread.
        let direction = 2 + dice.roll(2);
        case.left_hand = direction == 3;
        let _ = writeln!(
            text,
            "CYCLE90(10,0,{clearance},,{depth},{},{},{pitch},500,{direction},{kind},{x},{y})",
            2.0 * nominal,
            2.0 * core
        );
    } else {
        case.teeth = [1, 1, 2, 3, 5, 12][dice.roll(6)];
        let (tens, hundreds, unit) = (dice.roll(3), dice.roll(2), 1 + dice.roll(2));
        case.left_hand = hundreds == 1;
        let rest = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.0, 0.3 * height) };
        let infeed = number(dice, 0.1 * height, 1.2 * height);
        if unit == 1 {
            (case.rest, case.infeed) = (rest, Some(infeed));
        }
        let _ = writeln!(
            text,
            "CYCLE70(10,0,{clearance},{},{},{height},{rest},{pitch},{},{infeed},500,{kind},{x},{y},{},{hundreds}{tens}{unit},1,,,,0,1,0)",
            -depth,
            2.0 * nominal,
            case.teeth,
            number(dice, 0.0, 360.0)
        );
    }
    text.push_str("M30\n");
    Case { text, ..case }
}

#[test]
fn milled_threads_at_random_keep_the_properties_of_cycles() {
    let settings = settings("[cycles]\nthread_milling_digits = true\n");
    super::milling::many("PARTC_MILLED_THREADS", 300, |dice, _| {
        let case = random(dice);
        case.judge(&settings).map_err(|why| format!("{why}\n{}{case:?}", case.text)).map(|()| true)
    });
}
