//! `[control]` keys that several languages share, and those that name the control.

use super::key::{Key, Kind, key};
use crate::machine::tree::{ConfigError, Node};
use crate::machine::unit::Unit;
use crate::machine::values::{is, number, put, text, wholes};

use crate::machine::options::klartext::Generation;

const GENERATIONS: &[&str] = &["tnc426", "itnc530", "tnc640", "tnc7"];
const SINUMERIKS: &[&str] = &["802d", "810d", "828d", "840dsl", "one"];
const TURNINGS: &[&str] = &["manualplus4110", "cncpilot4290", "manualplus620"];

pub const KEYS: &[Key] = &[
    key("klartext", Kind::Choice(GENERATIONS), "HEIDENHAIN milling control", |s, v| {
        s.control.klartext = match text(v) {
            "tnc426" => Generation::Tnc426,
            "tnc640" => Generation::Tnc640,
            "tnc7" => Generation::Tnc7,
            _ => Generation::Itnc530,
        };
        Ok(())
    })
    .or(r#""itnc530""#),
    key("sinumerik", Kind::Choice(SINUMERIKS), "SINUMERIK control", |s, v| {
        put(&mut s.control.sinumerik.model, text(v).to_owned())
    }),
    key("heidenhain_turning", Kind::Choice(TURNINGS), "HEIDENHAIN turning control", |s, v| {
        put(&mut s.control.heidenhain_turning, text(v).to_owned())
    }),
    key(
        "skip_blocks",
        Kind::Digits,
        "skip levels that are switched on, and whose blocks are left out: 0 is / and /0, 1 is those and /1, 2 to 9 one each",
        |s, v| put(&mut s.control.skip_blocks, skip_levels(v)?),
    )
    .or("[]"),
    key(
        "unit",
        Kind::Choice(&["mm", "inch"]),
        "unit of a Klartext file without BEGIN PGM; base unit of an MTC200",
        |s, v| put(&mut s.control.unit, Some(if is(v, "inch") { Unit::Inch } else { Unit::Mm })),
    ),
    key(
        "open_end",
        Kind::Choice(&["refuse", "allow"]),
        "a main program without M30, M2 or another end: it may have been cut off in transfer",
        |s, v| put(&mut s.control.open_end, is(v, "allow")),
    )
    .or(r#""refuse""#),
    key("feed", Kind::Number, "feed in mm/min at the start, and for F AUTO without a TOOL CALL", |s, v| {
        put(&mut s.control.feed, Some(feed(v)?))
    }),
    key("rapid_feed", Kind::Number, "feed in mm/min of arcs programmed at rapid traverse", |s, v| {
        put(&mut s.control.rapid_feed, Some(feed(v)?))
    }),
    key(
        "tool_change",
        Kind::Choice(&["m6", "t"]),
        "word that changes the tool; default: t on a SINUMERIK lathe, TOOL CALL (t) of a Klartext program without M6, else m6",
        |s, v| {
            s.control.mtc200.t_changes = is(v, "t");
            put(&mut s.control.sinumerik.tool_change_by_t, Some(is(v, "t")))
        },
    ),
    key(
        "tool_change_m",
        Kind::Wholes,
        "Klartext and SINUMERIK: M functions of the machine builder that change the tool as M6 does, also where pass_m lists them",
        |s, v| put(&mut s.control.tool_change_m, wholes(v).map(|n| changing(v, n)).collect::<Result<_, _>>()?),
    )
    .or("[]"),
];

fn skip_levels(node: &Node) -> Result<Vec<u8>, ConfigError> {
    let level = |n| u8::try_from(n).ok().filter(|n| *n <= 9).ok_or_else(|| node.fail("skip levels are 0 to 9"));
    wholes(node).map(level).collect()
}

/// An M function that no manual of a control gives another meaning.
fn changing(node: &Node, number: i64) -> Result<u32, ConfigError> {
    let known = matches!(number, 0..=9 | 13 | 14 | 17 | 19 | 30 | 40..=45 | 70);
    match u32::try_from(number).ok().filter(|n| *n < 10_000) {
        Some(number) if !known => Ok(number),
        _ => Err(node.fail(format!("M{number} is no M function of a machine builder"))),
    }
}

fn feed(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|f| *f > 0.0).ok_or_else(|| node.fail("a feed is above 0"))
}
