//! What the words of a line do, in the order of the RS274 manual: modes of the feed, F, S, T, change, spindle, coolant,
//! other functions, dwell, plane, units, compensation, length, offset, distances, motion, stop.

use super::act::{AXES, Act, Arc, Cutter, FeedKind, LETTERS, Move, Path, PathControl, Plane, Speed};
use super::block::{Block, CornerWord, is_tap};
use super::number::SCALE;
use super::rules::Words;
use super::{ACTS, Fault, Lack, Reader};

impl Reader {
    /// Carries out the words of a line.
    pub(super) fn run(&mut self, mut block: Block) -> Result<(), Fault> {
        if let Some(inches) = block.inches
            && self.modes.inches != Some(inches)
        {
            // F is read before the unit, positions behind it.
            if block.has(b'F') {
                return Err(Fault::new("the unit changes in a line with F, which counts in the old one"));
            }
            self.modes.inches = Some(inches);
        }
        let spindle = block.take(b'$').map_or(Ok(0), |units| {
            u8::try_from(units / SCALE).ok().filter(|_| units % SCALE == 0).ok_or_else(|| Fault::new("no such spindle"))
        })?;
        // The number of a wait may have the address of the feed.
        let wait = if block.dwell { block.take(self.rules.dwell.0) } else { None };
        let new_feed = block.has(b'F');
        self.feed_words(&mut block)?;
        self.speed_words(&mut block, spindle)?;
        if let Some(tool) = block.take_whole(b'T')? {
            self.tool(tool)?;
        }
        if let Some(angle) = block.orient {
            self.push(Act::M { number: 19, spindle: 0, angle: Some(angle) })?;
        }
        self.functions(&mut block, spindle)?;
        if block.dwell {
            let seconds = wait.filter(|units| *units >= 0).and_then(|units| self.rules.seconds(units));
            if self.rules.dwell.1 > 1 && self.modes.feed_kind == Some(FeedKind::PerRevolution) {
                return Err(Fault::new("under a feed per revolution G4 may count revolutions"));
            }
            self.push(Act::Dwell(seconds.ok_or_else(|| Fault::new("G4 wants its wait"))?))?;
        }
        self.mode_words(&mut block)?;
        self.motion(&mut block, new_feed)?;
        if block.more_turns.is_some() {
            return Err(Fault::new("TURN without an arc"));
        }
        if let Some(letter) = block.left() {
            return Err(Fault::new(format!("the {letter} word has nothing that it belongs to")));
        }
        for number in block.m().filter(|m| stops(*m)) {
            self.push(Act::M { number, spindle: 0, angle: None })?;
            self.ended |= matches!(number, 2 | 30);
        }
        let modes = &self.modes;
        let by_time = modes.feed_kind == Some(FeedKind::InverseTime);
        let as_written =
            modes.incremental == Some(false) && modes.inches == Some(false) && modes.diameter != Some(true);
        self.plain = as_written && !by_time && !self.ended;
        Ok(())
    }

    pub(super) fn push(&mut self, act: Act) -> Result<(), Fault> {
        let place = self.acts.get_mut(self.open.1).ok_or_else(|| Fault::new("too much in one line"))?;
        *place = act;
        self.spindle_hears(&act);
        self.open.1 += 1;
        debug_assert!(self.open.1 <= ACTS);
        Ok(())
    }

    /// A T word: the next tool, or on a turret the tool and its offset.
    fn tool(&mut self, number: u32) -> Result<(), Fault> {
        let Some(digits) = self.rules.turret else {
            self.tools[0] = Some(number);
            return self.push(Act::Select(number));
        };
        let place = 10u32.pow(digits);
        let (tool, offset) = (number / place, number % place);
        if tool == 0 || offset == 0 {
            return Err(Fault::new("T without a tool, or without its offset"));
        }
        self.modes.length = Some(offset);
        self.push(Act::Select(tool))?;
        self.push(Act::Change)
    }

    /// A length of the program in units.
    pub(super) fn length(&self, number: i64) -> Result<i64, Fault> {
        match self.modes.inches {
            Some(false) => Ok(number),
            Some(true) => {
                let units = i128::from(number) * 254 / 10;
                i64::try_from(units).ok().ok_or_else(|| Fault::new("a length is too large"))
            }
            None => Err(Fault::unsaid("millimetres or inches: nobody has said it", Lack::Unit)),
        }
    }

    fn feed_words(&mut self, block: &mut Block) -> Result<(), Fault> {
        if let Some(kind) = block.feed_kind
            && self.modes.feed_kind.replace(kind) != Some(kind)
        {
            // A feed of another kind counts no longer.
            self.feed = None;
        }
        let lead = self.rules.lead == b'F' && block.motion.or(self.modes.motion) == Some(33);
        if let Some(feed) = if lead { None } else { block.take(b'F') } {
            if feed < 0 {
                return Err(Fault::new("a feed below zero"));
            }
            let by_time = self.modes.feed_kind == Some(FeedKind::InverseTime);
            self.feed = Some(if by_time { feed } else { self.length(feed)? });
        }
        Ok(())
    }

    fn speed_words(&mut self, block: &mut Block, spindle: u8) -> Result<(), Fault> {
        if block.speed_limit {
            let limit = block.take(b'S').filter(|_| block.constant_cut.is_none());
            self.speed_limit = Some(limit.ok_or_else(|| Fault::new("a largest speed wants S, alone"))?);
            return Ok(());
        }
        if let Some(on) = block.constant_cut {
            // Further spindles have modes of their own.
            if spindle == 0 {
                self.modes.constant_cut = Some(on);
            }
            if on && self.rules.words == Words::Rs274 {
                self.speed_limit = block.take(b'D');
            }
        }
        let Some(value) = block.take(b'S') else {
            return match block.constant_cut {
                Some(true) => Err(Fault::new("G96 wants S")),
                // What its last S meant is not kept.
                Some(false) if spindle != 0 => Err(Fault::new("G97 of a further spindle wants S")),
                Some(false) | None => Ok(()),
            };
        };
        // Under G96 each S is a cutting speed.
        let on = if spindle == 0 { self.modes.constant_cut } else { block.constant_cut };
        let constant_cut = (on == Some(true)).then_some(self.speed_limit);
        self.push(Act::Speed(Speed { spindle, value, constant_cut }))
    }

    /// M functions that act before the move.
    fn functions(&mut self, block: &mut Block, spindle: u8) -> Result<(), Fault> {
        for _ in block.m().filter(|m| *m == 6) {
            self.tools[1] = self.tools[0];
            self.push(Act::Change)?;
        }
        for number in block.m().filter(|m| of_spindle(*m)) {
            let angle = if number == 19 { block.take(b'R') } else { None };
            self.push(Act::M { number, spindle, angle })?;
        }
        for number in block.m().filter(|m| !of_spindle(*m) && !stops(*m) && *m != 6) {
            self.push(Act::M { number, spindle: 0, angle: None })?;
        }
        Ok(())
    }

    /// Modes that hold from this line on.
    fn mode_words(&mut self, block: &mut Block) -> Result<(), Fault> {
        let mut cutter = block.cutter(&self.rules)?;
        if let Some(Cutter { diameter: Some(diameter), .. }) = &mut cutter {
            *diameter = self.length(*diameter)?;
        }
        let modes = &mut self.modes;
        modes.plane = block.plane.or(modes.plane);
        modes.diameter = block.diameter.or(modes.diameter);
        match block.length {
            Some(true) => {
                let number = block.take_whole(b'H')?.ok_or_else(|| Fault::new("G43 wants H"))?;
                let straight = matches!(block.motion, Some(0 | 1));
                if self.rules.length_moves && !(straight && block.has(b'Z') && !block.machine) {
                    return Err(Fault::new("G43 stands in a straight move along Z only"));
                }
                modes.length = Some(number);
            }
            Some(false) => modes.length = Some(0),
            None => {}
        }
        if self.rules.words == Words::Siemens
            && let Some(edge) = block.take_whole(b'D')?
        {
            let tool = self.tools[1].ok_or_else(|| Fault::new("D without a tool"));
            modes.length = Some(if edge == 0 { 0 } else { tool? });
        }
        if let Some(cutter) = cutter {
            self.side(cutter, block)?;
        }
        let modes = &mut self.modes;
        modes.incremental = block.incremental.or(modes.incremental);
        modes.absolute_centers = block.absolute_centers.or(modes.absolute_centers);
        self.corners(block)?;
        let modes = &mut self.modes;
        if block.stop_motion {
            modes.motion = None;
            modes.cycles_are_off = true;
        }
        if let Some((letter, from)) = block.offset_by_number {
            let number = block.take_whole(letter)?.filter(|number| (1..=99).contains(number));
            let number = number.ok_or_else(|| Fault::new("a work offset without its number"))?;
            block.offset = Some(from + number as u8);
        }
        if let Some(offset) = block.offset {
            modes.offset = offset;
            // The same place has other coordinates now.
            self.known = 0;
            self.push(Act::Offset(offset))?;
        }
        Ok(())
    }

    /// Another way to take corners.
    fn corners(&mut self, block: &mut Block) -> Result<(), Fault> {
        let of_arc = matches!(block.motion, Some(2 | 3)) || block.dwell;
        let (word, length) = (block.corners, block.corner_length.take());
        let mode = match (word, length) {
            (None, None) => return Ok(()),
            (Some(CornerWord::Exact), None) => PathControl::Exact,
            (Some(CornerWord::Continuous), None) if self.rules.words == Words::Rs274 && block.has(b'P') => {
                if of_arc {
                    return Err(Fault::new("P belongs to G64 or to another word of the line"));
                }
                let [bound, merged] = [block.take(b'P'), block.take(b'Q')].map(Option::unwrap_or_default);
                match (bound, merged) {
                    (..0, _) | (_, ..0) => return Err(Fault::new("a bound below zero")),
                    // Without P there is no bound, whatever Q is.
                    (0, _) => PathControl::Unbounded,
                    // Q0 merges no lines; one bound for both is the smaller of them.
                    (_, 0) => PathControl::Within(self.length(bound)?),
                    _ => PathControl::Within(self.length(bound.min(merged))?),
                }
            }
            (Some(CornerWord::Continuous), None) => PathControl::Unbounded,
            (Some(CornerWord::Before), Some((false, length))) if length > 0 => {
                PathControl::Before(self.length(length)?)
            }
            (Some(CornerWord::Within), Some((true, length))) if length > 0 => PathControl::Within(self.length(length)?),
            _ => return Err(Fault::new("G641 wants ADIS, G642 wants CTOL, and both lengths want their word")),
        };
        self.modes.corners = Some(mode);
        self.push(Act::Corners(mode))
    }

    /// Another side, or another tool whose radius counts.
    fn side(&mut self, mut cutter: Cutter, block: &Block) -> Result<(), Fault> {
        let modes = &mut self.modes;
        if self.rules.words == Words::Siemens && cutter.side != 0 {
            // The radius belongs to the D that is in force.
            let tool = modes.length.filter(|tool| *tool != 0);
            cutter.tool = tool.ok_or_else(|| Fault::new("G41 or G42 without the D of a tool"))?;
        }
        let [first, second, _] = modes.plane.unwrap_or(Plane::Xy).axes();
        let straight = matches!(block.motion.or(modes.motion), Some(0 | 1)) && !block.machine;
        let moves = straight && (block.has(LETTERS[first]) || block.has(LETTERS[second]));
        let changes = modes.cutter.map_or(0, |cutter| cutter.side) != cutter.side;
        if self.rules.side_moves && changes && !moves {
            return Err(Fault::new("radius compensation begins or ends without a straight move in the plane"));
        }
        modes.cutter = Some(cutter);
        Ok(())
    }

    fn motion(&mut self, block: &mut Block, new_feed: bool) -> Result<(), Fault> {
        let named = LETTERS.iter().any(|letter| block.has(*letter));
        let motion = block.motion.or(self.modes.motion);
        let cuts = matches!(motion, Some(1..=3));
        let centred = b"IJK".iter().any(|letter| block.has(*letter));
        if (named || centred) && cuts && self.modes.feed_kind == Some(FeedKind::InverseTime) && !new_feed {
            return Err(Fault::new("each move by time wants its F"));
        }
        self.modes.motion = motion;
        if let Some(motion) = motion.filter(|_| named && is_tap(motion)) {
            return self.taps(block, motion);
        }
        if block.level {
            return Err(Fault::new("where a cycle returns to, without a cycle"));
        }
        if let (false, true, true, Some(circle @ (2 | 3)), false) =
            (named, self.rules.turns, centred, motion, block.machine)
        {
            return self.circle(block, circle == 3);
        }
        if named && self.turns {
            return Err(Fault::new("a move while the plane is stated and the axes did not turn yet"));
        }
        if !named {
            return match block.motion {
                motion if is_tap(motion) => Err(Fault::new("a tap without a depth")),
                Some(2 | 3) => Err(Fault::new("an arc without an end")),
                Some(33) => Err(Fault::new("a thread without an end")),
                _ if block.machine => Err(Fault::new("G53 without an axis")),
                _ => Ok(()),
            };
        }
        if block.machine && self.rules.words == Words::Siemens && self.modes.length != Some(0) {
            return Err(Fault::new("the length of the tool counts under SUPA"));
        }
        let Some(motion) = self.modes.motion else { return Err(Fault::unsaid("axes without a move", Lack::Mode)) };
        let (from, was) = (self.at, self.known);
        let axes = self.ends(block)?;
        let path = match motion {
            0 => {
                if let Some(rapid) = self.rules.rapid_feed
                    && (!new_feed || self.feed.take() != Some(rapid))
                {
                    return Err(Fault::new("rapid traverse at another feed, for it goes at the last F"));
                }
                Path::Rapid
            }
            1 if block.machine && !matches!(self.rules.words, Words::Rs274 | Words::Siemens) => {
                return Err(Fault::new("a feed in machine coordinates"));
            }
            1 => Path::Line,
            33 if block.machine => return Err(Fault::new("a thread in machine coordinates")),
            33 => {
                let lead = block.take(self.rules.lead).filter(|lead| *lead > 0);
                if self.rules.lead == b'F' {
                    self.feed = None;
                    let moved = (0..AXES).filter(|i| axes & (1 << i) != 0 && from[*i] != self.at[*i]).count();
                    if moved > 1 {
                        return Err(Fault::new("the lead of a tapered thread counts along one axis"));
                    }
                }
                Path::Thread(self.length(lead.ok_or_else(|| Fault::new("a thread without a lead"))?)?)
            }
            _ if block.machine => return Err(Fault::new("an arc in machine coordinates")),
            _ => Path::Arc(self.arc(block, motion == 3, &from, was)?),
        };
        if block.machine {
            self.known &= !axes;
        }
        self.push(Act::Move(Move { path, axes, machine: block.machine }))
    }

    /// A full circle, whose line names no end: back to where it begins.
    fn circle(&mut self, block: &mut Block, ccw: bool) -> Result<(), Fault> {
        let arc = self.arc(block, ccw, &self.at, self.known)?;
        let [first, second, _] = arc.plane.axes();
        let axes = (1 << first) | (1 << second);
        self.push(Act::Move(Move { path: Path::Arc(arc), axes, machine: false }))
    }

    /// Takes the axes of the line; a bit for each.
    fn ends(&mut self, block: &mut Block) -> Result<u16, Fault> {
        let mut axes = 0;
        for (axis, letter) in LETTERS.iter().enumerate() {
            let Some(number) = block.take(*letter) else { continue };
            let rotary = (3..6).contains(&axis);
            let mut units = if rotary { number } else { self.length(number)? };
            if axis == 0 && self.modes.diameter == Some(true) {
                units /= 2;
            }
            let Some(incremental) = self.modes.incremental else {
                return Err(Fault::unsaid("absolute or incremental: nobody has said it", Lack::Mode));
            };
            if incremental && !block.machine {
                let before = self
                    .place(axis)
                    .ok_or_else(|| Fault::unsaid("an increment from an unknown place", Lack::Place(axis)))?;
                units = before.checked_add(units).ok_or_else(|| Fault::new("a place is too far away"))?;
            }
            self.stand(axis, units);
            axes |= 1 << axis;
        }
        Ok(axes)
    }

    fn arc(&self, block: &mut Block, ccw: bool, before: &[i64; AXES], was: u16) -> Result<Arc, Fault> {
        let Some(plane) = self.modes.plane else {
            return Err(Fault::unsaid("the plane: nobody has said it", Lack::Mode));
        };
        let [first, second, third] = plane.axes();
        let known = (1 << first) | (1 << second);
        // A helix: how far it rises nobody knows.
        if was & (1 << third) == 0 && self.known & (1 << third) != 0 {
            return Err(Fault::unsaid("a helix from an unknown place", Lack::Place(third)));
        }
        if was & known != known || self.known & known != known {
            let missing = if was & self.known & (1 << first) == 0 { first } else { second };
            return Err(Fault::unsaid("an arc from an unknown place", Lack::Place(missing)));
        }
        let (from, to) = ([before[first], before[second]], [self.at[first], self.at[second]]);
        let turns = if self.rules.words == Words::Siemens {
            block.more_turns.take().unwrap_or(0).saturating_add(1)
        } else if self.rules.turns {
            block.take_whole(b'P')?.unwrap_or(1)
        } else {
            1
        };
        let turns = i32::try_from(turns).ok().filter(|turns| *turns > 0);
        let turns = turns.ok_or_else(|| Fault::new("no such number of turns"))?;
        let turns = if ccw { turns } else { -turns };
        if let Some(radius) = block.take(b'R') {
            let center = by_radius(from, to, self.length(radius)?, ccw)?;
            return Ok(Arc { plane, from, to, center, turns, by_angle: false });
        }
        let offsets = [block.take(b"IJK"[first]), block.take(b"IJK"[second])];
        if offsets == [None, None] {
            return Err(Fault::new("an arc without a centre"));
        }
        // FreeCAD writes the third offset, too: 0 has no effect.
        let outside = b"IJK"[third];
        if block.take(outside).is_some_and(|units| units != 0) {
            return Err(Fault::new(format!("{} lies outside the plane of the arc", char::from(outside))));
        }
        let Some(absolute) = self.modes.absolute_centers else {
            return Err(Fault::unsaid("where centres count from: nobody has said it", Lack::Mode));
        };
        let mut center = [0; 2];
        for i in 0..2 {
            let units = self.length(offsets[i].unwrap_or(0))?;
            let place = if absolute { Some(units) } else { from[i].checked_add(units) };
            if absolute && offsets[i].is_none() {
                return Err(Fault::new("a centre with one coordinate only"));
            }
            center[i] = place.ok_or_else(|| Fault::new("a centre is too far away"))?;
        }
        Ok(Arc { plane, from, to, center, turns, by_angle: false })
    }
}

/// The centre of an arc by its radius; a negative one asks for more than half a turn.
fn by_radius(from: [i64; 2], to: [i64; 2], radius: i64, ccw: bool) -> Result<[i64; 2], Fault> {
    let way = [0, 1].map(|i| (i128::from(to[i]) - i128::from(from[i])) as f64);
    let chord = libm::hypot(way[0], way[1]);
    let r = (radius as f64).abs();
    if chord == 0.0 || chord > 2.0 * r * 1.001 {
        return Err(Fault::new("no circle of this radius leads there"));
    }
    let height = libm::sqrt((r * r - chord * chord / 4.0).max(0.0));
    // Left of the way for a short arc counter-clockwise.
    let side = if ccw == (radius > 0) { 1.0 } else { -1.0 };
    let off = |i: usize| [-way[1], way[0]][i] / chord * height * side;
    let center = |i: usize| from[i].checked_add(libm::round(way[i] / 2.0 + off(i)) as i64);
    center(0).zip(center(1)).map(|(u, v)| [u, v]).ok_or_else(|| Fault::new("a centre is too far away"))
}

fn of_spindle(m: u32) -> bool {
    matches!(m, 3..=5 | 19)
}

/// M functions that act behind the move.
fn stops(m: u32) -> bool {
    matches!(m, 0 | 1 | 2 | 30 | 60)
}
