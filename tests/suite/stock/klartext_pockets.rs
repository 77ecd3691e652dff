//! Cycles 251 to 254 with sizes at random: the properties of docs/cycles.md, column by column.

use std::fmt::Write as _;

use partc::internals::machine::Settings;
use partc::internals::machine::tools::{Tool, ToolKey};

use super::super::damage::Dice;
use super::milling::{many, turned};
use super::pockets::{Case, FINISH, Outline, PLUNGE, ROUGH, Sizes, number, sizes};

/// Plunging angle of the tool, degrees.
pub const ANGLE: f64 = 4.0;

struct Common {
    sizes: Sizes,
    overlap: f64,
    climb: i32,
    plunging: usize,
    infeed: f64,
}

impl std::ops::Deref for Common {
    type Target = Sizes;

    fn deref(&self) -> &Sizes {
        &self.sizes
    }
}

fn common(dice: &mut Dice, most: usize) -> Common {
    let sizes = sizes(dice);
    // A floor that one cut does not take off is refused.
    let sizes = Sizes { floor: sizes.floor.min(sizes.step), ..sizes };
    Common {
        sizes,
        overlap: number(dice, 0.3, 1.999),
        climb: if dice.roll(2) == 0 { 1 } else { -1 },
        plunging: dice.roll(most + 1),
        infeed: if dice.roll(2) == 0 { 0.0 } else { number(dice, sizes.depth / 4.0, sizes.depth) },
    }
}

/// The program that calls the cycle, whose own parameters are given; what is finished.
fn program(dice: &mut Dice, c: &Common, cycle: u32, own: &str) -> (String, [bool; 2]) {
    let mut text = format!("BEGIN PGM P MM\nTOOL DEF 1 L+0 R+{}\nTOOL CALL 1 Z S3000\n", c.radius);
    let _ = writeln!(text, "L X{:+} Y{:+} Z+50 R0 FMAX M3", c.at[0], c.at[1]);
    let asked: &[u32] = [&[0][..], &[1], &[1, 2]][dice.roll(3)];
    for q215 in asked {
        // Z of CYCL CALL POS lifts Q203 back to 0; slots have a place beside that of the call.
        let by_place = cycle <= 252 && dice.roll(3) == 0;
        let by = if by_place { dice.roll(41) as f64 / 4.0 - 5.0 } else { 0.0 };
        let _ = writeln!(
            text,
            "CYCL DEF {cycle} NAME Q215={q215} {own} Q368={:.4} Q207={ROUGH} Q351={} Q201={:.4} Q202={:.4} Q369={:.4} Q206={PLUNGE} Q338={:.4} Q200=2 Q203={} Q204=10 Q366={} Q385={FINISH}",
            c.wall, c.climb, -c.depth, c.step, c.floor, c.infeed, -by, c.plunging
        );
        let [x, y] = c.at;
        let _ = match by_place {
            true => writeln!(text, "CYCL CALL POS X{x:+} Y{y:+} Z{by:+} FMAX"),
            false => writeln!(text, "L X{x:+} Y{y:+} R0 FMAX M99"),
        };
    }
    text.push_str("M30\nEND PGM P MM\n");
    let finishes = asked != [1];
    (text, [finishes && c.wall > 0.0, finishes && c.floor > 0.0])
}

fn case(
    (text, finish): (String, [bool; 2]),
    outline: Outline,
    places: Vec<([f64; 2], f64)>,
    c: &Common,
    home: Option<[f64; 2]>,
) -> Case {
    let slope = (c.plunging > 0).then(|| ANGLE.to_radians().tan());
    Case { finish, slope, home, ..Case::of("klartext", text, outline, places, c) }
}

fn rectangle(dice: &mut Dice) -> Case {
    let c = common(dice, 2);
    let half = [0, 1].map(|_| c.radius + c.wall + number(dice, 0.5, 4.0 * c.radius));
    let corner = if dice.roll(3) == 0 { 0.0 } else { number(dice, 0.0, half[0].min(half[1])) };
    let turn = if dice.roll(2) == 0 { 0.0 } else { number(dice, -180.0, 180.0) };
    let position = dice.roll(5);
    let sign = [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][position];
    let way = turned([sign[0] * half[0], sign[1] * half[1]], turn);
    let own = format!(
        "Q218={:.4} Q219={:.4} Q220={corner:.4} Q224={turn} Q367={position} Q370={}",
        2.0 * half[0],
        2.0 * half[1],
        c.overlap
    );
    let outline = Outline::Rectangle { half, corner: if corner < c.radius { 0.0 } else { corner } };
    let made = program(dice, &c, 251, &own);
    case(made, outline, vec![([c.at[0] + way[0], c.at[1] + way[1]], turn)], &c, Some(c.at))
}

fn circle(dice: &mut Dice) -> Case {
    let c = common(dice, 1);
    let radius = c.radius + c.wall + number(dice, 0.5, 5.0 * c.radius);
    let own = format!("Q223={:.4} Q370={}", 2.0 * radius, c.overlap);
    let made = program(dice, &c, 252, &own);
    case(made, Outline::Circle { radius }, vec![(c.at, 0.0)], &c, Some(c.at))
}

fn slot(dice: &mut Dice) -> Case {
    let c = common(dice, 2);
    let half = c.radius + c.wall + if dice.roll(4) == 0 { 0.0 } else { number(dice, 0.0, 2.5 * c.radius) };
    let between = number(dice, 0.5, 40.0);
    let turn = number(dice, -180.0, 180.0);
    let position = dice.roll(5);
    let to_middle = [0.0, between / 2.0 + half, between / 2.0, -between / 2.0, -between / 2.0 - half][position];
    let way = turned([to_middle, 0.0], turn);
    let own = format!("Q218={:.4} Q219={:.4} Q374={turn} Q367={position}", (between + 2.0 * half), 2.0 * half);
    let outline = Outline::Slot { from: -between / 2.0, to: between / 2.0, half };
    let made = program(dice, &c, 253, &own);
    let home = (position == 0).then_some(c.at);
    case(made, outline, vec![([c.at[0] + way[0], c.at[1] + way[1]], turn)], &c, home)
}

fn bow(dice: &mut Dice) -> Case {
    let c = common(dice, 2);
    let half = c.radius + c.wall + if dice.roll(4) == 0 { 0.0 } else { number(dice, 0.0, 2.5 * c.radius) };
    let count = 1 + dice.roll(3);
    let index = 360.0 / count as f64;
    let (about, sweep) = super::pockets::bow(dice, half, index);
    let start = number(dice, -180.0, 180.0);
    let by_middle = dice.roll(3) == 0;
    let center = [number(dice, -20.0, 20.0), number(dice, -20.0, 20.0)];
    let (center, first) = if by_middle {
        let way = turned([about, 0.0], start);
        ([c.at[0] - way[0], c.at[1] - way[1]], start - sweep / 2.0)
    } else {
        (center, start)
    };
    let own = format!(
        "Q219={:.4} Q375={:.4} Q367={} Q216={:.4} Q217={:.4} Q376={start} Q248={sweep} Q378={index} Q377={count}",
        2.0 * half,
        2.0 * about,
        if by_middle { 2 } else { 0 },
        center[0],
        center[1]
    );
    let places = (0..count).map(|i| (center, first + i as f64 * index)).collect();
    let outline = Outline::Bow { radius: about, sweep: sweep.to_radians(), half };
    let made = program(dice, &c, 254, &own);
    case(made, outline, places, &c, None)
}

/// A mill that may go down at [`ANGLE`].
pub fn settings() -> Settings {
    let mut settings = Settings::default();
    let tool = Tool { plunge_angle: Some(ANGLE), ..Tool::default() };
    settings.tools.table.insert(ToolKey::Number(1, 0), tool);
    settings
}

/// Many cases at random by a generator, the number by `PARTC_POCKETS`.
pub fn judge_many(usual: u64, settings: &Settings, random: impl Fn(&mut Dice) -> Case) {
    many("PARTC_POCKETS", usual, |dice, shift| {
        let case = random(dice);
        case.judge(settings, shift).map_err(|why| format!("{why}\n{}{case:?}", case.text)).map(|()| true)
    });
}

#[test]
fn klartext_rectangles_at_random() {
    judge_many(100, &settings(), rectangle);
}

#[test]
fn klartext_circles_at_random() {
    judge_many(60, &settings(), circle);
}

#[test]
fn klartext_slots_at_random() {
    judge_many(100, &settings(), slot);
}

#[test]
fn klartext_circular_slots_at_random() {
    judge_many(80, &settings(), bow);
}
