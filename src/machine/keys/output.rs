//! `[output]`, `[limits]` and `[include]`: what is printed, how long a run may be, and what it may open.

use super::key::{Key, Kind, key};
use crate::machine::PathChoice;
use crate::machine::settings::{Compensation, Decimals, Settings, ToolChange, Units};
use crate::machine::tree::{ConfigError, Node, Value};
use crate::machine::values::{flag, is, number, put, table_of, text, texts, whole, wholes};
use crate::target::{self, DwellUnit};

pub const KEYS: &[Key] = &[
    key("target", Kind::Choice(&target::NAMES), "control that runs the output", |s, v| {
        put(&mut s.output.target, target::find(text(v)).ok_or_else(|| v.fail("no such target"))?)
    })
    .or(r#""linuxcnc""#),
    key("units", Kind::Choice(&["mm", "inch"]), "unit of the printed lengths", |s, v| {
        put(&mut s.output.units, if is(v, "inch") { Units::Inches } else { Units::Millimetres })
    })
    .or(r#""mm""#),
    key(
        "decimals",
        Kind::Places,
        "decimal places of lengths, 3 to 6; or of each quantity: { length = 3, angle = 3, feed = 1, speed = 0, time = 2 }; \
         without it as the target has them, linuxcnc 4",
        |s, v| put(&mut s.output.decimals, decimals(v)?),
    ),
    key("compensation", Kind::Choice(&["resolve", "control"]), "tool-centre path, or contour with G41/G42", |s, v| {
        put(&mut s.output.compensation, if is(v, "control") { Compensation::Control } else { Compensation::Resolve })
    })
    .or(r#""resolve""#),
    key("diameter", Kind::Flag, "print diameters (lathe); without it as the target has X", |s, v| {
        put(&mut s.output.diameter, Some(flag(v)))
    }),
    key("comments", Kind::Flag, "keep comments of the source", |s, v| put(&mut s.output.comments, flag(v))).or("true"),
    key("modal", Kind::Flag, "print what changes; false prints all axes and the feed in each block", |s, v| {
        put(&mut s.output.modal, flag(v))
    })
    .or("true"),
    key("line_numbers", Kind::Whole, "step of block numbers, such as 10; 0 prints none", |s, v| {
        let step = u32::try_from(whole(v)).ok().filter(|n| *n <= 1000);
        put(&mut s.output.line_numbers, step.ok_or_else(|| v.fail("0 to 1000"))?)
    })
    .or("0"),
    key("program_number", Kind::Whole, "number of the program where the target names programs by one", |s, v| {
        let number = u32::try_from(whole(v)).ok().filter(|n| (1..=99_999_999).contains(n));
        put(&mut s.output.program_number, number.ok_or_else(|| v.fail("1 to 99999999"))?)
    })
    .or("1"),
    key("header", Kind::Texts, HEADER, |s, v| put(&mut s.output.header, templates(v)?)).or("[]"),
    key("footer", Kind::Texts, "comments before the end of the program, with the fields of `header`", |s, v| {
        put(&mut s.output.footer, templates(v)?)
    })
    .or("[]"),
    key("pass_m", Kind::Wholes, "M functions that are printed as they stand", |s, v| {
        let number = |n| u32::try_from(n).ok().filter(|n| *n < 10_000).ok_or_else(|| v.fail("no M function"));
        put(&mut s.output.pass_m, wholes(v).map(number).collect::<Result<_, _>>()?)
    })
    .or("[]"),
    key(
        "tool_length",
        Kind::Choice(&["off", "G43"]),
        "the target adds the length of the tool from its table: G43 H, or its own word; without it as is usual there, \
         linuxcnc off",
        |s, v| put(&mut s.output.tool_length, Some(is(v, "G43"))),
    ),
    key(
        "tool_change",
        Kind::Choice(&["change", "stop"]),
        "change by the target, or a stop to change by hand",
        |s, v| put(&mut s.output.tool_change, if is(v, "stop") { ToolChange::Stop } else { ToolChange::Change }),
    )
    .or(r#""change""#),
    key(
        "tool_offsets",
        Kind::Whole,
        "largest number of a length or radius offset (H, D), where that is an option of the receiver; without it 99",
        |s, v| {
            let most = u32::try_from(whole(v)).ok().filter(|most| (1..=9999).contains(most));
            put(&mut s.output.tool_offsets, Some(most.ok_or_else(|| v.fail("1 to 9999"))?))
        },
    ),
    key(
        "dwell_unit",
        Kind::Choice(&["seconds", "milliseconds"]),
        "what the number of a wait counts, where that is a setting of the receiver (mach3)",
        |s, v| {
            let unit = if is(v, "seconds") { DwellUnit::Seconds } else { DwellUnit::Milliseconds };
            put(&mut s.output.dwell_unit, Some(unit))
        },
    ),
    key(
        "rapid_feed",
        Kind::Whole,
        "feed of rapid traverse in mm/min, where that goes at the last F (klipper, marlin)",
        |s, v| {
            let feed = u32::try_from(whole(v)).ok().filter(|feed| (1..=1_000_000).contains(feed));
            put(&mut s.output.rapid_feed, Some(feed.ok_or_else(|| v.fail("1 to 1000000"))?))
        },
    ),
    key(
        "arc_fallback_tolerance",
        Kind::Number,
        "how far lines may leave an arc that the target cannot say, in mm, 0.001 to 1; without it such an arc is refused",
        |s, v| {
            let most = number(v).filter(|mm| (0.001..=1.0).contains(mm)).ok_or_else(|| v.fail("0.001 to 1"))?;
            put(&mut s.output.arc_fallback, Some(libm::round(most * 1e6) as u32))
        },
    ),
    key(
        "tapping",
        Kind::Choice(&["warn", "as-target"]),
        "what the tap of the target leaves out (dwell, speed of the way out, angle), or does by leaving the hole instead of \
         breaking the chip: warn of it, or take it",
        |s, v| put(&mut s.output.tapping_as_target, is(v, "as-target")),
    )
    .or(r#""warn""#),
    key(
        "path_control",
        Kind::Corners,
        "how corners are taken where the program has no say: \"exact\", { tolerance = 0.01 } in mm, or \"none\": no word of it \
         is printed; without it a tolerance of 0.01 where the target can say one, on lathes \"exact\"",
        |s, v| put(&mut s.output.path_control, Some(path_choice(v)?)),
    ),
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

const HEADER: &str = "comments after the head; fields: {source}, {version}, {target}, {number}, {units}";

/// Fields of a template.
pub const FIELDS: [&str; 5] = ["source", "version", "target", "number", "units"];

/// Lines of comments whose fields are all known.
fn templates(node: &Node) -> Result<Vec<String>, ConfigError> {
    for text in texts(node) {
        let mut rest = text;
        while let Some((_, behind)) = rest.split_once('{') {
            let (field, behind) = behind.split_once('}').ok_or_else(|| node.fail("a field ends with `}`"))?;
            if !FIELDS.contains(&field) {
                return Err(node.fail(format!("`{{{field}}}` is no field: {}", FIELDS.join(", "))));
            }
            rest = behind;
        }
    }
    Ok(texts(node).map(str::to_owned).collect())
}

/// `4`, or `{ length = 3, feed = 1 }`
fn decimals(node: &Node) -> Result<Decimals, ConfigError> {
    let of = |node: &Node, from: u8| {
        let places = u8::try_from(whole(node)).ok().filter(|n| (from..=6).contains(n));
        let places = places.filter(|_| matches!(node.value, Value::Whole(_)));
        places.map(Some).ok_or_else(|| node.fail(format!("{from} to 6 decimal places")))
    };
    let Value::Table(table) = &node.value else {
        return Ok(Decimals { length: of(node, 3)?, ..Decimals::default() });
    };
    let mut decimals = Decimals::default();
    for (name, node) in table {
        match name.as_str() {
            "length" => decimals.length = of(node, 3)?,
            "angle" => decimals.angle = of(node, 3)?,
            "feed" => decimals.feed = of(node, 0)?,
            "speed" => decimals.speed = of(node, 0)?,
            "time" => decimals.time = of(node, 1)?,
            other => return Err(node.fail(format!("`{other}` is none of length, angle, feed, speed, time"))),
        }
    }
    Ok(decimals)
}

fn roots(settings: &mut Settings, node: &Node) -> Result<(), ConfigError> {
    for (prefix, node) in table_of(node) {
        let Value::Text(folder) = &node.value else { return Err(node.fail("a root is a folder")) };
        let one = one_spelling(prefix);
        if let Some(other) = settings.include.roots.keys().find(|other| one_spelling(other) == one) {
            return Err(node.fail(format!("`{other}` and `{prefix}` are one folder of the control; leave one of them")));
        }
        settings.include.roots.insert(prefix.clone(), folder.into());
    }
    Ok(())
}

/// A drive or folder of a control: upper and lower case, and which slash, make no difference there.
fn one_spelling(prefix: &str) -> String {
    let upper = prefix.to_ascii_uppercase().replace('\\', "/");
    let parts = upper.trim_end_matches('/').split('/').map(|part| match part.rsplit_once('.') {
        Some((stem, kind @ ("DIR" | "WPD"))) => format!("_N_{stem}_{kind}"),
        _ => part.to_owned(),
    });
    parts.collect::<Vec<_>>().join("/")
}

/// `"exact"`, `"none"` or `{ tolerance = 0.01 }`
fn path_choice(node: &Node) -> Result<PathChoice, ConfigError> {
    let wanted = "\"exact\", { tolerance = 0.01 } or \"none\"";
    match &node.value {
        Value::Text(text) if text == "exact" => Ok(PathChoice::Exact),
        Value::Text(text) if text == "none" => Ok(PathChoice::None),
        Value::Table(table) => match (table.get("tolerance"), table.len()) {
            (Some(tolerance), 1) => {
                let mm = number(tolerance).filter(|mm| (0.001..=1.0).contains(mm));
                let mm = mm.ok_or_else(|| tolerance.fail("0.001 to 1 mm"))?;
                Ok(PathChoice::Within(libm::round(mm * 1e6) as u32))
            }
            _ => Err(node.fail(format!("`path_control` is {wanted}"))),
        },
        _ => Err(node.fail(format!("`path_control` is {wanted}"))),
    }
}
