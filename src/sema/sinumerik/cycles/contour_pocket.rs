//! CYCLE63: the pocket along contours of CYCLE62.
//!
//! Source: M 7.7 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::geo::area::{Relation, relation};
use crate::geo::{Deg, Element, grid};
use crate::ir::captured::Captured;
use crate::ir::cycle::pocket::{Finish, Insertion, WallApproach};
use crate::ir::cycle::region::RegionFault;
use crate::ir::cycle::{Cycle, Family, Region};

use super::super::named_contour::CalledContour;
use super::call::{Act, Acts, CycleCall};
use super::milling::{ALONG_CONTOURS, Around};
use super::names::{DR, DXY, EP, ER, EW, TR, UXY, VARI, XS, YS};
use crate::sema::cycle::call::{Elsewhere, Made};

impl CycleCall<'_> {
    /// CYCLE63
    pub(super) fn contour_pocket(&self, contours: &[CalledContour]) -> Made<Acts> {
        self.mill_contour_pocket(self.contour_pocket_without_contours()?, contours)
    }

    /// What the arguments say.
    fn contour_pocket_without_contours(&self) -> Made<Region> {
        let given = self.given;
        let mill = self.mill(&ALONG_CONTOURS)?;
        if given.text(TR).is_some() {
            return self.refuse_argument(TR, codes::S9015::residual_material_of_another_tool());
        }
        if given.or_zero(DR) != 0.0 {
            self.unused(DR, "without the name of a tool in `_TR`");
        }
        let code = given.whole(VARI).unsigned_abs();
        if given.digit(VARI, 2) > 0 || code >= 100_000 {
            return self.refuse_argument(VARI, codes::S9015::this_kind_of_area());
        }
        let (rough, wall, floor) = match given.digit(VARI, 0) {
            1 => (true, false, false),
            3 => (false, false, true),
            4 => (false, true, false),
            5 => return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported()),
            _ => return self.no_such_machining("units 1 roughs, 3 finishes the floor, 4 the wall"),
        };
        let insertion = self.contour_insertion(rough)?;
        let lifts_high = match given.digit(VARI, 3) {
            0 => true,
            1 => false,
            _ => return self.no_such_machining("thousands 0 lifts to the retraction plane, 1 to the safety distance"),
        };
        let start = match given.digit(VARI, 4) {
            0 => None,
            1 => Some(self.reference_point(XS, YS)),
            _ => return self.no_such_machining("ten thousands 0 finds the start point, 1 takes `_XS` and `_YS`"),
        };
        Ok(Region {
            counter_clockwise: self.goes_counter_clockwise(Around::Inside)?,
            allowance: self.given.magnitude(UXY),
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
                onto: WallApproach::Usual,
                inserts: false,
            }),
            lifts_high,
            mill,
        })
    }

    fn contour_insertion(&self, rough: bool) -> Made<Insertion> {
        let given = self.given;
        Ok(match given.digit(VARI, 1) {
            _ if !rough => Insertion::Vertical,
            0 => Insertion::Vertical,
            1 => {
                let (radius, pitch) = (self.given.magnitude(ER), self.given.magnitude(EP));
                if pitch == 0.0 {
                    return self.refuse_argument(EP, codes::P2090::pitch_of_helix_ep_is_0(&given.argument(EP)));
                }
                self.own_way(codes::P8101::helix_becomes_smaller_where_walls_leave_less());
                Insertion::Helix { radius, pitch }
            }
            2 => {
                let angle = given.or_zero(EW).abs();
                if angle == 0.0 || angle >= 90.0 {
                    let place = given.argument(EW);
                    return self.refuse_argument(EW, codes::P2090::angle_of_insertion_ew_is_above_0(&place));
                }
                Insertion::Ramp { angle: Deg(angle), stroke: None }
            }
            _ => return self.no_such_machining("tens 0 straight down, 1 on a helix, 2 to and fro"),
        })
    }

    fn mill_contour_pocket(&self, made: Region, contours: &[CalledContour]) -> Made<Acts> {
        let given = self.given;
        for contour in contours {
            if contour.made.plane != made.mill.plane {
                return self.refuse(codes::P2090::contour_lies_in_another_plane());
            }
        }
        let mut closed = contours.iter().map(|contour| closed(&contour.made));
        let outline = closed.next().unwrap_or_default();
        let islands: Vec<Vec<Element>> = closed.collect();
        self.islands_lie_inside(contours, &outline, &islands)?;
        let region = Region { outlines: vec![outline], islands, ..made };
        if let Err(fault) = region.check() {
            let (key, alarm) = match fault {
                RegionFault::Mill(fault) => return self.mill_fault(&ALONG_CONTOURS, fault),
                RegionFault::Width | RegionFault::TooManyRings => (DXY, 61111),
                RegionFault::Pitch => (EP, 61019),
                RegionFault::LargeArc => return self.unsound_call(61931, &fault, "draw such an arc as a line"),
                RegionFault::Insertion | RegionFault::Number | RegionFault::Nothing => (VARI, 61019),
            };
            return self.refuse_argument(
                key,
                codes::P2090::so_check_arguments(&fault, &given.written(key), &given.argument(key)).alarm(alarm),
            );
        }
        self.own_way(codes::P8101::first_contour_is_pocket());
        Ok(vec![Act::Cycle(Cycle::Region(region))])
    }

    /// Islands neither cross the outline nor each other, nor stand outside or in another one.
    fn islands_lie_inside(&self, contours: &[CalledContour], outline: &[Element], islands: &[Vec<Element>]) -> Made {
        for (at, island) in islands.iter().enumerate() {
            let apart = |other: &Vec<Element>| relation(other, island) == Relation::Apart;
            if relation(outline, island) == Relation::SecondInside && islands.iter().take(at).all(apart) {
                continue;
            }
            let Some(CalledContour { call, .. }) = contours.get(at + 1) else { continue };
            let fault = codes::S2091::island_does_not_lie_inside_pocket(&call.name);
            let place = call.loc;
            return self.refuse_elsewhere(Elsewhere { place, fault, call: Label::PocketMilled });
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
