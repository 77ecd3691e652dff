//! A cycle that is called: its arguments are read, checked and carried out here.

use std::ops::{Deref, DerefMut};

use super::super::Channel;
use super::arguments::Arguments;

/// A call of a cycle, and the channel whose modal state its arguments count under.
pub(in super::super) struct CycleCall<'c, 'a> {
    channel: &'c mut Channel<'a>,
    pub args: &'c Arguments,
}

impl<'a> Channel<'a> {
    pub(super) fn cycle<'c>(&'c mut self, args: &'c Arguments) -> CycleCall<'c, 'a> {
        CycleCall { channel: self, args }
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
