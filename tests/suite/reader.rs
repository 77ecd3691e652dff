//! A small reader of our own output, written without the printer: the same moves as the interpreter gives.

use super::rs274::{AXES, Move};

/// Position in units of 0.0001, so that nothing is rounded twice.
type Units = [i64; AXES];

/// Reads a program. Fails on any word that a plain program does not have.
pub fn read(program: &str) -> Result<Vec<Move>, String> {
    let mut moves = Vec::new();
    let mut at: Units = [0; AXES];
    let mut plane = [0, 1, 2];
    for line in program.lines() {
        if line.is_empty() || line == "%" || line.starts_with('(') {
            continue;
        }
        let mut motion = None;
        let mut to = at;
        let mut offset = [0; 3];
        let mut turns = 1;
        let mut ends = 0;
        for word in line.split(' ') {
            let (letter, value) = word.split_at(1);
            match (letter, value) {
                ("G", "0" | "1" | "2" | "3") => motion = value.parse::<u8>().ok(),
                ("G", "17") => plane = [0, 1, 2],
                ("G", "18") => plane = [2, 0, 1],
                ("G", "19") => plane = [1, 2, 0],
                ("G", _) | ("T" | "S" | "F" | "M" | "U" | "V" | "W" | "D" | "H" | "R", _) => {}
                ("P", _) => turns = value.parse::<f64>().map_err(|e| format!("{word}: {e}"))? as i32,
                ("X" | "Y" | "Z" | "A" | "B" | "C", _) => {
                    to["XYZABC".find(letter).expect("one of six")] = units(value)?;
                    ends += 1;
                }
                ("I" | "J" | "K", _) => offset["IJK".find(letter).expect("one of three")] = units(value)?,
                _ => return Err(format!("unknown word {word} in {line}")),
            }
        }
        let mm = |u: i64| u as f64 * 1e-4;
        let point = |u: Units| u.map(mm);
        match motion {
            Some(0) if ends > 0 => moves.push(Move::Rapid(point(to))),
            Some(1) if ends > 0 => moves.push(Move::Feed(point(to))),
            Some(n @ (2 | 3)) => {
                let [a, b, c] = plane;
                let center = [at[a] + offset[a], at[b] + offset[b]];
                let square = |p: Units| {
                    let (x, y) = (i128::from(p[a] - center[0]), i128::from(p[b] - center[1]));
                    ((x * x + y * y) as f64).sqrt()
                };
                let off = (square(at) - square(to)).abs();
                if off > 1.5 {
                    return Err(format!("{line}: the radii differ by {off} units"));
                }
                moves.push(Move::Arc {
                    plane,
                    end: [mm(to[a]), mm(to[b])],
                    center: [mm(center[0]), mm(center[1])],
                    turns: if n == 3 { turns } else { -turns },
                    third: mm(to[c]),
                    rotary: [mm(to[3]), mm(to[4]), mm(to[5])],
                });
            }
            _ => {}
        }
        at = to;
    }
    Ok(moves)
}

/// A decimal in units of 0.0001.
fn units(text: &str) -> Result<i64, String> {
    let (sign, digits) = text.strip_prefix('-').map_or((1, text), |digits| (-1, digits));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if fraction.len() > 4 || text == "-0" || fraction.ends_with('0') || whole.is_empty() {
        return Err(format!("{text} is not how numbers are printed"));
    }
    let fraction = format!("{fraction:0<4}");
    let number = format!("{whole}{fraction}").parse::<i64>().map_err(|e| format!("{text}: {e}"))?;
    Ok(sign * number)
}
