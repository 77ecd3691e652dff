//! Klartext blocks for rules on source text.

use crate::geo::Plane;
use crate::lexer::klartext::Value;
use crate::machine::Unit;
use crate::parser::klartext::ast::{Addr, Block, LabelRef, PathFn, Stmt, Test};
use crate::parser::symbols::Symbols;
use crate::sema::Job;
use crate::sema::run::survey::{Item, Notes, Visitor, What};
use crate::sema::run::unexecuted::Passed;
use crate::sema::run::{Shown, Shows, survey_file};
use crate::text::{FileId, Span};

use super::Klartext;
use super::labels::Label;

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    survey_file::<Klartext>(job, file, visitor);
}

impl Shows for Klartext {
    type Before = Shape;

    fn show(passed: &Passed<'_, Klartext>, _: &Symbols, shape: &mut Shape, items: bool, notes: &mut Notes) -> Shown {
        let (block, text) = (passed.block, passed.text);
        if let Some(comment) = block.comment {
            if passed.site.lines == 1 || comment.start <= block.span.start {
                notes.comments.push(comment);
            } else {
                notes.comments_of_lines(text);
            }
        }
        if items {
            if let Stmt::Begin { unit: Some(written), .. } = block.stmt {
                shape.unit = written;
            }
            note(block, text, notes);
            if block.stmt == Stmt::BlkForm {
                notes.items.extend(corner_of_blank(block, text, shape.unit.mm(), &mut shape.low));
            }
        }
        Shown {
            number: block.number,
            skip: block.skip,
            words: block.span,
            is_empty: block.stmt == Stmt::Empty,
            is_bad: block.stmt == Stmt::Bad,
        }
    }
}

/// What blocks in front say of lengths.
#[derive(Debug, Default)]
pub(super) struct Shape {
    unit: Unit,
    /// The low corner of the blank.
    low: Option<[f64; 3]>,
}

fn note(block: &Block, text: &[u8], notes: &mut Notes) {
    note_statement(block, text, notes);
    note_words(block, notes);
    parameters(block, text, notes);
}

/// Labels, calls, and where the program begins, ends and leaves its own text.
fn note_statement(block: &Block, text: &[u8], notes: &mut Notes) {
    let used = |label: LabelRef| Label::written(label, text).map_or(What::UsesUnknown, |l| What::Uses(l.to_string()));
    match block.stmt {
        // The end of a called section; what runs through it goes on behind it.
        Stmt::Label(LabelRef::Number(0)) => {}
        Stmt::Label(label) => {
            if let Some(label) = Label::written(label, text) {
                notes.add(What::Label(label.to_string()), block.span);
            }
        }
        Stmt::CallLabel { label, .. } => notes.add(used(label), block.span),
        Stmt::If { test, target, .. } => {
            notes.add(used(target), block.span);
            if always(test) {
                notes.add(What::Leaves, block.span);
            }
        }
        Stmt::CallProgram(_) | Stmt::SelectProgram(_) | Stmt::CallSelected => notes.add(What::Opaque, block.span),
        // A contour is called by its label; what other functions read is not known.
        Stmt::Cycle { number: 14, .. } | Stmt::FnOther { .. } | Stmt::Refused(..) | Stmt::Surface | Stmt::Iso => {
            notes.add(What::Opaque, block.span);
            notes.add(What::UsesUnknown, block.span);
        }
        Stmt::Begin { .. } => notes.add(What::Begins, block.span),
        Stmt::End { .. } => notes.add(What::Ends, block.span),
        Stmt::Pole => notes.add(What::Pole, block.span),
        Stmt::Path(PathFn::Circle | PathFn::LinePolar | PathFn::CirclePolar | PathFn::TangentPolar) => {
            notes.add(What::Polar, block.span);
        }
        // F of TOOL CALL is that of F AUTO.
        Stmt::ToolDef
        | Stmt::ToolCall
        | Stmt::Rounding
        | Stmt::Chamfer
        | Stmt::Approach
        | Stmt::Cycle { .. }
        | Stmt::CycleCall(_) => {
            notes.add(What::OwnValues, block.span);
        }
        _ => {}
    }
}

/// Feeds, speeds, coordinates and M functions that are numbers.
fn note_words(block: &Block, notes: &mut Notes) {
    for word in &block.words {
        if let (Stmt::ToolCall, Addr::Axis { axis, .. }) = (block.stmt, word.addr) {
            notes
                .items
                .extend(Plane::normal_to(axis.index()).map(|plane| Item { what: What::Plane(plane), span: word.span }));
        }
        let letter = match word.addr {
            Addr::Feed => b'F',
            Addr::Speed => b'S',
            Addr::Axis { axis, .. } => axis.letter() as u8,
            Addr::M(number) => {
                notes.word(b'M', f64::from(number), word.span);
                if matches!(number, 2 | 30) {
                    notes.add(What::Ends, word.span);
                }
                continue;
            }
            _ => continue,
        };
        if let Value::Number(value) = word.value {
            notes.word(letter, value, word.span);
        }
    }
}

/// `BLK FORM 0.1 Z X+0 Y+0 Z-20`, where all coordinates are numbers; increments of the high corner count from the `low` one.
fn corner_of_blank(block: &Block, text: &[u8], mm: f64, low: &mut Option<[f64; 3]>) -> Option<Item> {
    let high = match block.words.first()?.span.of(text) {
        b"0.1" | b"0,1" => false,
        b"0.2" | b"0,2" => true,
        _ => return None,
    };
    let mut at = [None; 3];
    for word in &block.words {
        if let (Addr::Axis { axis, incremental }, Value::Number(value)) = (word.addr, word.value)
            && axis.is_main()
        {
            let base = if incremental { low.filter(|_| high)?[axis.index()] } else { 0.0 };
            at[axis.index()] = Some(base + value * mm);
        }
    }
    let [Some(x), Some(y), Some(z)] = at else { return None };
    if !high {
        *low = Some([x, y, z]);
    }
    Some(Item { what: What::BlankCorner { high, at: [x, y, z] }, span: block.span })
}

/// A condition of numbers that holds in every run.
fn always(test: Test) -> bool {
    use crate::parser::klartext::ast::{Operand, Relation};
    let Test::Compare { relation, left: Operand::Number(left), right: Operand::Number(right) } = test else {
        return false;
    };
    match relation {
        Relation::Equal => left == right,
        Relation::NotEqual => left != right,
        Relation::Greater => left > right,
        Relation::Less => left < right,
    }
}

/// The parameters of a block as they are written: the target of an assignment is the first of them.
fn parameters(block: &Block, text: &[u8], notes: &mut Notes) {
    let writes = matches!(block.stmt, Stmt::Assign(_) | Stmt::AssignText(_) | Stmt::Fn { .. } | Stmt::SystemRead(_));
    let end = block.comment.map_or(text.len(), |comment| comment.start as usize).min(text.len());
    let code = if notes.comments.len() > 1 { text } else { &text[..end] };
    let mut first = true;
    let mut at = 0;
    while let Some(found) = memchr::memchr2(b'Q', b'q', &code[at..]) {
        let start = at + found;
        let mut to = start + 1;
        if code.get(to).is_some_and(|b| matches!(b.to_ascii_uppercase(), b'L' | b'R' | b'S')) {
            to += 1;
        }
        let digits = code[to..].iter().take_while(|b| b.is_ascii_digit()).count();
        at = to + digits;
        // `SEQ+` and the like are no parameters; behind the letter of a word one may stand.
        if digits == 0 {
            continue;
        }
        let name = String::from_utf8_lossy(&code[start..at]).to_ascii_uppercase();
        let given = code[at..].trim_ascii_start().first() == Some(&b'=');
        let span = Span { start: start as u32, end: at as u32 };
        if writes && first {
            notes.add(What::Writes(name), span);
        } else if !given {
            notes.add(What::Reads(name), span);
        }
        first = false;
    }
}
