//! Tilted planes: what is printed for them, and that every fault in it is noticed.

use nalgebra::Vector3;

use crate::geo::{Plane, rotation};
use crate::ir::motion::{Move, Path};
use crate::ir::tilt::{Solution, Tilt};
use crate::ir::{Feed, Function, Pos, Side, Tilting};
use crate::machine::{Axis, AxisSet, Settings};

use super::streams::{Dice, Item, Stream};
use super::{as_it_is, validate};

const TARGETS: [&str; 4] = ["fanuc", "mazak", "sinumerik", "heidenhain"];

fn plane(angles: [f64; 3], origin: [f64; 3], solution: Solution) -> Item {
    tilts(Tilting::Into(Tilt { axes: rotation::spatial(angles), origin: Vector3::from(origin), solution }))
}

fn tilts(tilting: Tilting) -> Item {
    Item::Function(Function::Tilt(Box::new(tilting)))
}

fn to(path: Path, machine: bool, axes: &[(Axis, f64)]) -> Item {
    let mut end = Pos::UNKNOWN;
    axes.iter().for_each(|(axis, value)| end.set(*axis, *value));
    let axes: AxisSet = axes.iter().map(|(axis, _)| *axis).collect();
    Item::Move(Move { end, axes, path, side: Side::None, plane: Plane::Xy, machine })
}

fn rapid(axes: &[(Axis, f64)]) -> Item {
    to(Path::Rapid, false, axes)
}

fn retract() -> Item {
    to(Path::Rapid, true, &[(Axis::Z, 0.0)])
}

fn settings(target: &str) -> Settings {
    let mut settings = Settings::default();
    settings.output.target = crate::target::find(target).expect("a target");
    settings.machine.tilt_axes = [Axis::A, Axis::C].into_iter().collect();
    settings.machine.swivel_record = Some("TC1".to_owned());
    settings
}

/// The program of references, multi-axis, 6.2: a hole in a plane, then another plane, then back.
fn hole(target: &str) -> Stream {
    let solution = if target == "sinumerik" {
        Solution::Reference { greater: true }
    } else {
        Solution::Primary { positive: true }
    };
    let cut = Path::Line(Feed::PerMinute(100.0));
    let items = vec![
        Item::Function(Function::ToolChange { number: 1 }),
        retract(),
        plane([0.0, 45.0, 0.0], [50.0, 0.0, 20.0], solution),
        rapid(&[(Axis::X, 10.0), (Axis::Y, 5.0)]),
        rapid(&[(Axis::X, 10.0), (Axis::Y, 5.0), (Axis::Z, 2.0)]),
        to(cut, false, &[(Axis::X, 10.0), (Axis::Y, 5.0), (Axis::Z, -10.0)]),
        rapid(&[(Axis::X, 10.0), (Axis::Y, 5.0), (Axis::Z, 2.0)]),
        retract(),
        plane([-15.0, 0.0, 0.0], [0.0, 0.0, 0.0], Solution::Control),
        rapid(&[(Axis::X, 1.0), (Axis::Y, 2.0)]),
        rapid(&[(Axis::X, 1.0), (Axis::Y, 2.0), (Axis::Z, 3.0)]),
        tilts(Tilting::Off),
        retract(),
        tilts(Tilting::Back(Solution::Reference { greater: false })),
        rapid(&[(Axis::X, 0.0), (Axis::Y, 0.0), (Axis::Z, 50.0)]),
    ];
    Stream { settings: settings(target), items }
}

/// The text between the head and the end, without numbers of blocks.
fn printed(stream: &Stream) -> String {
    let outcome = validate(stream, None, &mut as_it_is).expect("is printed");
    assert!(outcome.mismatch.is_none(), "{:?}\n{}", outcome.mismatch, outcome.pieces.concat());
    let pieces = &outcome.pieces[2..outcome.pieces.len() - 1];
    let numbered = stream.settings.output.target.name == "heidenhain";
    let line = |line: &str| {
        if numbered { line.split_once(' ').map_or("", |(_, rest)| rest).to_owned() } else { line.to_owned() }
    };
    pieces.concat().lines().map(|text| line(text) + "\n").collect()
}

#[test]
fn a_fanuc_says_a_plane_by_euler_angles() {
    let wanted = "G53 G0 Z0.\nG68.2 X50. Y0. Z20. I90. J45. K-90.\nG53.1\nG0 X10. Y5.\nG0 G43 Z2. H1\nG1 Z-10. F100.\nG0 Z2.\n\
                  G69\nG53 G0 Z0.\nG49\nG68.2 X0. Y0. Z0. I180. J15. K180.\nG53.1\nG0 X1. Y2.\nG0 G43 Z3. H1\nG69\n\
                  G53 G0 Z0.\nG49\nG0 A0. C0.\nG0 G43 X0. Y0. Z50. H1\n";
    assert_eq!(printed(&hole("fanuc")), wanted);
    assert_eq!(printed(&hole("mazak")), wanted.replace("G68.2 ", "G68.2 P0 "));
}

#[test]
fn a_sinumerik_says_a_plane_by_a_cycle() {
    let text = printed(&hole("sinumerik"));
    let calls: Vec<&str> = text.lines().filter(|line| line.starts_with("CYCLE800")).collect();
    assert_eq!(
        calls,
        [
            "CYCLE800(0,\"TC1\",0,27,50,0,20,0,45,0,0,0,0,1,0,1)",
            "CYCLE800(0,\"TC1\",0,27,0,0,0,0,0,-15,0,0,0,1,0,1)",
            "CYCLE800()",
            "CYCLE800(0,\"TC1\",0,57,0,0,0,0,0,0,0,0,0,-1,0,1)",
        ]
    );
}

#[test]
fn a_dialog_says_a_plane_behind_a_shift() {
    assert_eq!(
        printed(&hole("heidenhain")),
        "L Z+0 R0 FMAX M91\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+50\nCYCL DEF 7.2 Y+0\nCYCL DEF 7.3 Z+20\n\
         PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX SEQ+\nL X+10 Y+5 R0 FMAX\nL Z+2 R0 FMAX\nL Z-10 F100\nL Z+2 R0 FMAX\n\
         L Z+0 R0 FMAX M91\nPLANE RESET STAY\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\n\
         CYCL DEF 7.3 Z+0\nPLANE SPATIAL SPA-15 SPB+0 SPC+0 TURN FMAX\nL X+1 Y+2 R0 FMAX\nL Z+3 R0 FMAX\nPLANE RESET STAY\n\
         L Z+0 R0 FMAX M91\nPLANE RESET TURN FMAX\nL X+0 Y+0 Z+50 R0 FMAX\n"
    );
    let turned = plane([0.0, 0.0, 30.0], [0.0; 3], Solution::Primary { positive: false });
    let stream = Stream { settings: settings("heidenhain"), items: vec![retract(), turned] };
    let text = validate(&stream, None, &mut as_it_is).expect("is printed").pieces.concat();
    assert!(text.contains("PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX SEQ- COORD ROT\n"), "{text}");
}

/// Machine coordinates end the plane of a Fanuc: what goes on in it is refused, and so is a way back without letters.
#[test]
fn what_a_fanuc_cannot_say_is_refused() {
    let tilt = || plane([0.0, 45.0, 0.0], [0.0; 3], Solution::Control);
    for target in TARGETS {
        let euler = matches!(target, "fanuc" | "mazak");
        let items = vec![retract(), tilt(), retract(), rapid(&[(Axis::Z, 5.0)])];
        let stream = Stream { settings: settings(target), items };
        assert_eq!(validate(&stream, None, &mut as_it_is).is_none(), euler, "{target}");
        let items = vec![retract(), tilt(), retract(), tilts(Tilting::Back(Solution::Control))];
        let mut stream = Stream { settings: settings(target), items };
        stream.settings.machine.tilt_axes = AxisSet::EMPTY;
        assert_eq!(validate(&stream, None, &mut as_it_is).is_none(), euler, "{target}");
        let items = vec![retract(), plane([10.003, 20.0004, 30.0004], [0.0; 3], Solution::Control)];
        let mut stream = Stream { settings: settings(target), items };
        assert!(validate(&stream, None, &mut as_it_is).is_some(), "{target}");
        stream.settings.output.decimals.angle = Some(2);
        assert!(validate(&stream, None, &mut as_it_is).is_none(), "{target}: two places");
    }
    let stream = Stream { settings: settings("linuxcnc"), items: vec![retract(), tilt()] };
    assert!(validate(&stream, None, &mut as_it_is).is_none());
}

/// Any plane, in millimetres and inches, is printed as it is meant.
#[test]
fn random_planes_are_printed_as_they_are_meant() {
    let mut dice = Dice(0x51a7_e11e_d51a_7e11);
    for n in 0..4000 {
        let mut settings = settings(TARGETS[n % 4]);
        if dice.one_in(2) {
            settings.output.units = crate::machine::settings::Units::Inches;
        }
        let mut items = vec![Item::Function(Function::ToolChange { number: 3 }), retract()];
        for _ in 0..3 {
            let grain = dice.of(&[45.0, 15.0, 0.001, 1e-7]);
            let angles = [0; 3].map(|_| ((dice.part() * 720.0 - 360.0) / grain).round() * grain);
            let origin = [0; 3].map(|_| if dice.one_in(3) { 0.0 } else { dice.part() * 400.0 - 200.0 });
            let solution = dice.of(&[
                Solution::Control,
                Solution::Primary { positive: true },
                Solution::Primary { positive: false },
                Solution::Reference { greater: false },
            ]);
            items.push(plane(angles, origin, solution));
            items.push(rapid(&[(Axis::X, 1.0), (Axis::Y, -2.0)]));
            items.push(rapid(&[(Axis::X, 1.0), (Axis::Y, -2.0), (Axis::Z, 7.5)]));
            match dice.roll(3) {
                0 => items.extend([retract()]),
                1 => items.extend([tilts(Tilting::Off), retract()]),
                _ => items.extend([retract(), tilts(Tilting::Back(solution)), rapid(&[(Axis::Z, 3.0)]), retract()]),
            }
        }
        let stream = Stream { settings, items };
        let outcome = validate(&stream, None, &mut as_it_is).unwrap_or_else(|| panic!("stream {n} is refused"));
        assert!(outcome.mismatch.is_none(), "{n}: {:?}\n{}", outcome.mismatch, outcome.pieces.concat());
    }
}

/// What one piece of the text becomes, where it has something to change.
type Fault = fn(&str) -> Option<String>;

fn other(text: &str, a: &str, b: &str) -> Option<String> {
    text.contains(a).then(|| text.replacen(a, b, 1))
}

/// Without the first line that begins so; in a dialog, the numbers stay right.
fn less(text: &str, begin: &str) -> Option<String> {
    let bare = |line: &str| line.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ').to_owned();
    let numbered = text.starts_with(|c: char| c.is_ascii_digit());
    let lines: Vec<&str> = text.lines().collect();
    let at = lines.iter().position(|line| if numbered { bare(line) } else { (*line).to_owned() }.starts_with(begin))?;
    let kept = lines.iter().enumerate().filter(|(i, _)| *i != at).map(|(i, line)| match line.split_once(' ') {
        Some((number, rest)) if numbered && i > at => format!("{} {rest}\n", number.parse::<u64>().unwrap_or(0) - 1),
        _ => format!("{line}\n"),
    });
    Some(kept.collect())
}

#[test]
fn faults_in_a_plane_are_noticed() {
    let euler: &[(&str, Fault)] = &[
        ("sign of K", |t| other(t, "K-90.", "K90.")),
        ("sign of J", |t| other(t, "J45.", "J-45.")),
        ("I and K swapped", |t| other(t, "I90. J45. K-90.", "I-90. J45. K90.")),
        ("origin in X", |t| other(t, "X50.", "X50.001")),
        ("origin in Z", |t| other(t, "Z20.", "Z-20.")),
        ("no origin", |t| other(t, " X50. Y0. Z20.", "")),
        ("G53.1 missing", |t| less(t, "G53.1")),
        ("G53.1 twice", |t| other(t, "G53.1\n", "G53.1\nG53.1\n")),
        ("G69 missing", |t| less(t, "G69")),
        ("G49 missing", |t| less(t, "G49")),
        ("no length again", |t| t.contains("Z3.").then(|| t.replace("G43 ", "").replace(" H1", ""))),
        ("an axis that does not turn back", |t| other(t, "A0. C0.", "A0.")),
        ("another axis", |t| other(t, "A0. C0.", "B0. C0.")),
        ("turned elsewhere", |t| other(t, "A0. C0.", "A0. C180.")),
        ("a plane in a cutting move", |t| other(t, "G1 Z-10.", "G69\nG1 Z-10.")),
        ("a move in between", |t| other(t, "G53.1\n", "G0 X1.\nG53.1\n")),
        ("plane forgotten", |t| t.contains("G68.2").then(String::new)),
        ("way back forgotten", |t| t.contains("A0. C0.").then(String::new)),
    ];
    let swivel: &[(&str, Fault)] = &[
        ("sign of an angle", |t| other(t, ",45,0,", ",-45,0,")),
        ("A and C swapped", |t| other(t, ",0,0,-15,", ",-15,0,0,")),
        ("origin", |t| other(t, ",50,0,20,", ",50,0,20.001,")),
        ("direction", |t| other(t, ",0,1,0,1)", ",0,-1,0,1)")),
        ("direction back", |t| other(t, ",0,-1,0,1)", ",0,1,0,1)")),
        ("nothing turns", |t| other(t, ",0,1,0,1)", ",0,0,0,1)")),
        ("record", |t| other(t, "TC1", "TC2")),
        ("order", |t| other(t, ",27,", ",57,")),
        ("additive", |t| other(t, "\",0,", "\",1,")),
        ("an argument less", |t| other(t, ",0,1)", ",1)")),
        ("plane forgotten", |t| t.contains("CYCLE800(0,\"TC1\",0,27").then(String::new)),
        ("end forgotten", |t| t.contains("CYCLE800()").then(String::new)),
        ("way back forgotten", |t| t.contains(",57,").then(String::new)),
        ("only ended", |t| t.contains(",57,").then(|| "CYCLE800()\n".to_owned())),
    ];
    let dialog: &[(&str, Fault)] = &[
        ("sign of SPB", |t| other(t, "SPB+45", "SPB-45")),
        ("A and B swapped", |t| other(t, "SPA+0 SPB+45", "SPA+45 SPB+0")),
        ("origin", |t| other(t, "X+50", "X+50.001")),
        ("origin in another axis", |t| other(t, "Z+20", "Z+0")),
        ("SEQ flipped", |t| other(t, "SEQ+", "SEQ-")),
        ("SEQ forgotten", |t| other(t, " SEQ+", "")),
        ("SEQ invented", |t| other(t, "SPA-15 SPB+0 SPC+0 TURN FMAX", "SPA-15 SPB+0 SPC+0 TURN FMAX SEQ-")),
        ("axes stay", |t| other(t, "SPC+0 TURN FMAX", "SPC+0 STAY")),
        ("reset forgotten", |t| t.contains("SPA-15").then(|| less(t, "PLANE RESET")).flatten()),
        ("reset that turns", |t| (!t.contains("SPA")).then(|| other(t, "RESET STAY", "RESET TURN FMAX")).flatten()),
        ("reset that stays", |t| other(t, "RESET TURN FMAX", "RESET STAY")),
        ("shift not taken back", |t| other(t, "7.1 X+0", "7.1 X+50")),
        ("half a shift", |t| less(t, "CYCL DEF 7.3")),
        ("plane forgotten", |t| less(t, "PLANE SPATIAL")),
    ];
    for target in TARGETS {
        let faults = match target {
            "sinumerik" => swivel,
            "heidenhain" => dialog,
            _ => euler,
        };
        let stream = hole(target);
        for (name, fault) in faults {
            let mut changed = false;
            let outcome = validate(&stream, None, &mut |n, text| {
                let new = if n == 0 || changed { None } else { fault(text) };
                changed |= new.is_some();
                new
            });
            assert!(changed, "{target}: {name} changes nothing");
            assert!(outcome.is_some_and(|outcome| outcome.mismatch.is_some()), "{target}: {name} is not noticed");
        }
    }
}
