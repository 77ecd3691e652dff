//! `[output]`, `[limits]` and `[include]`: what is printed, how long a run may be, and what it may open.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::settings::{Compensation, Settings, ToolChange};
use crate::machine::tree::{ConfigError, Node, Value};
use crate::machine::values::{flag, is, put, table_of, text, whole, wholes};
use crate::target;

pub const KEYS: &[Key] = &[
    key("target", Kind::Choice(&target::NAMES), "control that runs the output", |s, v| {
        put(&mut s.output.target, target::find(text(v)).ok_or_else(|| v.fail("no such target"))?)
    })
    .or(r#""linuxcnc""#),
    key("decimals", Kind::Whole, "decimal places of lengths, 3 to 6", |s, v| {
        let places = u8::try_from(whole(v)).ok().filter(|n| (3..=6).contains(n));
        put(&mut s.output.decimals, places.ok_or_else(|| v.fail("3 to 6 decimal places"))?)
    })
    .or("4"),
    key("compensation", Kind::Choice(&["resolve", "control"]), "tool-centre path, or contour with G41/G42", |s, v| {
        put(&mut s.output.compensation, if is(v, "control") { Compensation::Control } else { Compensation::Resolve })
    })
    .or(r#""resolve""#),
    key("diameter", Kind::Flag, "print diameters (lathe)", |s, v| put(&mut s.output.diameter, flag(v))).or("false"),
    key("comments", Kind::Flag, "keep comments of the source", |s, v| put(&mut s.output.comments, flag(v))).or("true"),
    key("pass_m", Kind::Wholes, "M functions that are printed as they stand", |s, v| {
        let number = |n| u32::try_from(n).ok().filter(|n| *n < 10_000).ok_or_else(|| v.fail("no M function"));
        put(&mut s.output.pass_m, wholes(v).map(number).collect::<Result<_, _>>()?)
    })
    .or("[]"),
    key("tool_length", Kind::Choice(&["off", "G43"]), "G43 H behind a tool change", |s, v| {
        put(&mut s.output.tool_length, is(v, "G43"))
    })
    .or(r#""off""#),
    key(
        "tool_change",
        Kind::Choice(&["change", "stop"]),
        "change by the target, or a stop to change by hand",
        |s, v| put(&mut s.output.tool_change, if is(v, "stop") { ToolChange::Stop } else { ToolChange::Change }),
    )
    .or(r#""change""#),
];

pub const LIMITS: &[Key] = &[
    key("steps", Kind::Whole, "blocks that may be executed", |s, v| put(&mut s.limits.steps, at_least_one(v)?))
        .or("10_000_000"),
    key("output_blocks", Kind::Whole, "lines that may be printed", |s, v| {
        put(&mut s.limits.output_blocks, at_least_one(v)?)
    })
    .or("50_000_000"),
    key("call_depth", Kind::Whole, "nesting of calls", |s, v| {
        put(&mut s.limits.call_depth, usize::try_from(at_least_one(v)?).unwrap_or(usize::MAX).min(1000))
    })
    .or("64"),
];

pub const INCLUDE: &[Key] =
    &[key("roots", Kind::Free, "path prefix of the control and folder of this computer", roots)];

fn at_least_one(node: &Node) -> Result<u64, ConfigError> {
    u64::try_from(whole(node)).ok().filter(|n| *n > 0).ok_or_else(|| node.fail("must be at least 1"))
}

fn roots(settings: &mut Settings, node: &Node) -> Result<(), ConfigError> {
    for (prefix, node) in table_of(node) {
        let Value::Text(folder) = &node.value else { return Err(node.fail("a root is a folder")) };
        settings.include.roots.insert(prefix.clone(), folder.into());
    }
    Ok(())
}
