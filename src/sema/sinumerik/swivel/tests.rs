//! Programs with CYCLE800, by what they put into the contour stream.

use nalgebra::Vector3;

use crate::diag::{Diags, Severity, Trail};
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{Coords, Corner, CtxRef, Load, Move, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::tilt::Solution;
use crate::ir::{Function, Origin, Pos, Tap, Tilt, Tilting};
use crate::machine::{Axis, Settings};
use crate::sema::Job;
use crate::text::files::NoFiles;
use crate::text::{FileId, Memory, Opened, Sources};

/// The planes of a program, and where its moves end in the workpiece.
#[derive(Default)]
struct Recorder {
    tiltings: Vec<Tilting>,
    places: Vec<Vector3<f64>>,
    /// The plane that is on, and the place in it.
    plane: Option<Tilt>,
    at: Pos,
}

impl Sink for Recorder {
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, _: &Origin) {
        if mv.coords == Coords::Machine {
            return;
        }
        self.at.update(&mv.end);
        let inside = ctx.frame.apply(&self.at);
        let place = self.plane.map_or(inside, |plane| plane.in_workpiece(&inside));
        if let [Some(x), Some(y), Some(z)] = [Axis::X, Axis::Y, Axis::Z].map(|axis| place.get(axis)) {
            self.places.push(Vector3::new(x, y, z));
        }
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, _: &Origin) {
        if let Function::Tilt(tilting) = function {
            self.plane = tilting.plane().copied();
            assert!(self.plane.is_none() || ctx.frame.is_identity(), "nothing is programmed in the plane yet");
            self.at = Pos::UNKNOWN;
            self.tiltings.push(**tilting);
        }
    }

    fn corner(&mut self, _: &Corner, _: &CtxRef, _: &Origin) {}
    fn tap(&mut self, _: &Tap, _: &CtxRef, _: &Origin) {}
    fn cycle(&mut self, _: &Cycle, _: &CtxRef, _: &Origin) {}
    fn lost(&mut self, _: &CtxRef, _: &Origin) {}
    fn begins_at(&mut self, _: &Pos) {}
    fn stands_at(&mut self, _: &Pos, _: &CtxRef, _: &Origin) {}

    fn load(&self) -> Load {
        Load::default()
    }

    fn contour_begins(&mut self, _: usize, _: &CtxRef, _: &Origin) {}

    fn contour_ends(&mut self, _: &Origin) -> Result<Captured, Unfit> {
        Ok(Captured::default())
    }
}

/// What a program makes, and its errors and warnings: line, code and message.
fn run_with(program: &str, settings: &Settings) -> (Recorder, Vec<String>) {
    let sources = Sources::default();
    let text = format!("{program}\nM30\n").into_bytes();
    let opened = Opened { name: String::new(), identity: String::new(), text: Box::new(Memory::new(text)) };
    assert!(sources.add(opened).is_ok());
    let (diags, trail) = (Diags::default(), Trail::default());
    let job = Job { sources: &sources, diags: &diags, trail: &trail, files: &NoFiles, settings, main: FileId(0) };
    let mut recorder = Recorder::default();
    super::super::run(&job, &mut recorder);
    let found = diags.into_sorted().into_iter().filter(|found| found.severity != Severity::Note);
    (recorder, found.map(|found| format!("{}: {} {}", found.label.loc.line, found.code.id, found.message)).collect())
}

fn run(program: &str) -> (Recorder, Vec<String>) {
    run_with(program, &Settings::default())
}

/// The same of a program without findings.
fn clean(program: &str) -> Recorder {
    let (recorder, found) = run(program);
    assert!(found.is_empty(), "{program}\n{found:#?}");
    recorder
}

/// The one finding of a program, which holds all of these words.
fn finds(program: &str, words: &[&str]) {
    let (_, found) = run(program);
    assert!(
        matches!(&found[..], [one] if words.iter().all(|word| one.contains(word))),
        "{program}\n{words:?}\n{found:#?}"
    );
}

fn is(found: Vector3<f64>, wanted: [f64; 3], tolerance: f64) {
    assert!((found - Vector3::from(wanted)).abs().max() < tolerance, "{found} {wanted:?}");
}

fn into(tilting: &Tilting) -> &Tilt {
    tilting.plane().expect("a plane is on")
}

const HEAD: &str = "G54 G17 G90 G94 F200\nT1 M6\nS1000 M3\nG0 X0 Y0 Z100\n";
const TILT: &str = "CYCLE800(0,\"TC1\",0,57,0,0,0,0,30,0,0,0,0,1,,1)\n";
const BACK: &str = "CYCLE800(0,\"TC1\",0,57,0,0,0,0,0,0,0,0,0,1,,1)\n";

fn with(program: &str) -> String {
    format!("{HEAD}{program}")
}

/// Section 3.1: a box 50 high; the hole at X0 Y60 of the second plane.
#[test]
fn chain_of_a_published_program() {
    let made = clean(&with(
        "CYCLE800(0,\"TC1\",200000,57,0,0,50,-15,0,0,50,51.76,0,1,,1)\nG0 X0 Y0 Z0\n\
         CYCLE800(0,\"TC1\",200001,54,35,-24,0,7,0,0,0,0,0,1,,1)\nG0 X0 Y0 Z0\nG0 X0 Y60\n",
    ));
    let [first, second] = &made.tiltings[..] else { panic!("{:?}", made.tiltings) };
    is(into(first).origin, [50.0, 49.9963, 36.6035], 5e-5);
    is(into(second).origin, [85.0, 26.8141, 42.8152], 5e-5);
    is(into(second).direction(Axis::Z), [0.121869, 0.256890, 0.958726], 1e-6);
    assert_eq!(into(second).solution, Solution::Reference { greater: true });
    is(made.places[1], [50.0, 49.9963, 36.6035], 5e-5);
    is(made.places[3], [85.0, 84.7697, 27.2860], 5e-5);
}

#[test]
fn modes_and_directions() {
    for (mode, normal) in [
        (57, [0.342020, -0.163176, 0.925417]),
        (54, [0.163176, -0.342020, 0.925417]),
        (45, [0.469846, 0.018028, 0.882564]),
        (39, [0.543838, -0.204874, 0.813798]),
        (30, [0.318796, -0.469846, 0.823173]),
        (27, [0.378522, -0.440970, 0.813798]),
    ] {
        let made = clean(&with(&format!("CYCLE800(0,\"\",0,{mode},1,2,3,10,20,30,0,0,0,-1)\n")));
        let plane = into(&made.tiltings[0]);
        is(plane.direction(Axis::Z), normal, 1e-6);
        is(plane.origin, [1.0, 2.0, 3.0], 1e-12);
        assert_eq!(plane.solution, Solution::Reference { greater: false });
    }
}

/// The frame of the program acts in the plane; a work offset that the program writes lies outside of it.
#[test]
fn frames_inside_and_outside() {
    // X of the plane leads to -Z of the workpiece, Z to X.
    let quarter = "CYCLE800(0,\"TC1\",0,57,10,0,0,0,90,0,0,0,0,1,,1)\n";
    let made =
        clean(&with(&format!("{quarter}TRANS X5 Z2\nG0 X1 Y3 Z0\nTRANS\nG0 X1 Y3 Z0\nROT RPL=90\nG0 X1 Y3 Z0\n")));
    is(made.places[1], [12.0, 3.0, -6.0], 1e-9);
    is(made.places[2], [10.0, 3.0, -1.0], 1e-9);
    is(made.places[3], [10.0, 1.0, 3.0], 1e-9);
    let made = clean(&format!("$P_UIFR[1]=CTRANS(X,100,Z,7)\n{HEAD}{quarter}G0 X1 Y3 Z0\n"));
    is(into(&made.tiltings[0]).origin, [110.0, 0.0, 7.0], 1e-12);
    is(made.places[1], [110.0, 3.0, 6.0], 1e-9);
}

/// In inches offsets are converted, angles are not.
#[test]
fn inches() {
    let made = clean("G54 G700 G90 F10\nG0 X0 Y0 Z4\nCYCLE800(0,\"TC1\",0,57,1,0,0,0,90,0,0,0,2,1,,1)\n");
    is(into(&made.tiltings[0]).origin, [76.2, 0.0, 0.0], 1e-9);
    is(into(&made.tiltings[0]).direction(Axis::Z), [1.0, 0.0, 0.0], 1e-12);
}

#[test]
fn the_plane_turns_back() {
    let back = |end: &str| clean(&with(&format!("{TILT}G0 X1 Y2 Z3\n{end}G0 X1 Y2 Z3\n")));
    let greater = Tilting::Back(Solution::Reference { greater: true });
    let made = back(BACK);
    assert_eq!(made.tiltings[1], greater);
    is(made.places[2], [1.0, 2.0, 3.0], 1e-15);
    // 30 degrees more by -30: upright.
    let made = back("CYCLE800(0,\"TC1\",1,57,0,0,0,0,-30,0,0,0,0,1,,1)\n");
    assert_eq!(made.tiltings[1], greater);
    is(made.places[2], [1.0, 2.0, 3.0], 1e-12);
    let made = clean(&with(
        "CYCLE800(0,\"TC1\",0,57,0,0,0,0,90,0,0,0,0,1,,1)\nCYCLE800(0,\"TC1\",1,57,7,0,0,0,-90,0,0,0,0,-1,,1)\nG0 X1 Y2 Z3\n",
    ));
    assert_eq!(made.tiltings[1], Tilting::Back(Solution::Reference { greater: false }));
    // The shift by X of the first plane leads along -Z of the workpiece.
    is(made.places[1], [1.0, 2.0, -4.0], 1e-12);
    // Once upright, nothing turns any more.
    let made = clean(&with(&format!("{TILT}{BACK}{BACK}G0 X1 Y2 Z3\n")));
    assert_eq!(made.tiltings.len(), 2);
    // Rotary axes that the program turned itself turn back, too.
    let made = clean(&with(&format!("G0 A30\n{BACK}G0 X1 Y2 Z3\n")));
    assert_eq!(made.tiltings, [greater]);
}

#[test]
fn a_plane_that_is_off_leaves_the_tool_askew() {
    for off in
        ["CYCLE800()\n", "CYCLE800\n", "CYCLE800(0,\"0\")\n", "CYCLE800(0,\"TC1\",0,57,0,0,0,0,0,0,0,0,0,0,,1)\n"]
    {
        let start = with(&format!("{TILT}G0 X1 Y2 Z3\n{off}"));
        finds(&format!("{start}G0 X1 Y2 Z3\nX2\n"), &["8: P2042", "line 7"]);
        finds(&format!("{start}G0 Z50 A0 C0\n"), &["8: P2042"]);
        let by_words = format!("{start}SUPA G0 Z0 D0\nD1\nG0 A0 C0\nG0 X1 Y2 Z3\n");
        finds(&by_words, &["11: P2042"]);
        let mut named = Settings::default();
        named.machine.tilt_axes = [Axis::A, Axis::C].into_iter().collect();
        let (made, found) = run_with(&by_words, &named);
        assert!(found.is_empty(), "{found:#?}");
        assert_eq!(made.tiltings[1], Tilting::Off);
        is(made.places[2], [1.0, 2.0, 3.0], 1e-15);
        assert_eq!(clean(&format!("{start}{BACK}G0 X1 Y2 Z3\n")).tiltings.len(), 3);
        assert_eq!(clean(&format!("{start}{TILT}G0 X1 Y2 Z3\n")).tiltings.len(), 3);
    }
    assert!(clean(&with("CYCLE800()\nG0 X1\n")).tiltings.is_empty());
}

#[test]
fn positions_count_anew() {
    for turn in [TILT, &format!("{TILT}G0 X1 Y2 Z3\n{BACK}")] {
        finds(&with(&format!("{turn}G91 G0 X1\n")), &["P2001", "X", "turn of the working plane"]);
        finds(&with(&format!("{turn}G0 X1 Y1\nG91 G0 Z1\n")), &["P2001", "Z", "turn of the working plane"]);
    }
    // Each coordinate of the plane depends on each axis of the machine.
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\nSUPA G0 Z0 D0\nD1\nG91 G0 X1\n")), &["P2001", "X", "machine coordinates"]);
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\nT2 M6\nG91 G0 Y1\n")), &["P2001", "Y", "tool change"]);
}

#[test]
fn what_is_refused() {
    let call = |st: &str, mode: &str, angles: &str, dir: &str| {
        with(&format!("CYCLE800(0,\"TC1\",{st},{mode},0,0,0,{angles},0,0,0,{dir},,1)\n"))
    };
    for (program, words) in [
        (call("0", "64", "10,20,0", "1"), "solid"),
        (call("0", "185", "10,20,0", "1"), "projected"),
        (call("0", "192", "10,20,0", "1"), "rotary axes"),
        (call("0", "21", "10,20,0", "1"), "`_MODE` 21"),
        (call("10", "57", "10,20,0", "1"), "tens"),
        (call("200100", "57", "10,20,0", "1"), "hundreds"),
        (call("1000", "57", "10,20,0", "1"), "thousands"),
        (call("0", "57", "10,20,0", "0"), "`_DIR` 0"),
        (with("CYCLE800(3,\"TC1\",0,57,0,0,0,0,30,0,0,0,0,1)\n"), "retraction 3"),
        (with("CYCLE800(0,\"0\",0,57,0,0,0,0,30,0,0,0,0,1)\n"), "deselects"),
        (with("CYCLE800(0,\"TC1\",0,57,0,0,0,0,30,0,0,0,0,1,,3)\n"), "G17"),
        (with(&format!("G18\n{TILT}")), "G17"),
        (with(&format!("TRANS X1\n{TILT}")), "TRANS"),
        (with(&format!("{TILT}CYCLE800(0,\"TC2\",0,57,0,0,0,0,20,0,0,0,0,1,,1)\n")), "\"TC1\""),
    ] {
        finds(&program, &["S9006", words]);
    }
    finds(&format!("$P_UIFR[1]=CROT(Z,10)\n{HEAD}{TILT}"), &["S9006", "offset"]);
    finds(&with(&format!("$TC_DP6[1,1]=5\nT1 D1 M6\nG0 X0 Y0 Z5\nG41 G1 X5 Y5\n{TILT}")), &["S2080"]);
    finds(&with(&format!("{TILT}G55\n")), &["S2283", "G55"]);
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\n$P_IFRAME=CTRANS(X,1)\n")), &["S2283", "$P_IFRAME"]);
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\nTRANS X1\nCYCLE800()\n")), &["S2283", "TRANS"]);
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\nG0 C10\n")), &["P2043", "C"]);
    finds(&with(&format!("{TILT}G0 X1 Y2 Z3\nSUPA G0 A0\n")), &["P2043", "A"]);
    finds(&call("100000", "57", "10,20,0", "1"), &["S8255"]);
    let mut lathe = Settings::default();
    lathe.machine.kind = crate::machine::MachineKind::Lathe;
    let (_, found) = run_with(&format!("G54 G18 G0 X50 Z5\n{TILT}"), &lathe);
    assert!(matches!(&found[..], [one] if one.contains("S9006") && one.contains("lathe")), "{found:#?}");
}

#[test]
fn the_offset_in_force_may_be_named_again() {
    let made = clean(&with(&format!("{TILT}G54\nG0 X0 Y0 Z0\nG0 X1\n")));
    assert_eq!(made.tiltings.len(), 1);
}
