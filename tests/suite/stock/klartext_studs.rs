//! Cycles 213, 215, 230, 232, 233, 256, 257 and 258 with sizes at random: the properties of docs/cycles.md, column by column.

use super::super::common::settings;
use super::super::damage::Dice;
use super::milling::{Cut, EXACT, Stock, beside, many, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, number};
use super::spigots::Outline;

/// From path to path of a face.
const LINK: f64 = 700.0;

/// What a program has to leave: the height at a place, where that is promised.
struct Case<'a> {
    text: String,
    radius: f64,
    step: f64,
    low: [f64; 2],
    high: [f64; 2],
    /// Height that has to be reached, and the lowest one that may be.
    wanted: Box<dyn Fn([f64; 2]) -> (f64, f64) + 'a>,
    /// Feeds of ways along the tool axis, in the plane.
    feeds: (&'a [f64], &'a [f64]),
}

impl Case<'_> {
    fn judge(&self, shift: f64) -> Result<(), String> {
        let settings = settings("[cycles]\nmulti_edge_start = \"corner\"\n");
        let cuts = track_of("klartext", &self.text, &settings).map_err(|codes| format!("refused: {codes:?}"))?;
        let cell = self.radius / 5.0;
        let mut stock = Stock::new(self.low.map(|v| v - shift * cell), self.high, cell);
        for cut in &cuts {
            let met = stock.cut(cut, self.radius);
            if cut.is_rapid() && met.depth > EXACT {
                return Err(format!("rapid traverse through {:?}: {cut:?}", met.at));
            }
            if !cut.is_vertical() && met.depth > self.step + EXACT {
                return Err(format!("an infeed of {}: {cut:?}", met.depth));
            }
            self.feed(cut)?;
        }
        for (p, top) in stock.columns() {
            let (wanted, least) = (self.wanted)(p);
            if top > wanted + EXACT || top < least - EXACT {
                return Err(format!("the column at {p:?} ends at {top}, not at {wanted} to {least}"));
            }
        }
        if let Some(last) = cuts.last().filter(|last| last.to[2] != 10.0) {
            return Err(format!("ends below the 2nd set-up clearance: {last:?}"));
        }
        Ok(())
    }

    fn feed(&self, cut: &Cut) -> Result<(), String> {
        let known = if cut.is_vertical() { self.feeds.0 } else { self.feeds.1 };
        match cut.feed {
            Some(feed) if !known.contains(&feed) => Err(format!("at the wrong feed: {cut:?}")),
            _ => Ok(()),
        }
    }
}

fn program(radius: f64, at: [f64; 2], calls: &[String]) -> String {
    let mut text = format!("BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{radius}\nTOOL CALL 1 Z S3000\nL Z+50 R0 FMAX M3\n");
    for call in calls {
        text += &format!("CYCL DEF {call}\nL X{:+} Y{:+} R0 FMAX M99\n", at[0], at[1]);
    }
    text + "M30\nEND PGM P MM\n"
}

fn stud(dice: &mut Dice) -> Case<'static> {
    let radius = number(dice, 1.0, 10.0);
    let depth = number(dice, 1.0, 12.0);
    let step = number(dice, depth / 5.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.01, high) };
    // A floor that one cut does not take off is refused.
    let (wall, floor) = (some(dice, 0.5 * radius), some(dice, 0.4 * depth).min(step));
    let kind = dice.roll(3);
    let round = kind != 1;
    let mut half = [number(dice, 1.0, 25.0), number(dice, 1.0, 25.0)];
    if round {
        half[1] = half[0];
    }
    let corner = if round { half[0] } else { number(dice, 0.0, half[0].min(half[1])) };
    let more = number(dice, 0.0, 20.0);
    let corners = 3 + dice.roll(28);
    let raw = if round { [half[0] + more; 2] } else { [half[0] + more, half[1] + number(dice, 0.0, 20.0)] };
    let turn = if round { number(dice, 0.0, 359.0) } else { number(dice, -90.0, 90.0) };
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let climb = if dice.roll(2) == 0 { 1 } else { -1 };
    let overlap = number(dice, 0.3, 1.999);
    let asked: &[u32] = [&[0][..], &[1], &[1, 2]][dice.roll(3)];
    let (sin, cos) = (std::f64::consts::PI / corners as f64).sin_cos();
    let outline = match kind {
        // Its corners lie on the circle.
        2 => {
            let turns = (0..corners).map(|i| std::f64::consts::TAU * i as f64 / corners as f64);
            Outline::Polygon { corners: turns.map(|a| [half[0] * a.cos(), half[0] * a.sin()]).collect() }
        }
        _ => Outline::Rectangle { half, corner },
    };
    let own = if kind == 2 {
        let (through, across) = if sin > 0.4 { (1, 2.0 * half[0]) } else { (0, 2.0 * half[0] * cos) };
        format!("258 NAME Q573={through} Q571={across:.9} Q222={:.4} Q572={corners} Q224={turn} Q220=0", 2.0 * raw[0])
    } else if round {
        format!("257 NAME Q223={:.4} Q222={:.4} Q376={turn}", 2.0 * half[0], 2.0 * raw[0])
    } else {
        format!(
            "256 NAME Q218={:.4} Q424={:.4} Q219={:.4} Q425={:.4} Q220={corner} Q224={turn}",
            2.0 * half[0],
            2.0 * raw[0],
            2.0 * half[1],
            2.0 * raw[1]
        )
    };
    let call = |q215: &u32| {
        // Finishing starts from what roughing left.
        format!(
            "{own} Q215={q215} Q368={wall:.4} Q207={ROUGH} Q351={climb} Q201={:.4} Q202={step:.4} Q206={PLUNGE} Q200=2 Q203=0 Q204=10 Q370={overlap} Q369={floor:.4} Q338=0 Q385={FINISH}",
            -depth
        )
    };
    let text = program(radius, at, &asked.iter().map(call).collect::<Vec<_>>());
    let finishes = asked != [1];
    let left = if finishes { 0.0 } else { wall };
    let ends = if finishes { -depth } else { -depth + floor };
    // The stud and the blank in the turned frame of the stud.
    let (sin, cos) = turn.to_radians().sin_cos();
    let wanted = move |[x, y]: [f64; 2]| {
        let (dx, dy) = (x - at[0], y - at[1]);
        let p = [dx * cos + dy * sin, dy * cos - dx * sin];
        let away = outline.outside(p);
        let in_blank = if round { p[0].hypot(p[1]) < raw[0] } else { p[0].abs() < raw[0] && p[1].abs() < raw[1] };
        if away < left - EXACT {
            (0.0, 0.0)
        } else if away < left + EXACT || !in_blank {
            (0.0, -depth)
        } else {
            (ends, ends)
        }
    };
    let reach = raw[0].hypot(raw[1]) + 1.0;
    let (low, high) = (at.map(|v| v - reach), at.map(|v| v + reach));
    let wanted = Box::new(wanted);
    let step = if finishes { f64::MAX } else { step };
    Case { text, radius, step, low, high, wanted, feeds: (&[PLUNGE], &[ROUGH, FINISH]) }
}

fn face(dice: &mut Dice) -> Case<'static> {
    let radius = number(dice, 2.0, 12.0);
    let depth = number(dice, 1.0, 8.0);
    let step = number(dice, depth / 4.0, depth * 1.2);
    // A floor that one cut does not take off is refused.
    let floor = if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.01, 0.4 * depth).min(step) };
    let size = [0, 1].map(|_| number(dice, 3.0, 80.0) * if dice.roll(2) == 0 { 1.0 } else { -1.0 });
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    // The columns of the blank are wider than a tool that touches it shows.
    let beside = number(dice, 0.0, 5.0);
    let fast = dice.roll(2) == 0 && beside > radius / 2.0;
    let common = format!(
        "Q389={} Q227=0 Q386={:.4} Q218={:.4} Q219={:.4} Q202={step:.4} Q369={floor:.4} Q370={} Q207={ROUGH} Q385={FINISH} Q253={} Q200=2 Q357={} Q204=10",
        dice.roll(3),
        -depth,
        size[0],
        size[1],
        number(dice, 0.3, 1.999),
        if fast { "FMAX".to_owned() } else { LINK.to_string() },
        beside
    );
    let by_call = dice.roll(2) == 0;
    let asked: &[u32] = [&[0][..], &[1], &[1, 2]][if floor > 0.0 { dice.roll(3) } else { dice.roll(2) }];
    // Places of the call that are not the corner from which signed lengths count.
    let placed = if size[0] > 0.0 && size[1] > 0.0 { dice.roll(6) } else { 5 };
    let (text, ends) = if by_call {
        let along = dice.roll(2);
        let position = if placed == 5 { String::new() } else { format!(" Q367={placed}") };
        let calls: Vec<String> =
            asked.iter().map(|q215| format!("233 NAME Q215={q215} Q350={along}{position} {common}")).collect();
        (program(radius, at, &calls), if *asked == [1] { floor - depth } else { -depth })
    } else {
        let own = format!("232 NAME Q225={} Q226={} {common}", at[0], at[1]);
        (program(radius, [0.0; 2], &[own]), -depth)
    };
    let back = [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    let at = if by_call { [0, 1].map(|i| at[i] - back[placed][i] * size[i]) } else { at };
    let low = [0, 1].map(|i| at[i].min(at[i] + size[i]));
    let high = [0, 1].map(|i| at[i].max(at[i] + size[i]));
    let wanted = move |p: [f64; 2]| {
        let inside = (0..2).all(|i| p[i] > low[i] + EXACT && p[i] < high[i] - EXACT);
        if inside { (ends, ends) } else { (0.0, ends) }
    };
    let step = step.max(floor);
    Case { text, radius, step, low, high, wanted: Box::new(wanted), feeds: (&[LINK], &[LINK, ROUGH, FINISH]) }
}

/// Cycles 213 and 215: what stands on the wall is taken in one circuit.
fn finished_stud(dice: &mut Dice) -> Case<'static> {
    let radius = number(dice, 1.0, 10.0);
    let depth = number(dice, 1.0, 12.0);
    let step = number(dice, depth / 5.0, depth * 1.2);
    let more = number(dice, 0.0, 2.0 * radius);
    let round = dice.roll(2) == 0;
    let mut half = [number(dice, 1.0, 25.0), number(dice, 1.0, 25.0)];
    if round {
        half[1] = half[0];
    }
    let corner = if round { half[0] } else { number(dice, 0.0, half[0].min(half[1])) };
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let own = if round {
        format!("215 NAME Q222={:.4} Q223={:.4}", 2.0 * (half[0] + more), 2.0 * half[0])
    } else {
        format!("213 NAME Q218={:.4} Q219={:.4} Q220={corner} Q221={more}", 2.0 * half[0], 2.0 * half[1])
    };
    let own = format!(
        "{own} Q200=2 Q201={:.4} Q206={PLUNGE} Q202={step:.4} Q207={ROUGH} Q203=0 Q204=10 Q216={} Q217={}",
        -depth, at[0], at[1]
    );
    let text = program(radius, [0.0; 2], &[own]);
    let wanted = move |[x, y]: [f64; 2]| {
        let away = beside([x - at[0], y - at[1]], half, corner);
        if away < -EXACT {
            (0.0, 0.0)
        } else if away < EXACT || away > more - EXACT {
            (0.0, -depth)
        } else {
            (-depth, -depth)
        }
    };
    let reach = half[0].hypot(half[1]) + more + 1.0;
    let (low, high) = (at.map(|v| v - reach), at.map(|v| v + reach));
    Case { text, radius, step, low, high, wanted: Box::new(wanted), feeds: (&[PLUNGE], &[ROUGH]) }
}

/// Cycle 230: a face whose paths keep inside of its sides.
fn multipass(dice: &mut Dice) -> Case<'static> {
    let radius = number(dice, 2.0, 12.0);
    let sign = |dice: &mut Dice| if dice.roll(2) == 0 { 1.0 } else { -1.0 };
    let size = [number(dice, 3.0, 80.0) * sign(dice), (2.0 * radius + number(dice, 0.1, 60.0)) * sign(dice)];
    let at = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    // Paths that are at most a diameter apart leave nothing.
    let least = ((size[1].abs() - 2.0 * radius) / (2.0 * radius)).ceil() as usize + 1;
    let cuts = least.max(2) + dice.roll(4);
    let own = format!(
        "230 NAME Q225={} Q226={} Q227=-1.5 Q218={:.4} Q219={:.4} Q240={cuts} Q206={PLUNGE} Q207={ROUGH} Q209={LINK} Q200=11.5",
        at[0], at[1], size[0], size[1]
    );
    let text = program(radius, [0.0; 2], &[own]);
    let low = [0, 1].map(|i| at[i].min(at[i] + size[i]));
    let high = [0, 1].map(|i| at[i].max(at[i] + size[i]));
    // The corners of the face lie inside of the circle of the cutter at the ends of the outer paths.
    let wanted = move |p: [f64; 2]| {
        let inside = (0..2).all(|i| p[i] > low[i] + EXACT && p[i] < high[i] - EXACT);
        let beside = p[1] < low[1] - EXACT || p[1] > high[1] + EXACT;
        if inside {
            (-1.5, -1.5)
        } else if beside {
            (0.0, 0.0)
        } else {
            (0.0, -1.5)
        }
    };
    // The cells reach over the sides, so that a cut beside them shows.
    let over = [low.map(|v| v - 2.0), high.map(|v| v + 2.0)];
    let feeds: (&[f64], &[f64]) = (&[PLUNGE], &[LINK, ROUGH]);
    Case { text, radius, step: 1.5, low: over[0], high: over[1], wanted: Box::new(wanted), feeds }
}

fn judge_many(usual: u64, random: impl Fn(&mut Dice) -> Case<'static>) {
    many("PARTC_POCKETS", usual, |dice, shift| {
        let case = random(dice);
        case.judge(shift).map_err(|why| format!("{why}\n{}", case.text)).map(|()| true)
    });
}

#[test]
fn klartext_studs_at_random() {
    judge_many(100, stud);
}

#[test]
fn klartext_finished_studs_at_random() {
    judge_many(60, finished_stud);
}

#[test]
fn klartext_faces_at_random() {
    judge_many(100, face);
}

#[test]
fn klartext_multipass_at_random() {
    judge_many(100, multipass);
}
