//! Every golden output means to LinuxCNC's interpreter what the compiler meant.

use core::f64::consts::TAU;

use partc::dialect;
use partc::driver::Session;
use partc::ir::motion::{Move, Path, Sink};
use partc::ir::{Function, Origin};
use partc::machine::{Axis, Settings};
use partc::text::{Memory, Opened};

use super::common::{self, cases, compile_case};
use super::rs274::{self, AXES};

/// Half a printed unit, and what the interpreter's own print loses.
const TOLERANCE: f64 = 1.1e-4;

/// A move as the compiler meant it, in units of the interpreter.
#[derive(Debug, Clone)]
pub struct Meant {
    rapid: bool,
    /// `None` for axes whose position nobody knows.
    end: [Option<f64>; AXES],
    /// Plane, centre and sweep.
    arc: Option<([usize; 3], [f64; 2], f64)>,
}

/// Keeps what the compiler meant.
#[derive(Default)]
pub struct Recorder {
    pub moves: Vec<Meant>,
    at: [Option<f64>; AXES],
}

impl Sink for Recorder {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        let before = self.at;
        for axis in Axis::ALL.into_iter().filter(|axis| axis.index() < AXES) {
            if mv.axes.contains(axis) {
                self.at[axis.index()] = mv.end.get(axis);
            }
        }
        let arc = match &mv.path {
            Path::Arc(arc) => {
                let (a, b, c) = arc.plane.axes();
                Some(([a, b, c], [arc.center.x, arc.center.y], arc.sweep))
            }
            _ => None,
        };
        let printed = |v: Option<f64>| v.map(|v| (v * 1e4).round());
        let same = (0..AXES).all(|i| printed(before[i]) == printed(self.at[i]));
        if arc.is_some() || !same {
            self.moves.push(Meant { rapid: mv.path == Path::Rapid, end: self.at, arc });
        }
        if mv.machine {
            for axis in mv.axes.iter().filter(|axis| axis.index() < AXES) {
                self.at[axis.index()] = None;
            }
        }
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if matches!(function, Function::ToolChange { .. } | Function::WorkOffset(_)) {
            self.at = [None; AXES];
        }
    }

    fn lost(&mut self, _: &Origin) {}
}

fn meant(path: &std::path::Path) -> Vec<Meant> {
    let bytes = std::fs::read(path).expect("a readable case");
    let toml = std::fs::read_to_string(path.with_extension("toml")).unwrap_or_default();
    let settings: Settings = common::settings(&toml);
    let name = path.file_name().expect("a file").to_string_lossy().into_owned();
    let session = Session::new(Opened { name: name.clone(), identity: name, text: Box::new(Memory::new(bytes)) });
    let files = common::Beside(path.parent().expect("a folder").to_path_buf());
    let mut recorder = Recorder::default();
    let dialect = dialect::find(&common::dialect_of(path)).expect("a dialect");
    session.lower(dialect, &settings, &files, &mut recorder);
    recorder.moves
}

/// Compares the interpreter's moves with the ones that were meant.
pub fn compare(found: &[rs274::Move], meant: &[Meant]) -> Result<(), String> {
    if found.len() != meant.len() {
        return Err(format!("{} moves instead of {}", found.len(), meant.len()));
    }
    let mut at = [0.0; AXES];
    for (i, (found, meant)) in found.iter().zip(meant).enumerate() {
        let start = at;
        at = found.end(at);
        for (axis, end) in meant.end.iter().enumerate() {
            if end.is_some_and(|end| (end - at[axis]).abs() > TOLERANCE) {
                return Err(format!("move {i}: ends at {at:?}, meant {:?}", meant.end));
            }
        }
        match (found, &meant.arc) {
            (rs274::Move::Rapid(_), None) if meant.rapid => {}
            (rs274::Move::Feed(_), None) if !meant.rapid => {}
            (rs274::Move::Arc { plane, end, center, turns, .. }, Some((meant_plane, meant_center, sweep))) => {
                let off = (center[0] - meant_center[0]).hypot(center[1] - meant_center[1]);
                let radius = (end[0] - center[0]).hypot(end[1] - center[1]);
                let angle = |p: [f64; 2]| (p[1] - center[1]).atan2(p[0] - center[0]);
                let sign = f64::from(turns.signum());
                let mut part = ((angle(*end) - angle([start[plane[0]], start[plane[1]]])) * sign).rem_euclid(TAU);
                if part < 1e-9 {
                    part = TAU;
                }
                let total = sign * (part + TAU * f64::from(turns.abs() - 1));
                if plane != meant_plane || off > 3e-4 || (total - sweep).abs() > 1e-3 + 3e-4 / radius {
                    return Err(format!("move {i}: arc {found:?} sweeps {total}, meant {meant:?}"));
                }
            }
            _ => return Err(format!("move {i}: {found:?}, meant {meant:?}")),
        }
    }
    Ok(())
}

#[test]
fn golden_outputs_mean_what_they_say() {
    if !rs274::available() {
        return;
    }
    let mut failures = Vec::new();
    // Of the cases of findings those about geometry and output; the others may use words of some machine only.
    let about =
        |path: &std::path::Path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(['G', 'O']));
    let errors = cases("errors").into_iter().filter(|path| about(path));
    for path in ["klartext", "heidenhain-turning", "mtc200", "sinumerik"].into_iter().flat_map(cases).chain(errors) {
        let compiled = compile_case(&path);
        if compiled.has_errors() || has_parallel_axes(&compiled.output) {
            continue;
        }
        let replaced = compiled.codes().iter().any(|code| matches!(*code, "O4001" | "O4002"));
        let result = rs274::interpret(&compiled.output)
            .and_then(|found| if replaced { Ok(()) } else { compare(&found, &meant(&path)) })
            .and_then(|()| {
                let compensated = compiled.output.contains("\nG41") || compiled.output.contains("\nG42");
                if compensated { rs274::accepts(&compiled.output) } else { Ok(()) }
            });
        if let Err(why) = result {
            failures.push(format!("{}: {why}", path.display()));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The stand-alone interpreter knows no U, V and W.
fn has_parallel_axes(output: &str) -> bool {
    output.lines().filter(|line| !line.starts_with('(')).any(|line| line.contains(['U', 'V', 'W']))
}

#[test]
fn the_comparison_sees_faults() {
    let straight = |x| Meant { rapid: false, end: [Some(x), Some(0.0), None, None, Some(0.0), None], arc: None };
    let found = [rs274::Move::Feed([1.0, 0.0, 5.0, 0.0, 0.0, 0.0])];
    assert!(compare(&found, &[straight(1.0)]).is_ok());
    assert!(compare(&found, &[straight(1.001)]).is_err());
    assert!(compare(&found, &[]).is_err());
    assert!(compare(&[rs274::Move::Rapid([1.0, 0.0, 5.0, 0.0, 0.0, 0.0])], &[straight(1.0)]).is_err());
    assert!(compare(&[rs274::Move::Feed([1.0, 0.0, 5.0, 0.0, 90.0, 0.0])], &[straight(1.0)]).is_err());
    let arc = |turns, center| {
        [rs274::Move::Arc {
            plane: [0, 1, 2],
            end: [0.0, 0.0],
            center: [center, 0.0],
            turns,
            third: 0.0,
            rotary: [0.0; 3],
        }]
    };
    let circle = |sweep| Meant {
        rapid: false,
        end: [Some(0.0), Some(0.0), None, None, None, None],
        arc: Some(([0, 1, 2], [5.0, 0.0], sweep)),
    };
    assert!(compare(&arc(1, 5.0), &[circle(TAU)]).is_ok());
    assert!(compare(&arc(-1, 5.0), &[circle(TAU)]).is_err());
    assert!(compare(&arc(2, 5.0), &[circle(TAU)]).is_err());
    assert!(compare(&arc(1, 5.01), &[circle(TAU)]).is_err());
}
