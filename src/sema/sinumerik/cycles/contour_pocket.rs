//! CYCLE63: the pocket along contours of CYCLE62.
//!
//! Source: M 7.7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::area::{Relation, relation};
use crate::geo::{Deg, Element, grid};
use crate::ir::captured::Captured;
use crate::ir::cycle::pocket::{Finish, Insertion, Onto};
use crate::ir::cycle::region::RegionFault;
use crate::ir::cycle::{Cycle, Family, Region};

use super::super::value::whole;
use super::super::{Outcome, Run};
use super::arguments::{Arguments, DR, DXY, EP, ER, EW, TR, UXY, VARI, XS, YS};
use super::call::CycleCall;
use super::called_contours::ContourCall;
use super::milling::{ALONG_CONTOURS, Around};
use super::table::Source;

impl Run<'_> {
    /// CYCLE63
    pub(super) fn contour_pocket(&mut self, args: &Arguments) -> Outcome {
        self.cycle(args).check_parameters()?;
        let contours = self.contours_of(args, Source::Milled, false)?;
        let mut call = self.cycle(args);
        let made = call.contour_pocket_without_contours()?;
        call.mill_contour_pocket(made, contours)?;
        call.say_remarks();
        Ok(())
    }
}

impl CycleCall<'_, '_> {
    /// What the arguments say.
    fn contour_pocket_without_contours(&mut self) -> Outcome<Region> {
        let args = self.args;
        let mill = self.mill(&ALONG_CONTOURS)?;
        if args.text(TR).is_some_and(|name| !name.is_empty()) {
            return self.refuse_argument(TR, codes::S9015::residual_material_of_another_tool());
        }
        if args.or_zero(DR) != 0.0 {
            self.unused(DR, "_DR", "without the name of a tool in `_TR`");
        }
        let code = args.number(VARI).and_then(whole).unwrap_or(0).unsigned_abs();
        if args.digit(VARI, 2) > 0 || code >= 100_000 {
            return self.refuse_argument(VARI, codes::S9015::this_kind_of_area());
        }
        let (rough, wall, floor) = match args.digit(VARI, 0) {
            1 => (true, false, false),
            3 => (false, false, true),
            4 => (false, true, false),
            5 => return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported()),
            _ => return self.no_such_machining("units 1 roughs, 3 finishes the floor, 4 the wall"),
        };
        let insertion = self.contour_insertion(rough)?;
        let lifts_high = match args.digit(VARI, 3) {
            0 => true,
            1 => false,
            _ => return self.no_such_machining("thousands 0 lifts to the retraction plane, 1 to the safety distance"),
        };
        let start = match args.digit(VARI, 4) {
            0 => None,
            1 => Some(self.reference_point(XS, YS)),
            _ => return self.no_such_machining("ten thousands 0 finds the start point, 1 takes `_XS` and `_YS`"),
        };
        Ok(Region {
            counter_clockwise: self.goes_counter_clockwise(Around::Inside)?,
            allowance: self.magnitude(UXY),
            left: 0.0,
            cleared: true,
            width: self.width(DXY, mill.radius)?,
            insertion_feed: None,
            coarse: None,
            outlines: Vec::new(),
            islands: Vec::new(),
            insertion,
            start,
            rough,
            finish: (wall || floor).then_some(Finish {
                wall,
                floor,
                feed: mill.feeds.plane,
                step: mill.heights.step,
                speed: None,
                onto: Onto::Usual,
                inserts: false,
            }),
            lifts_high,
            mill,
        })
    }

    fn contour_insertion(&mut self, rough: bool) -> Outcome<Insertion> {
        let args = self.args;
        Ok(match args.digit(VARI, 1) {
            _ if !rough => Insertion::Vertical,
            0 => Insertion::Vertical,
            1 => {
                let (radius, pitch) = (self.magnitude(ER), self.magnitude(EP));
                if pitch == 0.0 {
                    return self.refuse_cycle(args.span_of(EP), codes::P2090::pitch_of_helix_ep_is_0(&args.place(EP)));
                }
                self.own_way(codes::P8101::helix_becomes_smaller_where_walls_leave_less());
                Insertion::Helix { radius, pitch }
            }
            2 => {
                let angle = args.or_zero(EW).abs();
                if angle == 0.0 || angle >= 90.0 {
                    let place = args.place(EW);
                    return self.refuse_cycle(args.span_of(EW), codes::P2090::angle_of_insertion_ew_is_above_0(&place));
                }
                Insertion::Sway { angle: Deg(angle), stroke: None }
            }
            _ => return self.no_such_machining("tens 0 straight down, 1 on a helix, 2 to and fro"),
        })
    }

    fn mill_contour_pocket(&mut self, made: Region, contours: Vec<(ContourCall, Captured)>) -> Outcome {
        let args = self.args;
        for (_, contour) in &contours {
            if contour.plane != made.mill.plane {
                return self.refuse_cycle(args.span, codes::P2090::contour_lies_in_another_plane());
            }
        }
        let mut closed = contours.iter().map(|(_, contour)| closed(contour));
        let outline = closed.next().unwrap_or_default();
        let islands: Vec<Vec<Element>> = closed.collect();
        self.islands_lie_inside(&contours, &outline, &islands)?;
        let region = Region { outlines: vec![outline], islands, ..made };
        if let Err(fault) = region.check() {
            let (key, alarm) = match fault {
                RegionFault::Mill(fault) => return self.mill_fault(&ALONG_CONTOURS, fault),
                RegionFault::Width | RegionFault::TooManyRings => (DXY, 61111),
                RegionFault::Pitch => (EP, 61019),
                RegionFault::LargeArc => {
                    let help = "draw such an arc as a line";
                    return self.cycle_fault(args.span, 61931, &fault.to_string(), help);
                }
                RegionFault::Insertion | RegionFault::Number | RegionFault::Nothing => (VARI, 61019),
            };
            return self.refuse_cycle(
                args.span_of(key),
                codes::P2090::so_check_arguments(&fault, &args.written(key), &args.place(key)).alarm(alarm),
            );
        }
        self.own_way(codes::P8101::first_contour_is_pocket());
        self.send_cycle(Cycle::Region(region));
        Ok(())
    }

    /// Islands neither cross the outline nor each other, nor stand outside or in another one.
    fn islands_lie_inside(
        &mut self,
        contours: &[(ContourCall, Captured)],
        outline: &[Element],
        islands: &[Vec<Element>],
    ) -> Outcome {
        for (at, island) in islands.iter().enumerate() {
            let apart = |other: &Vec<Element>| relation(other, island) == Relation::Apart;
            if relation(outline, island) == Relation::SecondInside && islands.iter().take(at).all(apart) {
                continue;
            }
            let Some((call, _)) = contours.get(at + 1) else { continue };
            let message = format!("the island `{}` does not lie inside the pocket by itself", call.name);
            let found = crate::diag::Diagnostic::new(codes::S2091.alarm(61932), call.loc, message);
            let found = found.also(self.loc(self.args.span), "the pocket is milled here");
            self.report(found.help("draw one contour where areas touch; call the pocket first, then its islands"));
            return Err(super::super::Reported);
        }
        Ok(())
    }
}

/// The elements of a contour, the last one ending where the first begins. Their coordinates are the same numbers, however they were
/// computed.
fn closed(contour: &Captured) -> Vec<Element> {
    let mut elements: Vec<Element> = contour.pieces.iter().map(|piece| piece.element).collect();
    if let Some(last) = elements.last_mut() {
        match last {
            Element::Line { to, .. } | Element::Arc { to, .. } => *to = contour.start,
        }
    }
    grid::chain(&elements)
}
