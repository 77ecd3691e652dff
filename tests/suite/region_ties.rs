//! The last bit of a coordinate decides nothing: pockets along contours whose coordinates are written as numbers, or come from formulas that
//! give the same number but for rounding, print the same bytes.

use std::fmt::Write as _;

use partc::files::NoFiles;
use partc::{Program, Settings, compile};

use super::common;
use super::damage::Dice;

/// Seeds of a run; `PARTC_TIES` asks for more.
const SEEDS: u64 = 240;

type P = [f64; 2];

/// A closed polygon, or a circle.
enum Ring {
    Corners(Vec<P>),
    Circle(P, f64),
}

fn number(dice: &mut Dice, low: f64, high: f64) -> f64 {
    let part = dice.roll(100_000) as f64 / 100_000.0;
    ((low + (high - low) * part) * 1000.0).round() / 1000.0
}

/// A pocket, mostly with symmetries, whose places are equal so often; and islands in it.
fn rings(dice: &mut Dice) -> Vec<Ring> {
    let (w, h) = (number(dice, 24.0, 34.0), number(dice, 20.0, 30.0));
    let box_of = |w: f64, h: f64| vec![[-w, -h], [w, -h], [w, h], [-w, h]];
    let around = |at: P, by: f64, count: usize, turn: f64| -> Vec<P> {
        let corner = |i: usize| {
            let (sin, cos) = (turn + 360.0 / count as f64 * i as f64).to_radians().sin_cos();
            [at[0] + by * cos, at[1] + by * sin].map(|v| (v * 1000.0).round() / 1000.0)
        };
        (0..count).map(corner).collect()
    };
    let pocket = match dice.roll(5) {
        0 => Ring::Corners(box_of(w, h)),
        1 => Ring::Corners(box_of(w, w)),
        2 => Ring::Circle([number(dice, -5.0, 5.0), 0.0], w),
        3 => Ring::Corners(around([0.0, 0.0], w, 3 + dice.roll(6), number(dice, 0.0, 90.0))),
        _ => Ring::Corners(vec![[-w, -h], [w, -h], [w, 0.0], [0.0, 0.0], [0.0, h], [-w, h]]),
    };
    let island = |dice: &mut Dice, at: P| match dice.roll(3) {
        0 => Ring::Circle(at, number(dice, 1.0, 2.5)),
        1 => Ring::Corners(box_of(2.0, 1.5).iter().map(|p| [at[0] + p[0], at[1] + p[1]]).collect()),
        _ => Ring::Corners(around(at, 2.0, 3 + dice.roll(3), number(dice, 0.0, 90.0))),
    };
    let places: &[P] = match dice.roll(3) {
        0 => &[],
        1 => &[[-7.0, -6.0]],
        _ => &[[-8.0, -5.0], [5.5, -5.0]],
    };
    core::iter::once(pocket).chain(places.iter().map(|at| island(dice, *at))).collect()
}

/// How a number is written.
trait Words {
    fn number(&mut self, value: f64) -> String;
}

struct Plain;

impl Words for Plain {
    fn number(&mut self, value: f64) -> String {
        format!("{value:+.4}")
    }
}

/// Formulas whose last bits are others, in the words of Klartext or SINUMERIK.
struct Noisy<'a> {
    dice: &'a mut Dice,
    klartext: bool,
    /// Parameters that are set in front.
    set: String,
    count: u32,
}

impl Words for Noisy<'_> {
    fn number(&mut self, value: f64) -> String {
        let by = 2 + self.dice.roll(9);
        let tiny = self.dice.roll(9) as i64 - 4;
        let formula = match self.dice.roll(3) {
            0 => format!("( {value:+.4} ) * {by} - ( {value:+.4} ) * {}", by - 1),
            1 => format!("( {value:+.4} ) + 0.0000001 * 0.0000001 * ( {tiny} )"),
            _ => format!("( {value:+.4} ) / {by} * {by}"),
        };
        let at = self.count;
        self.count += 1;
        let (name, is) =
            if self.klartext { (format!("Q{}", 1600 + at), " = ") } else { (format!("R{}", 100 + at), "=") };
        let formula = if self.klartext { formula } else { formula.replace(' ', "") };
        let _ = writeln!(self.set, "{name}{is}{formula}");
        if self.klartext { format!("+{name}") } else { format!("={name}") }
    }
}

fn klartext_contour(number: usize, ring: &Ring, words: &mut dyn Words) -> String {
    let mut text = format!("LBL {number}\n");
    let side = if number == 1 { "RL" } else { "RR" };
    match ring {
        Ring::Corners(corners) => {
            for (at, p) in corners.iter().chain(corners.first()).enumerate() {
                let side = if at == 0 { side } else { "" };
                let (x, y) = (words.number(p[0]), words.number(p[1]));
                let _ = writeln!(text, "L X{x} Y{y} {side}");
            }
        }
        Ring::Circle(center, radius) => {
            let (cx, cy) = (words.number(center[0]), words.number(center[1]));
            let (x, y) = (words.number(center[0] + radius), words.number(center[1]));
            let (again, too) = (words.number(center[0] + radius), words.number(center[1]));
            let _ = writeln!(text, "CC X{cx} Y{cy}\nL X{x} Y{y} {side}\nC X{again} Y{too} DR+");
        }
    }
    text + "LBL 0\n"
}

fn sinumerik_contour(number: usize, ring: &Ring, words: &mut dyn Words) -> String {
    let mut text = format!("E_LAB_A_R{number}:\n");
    match ring {
        Ring::Corners(corners) => {
            for (at, p) in corners.iter().chain(corners.first()).enumerate() {
                let (x, y) = (words.number(p[0]), words.number(p[1]));
                let _ = writeln!(text, "G{} X{x} Y{y}", usize::from(at > 0));
            }
        }
        Ring::Circle(center, radius) => {
            let (x, y) = (words.number(center[0] + radius), words.number(center[1]));
            let (again, too, i) = (words.number(center[0] + radius), words.number(center[1]), words.number(-radius));
            let _ = writeln!(text, "G0 X{x} Y{y}\nG3 X{again} Y{too} I{i} J0");
        }
    }
    let _ = writeln!(text, "E_LAB_E_R{number}:");
    text
}

/// What a program says in both of its forms.
struct Case {
    rings: Vec<Ring>,
    radius: f64,
    klartext: bool,
    cycles: String,
}

impl Case {
    fn random(dice: &mut Dice) -> Case {
        let rings = rings(dice);
        let (radius, klartext) = (number(dice, 3.0, 5.0), dice.roll(2) == 0);
        let width = [1.0, 0.8, number(dice, 0.5, 1.9)][dice.roll(3)];
        let wall = [0.0, 0.3][dice.roll(2)];
        let cycles = if klartext {
            let labels: String = (1..=rings.len()).map(|at| format!(" /{at}")).collect();
            let (swaying, corners) = ([0, 150][dice.roll(2)], [0.0, 0.4][dice.roll(2)]);
            format!(
                "CYCL DEF 14.0 CONTOUR GEOMETRY\nCYCL DEF 14.1 CONTOUR LABEL{labels}\n\
                 CYCL DEF 20 DATA Q1=-4 Q2={width} Q3={wall} Q4=+0 Q5=+0 Q6=+2 Q7=+20 Q8={corners} Q9=+1\n\
                 CYCL DEF 22 ROUGH Q10=+4 Q11=+100 Q12=+500 Q18=+0 Q19={swaying}\nCYCL CALL\n"
            )
        } else {
            let mut text = String::new();
            for at in 1..=rings.len() {
                let _ = writeln!(text, "CYCLE62(\"R{at}\",1,,)");
            }
            let (kind, by) = ([1, 11, 21][dice.roll(3)], width * radius);
            let _ = writeln!(text, "CYCLE63(\"P\",{kind},20,0,2,-4,500,100,{by:.3},4,{wall},0,0,0,0,2,1,8)");
            text
        };
        Case { rings, radius, klartext, cycles }
    }

    fn text(&self, words: &mut dyn Words) -> String {
        let contour = if self.klartext { klartext_contour } else { sinumerik_contour };
        self.rings.iter().enumerate().map(|(at, ring)| contour(at + 1, ring, words)).collect()
    }

    fn program(&self, set: &str, contours: &str) -> String {
        let (radius, cycles) = (self.radius, &self.cycles);
        if self.klartext {
            format!(
                "BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{radius}\nTOOL CALL 1 Z S3000\nL X+7 Y+3 Z+50 R0 FMAX M3\n{set}{cycles}M30\n{contours}END PGM P MM\n"
            )
        } else {
            format!(
                "G17 G90 G71\n$TC_DP6[1,1]={radius}\nT1 D1\nM6\nS3000 M3\nG0 X7 Y3 Z50\n{set}{cycles}M30\n{contours}"
            )
        }
    }

    /// What is printed, but for the head, which names the source; `None` where it is refused.
    fn printed(&self, program: &str, settings: &Settings) -> Option<String> {
        let language = if self.klartext { "klartext" } else { "sinumerik" };
        let program = Program::in_language(language, "P", program.as_bytes()).expect("a language");
        let text = compile(&program, settings, &NoFiles).expect("a target").text?;
        Some(text.lines().filter(|line| !line.starts_with('(')).collect::<Vec<_>>().join("\n"))
    }
}

#[test]
fn the_last_bit_of_a_coordinate_changes_no_byte() {
    let from = |name: &str, usual: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual);
    let (count, seed) = (from("PARTC_TIES", SEEDS), from("PARTC_TIES_SEED", 1));
    let settings = common::settings("[tools.1]\nplunge_angle = 8\n");
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut refused = 0;
    for _ in 0..count {
        let case = Case::random(&mut dice);
        let plain = case.program("", &case.text(&mut Plain));
        let mut words = Noisy { dice: &mut dice, klartext: case.klartext, set: String::new(), count: 0 };
        let contours = case.text(&mut words);
        let noisy = case.program(&words.set, &contours);
        let (one, other) = (case.printed(&plain, &settings), case.printed(&noisy, &settings));
        refused += u64::from(one.is_none());
        assert!(one == other, "{plain}\n{noisy}\n{}\n{}", one.unwrap_or_default(), other.unwrap_or_default());
    }
    println!("PARTC_TIES: {count} cases, {refused} refused");
    assert!(refused * 3 < count, "{refused} of {count} have no path");
}
