//! What the cycles of stock removal on lathes share: the nose of the tool, the directions, and the cycle that is sent.
//!
//! Source: M 1, 2 and 9 (docs/sources.md).

use core::fmt;

use crate::diag::{Answer, codes};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::layers::{Layers, Relief};
use crate::ir::cycle::recess::Operation;
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::turning::Towards;

use nalgebra::Vector3;

use super::super::compensation::nose_of;
use super::call::{Act, Acts, CycleCall};
use super::names::DMODE;
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

/// The side from which material is taken, and the way of the cuts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    pub into: Towards,
    /// Sense of the cutting axis, 1 or -1.
    pub along: f64,
}

impl Side {
    /// A place with `cut` along the cuts and `depth` along the infeed.
    pub fn point(self, cut: f64, depth: f64) -> Point2 {
        if self.into.is_radial() { Point2::new(cut, depth) } else { Point2::new(depth, cut) }
    }

    /// Coordinates along the cuts and along the infeed.
    pub fn place(self, p: Point2) -> (f64, f64) {
        if self.into.is_radial() { (p.x, p.y) } else { (p.y, p.x) }
    }

    /// Sense of the infeed axis out of the material.
    pub fn out(self) -> f64 {
        -(self.into.unit().x + self.into.unit().y)
    }

    /// The contour in the order of the cuts, and whether it had to be turned around.
    pub fn in_order(self, contour: &[Element]) -> (Vec<Element>, bool) {
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return (Vec::new(), false) };
        let (start, end) = (self.place(first.from()), self.place(last.to()));
        let way = (end.0 - start.0) * self.along;
        // An upright contour begins at its deeper end.
        let turned = way < -1e-6 || (way.abs() <= 1e-6 && (end.1 - start.1) * self.out() < 0.0);
        if !turned {
            return (contour.to_vec(), false);
        }
        (contour.iter().rev().map(backwards).collect(), true)
    }
}

fn backwards(element: &Element) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: to, to: from },
        Element::Arc { from, to, center, sweep } => Element::Arc { from: to, to: from, center, sweep: -sweep },
    }
}

/// The outline of a rectangle.
pub(super) fn rectangle(a: Point2, b: Point2) -> Vec<Element> {
    let corners = [a, Point2::new(b.x, a.y), b, Point2::new(a.x, b.y), a];
    let sides = corners.windows(2).filter(|pair| pair[0] != pair[1]);
    sides.map(|pair| Element::Line { from: pair[0], to: pair[1] }).collect()
}

impl CycleCall<'_> {
    /// The plane and the coded arguments of stock removal.
    pub(super) fn removal_digits(&self) -> Made {
        if !matches!(self.given.digit(DMODE, 0), 0 | 2) {
            return self.refuse_argument(DMODE, codes::S9015::turning_cycle_in_another_plane_than_g18());
        }
        self.digits_of_are_known(DMODE)
    }

    /// The nose of the active edge.
    pub(super) fn nose_of_edge(&self) -> Made<Nose> {
        let given = self.given;
        let (number, edge) = self.active_edge()?;
        let Some(radius) = self.known_radius() else {
            return self.refuse_as_said(
                given.place,
                codes::P2004::nose_radius_of_tool_d_is_not(&given.called, &number, &edge)
                    .answers([Answer::tool(number, "radius"), Answer::tool(number, "orientation")]),
            );
        };
        if radius < 0.0 {
            return self.refuse_as_said(
                given.place,
                codes::P2004::nose_radius_of_tool_d_is_below(&given.called, &number, &edge),
            );
        }
        if radius == 0.0 {
            return Ok(Nose::default());
        }
        match self.st.edge_position(self.settings, number, edge).and_then(nose_of) {
            Some(way) => Ok(Nose { radius, tip: self.in_frame(Vec2::zeros() - way)? }),
            None => self.refuse_as_said(
                given.place,
                codes::P2004::position_of_cutting_edge_of_tool_d(&given.called, &number, &edge)
                    .answer(Answer::tool(number, "orientation")),
            ),
        }
    }

    /// The angle of the flank of the active edge, degrees; on the control 0 is "not known".
    fn clearance_angle(&self) -> Option<f64> {
        let number = self.st.tool.active()?;
        let edge = self.st.tool.edge_or_first();
        let written = self.st.system.of_edge(24, number, edge);
        let listed = || self.st.active_tool(self.settings).and_then(|tool| tool.clearance).filter(|_| edge == 1);
        written.or_else(listed).filter(|angle| *angle > 0.0)
    }

    /// A direction of the tool along Z and X as the programmed frame sees it: no frame turns the tool.
    fn in_frame(&self, way: Vec2) -> Made<Vec2> {
        let linear = self.st.ctx.frame.linear();
        let seen = linear.transpose() * Vector3::new(way.y, 0.0, way.x);
        let whole = seen.map(|v| v.round());
        let straight = (seen - whole).norm() < 1e-9 && whole.y == 0.0 && whole.abs().max() <= 1.0;
        if straight && (linear * whole - Vector3::new(way.y, 0.0, way.x)).norm() < 1e-9 {
            return Ok(Vec2::new(whole.z, whole.x));
        }
        self.refuse_as_said(self.given.place, codes::S9015::under_frame_that_turns_part_by_angle(&self.given.called))
    }

    /// The kind of machining from a digit: 1 roughing, 2 finishing, 3 both.
    pub(super) fn operation(&self, digit: i32) -> Option<Operation> {
        match digit {
            1 => Some(Operation::Rough),
            2 => Some(Operation::Finish),
            3 => Some(Operation::RoughAndFinish),
            _ => None,
        }
    }

    /// Infeed that roughing needs.
    pub(super) fn infeed(&self, key: Name, operation: Operation) -> Made<f64> {
        let given = self.given;
        let most = self.given.magnitude(key);
        if most > 0.0 || operation == Operation::Finish {
            return Ok(most);
        }
        self.refuse_argument(key, codes::P2090::greatest_infeed_is_missing(&given.written(key), &given.argument(key)))
    }

    /// The cycle, and what it rests on.
    pub(super) fn send_layers(&self, layers: Layers) -> Made<Acts> {
        let given = self.given;
        let reliefs = layers.reliefs();
        let (called, place) = (&given.called, given.place);
        if !reliefs.is_empty() {
            let shown = Reliefs { list: &reliefs, along_z: layers.into.is_radial() };
            if layers.relief == Relief::Left {
                self.note(place, codes::S8210::relief_cut_from_is_left_standing(called, &shown), Kind::Once);
            } else if let Some(angle) = self.clearance_angle() {
                let steepest = layers.steepest_fall();
                if steepest > angle + 1e-6 {
                    return self.refuse(codes::P2090::relief_cut_from_falls_at_degrees(&shown, &steepest, &angle));
                }
            } else {
                self.note(place, codes::S8211::relief_cut(called, &shown), Kind::Once);
            }
        }
        if layers.points_back() {
            self.note(place, codes::S8213::cutting_edge_points_back(called), Kind::Once);
        }
        if layers.leans_over() && layers.operation != Operation::Finish {
            self.note(place, codes::S8212::part_of_contour_leans_over(called), Kind::Once);
        }
        if layers.operation != Operation::Finish {
            self.own_way(codes::P8101::controls_do_not_publish_cuts());
        }
        Ok(vec![Act::Cycle(Cycle::Layers(layers))])
    }

    /// Refuses a kind of machining.
    pub(super) fn kind_fault<T>(&self, key: Name, help: &str) -> Made<T> {
        self.refuse_argument(
            key,
            codes::P2090::there_is_no_such_kind_of_machining(&self.given.written(key), &self.given.argument(key))
                .help(help),
        )
    }

    /// Nothing between the blank and the end point.
    pub(super) fn no_material<T>(&self, key: Name, what: &str) -> Made<T> {
        let given = self.given;
        self.refuse_argument(key, codes::P2090::so_check_corner(&what, &given.written(key), &given.argument(key)))
    }
}

/// Relief cuts as findings show them: from where to where on the axis of the cuts, X as a diameter.
struct Reliefs<'r> {
    list: &'r [(f64, f64)],
    along_z: bool,
}

impl fmt::Display for Reliefs<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (axis, scale) = if self.along_z { ("Z", 1.0) } else { ("X", 2.0) };
        for (at, (from, to)) in self.list.iter().enumerate() {
            let between = if at == 0 { "" } else { ", " };
            write!(f, "{between}{axis}{:.3} to {axis}{:.3}", from * scale, to * scale)?;
        }
        Ok(())
    }
}
