//! Soft approach and retraction: G147 to G348.
//!
//! Comes in: a block with G147, G247 or G347, the point where the contour begins, and the element behind it, whose
//! direction decides where the tool comes from; or a block with G148, G248 or G348. Goes out: plain moves. A compensated
//! contour is lengthened by a line or an arc, so that the path of its centre has the length or radius of the block.
//!
//! ```text
//! P0 ── P1          plane of the start
//!       │  infeed   P2 = DISCL above the contour
//!       P3 ── P4    line, quadrant or semicircle in the plane of the contour, or falling onto it (G340)
//! ```
//!
//! Source: S 2.13 (docs/sources.md); docs/compensation.md.

use crate::diag::codes;
use crate::geo::arc::tangent_at;
use crate::geo::soft::{Shape, touch};
use crate::geo::tolerance;
use crate::geo::{Plane, Point2, SAME_DIRECTION, SAME_POINT, Vec2, cross, direction};
use crate::ir::compensation::Border;
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::{self, Feed, Function, Origin, Pos, Side};
use crate::machine::Axis;
use crate::sema::common::compensation::compensate;
use crate::sema::run::{Site, Where};
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::tangent::Heading;
use super::vocabulary::Address;
use super::words::{Given, Mode, Words, misplaced_modifier};
use super::{Channel, Core, Outcome, State};

/// Functions and comments between an approach and its contour.
const MOST_HELD: usize = 256;

/// A height along the tool axis.
#[derive(Debug, Clone, Copy)]
enum Height {
    At(f64),
    Above(f64),
}

impl Height {
    fn over(self, contour: f64) -> f64 {
        match self {
            Height::At(z) => z,
            Height::Above(way) => contour + way,
        }
    }
}

/// A move of an approach or retraction, and on which side it is printed.
type SoftMove = (Pos, Path, Side);

/// The words of a block.
#[derive(Debug, Clone, Copy)]
struct Sizes {
    shape: Shape,
    /// DISR in mm.
    size: f64,
    /// DISCL and DISRP.
    safe: Option<Height>,
    plane: Option<Height>,
    /// FAD
    infeed: Option<Feed>,
}

/// An approach whose contour is not known yet.
#[derive(Debug)]
pub(super) struct Soft {
    sizes: Sizes,
    name: String,
    here: Site,
    span: Span,
    from: Pos,
    /// The point of the contour stands in the block itself.
    named: bool,
    /// So does its height.
    height_named: bool,
    before: Path,
    feed: Option<Feed>,
    held: Vec<(Function, Origin)>,
}

impl Soft {
    /// Something that cannot stand between an approach and its contour.
    pub fn report_open(&self, core: &Core<'_>) {
        let found = codes::S2083::no_contour_element_follows(&self.name).at(self.here.loc(&core.job, self.span));
        core.job.diags.push(found.called(self.here.origin.call).help("let a path block of the plane follow"));
    }

    /// Holds back a function that waits for the contour.
    pub fn holds(&mut self, function: &Function, origin: Origin) -> bool {
        let acts = matches!(
            function,
            Function::ToolChange { .. } | Function::WorkOffset(_) | Function::Plane(_) | Function::End { .. }
        );
        let waits = !acts && self.held.len() < MOST_HELD;
        if waits {
            self.held.push((function.clone(), origin));
        }
        waits
    }
}

fn shape_of(code: GCode) -> Option<(Shape, bool)> {
    Some(match code {
        GCode::G147 => (Shape::Line, true),
        GCode::G247 => (Shape::Quadrant, true),
        GCode::G347 => (Shape::Semicircle, true),
        GCode::G148 => (Shape::Line, false),
        GCode::G248 => (Shape::Quadrant, false),
        GCode::G348 => (Shape::Semicircle, false),
        _ => return None,
    })
}

impl Channel<'_> {
    /// A block with one of the codes. `before` is the way of the block before; the technology of the block was taken.
    pub(super) fn soft_block(&mut self, code: GCode, span: Span, w: &mut Words, before: Path) -> Outcome {
        let Some((shape, approaches)) = shape_of(code) else {
            return self.core.refuse(span, codes::P9011::is_not_supported_so_program_way(&code.word()));
        };
        let ends = w.code_of(Group::Compensation).is_some_and(|(code, _)| code == GCode::G40);
        let side = if ends && self.st.compensation.waits() { self.st.compensation.left() } else { self.st.side() };
        let other = if !self.core.resolves() && side != Side::None {
            "beside radius compensation by the target"
        } else if self.capture.is_some() {
            "inside a contour"
        } else if self.st.modal_call.is_on() {
            "under MCALL"
        } else if self.st.offsets.in_machine() {
            "in machine coordinates"
        } else {
            ""
        };
        if !other.is_empty() {
            return self.core.refuse(span, codes::P9011::is_not_supported_so_program_approach(&code.word(), &other));
        }
        if self.soft.is_some() {
            return self.core.refuse(span, codes::S2083::approach_before_has_no_contour());
        }
        if approaches && side != Side::None && self.core.resolves() && !self.st.compensation.waits() {
            return self.core.refuse(span, codes::P9013::stands_in_contour_whose_compensation_has_begun(&code.word()));
        }
        self.pending_must_be_done(span)?;
        let sizes = soft_sizes(&self.core, &self.st, (shape, approaches), side, span, w)?;
        let scale = self.st.ctx.frame.uniform_scale();
        if side != Side::None && scale.is_none_or(|scale| (scale - 1.0).abs() > SAME_DIRECTION) {
            return self.core.refuse(span, codes::P9011::under_scaling_is_not_supported(&code.word()));
        }
        let end = self.st.targets(&self.core, w)?;
        self.st.compensation.is_over();
        if approaches {
            let soft = approach(&self.core, &self.st, (code, span), w, sizes, &end, before)?;
            self.soft = Some(Box::new(soft));
            self.st.position.move_to(&end);
            return Ok(());
        }
        let made = retract(&self.core, &self.st, (code, span), sizes, end, (side, ends), before)?;
        let Some((moves, last)) = made else {
            self.st.feed.lose();
            return self.core.refuse(span, codes::P2002::no_feed_is_programmed_so_program_f());
        };
        self.soft_moves(&moves);
        self.st.heading = Heading::Later;
        self.st.position.move_to(&last);
        Ok(())
    }

    /// A move behind an approach: the point of the contour, or its first element. True if it moves nothing itself.
    pub(super) fn soft_element(&mut self, end: &Pos, path: &Path) -> bool {
        let [first, second, third] = self.st.roles();
        let in_plane = end.get(first).is_some() || end.get(second).is_some();
        let Some(mut soft) = self.soft.take() else { return false };
        if !in_plane || path.is_rapid() && soft.named {
            self.soft = Some(soft);
            return self.soft_must_be_done().is_err();
        }
        if !soft.named {
            if matches!(path, Path::Arc(..)) || soft.height_named && end.get(third).is_some() {
                self.soft = Some(soft);
                self.core.say(Where::Block, codes::S2083::end_point_is_no_point_of_plane());
                self.soft = None;
                self.lose_all();
                return true;
            }
            soft.named = true;
            self.st.position.move_to(end);
            self.soft = Some(soft);
            return true;
        }
        let here = std::mem::replace(&mut self.core.here, soft.here);
        let made = approach_moves(&self.core, &self.st, &soft, end, path).map(|moves| self.soft_moves(&moves));
        self.core.here = here;
        if made.is_err() {
            self.lose_all();
            return true;
        }
        for (function, origin) in std::mem::take(&mut soft.held) {
            self.core.out.function(&function, &self.st.ctx, &origin);
        }
        false
    }

    /// Sends the moves of an approach or retraction.
    fn soft_moves(&mut self, moves: &[SoftMove]) {
        self.st.straight_border();
        for (end, path, side) in moves {
            if self.leaves_touched(end.known(), path.is_rapid()).is_ok() {
                self.left.cuts(self.capture.is_some());
                let mv = Move { end: *end, path: *path, side: *side, coords: Coords::Frame };
                self.core.send_move(&mv, &self.st.ctx);
            }
        }
    }
}

impl State {
    /// KONT has no say where the way is tangential.
    fn straight_border(&mut self) {
        if let Some(rules) = self.ctx.compensation.as_deref() {
            let rules = ir::Compensation { approach: Border::Perpendicular, retract: Border::Perpendicular, ..*rules };
            compensate(&mut self.ctx, rules);
        }
    }
}

fn soft_sizes(
    core: &Core<'_>,
    st: &State,
    (shape, approaches): (Shape, bool),
    side: Side,
    span: Span,
    w: &mut Words,
) -> Outcome<Sizes> {
    let mm = st.length_unit();
    let radius = if side == Side::None { 0.0 } else { st.path.radius() };
    let size = w.take(Address::Disr).map(|disr| disr.value * mm);
    let fits = size.is_some_and(|size| if shape == Shape::Line { size + radius > 0.0 } else { size > 0.0 });
    let Some(size) = size.filter(|_| fits) else {
        return core.refuse(span, codes::S2083::disr_is_missing_or_too_small());
    };
    let height = |given: Option<Given>| match given {
        None => Ok(None),
        Some(given) => match given.mode {
            Mode::Plain => Ok(Some(Height::Above(given.value * mm))),
            Mode::Ac => Ok(Some(Height::At(given.value * mm))),
            _ => Err(given.span),
        },
    };
    let (safe, plane) = match (height(w.take(Address::Discl)), height(w.take(Address::Disrp))) {
        (Ok(safe), Ok(plane)) => (safe, plane),
        (Err(span), _) | (_, Err(span)) => return core.refuse(span, misplaced_modifier()),
    };
    let infeed = match w.take(Address::Fad) {
        Some(fad) if fad.value <= 0.0 => {
            return core.refuse(fad.span, codes::P2003::feed_fad_is_not_above_0());
        }
        fad => {
            let falls = st.is(GCode::G340);
            // On the helix of a retraction F holds, and without DISCL nothing is left to go at the feed of the infeed.
            let why = if !approaches && falls {
                Some("G340 retracts at F")
            } else if !falls && matches!(safe, None | Some(Height::Above(0.0))) {
                Some("without DISCL, or with DISCL=0, there is no slow infeed")
            } else {
                None
            };
            if let (Some(fad), Some(why)) = (fad, why) {
                core.say_once(fad.span, codes::S8196::fad_has_no_effect_here(&why));
            }
            fad.map(|fad| infeed(core, st, fad))
        }
    };
    Ok(Sizes { shape, size, safe, plane, infeed })
}

/// `FAD=150`, counted as F is, or `FAD=PM(150)` as under G94 and `FAD=PR(0.2)` as under G95.
fn infeed(core: &Core<'_>, st: &State, fad: Given) -> Feed {
    let unit = st.feed_unit();
    let feed = match fad.mode {
        Mode::PerMinute => Feed::PerMinute(fad.value * unit),
        Mode::PerTurn => Feed::PerRevolution(fad.value * unit),
        _ => st.feed_of(fad.value),
    };
    if matches!(feed, Feed::PerRevolution(_)) {
        st.master_feeds(core, fad.span);
    }
    feed
}

/// An approach by the words of its block, which ends at `end`.
fn approach(
    core: &Core<'_>,
    st: &State,
    (code, span): (GCode, Span),
    w: &Words,
    sizes: Sizes,
    end: &Pos,
    before: Path,
) -> Outcome<Soft> {
    let [first, second, third] = st.roles();
    // Without F the way before goes on, and at rapid traverse nothing should meet the part.
    let feed = if w.feed_given || !before.is_rapid() { st.feed.word() } else { None };
    let whole = sizes.infeed.is_some() && st.is(GCode::G340);
    if feed.is_none() && !whole {
        return core.refuse(span, codes::P2002::has_no_feed(&code.word()));
    }
    let named = end.get(first).is_some() || end.get(second).is_some();
    Ok(Soft {
        sizes,
        name: code.word(),
        here: core.here,
        span,
        from: *st.position.at(),
        named,
        height_named: end.get(third).is_some(),
        before,
        feed,
        held: Vec::new(),
    })
}

/// The moves to the contour, whose first element is `path`.
fn approach_moves(core: &Core<'_>, st: &State, soft: &Soft, end: &Pos, path: &Path) -> Outcome<Vec<SoftMove>> {
    let plane = st.plane();
    let third = st.roles()[2];
    let at = st.stands_in(core, plane, soft.span)?;
    let Some(heading) = direction_at_start(st, end, path) else {
        return core.refuse(soft.span, codes::S2083::direction_behind_is_not_known());
    };
    let side = st.side();
    let way = Way { shape: soft.sizes.shape, at, heading, span: soft.span };
    let s = soft_side(core, st, way, side, soft.from.in_plane(plane))?;
    let radius = if side == Side::None { 0.0 } else { st.path.radius() };
    // Backwards along the contour its sides are swapped.
    let touch = touch(soft.sizes.shape, soft.sizes.size, at, -heading, -s, radius);
    let heights = approach_heights(core, st, soft, third)?;
    let printed = st.printed_side(side);
    let falls = st.is(GCode::G340);
    if heights.is_some()
        && soft.sizes.safe.is_none()
        && soft.before.is_rapid()
        && core.job.diags.first_time(codes::S8197, &soft.name)
    {
        let found = codes::S8197::has_no_discl(&soft.name).at(core.loc(soft.span));
        core.report(found.help("program DISCL, and FAD for the way from there"));
    }
    let place = |p: Option<Point2>, z: Option<f64>| {
        let mut end = Pos::UNKNOWN;
        if let Some(p) = p {
            end.set_in_plane(plane, p);
        }
        if let Some(z) = z {
            end.set(third, z);
        }
        end
    };
    let infeed = Path::straight(soft.sizes.infeed.or(soft.feed));
    let mut moves = vec![(place(Some(touch.contour), heights.and_then(|h| h.first)), soft.before, printed)];
    if let Some(heights) = heights {
        moves.push((place(None, Some(heights.safe)), soft.before, printed));
        if !falls && heights.safe != heights.contour {
            moves.push((place(None, Some(heights.contour)), infeed, printed));
        }
    }
    let way = if falls { soft.sizes.infeed.or(soft.feed) } else { soft.feed };
    let to = place(Some(at), heights.map(|h| h.contour));
    let path = way.map_or(Path::straight(None), |feed| path_of(plane, touch.circle, s > 0.0, feed));
    moves.push((to, path, printed));
    Ok(moves)
}

/// Direction of an element at its start, where the tool stands.
fn direction_at_start(st: &State, end: &Pos, path: &Path) -> Option<Vec2> {
    let plane = st.plane();
    let at = st.position.in_plane(plane)?;
    match path {
        Path::Arc(arc, _) => match Heading::behind(arc, &st.position, end) {
            Heading::Arc { plane: other, center, ccw } if other == plane => tangent_at(at, center, ccw),
            _ => None,
        },
        _ => {
            let (first, second, _) = plane.axes();
            let to = |axis: usize, old: f64| end.get(Axis::ALL[axis]).unwrap_or(old);
            direction(Point2::new(to(first, at.x), to(second, at.y)) - at, SAME_POINT)
        }
    }
}

/// The side from which the way comes, or to which it leads: 1 left, -1 right.
/// A line without compensation has no side.
fn soft_side(core: &Core<'_>, st: &State, way: Way, side: Side, far: Option<Point2>) -> Outcome<f64> {
    let Way { shape, at, heading, span } = way;
    let own = match st.printed_side(side) {
        Side::None => None,
        Side::Left => Some(1.0),
        Side::Right => Some(-1.0),
    };
    let chosen = match st.codes.of(Group::SoftApproach).index {
        2 => Some(1.0),
        3 => Some(-1.0),
        4 => far.map(|far| if cross(heading, far - at) >= 0.0 { 1.0 } else { -1.0 }),
        _ => own,
    };
    match chosen {
        Some(chosen) if own.is_none_or(|own| own == chosen) => Ok(chosen),
        Some(_) => core.refuse(span, codes::P9011::way_leads_to_other_side_of_contour()),
        None if shape == Shape::Line => Ok(1.0),
        None => core.refuse(span, codes::S2083::side_of_way_is_not_known()),
    }
}

/// Heights of an approach; `None` where the way stays in its plane.
fn approach_heights(core: &Core<'_>, st: &State, soft: &Soft, third: Axis) -> Outcome<Option<Heights>> {
    let (start, contour) = (soft.from.get(third), st.position.get(third));
    let moves = contour != start || soft.sizes.safe.is_some() || soft.sizes.plane.is_some();
    if !moves {
        return Ok(None);
    }
    let (Some(start), Some(contour)) = (start, contour) else {
        return st.unknown_axis(core, third, soft.span);
    };
    let safe = soft.sizes.safe.map_or(contour, |height| height.over(contour));
    check_heights(core, st, soft.span, start, contour, safe, soft.sizes.plane)?;
    Ok(Some(Heights { first: soft.sizes.plane.map(|height| height.over(contour)), safe, contour }))
}

fn check_heights(
    core: &Core<'_>,
    st: &State,
    span: Span,
    start: f64,
    contour: f64,
    safe: f64,
    plane: Option<Height>,
) -> Outcome {
    if safe < contour || safe > start + SAME_POINT {
        return core.refuse(span, codes::S2083::discl_lies_outside_way());
    }
    if st.is(GCode::G340) && safe == contour && start != contour {
        return core.refuse(span, codes::P9011::under_g340_without_discl_tool_comes_down());
    }
    let between = |height: Height| (safe..=start.max(safe)).contains(&height.over(contour));
    if plane.is_some_and(|height| !between(height)) {
        return core.refuse(span, codes::S2083::disrp_lies_outside_way());
    }
    Ok(())
}

/// The moves from the contour; `None` where no feed is programmed.
fn retract(
    core: &Core<'_>,
    st: &State,
    (code, span): (GCode, Span),
    sizes: Sizes,
    end: Pos,
    (side, ends): (Side, bool),
    before: Path,
) -> Outcome<Option<(Vec<SoftMove>, Pos)>> {
    let plane = st.plane();
    let [first, second, third] = st.roles();
    if side != Side::None && !ends {
        return core.refuse(span, codes::P9011::leaves_radius_compensation(&code.word()));
    }
    let at = st.stands_in(core, plane, span)?;
    let Some(heading) = st.heading.direction_at(plane, at) else {
        return core.refuse(span, codes::S2083::direction_in_front_is_not_known());
    };
    let corner = |axis: Axis, old: f64| end.get(axis).unwrap_or(old);
    let named = end.get(first).is_some() || end.get(second).is_some();
    let far = Point2::new(corner(first, at.x), corner(second, at.y));
    let s = soft_side(core, st, Way { shape: sizes.shape, at, heading, span }, side, named.then_some(far))?;
    let radius = if side == Side::None { 0.0 } else { st.path.radius() };
    let touch = touch(sizes.shape, sizes.size, at, heading, s, radius);
    let heights = retract_heights(core, st, &sizes, end.get(third), span)?;
    let Some(feed) = st.feed.word() else { return Ok(None) };
    let rises = st.is(GCode::G340);
    let mut to = Pos::UNKNOWN;
    to.set_in_plane(plane, touch.contour);
    if let Some((heights, _)) = heights.filter(|_| rises) {
        to.set(third, heights.safe);
    }
    let old = if let Path::Line(feed) = before { feed } else { feed };
    let path = path_of(plane, touch.circle, s > 0.0, old);
    let mut moves = vec![(to, path, st.printed_side(side))];
    // From here on the centre of the tool itself is meant.
    let mut last = Pos::UNKNOWN;
    last.set_in_plane(plane, touch.centre);
    if let Some(heights) = heights {
        rise(st, &mut moves, &mut last, heights, [sizes.infeed.unwrap_or(feed), feed]);
    }
    let height = last.get(third);
    if named {
        last.set_in_plane(plane, far);
    }
    if let Some(top) = end.get(third) {
        last.set(third, top);
    }
    if named || height.is_none() || height != last.get(third) {
        moves.push((last, Path::Line(feed), Side::None));
    }
    Ok(Some((moves, last)))
}

/// Heights of a retraction, and the highest of them; `None` where the way stays in its plane. `top`: where the block ends.
fn retract_heights(
    core: &Core<'_>,
    st: &State,
    sizes: &Sizes,
    top: Option<f64>,
    span: Span,
) -> Outcome<Option<(Heights, f64)>> {
    let [_, _, third] = st.roles();
    let needed = sizes.safe.is_some() || sizes.plane.is_some() || top.is_some();
    let Some(contour) = st.position.get(third) else {
        return if needed { st.unknown_axis(core, third, span) } else { Ok(None) };
    };
    let safe = sizes.safe.map_or(contour, |height| height.over(contour));
    let over = sizes.plane.map(|height| height.over(contour));
    let highest = top.or(over).unwrap_or(safe);
    check_heights(core, st, span, highest, contour, safe, sizes.plane)?;
    Ok(Some((Heights { first: over, safe, contour }, highest)))
}

/// From the plane of the contour over the safe height to the next one. `feeds`: of either way.
fn rise(st: &State, moves: &mut Vec<SoftMove>, last: &mut Pos, (heights, highest): (Heights, f64), feeds: [Feed; 2]) {
    let [_, _, third] = st.roles();
    let rises = st.is(GCode::G340);
    let first_stop = if rises { None } else { Some(heights.safe).filter(|z| *z != heights.contour) };
    for (z, feed) in [first_stop, heights.first.or(Some(highest))].into_iter().zip(feeds) {
        let stands = last.get(third).unwrap_or(if rises { heights.safe } else { heights.contour });
        if let Some(z) = z.filter(|z| *z != stands) {
            last.set(third, z);
            moves.push((*last, Path::Line(feed), Side::None));
        }
    }
}

/// The way at the contour: about a centre, or straight.
fn path_of(plane: Plane, about: Option<Point2>, ccw: bool, feed: Feed) -> Path {
    let Some(center) = about else { return Path::Line(feed) };
    let shape = ArcShape::Center { center, ccw, tol: tolerance::SAME };
    Path::Arc(Arc { plane, shape, turns: 0 }, feed)
}

/// Where a way meets the contour, and how it leads there.
#[derive(Debug, Clone, Copy)]
struct Way {
    shape: Shape,
    at: Point2,
    heading: Vec2,
    span: Span,
}

/// Heights of a way.
#[derive(Debug, Clone, Copy)]
struct Heights {
    /// DISRP
    first: Option<f64>,
    safe: f64,
    contour: f64,
}
