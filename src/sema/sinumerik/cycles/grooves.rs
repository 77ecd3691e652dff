//! Groove cycles: CYCLE93 and CYCLE930. Their shape is in `groove_shape`, their path in `lower::cycles::grooving`.
//!
//! Source: M 6, C 5.2 and 5.6 (docs/sources.md).

use crate::diag::{Answer, Help, codes};
use crate::geo::corner::Size;
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::grooving::{Copies, GrooveFeeds, Grooving, MOST_GROOVES, Plunges};
use crate::ir::cycle::recess::{Operation, RecessTool};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Family};
use crate::machine::MachineKind;

use super::super::Outcome;
use super::super::value::whole;
use super::arguments::{
    AMODE, ANG1, ANG2, DBH, DIAG, DIAG2, DMODE, DN, DTB, FAL, FAL1, FAL2, FALX, FALZ, FF1, IDEP, IDEP1, Key, NR, NUM,
    RCI1, RCI2, RCO1, RCO2, S_FB, SDIS, SPD, SPL, STA, STA1, VARI, VRT, WIDG, WIDG2,
};
use super::call::CycleCall;
use super::groove_shape::{GrooveShape, GrooveSide, Left};

/// Clearance and retract of the classic cycle, mm.
const CLEARANCE: f64 = 1.0;
/// Greatest distance of two plunges as a part of the cutting width.
const SPACING: f64 = 0.8;
/// What the stored width of the top may differ from that of the shape, mm.
const WIDTH_ROUNDED: f64 = 0.01;

/// Corners in the order of the contour.
const CORNERS: [Key; 4] = [RCO1, RCI1, RCI2, RCO2];

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

impl CycleCall<'_, '_> {
    /// CYCLE93
    pub(super) fn groove_93(&mut self) -> Outcome {
        self.groove_conditions()?;
        let args = self.args;
        let side = self.groove_side(args.digit(VARI, 0))?;
        if args.digit(VARI, 1) > 1 || args.or_zero(VARI) >= 100.0 {
            return self.no_such_side();
        }
        self.no_inclined_surface(side.into)?;
        let floor_width = self.above_zero(WIDG)?;
        let depth = self.above_zero(DIAG)?;
        let by_sides = args.digit(VARI, 1) == 1;
        let corner = |key: Key| match self.length_of(args, key).unwrap_or(0.0) {
            0.0 => None,
            size if size > 0.0 => Some(Size::Radius(size)),
            size if by_sides => Some(Size::Side(-size)),
            size => Some(Size::Length(-size)),
        };
        let shape = GrooveShape {
            side,
            reference: self.turned_reference()?,
            at_floor: false,
            floor_width,
            depth,
            flanks: [ANG1, ANG2].map(|key| Deg(args.or_zero(key))),
            outer: [RCO1, RCO2].map(corner),
            inner: [RCI1, RCI2].map(corner),
        };
        let mm = |key: Key| self.length_of(args, key).unwrap_or(0.0);
        let retract = Some(mm(VRT)).filter(|way| *way > 0.0).unwrap_or(CLEARANCE);
        let cut = Cut {
            left: Left::Square { floor: mm(FAL1), flanks: mm(FAL2) },
            plunges: match mm(IDEP) {
                0.0 => Plunges::Whole,
                most => Plunges::Steps { most, retract },
            },
            dwell: args.or_zero(DTB),
            operation: Operation::RoughAndFinish,
            clearance: CLEARANCE,
            feed: self.cycle_feed()?,
            copies: Copies::ONE,
        };
        self.send_groove(&shape, cut, [FAL1, FAL2])?;
        self.own_groove(
            "WIDG counts at the floor, DIAG square to the axis, plunges are at most 0.8 of the tool apart and start from the middle",
        );
        Ok(())
    }

    /// CYCLE930
    pub(super) fn groove_930(&mut self) -> Outcome {
        self.groove_conditions()?;
        self.coded_930()?;
        let args = self.args;
        let side = self.groove_side(args.digit(VARI, 2))?;
        self.digits_of_are_known(VARI)?;
        let reference = self.turned_reference()?;
        let at_floor = args.digit(VARI, 3) == 1;
        let depth = self.depth_930(side.into, reference, at_floor)?;
        let plain = args.or_zero(NR) == 0.0;
        let size = |key: Key, place: u32| match self.length_of(args, key).unwrap_or(0.0) {
            0.0 => None,
            _ if plain => None,
            size if args.digit(AMODE, place) == 1 => Some(Size::Side(size)),
            size => Some(Size::Radius(size)),
        };
        let shape = GrooveShape {
            side,
            reference,
            at_floor,
            floor_width: self.above_zero(WIDG)?,
            depth,
            flanks: [ANG1, ANG2].map(|key| Deg(if plain { 0.0 } else { args.or_zero(key) })),
            outer: [size(RCO1, 3), size(RCO2, 6)],
            inner: [size(RCI1, 4), size(RCI2, 5)],
        };
        self.top_width_agrees(&shape)?;
        let clearance = self.above_zero(SDIS)?;
        let operation = match args.digit(VARI, 1) {
            1 => Operation::Rough,
            2 => Operation::Finish,
            _ => Operation::RoughAndFinish,
        };
        let cut = Cut {
            left: self.left_930(side.into)?,
            plunges: match self.length_of(args, IDEP1).unwrap_or(0.0) {
                0.0 => Plunges::Whole,
                most => Plunges::Alternating { most, retract: most + clearance },
            },
            dwell: if operation == Operation::Finish { 0.0 } else { self.dwell_930(&shape) },
            operation,
            clearance,
            feed: self.mill_feed(FF1)?,
            copies: self.copies()?,
        };
        self.send_groove(&shape, cut, [FAL; 2])?;
        self.own_groove(
            "the digits of `_VARI` and `_AMODE` are read as in stored calls, plunges are at most 0.8 of the tool apart and start from the middle",
        );
        Ok(())
    }

    /// What both cycles need around them.
    pub(super) fn groove_conditions(&mut self) -> Outcome {
        let args = self.args;
        self.check_parameters()?;
        self.digits_are_known()?;
        let machine = &self.job.settings.machine;
        if machine.kind != MachineKind::Lathe {
            return self.refuse_cycle(
                args.span,
                codes::P2090::grooves_need_turning_technology()
                    .answer(Answer::key("machine", "kind").one_of(&["\"lathe\""])),
            );
        }
        self.in_turning_plane()?;
        self.no_normal_offset()?;
        if self.names_other_plane(args) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        self.frame_is_not_scaled()?;
        if !self.st.ctx.frame.is_shift() {
            return self
                .refuse(args.span, codes::S9015::under_mirrored_or_turned_frame_programmed_corner(&args.name()));
        }
        Ok(())
    }

    fn groove_side(&self, number: i32) -> Outcome<GrooveSide> {
        match GrooveSide::numbered(number) {
            Some(side) => Ok(side),
            None => self.no_such_side(),
        }
    }

    fn no_such_side<T>(&self) -> Outcome<T> {
        let args = self.args;
        let name = args.written(VARI);
        self.refuse_cycle(args.span_of(VARI), codes::P2090::names_no_side_of_groove(&name, &args.place(VARI)))
    }

    /// The flanks of a groove in a slope may stand on the slope or on the axis.
    fn no_inclined_surface(&self, into: Towards) -> Outcome {
        let args = self.args;
        let fits = match args.or_zero(STA1) {
            0.0 | 180.0 => true,
            90.0 => !into.is_radial(),
            _ => false,
        };
        if fits {
            return Ok(());
        }
        self.refuse_argument(STA1, codes::S9015::groove_in_inclined_surface())
    }

    /// A length that is above 0.
    pub(super) fn above_zero(&self, key: Key) -> Outcome<f64> {
        let args = self.args;
        let name = args.written(key);
        let value = self.needed_length(key, &format!("`{name}`"))?;
        if value > 0.0 {
            return Ok(value);
        }
        self.refuse_cycle(args.span_of(key), codes::P2090::is_not_above_0(&name, &args.place(key)))
    }

    pub(super) fn turned_reference(&self) -> Outcome<Point2> {
        let x = self.needed_length(SPD, "the diameter of the reference point")? / 2.0;
        Ok(Point2::new(self.needed_length(SPL, "the reference point along Z")?, x))
    }

    /// Arguments of CYCLE930 that change the cut and are not known.
    fn coded_930(&self) -> Outcome {
        let args = self.args;
        if !(1..=3).contains(&args.digit(VARI, 1)) {
            return self.refuse_cycle(args.span_of(VARI), codes::P2090::tens_of_vari_are_no_kind(&args.place(VARI)));
        }
        if args.digit(VARI, 4) != 1 {
            return self.refuse_argument(VARI, codes::S9015::kind_of_machining_without_1_at_ten());
        }
        if args.or_zero(NR) == 2.0 {
            return self.refuse_argument(NR, codes::S9015::inclined_groove_nr_2_is_not());
        }
        if args.or_zero(STA) != 0.0 {
            return self.refuse_argument(STA, codes::S9015::inclined_groove());
        }
        if args.or_zero(S_FB) != 0.0 {
            return self.refuse_argument(S_FB, codes::S9015::feed_of_its_own_at_floor());
        }
        if args.or_zero(DIAG2) != 0.0 {
            self.unused(DIAG2, "_DIAG2", "where the groove is not inclined");
        }
        if args.or_zero(NR) == 0.0 {
            for key in [ANG1, ANG2, RCO1, RCI1, RCI2, RCO2].into_iter().filter(|key| args.or_zero(*key) != 0.0) {
                self.unused(key, &args.written(key), "in a rectangular groove (`_NR` 0)");
            }
        }
        Ok(())
    }

    /// T1, absolute or incremental.
    fn depth_930(&self, into: Towards, reference: Point2, at_floor: bool) -> Outcome<f64> {
        let args = self.args;
        let given = self.needed_length(DIAG, "the depth")?;
        let depth = if args.digit(AMODE, 1) == 1 {
            given.abs()
        } else {
            let given = if into.is_radial() { given / 2.0 } else { given };
            let sense = into.depth_coordinate(Point2::origin() + into.unit());
            let down = (given - into.depth_coordinate(reference)) * sense;
            if at_floor { -down } else { down }
        };
        if depth > 0.0 {
            return Ok(depth);
        }
        self.refuse_cycle(args.span_of(DIAG), codes::P2090::depth_diag_does_not_lie_in_material(&args.place(DIAG)))
    }

    /// The editor stores both widths.
    fn top_width_agrees(&self, shape: &GrooveShape) -> Outcome {
        let args = self.args;
        let given = self.length_of(args, WIDG2).unwrap_or(0.0);
        let width = shape.top_width();
        if given == 0.0 || (given - width).abs() <= WIDTH_ROUNDED {
            return Ok(());
        }
        self.refuse_cycle(args.span_of(WIDG2), codes::P2090::width_of_top_widg2(&args.place(WIDG2), &given, &width))
    }

    fn left_930(&self, into: Towards) -> Outcome<Left> {
        let args = self.args;
        let [all, x, z] = [FAL, FALX, FALZ].map(|key| self.length_of(args, key).unwrap_or(0.0));
        if all != 0.0 && (x != 0.0 || z != 0.0) {
            return self.refuse_cycle(args.span_of(FAL), codes::P2090::allowance_on_all_sides_stands_beside_one());
        }
        let (surface, depth) = if into.is_radial() { (z, x) } else { (x, z) };
        Ok(if x == 0.0 && z == 0.0 { Left::Square { floor: all, flanks: all } } else { Left::Along { surface, depth } })
    }

    /// Seconds that the configured turns of the spindle take at the floor.
    fn dwell_930(&self, shape: &GrooveShape) -> f64 {
        let args = self.args;
        let cycles = &self.job.settings.cycles;
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
                if self.job.diags.first_time(codes::S8222, ()) {
                    let found = codes::S8222::cycle930_waits_at_floor_for_turns().at(self.loc(args.span));
                    self.report(
                        found.help(
                            Answer::key("cycles", "groove_dwell")
                                .one_of(&["false"])
                                .help("program S before the cycle, or set `[cycles] groove_dwell = false`"),
                        ),
                    );
                }
                0.0
            }
        }
    }

    fn widest(&self, shape: &GrooveShape) -> f64 {
        let width = shape.top_width();
        let from = shape.reference.y;
        if shape.side.towards_plus { from + width } else { from }
    }

    fn copies(&self) -> Outcome<Copies> {
        let args = self.args;
        let count = args.number(NUM).filter(|count| *count != 0.0).unwrap_or(1.0);
        let distance = self.length_of(args, DBH).unwrap_or(0.0);
        let Some(count) = whole(count)
            .filter(|n| f64::from(*n) == count)
            .and_then(|n| u32::try_from(n).ok())
            .filter(|n| (1..=MOST_GROOVES).contains(n))
        else {
            return self.refuse_cycle(args.span_of(NUM), codes::P2090::num_is_no_number_of_grooves(&args.place(NUM)));
        };
        if count > 1 && distance == 0.0 {
            return self
                .refuse_cycle(args.span_of(DBH), codes::P2090::grooves_without_distance_dbh(&count, &args.place(DBH)));
        }
        if count == 1 && distance != 0.0 {
            self.unused(DBH, "_DBH", "with one groove");
        }
        Ok(Copies { count, distance })
    }

    /// The tool for work towards `into`: cutting width, nose, and the corner that is programmed.
    pub(super) fn groove_tool(&self, into: Towards) -> Outcome<RecessTool> {
        let args = self.args;
        let (number, edge) = self.active_edge()?;
        let listed = self.job.settings.tools.called(number).filter(|_| edge == 1);
        let missing = |what: &str, help: Help| {
            self.refuse(
                args.span,
                codes::P2004::of_tool_d_is_not_known(&args.name(), &what, &number, &edge).help(&help),
            )
        };
        let Some(width) = listed.and_then(|tool| tool.width) else {
            return missing(
                "the cutting width",
                Answer::tool(number, "width").help(format!("add it to partc.toml: `[tools.{number}] width = 3.0`")),
            );
        };
        let Some(nose) = self.known_radius() else {
            let help = Answer::tool(number, "radius").help(format!(
                "add it to partc.toml: `[tools.{number}] radius = 0.2`, or write `$TC_DP6[{number},{edge}]=0.2` before"
            ));
            return missing("the nose radius", help);
        };
        let Some(position) = self.edge_position(number, edge).and_then(whole) else {
            let help = Answer::tool(number, "orientation").help(format!(
                "add it to partc.toml: `[tools.{number}] orientation = 3`, or write `$TC_DP2[{number},{edge}]=3` before"
            ));
            return missing("the position of the cutting edge", help);
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
            return self.refuse_cycle(
                args.span,
                codes::P2090::edge_of_tool_lies_at_position(&number, &position, &first, &second),
            );
        };
        Ok(RecessTool { width, nose, edge })
    }

    fn send_groove(&mut self, shape: &GrooveShape, cut: Cut, left: [Key; 2]) -> Outcome {
        let args = self.args;
        let into = shape.side.into;
        let tool = self.groove_tool(into)?;
        self.turning_position(args.span)?;
        if cut.left.floor() >= shape.depth {
            return self.refuse_cycle(
                args.span_of(left[0]),
                codes::P2090::allowance_on_floor_is_not_less(&args.written(left[0])),
            );
        }
        let contour = match shape.contour() {
            Ok(contour) => contour,
            Err(fault) => {
                let key = CORNERS.get(fault.0).copied().unwrap_or(RCO1);
                let (name, place) = (args.written(key), args.place(key));
                return self.refuse_cycle(args.span_of(key), codes::P2090::corner_does_not_fit_on_flank(&name, &place));
            }
        };
        if shape.floor_width < tool.width - 1e-6 {
            let (name, place) = (args.written(WIDG), args.place(WIDG));
            return self.refuse_cycle(
                args.span_of(WIDG),
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
            return self.refuse_cycle(args.span, codes::P2090::groove_would_go_beyond_turning_centre());
        }
        if let Err(fault) = grooving.check() {
            return self.cycle_fault(args.span, 61019, &fault.to_string(), "check the arguments of the cycle");
        }
        self.send_cycle(Cycle::Grooving(grooving));
        Ok(())
    }

    /// A tool as wide as the groove leaves nothing on the flanks.
    fn less_on_flanks(&self, shape: &GrooveShape, left: Left, width: f64, key: Key) -> Left {
        let args = self.args;
        let Some(less) = shape.left_for(left, width) else { return left };
        let found = codes::S8221::tool_of_mm_leaves_no_room(
            &args.name(),
            &width,
            &shown(match less {
                Left::Square { flanks, .. } => flanks,
                Left::Along { surface, .. } => surface,
            }),
        )
        .at(self.loc(args.span_of(key)));
        self.report_once(found.help("take a narrower tool, or no allowance on the flanks"));
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
        let args = self.args;
        let edge = args.or_zero(DN);
        if edge == 0.0 || f64::from(self.st.tool.edge_or_first()) == edge {
            return;
        }
        let found = codes::S8223::control_partc_computes_it_from_cutting_width(&args.name(), &what, &args.place(DN))
            .at(self.loc(args.span_of(DN)));
        self.report_once(found.help("check that the cutting width in the tool table is that of the tool"));
    }

    /// A reading of the manuals or a path of our own, once for each cycle.
    pub(super) fn own_groove(&self, what: &str) {
        let found = codes::P8101::path_is_own(&self.args.name(), &what).at(self.loc(self.args.span));
        self.report_once(found.help("docs/cycles.md describes the path; compare with what the machine does"));
    }
}

/// A length with the decimals that matter.
fn shown(mm: f64) -> f64 {
    (mm * 1e4).round() / 1e4
}
