//! LinuxCNC's stand-alone interpreter as an independent reader of our output.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// X Y Z A B C; the stand-alone interpreter has no U V W.
pub const AXES: usize = 6;

/// A canonical call that moves: end, and centre with turns for an arc.
#[derive(Debug, Clone, PartialEq)]
pub enum Move {
    Rapid([f64; AXES]),
    Feed([f64; AXES]),
    /// First and second axis of the plane: end and centre; signed turns; end of the third axis.
    Arc {
        plane: [usize; 3],
        end: [f64; 2],
        center: [f64; 2],
        turns: i32,
        third: f64,
        /// A B C.
        rotary: [f64; 3],
    },
}

impl Move {
    /// Where it ends, given where it starts.
    pub fn end(&self, from: [f64; AXES]) -> [f64; AXES] {
        match self {
            Move::Rapid(end) | Move::Feed(end) => *end,
            Move::Arc { plane, end, third, rotary, .. } => {
                let mut to = from;
                to[plane[0]] = end[0];
                to[plane[1]] = end[1];
                to[plane[2]] = *third;
                to[3..].copy_from_slice(rotary);
                to
            }
        }
    }
}

/// Is the interpreter installed? `PARTC_REQUIRE_ORACLE` makes its absence an error.
pub fn available() -> bool {
    let found = Command::new("rs274").arg("-h").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok();
    assert!(
        found || std::env::var_os("PARTC_REQUIRE_ORACLE").is_none(),
        "rs274 is not installed (Debian package linuxcnc-uspace)"
    );
    if !found {
        eprintln!("skipped: rs274 is not installed (Debian package linuxcnc-uspace)");
    }
    found
}

/// Interprets `program` with tools of radius 0; the moves, or what the interpreter complains about.
pub fn interpret(program: &str) -> Result<Vec<Move>, String> {
    interpret_with(program, "0")
}

/// Does the interpreter take `program` with tools that have a radius? With it more is forbidden between G41
/// and G40, and outside corners get arcs, which nobody meant; so the moves are not looked at.
pub fn accepts(program: &str) -> Result<(), String> {
    interpret_with(program, "0.000002").map(drop)
}

fn interpret_with(program: &str, diameter: &str) -> Result<Vec<Move>, String> {
    let dir = scratch();
    let write = |file: &str, text: &str| fs::write(dir.join(file), text).expect("a writable folder");
    let mut table = String::new();
    for (pocket, number) in tools(program).into_iter().enumerate() {
        table += &format!("T{number} P{} D{diameter} Z0 ;\n", pocket + 1);
    }
    write("t.tbl", &table);
    write(
        "o.ini",
        "[EMC]\nMACHINE=o\n[RS274NGC]\nCENTER_ARC_RADIUS_TOLERANCE_MM = 0.001\nCENTER_ARC_RADIUS_TOLERANCE_INCH = 0.00004\n\
         [TRAJ]\nLINEAR_UNITS=mm\nANGULAR_UNITS=degree\nCOORDINATES=X Y Z A B C U V W\n[EMCIO]\nTOOL_TABLE=t.tbl\n",
    );
    write("v.var", "");
    write("p.ngc", program);
    // Names without a folder: the interpreter has room for short ones only.
    let out = Command::new("rs274")
        .args(["-g", "-n", "2", "-i", "o.ini", "-t", "t.tbl", "-v", "v.var", "p.ngc"])
        .env("HOME", &dir)
        .current_dir(&dir)
        .output()
        .expect("rs274 starts");
    let errors = String::from_utf8_lossy(&out.stderr);
    let errors: Vec<&str> =
        errors.lines().filter(|line| !line.trim().is_empty() && line.trim() != "executing").collect();
    let _ = fs::remove_dir_all(&dir);
    if !out.status.success() || !errors.is_empty() {
        return Err(errors.join("\n"));
    }
    moves(&String::from_utf8_lossy(&out.stdout))
}

/// The end of a straight move.
fn straight_end(numbers: &[f64]) -> Result<[f64; AXES], String> {
    numbers.get(..AXES).and_then(|end| end.try_into().ok()).ok_or_else(|| format!("six numbers in {numbers:?}"))
}

/// A folder of its own for each run: tests run side by side.
fn scratch() -> PathBuf {
    static RUNS: AtomicUsize = AtomicUsize::new(0);
    let run = RUNS.fetch_add(1, Ordering::Relaxed);
    let own = format!("rs274-{}-{run}", std::process::id());
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(own);
    fs::create_dir_all(&dir).expect("a writable target folder");
    dir
}

fn tools(program: &str) -> Vec<u32> {
    let mut found: Vec<u32> = program
        .lines()
        .filter(|line| !line.starts_with('('))
        .flat_map(|line| line.split(' '))
        .filter_map(|word| word.strip_prefix(['T', 'D', 'H'])?.parse().ok())
        .filter(|number| (1..100_000).contains(number))
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

fn moves(canonical: &str) -> Result<Vec<Move>, String> {
    let mut plane = [0, 1, 2];
    let mut at = [0.0; AXES];
    let mut list = Vec::new();
    for line in canonical.lines() {
        let Some(open) = line.find('(') else { continue };
        let name = line[..open].rsplit(' ').next().unwrap_or_default();
        let arguments = line[open + 1..].trim_end().trim_end_matches(')');
        let numbers: Vec<f64> = arguments.split(',').filter_map(|part| part.trim().parse().ok()).collect();
        match name {
            "SELECT_PLANE" => {
                plane = match arguments.rsplit('_').next() {
                    Some("XZ") => [2, 0, 1],
                    Some("YZ") => [1, 2, 0],
                    _ => [0, 1, 2],
                }
            }
            "STRAIGHT_TRAVERSE" => list.push(Move::Rapid(straight_end(&numbers)?)),
            "STRAIGHT_FEED" => list.push(Move::Feed(straight_end(&numbers)?)),
            "ARC_FEED" if numbers.len() < 9 => return Err(format!("{line}: nine numbers are expected")),
            "ARC_FEED" => {
                let arc = Move::Arc {
                    plane,
                    end: [numbers[0], numbers[1]],
                    center: [numbers[2], numbers[3]],
                    turns: numbers[4] as i32,
                    third: numbers[5],
                    rotary: [numbers[6], numbers[7], numbers[8]],
                };
                let radius = |p: [f64; 2]| (p[0] - numbers[2]).hypot(p[1] - numbers[3]);
                let off = (radius([at[plane[0]], at[plane[1]]]) - radius([numbers[0], numbers[1]])).abs();
                if off > 0.001 + 1.5e-4 {
                    return Err(format!("{line}: the radii differ by {off:.5}"));
                }
                list.push(arc);
            }
            _ => {}
        }
        if let Some(last) = list.last() {
            at = last.end(at);
        }
    }
    Ok(list)
}
