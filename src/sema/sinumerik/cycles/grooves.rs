//! Groove cycles: CYCLE93 and CYCLE930. Their shape is in `groove_shape`, their path in `lower::cycles::grooving`.
//!
//! Source: M 6, C 5.2 and 5.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::corner::Size;
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::grooving::{Copies, GrooveFeeds, Grooving, MOST_GROOVES, Plunges};
use crate::ir::cycle::recess::{Operation, RecessTool};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Family};

use super::super::value::whole;
use super::call::{Act, Acts, CycleCall};
use super::groove_shape::{GrooveShape, GrooveSide, Left};
use super::names::{
    AMODE, ANG1, ANG2, DBH, DIAG, DIAG2, DN, DTB, FAL, FAL1, FAL2, FALX, FALZ, FF1, IDEP, IDEP1, NR, NUM, RCI1, RCI2,
    RCO1, RCO2, S_FB, SDIS, SPD, SPL, STA, STA1, VARI, VRT, WIDG, WIDG2,
};
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

/// Clearance and retract of the classic cycle, mm.
const CLEARANCE: f64 = 1.0;
/// Greatest distance of two plunges as a part of the cutting width.
const SPACING: f64 = 0.8;
/// What the stored width of the top may differ from that of the shape, mm.
const WIDTH_ROUNDED: f64 = 0.01;

/// Corners in the order of the contour.
const CORNERS: [Name; 4] = [RCO1, RCI1, RCI2, RCO2];

/// How a call has the groove cut.
struct Cut {
    left: Left,
    plunges: Plunges,
    dwell: f64,
    operation: Operation,
    clearance: f64,
    feed: Feed,
    copies: Copies,
}

impl CycleCall<'_> {
    /// CYCLE93
    pub(super) fn groove_93(&self) -> Made<Acts> {
        let given = self.given;
        let side = self.groove_side(given.digit(VARI, 0))?;
        if given.digit(VARI, 1) > 1 || given.or_zero(VARI) >= 100.0 {
            return self.no_such_side();
        }
        self.no_inclined_surface(side.into)?;
        let floor_width = given.length(WIDG);
        let depth = given.length(DIAG);
        let by_sides = given.digit(VARI, 1) == 1;
        let corner = |key: Name| match self.given.length(key) {
            0.0 => None,
            size if size > 0.0 => Some(Size::Radius(size)),
            size if by_sides => Some(Size::Side(-size)),
            size => Some(Size::Length(-size)),
        };
        let shape = GrooveShape {
            side,
            reference: self.turned_reference(),
            at_floor: false,
            floor_width,
            depth,
            flanks: [ANG1, ANG2].map(|key| Deg(given.or_zero(key))),
            outer: [RCO1, RCO2].map(corner),
            inner: [RCI1, RCI2].map(corner),
        };
        let mm = |key: Name| self.given.length(key);
        let retract = Some(mm(VRT)).filter(|way| *way > 0.0).unwrap_or(CLEARANCE);
        let cut = Cut {
            left: Left::Square { floor: mm(FAL1), flanks: mm(FAL2) },
            plunges: match mm(IDEP) {
                0.0 => Plunges::Whole,
                most => Plunges::Steps { most, retract },
            },
            dwell: given.or_zero(DTB),
            operation: Operation::RoughAndFinish,
            clearance: CLEARANCE,
            feed: self.cycle_feed()?,
            copies: Copies::ONE,
        };
        self.own_way(codes::P8101::groove_93_as_partc_reads_it());
        self.send_groove(&shape, cut, [FAL1, FAL2])
    }

    /// CYCLE930
    pub(super) fn groove_930(&self) -> Made<Acts> {
        self.coded_930()?;
        let given = self.given;
        let side = self.groove_side(given.digit(VARI, 2))?;
        self.digits_of_are_known(VARI)?;
        let reference = self.turned_reference();
        let at_floor = given.digit(VARI, 3) == 1;
        let depth = self.depth_930(side.into, reference, at_floor)?;
        let plain = given.or_zero(NR) == 0.0;
        let size = |key: Name, place: u32| match self.given.length(key) {
            0.0 => None,
            _ if plain => None,
            size if given.digit(AMODE, place) == 1 => Some(Size::Side(size)),
            size => Some(Size::Radius(size)),
        };
        let shape = GrooveShape {
            side,
            reference,
            at_floor,
            floor_width: given.length(WIDG),
            depth,
            flanks: [ANG1, ANG2].map(|key| Deg(if plain { 0.0 } else { given.or_zero(key) })),
            outer: [size(RCO1, 3), size(RCO2, 6)],
            inner: [size(RCI1, 4), size(RCI2, 5)],
        };
        self.top_width_agrees(&shape)?;
        let clearance = given.length(SDIS);
        let operation = match given.digit(VARI, 1) {
            1 => Operation::Rough,
            2 => Operation::Finish,
            _ => Operation::RoughAndFinish,
        };
        let cut = Cut {
            left: self.left_930(side.into)?,
            plunges: match self.given.length(IDEP1) {
                0.0 => Plunges::Whole,
                most => Plunges::Alternating { most, retract: most + clearance },
            },
            dwell: if operation == Operation::Finish { 0.0 } else { self.dwell_930(&shape) },
            operation,
            clearance,
            feed: self.mill_feed(FF1)?,
            copies: self.copies()?,
        };
        self.own_way(codes::P8101::groove_930_as_partc_reads_it());
        self.send_groove(&shape, cut, [FAL; 2])
    }

    fn groove_side(&self, number: i32) -> Made<GrooveSide> {
        match GrooveSide::numbered(number) {
            Some(side) => Ok(side),
            None => self.no_such_side(),
        }
    }

    fn no_such_side<T>(&self) -> Made<T> {
        let given = self.given;
        let name = given.written(VARI);
        self.refuse_argument(VARI, codes::P2090::names_no_side_of_groove(&name, &given.argument(VARI)))
    }

    /// The flanks of a groove in a slope may stand on the slope or on the axis.
    fn no_inclined_surface(&self, into: Towards) -> Made {
        let given = self.given;
        let fits = match given.or_zero(STA1) {
            0.0 | 180.0 => true,
            90.0 => !into.is_radial(),
            _ => false,
        };
        if fits {
            return Ok(());
        }
        self.refuse_argument(STA1, codes::S9015::groove_in_inclined_surface())
    }

    pub(super) fn turned_reference(&self) -> Point2 {
        Point2::new(self.given.length(SPL), self.given.length(SPD) / 2.0)
    }

    /// Arguments of CYCLE930 that change the cut and are not known.
    fn coded_930(&self) -> Made {
        let given = self.given;
        if !(1..=3).contains(&given.digit(VARI, 1)) {
            return self.refuse_argument(VARI, codes::P2090::tens_of_vari_are_no_kind(&given.argument(VARI)));
        }
        if given.digit(VARI, 4) != 1 {
            return self.refuse_argument(VARI, codes::S9015::kind_of_machining_without_1_at_ten());
        }
        if given.or_zero(NR) == 2.0 {
            return self.refuse_argument(NR, codes::S9015::inclined_groove_nr_2_is_not());
        }
        if given.or_zero(STA) != 0.0 {
            return self.refuse_argument(STA, codes::S9015::inclined_groove());
        }
        if given.or_zero(S_FB) != 0.0 {
            return self.refuse_argument(S_FB, codes::S9015::feed_of_its_own_at_floor());
        }
        if given.or_zero(DIAG2) != 0.0 {
            self.unused(DIAG2, "where the groove is not inclined");
        }
        if given.or_zero(NR) == 0.0 {
            for key in [ANG1, ANG2, RCO1, RCI1, RCI2, RCO2].into_iter().filter(|key| given.or_zero(*key) != 0.0) {
                self.unused(key, "in a rectangular groove (`_NR` 0)");
            }
        }
        Ok(())
    }

    /// T1, absolute or incremental.
    fn depth_930(&self, into: Towards, reference: Point2, at_floor: bool) -> Made<f64> {
        let given = self.given;
        let written = given.length(DIAG);
        let depth = if given.digit(AMODE, 1) == 1 {
            written.abs()
        } else {
            let written = if into.is_radial() { written / 2.0 } else { written };
            let sense = into.depth_coordinate(Point2::origin() + into.unit());
            let down = (written - into.depth_coordinate(reference)) * sense;
            if at_floor { -down } else { down }
        };
        if depth > 0.0 {
            return Ok(depth);
        }
        self.refuse_argument(DIAG, codes::P2090::depth_diag_does_not_lie_in_material(&given.argument(DIAG)))
    }

    /// The editor stores both widths.
    fn top_width_agrees(&self, shape: &GrooveShape) -> Made {
        let given = self.given;
        let stored = given.length(WIDG2);
        let width = shape.top_width();
        if stored == 0.0 || (stored - width).abs() <= WIDTH_ROUNDED {
            return Ok(());
        }
        self.refuse_argument(WIDG2, codes::P2090::width_of_top_widg2(&given.argument(WIDG2), &stored, &width))
    }

    fn left_930(&self, into: Towards) -> Made<Left> {
        let [all, x, z] = [FAL, FALX, FALZ].map(|key| self.given.length(key));
        if all != 0.0 && (x != 0.0 || z != 0.0) {
            return self.refuse_argument(FAL, codes::P2090::allowance_on_all_sides_stands_beside_one());
        }
        let (surface, depth) = if into.is_radial() { (z, x) } else { (x, z) };
        Ok(if x == 0.0 && z == 0.0 { Left::Square { floor: all, flanks: all } } else { Left::Along { surface, depth } })
    }

    /// Seconds that the configured turns of the spindle take at the floor.
    fn dwell_930(&self, shape: &GrooveShape) -> f64 {
        let given = self.given;
        let cycles = &self.settings.cycles;
        let turns = cycles.groove_dwell_revolutions;
        if !cycles.groove_dwell || turns == 0.0 {
            return 0.0;
        }
        // On a face the widest floor turns slowest.
        let radius = if shape.side.into.is_radial() { shape.floor() } else { self.widest(shape) };
        let spindles = &self.st.spindles;
        let speed = match spindles.fixed_turns(None) {
            Some(fixed) => Some(fixed),
            None if spindles.is_cutting() && !spindles.keeps_speed() && radius > 1e-3 => {
                spindles.speed().map(|speed| {
                    let free = 1000.0 * speed / (2.0 * std::f64::consts::PI * radius);
                    spindles.limit().map_or(free, |limit| free.min(limit))
                })
            }
            None => None,
        };
        match speed.filter(|speed| *speed > 0.0) {
            Some(speed) => turns * 60.0 / speed,
            None => {
                let key = Answer::key("cycles", "groove_dwell").one_of(&["false"]);
                self.note(given.place, codes::S8222::cycle930_waits_at_floor_for_turns().answer(key), Kind::Once);
                0.0
            }
        }
    }

    fn widest(&self, shape: &GrooveShape) -> f64 {
        let width = shape.top_width();
        let from = shape.reference.y;
        if shape.side.towards_plus { from + width } else { from }
    }

    fn copies(&self) -> Made<Copies> {
        let given = self.given;
        let count = given.number(NUM).filter(|count| *count != 0.0).unwrap_or(1.0);
        let distance = self.given.length(DBH);
        let Some(count) = whole(count)
            .filter(|n| f64::from(*n) == count)
            .and_then(|n| u32::try_from(n).ok())
            .filter(|n| (1..=MOST_GROOVES).contains(n))
        else {
            return self.refuse_argument(NUM, codes::P2090::num_is_no_number_of_grooves(&given.argument(NUM)));
        };
        if count > 1 && distance == 0.0 {
            return self.refuse_argument(DBH, codes::P2090::grooves_without_distance_dbh(&count, &given.argument(DBH)));
        }
        if count == 1 && distance != 0.0 {
            self.unused(DBH, "with one groove");
        }
        Ok(Copies { count, distance })
    }

    /// The tool for work towards `into`: cutting width, nose, and the corner that is programmed.
    pub(super) fn groove_tool(&self, into: Towards) -> Made<RecessTool> {
        let given = self.given;
        let (number, edge) = self.active_edge()?;
        let listed = self.settings.tools.called(number).filter(|_| edge == 1);
        let called = &given.called;
        let Some(width) = listed.and_then(|tool| tool.width) else {
            let fault = codes::P2004::cutting_width_of_tool_d_is_not_known(called, &number, &edge);
            return self.refuse_as_said(given.place, fault.answer(Answer::tool(number, "width")));
        };
        let Some(nose) = self.known_radius() else {
            let fault = codes::P2004::nose_radius_for_groove_is_not_known(called, &number, &edge);
            return self.refuse_as_said(given.place, fault.answer(Answer::tool(number, "radius")));
        };
        let Some(position) = self.st.edge_position(self.settings, number, edge).and_then(whole) else {
            let fault = codes::P2004::position_for_groove_is_not_known(called, &number, &edge);
            return self.refuse_as_said(given.place, fault.answer(Answer::tool(number, "orientation")));
        };
        // The edge that lies towards minus on the cutting axis, seen from the programmed corner.
        let corners: [(i32, f64); 2] = match into {
            Towards::MinusX => [(3, 0.0), (4, -width)],
            Towards::PlusX => [(2, 0.0), (1, -width)],
            Towards::MinusZ => [(3, 0.0), (2, -width)],
            Towards::PlusZ => [(4, 0.0), (1, -width)],
        };
        let Some((_, edge)) = corners.into_iter().find(|(known, _)| *known == position) else {
            let [(first, _), (second, _)] = corners;
            return self.refuse(codes::P2090::edge_of_tool_lies_at_position(&number, &position, &first, &second));
        };
        Ok(RecessTool { width, nose, edge })
    }

    fn send_groove(&self, shape: &GrooveShape, cut: Cut, left: [Name; 2]) -> Made<Acts> {
        let given = self.given;
        let into = shape.side.into;
        let tool = self.groove_tool(into)?;
        if cut.left.floor() >= shape.depth {
            return self
                .refuse_argument(left[0], codes::P2090::allowance_on_floor_is_not_less(&given.written(left[0])));
        }
        let contour = match shape.contour() {
            Ok(contour) => contour,
            Err(fault) => {
                let key = CORNERS.get(fault.0).copied().unwrap_or(RCO1);
                let (name, place) = (given.written(key), given.argument(key));
                return self.refuse_argument(key, codes::P2090::corner_does_not_fit_on_flank(&name, &place));
            }
        };
        if shape.floor_width < tool.width - 1e-6 {
            let (name, place) = (given.written(WIDG), given.argument(WIDG));
            return self.refuse_argument(
                WIDG,
                codes::P2090::tool_of_mm_is_wider_than_floor(&tool.width, &name, &place, &shape.floor_width),
            );
        }
        let left = self.less_on_flanks(shape, cut.left, tool.width, left[1]);
        self.second_edge("finishes the second half with this edge");
        let grooving = Grooving {
            rims: shape.rims(&contour),
            contour,
            into,
            tool,
            surface: shape.surface(),
            allowance: shape.allowance(left),
            spacing: SPACING * tool.width,
            plunges: cut.plunges,
            dwell: cut.dwell,
            operation: cut.operation,
            clearance: cut.clearance,
            feeds: GrooveFeeds { plunge: cut.feed, finish: cut.feed },
            copies: cut.copies,
        };
        if self.beyond_centre(shape, &grooving) {
            return self.refuse(codes::P2090::groove_would_go_beyond_turning_centre());
        }
        if let Err(fault) = grooving.check() {
            return self.unsound_call(61019, &fault, "check the arguments of the cycle");
        }
        Ok(vec![Act::Cycle(Cycle::Grooving(grooving))])
    }

    /// A tool as wide as the groove leaves nothing on the flanks.
    fn less_on_flanks(&self, shape: &GrooveShape, left: Left, width: f64, key: Name) -> Left {
        let given = self.given;
        let Some(less) = shape.left_for(left, width) else { return left };
        let flanks = match less {
            Left::Square { flanks, .. } => flanks,
            Left::Along { surface, .. } => surface,
        };
        let fault = codes::S8221::tool_of_mm_leaves_no_room(&given.called, &width, &shown(flanks));
        self.note(given.place_of(key), fault, Kind::Once);
        less
    }

    fn beyond_centre(&self, shape: &GrooveShape, grooving: &Grooving) -> bool {
        let copies = f64::from(grooving.copies.count - 1) * grooving.copies.distance;
        let points = grooving.contour.iter().flat_map(|element| [element.from(), element.to()]);
        let lowest = points.map(|point| point.y).fold(f64::INFINITY, f64::min);
        if grooving.into.is_radial() {
            lowest < 0.0 || grooving.clear() <= 0.0 || shape.floor() < 0.0
        } else {
            lowest + copies.min(0.0) < 0.0
        }
    }

    /// The control changes to the other corner of the tool; here it follows from the width.
    pub(super) fn second_edge(&self, what: &str) {
        let given = self.given;
        let edge = given.or_zero(DN);
        if edge == 0.0 || f64::from(self.st.tool.edge_or_first()) == edge {
            return;
        }
        let fault =
            codes::S8223::control_partc_computes_it_from_cutting_width(&given.called, &what, &given.argument(DN));
        self.note(given.place_of(DN), fault, Kind::Once);
    }
}

/// A length with the decimals that matter.
fn shown(mm: f64) -> f64 {
    (mm * 1e4).round() / 1e4
}
