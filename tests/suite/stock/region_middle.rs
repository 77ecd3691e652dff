//! Middle lines of pockets along contours: a cutter that is a little smaller than it was said to be leaves nothing between the rings.

use super::super::common;
use super::super::damage::Dice;
use super::milling::{Stock, many, track_of};

/// How much smaller the cutter is.
const WORN: f64 = 0.985;

const RADII: [f64; 8] = [1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0];
const OVERLAPS: [f64; 7] = [0.5, 0.8, 0.95, 1.0, 1.2, 1.4, 1.9];
/// Rings to the middle, often a whole number; and how much the pocket is off that.
const RINGS: [f64; 6] = [2.0, 3.0, 4.0, 5.0, 2.5, 3.7];
const OFF: [f64; 6] = [1.0, 1.0, 0.98, 0.99, 0.995, 1.003];

fn rectangle([w, h]: [f64; 2], overlap: f64) -> String {
    format!(
        "BEGIN PGM MIDDLE MM
TOOL CALL 1 Z S2500
L Z+50 R0 FMAX M3
CYCL DEF 14.0 CONTOUR
CYCL DEF 14.1 CONTOUR LABEL1
CYCL DEF 20 CONTOUR DATA Q1=-5 Q2=+{overlap} Q3=+0 Q4=+0 Q5=+0 Q6=+2 Q7=+50 Q8=+0 Q9=+1
CYCL DEF 22 ROUGH-OUT Q10=-5 Q11=+100 Q12=+350 Q18=+0 Q19=+0
CYCL CALL
L Z+50 R0 FMAX M2
LBL 1
L X+0 Y+0 RL
L X+{w}
L Y+{h}
L X+0
L Y+0
LBL 0
END PGM MIDDLE MM
"
    )
}

fn pick<const N: usize>(dice: &mut Dice, of: [f64; N]) -> f64 {
    of[dice.roll(N)]
}

/// Is the floor cleared, but for a strip along the walls?
fn judge(radius: f64, size: [f64; 2], overlap: f64, shift: f64) -> Result<bool, String> {
    let settings = common::settings(&format!("[tools.1]\nradius = {radius}\n"));
    let what = format!("{size:?} by {radius}, Q2 {overlap}");
    let cuts =
        track_of("klartext", &rectangle(size, overlap), &settings).map_err(|codes| format!("{what}: {codes:?}"))?;
    let cell = radius / 6.0;
    // The columns of the middle line are among those that are looked at.
    let low = [size[0] / 2.0 % cell - cell, size[1] / 2.0 % cell - cell - (shift * 3.0).floor() * cell];
    let mut stock = Stock::new(low, size, cell);
    for cut in &cuts {
        stock.cut(cut, radius * WORN);
    }
    let strip = 0.4 * radius;
    let inside = |p: [f64; 2]| (0..2).all(|i| p[i] >= strip && p[i] <= size[i] - strip);
    match stock.columns().find(|(p, top)| inside(*p) && *top > -4.9) {
        Some((p, _)) => Err(format!("{what}: something is left at {p:?}")),
        None => Ok(true),
    }
}

#[test]
fn rings_clear_the_middle_line() {
    assert_eq!(judge(4.0, [60.0, 40.0], 1.2, 0.0), Ok(true));
    many("PARTC_MIDDLE", 60, |dice, shift| {
        let radius = pick(dice, RADII);
        let height = 2.0 * radius * (1.0 + pick(dice, RINGS) * pick(dice, OFF));
        let size = [height * pick(dice, [1.0, 1.3, 1.5, 2.0]), height].map(|v| (v * 1e3).round() / 1e3);
        judge(radius, size, pick(dice, OVERLAPS), shift)
    });
}
