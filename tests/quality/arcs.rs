//! Printed arcs: radii at both ends, from the numbers as they stand in the output.

use partc::internals::read::{Act, Path, Reader, SCALE};
use partc::internals::text::files::NoFiles;

use crate::common::{compile_bytes, settings};
use crate::damage::Dice;

/// What was seen.
#[derive(Debug, Default)]
pub struct Arcs {
    pub arcs: u64,
    /// Largest difference of the radii at start and end, in units of the last place.
    pub worst: f64,
    /// A program whose output cannot be read, or was refused for another reason than an arc of no size.
    pub unread: Option<String>,
}

/// A program of arcs of all sizes, sweeps and ways to write them.
fn program(dice: &mut Dice) -> String {
    let mut text = "0 BEGIN PGM A MM\nL X+0 Y+0 Z+5 R0 F800\n".to_owned();
    for _ in 0..40 {
        let size = [0.05, 1.0, 20.0, 300.0, 5000.0][dice.roll(5)];
        let mut number = || (dice.roll(2_000_001) as f64 / 1e6 - 1.0) * size;
        let (x, y, z) = (number(), number(), number());
        let sense = if dice.roll(2) == 0 { '+' } else { '-' };
        let angle = dice.roll(720_000) as f64 / 1e3 + 0.5;
        text += &match dice.roll(3) {
            0 => format!("CC IX{x:+.4} IY{y:+.4}\nCP IPA{sense}{angle} DR{sense}\n"),
            1 => format!("CC IX{x:+.4} IY{y:+.4}\nCP IPA{sense}{angle} IZ{z:+.4} DR{sense}\n"),
            _ => format!(
                "CR IX{x:+.4} IY{y:+.4} R{:+.4} DR{sense}\n",
                x.hypot(y) * (0.51 + dice.roll(100) as f64 / 50.0)
            ),
        };
    }
    text + "END PGM A MM\n"
}

/// Compiles `programs` of them at so many decimals.
pub fn arcs(programs: usize, decimals: u8) -> Arcs {
    let settings = settings(&format!("[output]\ndecimals = {decimals}\n"));
    let mut dice = Dice(0xa4c5_0000 + u64::from(decimals));
    let mut seen = Arcs::default();
    for _ in 0..programs {
        let text = program(&mut dice);
        let compiled = compile_bytes("A.H", text.into_bytes(), "klartext", &settings, &NoFiles);
        // A random arc may start on its centre, or leave the machine.
        if compiled.has_errors() {
            continue;
        }
        seen.read(compiled.output.as_bytes(), decimals);
    }
    seen
}

impl Arcs {
    fn read(&mut self, output: &[u8], decimals: u8) {
        let unit = (SCALE / 10i64.pow(u32::from(decimals))) as f64;
        let mut reader = Reader::at_power_on();
        let (mut rest, mut end) = (output, output.len());
        loop {
            match reader.next(&mut rest, &mut end) {
                Ok(Some(Act::Move(mv))) => {
                    let Path::Arc(arc) = mv.path else { continue };
                    let radius = |p: [i64; 2]| ((p[0] - arc.center[0]) as f64).hypot((p[1] - arc.center[1]) as f64);
                    self.arcs += 1;
                    self.worst = self.worst.max((radius(arc.from) - radius(arc.to)).abs() / unit);
                }
                Ok(Some(_)) => {}
                Ok(None) => return,
                Err(fault) => {
                    self.unread.get_or_insert(fault.why);
                    return;
                }
            }
        }
    }
}
