//! Feed: its kinds, and what a path block takes.
//!
//! Source: S 2.1 and 2.15 (docs/sources.md).

use std::collections::BTreeMap;

use crate::diag::{Answer, Help, Label, codes};
use crate::ir::{Feed, Side};
use crate::machine::{Axis, MachineKind, Settings};
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::g_groups::{GCode, Group};
use super::vocabulary::Address;
use super::words::{Given, Words};
use super::{Channel, Core, Outcome, Reported, State};

/// What F says.
#[derive(Debug, Clone)]
pub(super) struct FeedState {
    /// F word in mm, with the kind of feed under which it was written.
    word: Option<Feed>,
    /// A feed is missing, which was reported.
    lost: bool,
    /// No block has said what F counts, and lathes differ in what it does at the start.
    kind_open: bool,
    /// FA of positioning axes, as written.
    axes: BTreeMap<Axis, f64>,
    /// The call that is left out and may have changed the feed, until F is programmed.
    left: Option<Box<FeedLeft>>,
}

/// A call that is left out, where nothing says what feed it leaves, or that it leaves none that is known.
#[derive(Debug, Clone)]
pub(super) struct FeedLeft {
    pub name: String,
    pub call: Loc,
    pub lost: bool,
}

impl FeedState {
    pub fn at_start(settings: &Settings) -> FeedState {
        let lathe = settings.machine.kind == MachineKind::Lathe;
        FeedState {
            word: settings.control.feed.map(Feed::PerMinute),
            lost: false,
            kind_open: lathe && settings.control.sinumerik.feed_per_revolution.is_none(),
            axes: BTreeMap::new(),
            left: None,
        }
    }

    /// A call is left out that may have changed the feed.
    pub fn leave(&mut self, left: FeedLeft) {
        if left.lost {
            self.word = None;
        }
        self.left = Some(Box::new(left));
    }

    /// No such call stands between F and here.
    #[inline]
    pub fn is_the_programs(&self) -> bool {
        self.left.is_none()
    }

    #[inline]
    pub fn word(&self) -> Option<Feed> {
        self.word
    }

    #[inline]
    pub fn is_lost(&self) -> bool {
        self.lost
    }

    pub fn of_axis(&self, axis: Axis) -> Option<f64> {
        self.axes.get(&axis).copied()
    }

    pub fn program(&mut self, feed: Feed) {
        (self.word, self.lost, self.left) = (Some(feed), false, None);
    }

    /// Feeds of positioning axes hold on.
    pub fn program_axes(&mut self, feeds: &[(Axis, f64)]) {
        self.axes.extend(feeds.iter().copied());
    }

    /// Once is enough.
    pub fn lose(&mut self) {
        self.lost = true;
    }

    /// F counts as something else from here on.
    pub fn end(&mut self) {
        self.word = None;
    }

    pub fn kind_is_said(&mut self) {
        self.kind_open = false;
    }

    /// No block has said what F counts.
    pub fn is_kind_open(&self) -> bool {
        self.kind_open
    }

    /// True once, where no block has said what F counts.
    pub fn take_kind_open(&mut self) -> bool {
        std::mem::take(&mut self.kind_open)
    }

    /// Says once that F counts per minute because no block says otherwise.
    pub fn say_kind(&mut self, core: &Core<'_>) {
        if !self.take_kind_open() {
            return;
        }
        let found = codes::S8045::no_block_says_what_f_counts().at(core.loc(Where::Block));
        core.report(
            found.help(
                Answer::key("control", "md20150").help("program G94 or G95, or set `[control] md20150 = \"g95\"`"),
            ),
        );
    }

    /// The first cut after a call that is left out takes the feed of before the call.
    fn say_left(&mut self, core: &Core<'_>) {
        let Some(left) = self.left.take() else { return };
        let name = &left.name;
        let message = format!("this cut takes the feed of before {name}, which is left out and may leave another one");
        if !core.job.diags.first_text(codes::S8171, &message) {
            return;
        }
        let help = format!(
            "program F after {name}; or say under `[programs]` what it leaves: `feed = …` beside the rest of `{name} = {{ … }}`"
        );
        let found =
            codes::S8171::this_cut_takes_feed_of_before(&name).at(core.loc(Where::Block)).also(left.call, Label::Call);
        core.report(found.help(help));
    }

    /// What to do where none is programmed.
    fn help_of_missing(&self) -> Help {
        match &self.left {
            Some(left) if left.lost => Help::from(format!(
                "program F after {} in line {}, which leaves a feed that is not known, as `[programs]` says",
                left.name, left.call.line
            )),
            _ => Answer::key("control", "feed").help(
                "program F in this block or before, again after G94, G95 and G96; a contour by itself takes `[control] feed`",
            ),
        }
    }
}

impl State {
    pub(super) fn feed_code(&mut self, core: &Core<'_>, code: GCode, span: Span) -> Outcome {
        let old = self.codes.of(Group::FeedType);
        use GCode as G;
        if !matches!(code, G::G93 | G::G94 | G::G95 | G::G96 | G::G97 | G::G961 | G::G971) {
            return core.refuse(span, codes::S9009::gives_feeds_that_plain_g_code_cannot(&code.word()));
        }
        if code.holds_cutting_speed() && core.job.settings.machine.diameter_axis.is_none() {
            return core.refuse(
                span,
                codes::S2060::constant_cutting_speed_needs_diameter_axis()
                    .answer(Answer::key("machine", "diameter_axis")),
            );
        }
        self.codes.activate(code);
        self.feed.kind_is_said();
        if old != code {
            self.feed_mode_changed();
        }
        Ok(())
    }
}

impl Channel<'_> {
    /// The feed of a straight path block; `None` at rapid traverse.
    pub(super) fn path_feed(&mut self, w: &mut Words, rapid: bool) -> Outcome<Option<Feed>> {
        if rapid {
            self.core.block_feed(w)?;
            return Ok(None);
        }
        self.cutting_feed(w).map(Some)
    }

    /// The feed of a path block that cuts.
    pub(super) fn cutting_feed(&mut self, w: &mut Words) -> Outcome<Feed> {
        if self.st.is(GCode::G93) && self.capture.is_none() {
            time_of_block(&self.core, self.st.side(), w)?;
        }
        if let Some(fb) = self.core.block_feed(w)? {
            if self.st.codes.per_revolution() {
                self.st.master_feeds(&self.core, fb.span);
            }
            return Ok(self.st.feed_of(fb.value));
        }
        if self.capture.is_some() {
            // Nothing moves along a contour that is read; the cycle that takes it has the feeds.
            return Ok(self.st.feed.word().unwrap_or(Feed::PerRevolution(1.0)));
        }
        self.speed_is_known()?;
        if self.st.feed.is_lost() {
            return Err(Reported);
        }
        let rotary_only = !w.axes.is_empty() && w.axes.iter().all(Axis::is_rotary);
        // The alarm waits for a feed move of the geometry axes; a feed in degrees per minute needs no spindle.
        let waits = rotary_only && !matches!(self.st.feed.word(), Some(Feed::PerRevolution(_)));
        if !waits && self.st.spindles.close_cut_speed() {
            let help = self.left.or_left_at_rapid(
                self.core.job.settings,
                "program S in m/min with G96; the S of before is a speed in turns".into(),
            );
            return self.core.refuse(Where::Block, codes::S2045::g96_has_no_cutting_speed().help(help));
        }
        if self.st.spindles.is_cutting() {
            says_shifted_diameter(&self.core, &self.st);
        }
        match self.st.feed.word() {
            Some(feed) => {
                self.st.feed.say_kind(&self.core);
                self.st.feed.say_left(&self.core);
                if matches!(feed, Feed::PerRevolution(_)) {
                    self.st.master_feeds(&self.core, Where::Block);
                    if self.st.spindles.turn().is_none() && self.core.job.diags.first_time(codes::S8047, ()) {
                        let help = "program M3 or M4 with a speed before it".into();
                        let found = codes::S8047::no_block_in_front_of_this_feed().at(self.core.loc(Where::Block));
                        self.core.report(found.help(self.left.or_started_by_call(self.core.job.settings, help)));
                    }
                }
                if rotary_only && let Feed::PerMinute(f) = feed {
                    // Degrees have no unit of length.
                    return Ok(Feed::PerMinute(f / self.st.feed_unit()));
                }
                Ok(feed)
            }
            None => {
                // Once is enough.
                self.st.feed.lose();
                let help = match self.measured.help_of_feed() {
                    Some(help) => help,
                    None => self.left.or_left_at_rapid(self.core.job.settings, self.st.feed.help_of_missing()),
                };
                self.core.refuse(Where::Block, codes::P2002::no_feed_is_programmed().help(help))
            }
        }
    }
}

impl Core<'_> {
    /// FB, for one block.
    fn block_feed(&self, w: &mut Words) -> Outcome<Option<Given>> {
        match w.take(Address::Fb) {
            Some(fb) if fb.value <= 0.0 => self.refuse(fb.span, codes::P2003::feed_fb_is_not_above_0(&fb.value)),
            fb => Ok(fb),
        }
    }
}

/// G96 of the target takes the diameter that is printed, with the shift of the frame in it.
fn says_shifted_diameter(core: &Core<'_>, st: &State) {
    let axis = core.job.settings.machine.diameter_axis;
    let shift = axis.map_or(0.0, |axis| st.ctx.frame.shift_of(axis));
    if shift == 0.0 || st.spindles.keeps_speed() || !core.job.diags.first_time(codes::S8191, shift.to_bits()) {
        return;
    }
    core.report(codes::S8191::under_g96_frame_shifts_diameter_axis(&shift).at(core.loc(Where::Block)));
}

/// Under G93 F is the time of its own block, which no other block has.
fn time_of_block(core: &Core<'_>, side: Side, w: &Words) -> Outcome {
    if side != Side::None {
        return core.refuse(Where::Block, codes::S9009::time_under_compensation_is_of_target());
    }
    if w.feed_given || w.get(Address::Fb).is_some() {
        return Ok(());
    }
    core.refuse(Where::Block, codes::P2002::under_g93_block_has_no_f())
}
