//! Cycles 21 to 24 along contours of subprograms at random: the properties of docs/cycles.md, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::klartext_frames::Seen;
use super::klartext_pockets::{ANGLE, settings};
use super::milling::{Cut, EXACT, many, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, number};
use super::regions::{COARSE, Case, Land, P, Ring, star};

/// The subprogram of a contour.
fn label(number: usize, ring: &Ring, is_pocket: bool) -> String {
    let mut text = format!("LBL {number}\n");
    let side = |ccw: bool| if ccw == is_pocket { "RL" } else { "RR" };
    match ring {
        Ring::Corners(corners) => {
            let twice: f64 =
                corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
            let _ = writeln!(text, "L X{:+} Y{:+} {}", corners[0][0], corners[0][1], side(twice > 0.0));
            for p in corners.iter().skip(1).chain(corners.first()) {
                let _ = writeln!(text, "L X{:+} Y{:+}", p[0], p[1]);
            }
        }
        Ring::Circle { center: [x, y], radius } => {
            // Small ones one way round, large ones the other.
            let (sense, side) = if *radius > 6.0 { ("DR+", side(true)) } else { ("DR-", side(false)) };
            let at = x + radius;
            let _ = writeln!(text, "CC X{x:+} Y{y:+}\nL X{at:+.4} Y{y:+} {side}\nC X{at:+.4} Y{y:+} {sense}");
        }
    }
    text + "LBL 0\n"
}

/// A pocket, further ones that may cross it, and islands that may cross them.
fn land(dice: &mut Dice) -> Land {
    let first = match dice.roll(6) {
        0 => {
            Ring::Circle { center: [number(dice, -5.0, 5.0), number(dice, -5.0, 5.0)], radius: number(dice, 8.0, 40.0) }
        }
        _ => Ring::Corners(star(dice)),
    };
    let mut land = Land::new(vec![first], 1);
    let (pockets, islands) = ([0, 0, 1, 2][dice.roll(4)], dice.roll(4));
    for at in 0..pockets + islands {
        let is_pocket = at < pockets;
        let far = if is_pocket { 40.0 } else { 28.0 };
        let center = [number(dice, -far, far), number(dice, -far, far)];
        let size = if is_pocket { number(dice, 6.0, 20.0) } else { number(dice, 1.0, 9.0) };
        let ring = match dice.roll(2) {
            0 => Ring::Circle { center, radius: size },
            _ => {
                let (turn, count) = (number(dice, 0.0, 90.0), 3 + dice.roll(3));
                let round = |v: f64| (v * 1000.0).round() / 1000.0;
                let corner = |i: usize| {
                    let (sin, cos) = (turn + 360.0 / count as f64 * i as f64).to_radians().sin_cos();
                    [round(center[0] + size * cos), round(center[1] + size * sin)]
                };
                Ring::Corners((0..count).map(corner).collect())
            }
        };
        if land.takes(&ring, is_pocket) {
            let pockets = land.pockets + usize::from(is_pocket);
            let mut rings = land.rings;
            rings.push(ring);
            land = Land::new(rings, pockets);
        }
    }
    land
}

struct Made {
    case: Case,
    /// The same pocket, with its pilot holes only.
    pilot: String,
    /// Its first level only.
    first: String,
}

/// A block or two that call the cycle, once or twice over.
fn call(dice: &mut Dice, again: bool) -> &'static str {
    match dice.roll(if again { 4 } else { 3 }) {
        0 => "L X+7 Y+3 R0 FMAX\nCYCL CALL\n",
        1 => "CYCL CALL\n",
        2 => "L X+7 Y+3 R0 FMAX M99\n",
        _ => "L X-9 Y+3 R0 FMAX M89\nL X+7 Y+3 R0 FMAX M99\n",
    }
}

/// A cycle 22: infeed, feed, coarse tool, and the feed of strokes to and fro.
struct Rough {
    step: f64,
    feed: f64,
    before: u32,
    swaying: f64,
}

impl Rough {
    fn text(&self, dice: &mut Dice) -> String {
        let Rough { step, feed, before, swaying } = self;
        // The second call would ask for a coarse tool directly in front of it.
        let call = call(dice, *before == 0);
        format!("CYCL DEF 22 ROUGH Q10={step} Q11={PLUNGE} Q12={feed} Q18={before} Q19={swaying}\n{call}")
    }
}

fn random(dice: &mut Dice) -> Made {
    let radius = number(dice, 1.5, 5.0);
    let depth = number(dice, 1.0, 8.0);
    let step = number(dice, depth / 3.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.01, high) };
    let (wall, floor) = (some(dice, 0.4 * radius), some(dice, 0.3 * depth));
    let land = land(dice);
    let corners = if dice.roll(3) == 0 { number(dice, 0.1, 2.0) } else { 0.0 };
    // An arc stays as it is, so that a cutter may reach more next to it.
    let corners = if land.rings.iter().any(|ring| matches!(ring, Ring::Circle { .. })) { 0.0 } else { corners };
    // Pockets keep their order; islands stand anywhere between them.
    let mut order: Vec<usize> = (0..land.pockets).collect();
    for island in land.pockets..land.rings.len() {
        order.insert(dice.roll(order.len() + 1), island);
    }
    let named: String = order.iter().map(|at| format!(" /{}", at + 1)).collect();
    let overlap = number(dice, 0.4, 1.999);
    let climb = if dice.roll(2) == 0 { "+1" } else { "-1" };
    let round = |v: f64| (v * 1000.0).round() / 1000.0;
    let larger = |dice: &mut Dice, than: f64| round(than + number(dice, 0.05, 0.8 * radius));
    // One or two cutters before, each smaller than the one before it.
    let coarse: Vec<f64> = match dice.roll(6) {
        0 | 1 => vec![larger(dice, radius)],
        2 => {
            let second = larger(dice, radius);
            vec![larger(dice, second), second]
        }
        _ => Vec::new(),
    };
    let reciprocating = if dice.roll(4) == 0 { PLUNGE } else { 0.0 };
    let seen = Seen::random(dice);
    let (unit, system) = (seen.word(), seen.text());
    let tools: String = coarse.iter().enumerate().map(|(at, by)| format!("TOOL DEF {} L+0 R+{by}\n", at + 2)).collect();
    let data = format!(
        "CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL{named}\n\
         CYCL DEF 20 DATA Q1={} Q2={overlap} Q3={wall} Q4={floor} Q5=+0 Q6=+2 Q7=+10 Q8={corners} Q9={climb}\n",
        -depth
    );
    // The system counts where a cycle runs.
    let data = if dice.roll(2) == 0 { data + &system } else { system + &data };
    let head = format!(
        "BEGIN PGM P {unit}\nTOOL DEF 1 L+0 R+{radius}\n{tools}TOOL CALL 1 Z S3000\n\
         L X+7 Y+3 Z+50 R0 FMAX M3\n{data}"
    );
    let labels: String =
        land.rings.iter().enumerate().map(|(at, ring)| label(at + 1, ring, at < land.pockets)).collect();
    let tail = format!("M30\n{labels}END PGM P {unit}\n");
    let mut text = head.clone();
    let mut before = 0;
    for (at, feed) in (0..coarse.len()).zip(COARSE) {
        let number = at as u32 + 2;
        let with_it = Rough { step, feed, before, swaying: 0.0 }.text(dice);
        let _ = write!(text, "TOOL CALL {number} Z S3000\nM3\n{with_it}L Z+50 R0 FMAX\n");
        before = number;
    }
    if before > 0 {
        text += "TOOL CALL 1 Z S3000\nM3\n";
    }
    text += &Rough { step, feed: ROUGH, before, swaying: reciprocating }.text(dice);
    let left = if wall > 0.02 && dice.roll(2) == 0 { number(dice, 0.0, 0.8 * wall) } else { 0.0 };
    let finish = [wall > left && dice.roll(2) == 0, dice.roll(2) == 0];
    if finish[1] {
        let _ = write!(text, "CYCL DEF 23 FLOOR Q11={PLUNGE} Q12={FINISH}\n{}", call(dice, true));
    }
    if finish[0] {
        let infeed = number(dice, depth / 3.0, depth * 1.2);
        let climb = if dice.roll(2) == 0 { "+1" } else { "-1" };
        let call = call(dice, true);
        let _ = write!(text, "CYCL DEF 24 SIDE Q9={climb} Q10={infeed} Q11={PLUNGE} Q12={FINISH} Q14={left}\n{call}");
    }
    text += &tail;
    let pilot = format!("{head}CYCL DEF 21 PILOT Q10={step} Q11={PLUNGE} Q13=1\n{}{tail}", call(dice, false));
    let whole = Rough { step: 2.0 * depth, feed: ROUGH, before: 0, swaying: 0.0 }.text(dice);
    let first = format!("{head}{whole}{tail}");
    let case = Case {
        language: "klartext",
        text,
        land,
        radius,
        depth,
        step,
        wall,
        floor,
        finish,
        left: if finish[0] { left } else { 0.0 },
        corners,
        coarse,
        angle: (reciprocating > 0.0).then_some(ANGLE),
        settings: settings(),
        seen,
    };
    Made { case, pilot, first }
}

impl Made {
    fn track(&self, text: &str) -> Result<Vec<Cut>, String> {
        let cuts = track_of("klartext", text, &Settings::default());
        cuts.map(|cuts| self.case.seen.programmed(cuts)).map_err(|codes| format!("refused: {codes:?}\n{text}"))
    }

    /// The pilot holes are where the tool goes down.
    fn pilots(&self) -> Result<(), String> {
        let floor = self.case.floor - self.case.depth;
        let drilled = self.track(&self.pilot)?;
        self.pecks(&drilled, floor).map_err(|why| format!("{why}\n{}", self.pilot))?;
        if (floor + 2.0).abs() < EXACT {
            // Over cleared ground the tool comes down from the surface, too.
            return Ok(());
        }
        // Into material the tool goes from the surface, or from the set-up clearance; from lower down it goes over cleared ground.
        let solid = |z: f64| z.abs() < EXACT || z > 2.0 - EXACT;
        let at = |cuts: &[Cut], drills: bool| -> Vec<P> {
            let down = cuts.iter().filter(|cut| {
                let arrives = (cut.to[2] - floor).abs() < EXACT && cut.from[2] > floor + EXACT;
                cut.is_vertical() && !cut.is_rapid() && arrives && (drills || solid(cut.from[2]))
            });
            down.map(|cut| [cut.to[0], cut.to[1]]).collect()
        };
        let milled = self.track(&self.first)?;
        let (holes, mut plunges) = (at(&drilled, true), at(&milled, false));
        // A second call mills air, and goes down at the same places.
        plunges.truncate(if plunges.len() == 2 * holes.len() { holes.len() } else { plunges.len() });
        let same = |(p, q): (&P, &P)| (p[0] - q[0]).abs() < EXACT && (p[1] - q[1]).abs() < EXACT;
        if holes.is_empty() || holes.len() != plunges.len() || !holes.iter().zip(&plunges).all(same) {
            return Err(format!("holes at {holes:?}, down at {plunges:?}\n{}", self.pilot));
        }
        Ok(())
    }

    /// Steps, stop distances and ends of the pilot holes, and their distance from the walls.
    fn pecks(&self, cuts: &[Cut], floor: f64) -> Result<(), String> {
        let case = &self.case;
        let deep = -floor * case.seen.unit;
        let ahead = if deep > 30.0 { (deep / 50.0).min(7.0) } else { 0.6 } / case.seen.unit;
        let mut bottom: Option<f64> = None;
        for cut in cuts {
            let lowest = cut.from[2].min(cut.to[2]);
            if !cut.is_vertical() {
                if lowest < 2.0 - EXACT || !cut.is_rapid() {
                    return Err(format!("between the holes: {cut:?}"));
                }
                if bottom.is_some_and(|bottom| bottom > floor + EXACT) {
                    return Err(format!("a hole ends at {bottom:?}, not at {floor}"));
                }
                bottom = None;
            } else if let Some(feed) = cut.feed {
                let from = bottom.map_or(2.0, |bottom| (bottom + ahead).min(2.0));
                let step = bottom.unwrap_or(0.0) - cut.to[2];
                let right = feed == PLUNGE && (cut.from[2] - from).abs() < EXACT && cut.to[2] > floor - EXACT;
                if !right || step < EXACT || step > case.step + EXACT {
                    return Err(format!("a step of {step} from {from}: {cut:?}"));
                }
                bottom = Some(cut.to[2]);
                let room = case.room([cut.to[0], cut.to[1]]);
                if room < case.radius + case.wall - EXACT {
                    return Err(format!("a hole {room} beside the wall: {cut:?}"));
                }
            } else if bottom.is_some_and(|bottom| lowest < bottom + ahead.min(2.0 - bottom) - EXACT)
                && cut.to[2] < cut.from[2]
            {
                return Err(format!("rapid traverse too deep: {cut:?}"));
            }
        }
        match cuts.last() {
            Some(last) if last.to[2] == 10.0 && bottom.is_some_and(|bottom| (bottom - floor).abs() < EXACT) => Ok(()),
            last => Err(format!("ends at {last:?} behind {bottom:?}")),
        }
    }
}

#[test]
fn contours_of_labels_at_random_keep_the_properties_of_cycles() {
    many("PARTC_LABELS", 12, |dice, shift| {
        let made = random(dice);
        let case = &made.case;
        let done = case.judge(shift).map_err(|why| format!("{why}\n{}{case:?}", case.text))?;
        if done {
            made.pilots()?;
        }
        Ok(done)
    });
}
