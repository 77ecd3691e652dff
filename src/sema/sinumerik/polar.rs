//! Poles and polar end points: G110, G111, G112, AP and RP.
//!
//! Source: S 2.4 (docs/sources.md).

use crate::diag::codes;
use crate::geo::angle::polar_point;
use crate::geo::{Deg, Point2};
use crate::ir::Pos;
use crate::machine::AxisSet;
use crate::text::Span;

use super::g_groups::GCode;
use super::vocabulary::Address;
use super::words::{Given, Mode, Words};
use super::{Channel, Core, Outcome, Reported};

/// Pole, and the polar words that hold on.
#[derive(Debug, Clone)]
pub(super) struct Polar {
    pole: Point2,
    /// The pole was set under an error, or what counts from it is missing: reported.
    lost: bool,
    angle: Option<f64>,
    radius: Option<f64>,
}

impl Default for Polar {
    fn default() -> Polar {
        Polar { pole: Point2::origin(), lost: false, angle: None, radius: None }
    }
}

impl Polar {
    pub fn pole(&self) -> Point2 {
        self.pole
    }

    /// The last RP in mm.
    pub fn radius(&self) -> Option<f64> {
        self.radius
    }

    /// The pole is the zero of the new plane, and its angle has to be said anew.
    pub fn plane_changed(&mut self) {
        self.set_pole(Point2::origin());
    }

    fn set_pole(&mut self, pole: Point2) {
        (self.pole, self.angle) = (pole, None);
    }
}

impl Channel<'_> {
    /// G110, G111 or G112: the pole, by coordinates or by angle and radius.
    pub(super) fn pole_block(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome {
        let result = self.set_pole(code, span, w);
        self.st.polar.lost = result.is_err();
        result
    }

    fn set_pole(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome {
        let plane = self.st.plane();
        let [first, second, third] = self.st.roles();
        for axis in w.axes.iter() {
            if axis != first && axis != second {
                let given = w.axis(axis).unwrap_or_default();
                let help = format!("a pole has {} and {}", first.letter(), second.letter());
                let help = if axis == third { format!("{help}; check G17, G18, G19") } else { help };
                return self
                    .core
                    .refuse(given.span, codes::S2050::is_no_axis_of_working_plane(&axis.letter()).help(&help));
            }
        }
        let base = match code {
            GCode::G111 => Point2::origin(),
            GCode::G112 => {
                if self.st.polar.lost {
                    return Err(Reported);
                }
                self.st.polar.pole
            }
            _ => match self.st.position.in_plane(plane) {
                Some(at) => at,
                None => {
                    let axis = if self.st.position.get(first).is_none() { first } else { second };
                    return self.st.unknown_axis(&self.core, axis, span);
                }
            },
        };
        let (ap, rp) = (w.take(Address::Ap), w.take(Address::Rp));
        let pole = if ap.is_some() || rp.is_some() {
            if !w.axes.is_empty() {
                return self.core.mixed(span);
            }
            let (Some(ap), Some(rp)) = (ap, rp) else {
                return self.core.refuse(span, codes::P1003::polar_pole_needs_ap());
            };
            self.core.check_angle(ap, 14260)?;
            self.core.check_radius(rp, 14250)?;
            polar_point(base, rp.value * self.st.length_unit(), Deg(ap.value))
        } else {
            // G90, G91, AC and IC do not matter; the diameter axis counts as it is programmed.
            let mut way = [0.0; 2];
            for (place, axis) in way.iter_mut().zip([first, second]) {
                if let Some(given) = w.axis(axis) {
                    self.core.parameter_of_frame(given)?;
                    *place = self.st.length(&self.core, axis, Given { mode: Mode::Plain, ..given }, false)?;
                }
            }
            Point2::new(base.x + way[0], base.y + way[1])
        };
        self.st.polar.set_pole(pole);
        Ok(())
    }

    /// The end point of a block with AP or RP.
    pub(super) fn polar_end(&mut self, w: &mut Words) -> Outcome<Pos> {
        if self.st.polar.lost {
            return Err(Reported);
        }
        let plane = self.st.plane();
        let [first, second, _] = self.st.roles();
        let (ap, rp) = (w.take(Address::Ap), w.take(Address::Rp));
        let span = ap.or(rp).map(|given| given.span).unwrap_or_default();
        if w.axes.contains(first) || w.axes.contains(second) {
            return self.core.mixed(span);
        }
        let radius = match rp {
            Some(rp) => {
                self.core.check_radius(rp, 14200)?;
                rp.value * self.st.length_unit()
            }
            None => match self.st.polar.radius {
                Some(radius) => radius,
                None => {
                    self.st.position.lose(AxisSet::MAIN);
                    self.lost();
                    return self.core.refuse(span, codes::S2054::rp_was_never_programmed());
                }
            },
        };
        let angle = match ap {
            Some(ap) => {
                self.core.check_angle(ap, 14210)?;
                let incremental = match ap.mode {
                    Mode::Plain => self.st.is(GCode::G91),
                    Mode::Ac => false,
                    Mode::Ic => true,
                    _ => return self.core.refuse(ap.span, codes::P1003::only_ac_and_ic_fit_ap()),
                };
                if incremental {
                    let base = match self.st.polar.angle {
                        Some(angle) => angle,
                        None => return self.polar_word_missing(ap.span, "the angle that AP= counts from"),
                    };
                    base + ap.value
                } else {
                    ap.value
                }
            }
            None => match self.st.polar.angle {
                Some(angle) => angle,
                None => return self.polar_word_missing(span, "AP="),
            },
        };
        self.st.polar.radius = Some(radius);
        self.st.polar.angle = Some(angle);
        let mut end = self.st.targets(&self.core, w)?;
        end.set_in_plane(plane, polar_point(self.st.polar.pole, radius, Deg(angle)));
        Ok(end)
    }

    /// The manuals demand the word again, so that what it was does not count.
    fn polar_word_missing<T>(&mut self, span: Span, what: &str) -> Outcome<T> {
        // What counts on from here is not reported again.
        self.st.polar.lost = true;
        self.st.position.lose(AxisSet::MAIN);
        self.lost();
        self.core.refuse(span, codes::S2054::was_not_programmed_since_pole_or_plane(&what))
    }
}

impl Core<'_> {
    fn mixed<T>(&self, span: Span) -> Outcome<T> {
        self.refuse(span, codes::S2051::ap_or_rp_stands_beside_axis())
    }

    fn check_angle(&self, ap: Given, alarm: u32) -> Outcome {
        if ap.value.abs() > 360.0 {
            return self.refuse(ap.span, codes::S2053::ap_lies_outside_360_to_360_degrees(&ap.value).alarm(alarm));
        }
        Ok(())
    }

    fn check_radius(&self, rp: Given, alarm: u32) -> Outcome {
        if rp.value < 0.0 {
            return self.refuse(rp.span, codes::S2052::rp_is_negative(&rp.value).alarm(alarm));
        }
        Ok(())
    }
}
