//! A tap or thread has a pitch that no thread has.

use crate::diag::codes;
use crate::ir::function::Spindle;
use crate::ir::motion::Path;
use crate::ir::{Feed, Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::lint::tapping::Tapping;

/// Pitches of taps, mm: S0.5 has 0.125, R 6 has 2.3, M64 has 6.
const OF_TAPS: [f64; 2] = [0.1, 8.0];
/// Leads of threads that are cut, mm; those of several starts are long.
const OF_THREADS: [f64; 2] = [0.05, 100.0];

#[derive(Debug)]
pub(super) struct TapPitch<'a> {
    tapping: Tapping<'a>,
    /// Revolutions a minute; `None` where they are not known.
    speed: Option<f64>,
    last: Option<f64>,
}

impl<'a> TapPitch<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> TapPitch<'a> {
        TapPitch { tapping: Tapping::new(setup), speed: None, last: None }
    }

    fn of_feed(&self, feed: Feed) -> Option<f64> {
        match feed {
            Feed::PerRevolution(feed) => Some(feed),
            Feed::PerMinute(feed) => self.speed.filter(|speed| *speed > 0.0).map(|speed| feed / speed),
            Feed::InverseTime(_) => None,
        }
    }
}

impl MotionRule for TapPitch<'_> {
    fn movement(&mut self, step: &Step<'_>, machine: &Machine, say: Say<'_>) {
        let (pitch, [least, most]) = match step.mv.path {
            Path::Thread { lead } => (lead, if step.of_tap { OF_TAPS } else { OF_THREADS }),
            Path::Line(feed) => {
                let Some(pitch) = self.of_feed(feed).filter(|pitch| !(OF_TAPS[0]..=OF_TAPS[1]).contains(pitch)) else {
                    return;
                };
                if !step.of_tap && !self.tapping.taps(step, machine) {
                    return;
                }
                (pitch, OF_TAPS)
            }
            _ => return,
        };
        if (least..=most).contains(&pitch) || self.last == Some(pitch) {
            return;
        }
        self.last = Some(pitch);
        let message = match step.mv.path {
            Path::Line(Feed::PerMinute(feed)) => {
                let speed = self.speed.unwrap_or_default();
                format!("this tap goes {pitch:.4} mm in a turn: {feed} mm per minute at {speed} turns")
            }
            Path::Line(_) => format!("this tap goes {pitch} mm in a turn"),
            _ if step.of_tap => format!("this tap has a pitch of {pitch} mm"),
            _ => format!("this thread has a pitch of {pitch} mm"),
        };
        say.about(
            codes::L1035,
            step.origin,
            message,
            "F of a tap is pitch times speed under G94, and the pitch itself under G95",
        );
    }

    fn function(&mut self, function: &Function, _: &Machine, _: &Origin, _: Say<'_>) {
        match function {
            Function::Spindle(Spindle::Speed(speed)) => self.speed = Some(*speed),
            Function::Spindle(Spindle::CuttingSpeed { .. }) | Function::SpindleOf { .. } | Function::FeedSpindle(_) => {
                self.speed = None;
            }
            Function::ToolChange { .. } => self.last = None,
            _ => {}
        }
    }
}
