//! Parameters: Q, QR and QS of the whole run; QL of each program.

use std::collections::BTreeMap;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::diag::codes;
use crate::lexer::klartext::{QKind, QRef};
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::{Core, Outcome};

/// A number or a text in UTF-8.
pub(super) type Val = crate::sema::value::Val;

/// What a parameter holds.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Slot {
    Number(f64),
    Text(Rc<[u8]>),
    /// Its computation failed and was reported.
    Lost,
    /// The control sets it at the machine, by the block at this place, which has no counterpart in the output.
    AtMachine(Loc),
}

/// Highest number of each kind, plus one.
const Q_COUNT: u32 = 2000;
const QL_COUNT: u32 = 500;

/// The parameters that every program sees.
#[derive(Debug, Clone, Default)]
pub(super) struct Vars {
    q: Vec<Option<Slot>>,
    qr: Vec<Option<Slot>>,
    qs: FxHashMap<u32, Slot>,
}

/// Parameters of one program level.
pub(super) type Locals = FxHashMap<u32, Slot>;

/// Does a control have this parameter?
pub(super) fn exists(q: QRef) -> bool {
    match q.kind {
        QKind::Q | QKind::Qs => q.number < Q_COUNT,
        QKind::Ql | QKind::Qr => q.number < QL_COUNT,
    }
}

impl Vars {
    /// Parameters with the start values of the configuration.
    pub fn new(start: &BTreeMap<String, f64>) -> (Vars, Locals) {
        let mut vars = Vars::default();
        let mut locals = Locals::default();
        for (name, &value) in start {
            if let Some(q) = named(name).filter(|q| exists(*q)) {
                vars.set(&mut locals, q, Slot::Number(value));
            }
        }
        (vars, locals)
    }

    pub fn get<'v>(&'v self, locals: &'v Locals, q: QRef) -> Option<&'v Slot> {
        match q.kind {
            QKind::Q => self.q.get(q.number as usize)?.as_ref(),
            QKind::Qr => self.qr.get(q.number as usize)?.as_ref(),
            QKind::Qs => self.qs.get(&q.number),
            QKind::Ql => locals.get(&q.number),
        }
    }

    /// Sets a parameter that [`exists`].
    pub fn set(&mut self, locals: &mut Locals, q: QRef, value: Slot) {
        let list = match q.kind {
            QKind::Q => &mut self.q,
            QKind::Qr => &mut self.qr,
            QKind::Qs => {
                self.qs.insert(q.number, value);
                return;
            }
            QKind::Ql => {
                locals.insert(q.number, value);
                return;
            }
        };
        let at = q.number as usize;
        if list.len() <= at {
            list.resize(at + 1, None);
        }
        list[at] = Some(value);
    }

    /// Sets a parameter by the block in hand.
    pub fn assign(&mut self, core: &mut Core<'_>, q: QRef, value: Slot, span: Span) -> Outcome {
        if !exists(q) {
            return core.refuse(span, codes::P2025::does_not_exist(&q));
        }
        if q.kind == QKind::Q && (100..200).contains(&q.number) {
            core.say(span, codes::K2305::belongs_to_control(&q));
        }
        if let Slot::Number(number) = value {
            let origin = core.here.origin;
            core.job.trail.assigns(origin.loc, origin.call, || q.to_string(), number);
        }
        self.put(core, q, value);
        Ok(())
    }

    /// The control, or an error, sets a parameter that [`exists`].
    pub fn put(&mut self, core: &mut Core<'_>, q: QRef, value: Slot) {
        if let Some(locals) = core.locals_mut() {
            self.set(locals, q, value);
        }
    }

    /// The block `text` would have set a parameter and was refused: its value is lost, not undefined.
    pub fn lose_target(&mut self, core: &mut Core<'_>, text: &[u8]) {
        if let Some(q) = assigned(text).filter(|q| exists(*q)) {
            self.put(core, q, Slot::Lost);
        }
    }

    /// FN 37: EXPORT copies a local parameter to the caller.
    pub fn export(&self, core: &mut Core<'_>, number: u32) -> Outcome {
        let q = QRef { kind: QKind::Ql, number };
        let Some(value) = self.get(core.locals(), q).cloned() else {
            return core.refuse(Where::Block, codes::P2020::has_no_value_to_export(&q));
        };
        if let Some(locals) = core.locals_of_caller() {
            locals.insert(number, value);
        }
        Ok(())
    }
}

/// `Q5`, `QL5`, `QR5`, `QS5`
pub(super) fn named(name: &str) -> Option<QRef> {
    let rest = name.strip_prefix('Q')?;
    let (kind, digits) = match rest.chars().next()? {
        'L' => (QKind::Ql, &rest[1..]),
        'R' => (QKind::Qr, &rest[1..]),
        'S' => (QKind::Qs, &rest[1..]),
        _ => (QKind::Q, rest),
    };
    Some(QRef { kind, number: digits.parse().ok()? })
}

/// The parameter in front of the first `=`: `Q1 = …`, `FN 1: Q1 = …`, `TABREAD Q10 = …`.
fn assigned(text: &[u8]) -> Option<QRef> {
    let front = text.split(|b| *b == b'=').next().filter(|front| front.len() < text.len())?;
    let word = front.trim_ascii_end().rsplit(|b| b.is_ascii_whitespace() || *b == b':').next()?;
    named(std::str::from_utf8(&word.to_ascii_uppercase()).ok()?)
}
