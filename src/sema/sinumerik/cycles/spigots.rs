//! CYCLE76, CYCLE77 and CYCLE79: spigots.
//!
//! Source: M 7.6 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::geo::Deg;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::spigot::{Blank, MOST_EDGES, Shape, SpigotFault, Starts};
use crate::ir::cycle::{Cycle, Family, Spigot};
use crate::machine::options::cycles::{MultiEdgeStart, SpigotSize};

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{AP1, AP2, CDIAM, CRAD, FAL, Key, LENG, MIDA, NUM, PA, PO, RC, STA, SWL, VARI, WID};
use super::call::CycleCall;
use super::milling::{Around, CLASSIC};

/// Arguments of CYCLE77 in its old form.
const OLD_FORM: usize = 16;

impl CycleCall<'_, '_> {
    /// CYCLE76
    pub(super) fn rectangular_spigot(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let half = [self.size(LENG)? / 2.0, self.size(WID)? / 2.0];
        let shape = Shape::Rectangle { half, corner: self.magnitude(CRAD) };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(self.args.or_zero(STA)) };
        let blank = self.blank(&[AP1, AP2])?;
        // The corner of the blank is farthest from the spigot.
        let [x, y] = [(AP1, half[0]), (AP2, half[1])].map(|(key, half)| self.magnitude(key) / 2.0 - half);
        let corner = self.magnitude(CRAD);
        let stands = match x > -corner && y > -corner {
            true => libm::hypot(x + corner, y + corner) - corner,
            false => x.max(y),
        };
        self.stock_that_stays(&mill, stands);
        self.mill_spigot(mill, place, shape, blank, None)
    }

    /// CYCLE77
    pub(super) fn circular_spigot(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let size = self.size(CDIAM)?;
        let radius = match (self.args.list.len() > OLD_FORM, self.job.settings.cycles.spigot_size) {
            (true, _) | (false, Some(SpigotSize::Diameter)) => size / 2.0,
            (false, Some(SpigotSize::Radius)) => size,
            (false, None) => {
                return self.fail_help(
                    codes::S9015,
                    self.args.span_of(CDIAM),
                    "CYCLE77 in its old form of 16 arguments: whether the sixth one is the diameter or the radius of the spigot is not confirmed",
                    Answer::key("cycles", "spigot_size").help("say it by `[cycles] spigot_size = \"diameter\"`, or write the call with the codes behind `_AP1`"),
                );
            }
        };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(0.0) };
        let blank = self.blank(&[AP1])?;
        self.stock_that_stays(&mill, blank - radius);
        self.mill_spigot(mill, place, Shape::Circle { radius }, blank, None)
    }

    /// CYCLE79
    pub(super) fn multi_edge(&mut self) -> Outcome {
        let mill = self.mill(&CLASSIC)?;
        let args = self.args;
        let edges = args.or_zero(NUM);
        if edges == 1.0 || edges == 2.0 {
            let flats = if edges == 1.0 { "one flat" } else { "two flats" };
            return self.fail_help(
                codes::S9015,
                args.span_of(NUM),
                format!(
                    "CYCLE79: {flats} on a round blank (`_NUM` {edges}, argument {}) is not supported",
                    args.place(NUM)
                ),
                "mill each flat by CYCLE61 or CYCLE72, or by plain moves",
            );
        }
        let known = whole(edges).and_then(|n| u32::try_from(n).ok()).filter(|_| edges.fract() == 0.0);
        let Some(edges) = known.filter(|n| (3..=MOST_EDGES).contains(n)) else {
            let message = format!("the number of edges `_NUM` (argument {}) is 3 to {MOST_EDGES}", args.place(NUM));
            return self.cycle_fault(args.span_of(NUM), 61019, &message, "give a whole number");
        };
        if args.or_zero(RC) != 0.0 {
            return self.not_built(RC, "a transition at the corners of a multi-edge (`_RC`)");
        }
        let starts = match self.job.settings.cycles.multi_edge_start {
            Some(MultiEdgeStart::Edge) => Starts::Edge,
            Some(MultiEdgeStart::Corner) => Starts::Corner,
            None => {
                return self.fail_help(
                    codes::S9015,
                    args.span_of(STA),
                    "CYCLE79: whether an edge or a corner of the multi-edge lies on the first axis is not confirmed",
                    Answer::key("cycles", "multi_edge_start")
                        .help("say it by `[cycles] multi_edge_start = \"edge\"` or \"corner\""),
                );
            }
        };
        let size = self.size(SWL)?;
        let apothem = if edges % 2 == 0 {
            self.own_way("an even number of edges: `_SWL` is read as the width across flats");
            size / 2.0
        } else {
            self.own_way("an odd number of edges: `_SWL` is read as the length of an edge");
            let (sin, cos) = Deg(180.0 / f64::from(edges)).sin_cos();
            size * cos / sin / 2.0
        };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(args.or_zero(STA)) };
        let blank = self.blank(&[AP1])?;
        let width = self.width(MIDA, mill.radius)?;
        self.mill_spigot(mill, place, Shape::Polygon { edges, apothem, starts }, blank, Some(width))
    }

    /// Half of the blank along the first axis; roughing needs it.
    fn blank(&self, keys: &[Key]) -> Outcome<f64> {
        for key in keys {
            if self.magnitude(*key) == 0.0 && self.args.digit(VARI, 0) == 1 {
                let (name, place) = (self.args.written(*key), self.args.place(*key));
                let message = format!("the size of the blank `{name}` (argument {place}) is 0 or missing");
                let help = "give it: outside of the blank the tool travels at rapid traverse";
                return self.cycle_fault(self.args.span_of(*key), 61019, &message, help);
            }
        }
        Ok(keys.first().map_or(0.0, |key| self.magnitude(*key) / 2.0))
    }

    /// One circuit is as wide as the cutter: says what it leaves of a blank that stands out by more.
    fn stock_that_stays(&self, mill: &Mill, stands: f64) {
        let args = self.args;
        let roughs = args.digit(VARI, 0) == 1;
        if roughs && stands < 0.0 {
            self.says_once("the blank is smaller than the spigot", "give the size of the blank in front of the cycle");
        }
        let reach = 2.0 * mill.radius + if roughs { self.magnitude(FAL) } else { 0.0 };
        let stays = stands - reach;
        // Where it finishes, the allowance on the floor is all that was left.
        if stays <= 1e-6 || !roughs && mill.heights.allowance == 0.0 {
            return;
        }
        let what = if roughs { "of the blank" } else { "with the allowance on the floor of the blank" };
        let message = format!(
            "{}: the tool goes round once, and leaves {stays:.3} mm {what} `{}` (argument {}) standing outside",
            args.name(),
            args.written(AP1),
            args.place(AP1)
        );
        let found = Diagnostic::new(codes::S8240, self.loc(args.span_of(AP1)), message);
        let help = "call the cycle several times with smaller and smaller `_FAL`, each with the blank that the one before leaves";
        self.report(found.help(help));
    }

    fn mill_spigot(&mut self, mill: Mill, place: Place, shape: Shape, blank: f64, width: Option<f64>) -> Outcome {
        let finishes_floor = match self.args.number(VARI).and_then(whole) {
            Some(1) => false,
            Some(2) => true,
            Some(5) => return self.not_built(VARI, "chamfering (units of `_VARI`)"),
            _ => return self.no_such_machining("1 roughs, 2 finishes"),
        };
        // The finishing cut takes the allowance off.
        let allowance = if finishes_floor { 0.0 } else { self.magnitude(FAL) };
        let counter_clockwise = self.goes_counter_clockwise(Around::Outside)?;
        let blank = Blank { reach: blank, stock: blank - shape.least(), aside: mill.heights.clearance };
        let (rough, finish) = (true, None);
        let spigot =
            Spigot { mill, place, shape, counter_clockwise, allowance, blank, width, finishes_floor, rough, finish };
        if let Err(fault) = spigot.check() {
            return self.spigot_fault(fault);
        }
        self.own_way("the tool goes down the safety distance beside the blank, and comes to the wall on a semicircle");
        self.send_cycle(Cycle::Spigot(spigot));
        Ok(())
    }

    fn spigot_fault(&self, fault: SpigotFault) -> Outcome {
        let (key, alarm, help) = match fault {
            SpigotFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            SpigotFault::Corner => (CRAD, 61113, "give at most half of the smaller side"),
            SpigotFault::Width | SpigotFault::TooManyCircuits => (MIDA, 61111, "give a usual width of a cut"),
            SpigotFault::Edges => (NUM, 61019, "give a whole number from 3 on"),
            SpigotFault::Size => {
                let known = [LENG, WID, CDIAM, SWL];
                let key = known.into_iter().find(|key| self.args.place(*key) > 0).unwrap_or(SWL);
                (key, 61118, "give a size above 0")
            }
            SpigotFault::Number => (VARI, 61019, "check the arguments of the cycle"),
        };
        let message = format!("{fault}: `{}` (argument {})", self.args.written(key), self.args.place(key));
        self.cycle_fault(self.args.span_of(key), alarm, &message, help)
    }
}
