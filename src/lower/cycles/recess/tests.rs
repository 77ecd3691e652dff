use super::*;
use crate::geo::{Vec2, distance};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::tests::{groove, lines};
use crate::ir::cycle::recess::{RecessFeeds, RecessTool};
use crate::ir::cycle::turning::Towards;
use crate::lower::cycles::simulate::{Blank, GRID, StepDown, chain, check_lowering, height, moved_by, samples, step};
use crate::lower::cycles::track::{Move, Path, Stroke};
use proptest::prelude::*;

fn strokes(recess: &RecessTurning, from: Point2) -> Result<Vec<Move>, &'static str> {
    let mut list = Vec::new();
    expand(recess, from, &mut |stroke| {
        if let Stroke::Move(mv) = stroke {
            list.push(mv);
        }
    })
    .map_err(|fault| fault.code().id)?;
    Ok(list)
}

/// Strokes as words with X as a diameter, rounded to four decimals; axes that stay are left out.
fn words(recess: &RecessTurning, from: Point2) -> Vec<String> {
    let mut at = from;
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let word = |letter, new: f64, old: f64| {
        if round(new) == round(old) { String::new() } else { format!(" {letter}{}", round(new)) }
    };
    let mut text = Vec::new();
    for Move { to, path } in strokes(recess, from).expect("a recess") {
        let (head, tail) = match path {
            Path::Rapid => ("G0", String::new()),
            Path::Line { feed } => ("G1", format!(" F{}", feed.value())),
            Path::Arc { ccw, feed, .. } => (if ccw { "G3" } else { "G2" }, format!(" F{}", feed.value())),
            Path::Thread { .. } => ("G33", String::new()),
        };
        text.push(format!("{head}{}{}{tail}", word('X', 2.0 * to.y, 2.0 * at.y), word('Z', to.x, at.x)));
        at = to;
    }
    text
}

const FROM: Point2 = Point2::new(-10.0, 31.0);

#[test]
fn radial_groove_as_computed_by_hand() {
    let expected = [
        "G0 Z-23.1",
        "G1 X56.1333 F0.08",
        "G1 Z-31.9 F0.15",
        "G1 X52.2667 F0.08",
        "G1 Z-23.4 F0.15",
        "G1 X48.4 F0.08",
        "G1 Z-31.6 F0.15",
        "G0 X62",
        "G0 Z-23.1",
        "G1 X48.4 F0.08",
        "G0 X62",
        "G0 Z-31.9",
        "G1 X48.4 F0.08",
        "G0 X62",
    ];
    assert_eq!(words(&groove(), FROM), expected);
}

#[test]
fn one_way_lifts_and_goes_back() {
    let recess = RecessTurning { passes: Passes::OneWay, ..groove() };
    let expected = [
        "G0 Z-23.1",
        "G1 X56.1333 F0.08",
        "G1 Z-31.9 F0.15",
        "G0 X62",
        "G0 Z-23.1",
        "G0 X58.1333",
        "G1 X52.2667 F0.08",
        "G1 Z-31.9 F0.15",
    ];
    assert_eq!(words(&recess, FROM)[..8], expected);
}

#[test]
fn finishing_cuts_both_walls_down_and_meets_on_the_floor() {
    let recess = RecessTurning { operation: Operation::Finish, end: RecessEnd::Start, ..groove() };
    let plain = [
        "G0 Z-23",
        "G1 X48 F0.1",
        "G1 Z-31.9 F0.1",
        "G0 X62",
        "G0 Z-32",
        "G1 X48 F0.1",
        "G1 Z-31.9 F0.1",
        "G0 X62",
        "G0 Z-10",
    ];
    assert_eq!(words(&recess, FROM), plain);
    let bent = RecessTurning { compensation: 0.05, end: RecessEnd::Front, ..recess };
    let expected = ["G0 Z-23", "G1 X48 F0.1", "G1 X48.1 F0.1", "G1 Z-31.9 F0.1"];
    assert_eq!(words(&bent, FROM)[..4], expected);
    assert_eq!(words(&bent, FROM).last().map(String::as_str), Some("G0 Z-20"));
}

#[test]
fn the_offset_width_is_limited() {
    // 80 % of the effective width of 2.6 is 2.08, for one turned cut at each wall.
    let wide = RecessTurning { offset_width: 9.0, ..groove() };
    assert_eq!(words(&wide, FROM)[4], "G1 Z-25.18 F0.15");
    // Five levels: two cuts at the second wall share it.
    let deep = RecessTurning { offset_width: 9.0, most: 1.2, ..groove() };
    let list = words(&deep, FROM);
    assert_eq!((list[4].as_str(), list[8].as_str()), ("G1 Z-24.14 F0.15", "G1 Z-25.18 F0.15"));
    // No effective width, no offset, no cleaning cut.
    let round = RecessTurning { tool: RecessTool { width: 3.0, nose: 1.5, edge: 0.0 }, ..groove() };
    assert_eq!(words(&round, FROM)[4], "G1 Z-23.1 F0.15");
    assert_eq!(words(&round, FROM).len(), 8);
}

#[test]
fn the_reference_point_may_be_either_edge() {
    let right = RecessTurning { tool: RecessTool { width: 3.0, nose: 0.2, edge: -3.0 }, ..groove() };
    assert_eq!(words(&right, FROM)[..3], ["G0 Z-20.1", "G1 X56.1333 F0.08", "G1 Z-28.9 F0.15"]);
    let back =
        RecessTurning { contour: lines(&[(-32.0, 60.0), (-32.0, 48.0), (-20.0, 48.0), (-20.0, 60.0)]), ..groove() };
    assert_eq!(words(&back, FROM)[..3], ["G0 Z-31.9", "G1 X56.1333 F0.08", "G1 Z-23.1 F0.15"]);
}

#[test]
fn strokes_side_by_side() {
    // From Z-23.1 to Z-31.9 are 8.8 mm: four gaps of at most 2.4.
    let recess = RecessTurning { passes: Passes::Strokes { width: 2.4, dwell: 0.0 }, ..groove() };
    let mut expected = Vec::new();
    for z in ["-23.1", "-25.3", "-27.5", "-29.7", "-31.9"] {
        expected.extend([format!("G0 Z{z}"), "G1 X48.4 F0.08".to_owned(), "G0 X62".to_owned()]);
    }
    assert_eq!(words(&recess, FROM), expected);
    // A groove as wide as the tool takes one stroke.
    let contour = lines(&[(-20.0, 60.0), (-20.0, 48.0), (-23.0, 48.0), (-23.0, 60.0)]);
    let narrow = RecessTurning { contour, oversize: Vec2::zeros(), ..recess };
    assert_eq!(words(&narrow, FROM), ["G0 Z-23", "G1 X48 F0.08", "G0 X62"]);
}

#[test]
fn the_tool_waits_at_the_floor() {
    let passes = Passes::Strokes { width: 2.4, dwell: 0.5 };
    let recess = RecessTurning { operation: Operation::RoughAndFinish, passes, ..groove() };
    let mut count = 0;
    let run = expand(&recess, FROM, &mut |stroke| count += u32::from(stroke == Stroke::Dwell { seconds: 0.5 }));
    // Five strokes, two walls.
    assert_eq!((run, count), (Ok(()), 7));
}

#[test]
fn axial_groove_in_a_face() {
    // X40 to X60, 5 deep, in the front face; the tool is programmed at its edge towards the centre.
    let recess = RecessTurning {
        contour: lines(&[(0.0, 60.0), (-5.0, 60.0), (-5.0, 40.0), (0.0, 40.0)]),
        into: Towards::MinusZ,
        blank: 0.0,
        oversize: Vec2::zeros(),
        most: 2.5,
        offset_width: 0.0,
        ..groove()
    };
    let expected = ["G0 Z1", "G0 X54", "G1 Z-2.5 F0.08", "G1 X40 F0.15", "G1 Z-5 F0.08", "G1 X54 F0.15", "G0 Z1"];
    let mut list = words(&recess, Point2::new(2.0, 30.0));
    list.swap(0, 1);
    assert_eq!(list, expected.map(str::to_owned).to_vec());
}

#[test]
fn a_bored_groove_is_the_outer_one_turned_over() {
    let outer = groove();
    let over = |p: Point2| Point2::new(p.x, 100.0 - p.y);
    let contour = outer.contour.iter().map(|e| Element::Line { from: over(e.from()), to: over(e.to()) }).collect();
    let inner = RecessTurning { contour, into: Towards::PlusX, blank: 70.0, ..outer.clone() };
    let a = strokes(&outer, FROM).expect("a groove");
    let b = strokes(&inner, over(FROM)).expect("a groove");
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(&b).all(|(a, b)| distance(over(a.to), b.to) < 1e-9));
}

#[test]
fn refused_recesses() {
    let code = |recess: RecessTurning| strokes(&recess, FROM).expect_err("refused");
    let contour = lines(&[(-20.0, 60.0), (-20.0, 48.0), (-32.0, 48.0)]);
    assert_eq!(code(RecessTurning { contour, ..groove() }), "G3044");
    let tool = RecessTool { width: 12.0, nose: 0.2, edge: 0.0 };
    assert_eq!(code(RecessTurning { tool, ..groove() }), "G3045");
    assert_eq!(code(RecessTurning { blank: 24.0, ..groove() }), "G3046");
    assert_eq!(code(RecessTurning { most: 1e-9, ..groove() }), "G3040");
    assert_eq!(code(RecessTurning { most: 0.0, ..groove() }), "G3041");
}

/// The groove in the standard view, on a floor at 0.
#[derive(Debug, Clone)]
struct Shape {
    contour: Vec<Element>,
    /// The two walls, both falling, the second in a mirror.
    walls: [Vec<Element>; 2],
    rim: f64,
}

fn mirror_back(list: &[Element]) -> Vec<Element> {
    let go = |p: Point2| Point2::new(-p.x, p.y);
    list.iter()
        .rev()
        .map(|e| match *e {
            Element::Line { from, to } => Element::Line { from: go(to), to: go(from) },
            Element::Arc { from, to, center, sweep } => {
                Element::Arc { from: go(to), to: go(from), center: go(center), sweep }
            }
        })
        .collect()
}

fn shape(left: &[StepDown], right: &[StepDown], floor: f64) -> Shape {
    let (a, b) = (chain(left), chain(right));
    let foot = |c: &[Element]| c.last().map_or(Point2::origin(), Element::to);
    let (fa, fb) = (foot(&a), foot(&b));
    let a = moved_by(&a, Vec2::new(0.0, -fa.y));
    // The mirrored wall ends where the floor does.
    let b = moved_by(&b, Vec2::new(-(fa.x + floor) - fb.x, -fb.y));
    let bottom = Element::Line { from: Point2::new(fa.x, 0.0), to: Point2::new(fa.x + floor, 0.0) };
    let mut contour = a.clone();
    contour.push(bottom);
    contour.extend(mirror_back(&b));
    Shape { contour, walls: [a, b], rim: (-fa.y).max(-fb.y) }
}

fn case() -> impl Strategy<Value = (Shape, RecessTurning, View)> {
    let walls = (prop::collection::vec(step(), 1..5), prop::collection::vec(step(), 1..5), 3.0f64..12.0);
    let tool = (1.0f64..2.9, 0.0f64..0.9, 0usize..3);
    let numbers = (0.3f64..3.0, 0.0f64..0.3, 0.0f64..0.3, 0.0f64..1.0, 0.0f64..0.1, 0.0f64..1.0);
    let modes = (0usize..3, 0usize..3, 0usize..4, any::<bool>());
    (walls, tool, numbers, modes).prop_map(|((left, right, floor), (width, nose, edge), numbers, modes)| {
        let (most, along, deep, offset_width, compensation, proud) = numbers;
        let (passes, operation, into, back) = modes;
        let nose = nose * width / 2.0;
        let strokes = Passes::Strokes { width: (0.8 * (width - 2.0 * nose)).max(0.1), dwell: 0.0 };
        let shape = shape(&left, &right, floor);
        let into = [Towards::MinusX, Towards::PlusX, Towards::MinusZ, Towards::PlusZ][into];
        let view = View::new(into, if back { -1.0 } else { 1.0 });
        // Far from the axes, so that no sign is right by chance.
        let place = |p: Point2| view.part(p + Vec2::new(70.0, 50.0));
        let contour = shape
            .contour
            .iter()
            .map(|e| match *e {
                Element::Line { from, to } => Element::Line { from: place(from), to: place(to) },
                Element::Arc { from, to, center, sweep } => Element::Arc {
                    from: place(from),
                    to: place(to),
                    center: place(center),
                    sweep: if view.mirrors() { -sweep } else { sweep },
                },
            })
            .collect();
        let blank = place(Point2::new(0.0, shape.rim + proud));
        let feed = Feed::PerRevolution(0.1);
        let recess = RecessTurning {
            contour,
            into,
            tool: RecessTool { width, nose, edge: [0.0, -width, -width / 2.0][edge] },
            blank: into.depth_coordinate(blank),
            most,
            oversize: if into.is_radial() { Vec2::new(along, deep) } else { Vec2::new(deep, along) },
            offset_width,
            compensation,
            passes: [Passes::OneWay, Passes::BothWays, strokes][passes],
            operation: [Operation::Rough, Operation::RoughAndFinish, Operation::Finish][operation],
            clearance: 1.0,
            feeds: RecessFeeds { plunge: feed, turn: feed, finish: feed },
            end: RecessEnd::Lift,
        };
        (shape, recess, view)
    })
}

fn check_cutting(shape: &Shape, recess: &RecessTurning, view: &View) -> Result<(), TestCaseError> {
    let origin = Vec2::new(70.0, 50.0);
    let start = view.part(Point2::new(-5.0, shape.rim + 3.0) + origin);
    let list = match strokes(recess, start) {
        Ok(list) => list,
        Err("G3045") => return Err(TestCaseError::reject("the tool does not fit")),
        Err(code) => return Err(TestCaseError::fail(code)),
    };
    // From the programmed point to the edge towards -x, in the view.
    let groove = Groove::of(recess).map_err(|_| TestCaseError::fail("a groove"))?;
    let shift = groove.shift;
    let tool = &recess.tool;
    let over = if recess.into.is_radial() { recess.oversize } else { recess.oversize.yx() };
    let finished = |x: f64| height(&shape.walls[0], x).max(height(&shape.walls[1], -x));
    let rough = |x: f64| over.y + height(&shape.walls[0], x - over.x).max(height(&shape.walls[1], -x - over.x));
    let top = view.height(recess.blank) - origin.y;
    let end = shape.contour.last().map_or(0.0, |e| e.to().x);
    let mut blank = Blank { left: -3.0 + GRID * 0.37, columns: Vec::new() };
    blank.columns = vec![top; ((end + 6.0) / GRID) as usize];
    let column = |blank: &Blank, i: usize| blank.left + i as f64 * GRID;
    if recess.operation == Operation::Finish {
        for i in 0..blank.columns.len() {
            blank.columns[i] = top.min(rough(column(&blank, i)));
        }
    }
    let limit = if recess.operation == Operation::Rough { &rough as &dyn Fn(f64) -> f64 } else { &finished };
    let mut at = view.point(start) - origin;
    for mv in &list {
        let seen = Move { to: view.point(mv.to) - origin, path: view_path(view, mv.path, origin) };
        let before = blank.columns.clone();
        for p in samples(at, &seen) {
            let x = p.x - shift;
            let rapid = matches!(mv.path, Path::Rapid);
            let hits: Vec<(usize, f64)> = blank.under(tool, x).map(|(i, up)| (i, p.y + up)).collect();
            for (i, y) in hits {
                let c = column(&blank, i);
                // A rounding of the arithmetic beside an upright wall is a whole wall in height.
                let floor = limit(c).min(limit(c - 1e-6)).min(limit(c + 1e-6));
                prop_assert!(y >= floor - 1e-6 || y >= top, "gouges {} at {c}: {y} under {floor}, {mv:?}", tool.width);
                if rapid {
                    prop_assert!(y >= blank.columns[i] - 1e-6, "rapid into {} at {c}: {mv:?}", blank.columns[i]);
                } else if y < blank.columns[i] {
                    blank.columns[i] = y;
                }
            }
        }
        let levels = !matches!(recess.passes, Passes::Strokes { .. });
        if levels && recess.operation == Operation::Rough {
            // Deeper than the infeed it cuts only the strip that was left standing at a wall.
            let strip = 0.8 * (tool.width - 2.0 * tool.nose) + tool.nose + 2.0 * GRID;
            let reach = (strip / GRID) as usize;
            for i in 0..before.len() {
                let under = before[i] - recess.most - 1e-6;
                let near = i.saturating_sub(reach)..(i + reach + 1).min(before.len());
                let walled = near.into_iter().any(|j| limit(column(&blank, j)) >= under);
                prop_assert!(blank.columns[i] >= under || walled, "too deep at {}: {mv:?}", column(&blank, i));
            }
        }
        at = seen.to;
    }
    check_rest(shape, recess, &blank, limit)
}

fn view_path(view: &View, path: Path, origin: Vec2) -> Path {
    match path {
        Path::Arc { center, ccw, feed } => {
            Path::Arc { center: view.point(center) - origin, ccw: ccw != view.mirrors(), feed }
        }
        other => other,
    }
}

/// What stands at the end is what the tool cannot reach.
fn check_rest(
    shape: &Shape,
    recess: &RecessTurning,
    blank: &Blank,
    limit: &dyn Fn(f64) -> f64,
) -> Result<(), TestCaseError> {
    let tool = &recess.tool;
    let count = blank.columns.len();
    let column = |i: usize| blank.left + i as f64 * GRID;
    let mut reach = vec![f64::INFINITY; count];
    for k in 0..4 * count {
        let x = blank.left + k as f64 * GRID / 4.0;
        let under: Vec<(usize, f64)> = blank.under(tool, x).collect();
        let rest = under.iter().map(|(i, up)| limit(column(*i)) - up).fold(f64::NEG_INFINITY, f64::max);
        for (i, up) in under {
            reach[i] = reach[i].min(rest + up);
        }
    }
    for (i, reach) in reach.iter().enumerate() {
        let c = column(i);
        let steep = [-0.3, -0.1, 0.1, 0.3].iter().any(|d| (limit(c + d) - limit(c)).abs() > 3.0 * d.abs());
        let out = c < shape.contour[0].from().x || c > shape.contour.last().map_or(0.0, |e| e.to().x);
        if steep || out {
            continue;
        }
        let bent = if recess.operation == Operation::Rough { 0.0 } else { recess.compensation };
        let rest = blank.columns[i] - reach.max(limit(c));
        prop_assert!(rest <= bent + 0.15, "{rest} stands at {c}");
    }
    Ok(())
}

/// A groove on which a long arc once became its chord, 0.003 mm too deep at the second wall.
#[test]
fn a_small_rounding_above_an_upright_wall_is_not_gouged() {
    let left = [
        StepDown::Bulge(0.6403022914171055),
        StepDown::Line(1.3918015861454755, 0.0),
        StepDown::Line(1.304413595420839, 0.0),
    ];
    let right = [StepDown::Bulge(0.1), StepDown::Line(0.0, 1.5)];
    let shape = shape(&left, &right, 7.33055456018633);
    let view = View::new(Towards::MinusX, 1.0);
    let recess = RecessTurning {
        contour: moved_by(&shape.contour, Vec2::new(70.0, 50.0)),
        into: Towards::MinusX,
        tool: RecessTool { width: 2.248618495190881, nose: 0.9168178244483085, edge: 0.0 },
        blank: 52.1,
        most: 0.3,
        oversize: Vec2::zeros(),
        offset_width: 0.0,
        compensation: 0.0,
        passes: Passes::BothWays,
        operation: Operation::Rough,
        clearance: 1.0,
        end: RecessEnd::Lift,
        ..groove()
    };
    check_cutting(&shape, &recess, &view).expect("no gouge");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    /// The four promises: no gouge, no rapid in material, no level over the infeed, nothing left but the
    /// oversize and what the tool cannot reach.
    #[test]
    fn random_grooves_are_cut_right((shape, recess, view) in case()) {
        check_cutting(&shape, &recess, &view)?;
        check_lowering(&Cycle::RecessTurning(recess), view.part(Point2::new(65.0, 80.0)))?;
    }
}
