//! Cycles that no manual of the control has, and what `[programs]` says of them.
//!
//! Comes in: the definition, word by word. Goes out: nothing but what the entry says that the cycle leaves behind. The
//! name behind a number is decoration to the control; to partc, which does not know the cycle, a word with a value in it is
//! a word that is left out.

use crate::diag::{Answer, codes};
use crate::machine::{AxisSet, StandIn};
use crate::parser::klartext::ast::{Addr, Block};
use crate::sema::run::Where;
use crate::text::Span;

use super::cycle_definition::{Does, LeftWord, Open};
use super::cycles::{CycleKind, find};
use super::m_table;
use super::{Core, Outcome, Reported, Run};

impl Open {
    /// Keeps the words of a block that defines a cycle nobody knows.
    pub fn keep_left_words(&mut self, core: &Core<'_>, part: Option<u32>, block: &Block, text: &[u8]) {
        let mut left = Vec::new();
        if matches!(part, None | Some(0)) {
            words_of_name(core, block, text, &mut left);
        }
        for word in &block.words {
            let does = match word.addr {
                Addr::Assign(_) => continue,
                Addr::Axis { axis, .. } => Does::Moves(axis),
                Addr::AssignText(_) => Does::Acts,
                _ => Does::read(&core.word_text(word.span)).unwrap_or(Does::Nothing),
            };
            left.push(LeftWord { text: core.word_text(word.span), does, loc: core.loc(word.span) });
        }
        self.left.append(&mut left);
    }

    /// What is left out moves nothing, or the axes that the entry names.
    fn may_be_left_out(&self, core: &Core<'_>, name: &str, moved: AxisSet) -> Outcome {
        let doubtful = self.left.iter().find(|word| match word.does {
            Does::Nothing => false,
            Does::Moves(axis) => !moved.contains(axis),
            Does::Acts => true,
        });
        let Some(word) = doubtful else { return Ok(()) };
        let help = match word.does {
            Does::Moves(_) => "if the cycle moves nothing, take the word out; if it moves, program its moves as blocks",
            Does::Nothing | Does::Acts => "take the word out, and program what it does in a block of its own",
        };
        core.report(codes::P9010::is_to_be_left_out_as_cycle(&name, &word.text).at(word.loc).help(help));
        Err(Reported)
    }
}

/// Words with a value that stand in the name of the cycle.
fn words_of_name(core: &Core<'_>, block: &Block, text: &[u8], left: &mut Vec<LeftWord>) {
    let code = block.span.of(text);
    let first = block.words.first().map_or(code.len(), |word| (word.span.start - block.span.start) as usize);
    let end = code.iter().position(|b| matches!(b, b';' | b'~' | b'\n')).unwrap_or(code.len()).min(first);
    let digit = code.iter().position(u8::is_ascii_digit).unwrap_or(end);
    let mut at = code[digit..].iter().position(u8::is_ascii_whitespace).map_or(end, |len| digit + len);
    for word in code.get(at..end).unwrap_or_default().split(u8::is_ascii_whitespace) {
        let span = Span::at(block.span.start + at as u32, word.len() as u32);
        at += word.len() + 1;
        if let Some(does) = Does::read(&String::from_utf8_lossy(word)) {
            left.push(LeftWord { text: core.word_text(span), does, loc: core.loc(span) });
        }
    }
}

impl Run<'_> {
    /// A cycle that no manual of the control has: `[programs]` may say that it does nothing.
    pub(super) fn builders_cycle(&mut self, open: &Open) -> Outcome {
        let number = open.number;
        let name = format!("CYCL DEF {number}");
        if self.core.job.settings.programs.get(&name) == Some(&StandIn::Ignored) {
            let moved = self.core.job.settings.left_by(&name).lost;
            open.may_be_left_out(&self.core, &name, moved)?;
            let words: Vec<&str> = open.left.iter().map(|word| word.text.as_str()).collect();
            let fault = match words.as_slice() {
                [] => codes::P8105::is_left_out_as_programs_says(&name),
                words => codes::P8105::is_left_out_with_words(&name, &words.join(" ")),
            };
            self.core.say_once(Where::Block, fault);
            self.leave_axes(&name, "end the contour with R0 before it")?;
            return self.leave_technology(&name);
        }
        let fault = codes::P9010::cycle_is_not_known(&number, &name);
        self.core.refuse(Where::Block, fault.answer(Answer::key("programs", &name).one_of(&["{ ignore = true }"])))
    }
}

impl Core<'_> {
    /// Entries of `[programs]` that would make a cycle vanish that partc knows, and those that no block of this language reads.
    pub(super) fn refuse_entries_of_cycles(&self) {
        let programs = &self.job.settings.programs;
        let motion =
            |name: &str| self.job.settings.left_by(name).rapid.map(|_| "Klartext has no G0 and no G1 that holds on");
        let entries: Vec<(&str, &str)> = programs
            .iter()
            .filter(|(name, _)| is_of_klartext(name))
            .filter_map(|(name, stands)| Some((name.as_str(), vain(cycle_of(name), stands).or_else(|| motion(name))?)))
            .collect();
        let help = "take them out: only a program or a cycle of the machine builder, which no manual of the control has, can be \
                    left out: `\"CYCL DEF 392\" = { ignore = true }`; touch probe cycles are left out by the key `probing` of `[control]`";
        self.refuse_entries("[programs]", &entries, help);
        let changing = &self.job.settings.control.tool_change_m;
        let known: Vec<String> =
            changing.iter().filter(|m| m_table::entry(**m).is_some()).map(|m| format!("M{m}")).collect();
        let entries: Vec<(&str, &str)> = known.iter().map(|m| (m.as_str(), "a function of the control")).collect();
        let help = "take them out: only an M function of the machine builder can change the tool as M6 does";
        self.refuse_entries("[control] tool_change_m", &entries, help);
    }
}

/// What an entry names that may not vanish, or that no block reads.
fn vain(cycle: Option<u32>, stands: &StandIn) -> Option<&'static str> {
    let Some(number) = cycle else { return Some("which is no name of a cycle") };
    let row = find(number);
    if !matches!(row.nature, CycleKind::Unknown) {
        return Some(row.called());
    }
    (*stands != StandIn::Ignored).then_some("a cycle can be left out only, by `ignore`")
}

/// The number of `CYCL DEF 392`, written as the entry is looked for.
fn cycle_of(name: &str) -> Option<u32> {
    let digits = name.strip_prefix("CYCL DEF ")?;
    let number: u32 = digits.parse().ok()?;
    (number.to_string() == digits).then_some(number)
}

/// Is it meant for this language? No program of another one has a blank in its name, or the name of an M function.
fn is_of_klartext(name: &str) -> bool {
    let number = name.strip_prefix('M').unwrap_or_default();
    let function = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
    let program = name.ends_with(".H") || name.ends_with(".I");
    function || name.starts_with("CYCL ") || (!program && name.contains(|c: char| c.is_whitespace()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_entries() {
        assert_eq!(cycle_of("CYCL DEF 392"), Some(392));
        assert!(
            ["CYCL DEF", "CYCL DEF ", "CYCL  DEF 392", "CYCL DEF 0392", "CYCL DEF +1"]
                .iter()
                .all(|name| cycle_of(name).is_none())
        );
        assert!(["TCH PROBE 412", "M128", "CYCL DEF", "PLANE SPATIAL"].iter().all(|name| is_of_klartext(name)));
        assert!(!["TC", "CYCLE60", "M", "MYPROG", "HEAD CLEAN.H"].iter().any(|name| is_of_klartext(name)));
    }
}
