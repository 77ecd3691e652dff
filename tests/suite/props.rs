//! Properties of whole programs: what is printed is what was meant, and two ways to say a thing are equal.

use proptest::prelude::*;

use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::ir::motion::{Move, Path, Sink};
use partc::internals::ir::{Function, Origin};
use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};

use super::common::{compile_bytes, settings};
use super::meant::{Recorder, compare, tolerance};
use super::reader;

fn program(blocks: &[String]) -> String {
    let mut text = "0 BEGIN PGM P MM\n".to_owned();
    for block in blocks {
        text += block;
        text.push('\n');
    }
    text + "END PGM P MM\n"
}

/// Output without the head, which holds a hash of the source.
fn body(text: &str, settings: &Settings) -> Vec<String> {
    let compiled = compile_bytes("P.H", text.as_bytes().to_vec(), "klartext", settings, &NoFiles);
    assert!(!compiled.has_errors(), "{text}\n{:?}", compiled.rendered);
    compiled.output.lines().skip(3).map(str::to_owned).collect()
}

fn recorded(text: &str, settings: &Settings, sink: &mut dyn Sink) {
    let main =
        Opened { name: "P.H".into(), identity: "P".into(), text: Box::new(Memory::new(text.as_bytes().to_vec())) };
    let session = Session::new(main);
    session.lower(dialect::find("klartext").expect("a dialect"), settings, &NoFiles, sink);
}

/// A coordinate as a CAM system writes it.
fn coordinate() -> impl Strategy<Value = f64> {
    (-200_000i32..200_000).prop_map(|n| f64::from(n) / 1000.0)
}

fn angle() -> impl Strategy<Value = f64> {
    (-359_999i32..359_999).prop_map(|n| f64::from(n) / 1000.0)
}

/// A block that always makes sense after a first positioning.
fn block() -> impl Strategy<Value = String> {
    prop_oneof![
        (coordinate(), coordinate()).prop_map(|(x, y)| format!("L X{x:+} Y{y:+}")),
        (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| format!("L X{x:+} Y{y:+} Z{z:+} F500")),
        coordinate().prop_map(|z| format!("L IZ{z:+} FMAX")),
        (coordinate(), coordinate()).prop_map(|(x, y)| format!("L IX{x:+} IY{y:+}")),
        (coordinate(), coordinate()).prop_map(|(x, y)| format!("CC X{x:+} Y{y:+}")),
        (coordinate(), angle()).prop_map(|(r, a)| format!("LP PR{r:+} PA{a:+}")),
        (angle(), any::<bool>()).prop_map(|(a, ccw)| format!("CP PA{a:+} DR{}", if ccw { '+' } else { '-' })),
        (1i32..2_000_000, coordinate(), any::<bool>()).prop_map(|(a, z, ccw)| {
            let sign = if ccw { '+' } else { '-' };
            format!("CP IPA{sign}{} IZ{z:+} DR{sign}", f64::from(a) / 1000.0)
        }),
        (1i32..150_000, 1i32..300_000, any::<bool>(), any::<bool>()).prop_map(|(dx, extra, long, ccw)| {
            // A radius that always reaches.
            let chord = f64::from(dx) / 1000.0;
            let radius = chord / 2.0 + f64::from(extra) / 1000.0;
            format!("CR IX+{chord} R{}{radius:.3} DR{}", if long { '-' } else { '+' }, if ccw { '+' } else { '-' })
        }),
        any::<bool>().prop_map(|ccw| format!("C DR{}", if ccw { '+' } else { '-' })),
    ]
}

fn blocks() -> impl Strategy<Value = Vec<String>> {
    prop::collection::vec(block(), 1..30).prop_map(|mut list| {
        list.insert(0, "CC X+1000 Y+1000".to_owned());
        list.insert(0, "L X+10 Y+20 Z+5 R0 F800".to_owned());
        list
    })
}

/// Transformations that keep circles.
fn transformation() -> impl Strategy<Value = Vec<String>> {
    (coordinate(), coordinate(), angle(), 0usize..4, 1i32..5000).prop_map(|(x, y, a, mirror, scale)| {
        let axes = ["", "X", "Y", "X Y"][mirror];
        vec![
            "CYCL DEF 7.0 DATUM SHIFT".to_owned(),
            format!("CYCL DEF 7.1 X{x:+} Y{y:+}"),
            "CYCL DEF 8.0 MIRROR IMAGE".to_owned(),
            format!("CYCL DEF 8.1 {axes}"),
            "CYCL DEF 10.0 ROTATION".to_owned(),
            format!("CYCL DEF 10.1 ROT{a:+}"),
            "CYCL DEF 11.0 SCALING".to_owned(),
            format!("CYCL DEF 11.1 SCL {}", f64::from(scale) / 1000.0),
        ]
    })
}

/// Arcs that touch their neighbours, checked move by move.
#[derive(Default)]
struct Tangents {
    last: Option<[f64; 2]>,
    worst: f64,
    at: Option<[f64; 2]>,
    arcs: u32,
}

impl Sink for Tangents {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        let Some(to) = mv.end.in_plane(mv.plane) else { return };
        let from = self.at.replace([to.x, to.y]);
        let unit = |x: f64, y: f64| [x / x.hypot(y), y / x.hypot(y)];
        let (start, end) = match (&mv.path, from) {
            (Path::Arc(arc, _), _) => {
                let sign = arc.sweep.signum();
                let tangent = |x: f64, y: f64| unit(-(y - arc.center.y) * sign, (x - arc.center.x) * sign);
                (Some(tangent(arc.from.x, arc.from.y)), Some(tangent(to.x, to.y)))
            }
            (_, Some([x, y])) if (to.x - x).hypot(to.y - y) > 1e-6 => {
                let dir = unit(to.x - x, to.y - y);
                (Some(dir), Some(dir))
            }
            _ => return,
        };
        self.arcs += u32::from(matches!(mv.path, Path::Arc(..)));
        if let (Some(last), Some(start)) = (self.last, start) {
            self.worst = self.worst.max((last[0] - start[0]).hypot(last[1] - start[1]));
        }
        self.last = end;
    }

    fn function(&mut self, _: &Function, _: &Origin) {}
    fn lost(&mut self, _: &Origin) {}
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// The printed program, read back by a reader that knows nothing of the printer, is the path that was meant.
    #[test]
    fn printed_is_meant(list in blocks(), frame in prop::option::of(transformation())) {
        let mut all = frame.unwrap_or_default();
        all.extend(list);
        let text = program(&all);
        let settings = Settings::default();
        let compiled = compile_bytes("P.H", text.as_bytes().to_vec(), "klartext", &settings, &NoFiles);
        let codes = compiled.codes();
        // A random arc may start on its own centre.
        prop_assume!(!codes.iter().any(|code| matches!(*code, "G3014" | "K2110" | "O4001" | "O4002")));
        prop_assert!(!compiled.has_errors(), "{text}\n{:?}", compiled.rendered);
        let mut recorder = Recorder::new(&settings);
        recorded(&text, &settings, &mut recorder);
        let found = reader::read(&compiled.output, 4).map_err(TestCaseError::fail)?;
        compare(&found, &recorder.finish(), tolerance(4)).map_err(|why| TestCaseError::fail(format!("{why}\n{text}\n{}", compiled.output)))?;
    }

    /// A section repeat is the same as the section written out.
    #[test]
    fn repeat_is_unrolled(list in blocks(), times in 0usize..4) {
        let mut rolled = vec!["L X+10 Y+20 Z+5 R0 F800".to_owned(), "LBL 1".to_owned()];
        rolled.extend(list.clone());
        rolled.push(format!("CALL LBL 1 REP {times}"));
        let mut flat = vec!["L X+10 Y+20 Z+5 R0 F800".to_owned()];
        for _ in 0..=times {
            flat.extend(list.clone());
        }
        let settings = Settings::default();
        let go = |blocks: &[String]| {
            let compiled = compile_bytes("P.H", program(blocks).into_bytes(), "klartext", &settings, &NoFiles);
            (compiled.has_errors(), compiled.output.lines().skip(3).map(str::to_owned).collect::<Vec<_>>())
        };
        prop_assert_eq!(go(&rolled), go(&flat));
    }

    /// Polar and Cartesian words for the same point print the same.
    #[test]
    fn polar_is_cartesian(x in coordinate(), y in coordinate(), r in 1i32..100_000, a in angle()) {
        let r = f64::from(r) / 1000.0;
        let (sin, cos) = partc::internals::geo::Deg(a).sin_cos();
        let settings = Settings::default();
        let polar = program(&[format!("CC X{x:+} Y{y:+}"), format!("LP PR+{r} PA{a:+} R0 F100")]);
        let cartesian = program(&[
            format!("Q1 = {x} + {r} * {cos:.15}").replace("+ -", "- "),
            format!("Q2 = {y} + {r} * {sin:.15}").replace("+ -", "- "),
            "L X+Q1 Y+Q2 R0 F100".to_owned(),
        ]);
        prop_assert_eq!(body(&polar, &settings), body(&cartesian, &settings));
    }

    /// A rounding touches both neighbours; so do tangential arcs.
    #[test]
    fn roundings_are_tangent(turn in 10i32..170, flip in any::<bool>(), radius in 1i32..3000, a in angle(), arc in any::<bool>()) {
        let start = partc::internals::geo::Deg(a).unit() * 50.0;
        let side = if flip { -f64::from(turn) } else { f64::from(turn) };
        let end = partc::internals::geo::Deg(a + 180.0 - side).unit() * 60.0;
        let second = if arc {
            // An arc that leaves the corner in the same direction as the line would.
            format!("CR X{:+.4} Y{:+.4} R+200 DR{}", end.x, end.y, if flip { '-' } else { '+' })
        } else {
            format!("L X{:+.4} Y{:+.4}", end.x, end.y)
        };
        let text = program(&[
            format!("L X{:+.4} Y{:+.4} R0 F100", start.x, start.y),
            "L X+0 Y+0".to_owned(),
            format!("RND R{}", f64::from(radius) / 1000.0),
            second,
        ]);
        let mut tangents = Tangents::default();
        recorded(&text, &Settings::default(), &mut tangents);
        prop_assert!(arc || tangents.arcs == 1, "{text}");
        prop_assert!(tangents.worst < 1e-6, "{} {text}", tangents.worst);
    }

    /// Mirroring twice in the same axis is no mirror, and four quarter turns are none.
    #[test]
    fn transformations_undo_each_other(list in blocks()) {
        let settings = settings("");
        let plain = {
            let compiled = compile_bytes("P.H", program(&list).into_bytes(), "klartext", &settings, &NoFiles);
            prop_assume!(!compiled.has_errors());
            compiled.output
        };
        let mut turned = Vec::new();
        for _ in 0..4 {
            turned.push("CYCL DEF 10.0 ROTATION".to_owned());
            turned.push("CYCL DEF 10.1 IROT+90".to_owned());
        }
        turned.push("CYCL DEF 8.0 MIRROR IMAGE".to_owned());
        turned.push("CYCL DEF 8.1 X".to_owned());
        turned.push("CYCL DEF 8.0 MIRROR IMAGE".to_owned());
        turned.push("CYCL DEF 8.1".to_owned());
        turned.extend(list);
        let plain: Vec<String> = plain.lines().skip(3).map(str::to_owned).collect();
        prop_assert_eq!(body(&program(&turned), &settings), plain);
    }
}
