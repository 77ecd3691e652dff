//! Cycles 21 to 24 along contours of subprograms at random: the properties of docs/cycles.md, column by column.

use std::fmt::Write as _;

use partc::Settings;

use super::super::damage::Dice;
use super::milling::{EXACT, many, track_of};
use super::pockets::{FINISH, PLUNGE, ROUGH, number};
use super::regions::{Case, P, Ring, star};

/// The subprogram of the contour of a pocket.
fn label(ring: &Ring) -> String {
    let mut text = "LBL 1\n".to_owned();
    match ring {
        Ring::Corners(corners) => {
            let twice: f64 =
                corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
            for (at, p) in corners.iter().chain(corners.first()).enumerate() {
                let side = if at > 0 {
                    ""
                } else if twice > 0.0 {
                    " RL"
                } else {
                    " RR"
                };
                let _ = writeln!(text, "L X{:+} Y{:+}{side}", p[0], p[1]);
            }
        }
        Ring::Circle { center: [x, y], radius } => {
            let _ =
                writeln!(text, "CC X{x:+} Y{y:+}\nL X{:+.4} Y{y:+} RL\nC X{:+.4} Y{y:+} DR+", x + radius, x + radius);
        }
    }
    text + "LBL 0\n"
}

struct Made {
    case: Case,
    /// The same pocket, with its pilot holes only.
    pilot: String,
    /// Its first level only.
    first: String,
}

fn random(dice: &mut Dice) -> Made {
    let radius = number(dice, 1.5, 5.0);
    let depth = number(dice, 1.0, 8.0);
    let step = number(dice, depth / 3.0, depth * 1.2);
    let some = |dice: &mut Dice, high: f64| if dice.roll(2) == 0 { 0.0 } else { number(dice, 0.01, high) };
    let (wall, floor) = (some(dice, 0.4 * radius), some(dice, 0.3 * depth));
    let ring = match dice.roll(6) {
        0 => {
            Ring::Circle { center: [number(dice, -5.0, 5.0), number(dice, -5.0, 5.0)], radius: number(dice, 8.0, 40.0) }
        }
        _ => Ring::Corners(star(dice)),
    };
    let corners = if dice.roll(3) == 0 { number(dice, 0.1, 2.0) } else { 0.0 };
    let corners = if matches!(ring, Ring::Circle { .. }) { 0.0 } else { corners };
    let overlap = number(dice, 0.4, 1.999);
    let climb = if dice.roll(2) == 0 { "+1" } else { "-1" };
    let head = format!(
        "BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{radius}\nTOOL CALL 1 Z S3000\nL X+7 Y+3 Z+50 R0 FMAX M3\n\
         CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL 1\n\
         CYCL DEF 20 DATA Q1={} Q2={overlap} Q3={wall} Q4={floor} Q5=+0 Q6=+2 Q7=+10 Q8={corners} Q9={climb}\n",
        -depth
    );
    let tail = format!("M30\n{}END PGM P MM\n", label(&ring));
    let rough = |step: f64| {
        format!("CYCL DEF 22 ROUGH Q10={step} Q11={PLUNGE} Q12={ROUGH} Q18=+0 Q19=+0\nL X+7 Y+3 R0 FMAX\nCYCL CALL\n")
    };
    let mut text = head.clone() + &rough(step);
    let left = if wall > 0.02 && dice.roll(2) == 0 { number(dice, 0.0, 0.8 * wall) } else { 0.0 };
    let finish = [wall > left && dice.roll(2) == 0, dice.roll(2) == 0];
    if finish[1] {
        let _ = writeln!(text, "CYCL DEF 23 FLOOR Q11={PLUNGE} Q12={FINISH}\nCYCL CALL");
    }
    if finish[0] {
        let infeed = number(dice, depth / 3.0, depth * 1.2);
        let climb = if dice.roll(2) == 0 { "+1" } else { "-1" };
        let _ =
            writeln!(text, "CYCL DEF 24 SIDE Q9={climb} Q10={infeed} Q11={PLUNGE} Q12={FINISH} Q14={left}\nCYCL CALL");
    }
    text += &tail;
    let drill = format!("CYCL DEF 21 PILOT Q10={step} Q11={PLUNGE} Q13=1\nCYCL CALL\n");
    let pilot = format!("{head}{drill}{tail}");
    let first = format!("{head}{}{tail}", rough(2.0 * depth));
    let case = Case {
        language: "klartext",
        text,
        rings: vec![ring],
        radius,
        depth,
        step,
        wall,
        floor,
        finish,
        left: if finish[0] { left } else { 0.0 },
        corners,
    };
    Made { case, pilot, first }
}

impl Made {
    /// The pilot holes are where the tool goes down.
    fn pilots(&self) -> Result<(), String> {
        let settings = Settings::default();
        let track =
            |text: &str| track_of("klartext", text, &settings).map_err(|codes| format!("refused: {codes:?}\n{text}"));
        let floor = -self.case.depth + self.case.floor;
        let at = |text: &str| -> Result<Vec<P>, String> {
            let cuts = track(text)?;
            let down = cuts.iter().filter(|cut| {
                cut.is_vertical() && !cut.is_rapid() && (cut.to[2] - floor).abs() < EXACT && cut.from[2] > floor + EXACT
            });
            Ok(down.map(|cut| [cut.to[0], cut.to[1]]).collect())
        };
        let (holes, plunges) = (at(&self.pilot)?, at(&self.first)?);
        if holes.is_empty() || holes != plunges {
            return Err(format!("holes at {holes:?}, down at {plunges:?}\n{}", self.pilot));
        }
        Ok(())
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
