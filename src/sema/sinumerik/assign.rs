//! Assignments and declarations: DEF, SET and REP, macros, definition files.
//!
//! Source: reference sections 5.1 and 5.6.

use std::rc::Rc;

use crate::diag::{Diagnostic, codes};
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op, Stmt, Target, TypeName, Value, Variable, Word};
use crate::parser::sinumerik::{SPLIT, parse_block};
use crate::parser::symbols::Symbol;
use crate::sema::exec::open_cursor;
use crate::text::{Next, Request, Span};

use super::frames::Component;
use super::value::{MOST_TEXT, NoValue, Val, type_name, whole};
use super::vars::{MOST_ELEMENTS, MOST_R, Slot, Var};
use super::vocabulary::Meaning;
use super::{Outcome, Reported, Run};

/// Definition files that a control reads at power-on, if they stand beside the program.
const DEFINITION_FILES: &[&str] =
    &["SGUD", "MGUD", "UGUD", "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9", "SMAC", "MMAC", "UMAC"];
/// Longest text of a macro.
const MOST_MACRO: usize = 256;

impl Run<'_> {
    /// `target = formula`
    pub(super) fn assign_word(&mut self, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let result = self.assign(word, block, text);
        if result.is_err() {
            self.lose_target(word.target);
        }
        result
    }

    /// What could not be computed is not reported again by those that read it.
    fn lose_target(&mut self, target: Target) {
        match target {
            Target::Numbered(b'R', n, _) => self.vars.lose_r(n),
            Target::Numbered(_, _, name) | Target::Name(name) | Target::Indexed(Base::Name(name), _) => {
                if let Some(slot) = self.vars.find(name)
                    && let Some(var) = self.vars.get_mut(slot)
                {
                    var.lost = true;
                }
            }
            _ => {}
        }
    }

    fn assign(&mut self, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let Value::Formula(formula) = word.value else {
            return self.fail(codes::S1001, 12080, word.span, "`=` and a value are missing");
        };
        if let Target::Numbered(b'R', n, _) = word.target {
            let value = self.number(formula, block, text)?;
            return self.set_r(n, value, word.span);
        }
        // `A[0,1]=SET(7,8)` fills from an element on.
        if let Some(values) = self.list_of(formula, block, text)? {
            return self.fill_target(word.target, &values, formula.span, block, text);
        }
        let value = self.eval(formula, block, text)?;
        self.write_target(word.target, value, word.span, block, text)
    }

    fn set_r(&mut self, n: u32, value: f64, span: Span) -> Outcome {
        if n > MOST_R {
            return self.fail(codes::S2018, 17020, span, format!("there is no parameter R{n}"));
        }
        self.vars.set_r(n, value);
        Ok(())
    }

    /// Reads a target, for counting loops.
    pub(super) fn read_target(&mut self, target: Target, block: &Block, text: &[u8]) -> Outcome<Val> {
        match target {
            Target::Numbered(b'R', n, _) => self.r_value(n, block.span),
            Target::Numbered(_, _, name) | Target::Name(name) => match self.vars.find(name) {
                Some(slot) => self.variable_value(slot, &[], block.span),
                None => self.undefined(name, block.span),
            },
            Target::Indexed(base, args) => {
                let mut values = Vec::new();
                for formula in block.arguments(args).to_vec() {
                    values.push(self.eval(formula, block, text)?);
                }
                match base {
                    Base::Letter(b'R') => {
                        let n = self.r_index(&values, block.span)?;
                        self.r_value(n, block.span)
                    }
                    Base::Name(name) => match self.vars.find(name) {
                        Some(slot) => {
                            let indices = self.indices(&values, block.span)?;
                            self.variable_value(slot, &indices, block.span)
                        }
                        None => self.undefined(name, block.span),
                    },
                    _ => self.fail(codes::S1001, 12080, block.span, "this cannot count a loop"),
                }
            }
            Target::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.variable_value(slot, &[], block.span),
                None => self.fail(codes::S1001, 12080, block.span, "an address cannot count a loop"),
            },
            Target::System(_) => self.fail(codes::S1001, 12080, block.span, "this cannot count a loop"),
        }
    }

    pub(super) fn write_target(
        &mut self,
        target: Target,
        value: Val,
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        match target {
            Target::Numbered(b'R', n, _) => {
                let value = self.as_number(&value, span)?;
                self.set_r(n, value, span)
            }
            Target::Numbered(_, _, name) | Target::Name(name) => {
                let Some(slot) = self.vars.find(name) else { return self.undefined(name, span) };
                self.write_element(slot, &[], value, span)
            }
            Target::System(name) => self.write_system(name, &[], value, span),
            Target::Indexed(base, args) => {
                let mut indices = Vec::new();
                for formula in block.arguments(args).to_vec() {
                    indices.push(self.eval(formula, block, text)?);
                }
                match base {
                    Base::Letter(b'R') => {
                        let n = self.r_index(&indices, span)?;
                        let value = self.as_number(&value, span)?;
                        self.set_r(n, value, span)
                    }
                    Base::System(name) => self.write_system(name, &indices, value, span),
                    Base::Name(name) => {
                        let Some(slot) = self.vars.find(name) else { return self.undefined(name, span) };
                        self.write_indexed(slot, &indices, value, span)
                    }
                    Base::Letter(_) => self.fail(codes::S1001, 12080, span, "this takes no value"),
                }
            }
            Target::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.write_element(slot, &[], value, span),
                None => self.fail(codes::S1001, 12080, span, "this takes no value"),
            },
        }
    }

    fn write_indexed(&mut self, slot: Slot, indices: &[Val], value: Val, span: Span) -> Outcome {
        if let Some(Val::Frame(frame)) = self.vars.get(slot).and_then(|var| var.values.first()).cloned() {
            let mut changed = (*frame).clone();
            self.set_frame_component(&mut changed, indices, &value, span)?;
            return self.write_element(slot, &[], Val::Frame(Rc::new(changed)), span);
        }
        let indices = self.indices(indices, span)?;
        // One character of a text.
        if let Some(var) = self.vars.get(slot)
            && let ([at], [], Some(Val::Text(old))) = (indices.as_slice(), var.sizes.as_slice(), var.values.first())
        {
            let character = self.converted(&value, TypeName::Char, span)?;
            let mut bytes = old.to_vec();
            let place = usize::try_from(*at).ok().and_then(|at| bytes.get_mut(at));
            let (Some(place), Val::Char(c)) = (place, character) else {
                return self.fail(codes::S2018, 12400, span, format!("the text has no character {at}"));
            };
            *place = c;
            return self.write_element(slot, &[], Val::text(&bytes), span);
        }
        self.write_element(slot, &indices, value, span)
    }

    fn write_element(&mut self, slot: Slot, indices: &[i32], value: Val, span: Span) -> Outcome {
        let Some(var) = self.vars.get(slot) else { return Err(Reported) };
        let (kind, length) = (var.kind, var.length);
        let Some(at) = var.offset(indices) else {
            let message = if var.sizes.is_empty() {
                "the variable is no array".to_owned()
            } else {
                format!("the array has the sizes {:?}, counted from 0; there is no element {indices:?}", var.sizes)
            };
            return self.fail(codes::S2018, 12400, span, message);
        };
        let value = self.converted(&value, kind, span)?;
        self.check_length(&value, length, span)?;
        if let Some(var) = self.vars.get_mut(slot)
            && let Some(element) = var.values.get_mut(at)
        {
            *element = value;
            var.lost = false;
            var.written = true;
        }
        Ok(())
    }

    fn check_length(&self, value: &Val, length: usize, span: Span) -> Outcome {
        match value {
            Val::Text(text) if text.len() > length => {
                let message = format!("the text has {} characters, the variable takes {length}", text.len());
                self.fail(codes::S2030, 12210, span, message)
            }
            _ => Ok(()),
        }
    }

    /// A value as one of another type.
    pub(super) fn converted(&self, value: &Val, kind: TypeName, span: Span) -> Outcome<Val> {
        match value.converted(kind) {
            Ok(value) => Ok(value),
            Err(NoValue::Type) => {
                let message = format!("{} does not become {}", value.what(), type_name(kind));
                self.fail(codes::S2005, 12150, span, message)
            }
            Err(NoValue::Range) => {
                let message = format!("the value lies outside what {} holds", type_name(kind));
                self.fail(codes::S2029, 12560, span, message)
            }
        }
    }

    // Lists of values.

    /// The values of `SET(…)`, `(…)` or `REP(…)`; `None` for anything else.
    fn list_of(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Option<Fill>> {
        match block.formula(formula) {
            [inner @ .., Op::List(_)] => {
                let inner = formula_part(formula, inner.len());
                self.list_values(inner, block, text).map(|list| Some(Fill::Set(list)))
            }
            [inner @ .., Op::Call(name, _, _)] => {
                let word = self.symbols.name(*name);
                if word != "SET" && word != "REP" {
                    return Ok(None);
                }
                let set = word == "SET";
                let inner = formula_part(formula, inner.len());
                let list = self.list_values(inner, block, text)?;
                if set {
                    return Ok(Some(Fill::Set(list)));
                }
                let count = match list.get(1) {
                    None => None,
                    Some(value) => {
                        let n = value.number().and_then(whole).and_then(|n| usize::try_from(n).ok());
                        match n {
                            Some(n) => Some(n),
                            None => {
                                return self.fail(
                                    codes::S2017,
                                    12260,
                                    formula.span,
                                    "REP counts elements by a whole number",
                                );
                            }
                        }
                    }
                };
                match list.into_iter().next() {
                    Some(value) => Ok(Some(Fill::Repeat(value, count))),
                    None => self.fail(codes::S2017, 12260, formula.span, "REP needs a value"),
                }
            }
            _ => Ok(None),
        }
    }

    /// Values that stand one behind the other: what is left on the stack.
    fn list_values(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Vec<Val>> {
        let ops = block.formula(formula);
        let count = depth(ops);
        let mut wrapped = Block { ops: ops.to_vec(), ..Block::default() };
        wrapped.ops.push(Op::List(count));
        let whole = Formula { from: 0, to: wrapped.ops.len() as u32, span: formula.span };
        match self.eval(whole, &wrapped, text)? {
            Val::List(list) => Ok(list.to_vec()),
            _ => Err(Reported),
        }
    }

    fn fill_target(&mut self, target: Target, fill: &Fill, span: Span, block: &Block, text: &[u8]) -> Outcome {
        let (name, indices) = match target {
            Target::Name(name) | Target::Numbered(_, _, name) => (name, Vec::new()),
            Target::Indexed(Base::Name(name), args) => {
                let mut values = Vec::new();
                for formula in block.arguments(args).to_vec() {
                    values.push(self.eval(formula, block, text)?);
                }
                (name, self.indices(&values, span)?)
            }
            _ => return self.fail(codes::S2005, 12150, span, "a list of values fills an array"),
        };
        let Some(slot) = self.vars.find(name) else { return self.undefined(name, span) };
        let Some(var) = self.vars.get(slot).cloned() else { return Err(Reported) };
        let start = if indices.is_empty() { Some(0) } else { var.offset(&indices) };
        let Some(start) = start.filter(|_| !var.sizes.is_empty()) else {
            return self.fail(codes::S2018, 12400, span, "the array has no such element");
        };
        let filled = self.filled(&var, start, fill, span)?;
        if let Some(var) = self.vars.get_mut(slot) {
            *var = filled;
        }
        Ok(())
    }

    fn filled(&self, var: &Var, start: usize, fill: &Fill, span: Span) -> Outcome<Var> {
        let mut made = var.clone();
        made.written = true;
        let room = made.values.len() - start.min(made.values.len());
        match fill {
            Fill::Set(list) => {
                if list.len() > room {
                    let message = format!("{} values for {room} elements", list.len());
                    return self.fail(codes::S2017, 12260, span, message);
                }
                for (at, value) in list.iter().enumerate().filter(|(_, value)| **value != Val::Missing) {
                    made.values[start + at] = self.converted(value, made.kind, span)?;
                }
            }
            Fill::Repeat(value, count) => {
                let value = self.converted(value, made.kind, span)?;
                let count = count.unwrap_or(room);
                if count > room {
                    return self.fail(codes::S2017, 12260, span, format!("{count} values for {room} elements"));
                }
                for element in made.values.iter_mut().skip(start).take(count) {
                    *element = value.clone();
                }
            }
        }
        Ok(made)
    }

    // Declarations.

    pub(super) fn def_block(
        &mut self,
        kind: TypeName,
        length: Option<Formula>,
        global: bool,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        if self.program_level().executed && !global {
            return self.fail_help(
                codes::S2015,
                14500,
                block.span,
                "DEF stands behind executed blocks",
                "move it to the top of the program",
            );
        }
        let length = match length {
            Some(formula) => {
                let n = self.number(formula, block, text)?;
                match whole(n).and_then(|n| usize::try_from(n).ok()).filter(|n| *n <= MOST_TEXT) {
                    Some(n) => n,
                    None => return self.fail(codes::S2030, 12210, formula.span, "a text has 0 to 400 characters"),
                }
            }
            None if kind == TypeName::String => 32,
            None => MOST_TEXT,
        };
        let mut result = Ok(());
        for variable in block.variables.clone() {
            if let Err(reported) = self.define(variable, kind, length, global, block, text) {
                result = Err(reported);
            }
        }
        result
    }

    fn define(
        &mut self,
        variable: Variable,
        kind: TypeName,
        length: usize,
        global: bool,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let Some(name) = variable.name else { return Ok(()) };
        let word = self.symbols.name(name).to_owned();
        let defined = self.loc(variable.span);
        if let Some(first) = self.vars.of_level(name).map(|var| var.defined).filter(|first| *first != defined) {
            let found = Diagnostic::new(codes::S2016, defined, format!("`{word}` is defined twice (alarm 12170)"));
            self.report(found.also(first, "the first definition").help("rename one of them"));
            return Err(Reported);
        }
        let taken = match self.meaning(name) {
            Meaning::Axis(axis) if self.st.geometry_axes.contains(&axis) => Some("a geometry axis"),
            Meaning::Code(_) => Some("a word of the language"),
            _ => None,
        };
        if let Some(what) = taken {
            let message = format!("`{word}` is {what} and cannot be a variable");
            return self.fail_help(codes::S2016, 12170, variable.span, message, "choose another name");
        }
        let mut sizes = Vec::new();
        for formula in block.arguments(variable.sizes).to_vec() {
            let n = self.number(formula, block, text)?;
            match whole(n).and_then(|n| u32::try_from(n).ok()).filter(|n| (1..=MOST_ELEMENTS).contains(n)) {
                Some(n) => sizes.push(n),
                None => {
                    return self.fail(
                        codes::S2018,
                        12430,
                        formula.span,
                        "an array has 1 to 32767 elements in a direction",
                    );
                }
            }
        }
        if sizes.len() > 3 {
            return self.fail(codes::S2018, 12190, variable.span, "an array has at most three directions");
        }
        let count = sizes.iter().map(|n| u64::from(*n)).product::<u64>();
        if count > u64::from(MOST_ELEMENTS) * 4 {
            return self.fail(codes::S2018, 12380, variable.span, format!("{count} elements are too many"));
        }
        // Making them is work.
        self.budget.take(count / 64);
        let values = vec![Val::zero(kind); count as usize];
        let mut var = Var { kind, sizes, values, length, defined, lost: false, written: false };
        if let Some(formula) = variable.value {
            if kind == TypeName::Frame {
                return self.fail(codes::S2017, 12261, formula.span, "a FRAME cannot be given a value by DEF");
            }
            var = self.started(var, formula, block, text)?;
        }
        if !self.vars.define(name, var, global) {
            return self.fail(codes::S2018, 12380, variable.span, "the variables of the program are too large");
        }
        Ok(())
    }

    fn started(&mut self, mut var: Var, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Var> {
        if let Some(fill) = self.list_of(formula, block, text)? {
            return self.filled(&var, 0, &fill, formula.span);
        }
        let value = self.eval(formula, block, text)?;
        let value = self.converted(&value, var.kind, formula.span)?;
        self.check_length(&value, var.length, formula.span)?;
        // A single value fills the first element.
        if let Some(first) = var.values.first_mut() {
            *first = value;
        }
        Ok(var)
    }

    // Macros.

    /// `NAME AS words`
    pub(super) fn define_macro(&mut self, rest: &[u8], span: Span) -> Outcome {
        let rest = rest.trim_ascii();
        let len = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        let (name, body) = rest.split_at(len);
        let body = body.trim_ascii_start();
        let keyword = body.get(..2).is_some_and(|word| word.eq_ignore_ascii_case(b"AS"));
        if len == 0 || !keyword {
            return self.fail_help(
                codes::S1001,
                12080,
                span,
                "a macro is written DEFINE NAME AS words",
                "DEFINE M_START AS M3 S1000",
            );
        }
        let body = body[2..].trim_ascii();
        if body.len() > MOST_MACRO {
            return self.fail(codes::S2030, 12280, span, "the text of a macro has at most 256 characters");
        }
        let symbol = self.symbols.intern(name);
        if let Some(message) = self.macro_in_use(symbol) {
            return self.fail_help(codes::S2016, 12270, span, message, "choose a name that means nothing yet");
        }
        if self.vars.find(symbol).is_some() {
            let message = format!("`{}` is a variable already", self.symbols.name(symbol));
            return self.fail(codes::S2016, 12270, span, message);
        }
        if self.macros.insert(symbol, body.into()).as_deref() != Some(body) {
            // Blocks that were read before may contain the name.
            for file in &mut self.programs.files {
                file.cache = Default::default();
            }
        }
        Ok(())
    }

    /// A macro must not give a word of the language another meaning.
    fn macro_in_use(&mut self, symbol: Symbol) -> Option<String> {
        let word = self.symbols.name(symbol).to_owned();
        let digits = word.get(1..).filter(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()));
        let taken = match (word.as_bytes().first(), digits) {
            (Some(b'G'), Some(digits)) => {
                digits.len() > 3 || digits.parse().ok().is_some_and(|n: f64| self.gcodes.get(n).is_some())
            }
            (Some(b'M'), Some(digits)) => {
                let number: Option<u32> = digits.parse().ok();
                digits.len() > 2 || number.is_some_and(|n| n <= 9 || n == 17 || n == 19 || n == 30)
            }
            (Some(b'H'), Some(_)) => false,
            (Some(_), Some(_)) => true,
            _ => word.len() == 1 || self.meaning(symbol) != Meaning::Unknown || is_keyword(&word),
        };
        taken.then(|| format!("`{word}` is a word of the language"))
    }

    /// The block with its macros replaced; `None` if it has none.
    pub(super) fn expanded(&mut self, text: &[u8]) -> Option<Vec<u8>> {
        let mut current = self.replaced(text)?;
        // Macros in macros, with an end to it.
        for _ in 0..8 {
            match self.replaced(&current) {
                Some(next) => current = next,
                None => break,
            }
        }
        Some(current)
    }

    fn replaced(&mut self, text: &[u8]) -> Option<Vec<u8>> {
        let end = crate::lexer::sinumerik::comment_start(text).unwrap_or(text.len());
        if text.get(..end)?.windows(6).any(|w| w.eq_ignore_ascii_case(b"DEFINE")) {
            return None;
        }
        let mut out = Vec::new();
        let mut any = false;
        let mut at = 0;
        while at < end {
            let byte = text[at];
            if byte == b'"' {
                let close = text[at + 1..end].iter().position(|b| *b == b'"').map_or(end, |n| at + n + 2);
                out.extend_from_slice(&text[at..close]);
                at = close;
                continue;
            }
            let len = text[at..end].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
            if len == 0 {
                out.push(byte);
                at += 1;
                continue;
            }
            let word = &text[at..at + len];
            let upper = word.to_ascii_uppercase();
            let known = std::str::from_utf8(&upper).ok().and_then(|name| self.symbols.find(name));
            match known.and_then(|symbol| self.macros.get(&symbol)) {
                Some(body) if out.len() + body.len() <= 4 * MOST_MACRO => {
                    out.extend_from_slice(body);
                    any = true;
                }
                _ => out.extend_from_slice(word),
            }
            at += len;
        }
        out.extend_from_slice(&text[end..]);
        any.then_some(out)
    }

    // Definition files.

    /// True if the definition files were read before; otherwise reads them now.
    pub(super) fn definitions_known(&mut self) -> bool {
        if std::mem::replace(&mut self.definitions_read, true) {
            return true;
        }
        let identity = self.job.sources.identity(self.job.main);
        let mut any = false;
        for name in DEFINITION_FILES {
            let request = Request { from: &identity, name, extensions: &["DEF"] };
            let Ok(opened) = self.job.files.open(&request) else { continue };
            let Some(file) = self.job.sources.add(opened) else { continue };
            any = true;
            self.read_definitions(file);
        }
        !any
    }

    fn read_definitions(&mut self, file: crate::text::FileId) {
        let Some(mut cursor) = open_cursor(&self.job, file, SPLIT, self.here.origin.loc) else { return };
        let here = self.here;
        let mut block = Block::default();
        while let Ok(Next::Block(found)) = cursor.next(self.job.sources) {
            let (at, line, text) = (found.at, found.line, found.text.to_vec());
            parse_block(&text, &mut block, &mut self.symbols, &mut self.problems);
            self.here = crate::sema::here::Here::new(file, at, line, 1, here.origin.call);
            self.here.origin.loc.span = block.span.shifted(at);
            self.report_problems();
            let _ = match block.stmt {
                Stmt::Def { kind, length, .. } => self.def_block(kind, length, true, &block, &text),
                Stmt::Define(span) => self.define_macro(span.of(&text), span),
                Stmt::Empty | Stmt::Header | Stmt::Bad | Stmt::Redef(_) | Stmt::Words => Ok(()),
                _ => self.fail(codes::S2013, 12500, block.span, "a definition file holds DEF and DEFINE only"),
            };
        }
        self.here = here;
    }

    /// A component of a frame: `[X,TR]`.
    pub(super) fn frame_place(&self, args: &[Val], span: Span) -> Outcome<(crate::machine::Axis, Component)> {
        let component = match args {
            [Val::Axis(axis), Val::Text(name)] => {
                std::str::from_utf8(name).ok().and_then(Component::of).map(|component| (*axis, component))
            }
            _ => None,
        };
        match component {
            Some(found) => Ok(found),
            None => self.fail_help(
                codes::S2031,
                12040,
                span,
                "a component of a frame is an axis and one of TR, FI, RT, SC, MI",
                "for example [X,TR]",
            ),
        }
    }

    pub(super) fn frame_component(&self, frame: &super::frames::FrameValue, args: &[Val], span: Span) -> Outcome<Val> {
        let (axis, component) = self.frame_place(args, span)?;
        match frame.component(axis, component) {
            Some(value) => Ok(Val::Real(value)),
            None => self.fail(codes::S2034, 0, span, "this chain of rotations and scales has no such components"),
        }
    }

    pub(super) fn set_frame_component(
        &self,
        frame: &mut super::frames::FrameValue,
        args: &[Val],
        value: &Val,
        span: Span,
    ) -> Outcome {
        let (axis, component) = self.frame_place(args, span)?;
        let value = self.as_number(value, span)?;
        if frame.set_component(axis, component, value) {
            return Ok(());
        }
        self.fail(codes::S2034, 0, span, "this component cannot be set: a chain of rotations and scales, or a factor 0")
    }

    pub(super) fn meaning(&mut self, name: Symbol) -> Meaning {
        let at = name.0 as usize;
        if let Some(Some(known)) = self.meanings.get(at) {
            return *known;
        }
        let word = self.symbols.name(name);
        let meaning = match super::eval::axis_of(word) {
            Some(axis) => Meaning::Axis(axis),
            None => self.vocabulary.get(word).copied().unwrap_or(Meaning::Unknown),
        };
        if self.meanings.len() <= at {
            self.meanings.resize(at + 1, None);
        }
        self.meanings[at] = Some(meaning);
        meaning
    }
}

/// Words of control structures and declarations.
fn is_keyword(word: &str) -> bool {
    const KEYWORDS: &str = "IF ELSE ENDIF WHILE ENDWHILE FOR TO ENDFOR LOOP ENDLOOP REPEAT REPEATB UNTIL GOTO GOTOF GOTOB GOTOC GOTOS \
        CASE OF DEFAULT DEF REDEF PROC EXTERN DEFINE VAR CALL PCALL MCALL EXTCALL ISOCALL BLOCK NOT AND OR XOR B_NOT B_AND B_OR B_XOR \
        DIV MOD TRUE FALSE INT REAL BOOL CHAR STRING AXIS FRAME SAVE";
    KEYWORDS.split_ascii_whitespace().any(|keyword| keyword == word)
}

/// What fills an array.
enum Fill {
    Set(Vec<Val>),
    Repeat(Val, Option<usize>),
}

fn formula_part(formula: Formula, len: usize) -> Formula {
    Formula { from: formula.from, to: formula.from + len as u32, span: formula.span }
}

/// How many values postfix operations leave.
fn depth(ops: &[Op]) -> u32 {
    let mut depth = 0u32;
    for op in ops {
        let used = match op {
            Op::Index(_, n, _) | Op::Call(_, n, _) | Op::List(n) => *n,
            Op::Unary(_) => 1,
            Op::Binary(_) => 2,
            _ => 0,
        };
        depth = (depth + 1).saturating_sub(used);
    }
    depth
}
