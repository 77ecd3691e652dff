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
use super::{Core, Outcome, Reported, State};

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

impl State {
    /// G110, G111 or G112: the pole, by coordinates or by angle and radius.
    pub(super) fn pole_block(&mut self, core: &Core<'_>, code: GCode, span: Span, w: &mut Words) -> Outcome {
        let pole = pole_of(core, self, code, span, w);
        self.polar.lost = pole.is_err();
        self.polar.set_pole(pole?);
        Ok(())
    }

    /// The end point of a block with AP or RP.
    pub(super) fn polar_end(&mut self, core: &mut Core<'_>, w: &mut Words) -> Outcome<Pos> {
        if self.polar.lost {
            return Err(Reported);
        }
        let plane = self.plane();
        let [first, second, _] = self.roles();
        let (ap, rp) = (w.take(Address::Ap), w.take(Address::Rp));
        let span = ap.or(rp).map(|given| given.span).unwrap_or_default();
        if w.axes.contains(first) || w.axes.contains(second) {
            return core.mixed(span);
        }
        let radius = match rp {
            Some(rp) => {
                core.check_radius(rp, 14200)?;
                rp.value * self.length_unit()
            }
            None => match self.polar.radius {
                Some(radius) => radius,
                None => {
                    self.position.lose(AxisSet::MAIN);
                    core.send_lost(&self.ctx);
                    return core.refuse(span, codes::S2054::rp_was_never_programmed());
                }
            },
        };
        let angle = match ap {
            Some(ap) => {
                core.check_angle(ap, 14210)?;
                let incremental = match ap.mode {
                    Mode::Plain => self.is(GCode::G91),
                    Mode::Ac => false,
                    Mode::Ic => true,
                    _ => return core.refuse(ap.span, codes::P1003::only_ac_and_ic_fit_ap()),
                };
                if incremental {
                    let base = match self.polar.angle {
                        Some(angle) => angle,
                        None => return self.polar_word_missing(core, ap.span, "the angle that AP= counts from"),
                    };
                    base + ap.value
                } else {
                    ap.value
                }
            }
            None => match self.polar.angle {
                Some(angle) => angle,
                None => return self.polar_word_missing(core, span, "AP="),
            },
        };
        self.polar.radius = Some(radius);
        self.polar.angle = Some(angle);
        let mut end = self.targets(core, w)?;
        end.set_in_plane(plane, polar_point(self.polar.pole, radius, Deg(angle)));
        Ok(end)
    }

    /// The manuals demand the word again, so that what it was does not count.
    fn polar_word_missing<T>(&mut self, core: &mut Core<'_>, span: Span, what: &str) -> Outcome<T> {
        // What counts on from here is not reported again.
        self.polar.lost = true;
        self.position.lose(AxisSet::MAIN);
        core.send_lost(&self.ctx);
        core.refuse(span, codes::S2054::was_not_programmed_since_pole_or_plane(&what))
    }
}

/// The pole by the words of its block.
fn pole_of(core: &Core<'_>, st: &State, code: GCode, span: Span, w: &mut Words) -> Outcome<Point2> {
    let plane = st.plane();
    let [first, second, third] = st.roles();
    for axis in w.axes.iter() {
        if axis != first && axis != second {
            let given = w.axis(axis).unwrap_or_default();
            let help = format!("a pole has {} and {}", first.letter(), second.letter());
            let help = if axis == third { format!("{help}; check G17, G18, G19") } else { help };
            return core.refuse(given.span, codes::S2050::is_no_axis_of_working_plane(&axis.letter()).help(&help));
        }
    }
    let base = match code {
        GCode::G111 => Point2::origin(),
        GCode::G112 => {
            if st.polar.lost {
                return Err(Reported);
            }
            st.polar.pole
        }
        _ => st.stands_in(core, plane, span)?,
    };
    let (ap, rp) = (w.take(Address::Ap), w.take(Address::Rp));
    Ok(if ap.is_some() || rp.is_some() {
        if !w.axes.is_empty() {
            return core.mixed(span);
        }
        let (Some(ap), Some(rp)) = (ap, rp) else {
            return core.refuse(span, codes::P1003::polar_pole_needs_ap());
        };
        core.check_angle(ap, 14260)?;
        core.check_radius(rp, 14250)?;
        polar_point(base, rp.value * st.length_unit(), Deg(ap.value))
    } else {
        // G90, G91, AC and IC do not matter; the diameter axis counts as it is programmed.
        let mut way = [0.0; 2];
        for (place, axis) in way.iter_mut().zip([first, second]) {
            if let Some(given) = w.axis(axis) {
                given.counts_in_frame(core)?;
                *place = st.length(core, axis, Given { mode: Mode::Plain, ..given }, false)?;
            }
        }
        Point2::new(base.x + way[0], base.y + way[1])
    })
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
