//! What no manual at hand settles: the reading in use, and a word about it where a program depends on it.
//!
//! Each question has an option of `[control]`; whoever sets it has decided, and hears nothing. Source: reference
//! section 16.

use crate::diag::{Answer, Code, Diagnostic, Help, codes};
use crate::text::Span;

use super::Run;
use super::words::Words;

/// A question that the manuals leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Question {
    ThreadLeft,
    ThreadFace,
    SimpleThread,
    Infeed,
    LineAngle,
    ArcChoice,
    UndercutLimit,
    UndercutSide,
    ContourWords,
    RecessBlank,
    TurningDepth,
    OffsetOneWay,
    RecessDepth,
    RecessWidth,
    RecessOversize,
    BlankContour,
    FinishingSide,
    NosePath,
}

impl Question {
    /// Its code, the reading in use, and what settles it: in words, with the key of `[control]` where there is one.
    fn text(self) -> (&'static Code, &'static str, Help) {
        match self {
            Question::ThreadLeft => (
                codes::T8001,
                "the side to which H shifts the cuts of a thread is taken as: left is ahead of a cut towards -Z",
                settled("thread_left", "set `[control] thread_left = \"minus\"` to confirm it, or \"plus\""),
            ),
            Question::ThreadFace => (
                codes::T8002,
                "the face of this transverse thread is taken from the edge position of the tool",
                settled("thread_face", "set `[control] thread_face = \"front\"` or \"rear\" to say it"),
            ),
            Question::SimpleThread => (
                codes::T8003,
                "the words of G32 are read as docs/turning.md says: no manual at hand lists them",
                settled("simple_thread", "set `[control] simple_thread = \"documented\"` to confirm it, or \"refuse\""),
            ),
            Question::Infeed => (
                codes::T8004,
                "the infeed I of G81 is taken as a depth of cut, on the radius",
                settled("infeed", "set `[control] infeed = \"radius\"` to confirm it, or \"diameter\""),
            ),
            Question::LineAngle => (
                codes::T8005,
                "the angle of a line is taken to count from -Z: the diameter grows where the line runs towards -Z",
                settled("line_angle", "set `[control] line_angle = \"minus-z\"` to confirm it, or \"plus-z\""),
            ),
            Question::ArcChoice => (
                codes::T8006,
                "Q0 of an arc is taken to mean the near one of two solutions, as from software 7.1 on",
                settled(
                    "turning_arc_q",
                    "set `[control] turning_arc_q = \"near\"` to confirm it, or \"far\" for earlier controls",
                ),
            ),
            Question::UndercutLimit => (
                codes::T8007,
                "the table of G85 has no row for exactly this diameter: the one of smaller diameters is taken",
                settled("undercut_limit", "set `[control] undercut_limit = \"lower\"` to confirm it, or \"upper\""),
            ),
            Question::UndercutSide => (
                codes::T8008,
                "the tool stands on the cylinder: whether the undercut lies outside or inside is taken from its edge position",
                "position the tool clear of the cylinder to say it".into(),
            ),
            Question::ContourWords => (
                codes::T8009,
                "the words of G80 are read as docs/turning.md says: AC and WC lean the walls about their rims",
                settled("contour_words", "set `[control] contour_words = \"documented\"` to confirm it, or \"refuse\""),
            ),
            Question::RecessBlank => (
                codes::T8010,
                "RI of G869 is taken to count on the diameter",
                settled("recess_blank", "set `[control] recess_blank = \"diameter\"` to confirm it, or \"radius\""),
            ),
            Question::TurningDepth => (
                codes::T8011,
                "the turning depth compensation of G869 is taken to lift the tool off the floor",
                settled("turning_depth", "set `[control] turning_depth = \"away\"` to confirm it, or \"towards\""),
            ),
            Question::OffsetOneWay => (
                codes::T8012,
                "the offset width B has no effect under U1: one way there is no change from turning to plunging",
                settled("offset_one_way", "set `[control] offset_one_way = \"none\"` to confirm it, or \"end\""),
            ),
            Question::RecessDepth => (
                codes::T8013,
                "an incremental I of G22 is taken to count on the diameter",
                settled("recess_depth", "set `[control] recess_depth = \"diameter\"` to confirm it, or \"radius\""),
            ),
            Question::RecessWidth => (
                codes::T8014,
                "K of G23 is taken as the width of the opening, where the flanks lean",
                settled("recess_width", "set `[control] recess_width = \"opening\"` to confirm it, or \"floor\""),
            ),
            Question::RecessOversize => (
                codes::T8015,
                "the oversize of G86 is left on the floor and on the walls until the finishing cut",
                settled("recess_oversize", "set `[control] recess_oversize = \"all\"` to confirm it, or \"floor\""),
            ),
            Question::BlankContour => (
                codes::T8016,
                "the blank is drawn as a contour, which is not used: cycles take the blank to reach to the tool",
                "position the tool outside of the blank before each cycle, or describe the blank by G20 or G21".into(),
            ),
            Question::NosePath => (
                codes::T8019,
                "how G41 and G42 begin, end and go around outside corners no manual at hand says: at a right angle beside the contour, and on an arc about the corner",
                "look at the first and the last way beside the contour".into(),
            ),
            Question::FinishingSide => (
                codes::T8018,
                "two pages of the manual give G41 and G42 behind G89 opposite sides: the side is taken from the tool",
                "check the side of the tool: where it stands, or `orientation` in partc.toml".into(),
            ),
        }
    }

    /// Did the configuration decide it?
    fn is_settled(self, run: &Run<'_>) -> bool {
        let set = &run.job.settings.control.turning;
        match self {
            Question::ThreadLeft => set.left_is_plus.is_some(),
            Question::ThreadFace => set.rear_face.is_some(),
            Question::SimpleThread => set.refuse_simple_thread.is_some(),
            Question::Infeed => set.infeed.is_some(),
            Question::LineAngle => set.angle_from_plus.is_some(),
            Question::ArcChoice => set.arc_choice.is_some(),
            Question::UndercutLimit => set.undercut_upper.is_some(),
            Question::ContourWords => set.refuse_contour_words.is_some(),
            Question::RecessBlank => set.recess_blank.is_some(),
            Question::TurningDepth => set.towards_floor.is_some(),
            Question::OffsetOneWay => set.offset_one_way.is_some(),
            Question::RecessDepth => set.recess_depth.is_some(),
            Question::RecessWidth => set.recess_width.is_some(),
            Question::RecessOversize => set.oversize_on_floor.is_some(),
            Question::UndercutSide | Question::BlankContour | Question::FinishingSide | Question::NosePath => false,
        }
    }
}

/// A key of `[control]` confirms the reading, or takes the other one.
fn settled(key: &'static str, help: &'static str) -> Help {
    Answer::key("control", key).help(help)
}

impl Run<'_> {
    /// A word of the block that changes nothing here: worth a note, as no word goes in silence.
    pub(super) fn without_effect(&self, w: &Words, letters: &[u8], why: &str) {
        for letter in letters {
            if let Some(num) = w.get(*letter) {
                self.note_idle(num.span, *letter as char, why);
            }
        }
    }

    pub(super) fn note_idle(&self, span: Span, word: impl std::fmt::Display, why: &str) {
        self.report(codes::T8017::changes_nothing_here(&word, &why).at(self.loc(span)));
    }

    /// The block depends on `question`: the first one of the program says so.
    pub(super) fn depends_on(&self, question: Question, span: Span) {
        if question.is_settled(self) {
            return;
        }
        let (code, message, help) = question.text();
        self.job
            .diags
            .push_once(Diagnostic::new(code, self.loc(span), message).help(help).called(self.here.origin.call));
    }
}
