//! POCKET1 to POCKET4, SLOT1, SLOT2 and LONGHOLE.
//!
//! Source: M 7.4 and 7.5 (docs/sources.md).

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
            self.own_way("without codes behind `_DP1` the fifth argument is read as the radius, not as the diameter");
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
            let help = "give 1, or 0 in the thousands of `_GMODE` for slots on a circle";
            let what = "slots about one point run into each other: `NUM` (argument 6)";
            return self.cycle_fault(self.args.span_of(NUM), 61104, what, help);
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
            let help = "give an angle above 0 and below 360 degrees";
            return self.cycle_fault(
                self.args.span_of(AFSL),
                61118,
                "the angle of the slot `AFSL` (argument 7) is out of range",
                help,
            );
        }
        if radius <= width / 2.0 {
            let message = format!("the radius `RAD` (argument 11) of {radius} mm is not larger than half of the width");
            let help = "give a larger radius, or mill the ring as a pocket";
            return self.cycle_fault(self.args.span_of(RAD), 61118, &message, help);
        }
        let shape = Shape::Bow { radius, sweep: Deg(sweep), width };
        self.own_way("the angle of a slot is taken between the centres of its round ends");
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
            let message = format!("the length `LENG` (argument 7) of {length} mm has no room for the cutter");
            let help = "give a length above the diameter of the cutter, or drill the hole";
            return self.cycle_fault(args.span_of(LENG), 61105, &message, help);
        }
        let ends = [rad + mill.radius, rad + length - mill.radius].map(|way| Point2::new(way, 0.0));
        let places = self.places()?;
        let holes: Vec<_> = places.iter().map(|place| ends.map(|end| place.point(end))).collect();
        if places.len() > 1 {
            self.slots_are_apart(chord(ends[0].x, least_turn(&places)), 2.0 * mill.radius)?;
        }
        self.own_way("the length is taken over the outer edges, and the depth goes down at each end");
        self.send_cycle(Cycle::LongHole(LongHole { mill, holes, home: None }));
        Ok(())
    }

    /// Sizes and corners of POCKET1 and POCKET3.
    fn rectangle(&self, mill: &Mill) -> Outcome<Shape> {
        let half = [self.size(LENG)? / 2.0, self.size(WID)? / 2.0];
        let corner = self.magnitude(CRAD);
        if corner == 0.0 {
            self.says_once(
                "no corner radius: the corners keep the radius of the cutter",
                "give the radius of the corners",
            );
        } else if corner < mill.radius - 1e-9 {
            let message = format!(
                "the corner radius `{}` (argument {}) of {corner} mm is smaller than the cutter's, {} mm",
                self.args.written(CRAD),
                self.args.place(CRAD),
                mill.radius
            );
            let help = "take a smaller cutter, or give a larger corner radius";
            return self.cycle_fault(self.args.span_of(CRAD), 61113, &message, help);
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
        let message = format!("the size `{name}` (argument {place}) is 0 or missing");
        self.cycle_fault(self.args.span_of(key), 61118, &message, "give a size above 0")
    }

    pub(super) fn reference_point(&self, first: Key, second: Key) -> Point2 {
        Point2::new(self.length_of(self.args, first).unwrap_or(0.0), self.length_of(self.args, second).unwrap_or(0.0))
    }

    /// What the units of `_VARI` ask for, among `known` digits.
    fn asked(&self, known: &[i32]) -> Outcome<Asked> {
        let unit = self.args.digit(VARI, 0);
        if unit == 5 {
            return self.not_built(VARI, "chamfering (units of `_VARI`)");
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
        let message = format!("there is no such kind of machining: `{name}` (argument {place})");
        self.cycle_fault(self.args.span_of(VARI), 61002, &message, help)
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
            let message = format!("the allowance on the wall is {room} mm only: the cutter leaves no room for more");
            self.says_once(&message, "take a smaller cutter, or a smaller allowance");
            return room;
        }
        asked
    }

    /// Finishing with data of its own: MIDF, FFP2, SSF.
    fn with_own_finish(&mut self, mut pocket: Pocket) -> Outcome<Pocket> {
        let feed = if self.args.or_zero(FFP2) == 0.0 { pocket.mill.feeds.plane } else { self.mill_feed(FFP2)? };
        let speed = self.args.or_zero(SSF).abs();
        if speed > 0.0 && self.st.spindles.is_cutting() {
            return self.not_built(SSF, "a speed for finishing under G96");
        }
        if speed > 0.0 {
            self.master_is_main(self.args.span_of(SSF), "a speed for finishing")?;
            if self.st.spindles.speed().is_none() {
                self.says_once(
                    "the speed of finishing stays, as none stands in front of the cycle",
                    "program S before the cycle",
                );
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
                    let message =
                        format!("the pitch of the helix `_DP1` (argument {}) is 0 or missing", args.place(DP1));
                    return self.cycle_fault(args.span_of(DP1), 61019, &message, "give the depth of one turn");
                }
                if radius > mill.radius {
                    let message =
                        format!("the radius of the helix is {} mm only: a larger one leaves a core", mill.radius);
                    self.says_once(&message, "give at most the radius of the cutter as `_RAD1`");
                }
                Insertion::Helix { radius, pitch }
            }
            _ => {
                let angle = args.or_zero(RAD1).abs();
                if angle == 0.0 || angle >= 90.0 {
                    let place = args.place(RAD1);
                    let message = format!("the angle of insertion `_RAD1` (argument {place}) is above 0 and below 90");
                    return self.cycle_fault(args.span_of(RAD1), 61019, &message, "give the angle in degrees");
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
                self.own_way("the tool goes straight down at the feed for the depth");
                Insertion::Vertical
            }
            0 => {
                self.needs_predrilled();
                Insertion::Predrilled
            }
            1 => Insertion::Vertical,
            2 => return self.not_built(VARI, "a helix in a slot (tens of `VARI`)"),
            3 => {
                let angle = self.args.or_zero(STA2).abs();
                if angle >= 90.0 {
                    let message = format!("the angle `_STA2` (argument {}) is below 90", self.args.place(STA2));
                    return self.cycle_fault(self.args.span_of(STA2), 61019, &message, "give the angle in degrees");
                }
                Insertion::Sway { angle: Deg(angle), stroke: None }
            }
            _ => return self.no_such_machining("tens 0 and 1 straight down, 3 to and fro"),
        })
    }

    fn needs_predrilled(&self) {
        let what = "the tool goes down at rapid traverse: it needs a hole that was drilled before";
        self.says_once(what, "1 in the tens of `_VARI` goes down at the feed for the depth");
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
            self.own_way("the slot lies about CPA and CPO, and RAD is not used");
            return Ok(true);
        }
        let single = args.or_zero(NUM) == 1.0 && args.digit(DMODE, 3) == 1;
        if single {
            self.own_way("a single slot of the editor lies about CPA and CPO, and RAD is not used");
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
                let message = format!("the number `NUM` (argument {}) is 1 to {MOST_SLOTS}", args.place(NUM));
                return self.cycle_fault(args.span_of(NUM), 61103, &message, "give a whole number");
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
        let message = format!("neighbours run into each other: {gap:.4} mm between their centres, {width} mm wide");
        let help = "give a larger radius of the circle, a larger angle between them, or fewer of them";
        self.cycle_fault(self.args.span_of(NUM), 61104, &message, help)
    }

    fn mill_pocket(&mut self, pocket: Pocket) -> Outcome {
        if let Err(fault) = pocket.check() {
            return self.pocket_fault(&pocket, fault);
        }
        self.insertion_has_room(&pocket);
        self.own_way("the rings of a level, and how the tool comes to the wall, are those of partc");
        self.send_cycle(Cycle::Pocket(pocket));
        Ok(())
    }

    /// Says where the way down is another one than asked for.
    fn insertion_has_room(&self, pocket: &Pocket) {
        let straight = "the pocket has no room for it; a cutter that cannot plunge breaks";
        let turns = pocket.shape.room(pocket.rough_distance()).least();
        if pocket.strategy == Strategy::Helix && turns < SMALLEST_ARM / 2.0 {
            self.says_once(
                "there is no room for the helical turns: the tool goes straight down by the infeeds",
                straight,
            );
        }
        match pocket.insertion {
            Insertion::Helix { radius, .. } if pocket.rough => {
                let made = pocket.helix_radius(radius);
                if made < SMALLEST_ARM {
                    self.says_once("there is no room for the helix: the tool goes straight down", straight);
                } else if radius.min(pocket.mill.radius) > made {
                    self.says_once(
                        &format!("the radius of the helix is {made:.3} mm only"),
                        "the pocket has no room for more",
                    );
                }
            }
            Insertion::Sway { .. } if pocket.rough && pocket.sway_room() < SMALLEST_ARM => {
                self.says_once("there is no room to go to and fro: the tool goes straight down", straight);
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
