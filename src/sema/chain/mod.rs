//! Path elements with missing data, in any language: each is completed from its start, its own data and up to two
//! elements behind it.
//!
//! In: elements as programmed, each with what else is known of its block. Out: complete elements, in their order. Which of
//! several solutions is meant the language says.

use std::collections::VecDeque;

use crate::geo::Deg;
use crate::geo::open::{Data, Entry, Fault, Rules, Solution, Solutions, Start, solve};

#[cfg(test)]
mod tests;

/// Elements that may wait for each other.
const MOST: usize = 3;

/// How a language counts the angle of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Angles {
    /// From the positive first axis to the positive second; a line runs that way.
    FromPlus,
    /// From the negative first axis to the positive second; a line runs that way or against it.
    FromMinus,
}

impl Angles {
    /// The direction of an angle.
    pub fn entry(self, angle: Deg) -> Entry {
        match self {
            Angles::FromPlus => Entry::Along(angle.unit()),
            Angles::FromMinus => {
                let unit = angle.unit();
                Entry::Parallel(crate::geo::Vec2::new(-unit.x, unit.y))
            }
        }
    }
}

/// What a language knows of an element besides its geometry.
pub trait Choice {
    const RULES: Rules;

    /// The solution that is meant; `next` is the element behind.
    ///
    /// # Errors
    /// Why none is, or which cannot be told.
    fn choose(&self, start: &Start, next: Option<&Self>, among: &Solutions) -> Result<Solution, Fault>;
}

/// Elements that wait for each other.
#[derive(Debug)]
pub struct Chain<T> {
    queue: VecDeque<(Data, T)>,
}

impl<T> Default for Chain<T> {
    fn default() -> Chain<T> {
        Chain { queue: VecDeque::new() }
    }
}

impl<T: Choice> Chain<T> {
    pub fn is_empty(&self) -> bool {
        self.queue.is_empty()
    }

    pub fn clear(&mut self) {
        self.queue.clear();
    }

    pub fn push(&mut self, data: Data, tag: T) {
        self.queue.push_back((data, tag));
    }

    /// The first element, if it can be completed by now. `closed`: nothing more will come.
    ///
    /// # Errors
    /// The fault, and the element it is about.
    pub fn next(&mut self, start: &Start, closed: bool) -> Result<Option<(Solution, T)>, (Fault, T)> {
        let Some((data, tag)) = self.queue.front() else { return Ok(None) };
        let following = [self.queue.get(1), self.queue.get(2)];
        let next = following[0].map(|(_, tag)| tag);
        let result = solve(start, data, following.map(|element| element.map(|(data, _)| data)), &T::RULES)
            .and_then(|among| tag.choose(start, next, &among));
        if let Err(Fault::Open(_)) = result
            && !closed
            && self.queue.len() < MOST
        {
            return Ok(None);
        }
        let Some((_, tag)) = self.queue.pop_front() else { return Ok(None) };
        match result {
            Ok(solution) => Ok(Some((solution, tag))),
            Err(fault) => Err((fault, tag)),
        }
    }
}
