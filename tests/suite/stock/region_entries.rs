//! Where a cutter goes down into solid material: once for each room between the walls and each level.

use partc::files::NoFiles;
use partc::{Program, compile};

use super::super::common;
use super::klartext_frames::Seen;
use super::milling::{Cut, EXACT, Stock};
use super::regions::{Case, Land, P, Ring};

/// The ways down into material, one after the other.
#[derive(Debug, Default)]
pub struct Entries {
    /// Where each begins, and how deep it leads.
    found: Vec<(P, f64)>,
    is_going_down: bool,
}

impl Entries {
    /// The next cut; did it meet material?
    pub fn see(&mut self, cut: &Cut, met: bool) {
        if cut.is_rapid() {
            self.is_going_down = false;
        } else if cut.to[2] < cut.from[2] - EXACT && met {
            match self.found.last_mut().filter(|_| self.is_going_down) {
                Some((_, level)) => *level = cut.to[2],
                None => self.found.push(([cut.from[0], cut.from[1]], cut.to[2])),
            }
            self.is_going_down = true;
        }
    }

    /// Is there no more than one for each room and level? `is_free` says where the centre of the cutter may be.
    pub fn are_single(&self, stock: &Stock, is_free: impl Fn(P) -> bool) -> Result<(), String> {
        let rooms = rooms(stock, is_free);
        let mut seen: Vec<(usize, f64)> = Vec::new();
        for (p, level) in &self.found {
            // A room in which no column stands is not known.
            let Some(room) = rooms.iter().position(|room| room.iter().any(|q| near(*p, *q, stock.cell()))) else {
                continue;
            };
            if seen.iter().any(|(other, z)| *other == room && (z - level).abs() < EXACT) {
                return Err(format!("goes down to {level} in one room more than once, the last time at {p:?}"));
            }
            seen.push((room, *level));
        }
        Ok(())
    }
}

fn near(p: P, q: P, cell: f64) -> bool {
    (p[0] - q[0]).abs() <= 0.75 * cell && (p[1] - q[1]).abs() <= 0.75 * cell
}

/// Columns that hang together.
fn rooms(stock: &Stock, is_free: impl Fn(P) -> bool) -> Vec<Vec<P>> {
    let columns: Vec<P> = stock.columns().map(|(p, _)| p).collect();
    let mut open: Vec<bool> = columns.iter().map(|p| is_free(*p)).collect();
    let wide = stock.wide();
    let mut made = Vec::new();
    for start in 0..columns.len() {
        let mut waiting = if core::mem::take(&mut open[start]) { vec![start] } else { continue };
        let mut room = Vec::new();
        while let Some(at) = waiting.pop() {
            room.push(columns[at]);
            let beside = [(at % wide > 0).then(|| at - 1), (at % wide + 1 < wide).then_some(at + 1)];
            let over = [at.checked_sub(wide), Some(at + wide).filter(|at| *at < columns.len())];
            for next in beside.into_iter().chain(over).flatten() {
                if core::mem::take(&mut open[next]) {
                    waiting.push(next);
                }
            }
        }
        made.push(room);
    }
    made
}

/// Two circles with a square and a triangle standing in them: what the manuals show for cycles 21, 22 and 24.
const TWO_CIRCLES: &str = "BEGIN PGM C21 MM
TOOL CALL 1 Z S3000 F500
L Z+100 R0 FMAX M3
CYCL DEF 14.0 CONTOUR GEOMETRY
CYCL DEF 14.1 CONTOUR LABEL1 /2 /3 /4
CYCL DEF 20 CONTOUR DATA Q1=-20 Q2=+1 Q3=+0.5 Q4=+0.5 Q5=+0 Q6=+2 Q7=+100 Q8=+0.1 Q9=-1
CYCL DEF 21 PILOT DRILLING Q10=+5 Q11=+80 Q13=+1
CYCL CALL
CYCL DEF 22 ROUGH-OUT Q10=+5 Q11=+200 Q12=+1000 Q18=+0 Q19=+200
CYCL CALL
CYCL DEF 24 SIDE FINISHING Q9=+1 Q10=+20 Q11=+200 Q12=+500 Q14=+0
CYCL CALL
L Z+100 R0 FMAX M2
LBL 1
CC X-15 Y+0
L X-40 Y+0 RR
C X-40 DR-
LBL 0
LBL 2
CC X+15 Y+0
L X+40 Y+0 RR
C X+40 DR-
LBL 0
LBL 3
L X-23 Y+0 RL
L Y+8
L X-7
L Y-8
L X-23
L Y+0
LBL 0
LBL 4
L X+15 Y-8 RL
L X+7
L X+15 Y+8
L X+23 Y-8
L X+15
LBL 0
END PGM C21 MM
";

#[test]
fn two_circles_with_two_islands_are_entered_once_and_take_few_lines() {
    for angle in [1.2, 2.0, 5.0] {
        let settings = common::settings(&format!("[tools.1]\nradius = 3\nplunge_angle = {angle}\n"));
        let program = Program::in_language("klartext", "C21.H", TWO_CIRCLES.as_bytes()).expect("a language");
        let text = compile(&program, &settings, &NoFiles).expect("a target").text.expect("no error");
        let lines = text.lines().count();
        // Five places of entry and ramps to each, lifts between the rings: 638 lines under 5 degrees before.
        assert!(lines <= 350, "{lines} under {angle} degrees:\n{text}");
        let land = Land::new(
            vec![
                Ring::Circle { center: [-15.0, 0.0], radius: 25.0 },
                Ring::Circle { center: [15.0, 0.0], radius: 25.0 },
                Ring::Corners(vec![[-23.0, -8.0], [-7.0, -8.0], [-7.0, 8.0], [-23.0, 8.0]]),
                Ring::Corners(vec![[7.0, -8.0], [23.0, -8.0], [15.0, 8.0]]),
            ],
            2,
        );
        let roughed = TWO_CIRCLES.replace("CYCL DEF 21 PILOT DRILLING Q10=+5 Q11=+80 Q13=+1\nCYCL CALL\n", "");
        let case = Case {
            language: "klartext",
            text: roughed.replace("Q8=+0.1", "Q8=+0"),
            land,
            radius: 3.0,
            depth: 20.0,
            step: 5.0,
            wall: 0.5,
            floor: 0.5,
            finish: [true, false],
            left: 0.0,
            corners: 0.0,
            coarse: Vec::new(),
            angle: Some(angle),
            settings,
            seen: Seen::default(),
        };
        assert_eq!(case.judge(0.3), Ok(true));
    }
}
