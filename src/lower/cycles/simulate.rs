//! A blank of columns that a tool cuts, and random walls: the judge of the paths of cycles.

use proptest::prelude::*;

use crate::geo::{Element, Point2, Vec2, distance, turned};

use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::RecessTool;

use super::track::{Move, Path};

/// Distance of two columns of material, mm.
pub const GRID: f64 = 0.05;

/// One step down a wall: a line, an arc with the material inside, or one with the material outside.
#[derive(Debug, Clone, Copy)]
pub enum StepDown {
    Line(f64, f64),
    Bulge(f64),
    Hollow(f64),
}

pub fn step() -> impl Strategy<Value = StepDown> {
    prop_oneof![
        (0.0f64..2.0, 0.0f64..2.0).prop_map(|(x, y)| StepDown::Line(x, y)),
        Just(StepDown::Line(0.0, 1.5)),
        Just(StepDown::Line(1.0, 0.0)),
        (0.1f64..1.5).prop_map(StepDown::Bulge),
        (0.1f64..1.5).prop_map(StepDown::Hollow),
    ]
}

/// A chain that falls from the origin.
pub fn chain(steps: &[StepDown]) -> Vec<Element> {
    let mut at = Point2::origin();
    let mut list = Vec::new();
    let quarter = core::f64::consts::FRAC_PI_2;
    for step in steps.iter().copied().chain([StepDown::Line(0.0, 0.5)]) {
        let element = match step {
            StepDown::Line(x, y) => Element::Line { from: at, to: at + Vec2::new(x, -y) },
            StepDown::Bulge(r) => {
                let center = at - Vec2::new(0.0, r);
                Element::Arc { from: at, to: center + Vec2::new(r, 0.0), center, sweep: -quarter }
            }
            StepDown::Hollow(r) => {
                let center = at + Vec2::new(r, 0.0);
                Element::Arc { from: at, to: center - Vec2::new(0.0, r), center, sweep: quarter }
            }
        };
        at = element.to();
        list.push(element);
    }
    list
}

/// Height of a falling wall over `x`: endless outside, the floor behind its foot.
pub fn height(wall: &[Element], x: f64) -> f64 {
    if x < wall[0].from().x {
        return f64::INFINITY;
    }
    let mut high = 0.0_f64;
    for element in wall {
        let (a, b) = (element.from(), element.to());
        if x < a.x || x > b.x {
            continue;
        }
        high = high.max(match *element {
            Element::Line { .. } if b.x - a.x < 1e-12 => b.y,
            Element::Line { .. } => a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x),
            Element::Arc { from, center, sweep, .. } => {
                let r = distance(from, center);
                let up = (r * r - (x - center.x) * (x - center.x)).max(0.0).sqrt();
                center.y + if sweep < 0.0 { up } else { -up }
            }
        });
    }
    high
}

pub struct Blank {
    pub left: f64,
    pub columns: Vec<f64>,
}

impl Blank {
    /// Columns under the tool at `x`, with the height of the tool's edge over each, above its lowest point.
    pub fn under<'b>(&'b self, tool: &'b RecessTool, x: f64) -> impl Iterator<Item = (usize, f64)> + 'b {
        let first = ((x - self.left) / GRID).ceil().max(0.0) as usize;
        (first..self.columns.len()).map_while(move |i| {
            let t = self.left + i as f64 * GRID - x;
            if t > tool.width {
                return None;
            }
            let r = tool.nose;
            let into = (r - t).max(t - (tool.width - r)).max(0.0);
            Some((i, r - (r * r - into * into).max(0.0).sqrt()))
        })
    }
}

/// Points along a move, its end included.
pub fn samples(from: Point2, mv: &Move) -> Vec<Point2> {
    let Move { to, path } = *mv;
    let count = |length: f64| (length / (GRID / 2.0)).ceil().max(1.0) as usize;
    match path {
        Path::Arc { center, ccw, .. } => {
            let sweep = crate::geo::arc::sweep(from, to, center, ccw);
            let n = count(sweep.abs() * distance(from, center));
            (1..=n)
                .map(|i| if i == n { to } else { center + turned(from - center, sweep * i as f64 / n as f64) })
                .collect()
        }
        _ => {
            let n = count(distance(from, to));
            (1..=n).map(|i| if i == n { to } else { from + (to - from) * (i as f64 / n as f64) }).collect()
        }
    }
}

pub fn moved_by(list: &[Element], by: Vec2) -> Vec<Element> {
    let go = |p: Point2| p + by;
    list.iter()
        .map(|e| match *e {
            Element::Line { from, to } => Element::Line { from: go(from), to: go(to) },
            Element::Arc { from, to, center, sweep } => {
                Element::Arc { from: go(from), to: go(to), center: go(center), sweep }
            }
        })
        .collect()
}

/// Largest sweep of an arc in rad.
#[derive(Default)]
struct Arcs(f64);

impl crate::ir::motion::Sink for Arcs {
    fn movement(&mut self, mv: &crate::ir::motion::Move, _: &crate::ir::Origin) {
        if let crate::ir::motion::Path::Arc(arc, _) = &mv.path {
            self.0 = self.0.max(arc.sweep.abs());
        }
    }

    fn function(&mut self, _: &crate::ir::Function, _: &crate::ir::Origin) {}
    fn lost(&mut self, _: &crate::ir::Origin) {}
}

/// Through all passes of lowering: nothing is found, no arc is more than a quarter, and all hangs together.
pub fn check_lowering(cycle: &Cycle, start: Point2) -> Result<(), TestCaseError> {
    check_lowering_with(cycle, start, core::f64::consts::FRAC_PI_2)
}

/// The same with another greatest sweep of an arc, in rad.
pub fn check_lowering_with(cycle: &Cycle, start: Point2, most: f64) -> Result<(), TestCaseError> {
    use crate::diag::Diags;
    use crate::geo::Plane;
    use crate::ir::Origin;
    use crate::ir::contour::{Ctx, Sink};
    use crate::ir::verify;
    use crate::lower::Lower;
    use crate::machine::Machine;

    let (diags, machine) = (Diags::default(), Machine::default());
    let mut arcs = Arcs::default();
    let mut verify = verify::Motion::new(&mut arcs);
    let mut lower = Lower::new(&diags, &machine, &mut verify);
    let ctx = std::rc::Rc::new(Ctx { plane: Plane::Zx, ..Ctx::default() });
    let origin = Origin::default();
    let to_start = Move { to: start, path: Path::Rapid };
    lower.movement(&to_start.movement(), &ctx, &origin);
    lower.cycle(cycle, &ctx, &origin);
    lower.finish();
    let found: Vec<String> = diags.into_sorted().iter().map(|d| format!("{} {}", d.code.id, d.message)).collect();
    prop_assert!(found.is_empty(), "{found:?}");
    prop_assert!(arcs.0 <= most + 1e-3, "{}", arcs.0);
    Ok(())
}
