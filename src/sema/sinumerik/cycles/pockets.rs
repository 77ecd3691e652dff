//! POCKET1 to POCKET4, SLOT1, SLOT2 and LONGHOLE.
//!
//! Source: M 7.4 and 7.5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::pocket::{
    Between, Cleared, Finish, Insertion, Onto, Pocket, PocketFault, Shape, Speed, Strategy,
};
use crate::ir::cycle::{Cycle, Family, LongHole};

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{
    AD, AFSL, AP1, AP2, CDIAM, CPA, CPO, CRAD, DMODE, DP1, FAL, FALD, FFCP, FFP2, GMODE, INDA, Key, LENG, MIDA, MIDF,
    NUM, PA, PO, PRAD, RAD, RAD1, SSF, STA, STA1, STA2, VARI, WID,
};
use super::call::CycleCall;
use super::milling::{Around, CLASSIC};

/// Arguments of POCKET4 where its fifth one is a radius.
const WITH_RADIUS: usize = 19;
/// Arguments of SLOT1 and SLOT2 without codes.
const CLASSIC_SLOT: usize = 22;
/// Most slots of a call.
const MOST_SLOTS: i32 = 1000;
/// Smaller helices and strokes are none, mm.
const SMALLEST_ARM: f64 = 0.1;
/// The part of the cutter that is a cut's width where the cycle has no argument for it.
const USUAL_WIDTH: f64 = 0.8;

/// What the units of `_VARI` ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Asked {
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

impl CycleCall<'_, '_> {
    /// POCKET3
    pub(super) fn rectangular_pocket(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let shape = self.rectangle(&mill)?;
        let Shape::Rectangle { half, .. } = shape else { return Ok(()) };
        let turn = Deg(self.args.or_zero(STA));
        let [x, y] = match self.args.digit(GMODE, 3) {
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
    pub(super) fn circular_pocket(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let size = self.size(CDIAM)?;
        let by_radius = self.args.list.len() <= WITH_RADIUS;
        let radius = if by_radius { size } else { size / 2.0 };
        if by_radius {
            self.own_way(codes::P8101::without_codes_behind_dp1_fifth_argument());
        }
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(0.0) };
        let asked = self.asked(&[1, 2, 3, 4])?;
        let cleared = self.cleared([AP1, AP1])?;
        let strategy = match self.args.digit(VARI, 3) {
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
    pub(super) fn old_rectangular_pocket(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let shape = self.rectangle(&mill)?;
        let place = Place { at: self.reference_point(CPA, CPO), turn: Deg(self.args.or_zero(STA1)) };
        self.old_pocket(mill, shape, place)
    }

    /// POCKET2
    pub(super) fn old_circular_pocket(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let radius = self.size(PRAD)?;
        let place = Place { at: self.reference_point(CPA, CPO), turn: Deg(0.0) };
        self.old_pocket(mill, Shape::Circle { radius }, place)
    }

    fn old_pocket(&mut self, mill: Mill, shape: Shape, place: Place) -> Outcome {
        let asked = self.asked_or_complete()?;
        let pocket = self.with_own_finish(self.pocket(mill, shape, vec![place], asked)?)?;
        self.mill_pocket(pocket)
    }

    /// SLOT1
    pub(super) fn slots(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let (length, width) = (self.size(LENG)?, self.size(WID)?);
        let rad = self.magnitude(RAD);
        let between = length - width;
        let centred = self.slot_is_centred()?;
        let shape = if centred {
            Shape::Slot { from: -between / 2.0, to: between / 2.0, width }
        } else {
            Shape::Slot { from: rad + width / 2.0, to: rad + length - width / 2.0, width }
        };
        let places = self.places()?;
        if centred && places.len() > 1 {
            return self.refuse_cycle(self.args.span_of(NUM), codes::P2090::slots_about_one_point_run_into_each());
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
    pub(super) fn circular_slots(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let (radius, width) = (self.size(RAD)?, self.size(WID)?);
        let sweep = self.args.or_zero(AFSL);
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse_cycle(self.args.span_of(AFSL), codes::P2090::angle_of_slot_afsl());
        }
        if radius <= width / 2.0 {
            return self.refuse_cycle(self.args.span_of(RAD), codes::P2090::radius_rad(&radius));
        }
        let shape = Shape::Bow { radius, sweep: Deg(sweep), width };
        self.own_way(codes::P8101::angle_of_slot_is_taken_between_centres());
        let places = self.places()?;
        self.slots_are_apart(chord(radius, least_turn(&places) - sweep), width)?;
        let asked = self.asked_or_complete()?;
        let insertion = self.slot_insertion()?;
        let transfer = if self.args.or_zero(FFCP) > 0.0 { Some(self.mill_feed(FFCP)?) } else { None };
        let pocket = Pocket { insertion, transfer, ..self.pocket(mill, shape, places, asked)? };
        let pocket = self.with_own_finish(pocket)?;
        self.mill_pocket(pocket)
    }

    /// LONGHOLE
    pub(super) fn long_holes(&mut self) -> Outcome {
        let args = self.args;
        let mill = self.mill(&CLASSIC)?;
        if args.or_zero(VARI) != 0.0 {
            return self.no_such_machining("LONGHOLE knows 0 only");
        }
        let (length, rad) = (self.size(LENG)?, self.magnitude(RAD));
        if length <= 2.0 * mill.radius {
            return self.refuse_cycle(args.span_of(LENG), codes::P2090::length_leng(&length));
        }
        let ends = [rad + mill.radius, rad + length - mill.radius].map(|way| Point2::new(way, 0.0));
        let places = self.places()?;
        let holes: Vec<_> = places.iter().map(|place| ends.map(|end| place.point(end))).collect();
        if places.len() > 1 {
            self.slots_are_apart(chord(ends[0].x, least_turn(&places)), 2.0 * mill.radius)?;
        }
        self.own_way(codes::P8101::length_is_taken_over_outer_edges());
        self.send_cycle(Cycle::LongHole(LongHole { mill, holes, home: None }));
        Ok(())
    }

    /// Sizes and corners of POCKET1 and POCKET3.
    fn rectangle(&self, mill: &Mill) -> Outcome<Shape> {
        let half = [self.size(LENG)? / 2.0, self.size(WID)? / 2.0];
        let corner = self.magnitude(CRAD);
        if corner == 0.0 {
            self.leaves_open(codes::S8230::no_corner_radius());
        } else if corner < mill.radius - 1e-9 {
            return self.refuse_cycle(
                self.args.span_of(CRAD),
                codes::P2090::corner_radius_of_mm_is_smaller(
                    &self.args.written(CRAD),
                    &self.args.place(CRAD),
                    &corner,
                    &mill.radius,
                ),
            );
        }
        Ok(Shape::Rectangle { half, corner })
    }

    /// A size above 0, without its sign.
    pub(super) fn size(&self, key: Key) -> Outcome<f64> {
        let size = self.magnitude(key);
        if size > 0.0 {
            return Ok(size);
        }
        let (name, place) = (self.args.written(key), self.args.place(key));
        self.refuse_cycle(self.args.span_of(key), codes::P2090::size_is_0_or_missing(&name, &place))
    }

    pub(super) fn reference_point(&self, first: Key, second: Key) -> Point2 {
        Point2::new(self.length_of(self.args, first).unwrap_or(0.0), self.length_of(self.args, second).unwrap_or(0.0))
    }

    /// What the units of `_VARI` ask for, among `known` digits.
    fn asked(&self, known: &[i32]) -> Outcome<Asked> {
        let unit = self.args.digit(VARI, 0);
        if unit == 5 {
            return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported());
        }
        let more = self.args.number(VARI).and_then(whole).unwrap_or(0).unsigned_abs() / 10_000;
        let other = self.args.digit(VARI, 2) > 0 || self.args.digit(VARI, 3) > 0 && self.args.place(CDIAM) == 0;
        if !known.contains(&unit) || more > 0 || other {
            return self.no_such_machining("units 1 roughs, 2 finishes wall and floor, 3 the floor, 4 the wall");
        }
        Ok(match unit {
            0 => Asked { rough: true, wall: true, floor: true },
            1 => Asked { rough: true, wall: false, floor: false },
            2 => Asked { rough: false, wall: true, floor: true },
            3 => Asked { rough: false, wall: false, floor: true },
            _ => Asked { rough: false, wall: true, floor: false },
        })
    }

    /// The same for the cycles that know 0, and whose floor has an allowance in newer software only.
    fn asked_or_complete(&self) -> Outcome<Asked> {
        let asked = self.asked(&[0, 1, 2, 4])?;
        Ok(Asked { floor: asked.floor && self.magnitude(FALD) > 0.0, ..asked })
    }

    pub(super) fn no_such_machining<T>(&self, help: &str) -> Outcome<T> {
        let (name, place) = (self.args.written(VARI), self.args.place(VARI));
        self.refuse_cycle(self.args.span_of(VARI), codes::P2090::there_is_no_such_kind(&name, &place).help(help))
    }

    /// What all pockets and slots take.
    fn pocket(&self, mill: Mill, shape: Shape, places: Vec<Place>, asked: Asked) -> Outcome<Pocket> {
        let finish = (asked.wall || asked.floor).then_some(Finish {
            wall: asked.wall,
            floor: asked.floor,
            feed: mill.feeds.plane,
            step: mill.heights.step,
            speed: None,
            onto: Onto::Usual,
            inserts: false,
        });
        let width =
            if self.args.place(MIDA) > 0 { self.width(MIDA, mill.radius)? } else { USUAL_WIDTH * 2.0 * mill.radius };
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
            between: Between::Straight,
            home: None,
        })
    }

    /// The allowance on the wall; in a slot no more than there is room for.
    fn allowance(&self, mill: &Mill, shape: &Shape) -> f64 {
        let asked = self.magnitude(FAL);
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
    fn with_own_finish(&mut self, mut pocket: Pocket) -> Outcome<Pocket> {
        let feed = if self.args.or_zero(FFP2) == 0.0 { pocket.mill.feeds.plane } else { self.mill_feed(FFP2)? };
        let speed = self.args.or_zero(SSF).abs();
        if speed > 0.0 && self.st.spindles.is_cutting() {
            return self.refuse_argument(SSF, codes::S9015::speed_for_finishing_under_g96_is_not());
        }
        if speed > 0.0 {
            self.master_is_main(self.args.span_of(SSF), "a speed for finishing")?;
            if self.st.spindles.speed().is_none() {
                self.leaves_open(codes::S8230::speed_of_finishing_stays());
            }
        }
        let speed = (speed > 0.0).then(|| Speed { finishing: speed, after: self.st.spindles.speed() });
        let step = self.magnitude(MIDF);
        if let Some(finish) = &mut pocket.finish {
            (finish.step, finish.feed, finish.speed) = (step, feed, speed);
        }
        Ok(pocket)
    }

    /// How the tool gets to a level, by the tens of `_VARI` up to `most`. Is a part `cleared`, the hole is as deep as that.
    fn insertion(&mut self, mill: &Mill, most: i32, cleared: bool) -> Outcome<Insertion> {
        let args = self.args;
        let asked = args.digit(VARI, 1);
        Ok(match asked {
            _ if asked > most => {
                return self.no_such_machining("tens 0 and 1 straight down, 2 on a helix, 3 to and fro (POCKET3)");
            }
            // Finishing goes straight down.
            _ if args.digit(VARI, 0) != 1 => Insertion::Vertical,
            0 if !cleared => {
                self.needs_predrilled();
                Insertion::Predrilled
            }
            0 | 1 => Insertion::Vertical,
            2 => {
                let (radius, pitch) = (self.magnitude(RAD1), self.magnitude(DP1));
                if pitch == 0.0 {
                    return self
                        .refuse_cycle(args.span_of(DP1), codes::P2090::pitch_of_helix_dp1_is_0(&args.place(DP1)));
                }
                if radius > mill.radius {
                    self.leaves_open(codes::S8230::radius_of_helix_is_mm_only_larger(&mill.radius));
                }
                Insertion::Helix { radius, pitch }
            }
            _ => {
                let angle = args.or_zero(RAD1).abs();
                if angle == 0.0 || angle >= 90.0 {
                    let place = args.place(RAD1);
                    return self
                        .refuse_cycle(args.span_of(RAD1), codes::P2090::angle_of_insertion_rad1_is_above_0(&place));
                }
                Insertion::Sway { angle: Deg(angle), stroke: None }
            }
        })
    }

    /// The same for slots: to and fro over their whole length by STA2.
    fn slot_insertion(&mut self) -> Outcome<Insertion> {
        let classic = self.args.list.len() <= CLASSIC_SLOT;
        Ok(match self.args.digit(VARI, 1) {
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
                let angle = self.args.or_zero(STA2).abs();
                if angle >= 90.0 {
                    return self.refuse_cycle(
                        self.args.span_of(STA2),
                        codes::P2090::angle_sta2_is_below_90(&self.args.place(STA2)),
                    );
                }
                Insertion::Sway { angle: Deg(angle), stroke: None }
            }
            _ => return self.no_such_machining("tens 0 and 1 straight down, 3 to and fro"),
        })
    }

    fn needs_predrilled(&self) {
        self.leaves_open(codes::S8230::tool_goes_down_at_rapid_traverse());
    }

    /// What was cleared before: its sizes and its depth, unless the codes say that they do not count.
    fn cleared(&self, keys: [Key; 2]) -> Outcome<Option<Cleared>> {
        let sizes = keys.map(|key| self.magnitude(key));
        let depth = self.magnitude(AD);
        if self.args.digit(GMODE, 4) == 1 {
            return Ok(None);
        }
        if sizes.contains(&0.0) || depth == 0.0 {
            for key in [AP1, AP2, AD].into_iter().filter(|key| self.args.or_zero(*key) != 0.0) {
                self.unused(key, &self.args.written(key), "where the other sizes of what was cleared before are 0");
            }
            return Ok(None);
        }
        Ok(Some(Cleared { half: sizes.map(|size| size / 2.0), depth }))
    }

    /// Slot 1 lies about its own centre, or along a ray from it.
    fn slot_is_centred(&self) -> Outcome<bool> {
        let args = self.args;
        if args.list.len() <= CLASSIC_SLOT {
            return Ok(false);
        }
        if args.digit(GMODE, 3) >= 1 {
            self.own_way(codes::P8101::slot_lies_about_cpa());
            return Ok(true);
        }
        let single = args.or_zero(NUM) == 1.0 && args.digit(DMODE, 3) == 1;
        if single {
            self.own_way(codes::P8101::single_slot_of_editor_lies_about_cpa());
        }
        Ok(single)
    }

    /// The places of slots on a circle.
    fn places(&self) -> Outcome<Vec<Place>> {
        let args = self.args;
        let count = args.number(NUM).unwrap_or(1.0);
        let count = match whole(count).filter(|number| count.fract() == 0.0 && (1..=MOST_SLOTS).contains(number)) {
            Some(count) => count,
            None => {
                return self
                    .refuse_cycle(args.span_of(NUM), codes::P2090::number_num_is_1(&args.place(NUM), &MOST_SLOTS));
            }
        };
        let step = match args.or_zero(INDA) {
            0.0 => 360.0 / f64::from(count),
            step => step,
        };
        let at = self.reference_point(CPA, CPO);
        Ok((0..count).map(|i| Place { at, turn: Deg(args.or_zero(STA1) + f64::from(i) * step) }).collect())
    }

    /// Neighbours, whose centres come within `gap`, do not run into each other.
    fn slots_are_apart(&self, gap: f64, width: f64) -> Outcome {
        if gap >= width - 1e-9 {
            return Ok(());
        }
        self.refuse_cycle(self.args.span_of(NUM), codes::P2090::neighbours_run_into_each_other(&gap, &width))
    }

    fn mill_pocket(&mut self, pocket: Pocket) -> Outcome {
        if let Err(fault) = pocket.check() {
            return self.pocket_fault(&pocket, fault);
        }
        self.insertion_has_room(&pocket);
        self.own_way(codes::P8101::rings_of_level());
        self.send_cycle(Cycle::Pocket(pocket));
        Ok(())
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
            Insertion::Sway { .. } if pocket.rough && pocket.sway_room() < SMALLEST_ARM => {
                self.leaves_open(codes::S8230::there_is_no_room_to_go());
            }
            _ => {}
        }
    }

    fn pocket_fault(&self, pocket: &Pocket, fault: PocketFault) -> Outcome {
        let (key, alarm, help) = match fault {
            PocketFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            PocketFault::Cutter => {
                let keys = [WID, PRAD, CDIAM];
                let key = keys.into_iter().find(|key| self.args.place(*key) > 0).unwrap_or(WID);
                (key, Some(61105), "take a smaller cutter, or a smaller allowance")
            }
            PocketFault::Corner => (CRAD, Some(61113), "give at most half of the smaller side"),
            PocketFault::Length => (LENG, Some(61118), "a slot is longer than it is wide"),
            PocketFault::Width | PocketFault::TooManyRings => (MIDA, Some(61111), "give a usual width of a cut"),
            PocketFault::Pitch => (DP1, Some(61019), "give the depth of one turn"),
            PocketFault::FinishingStep => (MIDF, Some(61019), "give a larger infeed, or 0 for one cut"),
            PocketFault::Insertion => (VARI, Some(61019), "check the data of the insertion"),
            PocketFault::Number | PocketFault::Nothing => (VARI, Some(61019), "check the arguments of the cycle"),
        };
        let (name, place) = (self.args.written(key), self.args.place(key));
        let message = match fault {
            PocketFault::Cutter => {
                format!("{fault}: `{name}` (argument {place}), cutter {} mm", 2.0 * pocket.mill.radius)
            }
            _ => format!("{fault}: `{name}` (argument {place})"),
        };
        self.cycle_fault(self.args.span_of(key), alarm, &message, help)
    }
}
