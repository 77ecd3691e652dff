//! POCKET1 to POCKET4, SLOT1, SLOT2 and LONGHOLE.
//!
//! Source: M 7.4 and 7.5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::pocket::{
    Cleared, Finish, Insertion, LevelChange, Pocket, PocketFault, Shape, Speed, Strategy, WallApproach,
};
use crate::ir::cycle::{Cycle, Family, LongHole};

use super::super::value::whole;
use super::call::{Act, Acts, CycleCall};
use super::milling::{Around, CLASSIC, USUAL_WIDTH};
use super::names::{
    AD, AFSL, AP1, AP2, CDIAM, CPA, CPO, CRAD, DMODE, DP1, FAL, FALD, FFCP, FFP2, GMODE, INDA, LENG, MIDA, MIDF, NUM,
    PA, PO, PRAD, RAD, RAD1, SSF, STA, STA1, STA2, VARI, WID,
};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

/// Arguments of POCKET4 where its fifth one is a radius.
const WITH_RADIUS: usize = 19;
/// Arguments of SLOT1 and SLOT2 without codes.
const CLASSIC_SLOT: usize = 22;
/// Most slots of a call.
const MOST_SLOTS: i32 = 1000;
/// Smaller helices and strokes are none, mm.
const SMALLEST_ARM: f64 = 0.1;

/// What the units of `_VARI` ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Machining {
    rough: bool,
    wall: bool,
    floor: bool,
}

/// The smallest turn from one place on a circle to the next, degrees; a whole one of a single place.
fn least_turn(places: &[Place]) -> f64 {
    let mut turns: Vec<f64> = places.iter().map(|place| place.turn.0.rem_euclid(360.0)).collect();
    turns.sort_by(f64::total_cmp);
    let round = turns.first().map_or(360.0, |first| first + 360.0);
    let next = turns.iter().skip(1).copied().chain([round]);
    next.zip(&turns).map(|(next, turn)| next - turn).fold(360.0, f64::min)
}

/// Distance of two points on a circle; below 0 where they have passed each other.
fn chord(radius: f64, turn: f64) -> f64 {
    let (sin, _) = Deg(turn.min(180.0) / 2.0).sin_cos();
    2.0 * radius * sin
}

impl CycleCall<'_> {
    /// POCKET3
    pub(super) fn rectangular_pocket(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let shape = self.rectangle(&mill)?;
        let Shape::Rectangle { half, .. } = shape else { return Ok(Acts::new()) };
        let turn = Deg(self.given.or_zero(STA));
        let [x, y] = match self.given.digit(GMODE, 3) {
            2 => [half[0], half[1]],
            3 => [-half[0], half[1]],
            4 => [half[0], -half[1]],
            5 => [-half[0], -half[1]],
            _ => [0.0; 2],
        };
        let reference = Place { at: self.reference_point(PA, PO), turn };
        let place = Place { at: reference.point(Point2::new(x, y)), turn };
        let asked = self.asked(&[1, 2, 3, 4])?;
        let cleared = self.cleared([AP1, AP2])?;
        let insertion = self.insertion(&mill, 3, cleared.is_some())?;
        let pocket = Pocket { cleared, insertion, ..self.pocket(mill, shape, vec![place], asked)? };
        self.mill_pocket(pocket)
    }

    /// POCKET4
    pub(super) fn circular_pocket(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let size = self.given.magnitude(CDIAM);
        let by_radius = self.given.count() <= WITH_RADIUS;
        let radius = if by_radius { size } else { size / 2.0 };
        if by_radius {
            self.own_way(codes::P8101::without_codes_behind_dp1_fifth_argument());
        }
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(0.0) };
        let asked = self.asked(&[1, 2, 3, 4])?;
        let cleared = self.cleared([AP1, AP1])?;
        let strategy = match self.given.digit(VARI, 3) {
            0 => Strategy::Levels,
            1 => Strategy::Helix,
            _ => return self.no_such_machining("thousands 0 mills level by level, 1 on helices"),
        };
        let insertion = match strategy {
            Strategy::Levels => self.insertion(&mill, 2, cleared.is_some())?,
            Strategy::Helix => Insertion::Vertical,
        };
        let pocket =
            Pocket { cleared, insertion, strategy, ..self.pocket(mill, Shape::Circle { radius }, vec![place], asked)? };
        self.mill_pocket(pocket)
    }

    /// POCKET1
    pub(super) fn old_rectangular_pocket(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let shape = self.rectangle(&mill)?;
        let place = Place { at: self.reference_point(CPA, CPO), turn: Deg(self.given.or_zero(STA1)) };
        self.old_pocket(mill, shape, place)
    }

    /// POCKET2
    pub(super) fn old_circular_pocket(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let radius = self.given.magnitude(PRAD);
        let place = Place { at: self.reference_point(CPA, CPO), turn: Deg(0.0) };
        self.old_pocket(mill, Shape::Circle { radius }, place)
    }

    fn old_pocket(&self, mill: Mill, shape: Shape, place: Place) -> Made<Acts> {
        let asked = self.asked_or_complete()?;
        let pocket = self.with_own_finish(self.pocket(mill, shape, vec![place], asked)?)?;
        self.mill_pocket(pocket)
    }

    /// SLOT1
    pub(super) fn slots(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let (length, width) = (self.given.magnitude(LENG), self.given.magnitude(WID));
        let rad = self.given.magnitude(RAD);
        let between = length - width;
        let centred = self.slot_is_centred()?;
        let shape = if centred {
            Shape::Slot { from: -between / 2.0, to: between / 2.0, width }
        } else {
            Shape::Slot { from: rad + width / 2.0, to: rad + length - width / 2.0, width }
        };
        let places = self.places()?;
        if centred && places.len() > 1 {
            return self.refuse_argument(NUM, codes::P2090::slots_about_one_point_run_into_each());
        }
        if places.len() > 1 {
            self.slots_are_apart(chord(shape.entry().x, least_turn(&places)), width)?;
        }
        let asked = self.asked_or_complete()?;
        let insertion = self.slot_insertion()?;
        let pocket = Pocket { insertion, ..self.pocket(mill, shape, places, asked)? };
        let pocket = self.with_own_finish(pocket)?;
        self.mill_pocket(pocket)
    }

    /// SLOT2
    pub(super) fn circular_slots(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let (radius, width) = (self.given.magnitude(RAD), self.given.magnitude(WID));
        let sweep = self.given.or_zero(AFSL);
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse_argument(AFSL, codes::P2090::angle_of_slot_afsl());
        }
        if radius <= width / 2.0 {
            return self.refuse_argument(RAD, codes::P2090::radius_rad(&radius));
        }
        let shape = Shape::Bow { radius, sweep: Deg(sweep), width };
        self.own_way(codes::P8101::angle_of_slot_is_taken_between_centres());
        let places = self.places()?;
        self.slots_are_apart(chord(radius, least_turn(&places) - sweep), width)?;
        let asked = self.asked_or_complete()?;
        let insertion = self.slot_insertion()?;
        let transfer = if self.given.or_zero(FFCP) > 0.0 { Some(self.mill_feed(FFCP)?) } else { None };
        let pocket = Pocket { insertion, transfer, ..self.pocket(mill, shape, places, asked)? };
        let pocket = self.with_own_finish(pocket)?;
        self.mill_pocket(pocket)
    }

    /// LONGHOLE
    pub(super) fn long_holes(&self) -> Made<Acts> {
        let given = self.given;
        let mill = self.mill(&CLASSIC)?;
        if given.or_zero(VARI) != 0.0 {
            return self.no_such_machining("LONGHOLE knows 0 only");
        }
        let (length, rad) = (self.given.magnitude(LENG), self.given.magnitude(RAD));
        if length <= 2.0 * mill.radius {
            return self.refuse_argument(LENG, codes::P2090::length_leng(&length));
        }
        let ends = [rad + mill.radius, rad + length - mill.radius].map(|way| Point2::new(way, 0.0));
        let places = self.places()?;
        let holes: Vec<_> = places.iter().map(|place| ends.map(|end| place.point(end))).collect();
        if places.len() > 1 {
            self.slots_are_apart(chord(ends[0].x, least_turn(&places)), 2.0 * mill.radius)?;
        }
        self.own_way(codes::P8101::length_is_taken_over_outer_edges());
        Ok(vec![Act::Cycle(Cycle::LongHole(LongHole { mill, holes, home: None }))])
    }

    /// Sizes and corners of POCKET1 and POCKET3.
    fn rectangle(&self, mill: &Mill) -> Made<Shape> {
        let half = [self.given.magnitude(LENG) / 2.0, self.given.magnitude(WID) / 2.0];
        let corner = self.given.magnitude(CRAD);
        if corner == 0.0 {
            self.leaves_open(codes::S8230::no_corner_radius());
        } else if corner < mill.radius - 1e-9 {
            return self.refuse_argument(
                CRAD,
                codes::P2090::corner_radius_of_mm_is_smaller(
                    &self.given.written(CRAD),
                    &self.given.argument(CRAD),
                    &corner,
                    &mill.radius,
                ),
            );
        }
        Ok(Shape::Rectangle { half, corner })
    }

    pub(super) fn reference_point(&self, first: Name, second: Name) -> Point2 {
        Point2::new(self.given.length(first), self.given.length(second))
    }

    /// What the units of `_VARI` ask for, among `known` digits.
    fn asked(&self, known: &[i32]) -> Made<Machining> {
        let unit = self.given.digit(VARI, 0);
        if unit == 5 {
            return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported());
        }
        let more = self.given.whole(VARI).unsigned_abs() / 10_000;
        let other = self.given.digit(VARI, 2) > 0 || self.given.digit(VARI, 3) > 0 && self.given.argument(CDIAM) == 0;
        if !known.contains(&unit) || more > 0 || other {
            return self.no_such_machining("units 1 roughs, 2 finishes wall and floor, 3 the floor, 4 the wall");
        }
        Ok(match unit {
            0 => Machining { rough: true, wall: true, floor: true },
            1 => Machining { rough: true, wall: false, floor: false },
            2 => Machining { rough: false, wall: true, floor: true },
            3 => Machining { rough: false, wall: false, floor: true },
            _ => Machining { rough: false, wall: true, floor: false },
        })
    }

    /// The same for the cycles that know 0, and whose floor has an allowance in newer software only.
    fn asked_or_complete(&self) -> Made<Machining> {
        let asked = self.asked(&[0, 1, 2, 4])?;
        Ok(Machining { floor: asked.floor && self.given.magnitude(FALD) > 0.0, ..asked })
    }

    pub(super) fn no_such_machining<T>(&self, help: &str) -> Made<T> {
        let (name, place) = (self.given.written(VARI), self.given.argument(VARI));
        self.refuse_argument(VARI, codes::P2090::there_is_no_such_kind(&name, &place).help(help))
    }

    /// What all pockets and slots take.
    fn pocket(&self, mill: Mill, shape: Shape, places: Vec<Place>, asked: Machining) -> Made<Pocket> {
        let finish = (asked.wall || asked.floor).then_some(Finish {
            wall: asked.wall,
            floor: asked.floor,
            feed: mill.feeds.plane,
            step: mill.heights.step,
            speed: None,
            onto: WallApproach::Usual,
            inserts: false,
        });
        let width = if self.given.argument(MIDA) > 0 {
            self.width(MIDA, mill.radius)?
        } else {
            USUAL_WIDTH * 2.0 * mill.radius
        };
        Ok(Pocket {
            counter_clockwise: self.goes_counter_clockwise(Around::Inside)?,
            allowance: self.allowance(&mill, &shape),
            mill,
            shape,
            places,
            width,
            insertion: Insertion::Vertical,
            strategy: Strategy::Levels,
            rough: asked.rough,
            finish,
            cleared: None,
            transfer: None,
            between: LevelChange::Straight,
            home: None,
        })
    }

    /// The allowance on the wall; in a slot no more than there is room for.
    fn allowance(&self, mill: &Mill, shape: &Shape) -> f64 {
        let asked = self.given.magnitude(FAL);
        let room = match shape {
            Shape::Slot { .. } | Shape::Bow { .. } => shape.room(mill.radius).least(),
            Shape::Rectangle { .. } | Shape::Circle { .. } => return asked,
        };
        if room >= 0.0 && asked > room {
            self.leaves_open(codes::S8230::allowance_on_wall_is_mm(&room));
            return room;
        }
        asked
    }

    /// Finishing with data of its own: MIDF, FFP2, SSF.
    fn with_own_finish(&self, mut pocket: Pocket) -> Made<Pocket> {
        let feed = if self.given.or_zero(FFP2) == 0.0 { pocket.mill.feeds.plane } else { self.mill_feed(FFP2)? };
        let speed = self.given.or_zero(SSF).abs();
        if speed > 0.0 && self.st.spindles.is_cutting() {
            return self.refuse_argument(SSF, codes::S9015::speed_for_finishing_under_g96_is_not());
        }
        if speed > 0.0 {
            self.master_is_main(self.given.place_of(SSF), "a speed for finishing")?;
            if self.st.spindles.speed().is_none() {
                self.leaves_open(codes::S8230::speed_of_finishing_stays());
            }
        }
        let speed = (speed > 0.0).then(|| Speed { finishing: speed, after: self.st.spindles.speed() });
        let step = self.given.magnitude(MIDF);
        if let Some(finish) = &mut pocket.finish {
            (finish.step, finish.feed, finish.speed) = (step, feed, speed);
        }
        Ok(pocket)
    }

    /// How the tool gets to a level, by the tens of `_VARI` up to `most`. Is a part `cleared`, the hole is as deep as that.
    fn insertion(&self, mill: &Mill, most: i32, cleared: bool) -> Made<Insertion> {
        let given = self.given;
        let asked = given.digit(VARI, 1);
        Ok(match asked {
            _ if asked > most => {
                return self.no_such_machining("tens 0 and 1 straight down, 2 on a helix, 3 to and fro (POCKET3)");
            }
            // Finishing goes straight down.
            _ if given.digit(VARI, 0) != 1 => Insertion::Vertical,
            0 if !cleared => {
                self.needs_predrilled();
                Insertion::Predrilled
            }
            0 | 1 => Insertion::Vertical,
            2 => {
                let (radius, pitch) = (self.given.magnitude(RAD1), self.given.magnitude(DP1));
                if pitch == 0.0 {
                    return self.refuse_argument(DP1, codes::P2090::pitch_of_helix_dp1_is_0(&given.argument(DP1)));
                }
                if radius > mill.radius {
                    self.leaves_open(codes::S8230::radius_of_helix_is_mm_only_larger(&mill.radius));
                }
                Insertion::Helix { radius, pitch }
            }
            _ => {
                let angle = given.or_zero(RAD1).abs();
                if angle == 0.0 || angle >= 90.0 {
                    let place = given.argument(RAD1);
                    return self.refuse_argument(RAD1, codes::P2090::angle_of_insertion_rad1_is_above_0(&place));
                }
                Insertion::Ramp { angle: Deg(angle), stroke: None }
            }
        })
    }

    /// The same for slots: to and fro over their whole length by STA2.
    fn slot_insertion(&self) -> Made<Insertion> {
        let classic = self.given.count() <= CLASSIC_SLOT;
        Ok(match self.given.digit(VARI, 1) {
            0 if classic => {
                self.own_way(codes::P8101::tool_goes_straight_down_at_feed());
                Insertion::Vertical
            }
            0 => {
                self.needs_predrilled();
                Insertion::Predrilled
            }
            1 => Insertion::Vertical,
            2 => return self.refuse_argument(VARI, codes::S9015::helix_in_slot()),
            3 => {
                let angle = self.given.or_zero(STA2).abs();
                if angle >= 90.0 {
                    return self
                        .refuse_argument(STA2, codes::P2090::angle_sta2_is_below_90(&self.given.argument(STA2)));
                }
                Insertion::Ramp { angle: Deg(angle), stroke: None }
            }
            _ => return self.no_such_machining("tens 0 and 1 straight down, 3 to and fro"),
        })
    }

    fn needs_predrilled(&self) {
        self.leaves_open(codes::S8230::tool_goes_down_at_rapid_traverse());
    }

    /// What was cleared before: its sizes and its depth, unless the codes say that they do not count.
    fn cleared(&self, keys: [Name; 2]) -> Made<Option<Cleared>> {
        let sizes = keys.map(|key| self.given.magnitude(key));
        let depth = self.given.magnitude(AD);
        if self.given.digit(GMODE, 4) == 1 {
            return Ok(None);
        }
        if sizes.contains(&0.0) || depth == 0.0 {
            for key in [AP1, AP2, AD].into_iter().filter(|key| self.given.or_zero(*key) != 0.0) {
                self.unused(key, "where the other sizes of what was cleared before are 0");
            }
            return Ok(None);
        }
        Ok(Some(Cleared { half: sizes.map(|size| size / 2.0), depth }))
    }

    /// Slot 1 lies about its own centre, or along a ray from it.
    fn slot_is_centred(&self) -> Made<bool> {
        let given = self.given;
        if given.count() <= CLASSIC_SLOT {
            return Ok(false);
        }
        if given.digit(GMODE, 3) >= 1 {
            self.own_way(codes::P8101::slot_lies_about_cpa());
            return Ok(true);
        }
        let single = given.or_zero(NUM) == 1.0 && given.digit(DMODE, 3) == 1;
        if single {
            self.own_way(codes::P8101::single_slot_of_editor_lies_about_cpa());
        }
        Ok(single)
    }

    /// The places of slots on a circle.
    fn places(&self) -> Made<Vec<Place>> {
        let given = self.given;
        let count = given.number(NUM).unwrap_or(1.0);
        let count = match whole(count).filter(|number| count.fract() == 0.0 && (1..=MOST_SLOTS).contains(number)) {
            Some(count) => count,
            None => {
                return self.refuse_argument(NUM, codes::P2090::number_num_is_1(&given.argument(NUM), &MOST_SLOTS));
            }
        };
        let step = match given.or_zero(INDA) {
            0.0 => 360.0 / f64::from(count),
            step => step,
        };
        let at = self.reference_point(CPA, CPO);
        Ok((0..count).map(|i| Place { at, turn: Deg(given.or_zero(STA1) + f64::from(i) * step) }).collect())
    }

    /// Neighbours, whose centres come within `gap`, do not run into each other.
    fn slots_are_apart(&self, gap: f64, width: f64) -> Made {
        if gap >= width - 1e-9 {
            return Ok(());
        }
        self.refuse_argument(NUM, codes::P2090::neighbours_run_into_each_other(&gap, &width))
    }

    fn mill_pocket(&self, pocket: Pocket) -> Made<Acts> {
        if let Err(fault) = pocket.check() {
            return self.pocket_fault(&pocket, fault);
        }
        self.insertion_has_room(&pocket);
        self.own_way(codes::P8101::rings_of_level());
        Ok(vec![Act::Cycle(Cycle::Pocket(pocket))])
    }

    /// Says where the way down is another one than asked for.
    fn insertion_has_room(&self, pocket: &Pocket) {
        let turns = pocket.shape.room(pocket.rough_distance()).least();
        if pocket.strategy == Strategy::Helix && turns < SMALLEST_ARM / 2.0 {
            self.leaves_open(codes::S8230::there_is_no_room_for_helical_turns());
        }
        match pocket.insertion {
            Insertion::Helix { radius, .. } if pocket.rough => {
                let made = pocket.helix_radius(radius);
                if made < SMALLEST_ARM {
                    self.leaves_open(codes::S8230::there_is_no_room_for_helix());
                } else if radius.min(pocket.mill.radius) > made {
                    self.leaves_open(codes::S8230::radius_of_helix_is_mm(&made));
                }
            }
            Insertion::Ramp { .. } if pocket.rough && pocket.sway_room() < SMALLEST_ARM => {
                self.leaves_open(codes::S8230::there_is_no_room_to_go());
            }
            _ => {}
        }
    }

    fn pocket_fault<T>(&self, pocket: &Pocket, fault: PocketFault) -> Made<T> {
        let at = match fault {
            PocketFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            PocketFault::Cutter => {
                let name = [WID, PRAD, CDIAM].into_iter().find(|name| self.given.takes(*name)).unwrap_or(WID);
                let (written, place) = (self.given.written(name), self.given.argument(name));
                let diameter = 2.0 * pocket.mill.radius;
                return self
                    .refuse_argument(name, codes::P2090::cutter_does_not_fit(&fault, &written, &place, &diameter));
            }
            PocketFault::Corner => (CRAD, 61113, "give at most half of the smaller side"),
            PocketFault::Length => (LENG, 61118, "a slot is longer than it is wide"),
            PocketFault::Width | PocketFault::TooManyRings => (MIDA, 61111, "give a usual width of a cut"),
            PocketFault::Pitch => (DP1, 61019, "give the depth of one turn"),
            PocketFault::FinishingStep => (MIDF, 61019, "give a larger infeed, or 0 for one cut"),
            PocketFault::Insertion => (VARI, 61019, "check the data of the insertion"),
            PocketFault::Number | PocketFault::Nothing => (VARI, 61019, "check the arguments of the cycle"),
        };
        self.unsound(at, &fault)
    }
}
