//! Polar blocks: LP, CTP, CP, and the pole they refer to.
//!
//! Source: K 2.2 and 2.8 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Plane, Point2, angle};
use crate::ir::Pos;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::machine::{Axis, AxisSet, CcMissing};
use crate::parser::klartext::ast::Block;
use crate::sema::run::Where;
use crate::text::Span;

use super::place::View;
use super::pole::{PoleState, absolute_sweep, angle_undefined};
use super::words::{Admits, Words};
use super::{Outcome, Run};

impl View<'_, '_> {
    /// The pole in force.
    pub(super) fn pole(&self, function: &str) -> Outcome<PoleState> {
        self.st.polar.needed(self.core, self.st.frames.system(), function)
    }

    /// Radius and angle of the end of LP or CTP.
    pub(super) fn polar_words(&self, w: &Words, pole: &PoleState, function: &str) -> Outcome<(f64, Deg)> {
        let stands = || self.start_in(pole.plane, function);
        self.st.polar.words(self.core, w, pole, function, &stands)
    }

    /// The pole that CC sets.
    fn pole_of(&self, w: &Words, span: Span) -> Outcome<PoleState> {
        let axes = w.axes.known();
        if !axes.without(AxisSet::MAIN).is_empty() || axes.len() > 2 {
            return self.core.refuse(w.axes_span, codes::P1003::cc_takes_two_of_x());
        }
        let mut indices = axes.iter().map(Axis::index);
        let plane = match (indices.next(), indices.next()) {
            (Some(a), Some(b)) => Plane::spanned_by(a, b).unwrap_or_default(),
            (Some(a), None) => {
                let plane = self.st.plane();
                let (first, second, _) = plane.axes();
                if a != first && a != second {
                    return self.core.refuse(w.axes_span, codes::P1003::this_axis_is_not_in_working_plane());
                }
                plane
            }
            _ => self.st.plane(),
        };
        let written = self.absolute(w)?;
        let (first, second, _) = plane.axes();
        let previous = self.st.polar.pole().filter(|pole| pole.plane == plane);
        let keep = axes.len() == 1 && self.core.job.settings.control.cc_missing == CcMissing::Previous;
        let old = previous.filter(|_| keep).map(|pole| pole.at);
        if axes.len() == 1 {
            let from = if old.is_some() { "the CC before" } else { "the position" };
            self.core.say(span, codes::K2102::cc_with_one_coordinate(&from));
        }
        let coordinate = |axis: Axis, old: Option<f64>| match (written.get(axis), old) {
            (Some(value), _) => Ok(value),
            (None, Some(old)) => Ok(old),
            (None, None) => self.position_of(axis, span, "CC"),
        };
        let x = coordinate(Axis::ALL[first], old.map(|p| p.x))?;
        let y = coordinate(Axis::ALL[second], old.map(|p| p.y))?;
        let (at, set, system) = (Point2::new(x, y), self.core.loc(span), self.st.frames.system());
        Ok(PoleState { at, plane, set, system, used: false })
    }
}

impl Run<'_> {
    /// LP.
    pub(super) fn polar_line(&mut self, w: &Words) -> Outcome {
        let pole = self.view().pole("LP")?;
        let (radius, angle) = self.view().polar_words(w, &pole, "LP")?;
        let feed = self.st.feed.of_move(&self.core, w)?;
        let end = self.polar_end(w, &pole, (radius, angle), feed.is_some())?;
        let feed = feed.map(|feed| self.view().plunged(w, feed, &end, None));
        self.send(&end, Path::straight(feed));
        self.st.polar.keep(radius, angle, &pole);
        Ok(())
    }

    /// CTP.
    pub(super) fn tangent_polar(&mut self, w: &Words) -> Outcome {
        let pole = self.view().pole("CTP")?;
        self.st.feed.check_edge(&self.core, self.st.compensation.side())?;
        let (radius, angle) = self.view().polar_words(w, &pole, "CTP")?;
        let feed = self.st.feed.of_arc(&self.core, w)?;
        let end = self.polar_end(w, &pole, (radius, angle), true)?;
        w.flat(&self.core, pole.plane, "CTP")?;
        self.view().follows_a_block("CTP")?;
        self.view().start_in(pole.plane, "CTP")?;
        let feed = self.view().plunged(w, feed, &end, None);
        let arc = Arc { plane: pole.plane, shape: ArcShape::Tangent, turns: 0 };
        self.send(&end, Path::Arc(arc, feed));
        self.st.polar.keep(radius, angle, &pole);
        Ok(())
    }

    /// The end point of LP or CTP with the axes beside the plane.
    fn polar_end(&mut self, w: &Words, pole: &PoleState, to: (f64, Deg), cuts: bool) -> Outcome<Pos> {
        let rest = self.view().absolute(w)?;
        let mut end = self.check_axes(w, rest, cuts)?;
        end.set_in_plane(pole.plane, angle::polar_point(pole.at, to.0, to.1));
        Ok(end)
    }

    /// CP: arc or helix about the pole.
    pub(super) fn polar_arc(&mut self, w: &Words) -> Outcome {
        let pole = self.view().pole("CP")?;
        if w.polar_radius.is_some() {
            return self.core.refuse(w.polar_radius_span, codes::P1003::cp_takes_no_pr());
        }
        let Some((angle, incremental)) = w.polar_angle else {
            return self.core.refuse(Where::Block, codes::K2109::cp_needs_pa_or_ipa());
        };
        w.forbid_plane_axes(&self.core, pole.plane, "CP")?;
        let start = self.view().start_in(pole.plane, "CP")?;
        let (radius, Some(from)) = self.st.polar.start(&pole, &|| Ok(start))? else {
            return angle_undefined(&self.core, w);
        };
        let sweep = if incremental {
            self.st.polar.incremental_sweep(&self.core, w, angle)?
        } else {
            let ccw = self.st.polar.turns(&self.core, w, "CP")?;
            if angle.abs() > 360.0 {
                self.core.say(w.polar_angle_span, codes::K2106::pa_is_reduced_to_direction(&angle));
            }
            absolute_sweep(&self.core, from, angle, ccw, radius)?
        };
        let mut end = self.view().absolute(w)?;
        end.set_in_plane(pole.plane, angle::rotated(start, pole.at, Deg(sweep)));
        let cuts = self.st.feed.of_move(&self.core, w)?.is_some();
        let end = self.check_axes(w, end, cuts)?;
        let shape = ArcShape::Sweep { center: pole.at, sweep: Deg(sweep) };
        self.send_arc(w, pole.plane, shape, end)?;
        let angle = Deg(from.0 + sweep);
        self.st.polar.keep(radius, angle, &pole);
        Ok(())
    }

    pub(super) fn pole_block(&mut self, block: &Block) -> Outcome {
        let pole = self.gather(block, "CC", Admits::AXES).and_then(|w| {
            let pole = self.view().pole_of(&w, block.span);
            self.words = Some(w);
            pole
        });
        self.st.polar.set_pole(pole.as_ref().ok().copied());
        pole.map(drop)
    }
}
