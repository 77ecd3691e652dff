//! Spindles: speed, sense of rotation, constant cutting speed.
//!
//! Source: reference section 2.15.

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::function::Spindle;
use crate::text::Span;

use super::words::SWord;
use super::{Outcome, Run};

/// Highest spindle number that is a spindle.
const MOST_SPINDLES: u8 = 20;

impl Run<'_> {
    pub(super) fn speed(&mut self, s: SWord, constant: bool) -> Outcome {
        if s.value > 1e6 {
            return self.fail(codes::S2045, 0, s.span, format!("the speed S{} is out of all range", s.value));
        }
        if s.value < 0.0 {
            let help = "the sense of rotation comes from M3 or M4";
            return self.fail_help(codes::S2045, 14840, s.span, format!("the speed S{} is negative", s.value), help);
        }
        match s.spindle {
            Some(n) if n != self.st.master => {
                self.spindle_number(n, s.span)?;
                self.function(Function::SpindleOf { number: n, spindle: Spindle::Speed(s.value) });
            }
            _ if constant => {
                let feet = self.st.feed_unit() != 1.0;
                self.st.speed = Some(if feet { s.value * 0.3048 } else { s.value });
                self.st.constant_cut = true;
                self.send_cutting_speed();
            }
            _ => {
                self.st.speed = Some(s.value);
                self.st.constant_cut = false;
                self.function(Function::Spindle(Spindle::Speed(s.value)));
            }
        }
        Ok(())
    }

    pub(super) fn spindle_number(&self, n: u8, span: Span) -> Outcome {
        if (1..=MOST_SPINDLES).contains(&n) {
            Ok(())
        } else {
            self.fail(codes::S2045, 0, span, format!("there is no spindle {n}"))
        }
    }

    pub(super) fn send_cutting_speed(&mut self) {
        if let Some(speed) = self.st.speed {
            let limit = self.st.speed_limit;
            self.function(Function::Spindle(Spindle::CuttingSpeed { speed, limit }));
        }
    }
}
