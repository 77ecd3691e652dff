//! Parameters: Q, QR and QS of the whole run; QL of each program.

use std::collections::BTreeMap;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::lexer::klartext::{QKind, QRef};
use crate::text::Loc;

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
            let Some((kind, digits)) = split(name) else { continue };
            let Ok(number) = digits.parse() else { continue };
            let q = QRef { kind, number };
            if exists(q) {
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
}

fn split(name: &str) -> Option<(QKind, &str)> {
    let rest = name.strip_prefix('Q')?;
    Some(match rest.chars().next()? {
        'L' => (QKind::Ql, &rest[1..]),
        'R' => (QKind::Qr, &rest[1..]),
        'S' => (QKind::Qs, &rest[1..]),
        _ => (QKind::Q, rest),
    })
}
