//! PATTERN DEF and CYCL CALL PAT.
//!
//! Source: K 4.6 (docs/sources.md). The order within a grid is not documented: partc goes line by line, to and fro. Between
//! two places the tool retracts to where it stood in front of CYCL CALL PAT, or to the 2nd set-up clearance where that is
//! higher.

use crate::diag::{Label, codes};
use crate::geo::{Deg, Point2, Vec2};
use crate::ir::contour::Path;
use crate::ir::{Feed, Pos};
use crate::lexer::klartext::PatternKind;
use crate::machine::Axis;
use crate::parser::klartext::ast::{Addr, Block, PatternWord, Word};
use crate::sema::cycle::given::Given;
use crate::text::{Loc, Span};

use super::cycles::call::{By, Calling, Retract};
use super::cycles::holes::OLD_CLEARANCE;
use super::cycles::{DefinedCycle, SURFACE};
use super::patterns::{FIRST_PLACED, PLACES_A_STEP};
use super::words::Admits;
use super::{Outcome, Reported, Run};

/// Heights that differ by less are one, mm.
const SAME_HEIGHT: f64 = 1e-6;

/// Most places of a definition.
const MOST: usize = 99_999;

/// Places of a PATTERN DEF, in mm: in the plane, and the surface there.
#[derive(Debug)]
pub(super) struct Places {
    list: Vec<Place>,
    pub loc: Loc,
}

/// One of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub at: Point2,
    /// Of the surface.
    pub surface: f64,
    /// Height at which the tool goes to this place and from it, where one is given.
    pub clearance: Option<f64>,
}

impl Places {
    /// Those of a point table that is selected here.
    pub fn of_table(list: Vec<Place>, loc: Loc) -> Places {
        Places { list, loc }
    }

    pub fn iter(&self) -> impl Iterator<Item = &Place> {
        self.list.iter()
    }
}

/// What a pattern says.
#[derive(Debug)]
struct Data<'b> {
    kind: PatternKind,
    span: Span,
    /// Its words with their values.
    list: Vec<(&'b Word, f64)>,
}

impl Data<'_> {
    fn of(&self, word: PatternWord) -> Option<f64> {
        self.list.iter().find(|(found, _)| found.addr == Addr::PatternWord(word)).map(|(_, value)| *value)
    }

    fn or_zero(&self, word: PatternWord) -> f64 {
        self.of(word).unwrap_or(0.0)
    }

    /// A coordinate, absolute.
    fn along(&self, axis: usize) -> Option<f64> {
        let addr = Addr::Axis { axis: Axis::ALL[axis], incremental: false };
        self.list.iter().find(|(found, _)| found.addr == addr).map(|(_, value)| *value)
    }

    /// The words that it needs, besides its place, and those that it may have.
    fn takes(&self) -> (&'static [PatternWord], &'static [PatternWord]) {
        use PatternWord::{D, Dx, Dy, End, Num, NumX, NumY, Rot, RotX, RotY, Start, Step};
        match self.kind {
            PatternKind::Pos => (&[], &[]),
            PatternKind::Row => (&[D, Num], &[Rot]),
            PatternKind::Pat | PatternKind::Frame => (&[Dx, Dy, NumX, NumY], &[Rot, RotX, RotY]),
            PatternKind::Circ => (&[D, Start, Num], &[]),
            PatternKind::PitchCirc if self.of(End).is_some() => (&[D, Start, Num], &[Step, End]),
            PatternKind::PitchCirc => (&[D, Start, Num, Step], &[]),
        }
    }

    /// From the place of the pattern to its places.
    fn offsets(&self, mm: f64) -> Vec<Vec2> {
        use PatternWord::{D, Dx, Dy, End, Num, NumX, NumY, Rot, RotX, RotY, Start, Step};
        let (size, start, count) = (self.or_zero(D) * mm, self.or_zero(Start), self.or_zero(Num));
        match self.kind {
            PatternKind::Pos => vec![Vec2::zeros()],
            PatternKind::Row => {
                let along = Deg(self.or_zero(Rot)).unit();
                numbers(count).map(|k| along * (k * size)).collect()
            }
            PatternKind::Circ => numbers(count).map(|k| Deg(start + k * 360.0 / count).unit() * (size / 2.0)).collect(),
            PatternKind::PitchCirc => {
                let step = match self.of(End) {
                    Some(end) if count > 1.0 => (end - start) / (count - 1.0),
                    Some(_) => 0.0,
                    None => self.or_zero(Step),
                };
                numbers(count).map(|k| Deg(start + k * step).unit() * (size / 2.0)).collect()
            }
            PatternKind::Pat | PatternKind::Frame => {
                let turn = self.or_zero(Rot);
                let along = Deg(turn + self.or_zero(RotX)).unit() * (self.or_zero(Dx) * mm);
                let beside = Deg(turn + 90.0 + self.or_zero(RotY)).unit() * (self.or_zero(Dy) * mm);
                grid(self.or_zero(NumX), self.or_zero(NumY), self.kind == PatternKind::Frame)
                    .map(|(i, j)| along * i + beside * j)
                    .collect()
            }
        }
    }
}

impl Run<'_> {
    /// A block that cannot be read was to define a pattern: what runs over it suffers only from that.
    pub(super) fn refused_pattern(&mut self, text: &[u8]) {
        let begins = text.trim_ascii_start().get(..7).is_some_and(|head| head.eq_ignore_ascii_case(b"PATTERN"));
        if begins {
            (self.places, self.places_lost) = (None, true);
        }
    }

    pub(super) fn pattern_def(&mut self, block: &Block) -> Outcome {
        self.places = None;
        let result = self.read_patterns(block);
        self.places_lost = result.is_err();
        result
    }

    fn read_patterns(&mut self, block: &Block) -> Outcome {
        let loc = self.core.here.origin.loc;
        let mut list = Vec::new();
        let is_head = |word: &Word| matches!(word.addr, Addr::Pattern(_));
        for part in block.words.chunk_by(|_, next| !is_head(next)) {
            let Some((&Word { addr: Addr::Pattern(kind), span, .. }, words)) = part.split_first() else { continue };
            let data = Data { kind, span, list: self.pattern_data(words)? };
            self.add_places(&data, &mut list)?;
            if list.len() > MOST {
                return self.core.refuse(span, codes::K2411::has_too_many_places());
            }
        }
        if list.is_empty() {
            return self.core.refuse(self.core.block_span(), codes::K2411::names_no_place());
        }
        self.places = Some(Places { list, loc });
        Ok(())
    }

    fn pattern_data<'b>(&mut self, words: &'b [Word]) -> Outcome<Vec<(&'b Word, f64)>> {
        let mut list: Vec<(&Word, f64)> = Vec::with_capacity(words.len());
        for word in words {
            let value = self.number(word.value, word.span)?;
            if list.iter().any(|(other, _)| other.addr == word.addr) {
                return self.core.refuse(word.span, codes::K2411::word_stands_twice(&self.word_text(word.span)));
            }
            list.push((word, value));
        }
        Ok(list)
    }

    /// The places of one pattern.
    fn add_places(&mut self, data: &Data<'_>, list: &mut Vec<Place>) -> Outcome {
        let mm = self.core.level().frame.unit.mm();
        let (first, second, third) = self.st.plane().axes();
        let (name, span) = (data.kind.name(), data.span);
        let (Some(x), Some(y)) = (data.along(first), data.along(second)) else {
            let [u, v] = [first, second].map(|axis| Axis::ALL[axis].letter());
            return self.core.refuse(span, codes::K2411::needs_its_place(&name, &u, &v));
        };
        let (needed, also) = data.takes();
        for (word, _) in &data.list {
            let fits = match word.addr {
                Addr::Axis { axis, incremental } => {
                    !incremental && [first, second, third].iter().any(|known| Axis::ALL[*known] == axis)
                }
                Addr::PatternWord(word) => needed.contains(&word) || also.contains(&word),
                _ => false,
            };
            if !fits {
                return self.core.refuse(word.span, codes::K2411::has_no_such_word(&name, &self.word_text(word.span)));
            }
        }
        if data.of(PatternWord::Step).is_some() && data.of(PatternWord::End).is_some() {
            return self.core.refuse(span, codes::K2411::has_step_and_end(&name));
        }
        if matches!(data.kind, PatternKind::Circ | PatternKind::PitchCirc) && data.or_zero(PatternWord::D) < 0.0 {
            return self.core.refuse(span, codes::K2411::diameter_is_below_zero(&name));
        }
        if let Some(missing) = needed.iter().find(|word| data.of(**word).is_none()) {
            return self.core.refuse(span, codes::K2411::lacks_word(&name, &missing.name()));
        }
        let offsets = data.offsets(mm);
        if offsets.is_empty() {
            return self.core.refuse(span, codes::K2411::has_no_number_of_places(&name));
        }
        if matches!(data.kind, PatternKind::Pat | PatternKind::Frame) {
            self.core
                .job
                .diags
                .push_once(codes::K2410::places_of_are_visited_line_by_line(&name).at(self.core.loc(span)));
        }
        let (at, surface) = (Point2::new(x * mm, y * mm), data.along(third).unwrap_or(0.0) * mm);
        self.warn_of_repeated_places(name, offsets.iter().map(|offset| at + *offset), self.core.loc(span));
        list.extend(offsets.into_iter().map(|offset| Place { at: at + offset, surface, clearance: None }));
        Ok(())
    }

    /// Runs the machining cycle at all places of the PATTERN DEF in force.
    pub(super) fn call_pattern(&mut self, block: &Block) -> Outcome {
        // The first word is PAT itself.
        let mut rest = block.clone();
        rest.words.drain(..1);
        let w = self.gather(&rest, "CYCL CALL PAT", Admits::FEED.and(Admits::M))?;
        self.check_m(&w)?;
        self.forbid_m(&w, "CYCL CALL PAT", &[2, 30, 89, 91, 92, 99])?;
        let Some(places) = self.places.take() else {
            if self.places_lost {
                return Err(Reported);
            }
            return self.core.refuse(self.core.block_span(), codes::K9010::cycl_call_pat_runs_over_pattern());
        };
        let result = self.run_pattern(&w, &places);
        self.places = Some(places);
        result
    }

    fn run_pattern(&mut self, w: &super::words::Words, places: &Places) -> Outcome {
        if let Some(name) = self.program_of_cycle_12() {
            return self.run_program_pattern(w, places, &name);
        }
        let cycle = self.pattern_subject("CYCL CALL PAT")?;
        let old = matches!(cycle.number, 1..=5 | 17);
        if cycle.number < FIRST_PLACED && !old {
            return self.refuse_cycle(&cycle, codes::P9010::running_it_at_places_of_pattern_def());
        }
        if !old {
            self.has_a_surface(&cycle, "CYCL CALL PAT")?;
        }
        if places.list.is_empty() {
            self.core.report(
                codes::K8105::cycl_call_pat_runs_cycle_nowhere()
                    .at(self.core.here.origin.loc)
                    .also(places.loc, Label::SelectedHere),
            );
        }
        self.same_unit(&cycle)?;
        let given = self.checked(&cycle)?;
        let own = given.length(SURFACE);
        if own != 0.0 && places.list.iter().any(|place| place.surface != 0.0) {
            self.core.report(
                codes::K2411::places_have_surface_z_of_their_own()
                    .at(self.core.here.origin.loc)
                    .also(places.loc, Label::Pattern)
                    .also(cycle.loc, Label::Cycle),
            );
            return Err(Reported);
        }
        self.core.budget.take(places.list.len() as u64 / PLACES_A_STEP);
        self.m_at_start(w, true)?;
        let feed = self.pattern_feed(w, "CYCL CALL PAT")?;
        let height = self.position_of(self.st.axis(), self.core.block_span(), "CYCL CALL PAT")?;
        if old {
            self.old_cycle_starts(&cycle, &given, (places, height))?;
            return self.run_old_pattern(w, (&cycle, &given), places, feed);
        }
        for (i, place) in places.list.iter().enumerate() {
            self.core.goes_on()?;
            let clear = self.heights(&cycle, &given, place.surface);
            let axis = self.st.axis();
            let free = place.clearance.map_or(clear.second, |height| height.max(clear.second));
            if self.st.position.get(axis).is_none_or(|at| at < free) {
                let mut up = Pos::UNKNOWN;
                up.set(axis, free);
                self.send(&up, Path::Rapid);
            }
            let mut end = Pos::UNKNOWN;
            end.set_in_plane(self.st.plane(), place.at);
            self.st.polar.forget_last();
            self.send(&end, Path::straight(feed));
            // The higher one of the clearances here and at the next place.
            let next = places.list.get(i + 1).and_then(|next| next.clearance);
            let height = [place.clearance, next].into_iter().flatten().fold(height, f64::max);
            let calling = Calling { shift: place.surface, retract: Retract::To(height), by: By::Pattern };
            self.run_given(&cycle, &given, calling)?;
        }
        self.m_at_end(w)
    }

    /// The old cycles start where the tool stands, at their set-up clearance. Whether they come to it above the Z of a
    /// place is open, so the tool has to stand there.
    fn old_cycle_starts(&self, cycle: &DefinedCycle, given: &Given, (places, height): (&Places, f64)) -> Outcome {
        let clearance = given.magnitude(OLD_CLEARANCE);
        let wrong = places.list.iter().find_map(|place| {
            let start = place.surface + clearance;
            let lifts = place.clearance.filter(|high| *high > height + SAME_HEIGHT);
            match lifts {
                Some(high) => Some(codes::P9010::cycle_at_place_of_clearance(&cycle.number, &high)),
                None if (height - start).abs() > SAME_HEIGHT => {
                    Some(codes::P9010::cycle_starts_where_tool_stands(&cycle.number, &height, &clearance, &start))
                }
                None => None,
            }
        });
        let Some(fault) = wrong else { return Ok(()) };
        let found = fault.at(self.core.here.origin.loc);
        self.core.report(found.also(places.loc, Label::Pattern).also(cycle.loc, Label::Cycle));
        Err(Reported)
    }

    /// From place to place at the set-up clearance, to which an old cycle comes back.
    fn run_old_pattern(
        &mut self,
        w: &super::words::Words,
        (cycle, given): (&DefinedCycle, &Given),
        places: &Places,
        feed: Option<Feed>,
    ) -> Outcome {
        for place in &places.list {
            self.core.goes_on()?;
            let mut end = Pos::UNKNOWN;
            end.set_in_plane(self.st.plane(), place.at);
            self.st.polar.forget_last();
            self.send(&end, Path::straight(feed));
            self.run_given(cycle, given, Calling { by: By::Pattern, ..Calling::HERE })?;
        }
        self.m_at_end(w)
    }
}

/// 0, 1, … for a whole number of places; none for anything else.
fn numbers(count: f64) -> impl Iterator<Item = f64> {
    let whole = count.fract() == 0.0 && (1.0..=MOST as f64).contains(&count);
    (0..if whole { count as u32 } else { 0 }).map(f64::from)
}

/// Columns and lines of a grid, to and fro; only its border for a frame.
fn grid(columns: f64, lines: f64, frame: bool) -> impl Iterator<Item = (f64, f64)> {
    let (columns, lines) = if columns * lines <= MOST as f64 { (columns, lines) } else { (0.0, 0.0) };
    numbers(lines).flat_map(move |j| {
        numbers(columns).filter_map(move |i| {
            let i = if j % 2.0 == 0.0 { i } else { columns - 1.0 - i };
            let border = i == 0.0 || j == 0.0 || i == columns - 1.0 || j == lines - 1.0;
            (border || !frame).then_some((i, j))
        })
    })
}
