//! Stock removal at a corner: random calls of CYCLE951.

use super::layers::{chance, real};
use super::removal::{Blank, Language, Made, PLUNGE, Part, Piece, ROUGH, Side, Tally, UNLIMITED, made, run, steps};
use super::turning::P;
use crate::damage::Dice;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Corner {
    Sharp,
    Round(f64),
    /// Sides.
    Chamfer(f64),
}

#[derive(Debug)]
struct Case {
    inside: bool,
    front: bool,
    along_z: bool,
    /// Corner of the blank along Z and X (radius), and the way to the end point into the material.
    blank: P,
    way: P,
    /// The point between, in parts of the way; for oblique edges.
    between: Option<P>,
    /// Stored, where it means nothing.
    stale: bool,
    corners: [Corner; 3],
    /// X1, Z1, XM, ZM are increments.
    increments: [bool; 4],
    most: f64,
    left: P,
    operation: usize,
    clearance: f64,
    release: [f64; 2],
    position: usize,
    nose: f64,
    start: P,
}

impl Case {
    fn roll(dice: &mut Dice) -> Case {
        let (inside, front, along_z) = (chance(dice, 50), chance(dice, 50), chance(dice, 60));
        let way = [real(dice, 0.5, 40.0), real(dice, 0.5, 25.0)];
        let shape = dice.roll(3);
        let least = way[0].min(way[1]);
        let corner = |dice: &mut Dice| match dice.roll(if shape == 0 { 1 } else { 3 }) {
            0 => Corner::Sharp,
            1 => Corner::Round(real(dice, 0.05, least / 3.0)),
            _ => Corner::Chamfer(real(dice, 0.05, least / 3.0)),
        };
        let corners = [corner(dice), corner(dice), corner(dice)];
        let flip = |dice: &mut Dice| chance(dice, 50);
        let mut case = Case {
            inside,
            front,
            along_z,
            blank: [real(dice, -50.0, 50.0), real(dice, 30.0, 80.0)],
            way,
            between: (shape == 2).then(|| [real(dice, 0.0, 1.0), real(dice, 0.0, 1.0)]),
            stale: chance(dice, 50),
            corners,
            increments: [flip(dice), flip(dice), flip(dice), flip(dice)],
            most: real(dice, 0.5, 4.0),
            left: if chance(dice, 30) { [0.0, 0.0] } else { [real(dice, 0.0, 0.4), real(dice, 0.0, 0.4)] },
            operation: 1 + dice.roll(3),
            clearance: real(dice, 0.3, 3.0),
            release: [real(dice, 0.3, 2.0), if chance(dice, 30) { -1.0 } else { real(dice, 0.3, 2.0) }],
            position: 0,
            nose: if chance(dice, 15) { 0.0 } else { real(dice, 0.1, 1.2) },
            start: [0.0, 0.0],
        };
        let positions = case.side().positions();
        case.position = positions[if chance(dice, 50) { 0 } else { dice.roll(positions.len()) }];
        let high = case.seen_way()[1];
        case.start = match dice.roll(3) {
            0 => [-real(dice, 8.0, 20.0), real(dice, -2.0, high + 10.0)],
            1 => [real(dice, -10.0, 10.0), high + real(dice, 8.0, 15.0)],
            _ => [-9.0, high + 9.0],
        };
        case
    }

    /// Senses of Z and X into the material.
    fn into(&self) -> P {
        [if self.front { -1.0 } else { 1.0 }, if self.inside { 1.0 } else { -1.0 }]
    }

    fn end(&self) -> P {
        let into = self.into();
        [self.blank[0] + into[0] * self.way[0], self.blank[1] + into[1] * self.way[1]]
    }

    /// Length and height of the corner in the view.
    fn seen_way(&self) -> P {
        if self.along_z { self.way } else { [self.way[1], self.way[0]] }
    }

    /// The view: from the front of the blank, the deepest place at height 0.
    fn side(&self) -> Side {
        let ([z, x], [_, far], into) = (self.blank, self.end(), self.into());
        if self.along_z {
            Side { radial: true, out: -into[1], along: into[0], zero: [z, far] }
        } else {
            Side { radial: false, out: -into[0], along: into[1], zero: [x, self.end()[0]] }
        }
    }

    /// The point between on the part.
    fn middle(&self) -> P {
        let ([z, x], end) = (self.blank, self.end());
        let [a, b] = self.between.unwrap_or([1.0, 1.0]);
        let round = |v: f64| (v * 1e3).round() / 1e3;
        [round(z + (end[0] - z) * a), round(x + (end[1] - x) * b)]
    }

    /// The finished contour in the view.
    fn pieces(&self) -> Vec<Piece> {
        let side = self.side();
        let ([z, x], end, middle) = (self.blank, self.end(), self.middle());
        let see = |z: f64, x: f64| side.view(z, x);
        let (first, last) = (see(z, end[1]), see(end[0], x));
        let mut points = vec![first, see(middle[0], middle[1]), last];
        let mut corners = self.corners.to_vec();
        if !self.along_z {
            points.reverse();
            corners.reverse();
        }
        // The face of the blank in front and its second side behind.
        let [from, to] = [points[0], points[2]];
        points.insert(0, [from[0], from[1] - 100.0]);
        points.push([to[0] + 100.0, to[1]]);
        let mut list: Vec<Piece> = Vec::new();
        let mut at: Option<P> = None;
        for (k, corner) in corners.iter().enumerate() {
            let [a, p, b] = [points[k], points[k + 1], points[k + 2]];
            let (start, piece, end) = transition(a, p, b, *corner);
            if let Some(at) = at.filter(|at| far(*at, start) > 1e-9) {
                list.push(Piece { from: at, to: start, arc: None });
            }
            list.extend(piece);
            at = Some(end);
        }
        list
    }

    /// Do the corners have room on their edges?
    fn fits(&self) -> bool {
        let list = self.pieces();
        list.iter().all(|p| p.to[0] >= p.from[0] - 1e-9 && p.to[1] >= p.from[1] - 1e-9)
    }

    fn call(&self, operation: usize) -> String {
        let ([z, x], end, middle) = (self.blank, self.end(), self.middle());
        let [ix1, iz1, ixm, izm] = self.increments;
        let round = |v: f64| (v * 1e6).round() / 1e6;
        let along_x = |to: f64, inc: bool| round(if inc { (to - x).abs() } else { 2.0 * to });
        let along_z = |to: f64, inc: bool| round(if inc { (to - z).abs() } else { to });
        let oblique = self.between.is_some();
        let (xm, zm) = match (oblique, self.stale) {
            (true, _) => (along_x(middle[1], ixm), along_z(middle[0], izm)),
            (false, true) => (17.0, 33.0),
            (false, false) => (0.0, 0.0),
        };
        let plain = !oblique && self.corners == [Corner::Sharp; 3];
        let shape = if oblique { 2 } else { usize::from(!plain) };
        let mut mode = 0;
        for (n, inc) in [ix1, iz1, oblique && ixm, oblique && izm].into_iter().enumerate() {
            mode += usize::from(inc) * 10_usize.pow(n as u32);
        }
        let sizes = self.corners.map(|corner| match corner {
            Corner::Sharp => 0.0,
            Corner::Round(size) | Corner::Chamfer(size) => size,
        });
        for (n, corner) in self.corners.iter().enumerate() {
            mode += usize::from(matches!(corner, Corner::Chamfer(_))) * 10_usize.pow(n as u32 + 4);
        }
        let place = 2 * usize::from(self.inside) + usize::from(self.front);
        format!(
            "CYCLE951({},{z},{},{},{xm},{zm},{place},{},{},{},{}{},{},{},{},{},{ROUGH},{shape},2,{mode})",
            round(2.0 * x),
            along_x(end[1], ix1),
            along_z(end[0], iz1),
            self.most,
            self.left[1],
            self.left[0],
            operation,
            if self.along_z { 1 } else { 2 },
            sizes[0],
            sizes[1],
            sizes[2],
            self.clearance
        )
    }

    fn text(&self) -> String {
        let start = self.side().part(self.start);
        let calls =
            if self.operation == 2 { format!("{}\n{}", self.call(1), self.call(2)) } else { self.call(self.operation) };
        format!("G18 G90 DIAMON G95 F0.5\nT1 D1\nS1000 M3\nG0 X{:.6} Z{:.6}\n{calls}\nM30\n", start[1], start[0])
    }

    fn config(&self) -> String {
        let [outside, inside] = self.release;
        format!(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ndecimals = 6\n[cycles]\nfinish_feed_percent = 40\n\
             rough_release_outside = {outside:?}\nrough_release_inside = {inside:?}\n\
             [tools.1]\nradius = {:?}\norientation = {}\n",
            self.nose, self.position
        )
    }

    fn expected(&self) -> Part {
        let side = self.side();
        let (along, up) = if self.along_z { (self.left[0], self.left[1]) } else { (self.left[1], self.left[0]) };
        Part {
            pieces: self.pieces(),
            side,
            nose: self.nose,
            center: side.center(self.position, self.nose),
            relief: true,
            along,
            up,
            around: 0.0,
            most: self.most,
            blank: Blank::Box { front: 0.0, top: self.seen_way()[1] },
            limits: UNLIMITED,
            plunge: PLUNGE,
            beyond: self.nose,
            steps: Some(0.0),
        }
    }

    /// Where the cycle ends, on the part: Z and X as a diameter.
    fn home(&self) -> P {
        let into = self.into();
        [self.blank[0] - into[0] * self.clearance, 2.0 * (self.blank[1] - into[1] * self.clearance)]
    }
}

fn far(a: P, b: P) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The corner at `p` between `a` and `b`: where it begins, what it is and where it ends.
fn transition(a: P, p: P, b: P, corner: Corner) -> (P, Option<Piece>, P) {
    let (back, ahead) = (far(a, p), far(b, p));
    if back < 1e-6 || ahead < 1e-6 {
        return (p, None, p);
    }
    let (u, w) = ([(a[0] - p[0]) / back, (a[1] - p[1]) / back], [(b[0] - p[0]) / ahead, (b[1] - p[1]) / ahead]);
    // Twice the area, positive where the way turns left.
    let turn = -u[0] * w[1] + u[1] * w[0];
    let on = |d: P, by: f64| [p[0] + d[0] * by, p[1] + d[1] * by];
    match corner {
        _ if turn.abs() < 1e-6 => (p, None, p),
        Corner::Sharp => (p, None, p),
        Corner::Chamfer(size) => {
            let (from, to) = (on(u, size), on(w, size));
            (from, Some(Piece { from, to, arc: None }), to)
        }
        Corner::Round(radius) => {
            // Half the angle between both edges.
            let half = (turn.abs()).atan2(u[0] * w[0] + u[1] * w[1]) / 2.0;
            let (from, to) = (on(u, radius / half.tan()), on(w, radius / half.tan()));
            let middle = [(u[0] + w[0]) / 2.0, (u[1] + w[1]) / 2.0];
            let long = middle[0].hypot(middle[1]);
            let center = on([middle[0] / long, middle[1] / long], radius / half.sin());
            (from, Some(Piece { from, to, arc: Some((center, turn > 0.0)) }), to)
        }
    }
}

fn judge(case: &Case, tally: &mut Tally) -> Result<(), String> {
    let (text, moves) = match made(Language::Sinumerik, &case.text(), &case.config())? {
        Made::Moves { text, moves, .. } => (text, moves),
        // The allowance fills the blank.
        Made::Refused("G3046", _) => {
            tally.refused += 1;
            return Ok(());
        }
        // Corners that are too large.
        Made::Refused("P2090", why) if why.contains("larger than its edge") => {
            tally.refused += 1;
            return Ok(());
        }
        Made::Refused(code, why) => return Err(format!("{code} {why}")),
    };
    if !case.fits() {
        return Err("corners without room are cut".to_owned());
    }
    let part = case.expected();
    let steps = steps(part.side, part.center, &moves);
    tally.cut += 1;
    tally.moves += steps.len() as u64;
    part.check(&steps).map_err(|why| format!("{why}\n{text}"))?;
    let end = steps.last().map_or([0.0; 2], |step| step.sweep.ends().1);
    let tip = part.side.part([end[0] - part.center[0], end[1] - part.center[1]]);
    let mut home = case.home();
    // A nose that reaches lower than its tip stands as much higher.
    let raise = case.nose - part.center[1];
    if case.along_z {
        home[1] += 2.0 * part.side.out * raise
    } else {
        home[0] += part.side.out * raise
    }
    if (tip[0] - home[0]).abs() > 1e-5 || (tip[1] - home[1]).abs() > 1e-5 {
        return Err(format!("ends at {tip:?}, not {home:?}\n{text}"));
    }
    Ok(())
}

/// `PARTC_CORNERS` says how many, `PARTC_CORNERS_SEED` which.
#[test]
fn random_corners_are_cut_right() {
    run("CORNERS", 200, |dice, tally| {
        let case = Case::roll(dice);
        judge(&case, tally).map_err(|why| format!("{why}\n{case:?}\n{}{}", case.config(), case.text()))
    });
}
