//! The words of FL, FLT, FC and FCT.

use crate::diag::{Label, codes};
use crate::geo::open::window::{Base, EndAngle, Given, Item, Serial, Shape};
use crate::geo::{Plane, Point2, Vec2};
use crate::machine::Axis;
use crate::parser::klartext::ast::{Addr, Block, FkHead, Word};
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Where;
use crate::text::Span;

use super::super::reading::Reading;
use super::super::words::{Admits, Words};
use super::super::{Core, Outcome};
use super::Free;

/// A coordinate that a word says, or that another word refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    First,
    Second,
    Radius,
    Angle,
}

/// A word that only free contours have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Key {
    /// AN, IAN
    Direction { incremental: bool },
    /// LEN
    Length,
    /// CCA
    EndAngle,
    /// CCX, ICCPR, …
    Center { part: Part, incremental: bool },
    /// P1X: the point and its coordinate.
    Through(usize, Part),
    /// PDX
    Beside(Part),
    /// D
    Distance,
    /// PAR
    Parallel,
    /// DP
    ParallelDistance,
    /// RX, RPA: the block that the end counts from.
    EndFrom(Part),
    /// RCCX
    CenterFrom(Part),
    /// RAN
    DirectionFrom,
    /// CLSD+ (true), CLSD-
    Closed(bool),
}

/// A word with what it says.
#[derive(Debug, Clone, Copy)]
struct Said {
    key: Key,
    value: f64,
    span: Span,
}

/// The words of a block, but for those of every path block.
#[derive(Debug, Default)]
pub(super) struct Data {
    list: Vec<Said>,
}

pub(super) fn name(head: FkHead) -> &'static str {
    match head {
        FkHead::Pole => "FPOL",
        FkHead::Select => "FSELECT",
        FkHead::Line { smooth: false } => "FL",
        FkHead::Line { smooth: true } => "FLT",
        FkHead::Arc { smooth: false } => "FC",
        FkHead::Arc { smooth: true } => "FCT",
    }
}

/// The key that a word is, `None` for one that other blocks have as well or that nobody knows.
fn key(text: &[u8], letters: [char; 2]) -> Option<Key> {
    let upper = text.to_ascii_uppercase();
    let part = |rest: &[u8]| match rest {
        b"PR" => Some(Part::Radius),
        b"PA" => Some(Part::Angle),
        [letter] if char::from(*letter) == letters[0] => Some(Part::First),
        [letter] if char::from(*letter) == letters[1] => Some(Part::Second),
        _ => None,
    };
    let axis = |rest: &[u8]| part(rest).filter(|part| matches!(part, Part::First | Part::Second));
    Some(match upper.as_slice() {
        b"AN" => Key::Direction { incremental: false },
        b"IAN" => Key::Direction { incremental: true },
        b"LEN" => Key::Length,
        b"CCA" => Key::EndAngle,
        b"D" => Key::Distance,
        b"PAR" => Key::Parallel,
        b"DP" => Key::ParallelDistance,
        b"RAN" => Key::DirectionFrom,
        [b'C', b'L', b'S', b'D', .., b'+'] => Key::Closed(true),
        [b'C', b'L', b'S', b'D', .., b'-'] => Key::Closed(false),
        [b'R', b'C', b'C', rest @ ..] => Key::CenterFrom(part(rest)?),
        [b'I', b'C', b'C', rest @ ..] => Key::Center { part: part(rest)?, incremental: true },
        [b'C', b'C', rest @ ..] => Key::Center { part: part(rest)?, incremental: false },
        [b'P', b'D', rest @ ..] => Key::Beside(axis(rest)?),
        [b'P', point @ b'1'..=b'3', rest @ ..] => Key::Through(usize::from(*point - b'1'), axis(rest)?),
        [b'R', rest @ ..] => Key::EndFrom(part(rest)?),
        _ => return None,
    })
}

impl Key {
    /// Do lines have it?
    fn is_of_lines(self) -> bool {
        !matches!(self, Key::EndAngle | Key::Center { .. } | Key::CenterFrom(_) | Key::Through(2, _))
    }

    /// Do arcs have it?
    fn is_of_arcs(self) -> bool {
        !matches!(self, Key::Parallel | Key::ParallelDistance)
    }

    /// Is its value the number of a block?
    fn is_reference(self) -> bool {
        matches!(self, Key::Parallel | Key::EndFrom(_) | Key::CenterFrom(_) | Key::DirectionFrom)
    }

    /// Is its value a length?
    fn is_length(self) -> bool {
        match self {
            Key::Length | Key::Through(..) | Key::Beside(_) | Key::Distance | Key::ParallelDistance => true,
            Key::Center { part, .. } => part != Part::Angle,
            _ => false,
        }
    }
}

impl Data {
    fn get(&self, wanted: Key) -> Option<&Said> {
        self.list.iter().find(|said| said.key == wanted)
    }

    fn value(&self, wanted: Key) -> Option<f64> {
        self.get(wanted).map(|said| said.value)
    }
}

/// The words that every path block has, as far as an element takes them.
pub(super) fn admits(head: FkHead) -> Admits {
    let admits = Admits::PATH.and(Admits::POLAR);
    if matches!(head, FkHead::Line { .. }) { admits } else { admits.and(Admits::RADIUS).and(Admits::TURN) }
}

/// Takes the words of free contours out of the block.
pub(super) fn keys(
    reading: Reading<'_, '_>,
    letters: [char; 2],
    head: FkHead,
    block: &Block,
    text: &[u8],
) -> Outcome<(Block, Data)> {
    let (core, mm) = (reading.core, reading.core.mm());
    let is_line = matches!(head, FkHead::Line { .. });
    let (mut rest, mut said) = (block.clone(), Data::default());
    rest.words.clear();
    let mut words = block.words.iter();
    while let Some(&word) = words.next() {
        let found = if word.addr == Addr::Name { key(word.span.of(text), letters) } else { None };
        let Some(found) = found else {
            rest.words.push(word);
            continue;
        };
        if !(if is_line { found.is_of_lines() } else { found.is_of_arcs() }) {
            return core.not_admitted(word, name(head));
        }
        if said.get(found).is_some() {
            return core.refuse(word.span, codes::P1002::repeats_word_of_this_block(&core.word_text(word.span)));
        }
        let (mut value, mut span) = (0.0, word.span);
        if !matches!(found, Key::Closed(_)) {
            let Some(behind @ Word { addr: Addr::Value, .. }) = words.next() else {
                return core.refuse(word.span, codes::P1004::lacks_its_value(&core.word_text(word.span)));
            };
            span = word.span.to(behind.span);
            value = reading.number(behind.value, behind.span)? * if found.is_length() { mm } else { 1.0 };
        }
        said.list.push(Said { key: found, value, span });
    }
    Ok((rest, said))
}

/// What an element is described by, besides its words.
pub(super) struct Elements<'e, 'a> {
    pub core: &'e Core<'a>,
    pub plane: Plane,
    pub letters: [char; 2],
    /// In which the element before ends.
    pub direction: Option<Vec2>,
}

impl Elements<'_, '_> {
    /// What the block says of its element.
    pub(super) fn item(&self, free: &mut Free, head: FkHead, w: &Words, said: &Data) -> Outcome<Item> {
        let plane = self.plane;
        if !w.axes.known().without(plane_axes(plane)).is_empty() {
            return self.core.refuse(w.axes_span, codes::P1003::moves_in_working_plane(&name(head)));
        }
        let (shape, smooth) = match head {
            FkHead::Arc { smooth } => (Shape::Arc(w.turn), smooth),
            FkHead::Line { smooth } => (Shape::Line, smooth),
            FkHead::Pole | FkHead::Select => (Shape::Line, false),
        };
        let mut item = Item { shape, smooth, ..Item::default() };
        self.sizes(&mut item, w, said)?;
        self.end_of_element(&mut item, free, w, said)?;
        self.center_of_element(&mut item, free, said)?;
        self.direction_of_element(&mut item, free, said)?;
        self.points(&mut item, said)?;
        self.closing(&mut item, free, said)?;
        let polar = [item.end.radius, item.end.angle, item.center.radius, item.center.angle];
        match free.pole {
            Some(pole) => item.pole = pole,
            None if polar.iter().any(Option::is_some) => {
                return self.core.refuse(Where::Block, codes::K2101::polar_words_of_need_pole_of_free(&name(head)));
            }
            None => {}
        }
        Ok(item)
    }

    /// R, LEN, CCA, D and DP.
    fn sizes(&self, item: &mut Item, w: &Words, said: &Data) -> Outcome {
        item.length = said.value(Key::Length);
        item.radius = w.radius;
        let radius = w.radius.map(|radius| (radius, w.radius_span));
        let other = |key| said.get(key).map(|said| (said.value, said.span));
        for (value, span) in [radius, other(Key::Length)].into_iter().flatten() {
            if value <= 0.0 {
                return self.wrong(span, "is not above zero");
            }
        }
        for (value, span) in [other(Key::Distance), other(Key::ParallelDistance)].into_iter().flatten() {
            if value < 0.0 {
                return self.wrong(span, "is below zero");
            }
        }
        let Some(angle) = said.get(Key::EndAngle) else { return Ok(()) };
        let swept = self.core.job.settings.control.klartext_choices.fk_cca_swept == Some(true);
        if swept && !(angle.value > 0.0 && angle.value <= 360.0) {
            return self.wrong(angle.span, "is no angle that an arc sweeps");
        }
        item.end_angle = Some(if swept { EndAngle::Swept(angle.value) } else { EndAngle::At(angle.value) });
        Ok(())
    }

    fn wrong<T>(&self, span: Span, what: &str) -> Outcome<T> {
        let text = self.core.word_text(span);
        self.core.refuse(span, codes::P1004::word_lacks(&text, &what))
    }

    fn end_of_element(&self, item: &mut Item, free: &Free, w: &Words, said: &Data) -> Outcome {
        let (first, second, _) = self.plane.axes();
        let axis = |index: usize| {
            let axis = Axis::ALL[index];
            w.axes.get(axis).map(|value| (value, w.incremental.contains(axis)))
        };
        let written = [
            (Part::First, axis(first)),
            (Part::Second, axis(second)),
            (Part::Radius, w.polar_radius),
            (Part::Angle, w.polar_angle),
        ];
        for (part, value) in written {
            let from = said.get(Key::EndFrom(part));
            let given = self.given(free, value, from, false)?;
            match part {
                Part::First => item.end.x = given,
                Part::Second => item.end.y = given,
                Part::Radius => item.end.radius = given,
                Part::Angle => item.end.angle = given,
            }
        }
        Ok(())
    }

    fn center_of_element(&self, item: &mut Item, free: &Free, said: &Data) -> Outcome {
        for part in [Part::First, Part::Second, Part::Radius, Part::Angle] {
            let absolute = said.get(Key::Center { part, incremental: false });
            let incremental = said.get(Key::Center { part, incremental: true });
            let value = self.one_of(absolute, incremental)?;
            let from = said.get(Key::CenterFrom(part));
            let given = self.given(free, value, from, true)?;
            if let (Some(Given { from: Base::Start, .. }), Some(said)) = (given, incremental) {
                self.unconfirmed(said.span, "counts from the start of the arc", "name the block that it counts from");
            }
            match part {
                Part::First => item.center.x = given,
                Part::Second => item.center.y = given,
                Part::Radius => item.center.radius = given,
                Part::Angle => item.center.angle = given,
            }
        }
        Ok(())
    }

    /// A value that two words may give; true for the incremental one.
    fn one_of(&self, absolute: Option<&Said>, incremental: Option<&Said>) -> Outcome<Option<(f64, bool)>> {
        if let (Some(_), Some(twice)) = (absolute, incremental) {
            return self.wrong(twice.span, "says again what another word of the block says");
        }
        Ok(absolute.map(|said| (said.value, false)).or(incremental.map(|said| (said.value, true))))
    }

    fn direction_of_element(&self, item: &mut Item, free: &Free, said: &Data) -> Outcome {
        let absolute = said.get(Key::Direction { incremental: false });
        let incremental = said.get(Key::Direction { incremental: true });
        let value = self.one_of(absolute, incremental)?;
        item.angle = self.given(free, value, said.get(Key::DirectionFrom), false)?;
        if (item.smooth || incremental.is_some_and(|_| said.get(Key::DirectionFrom).is_none()))
            && free.queue.is_empty()
            && self.direction.is_none()
        {
            let span = incremental.map_or(self.core.block_span(), |said| said.span);
            return self.core.refuse(span, codes::K3004::direction_of_element_before_is_not_known());
        }
        let apart = said.get(Key::ParallelDistance);
        match (said.get(Key::Parallel), apart) {
            (Some(of), _) => {
                let serial = self.referred(free, of)?;
                if free.window.is_arc(serial) {
                    self.unconfirmed(
                        of.span,
                        "refers to an arc, and takes the direction in which that ends",
                        "refer to a line, or write AN",
                    );
                }
                item.parallel = Some((serial, apart.map(|said| said.value)));
            }
            (None, Some(apart)) => return self.incomplete(apart.span, "PAR and the number of a block"),
            (None, None) => {}
        }
        Ok(())
    }

    /// P1 to P3 and PD.
    fn points(&self, item: &mut Item, said: &Data) -> Outcome {
        for point in 0..3 {
            let coordinate = |part| said.get(Key::Through(point, part));
            item.through[point] = match (coordinate(Part::First), coordinate(Part::Second)) {
                (Some(x), Some(y)) => Some(Point2::new(x.value, y.value)),
                (None, None) => None,
                (Some(alone), None) | (None, Some(alone)) => {
                    return self.incomplete(alone.span, "the other coordinate of the point");
                }
            };
        }
        let coordinate = |part| said.get(Key::Beside(part));
        match (coordinate(Part::First), coordinate(Part::Second), said.get(Key::Distance)) {
            (Some(x), Some(y), Some(apart)) => item.beside = Some((Point2::new(x.value, y.value), apart.value)),
            (None, None, None) => {}
            (x, y, apart) => {
                let span = x.or(y).or(apart).map_or(self.core.block_span(), |said| said.span);
                let [first, second] = self.letters;
                return self.incomplete(span, &format!("PD{first}, PD{second} and D together"));
            }
        }
        Ok(())
    }

    /// CLSD+ and CLSD-.
    fn closing(&self, item: &mut Item, free: &mut Free, said: &Data) -> Outcome {
        if let Some(ends) = said.get(Key::Closed(false)) {
            item.closes = free.closes.take().map(|(serial, _)| serial).filter(|serial| free.window.knows(*serial));
            if item.closes.is_none() {
                return self
                    .incomplete(ends.span, "a block with CLSD+ where the contour begins, at most 64 elements before");
            }
        }
        if let Some(begins) = said.get(Key::Closed(true)) {
            let loc = self.core.loc(begins.span);
            if let Some((_, open)) = free.closes.replace((free.window.next_serial(), loc)) {
                self.core.report(
                    codes::K8025::no_clsd_closes_contour_that_begins().at(open).also(loc, Label::AnotherBegins),
                );
            }
        }
        Ok(())
    }

    fn incomplete<T>(&self, span: Span, needs: &str) -> Outcome<T> {
        let text = self.core.word_text(span);
        self.core.refuse(span, codes::P1004::needs(&text, &needs))
    }

    /// A value, and what it counts from.
    fn given(
        &self,
        free: &Free,
        value: Option<(f64, bool)>,
        from: Option<&Said>,
        center: bool,
    ) -> Outcome<Option<Given>> {
        Ok(match (value, from) {
            (None, None) => None,
            (Some((value, false)), None) => Some(Given { value, from: Base::Zero }),
            (Some((value, true)), None) => Some(Given { value, from: Base::Start }),
            (Some((value, true)), Some(from)) => {
                let serial = self.referred(free, from)?;
                if center && free.window.is_arc(serial) {
                    self.unconfirmed(
                        from.span,
                        "refers to an arc, and counts from its centre",
                        "refer to a line, or write the centre without a reference",
                    );
                }
                Some(Given { value, from: Base::Element(serial) })
            }
            (Some((_, false)) | None, Some(from)) => {
                let text = self.core.word_text(from.span);
                return self.core.refuse(from.span, codes::K3004::belongs_to_incremental_word(&text));
            }
        })
    }

    /// The element of a block number.
    fn referred(&self, free: &Free, said: &Said) -> Outcome<Serial> {
        debug_assert!(said.key.is_reference(), "a block number");
        let number = Some(said.value).filter(|value| value.fract() == 0.0 && (0.0..1e6).contains(value));
        let text = self.core.word_text(said.span);
        if let Some(number) = number
            && free.is_twice(number as u32)
        {
            return self.core.refuse(said.span, codes::K3004::refers_to_one_of_several_blocks(&text));
        }
        if let Some(serial) = number.and_then(|number| free.serial_of(number as u32)) {
            return Ok(serial);
        }
        if free.has_no_numbers() {
            return self.core.refuse(said.span, codes::K3004::names_block_by_its_number(&text));
        }
        self.core.refuse(said.span, codes::K3004::refers_to_block_that_is_no_fl(&text))
    }

    fn unconfirmed(&self, span: Span, what: &str, help: &str) {
        let text = self.core.word_text(span);
        self.core.say(span, codes::K8024::no_manual_at_hand_says(&text, &what).help(help.to_owned()));
    }
}
