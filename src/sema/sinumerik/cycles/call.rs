//! A cycle that is called: its arguments are read, checked and carried out here.

use std::cell::RefCell;
use std::ops::{Deref, DerefMut};

use crate::diag::{Code, Diagnostic, Fault, codes};

use super::super::{Channel, Outcome};
use super::arguments::Arguments;

/// A call of a cycle, and the channel whose modal state its arguments count under.
pub(in super::super) struct CycleCall<'c, 'a> {
    channel: &'c mut Channel<'a>,
    pub args: &'c Arguments,
    remarks: RefCell<Remarks>,
}

/// What is said of a call once it is carried out: one note of each kind.
#[derive(Debug, Default)]
struct Remarks {
    /// What the call leaves open, and what to do.
    open: Vec<(String, String)>,
    /// Readings and ways of our own.
    ways: Vec<String>,
}

impl<'a> Channel<'a> {
    pub(super) fn cycle<'c>(&'c mut self, args: &'c Arguments) -> CycleCall<'c, 'a> {
        CycleCall { channel: self, args, remarks: RefCell::default() }
    }
}

impl CycleCall<'_, '_> {
    /// The call leaves something open that the control takes from elsewhere; said by [`CycleCall::say_remarks`].
    pub(super) fn leaves_open(&self, fault: Fault) {
        let help = fault.help.map(|help| help.text).unwrap_or_default();
        self.remarks.borrow_mut().open.push((fault.message, help));
    }

    /// A reading of the manuals or a path of our own; said by [`CycleCall::say_remarks`].
    pub(super) fn own_way(&self, fault: Fault) {
        let ways = &mut self.remarks.borrow_mut().ways;
        if !ways.contains(&fault.message) {
            ways.push(fault.message);
        }
    }

    /// Says what was remarked, unless another call was said to be the same.
    pub(super) fn say_remarks(&self) {
        let Remarks { open, ways } = self.remarks.take();
        let (what, help): (Vec<String>, Vec<String>) = open.into_iter().unzip();
        self.remark(codes::S8230, &what, &help.join("; "));
        self.remark(codes::P8101, &ways, "docs/cycles.md describes the path; compare with what the machine does");
    }

    /// Tool and edge whose data the cycle works with.
    pub(super) fn active_edge(&self) -> Outcome<(u32, u32)> {
        let (args, tool) = (self.args, &self.st.tool);
        let Some(number) = tool.active().filter(|number| *number != 0) else {
            let change = if self.st.machine.lathe { "T1 D1" } else { "T1 M6" };
            return self.refuse_cycle(args.span, codes::P2090::no_tool_is_active(&change));
        };
        if tool.is_without_offset() {
            return self.refuse_cycle(args.span, codes::P2090::no_tool_offset_is_active());
        }
        self.edge_is_as_selected(number, tool.edge_or_first(), args.span)?;
        Ok((number, tool.edge_or_first()))
    }

    fn remark(&self, code: &'static Code, what: &[String], help: &str) {
        let message = format!("{}: {}", self.args.name(), what.join("; "));
        if !what.is_empty() && self.job.diags.first_text(code, &message) {
            self.report(Diagnostic::new(code, self.loc(self.args.span), message).help(help));
        }
    }
}

impl<'a> Deref for CycleCall<'_, 'a> {
    type Target = Channel<'a>;

    fn deref(&self) -> &Channel<'a> {
        self.channel
    }
}

impl<'a> DerefMut for CycleCall<'_, 'a> {
    fn deref_mut(&mut self) -> &mut Channel<'a> {
        self.channel
    }
}
