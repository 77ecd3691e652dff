//! Cycles 3 to 5, 210 to 212, 214 and 231, called in all ways, with sizes at random: the properties of docs/cycles.md, column by column.

use std::fmt::Write as _;

use partc::internals::machine::Settings;

use super::super::common::settings;
use super::super::damage::Dice;
use super::klartext_frames::Seen;
use super::klartext_pockets::judge_many;
use super::milling::{EXACT, many, track_of};
use super::pockets::{Case, FINISH, Outline, PLUNGE, ROUGH, Sizes, bow, number, sizes};
use super::regions::P;

/// The start of a program whose tool stands over a place, at its height.
fn begun(c: &Sizes, height: u32, seen: &Seen) -> String {
    let [x, y] = c.at;
    format!(
        "BEGIN PGM P {}\nTOOL DEF 1 L+0 R+{}\nTOOL CALL 1 Z S3000\n{}L X{x:+} Y{y:+} Z+{height} R0 FMAX M3\n",
        seen.word(),
        c.radius,
        seen.text()
    )
}

/// Calls of an old cycle where the tool stands, and at places beside each other: by M99, M89, or CYCL CALL PAT.
fn calls(dice: &mut Dice, at: P, apart: f64) -> (String, Vec<P>) {
    let row = |count: usize| -> Vec<P> { (0..count).map(|i| [at[0] + apart * i as f64, at[1]]).collect() };
    let (kind, count) = (dice.roll(4), 1 + dice.roll(3));
    match kind {
        0 => ("CYCL CALL\n".to_owned(), row(1)),
        1 => {
            let places = row(count);
            (places.iter().map(|[x, y]| format!("L X{x:+.4} Y{y:+.4} FMAX M99\n")).collect(), places)
        }
        2 => {
            let places = row(1 + count);
            let last = places.len() - 1;
            let m = |i: usize| {
                if i == 0 {
                    " M89"
                } else if i == last {
                    " M99"
                } else {
                    ""
                }
            };
            let text = places.iter().enumerate().map(|(i, [x, y])| format!("L X{x:+.4} Y{y:+.4} FMAX{}\n", m(i)));
            (text.collect(), places)
        }
        _ => {
            let places = row(count);
            let list: String =
                places.iter().enumerate().map(|(i, [x, y])| format!(" POS{} (X{x:+.4} Y{y:+.4} Z+0)", i + 1)).collect();
            (format!("PATTERN DEF{list}\nCYCL CALL PAT FMAX\n"), places)
        }
    }
}

/// Calls of a cycle that has a place of its own, wherever the tool is.
fn calls_of_own(dice: &mut Dice) -> &'static str {
    match dice.roll(3) {
        0 => "CYCL CALL\n",
        1 => "L X+3 Y-8 FMAX M99\n",
        _ => "L X-7 Y+8 FMAX M89\nL X+3 Y-8 FMAX M99\n",
    }
}

/// Cycles 3 to 5; the surface lies a set-up clearance of 10 mm below the tool.
fn old_pocket(dice: &mut Dice) -> Case {
    let c = Sizes { wall: 0.0, floor: 0.0, ..sizes(dice) };
    let Sizes { radius, depth, step, at, .. } = c;
    let number_of = 3 + dice.roll(3);
    let turn = if dice.roll(2) == 0 { '+' } else { '-' };
    let half = [0, 1].map(|_| radius + number(dice, 0.0, 4.0 * radius));
    let corner = if dice.roll(3) == 0 { 0.0 } else { number(dice, 0.0, half[0].min(half[1])) };
    let upright = dice.roll(2);
    let axes = if upright == 1 { ['Y', 'X'] } else { ['X', 'Y'] };
    let seen = Seen::random(dice);
    let mut text = begun(&c, 10, &seen);
    let (outline, (_, angle), own) = match number_of {
        3 => {
            let way = number(dice, 0.5, 40.0);
            let sign = if dice.roll(2) == 0 { '+' } else { '-' };
            let angle = 90.0 * upright as f64 + if sign == '-' { 180.0 } else { 0.0 };
            let own = vec![
                format!("{}{sign}{:.4}", axes[0], way + 2.0 * radius),
                format!("{}{:.4}", axes[1], 2.0 * radius),
                format!("F{ROUGH}"),
            ];
            (Outline::Slot { from: 0.0, to: way, half: radius }, (at, angle), own)
        }
        4 => {
            let sides = if upright == 1 { [half[1], half[0]] } else { half };
            let own = vec![
                format!("{}{:.4}", axes[0], 2.0 * sides[0]),
                format!("{}{:.4}", axes[1], 2.0 * sides[1]),
                format!("F{ROUGH} DR{turn} RADIUS {corner}"),
            ];
            (Outline::Rectangle { half, corner: if corner < radius { 0.0 } else { corner } }, (at, 0.0), own)
        }
        _ => {
            let own = vec![format!("RADIUS {:.4}", half[0]), format!("F{ROUGH} DR{turn}")];
            (Outline::Circle { radius: half[0] }, (at, 0.0), own)
        }
    };
    let _ = writeln!(
        text,
        "CYCL DEF {number_of}.0 NAME\nCYCL DEF {number_of}.1 SETUP 10\nCYCL DEF {number_of}.2 DEPTH {:.4}\nCYCL DEF {number_of}.3 PECKG {step:.4} F{PLUNGE}",
        -depth
    );
    for (part, own) in own.iter().enumerate() {
        let _ = writeln!(text, "CYCL DEF {number_of}.{} {own}", part + 4);
    }
    let size = match outline {
        Outline::Slot { to, half, .. } => to + 2.0 * half,
        Outline::Rectangle { half, .. } => 2.0 * half[0].max(half[1]),
        Outline::Circle { radius } => 2.0 * radius,
        Outline::Bow { .. } => 0.0,
    };
    let (calls, places) = calls(dice, at, size + 1.0);
    let _ = write!(text, "{calls}M30\nEND PGM P {}\n", seen.word());
    let home = places.last().copied();
    let places = places.into_iter().map(|at| (at, angle)).collect();
    Case { home, seen, ..Case::of("klartext", text, outline, places, &c) }
}

/// Cycles 210 and 211. A slot that is finished has no other wall than the finished one.
fn strokes(dice: &mut Dice) -> Case {
    let c = Sizes { floor: 0.0, ..sizes(dice) };
    let Sizes { radius, depth, step, at, .. } = c;
    let wall = if dice.roll(4) == 0 { 0.0 } else { number(dice, 0.0, 1.9 * radius) };
    let half = radius + wall;
    let asked: &[u32] = [&[0][..], &[1], &[1, 2]][if wall < 1e-5 { 0 } else { dice.roll(3) }];
    let finishes = wall > 1e-5 && *asked != [1];
    let q338 = if dice.roll(2) == 0 { 0.0 } else { number(dice, depth / 4.0, depth) };
    let (outline, place, own) = if dice.roll(2) == 0 {
        let between = (4.0 * radius - 2.0 * half).max(0.0) + number(dice, 0.5, 40.0);
        let turn = number(dice, -180.0, 180.0);
        let own = format!("Q218={:.4} Q219={:.4} Q224={turn}", between + 2.0 * half, 2.0 * half);
        (Outline::Slot { from: -between / 2.0, to: between / 2.0, half }, (at, turn), own)
    } else {
        let (about, sweep) = bow(dice, half, 360.0);
        let sweep = sweep.max((4.0 * radius / about.to_radians()).ceil());
        let start = number(dice, -180.0, 180.0);
        let own = format!("Q244={:.4} Q219={:.4} Q245={start} Q248={sweep}", 2.0 * about, 2.0 * half);
        (Outline::Bow { radius: about, sweep: sweep.to_radians(), half }, (at, start), own)
    };
    let seen = Seen::random(dice);
    let mut text = begun(&c, 50, &seen);
    let cycle = if matches!(outline, Outline::Slot { .. }) { 210 } else { 211 };
    for q215 in asked {
        let _ = writeln!(
            text,
            "CYCL DEF {cycle} NAME Q200=2 Q201={:.4} Q207={ROUGH} Q202={step:.4} Q215={q215} Q203=0 Q204=10 Q216={} Q217={} {own} Q338={q338:.4} Q206={PLUNGE}",
            -depth, at[0], at[1]
        );
        text += calls_of_own(dice);
    }
    let _ = write!(text, "M30\nEND PGM P {}\n", seen.word());
    let step = if finishes { depth.max(step) } else { step };
    let c = Sizes { wall: if finishes { 0.0 } else { wall }, step, ..c };
    Case { plunges: &[PLUNGE, ROUGH], seen, ..Case::of("klartext", text, outline, vec![place], &c) }
}

/// Cycles 212 and 214: the pocket is there, but for what stands on its wall.
fn finished_wall(dice: &mut Dice) -> Case {
    let c = Sizes { wall: 0.0, floor: 0.0, ..sizes(dice) };
    let Sizes { radius, depth, step, at, .. } = c;
    let more = number(dice, 0.01, 0.6 * radius);
    let half = [0, 1].map(|_| radius + more + number(dice, 0.01, 4.0 * radius));
    let corner = if dice.roll(3) == 0 { 0.0 } else { number(dice, 0.0, half[0].min(half[1])) };
    let (outline, before, own) = if dice.roll(2) == 0 {
        let own = format!("212 NAME Q218={:.4} Q219={:.4} Q220={corner} Q221={more}", 2.0 * half[0], 2.0 * half[1]);
        let corner = if corner < radius { 0.0 } else { corner };
        let there = Outline::Rectangle { half: half.map(|v| v - more), corner: (corner - more).max(radius) };
        (Outline::Rectangle { half, corner }, there, own)
    } else {
        let own = format!("214 NAME Q222={:.4} Q223={:.4}", 2.0 * (half[0] - more), 2.0 * half[0]);
        (Outline::Circle { radius: half[0] }, Outline::Circle { radius: half[0] - more }, own)
    };
    let seen = Seen::random(dice);
    let mut text = begun(&c, 50, &seen);
    let calls = calls_of_own(dice);
    let _ = write!(
        text,
        "CYCL DEF {own} Q200=2 Q201={:.4} Q206={PLUNGE} Q202={step:.4} Q207={FINISH} Q203=0 Q204=10 Q216={} Q217={}\n{calls}M30\nEND PGM P {}\n",
        -depth,
        at[0],
        at[1],
        seen.word()
    );
    let case = Case::of("klartext", text, outline, vec![(at, 0.0)], &c);
    Case { home: Some(at), finish: [true, false], cleared: Some((before, depth)), seen, ..case }
}

/// Cycle 231: the corners of its rows, in order.
fn ruled(dice: &mut Dice) -> Result<(), String> {
    let corners = [0, 1, 2, 3].map(|_| [0, 1, 2].map(|_| number(dice, -40.0, 40.0)));
    let rows = 2 + dice.roll(8);
    let mut own = String::new();
    for (at, value) in corners.iter().flatten().enumerate() {
        let _ = write!(own, " Q{}={value}", 225 + at);
    }
    let text = format!(
        "BEGIN PGM P MM\nTOOL DEF 1 L+0 R+3\nTOOL CALL 1 Z S3000\nL X+0 Y+0 Z+60 R0 FMAX M3\nCYCL DEF 231 NAME{own} Q240={rows} Q207={ROUGH}\nCYCL CALL\nM30\nEND PGM P MM\n"
    );
    let cuts =
        track_of("klartext", &text, &Settings::default()).map_err(|codes| format!("refused: {codes:?}\n{text}"))?;
    let [a, b, c, d] = corners;
    let between = |from: [f64; 3], to: [f64; 3], part: f64| [0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * part);
    let mut wanted = Vec::new();
    for row in 0..rows {
        let part = row as f64 / (rows - 1) as f64;
        let ends = [between(a, d, part), between(b, c, part)];
        wanted.extend(if row % 2 == 0 { ends } else { [ends[1], ends[0]] });
    }
    let highest = corners.iter().map(|corner| corner[2]).fold(f64::MIN, f64::max);
    if let Some(low) =
        cuts.iter().find(|cut| cut.is_rapid() && cut.from[2].min(cut.to[2]) < highest && !cut.is_vertical())
    {
        return Err(format!("rapid traverse below the highest corner: {low:?}\n{text}"));
    }
    let made: Vec<([f64; 3], f64)> = cuts.iter().filter_map(|cut| Some((cut.to, cut.feed?))).collect();
    let feed = |at: usize| if at < 2 { ROUGH / 2.0 } else { ROUGH };
    let same = made.len() == wanted.len()
        && made
            .iter()
            .zip(&wanted)
            .enumerate()
            .all(|(at, ((to, by), wanted))| *by == feed(at) && (0..3).all(|i| (to[i] - wanted[i]).abs() < EXACT));
    let ends = cuts.last().is_some_and(|last| (last.to[2] - highest - 6.0).abs() < EXACT);
    if same && ends { Ok(()) } else { Err(format!("made {made:?}\nnot {wanted:?}\n{text}")) }
}

#[test]
fn klartext_old_pockets_at_random() {
    judge_many(80, &Settings::default(), old_pocket);
}

#[test]
fn klartext_strokes_at_random() {
    judge_many(80, &settings("[cycles]\nq202 = \"stroke\"\n"), strokes);
}

#[test]
fn klartext_finished_walls_at_random() {
    judge_many(60, &Settings::default(), finished_wall);
}

#[test]
fn klartext_ruled_surfaces_at_random() {
    many("PARTC_POCKETS", 60, |dice, _| ruled(dice).map(|()| true));
}
