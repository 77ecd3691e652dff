//! Cycles 208, 262 to 265 and 267 with sizes at random: wall and depth, pitch and hand, rapid traverse, and where they end.

use std::f64::consts::TAU;

use partc::internals::machine::Settings;

use super::super::common;
use super::super::damage::Dice;
use super::milling::{Cut, EXACT, Stock, track_of};
use super::pockets::number;

/// Depth of an inside thread in pitches (ISO 68-1).
const IN_HOLE: f64 = 0.541_266;
/// And of an outside one.
const ON_STUD: f64 = 0.613_435;
/// What the printed decimals of a program may lose, mm.
const LOST: f64 = 1e-4;

fn far(p: [f64; 3]) -> f64 {
    p[0].hypot(p[1])
}

/// Farthest and nearest from the axis on the way.
fn reach(cut: &Cut) -> (f64, f64) {
    let steps = if cut.is_vertical() { 1 } else { 48 };
    let points = (0..=steps).map(|i| far(cut.at(f64::from(i) / f64::from(steps))));
    points.fold((0.0, f64::MAX), |(most, least), v| (f64::max(most, v), f64::min(least, v)))
}

fn lowest(cut: &Cut) -> f64 {
    cut.from[2].min(cut.to[2])
}

/// Turns about the axis; none where the move is no circle about it.
fn turns(cut: &Cut) -> Option<f64> {
    let ([x, y], sweep) = cut.arc?;
    (x.hypot(y) < LOST).then_some(sweep / TAU)
}

fn program(radius: f64, cycle: &str) -> String {
    format!(
        "BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{radius:.4}\nTOOL CALL 1 Z S3000\nL X+0 Y+0 Z+50 R0 FMAX M3\n{cycle}\nCYCL CALL\nL X+300 FMAX\nEND PGM P MM\n"
    )
}

/// The moves of the cycle alone.
fn moves(text: &str, settings: &Settings) -> Result<Vec<Cut>, String> {
    let mut cuts = track_of("klartext", text, settings).map_err(|codes| format!("refused: {codes:?}"))?;
    cuts.pop();
    Ok(cuts)
}

/// A hole that is open down to a depth.
fn drilled(stock: &mut Stock, radius: f64, depth: f64) {
    let at = |z: f64| [0.0, 0.0, z];
    stock.cut(&Cut { from: at(1.0), to: at(-depth), arc: None, feed: Some(1.0) }, radius);
}

fn rapid_is_free(stock: &mut Stock, cuts: &[Cut], radius: f64) -> Result<(), String> {
    for cut in cuts {
        let met = stock.cut(cut, radius);
        if cut.is_rapid() && met.depth > EXACT {
            return Err(format!("rapid traverse through {:?}: {cut:?}", met.at));
        }
    }
    Ok(())
}

fn ends_at(cuts: &[Cut], x: f64) -> Result<(), String> {
    let last = cuts.last().map(|last| last.to).ok_or("no moves")?;
    let gap = (last[0] - x).abs().max(last[1].abs()).max((last[2] - 50.0).abs());
    if gap < LOST { Ok(()) } else { Err(format!("ends at {last:?}")) }
}

fn bore(dice: &mut Dice) -> (String, Result<(), String>) {
    let radius = number(dice, 1.0, 10.0);
    let depth = number(dice, 0.5, 15.0);
    let pitch = number(dice, depth / 12.0, depth * 2.0);
    let large = dice.roll(3) == 0;
    let size = radius + if large { number(dice, 1.1 * radius, 3.0 * radius) } else { number(dice, 0.05, radius) };
    let open = if large { number(dice, 0.2 * size, 0.9 * size) } else { 0.0 };
    let overlap = if large && dice.roll(2) == 0 { number(dice, 0.3, 1.999) } else { 0.0 };
    let climb = if dice.roll(2) == 0 { 1 } else { -1 };
    let (entry, from) = (["arc", "line"][dice.roll(2)], ["clearance", "surface"][dice.roll(2)]);
    let settings = common::settings(&format!(
        "[cycles]\ncycle_208_rings = true\ncycle_entry = \"{entry}\"\nhelix_from = \"{from}\"\n"
    ));
    let overlapped = if overlap > 0.0 { format!(" Q370={overlap}") } else { String::new() };
    let text = program(
        radius,
        &format!(
            "CYCL DEF 208 BORE Q200=2 Q201={:.4} Q206=150 Q334={pitch:.4} Q203=0 Q204=50 Q335={:.4} Q342={:.4} Q351={climb}{overlapped}",
            -depth,
            2.0 * size,
            2.0 * open
        ),
    );
    let judge = || {
        let cuts = moves(&text, &settings)?;
        let extent = size + 2.0;
        let mut stock = Stock::new([-extent; 2], [extent; 2], (radius / 5.0).max(0.2));
        drilled(&mut stock, open, depth);
        let mut round = 0.0;
        for cut in &cuts {
            if lowest(cut) < 0.0 && reach(cut).0 + radius > size + LOST {
                return Err(format!("gouges the wall: {cut:?}"));
            }
            if lowest(cut) < -depth - EXACT {
                return Err(format!("gouges the floor: {cut:?}"));
            }
            if let Some(turns) = turns(cut) {
                let fall = cut.from[2] - cut.to[2];
                if fall > EXACT && (fall / turns.abs() - pitch).abs() > 0.01 * pitch {
                    return Err(format!("falls {} in a turn of {pitch}: {cut:?}", fall / turns.abs()));
                }
                if fall.abs() < EXACT && (far(cut.to) + radius - size).abs() < LOST && (cut.to[2] + depth).abs() < EXACT
                {
                    round += turns;
                }
                if turns.signum() != f64::from(climb) {
                    return Err(format!("turns the wrong way: {cut:?}"));
                }
            }
        }
        if (round.abs() - 1.0).abs() > 1e-6 {
            return Err(format!("{round} turns at the depth"));
        }
        rapid_is_free(&mut stock, &cuts, radius)?;
        for (p, top) in stock.columns() {
            let at = p[0].hypot(p[1]);
            if at < size - LOST && top > -depth + EXACT || at > size + LOST && top < 0.0 {
                return Err(format!("the column at {p:?} ends at {top}"));
            }
        }
        ends_at(&cuts, 0.0)
    };
    let made = judge();
    (text, made)
}

#[derive(Clone, Copy)]
struct Thread {
    radius: f64,
    nominal: f64,
    pitch: f64,
    depth: f64,
    left: bool,
    steps: usize,
}

fn thread(dice: &mut Dice) -> Thread {
    let nominal = number(dice, 2.0, 20.0);
    let pitch = number(dice, 0.1 * nominal, 0.35 * nominal).min(4.0);
    let core = nominal - IN_HOLE * pitch;
    Thread {
        radius: number(dice, 0.35 * core, 0.97 * core),
        nominal,
        pitch,
        depth: number(dice, 0.6 * pitch, 8.0 * pitch),
        left: dice.roll(2) == 0,
        steps: dice.roll(4),
    }
}

/// The helices have the pitch and the hand, lie on the radius, and begin or end where they have to.
fn threads(cuts: &[Cut], t: &Thread, on: f64, down: bool, once: bool) -> Result<(), String> {
    let mut found = Vec::new();
    for cut in cuts {
        let Some(turns) =
            turns(cut).filter(|_| (far(cut.to) - on).abs() < LOST && (cut.to[2] - cut.from[2]).abs() > EXACT)
        else {
            continue;
        };
        let rise = cut.to[2] - cut.from[2];
        let hand = if t.left { -t.pitch } else { t.pitch };
        if (rise / turns - hand).abs() > 1e-6 {
            return Err(format!("rises {} in a turn of {hand}: {cut:?}", rise / turns));
        }
        if (rise < 0.0) != down {
            return Err(format!("works the wrong way: {cut:?}"));
        }
        found.push((lowest(cut), turns.abs()));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let whole = |v: f64| (v - 1e-9).ceil();
    let wanted: Vec<(f64, f64)> = match t.steps {
        _ if once => vec![(-t.depth, 1.0)],
        0 => vec![(-t.depth, 1.0)],
        1 => vec![(-t.depth, whole(t.depth / t.pitch))],
        m => {
            let strip = t.pitch * m as f64;
            (0..whole(t.depth / strip) as u32).map(|i| (-t.depth + f64::from(i) * strip, 1.0)).collect()
        }
    };
    let same = found.len() == wanted.len()
        && found.iter().zip(&wanted).all(|(a, b)| (a.0 - b.0).abs() < LOST && (a.1 - b.1).abs() < 1e-6);
    if same { Ok(()) } else { Err(format!("made {found:?}, wanted {wanted:?}")) }
}

fn inside(dice: &mut Dice) -> (String, Result<(), String>) {
    let mut t = thread(dice);
    let cycle = [262, 263, 264, 265][dice.roll(4)];
    let climb = if dice.roll(2) == 0 { 1 } else { -1 };
    let room = number(dice, 0.34 * t.pitch, 1.5 * t.pitch);
    let (sink, circle) = (number(dice, 0.1, 1.5).min(t.depth), number(dice, 0.1, 0.5));
    let core = t.nominal - IN_HOLE * t.pitch;
    if cycle == 265 {
        t.radius = (t.radius.max(0.51 * t.nominal).min(0.98 * core) * 1e3).round() / 1e3;
        t.steps = 1;
    }
    let signed = if t.left { -t.pitch } else { t.pitch };
    let all = format!(
        "Q335={:.4} Q239={signed:.4} Q201={:.4} Q253={} Q200=2 Q203=0 Q204=50 Q207=500",
        2.0 * t.nominal,
        -t.depth,
        // The hole of cycle 264 is as wide as the tool.
        if dice.roll(3) == 0 && cycle != 264 { "FMAX" } else { "750" }
    );
    let front = format!("Q358={:.4} Q359={circle:.4}", -sink);
    let total = format!("Q356={:.4}", -t.depth - room);
    let own = match cycle {
        262 => format!("Q355={} Q351={climb}", t.steps),
        263 => format!("{total} Q357=0.2 {front} Q254=200 Q351={climb}"),
        264 => format!("{total} Q202=3 Q258=0.5 Q257=0 Q256=0.2 {front} Q206=150 Q351={climb}"),
        _ => format!("{front} Q360={} Q254=200", dice.roll(2)),
    };
    let text = program(t.radius, &format!("CYCL DEF {cycle} THREAD {all} {own}"));
    let settings = Settings::default();
    let judge = || {
        let cuts = moves(&text, &settings)?;
        let down = if cycle == 265 { true } else { (climb > 0) == t.left };
        let on = t.nominal - t.radius;
        threads(&cuts, &t, on, down, cycle == 263 || cycle == 264)?;
        let floor = match cycle {
            262 => t.depth + t.pitch / 2.0,
            265 => t.depth,
            _ => t.depth + room,
        };
        for cut in &cuts {
            // A countersink may be wider than the thread.
            let wall =
                if lowest(cut) > -sink - EXACT && cycle != 262 { t.nominal.max(circle + t.radius) } else { t.nominal };
            if lowest(cut) < 0.0 && reach(cut).0 + t.radius > wall + LOST {
                return Err(format!("gouges the wall: {cut:?}"));
            }
            if lowest(cut) < -floor - LOST {
                return Err(format!("goes below {floor}: {cut:?}"));
            }
        }
        let extent = t.nominal + 2.0;
        let mut stock = Stock::new([-extent; 2], [extent; 2], (t.radius / 4.0).max(0.2));
        if cycle == 262 || cycle == 263 {
            drilled(&mut stock, core, floor);
        }
        rapid_is_free(&mut stock, &cuts, t.radius)?;
        ends_at(&cuts, 0.0)
    };
    let made = judge();
    (text, made)
}

fn outside(dice: &mut Dice) -> (String, Result<(), String>) {
    let mut t = thread(dice);
    t.radius = number(dice, 1.0, 10.0);
    let climb = if dice.roll(2) == 0 { 1 } else { -1 };
    let core = dice.roll(2) == 0;
    let clearance = number(dice, 0.0, 5.0);
    let settings = common::settings(&format!("[cycles]\nthread_267 = \"{}\"\n", if core { "core" } else { "nominal" }));
    let signed = if t.left { -t.pitch } else { t.pitch };
    let text = program(
        t.radius,
        &format!(
            "CYCL DEF 267 THREAD Q335={:.4} Q239={signed:.4} Q201={:.4} Q355={} Q253=750 Q351={climb} Q200={clearance:.4} Q358=0 Q359=0 Q203=0 Q204=50 Q254=200 Q207=500",
            2.0 * t.nominal,
            -t.depth,
            t.steps
        ),
    );
    let judge = || {
        let cuts = moves(&text, &settings)?;
        let touched = if core { t.nominal - ON_STUD * t.pitch } else { t.nominal };
        // The other way round than in a hole.
        threads(&cuts, &t, touched + t.radius, (climb > 0) != t.left, false)?;
        for cut in &cuts {
            let near = if cut.is_rapid() { t.nominal } else { touched };
            if lowest(cut) < -EXACT && reach(cut).1 - t.radius < near - LOST {
                return Err(format!("gouges the stud: {cut:?}"));
            }
            if lowest(cut) < -t.depth - t.pitch / 2.0 - LOST {
                return Err(format!("goes too deep: {cut:?}"));
            }
        }
        ends_at(&cuts, t.nominal + t.radius + clearance.max(t.pitch))
    };
    let made = judge();
    (text, made)
}

/// Many cases at random; their number by an environment variable.
fn judge_many(variable: &str, usual: u64, case: impl Fn(&mut Dice) -> (String, Result<(), String>)) {
    let from = |name: &str, usual: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual);
    let (count, seed) = (from(variable, usual), from("PARTC_BORES_SEED", 1));
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut bad = Vec::new();
    for _ in 0..count {
        let (text, made) = case(&mut dice);
        if let Err(why) = made {
            bad.push(format!("{why}\n{text}"));
        }
    }
    bad.sort_by_key(String::len);
    assert!(bad.is_empty(), "{} of {count} fail, such as\n{}", bad.len(), bad[..bad.len().min(4)].join("\n\n"));
}

#[test]
fn klartext_bores_at_random() {
    judge_many("PARTC_BORES", 60, bore);
}

#[test]
fn klartext_threads_in_holes_at_random() {
    judge_many("PARTC_THREADS", 80, inside);
}

#[test]
fn klartext_threads_on_studs_at_random() {
    judge_many("PARTC_THREADS", 60, outside);
}
