//! PATTERN DEF and CYCL CALL PAT.
//!
//! Source: K 4.6 (docs/sources.md). The order within a grid is not documented: partc goes line by line, to and fro. Between
//! two places the tool retracts to where it stood in front of CYCL CALL PAT, or to the 2nd set-up clearance where that is
//! higher.

use crate::diag::{Diagnostic, codes};
use crate::geo::{Deg, Point2, Vec2};
use crate::ir::contour::Path;
use crate::ir::{Feed, Pos};
use crate::lexer::klartext::{QKind, QRef};
use crate::parser::klartext::ast::Block;
use crate::sema::cycle::given::Given;
use crate::text::{Loc, Span, number::decimal};

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

/// `X+12`, `NUM4`: the name and where its value stands.
type Words = Vec<(String, f64)>;

/// A reading position in the text of the definition.
struct Scan<'t> {
    text: &'t [u8],
    at: usize,
}

impl Scan<'_> {
    /// Skips blanks, line ends, continuation marks and comments.
    fn blanks(&mut self) {
        while let Some(&byte) = self.text.get(self.at) {
            match byte {
                b';' => self.at += self.text[self.at..].iter().take_while(|b| **b != b'\n').count(),
                b'~' => self.at += 1,
                byte if byte.is_ascii_whitespace() || byte == 0 => self.at += 1,
                _ => break,
            }
        }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.blanks();
        let found = self.text.get(self.at) == Some(&byte);
        self.at += usize::from(found);
        found
    }

    fn letters(&mut self) -> String {
        self.blanks();
        let from = self.at;
        self.at += self.text[from..].iter().take_while(|b| b.is_ascii_alphabetic()).count();
        String::from_utf8_lossy(&self.text[from..self.at]).to_ascii_uppercase()
    }

    fn digits(&mut self) -> Option<u32> {
        let from = self.at;
        self.at += self.text[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        std::str::from_utf8(&self.text[from..self.at]).ok()?.parse().ok()
    }
}

impl Run<'_> {
    pub(super) fn pattern_def(&mut self, rest: Span, text: &[u8]) -> Outcome {
        self.places = None;
        let result = self.read_pattern(rest, text);
        self.places_lost = result.is_err();
        result
    }

    fn read_pattern(&mut self, rest: Span, text: &[u8]) -> Outcome {
        let loc = self.here.origin.loc;
        let mut scan = Scan { text, at: rest.start as usize };
        let mut list = Vec::new();
        loop {
            scan.blanks();
            if scan.at >= text.len() {
                break;
            }
            let from = scan.at;
            let name = scan.letters();
            let numbered = scan.digits().is_some();
            if !numbered || !scan.take(b'(') {
                return self.no_pattern(
                    from,
                    scan.at,
                    "POS1, ROW1, PAT1, FRAME1, CIRC1 or PITCHCIRC1 with its data in brackets belongs here",
                );
            }
            let words = self.pattern_words(&mut scan)?;
            let span = Span { start: from as u32, end: scan.at as u32 };
            self.add_places(&name, &words, span, &mut list)?;
            if list.len() > MOST {
                return self.no_pattern(from, scan.at, "the pattern has more than 99999 places");
            }
        }
        if list.is_empty() {
            return self.no_pattern(rest.start as usize, rest.start as usize, "PATTERN DEF names no place");
        }
        self.places = Some(Places { list, loc });
        Ok(())
    }

    fn no_pattern<T>(&self, from: usize, to: usize, what: &str) -> Outcome<T> {
        let span = if from < to { Span { start: from as u32, end: to as u32 } } else { self.block_span() };
        self.fail_help(codes::K2411, span, what, "write `PATTERN DEF POS1 (X+12 Y+20 Z+0) POS2 (X+30 Y+20 Z+0)`")
    }

    /// The words up to the closing bracket.
    fn pattern_words(&mut self, scan: &mut Scan<'_>) -> Outcome<Words> {
        let mut words = Words::new();
        while !scan.take(b')') {
            let from = scan.at;
            let name = scan.letters();
            // `XQ1`: the Q belongs to the value.
            let name = match name.strip_suffix('Q') {
                Some(front) if !front.is_empty() => {
                    scan.at -= 1;
                    front.to_owned()
                }
                _ => name,
            };
            let value = self.pattern_value(scan)?;
            let Some(value) = value.filter(|_| !name.is_empty()) else {
                return self.no_pattern(
                    from,
                    scan.at.max(from + 1).min(scan.text.len()),
                    "a word of the pattern cannot be read",
                );
            };
            if words.iter().any(|(other, _)| *other == name) {
                return self.no_pattern(from, scan.at, "a word stands twice in the brackets");
            }
            words.push((name, value));
        }
        Ok(words)
    }

    /// A number or a parameter, with a sign.
    fn pattern_value(&mut self, scan: &mut Scan<'_>) -> Outcome<Option<f64>> {
        let negative = scan.take(b'-');
        if !negative {
            scan.take(b'+');
        }
        scan.blanks();
        let sign = if negative { -1.0 } else { 1.0 };
        if scan.text.get(scan.at).is_some_and(|b| b.eq_ignore_ascii_case(&b'Q')) {
            scan.at += 1;
            let kind = match scan.text.get(scan.at).map(u8::to_ascii_uppercase) {
                Some(b'L') => QKind::Ql,
                Some(b'R') => QKind::Qr,
                _ => QKind::Q,
            };
            scan.at += usize::from(kind != QKind::Q);
            let Some(number) = scan.digits() else { return Ok(None) };
            let value = self.parameter(QRef { kind, number }, self.block_span())?;
            return Ok(Some(sign * value));
        }
        let rest = scan.text.get(scan.at..).unwrap_or_default();
        let Some((value, len)) = decimal(rest, true) else { return Ok(None) };
        scan.at += len;
        Ok(Some(sign * value))
    }

    /// The places of one element.
    fn add_places(&mut self, name: &str, words: &Words, span: Span, list: &mut Vec<Place>) -> Outcome {
        let mm = self.level().frame.unit.mm();
        let (first, second, third) = self.st.plane().axes();
        let letter = |axis: usize| crate::machine::Axis::ALL[axis].letter().to_string();
        let (u, v, w) = (letter(first), letter(second), letter(third));
        let of = |name: &str| words.iter().find(|(found, _)| found == name).map(|(_, value)| *value);
        let (Some(x), Some(y)) = (of(&u), of(&v)) else {
            return self.no_pattern(
                span.start as usize,
                span.end as usize,
                &format!("{name} needs {u} and {v} as absolute values"),
            );
        };
        let known: &[&str] = match name {
            "POS" => &[],
            "ROW" => &["D", "NUM", "ROT"],
            "PAT" | "FRAME" => &["DX", "DY", "NUMX", "NUMY", "ROT", "ROTX", "ROTY"],
            "CIRC" => &["D", "START", "NUM"],
            "PITCHCIRC" => &["D", "START", "STEP", "END", "NUM"],
            _ => return self.no_pattern(span.start as usize, span.end as usize, &format!("{name} is no pattern")),
        };
        for (word, _) in words {
            if ![&u, &v, &w].contains(&word) && !known.contains(&word.as_str()) {
                let what = format!("`{word}` has no place in {name}");
                return self.no_pattern(span.start as usize, span.end as usize, &what);
            }
        }
        if of("STEP").is_some() && of("END").is_some() {
            let what = format!("{name} has STEP and END, and each says where the last place lies");
            return self.no_pattern(span.start as usize, span.end as usize, &what);
        }
        if matches!(name, "CIRC" | "PITCHCIRC") && of("D").is_some_and(|size| size < 0.0) {
            let what = format!("the diameter D of {name} is below zero");
            return self.no_pattern(span.start as usize, span.end as usize, &what);
        }
        let surface = of(&w).unwrap_or(0.0) * mm;
        let at = Point2::new(x * mm, y * mm);
        let mut missing = None;
        let mut need = |name: &'static str| match of(name) {
            Some(value) => value,
            None => {
                missing.get_or_insert(name);
                0.0
            }
        };
        let offsets: Vec<Vec2> = match name {
            "POS" => vec![Vec2::zeros()],
            "ROW" => {
                let (step, count) = (need("D") * mm, need("NUM"));
                let along = Deg(of("ROT").unwrap_or(0.0)).unit();
                numbers(count).map(|k| along * (k * step)).collect()
            }
            "CIRC" => {
                let (radius, start, count) = (need("D") * mm / 2.0, need("START"), need("NUM"));
                numbers(count).map(|k| Deg(start + k * 360.0 / count).unit() * radius).collect()
            }
            "PITCHCIRC" => {
                let (radius, start, count) = (need("D") * mm / 2.0, need("START"), need("NUM"));
                let step = match (of("STEP"), of("END")) {
                    (Some(step), None) => step,
                    (None, Some(end)) if count > 1.0 => (end - start) / (count - 1.0),
                    (None, Some(_)) => 0.0,
                    _ => need("STEP"),
                };
                numbers(count).map(|k| Deg(start + k * step).unit() * radius).collect()
            }
            _ => {
                let (dx, dy) = (need("DX") * mm, need("DY") * mm);
                let (columns, lines) = (need("NUMX"), need("NUMY"));
                let (turn, turn_x, turn_y) =
                    (of("ROT").unwrap_or(0.0), of("ROTX").unwrap_or(0.0), of("ROTY").unwrap_or(0.0));
                let (along, beside) = (Deg(turn + turn_x).unit() * dx, Deg(turn + 90.0 + turn_y).unit() * dy);
                grid(columns, lines, name == "FRAME").map(|(i, j)| along * i + beside * j).collect()
            }
        };
        if let Some(missing) = missing {
            return self.no_pattern(span.start as usize, span.end as usize, &format!("{name} lacks {missing}"));
        }
        if offsets.is_empty() {
            return self.no_pattern(
                span.start as usize,
                span.end as usize,
                &format!("{name} has no usable number of places"),
            );
        }
        if matches!(name, "PAT" | "FRAME") {
            self.job.diags.push_once(codes::K2410::places_of_are_visited_line_by_line(&name).at(self.loc(span)));
        }
        self.warn_of_repeated_places(name, offsets.iter().map(|offset| at + *offset), self.loc(span));
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
            return self.refuse(self.block_span(), codes::K9010::cycl_call_pat_runs_over_pattern());
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
            self.report(
                codes::K8105::cycl_call_pat_runs_cycle_nowhere()
                    .at(self.here.origin.loc)
                    .also(places.loc, "it is selected here"),
            );
        }
        self.same_unit(&cycle)?;
        let given = self.checked(&cycle)?;
        let own = given.length(SURFACE);
        if own != 0.0 && places.list.iter().any(|place| place.surface != 0.0) {
            self.report(
                codes::K2411::places_have_surface_z_of_their_own()
                    .at(self.here.origin.loc)
                    .also(places.loc, "the pattern")
                    .also(cycle.loc, "the cycle"),
            );
            return Err(Reported);
        }
        self.budget.take(places.list.len() as u64 / PLACES_A_STEP);
        self.m_at_start(w, true)?;
        let feed = self.pattern_feed(w, "CYCL CALL PAT")?;
        let height = self.position_of(self.st.axis(), self.block_span(), "CYCL CALL PAT")?;
        if old {
            self.old_cycle_starts(&cycle, &given, (places, height))?;
            return self.run_old_pattern(w, (&cycle, &given), places, feed);
        }
        for (i, place) in places.list.iter().enumerate() {
            self.goes_on()?;
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
                Some(high) => Some(format!(
                    "cycle {} at a place of CLEARANCE {high} mm: how it comes down from there to its set-up clearance is open",
                    cycle.number
                )),
                None if (height - start).abs() > SAME_HEIGHT => Some(format!(
                    "cycle {} starts where the tool stands, at {height} mm, and the set-up clearance {clearance} mm above the Z of the place is {start} mm: which of the two counts is open",
                    cycle.number
                )),
                None => None,
            }
        });
        let Some(message) = wrong else { return Ok(()) };
        self.report(
            Diagnostic::new(codes::P9010, self.here.origin.loc, message)
                .also(places.loc, "the pattern")
                .also(cycle.loc, "the cycle")
                .help("move to the set-up clearance above the places in front of CYCL CALL PAT, or give the places by cycle 220 or 221"),
        );
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
            self.goes_on()?;
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
