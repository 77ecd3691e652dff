//! The worked examples of docs/compensation.md that no dialect says alone, and what all of them rely on.

use std::rc::Rc;

use super::super::machine_axes::MachineAxes;
use super::*;
use crate::diag::Diags;
use crate::geo::{Point2, arc};
use crate::ir::Feed;
use crate::ir::compensation::{Border, Ends, Inside, Search};
use crate::ir::motion;
use crate::ir::motion::Arc;
use crate::machine::AxisSet;
use crate::machine::Machine;

/// Writes what comes out as blocks.
#[derive(Default)]
struct Paper {
    lines: Vec<String>,
}

fn number(v: f64) -> String {
    let text = format!("{:.4}", v + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

impl motion::Sink for Paper {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        assert_eq!(mv.side, Side::None);
        let to = mv.end.in_plane(Plane::Xy).expect("a place");
        let z = mv.axes.iter().any(|axis| axis == crate::machine::Axis::Z);
        let z = if z {
            format!(" Z{}", number(mv.end.get(crate::machine::Axis::Z).expect("a height")))
        } else {
            String::new()
        };
        let (x, y) = (number(to.x), number(to.y));
        self.lines.push(match &mv.path {
            Path::Arc(arc, _) => {
                let g = if arc.sweep > 0.0 { 3 } else { 2 };
                let (i, j) = (number(arc.center.x - arc.from.x), number(arc.center.y - arc.from.y));
                format!("G{g} X{x} Y{y}{z} I{i} J{j}")
            }
            Path::Rapid => format!("G0 X{x} Y{y}{z}"),
            _ => format!("G1 X{x} Y{y}{z}"),
        });
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        self.lines.push(format!("{function:?}"));
    }

    fn lost(&mut self, _: &Origin) {
        self.lines.push("lost".to_owned());
    }
}

type Change = fn(&mut Compensation);

/// Elements of a program in the plane.
#[derive(Clone, Copy)]
enum To {
    Line(f64, f64),
    /// End, centre, sense.
    Arc(f64, f64, f64, f64, bool),
    Z(f64),
    /// A line that moves Z, too.
    Space(f64, f64, f64),
}
use To::{Line, Z};

struct Program {
    side: Side,
    rules: Compensation,
    start: (f64, f64),
    /// Each with what changes the rules for it.
    contour: Vec<(To, Change)>,
    end: To,
}

fn same(_: &mut Compensation) {}

impl Program {
    fn new(side: Side, radius: f64, start: (f64, f64), contour: &[To], end: To) -> Program {
        let contour = contour.iter().map(|to| (*to, same as fn(&mut Compensation))).collect();
        Program { side, rules: Compensation { radius, ..Default::default() }, start, contour, end }
    }

    fn run(&self) -> (Vec<String>, Vec<String>) {
        let (diags, machine) = (Diags::default(), Machine::default());
        let mut paper = Paper::default();
        let mut compensator = Compensator::default();
        let mut at = Pos::UNKNOWN;
        at.set_in_plane(Plane::Xy, Point2::new(self.start.0, self.start.1));
        at.set(crate::machine::Axis::Z, 0.0);
        let mut machine_axes = MachineAxes::default();
        let mut out = Out { diags: &diags, machine: &machine, sink: &mut paper, machine_axes: &mut machine_axes };
        let steps = self.contour.iter().map(|(to, change)| (*to, *change, self.side));
        for (to, change, side) in steps.chain([(self.end, same as fn(&mut Compensation), Side::None)]) {
            let mut rules = self.rules;
            change(&mut rules);
            let mut mv =
                Move { end: at, plane: Plane::Xy, side, path: Path::Line(Feed::PerMinute(100.0)), ..Move::default() };
            let from = at.in_plane(Plane::Xy).expect("a place");
            match to {
                Line(x, y) => {
                    mv.end.set_in_plane(Plane::Xy, Point2::new(x, y));
                    mv.axes = super::super::step::plane_axes(Plane::Xy);
                }
                To::Arc(x, y, cx, cy, ccw) => {
                    let (to, center) = (Point2::new(x, y), Point2::new(cx, cy));
                    mv.end.set_in_plane(Plane::Xy, to);
                    mv.axes = super::super::step::plane_axes(Plane::Xy);
                    let sweep = arc::sweep(from, to, center, ccw);
                    mv.path = Path::Arc(Arc { plane: Plane::Xy, from, center, sweep }, Feed::PerMinute(100.0));
                }
                To::Space(x, y, z) => {
                    mv.end.set_in_plane(Plane::Xy, Point2::new(x, y));
                    mv.end.set(crate::machine::Axis::Z, z);
                    mv.axes = AxisSet::MAIN;
                }
                Z(z) => {
                    mv.end.set(crate::machine::Axis::Z, z);
                    mv.axes = AxisSet::of(crate::machine::Axis::Z);
                }
            }
            compensator.movement(&mv, &at, Some(&Rc::new(rules)), &Origin::default(), &mut out);
            at = mv.end;
        }
        compensator.finish(&mut out);
        let found = diags.into_sorted().iter().map(|found| found.code.id.to_owned()).collect();
        (paper.lines, found)
    }

    fn path(&self) -> Vec<String> {
        self.run().0
    }
}

const STEP: &[To] =
    &[Line(0.0, 0.0), Line(50.0, 0.0), Line(50.0, -0.5), Line(150.0, -0.5), Line(150.0, 0.0), Line(200.0, 0.0)];

#[test]
fn a_step_smaller_than_the_tool() {
    let mut program = Program::new(Side::Left, 20.0, (-50.0, 20.0), STEP, Line(250.0, 20.0));
    let (lines, found) = program.run();
    assert_eq!((lines.last().map(String::as_str), found), (Some("G1 X250 Y20"), vec!["G3202".to_owned()]));
    program.rules.search = Search { elements: 10, bottlenecks: false };
    let trimmed = [
        "G1 X0 Y20",
        "G1 X50 Y20",
        "G2 X54.4441 Y19.5 I0 J-20",
        "G1 X145.5559 Y19.5",
        "G2 X150 Y20 I4.4441 J-19.5",
        "G1 X200 Y20",
        "G1 X250 Y20",
    ];
    let (lines, found) = program.run();
    assert_eq!((lines, found), (trimmed.map(str::to_owned).to_vec(), vec!["G3210".to_owned(); 1]));
    // M97 at both outside corners.
    program.rules.search = Search::default();
    let prolonged: fn(&mut Compensation) = |rules| rules.outside.prolonged = crate::geo::Deg(180.0);
    program.contour = STEP.iter().map(|to| (*to, same as fn(&mut Compensation))).collect();
    (program.contour[1].1, program.contour[4].1) = (prolonged, prolonged);
    let stepped =
        ["G1 X0 Y20", "G1 X70 Y20", "G1 X70 Y19.5", "G1 X130 Y19.5", "G1 X130 Y20", "G1 X200 Y20", "G1 X250 Y20"];
    assert_eq!(program.path(), stepped);
}

#[test]
fn a_short_side_at_an_inside_corner_is_left_out() {
    let contour = [Line(0.0, 0.0), Line(40.0, 0.0), Line(42.0, 3.0), Line(42.0, 40.0)];
    let mut program = Program::new(Side::Left, 5.0, (-20.0, 5.0), &contour, Line(20.0, 50.0));
    assert_eq!(program.run().1, ["G3202"]);
    program.rules.search.elements = 3;
    let (lines, found) = program.run();
    assert_eq!(lines, ["G1 X0 Y5", "G1 X37 Y5", "G1 X37 Y40", "G1 X20 Y50"]);
    assert_eq!(found, ["G3210"]);
}

#[test]
fn other_axes_of_an_element_that_is_left_out_move_at_the_crossing() {
    let contour = [Line(0.0, 0.0), Line(40.0, 0.0), To::Space(42.0, 3.0, -3.0), Z(-4.0), Line(42.0, 40.0)];
    let mut program = Program::new(Side::Left, 5.0, (-20.0, 5.0), &contour, Line(20.0, 50.0));
    program.rules.search.elements = 3;
    let path = ["G1 X0 Y5", "G1 X37 Y5", "G1 X37 Y5 Z-3", "G1 X37 Y5 Z-4", "G1 X37 Y40", "G1 X20 Y50"];
    assert_eq!(program.path(), path);
}

#[test]
fn a_notch_narrower_than_the_tool_is_passed_over() {
    let contour = [Line(0.0, 0.0), Line(30.0, 0.0), Line(33.0, -4.0), Line(36.0, 0.0), Line(70.0, 0.0)];
    let mut program = Program::new(Side::Left, 5.0, (-20.0, 5.0), &contour, Line(80.0, 5.0));
    assert_eq!(program.run().1, ["G3202"]);
    program.rules.search.elements = 3;
    let (lines, found) = program.run();
    let passed = ["G1 X0 Y5", "G1 X30 Y5", "G2 X33 Y4 I0 J-5", "G2 X36 Y5 I3 J-4", "G1 X70 Y5", "G1 X80 Y5"];
    assert_eq!((lines, found), (passed.map(str::to_owned).to_vec(), vec!["G3210".to_owned()]));
}

#[test]
fn the_way_around_the_start_and_the_end() {
    let contour = [Line(10.0, 10.0), Line(10.0, 60.0), Line(50.0, 30.0), Line(10.0, 10.0)];
    let mut program = Program::new(Side::Left, 5.0, (35.0, 0.0), &contour, Line(-20.0, 50.0));
    (program.rules.approach, program.rules.retract) = (Border::Around, Border::Around);
    let around = [
        "G1 X9.0374 Y5.0935",
        "G2 X5 Y10 I0.9626 J4.9065",
        "G1 X5 Y60",
        "G2 X13 Y64 I5 J0",
        "G1 X53 Y34",
        "G2 X52.2361 Y25.5279 I-3 J-4",
        "G1 X12.2361 Y5.5279",
        "G2 X5.7201 Y7.415 I-2.2361 J4.4721",
        "G1 X-20 Y50",
    ];
    assert_eq!(program.path(), around);
}

#[test]
fn border_elements_prolonged() {
    let contour = [Line(50.0, 5.0), Line(50.0, 0.0), Line(30.0, 0.0), Line(20.0, -5.0)];
    let mut program = Program::new(Side::Right, 10.0, (0.0, 20.0), &contour, Line(0.0, 0.0));
    program.rules.search.elements = 3;
    assert_eq!(program.run().1, ["G3202"]);
    program.rules.ends = Ends::Circle;
    let rest = ["G1 X30 Y10", "G3 X25.5279 Y8.9443 I0 J-10", "G1 X15.5279 Y3.9443", "G1 X0 Y0"];
    assert_eq!(program.path(), [&["G1 X41.3397 Y10"], &rest[..]].concat());
    program.rules.ends = Ends::Tangent;
    assert_eq!(program.path(), [&["G1 X40 Y10"], &rest[..]].concat());
    // The same backwards, on the other side: the last element does not meet the one before.
    let contour = [Line(20.0, -5.0), Line(30.0, 0.0), Line(50.0, 0.0), Line(50.0, 5.0)];
    let mut back = Program::new(Side::Left, 10.0, (0.0, 0.0), &contour, Line(0.0, 20.0));
    back.rules = Compensation { ends: Ends::Circle, ..program.rules };
    let path =
        ["G1 X15.5279 Y3.9443", "G1 X25.5279 Y8.9443", "G2 X30 Y10 I4.4721 J-8.9443", "G1 X41.3397 Y10", "G1 X0 Y20"];
    assert_eq!(back.path(), path);
}

#[test]
fn a_constant_offset() {
    let contour = [
        Line(20.0, 0.0),
        Line(30.0, 0.0),
        Line(30.0, 20.0),
        Line(10.0, 20.0),
        Line(10.0, 30.0),
        Line(-10.0, 30.0),
        Line(-10.0, 20.0),
    ];
    let mut program = Program::new(Side::Right, 10.0, (0.0, 0.0), &contour, Line(0.0, 0.0));
    for i in [3, 4] {
        program.contour[i].1 = |rules| rules.constant = true;
    }
    program.contour[5].1 = |rules| rules.approach = Border::Around;
    let path = [
        "G1 X20 Y-10",
        "G1 X30 Y-10",
        "G3 X40 Y0 I0 J10",
        "G1 X40 Y20",
        "G1 X20 Y20",
        "G1 X20 Y30",
        "G3 X10 Y40 I-10 J0",
        "G1 X-10 Y40",
        "G3 X-20 Y30 I0 J-10",
        "G1 X-20 Y20",
        "G1 X0 Y0",
    ];
    assert_eq!(program.path(), path);
}

#[test]
fn a_corner_left_open_and_one_shortened() {
    let contour = [Line(0.0, 40.0), Line(0.0, 0.0), Line(30.0, 0.0)];
    let mut program = Program::new(Side::Left, 5.0, (20.0, 60.0), &contour, Line(50.0, 20.0));
    assert_eq!(program.path(), ["G1 X5 Y40", "G1 X5 Y5", "G1 X30 Y5", "G1 X50 Y20"]);
    program.contour[1].1 = |rules| rules.inside = Inside::Open;
    assert_eq!(program.path(), ["G1 X5 Y40", "G1 X5 Y0", "G1 X0 Y5", "G1 X30 Y5", "G1 X50 Y20"]);
    let contour = [Line(0.0, 0.0), Line(40.0, 0.0), Line(40.0, -30.0)];
    let mut program = Program::new(Side::Left, 10.0, (-20.0, 10.0), &contour, Line(80.0, -40.0));
    program.contour[1].1 = |rules| rules.outside.by = Some(4.0);
    assert_eq!(program.path()[1..4], ["G1 X44 Y10", "G2 X50 Y4 I0 J-6", "G1 X50 Y-30"]);
    program.contour[1].1 = |rules| rules.outside.by = Some(10.0);
    assert_eq!(program.path()[1..3], ["G1 X50 Y10", "G1 X50 Y-30"]);
    program.contour[1].1 = |rules| rules.outside.by = Some(10.1);
    assert_eq!(program.run().1, ["G3207"]);
}

#[test]
fn what_happens_between_two_elements_happens_at_the_joint() {
    let contour = [Line(0.0, 0.0), Z(-2.0), Line(30.0, 0.0), Z(-5.0), Line(30.0, 30.0), Z(-7.0), Line(50.0, 30.0)];
    let program = Program::new(Side::Left, 5.0, (-20.0, 0.0), &contour, Z(50.0));
    let path = [
        "G1 X0 Y5",
        "G1 X0 Y5 Z-2",
        "G1 X25 Y5",
        "G1 X25 Y5 Z-5",
        "G1 X25 Y30",
        "G1 X25 Y30 Z-7",
        "G2 X30 Y35 I5 J0",
        "G1 X50 Y35",
        "G1 X50 Y35 Z50",
    ];
    let (lines, found) = program.run();
    assert_eq!((lines, found), (path.map(str::to_owned).to_vec(), vec!["G3213".to_owned(), "G3212".to_owned()]));
}

#[test]
fn a_bottleneck_is_worth_a_warning() {
    // A pocket whose neck is narrower than the tool.
    let contour = [
        Line(0.0, 0.0),
        Line(30.0, 0.0),
        Line(30.0, -20.0),
        Line(10.0, -20.0),
        Line(10.0, -60.0),
        Line(60.0, -60.0),
        Line(60.0, -20.0),
        Line(37.0, -20.0),
        Line(37.0, 0.0),
        Line(70.0, 0.0),
    ];
    let program = Program::new(Side::Left, 5.0, (-20.0, 5.0), &contour, Line(80.0, 20.0));
    assert_eq!(program.run().1, ["G3211"]);
    let wide: Vec<To> = contour
        .iter()
        .map(|to| match *to {
            Line(x, y) if x >= 37.0 => Line(x + 4.0, y),
            other => other,
        })
        .collect();
    let program = Program::new(Side::Left, 5.0, (-20.0, 5.0), &wide, Line(84.0, 20.0));
    assert_eq!(program.run().1, [""; 0]);
}

#[test]
fn what_cannot_be() {
    let contour = [To::Arc(20.0, 0.0, 10.0, 0.0, true), Line(30.0, 0.0)];
    assert_eq!(Program::new(Side::Left, 5.0, (0.0, 0.0), &contour, Line(50.0, 0.0)).run().1, ["G3203"]);
    let contour = [Line(20.0, 0.0)];
    assert_eq!(Program::new(Side::Left, 5.0, (0.0, 0.0), &contour, Line(50.0, 0.0)).run().1, ["G3204"]);
    let contour = [Line(20.0, 0.0), To::Arc(20.0, 6.0, 20.0, 3.0, true)];
    assert_eq!(Program::new(Side::Left, 5.0, (0.0, 0.0), &contour, Line(50.0, 0.0)).run().1, ["G3201"]);
    assert!(Program::new(Side::Right, 5.0, (0.0, 0.0), &contour, Line(50.0, 0.0)).run().1.is_empty());
    let contour = [Line(20.0, 0.0), Line(40.0, 0.0)];
    let arc = To::Arc(60.0, 0.0, 50.0, 0.0, true);
    assert_eq!(Program::new(Side::Left, 5.0, (0.0, 0.0), &contour, arc).run().1, ["G3203"]);
    assert_eq!(Program::new(Side::Left, 0.0, (0.0, 0.0), &contour, arc).path().len(), 3);
}
