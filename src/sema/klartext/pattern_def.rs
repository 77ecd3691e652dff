//! PATTERN DEF and CYCL CALL PAT.
//!
//! Source: K 4.6 (docs/sources.md). The order within a grid is not documented: partc goes line by line, to and fro. Between
//! two places the tool retracts to where it stood in front of CYCL CALL PAT, or to the 2nd set-up clearance where that is
//! higher.

use crate::diag::{Label, codes};
use crate::geo::{Deg, Plane, Point2, Vec2};
use crate::ir::contour::Path;
use crate::lexer::klartext::PatternKind;
use crate::machine::Axis;
use crate::parser::klartext::ast::{Addr, Block, PatternWord, Word};
use crate::sema::cycle::given::Given;
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::cycles::call::{By, Calling, Retract};
use super::cycles::holes::OLD_CLEARANCE;
use super::cycles::patterns::repeated;
use super::cycles::{DefinedCycle, SURFACE};
use super::patterns::{FIRST_PLACED, PLACES_A_STEP};
use super::reading::Reading;
use super::words::{Admits, Words};
use super::{Core, Outcome, Reported, Run};

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

    /// The places of one pattern.
    fn add_places(&self, core: &Core<'_>, plane: Plane, list: &mut Vec<Place>) -> Outcome {
        let mm = core.mm();
        let (first, second, third) = plane.axes();
        let (name, span) = (self.kind.name(), self.span);
        let (Some(x), Some(y)) = (self.along(first), self.along(second)) else {
            let [u, v] = [first, second].map(|axis| Axis::ALL[axis].letter());
            return core.refuse(span, codes::K2411::needs_its_place(&name, &u, &v));
        };
        let (needed, also) = self.takes();
        for (word, _) in &self.list {
            let fits = match word.addr {
                Addr::Axis { axis, incremental } => {
                    !incremental && [first, second, third].iter().any(|known| Axis::ALL[*known] == axis)
                }
                Addr::PatternWord(word) => needed.contains(&word) || also.contains(&word),
                _ => false,
            };
            if !fits {
                return core.refuse(word.span, codes::K2411::has_no_such_word(&name, &core.word_text(word.span)));
            }
        }
        if self.of(PatternWord::Step).is_some() && self.of(PatternWord::End).is_some() {
            return core.refuse(span, codes::K2411::has_step_and_end(&name));
        }
        if matches!(self.kind, PatternKind::Circ | PatternKind::PitchCirc) && self.or_zero(PatternWord::D) < 0.0 {
            return core.refuse(span, codes::K2411::diameter_is_below_zero(&name));
        }
        if let Some(missing) = needed.iter().find(|word| self.of(**word).is_none()) {
            return core.refuse(span, codes::K2411::lacks_word(&name, &missing.name()));
        }
        let offsets = self.offsets(mm);
        if offsets.is_empty() {
            return core.refuse(span, codes::K2411::has_no_number_of_places(&name));
        }
        if matches!(self.kind, PatternKind::Pat | PatternKind::Frame) {
            core.note(span, codes::K2410::places_of_are_visited_line_by_line(&name));
        }
        let (at, surface) = (Point2::new(x * mm, y * mm), self.along(third).unwrap_or(0.0) * mm);
        if let Some(fault) = repeated(name, offsets.iter().map(|offset| at + *offset)) {
            core.say(span, fault);
        }
        list.extend(offsets.into_iter().map(|offset| Place { at: at + offset, surface, clearance: None }));
        Ok(())
    }
}

/// The places at which CYCL CALL PAT runs.
#[derive(Debug, Default)]
pub(super) struct Pattern {
    places: Option<Places>,
    /// The last definition was refused.
    lost: bool,
}

impl Pattern {
    /// PATTERN DEF, SEL PATTERN, or one of them that was refused.
    pub fn define(&mut self, places: Outcome<Places>) -> Outcome {
        self.lost = places.is_err();
        let (places, result) = places.map_or_else(|reported| (None, Err(reported)), |places| (Some(places), Ok(())));
        self.places = places;
        result
    }
}

/// Is a block that cannot be read one that was to define a pattern? What runs over it suffers only from that.
pub(super) fn begins_pattern(text: &[u8]) -> bool {
    text.trim_ascii_start().get(..7).is_some_and(|head| head.eq_ignore_ascii_case(b"PATTERN"))
}

impl Places {
    /// Reads PATTERN DEF.
    pub fn read(reading: Reading<'_, '_>, block: &Block) -> Outcome<Places> {
        let core = reading.core;
        let mut list = Vec::new();
        let is_head = |word: &Word| matches!(word.addr, Addr::Pattern(_));
        for part in block.words.chunk_by(|_, next| !is_head(next)) {
            let Some((&Word { addr: Addr::Pattern(kind), span, .. }, words)) = part.split_first() else { continue };
            let data = Data { kind, span, list: pattern_data(reading, words)? };
            data.add_places(core, reading.st.plane(), &mut list)?;
            if list.len() > MOST {
                return core.refuse(span, codes::K2411::has_too_many_places());
            }
        }
        if list.is_empty() {
            return core.refuse(Where::Block, codes::K2411::names_no_place());
        }
        Ok(Places { list, loc: core.here.origin.loc })
    }
}

/// The words of a pattern with their values.
fn pattern_data<'b>(reading: Reading<'_, '_>, words: &'b [Word]) -> Outcome<Vec<(&'b Word, f64)>> {
    let mut list: Vec<(&Word, f64)> = Vec::with_capacity(words.len());
    for word in words {
        let value = reading.number(word.value, word.span)?;
        if list.iter().any(|(other, _)| other.addr == word.addr) {
            let text = reading.core.word_text(word.span);
            return reading.core.refuse(word.span, codes::K2411::word_stands_twice(&text));
        }
        list.push((word, value));
    }
    Ok(list)
}

impl Run<'_> {
    /// Runs the machining cycle at all places of the PATTERN DEF in force.
    pub(super) fn call_pattern(&mut self, block: &Block) -> Outcome {
        // The first word is PAT itself.
        let mut rest = block.clone();
        rest.words.drain(..1);
        let admits = Admits::FEED.and(Admits::M);
        let w = self.gather_m(&rest, "CYCL CALL PAT", admits, &[2, 30, 89, 91, 92, 99])?;
        let Some(places) = self.pattern.places.take() else {
            if self.pattern.lost {
                return Err(Reported);
            }
            return self.core.refuse(Where::Block, codes::K9010::cycl_call_pat_runs_over_pattern());
        };
        let result = self.run_pattern(&w, &places);
        self.pattern.places = Some(places);
        result
    }

    fn run_pattern(&mut self, w: &Words, places: &Places) -> Outcome {
        if let Some(name) = self.cycles.program() {
            return self.run_program_pattern(w, places, &name);
        }
        let cycle = self.pattern_subject("CYCL CALL PAT")?;
        let old = matches!(cycle.number, 1..=5 | 17);
        if cycle.number < FIRST_PLACED && !old {
            return cycle.refuse(&self.core, codes::P9010::running_it_at_places_of_pattern_def());
        }
        if !old {
            cycle.has_a_surface(&self.core, "CYCL CALL PAT")?;
        }
        if places.list.is_empty() {
            self.core.report(
                codes::K8105::cycl_call_pat_runs_cycle_nowhere()
                    .at(self.core.here.origin.loc)
                    .also(places.loc, Label::SelectedHere),
            );
        }
        cycle.same_unit(&self.core)?;
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
        let height = self.view().position_of(self.st.axis(), self.core.block_span(), "CYCL CALL PAT")?;
        if old {
            cycle.starts_at(&self.core, &given, (places, height))?;
        }
        for (i, place) in places.list.iter().enumerate() {
            self.core.goes_on()?;
            let calling = match old {
                // From place to place at the set-up clearance, to which an old cycle comes back.
                true => Calling { by: By::Pattern, ..Calling::HERE },
                false => {
                    let clear = cycle.heights(&self.core, &given, place.surface);
                    self.rise_to(place.clearance.map_or(clear.second, |height| height.max(clear.second)));
                    // The higher one of the clearances here and at the next place.
                    let next = places.list.get(i + 1).and_then(|next| next.clearance);
                    let height = [place.clearance, next].into_iter().flatten().fold(height, f64::max);
                    Calling { shift: place.surface, retract: Retract::To(height), by: By::Pattern }
                }
            };
            self.go_in_plane(place.at, Path::straight(feed));
            self.run_given(&cycle, &given, calling)?;
        }
        self.m_at_end(w.m())
    }
}

impl DefinedCycle {
    /// The old cycles start where the tool stands, at their set-up clearance. Whether they come to it above the Z of a
    /// place is open, so the tool has to stand there.
    fn starts_at(&self, core: &Core<'_>, given: &Given, (places, height): (&Places, f64)) -> Outcome {
        let clearance = given.magnitude(OLD_CLEARANCE);
        let wrong = places.list.iter().find_map(|place| {
            let start = place.surface + clearance;
            let lifts = place.clearance.filter(|high| *high > height + SAME_HEIGHT);
            match lifts {
                Some(high) => Some(codes::P9010::cycle_at_place_of_clearance(&self.number, &high)),
                None if (height - start).abs() > SAME_HEIGHT => {
                    Some(codes::P9010::cycle_starts_where_tool_stands(&self.number, &height, &clearance, &start))
                }
                None => None,
            }
        });
        let Some(fault) = wrong else { return Ok(()) };
        let found = fault.at(core.here.origin.loc);
        core.report(found.also(places.loc, Label::Pattern).also(self.loc, Label::Cycle));
        Err(Reported)
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
