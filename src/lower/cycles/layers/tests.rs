use super::*;
use crate::geo::Element;
use crate::ir::cycle::layers::{Allowance, Blank, Clearance, LayerFeeds, Limits, Relief, Segmentation, Trace};
use crate::ir::cycle::recess::tests::lines;
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::turning::Towards;
use crate::lower::cycles::track::{Move, Path, Stroke};

/// A shaft of steps with a cone, points as (Z, X diameter).
fn shaft() -> Layers {
    let feed = Feed::PerRevolution(0.25);
    Layers {
        contour: lines(&[(0.0, 20.0), (-15.0, 20.0), (-25.0, 32.0), (-40.0, 32.0), (-40.0, 50.0)]),
        into: Towards::MinusX,
        along: -1.0,
        nose: Nose::default(),
        blank: Blank::Outline(lines(&[(0.0, 20.0), (0.0, 50.0), (-40.0, 50.0)])),
        allowance: Allowance { axes: Vec2::new(0.1, 0.3), around: 0.0 },
        most: 4.0,
        segmentation: Segmentation::Uniform,
        trace: Trace::Level,
        chips: None,
        relief: Relief::Cut,
        limits: Limits::default(),
        operation: Operation::Rough,
        finish_backwards: false,
        clearance: Clearance { lift: 1.0, entry: 1.1 },
        feeds: LayerFeeds { rough: feed, plunge: feed, finish: Feed::PerRevolution(0.1) },
        home: Point2::new(1.1, 26.3),
    }
}

fn moves(layers: &Layers, from: Option<Point2>) -> Result<Vec<Move>, &'static str> {
    let mut list = Vec::new();
    expand(layers, from, &mut |stroke| {
        if let Stroke::Move(mv) = stroke {
            list.push(mv);
        }
    })
    .map_err(|fault| fault.code().id)?;
    Ok(list)
}

#[test]
fn the_path_does_not_depend_on_where_the_tool_comes_from() {
    let [here, there] =
        [(80.0, 60.0), (10.0, 40.0)].map(|(z, x)| moves(&shaft(), Some(Point2::new(z, x))).expect("a path"));
    assert_eq!(here, there);
    assert_eq!(moves(&shaft(), None).expect("a path"), here);
    // It ends where it begins.
    assert_eq!((here[0].to, here.last().map(|mv| mv.to)), (shaft().home, Some(shaft().home)));
}

#[test]
fn refused_layers() {
    let from = Some(Point2::new(80.0, 60.0));
    let code = |layers: Layers| moves(&layers, from).expect_err("refused");
    assert_eq!(code(Layers { most: 1e-9, ..shaft() }), "G3040");
    assert_eq!(code(Layers { most: 0.0, ..shaft() }), "G3041");
    assert_eq!(code(Layers { blank: Blank::Outline(lines(&[(0.0, 0.0), (-40.0, 0.0)])), ..shaft() }), "G3046");
    assert_eq!(code(Layers { along: 1.0, ..shaft() }), "G3047");
    assert_eq!(moves(&shaft(), Some(Point2::new(-10.0, 20.0))), Err("G3301"));
    let nose = Nose { radius: 0.4, tip: Vec2::new(-1.0, 1.0) };
    assert_eq!(code(Layers { nose, ..shaft() }), "G3302");
    let limits = Limits { z: [Some(-5.0), None], ..Limits::default() };
    assert_eq!(code(Layers { limits, ..shaft() }), "G3303");
}

/// Sixty elements and thirty cuts: the cost does not grow with the square of the elements.
#[test]
fn many_elements_make_a_path() {
    let points: Vec<(f64, f64)> = (0..=60).map(|k| (-f64::from(k), 20.0 + f64::from(k + k % 2))).collect();
    let blank = Blank::Outline(lines(&[(0.0, 20.0), (0.0, 80.0), (-60.0, 80.0)]));
    let nose = Nose { radius: 0.4, tip: Vec2::new(-1.0, -1.0) };
    let layers = Layers { contour: lines(&points), blank, most: 1.0, nose, home: Point2::new(2.0, 42.0), ..shaft() };
    let list = moves(&layers, None).expect("a path");
    let levels = list.iter().filter(|mv| matches!(mv.path, Path::Rapid)).count();
    assert!(levels > 60 && layers.contour.iter().all(|e| matches!(e, Element::Line { .. })));
}
