//! A tap or thread has a pitch that no thread has.

use crate::ir::function::Spindle;
use crate::ir::motion::Path;
use crate::ir::{Feed, Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup, Step};
use crate::lint::tapping::Tapping;

super::rule! { L1035 Motion TapPitch Warning "pitch-implausible"
    what "tap or thread has a pitch that no thread has"
    why "A tap in a compensating chuck goes as far in a turn as F and S make it go, and here that is less than 0.1 mm or more than \
        8 mm; a thread that is cut in step with the spindle has a pitch below 0.05 mm or above 100 mm. Most often F holds the \
        pitch and G94 is in force (`F1.5` is 1.5 mm per minute), or F is mm per minute under G95. The tap breaks. Under G94 \
        program F as pitch times speed, under G95 the pitch. Taps are known by the cycle, by G63, and by `kind = \"tap\"` in the \
        tool table."
    example r#"
-- Example (L1035_fires_tapping.H)
0 BEGIN PGM P MM
; Q206 holds the pitch: 1.5 mm in a minute.
1 TOOL CALL 1 Z S500
2 CYCL DEF 206 TAPPING NEW ~
  Q200=+2 ~
  Q201=-10 ~
  Q206=+1.5 ~
  Q211=+0 ~
  Q203=+0 ~
  Q204=+50
3 L X+10 Y+10 Z+50 R0 FMAX M3
4 CYCL CALL
5 L Z+50 FMAX M30
6 END PGM P MM
"#
    says {
        tap_a_minute(pitch, feed, speed) "this tap goes {pitch:.4} mm in a turn: {feed} mm per minute at {speed} turns"
            help "F of a tap is pitch times speed under G94, and the pitch itself under G95";
        tap_a_turn(pitch) "this tap goes {pitch} mm in a turn"
            help "F of a tap is pitch times speed under G94, and the pitch itself under G95";
        tap(pitch) "this tap has a pitch of {pitch} mm"
            help "F of a tap is pitch times speed under G94, and the pitch itself under G95";
        thread(pitch) "this thread has a pitch of {pitch} mm"
            help "F of a tap is pitch times speed under G94, and the pitch itself under G95";
    }
}

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
        let fault = match step.mv.path {
            Path::Line(Feed::PerMinute(feed)) => L1035::tap_a_minute(&pitch, &feed, &self.speed.unwrap_or_default()),
            Path::Line(_) => L1035::tap_a_turn(&pitch),
            _ if step.of_tap => L1035::tap(&pitch),
            _ => L1035::thread(&pitch),
        };
        say.about(fault, step.origin);
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
