//! Reads one value of a `partc.toml` behind its key.

use std::collections::BTreeMap;

use super::axis::{Axis, AxisSet};
use super::keys::{Key, Kind};
use super::settings::{AxisUse, LONGEST_AXIS_NAME};
use super::tools::ToolKey;
use super::tree::{ConfigError, Node, Table, Value, did_you_mean};

pub(super) fn fits(key: &Key, node: &Node) -> Result<(), ConfigError> {
    let all = |good: fn(&Value) -> bool| match &node.value {
        Value::List(items) => items.iter().all(|item| good(&item.value)),
        _ => false,
    };
    let ok = match key.kind {
        Kind::Text => matches!(node.value, Value::Text(_)),
        Kind::Flag => matches!(node.value, Value::Flag(_)),
        Kind::Number => matches!(node.value, Value::Number(_) | Value::Whole(_)),
        Kind::Whole => matches!(node.value, Value::Whole(_)),
        Kind::Choice(choices) => {
            if let Value::Text(text) = &node.value
                && !choices.contains(&text.as_str())
            {
                let mut error = node.fail(format!("`{}` is none of {}", text, choices.join(", ")));
                error.help = did_you_mean(text, choices.iter().copied()).map(|like| format!("did you mean `{like}`?"));
                return Err(error);
            }
            matches!(node.value, Value::Text(_))
        }
        Kind::Wholes | Kind::Digits => all(|value| matches!(value, Value::Whole(_))),
        Kind::Texts => all(|value| matches!(value, Value::Text(_))),
        Kind::Free => matches!(node.value, Value::Table(_)),
        Kind::Places => matches!(node.value, Value::Whole(_) | Value::Table(_)),
        Kind::Corners => matches!(node.value, Value::Text(_) | Value::Table(_)),
        Kind::NumberOr(word) => match &node.value {
            Value::Number(_) | Value::Whole(_) => true,
            Value::Text(text) => text == word,
            _ => false,
        },
        Kind::Words => matches!(node.value, Value::Table(_)) || all(|value| matches!(value, Value::Text(_))),
    };
    let wanted = match key.kind {
        Kind::Text | Kind::Choice(_) => "a text in quotes",
        Kind::Flag => "true or false",
        Kind::Number => "a number",
        Kind::Whole => "a whole number",
        Kind::Wholes => "a list of whole numbers",
        Kind::Digits => "a list of numbers from 0 to 9",
        Kind::Texts => "a list of texts",
        Kind::Free => "a table",
        Kind::Places => "a whole number or a table",
        Kind::Corners => "a text in quotes or a table",
        Kind::Words => "a list of texts or a table",
        Kind::NumberOr(word) => {
            let message = format!("`{}` needs a number or \"{word}\": {}", key.name, key.doc);
            return if ok { Ok(()) } else { Err(node.fail(message)) };
        }
    };
    if ok { Ok(()) } else { Err(node.fail(format!("`{}` needs {wanted}: {}", key.name, key.doc))) }
}

pub(super) fn text(node: &Node) -> &str {
    match &node.value {
        Value::Text(text) => text,
        _ => "",
    }
}

/// Puts a value in its place.
pub(super) fn put<T>(place: &mut T, value: T) -> Result<(), ConfigError> {
    *place = value;
    Ok(())
}

/// Does the text say `wanted`?
pub(super) fn is(node: &Node, wanted: &str) -> bool {
    text(node) == wanted
}

/// A tolerance of lengths.
pub(super) fn tolerance(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|mm| (0.0..=1.0).contains(mm)).ok_or_else(|| node.fail("a tolerance is 0 to 1 mm"))
}

/// `{ X = 0.0, Z = 100.0 }`
pub(super) fn positions(into: &mut BTreeMap<Axis, f64>, node: &Node) -> Result<(), ConfigError> {
    for (name, node) in table_of(node) {
        let value = number(node).filter(|v| v.is_finite()).ok_or_else(|| node.fail("needs a number"))?;
        into.insert(axis(name, node)?, value);
    }
    Ok(())
}

/// Two keys for one thing.
pub(super) const BOTH_STARTS: &str =
    "`[control] start` is the older name of `[start]`: keep one of the two (X counts as a radius in the older one)";

pub(super) fn flag(node: &Node) -> bool {
    matches!(node.value, Value::Flag(true))
}

pub(super) fn whole(node: &Node) -> i64 {
    match node.value {
        Value::Whole(n) => n,
        _ => 0,
    }
}

pub(super) fn number(node: &Node) -> Option<f64> {
    match node.value {
        Value::Whole(n) => Some(n as f64),
        Value::Number(x) => Some(x),
        _ => None,
    }
}

pub(super) fn wholes(node: &Node) -> impl Iterator<Item = i64> + '_ {
    let items: &[Node] = match &node.value {
        Value::List(items) => items,
        _ => &[],
    };
    items.iter().map(whole)
}

pub(super) fn texts(node: &Node) -> impl Iterator<Item = &str> {
    let items: &[Node] = match &node.value {
        Value::List(items) => items,
        _ => &[],
    };
    items.iter().map(text)
}

pub(super) fn table_of(node: &Node) -> &Table {
    static NONE: Table = Table::new();
    match &node.value {
        Value::Table(table) => table,
        _ => &NONE,
    }
}

/// `["LA_ON"]`, or `{ LA_ON = "M64", LA_OFF = "" }`.
pub(super) fn machine_words(node: &Node) -> Result<BTreeMap<String, Option<u32>>, ConfigError> {
    if let Value::List(items) = &node.value {
        return Ok(items.iter().map(|item| (text(item).to_ascii_uppercase(), None)).collect());
    }
    let mut words = BTreeMap::new();
    for (name, node) in table_of(node) {
        let printed = text(node);
        let number = printed.strip_prefix(['M', 'm']).and_then(|digits| digits.parse().ok()).filter(|n| *n < 10_000);
        if number.is_none() && !(printed.is_empty() && matches!(node.value, Value::Text(_))) {
            return Err(node.fail("a word of the machine becomes an M function such as \"M101\", or nothing: \"\""));
        }
        words.insert(name.to_ascii_uppercase(), number);
    }
    Ok(words)
}

pub(super) fn axis(name: &str, node: &Node) -> Result<Axis, ConfigError> {
    match name.as_bytes() {
        [letter] => Axis::of(*letter),
        _ => None,
    }
    .ok_or_else(|| node.fail(format!("`{name}` is no axis: X, Y, Z, A, B, C, U, V, W")))
}

/// `{ B1 = "B", C4 = "leave-out" }`
pub(super) fn axis_names(node: &Node) -> Result<BTreeMap<String, AxisUse>, ConfigError> {
    let mut names = BTreeMap::new();
    for (name, node) in table_of(node) {
        let name = name.to_ascii_uppercase();
        if let Some(why) = no_axis_name(&name) {
            return Err(node.fail(format!("`{name}` cannot be the name of an axis: {why}")));
        }
        let stands_for = match text(node) {
            "leave-out" => AxisUse::LeftOut,
            letter => AxisUse::Printed(axis(letter, node).map_err(|_| {
                node.fail(format!("`{name}` becomes one of X, Y, Z, A, B, C, U, V, W, or \"leave-out\""))
            })?),
        };
        if Axis::of(name.as_bytes()[0])
            .is_some_and(|own| name.len() == 1 && own.is_main() && stands_for != AxisUse::Printed(own))
        {
            return Err(node.fail(format!("{name} is a geometry axis and is printed as {name}")));
        }
        names.insert(name, stands_for);
    }
    Ok(names)
}

/// Why a name in capitals is not one of an axis.
fn no_axis_name(name: &str) -> Option<&'static str> {
    let bytes = name.as_bytes();
    let letters = bytes.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let only_digits_follow = bytes[letters.min(1)..].iter().all(u8::is_ascii_digit);
    match bytes {
        [] => Some("it is empty"),
        _ if bytes.len() > LONGEST_AXIS_NAME => Some("it has more than 8 characters"),
        _ if letters == 0 || !bytes.iter().all(|b| b.is_ascii_alphanumeric() || *b == b'_') => {
            Some("a name begins with a letter and has letters, digits and _")
        }
        [b'D'..=b'H' | b'L'..=b'N' | b'P' | b'R'..=b'T' | b'O', ..] if only_digits_follow => {
            Some("its letter is an address of the language")
        }
        [b'I'..=b'K'] | [b'I'..=b'K', b'1'] => Some("it is a word of circles"),
        _ => None,
    }
}

/// An axis by its letter, or by a name of `[machine] axes`.
pub(super) fn named_axis(name: &str, node: &Node, names: &BTreeMap<String, AxisUse>) -> Result<Axis, ConfigError> {
    match names.get(&name.to_ascii_uppercase()) {
        Some(AxisUse::Printed(axis)) => Ok(*axis),
        Some(AxisUse::LeftOut) => Err(node.fail(format!("`{name}` is left out under `axes`"))),
        None => axis(name, node).map_err(|mut error| {
            error.help = Some(format!("name it: `axes = {{ {name} = \"X\" }}`"));
            error
        }),
    }
}

pub(super) fn geometry_axes(node: &Node, names: &BTreeMap<String, AxisUse>) -> Result<[Axis; 3], ConfigError> {
    let Value::List(items) = &node.value else { return Err(node.fail("needs three axis names")) };
    let axes = items.iter().map(|item| named_axis(text(item), item, names)).collect::<Result<Vec<_>, _>>()?;
    let distinct = |axes: &[Axis; 3]| axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2];
    <[Axis; 3]>::try_from(axes).ok().filter(distinct).ok_or_else(|| node.fail("needs three different axis names"))
}

pub(super) fn rotary_axes(node: &Node) -> Result<AxisSet, ConfigError> {
    let Value::List(items) = &node.value else { return Err(node.fail("needs a list of axes")) };
    let mut axes = AxisSet::EMPTY;
    for item in items {
        let axis = axis(text(item), item)?;
        if !axis.is_rotary() {
            return Err(item.fail("axes that count modulo 360 degrees are A, B and C"));
        }
        axes.insert(axis);
    }
    Ok(axes)
}

pub(super) fn range(node: &Node) -> Result<(f64, f64), ConfigError> {
    let fail = || node.fail("a range is two numbers, the smaller one first: [-10.0, 800.0]");
    let Value::List(items) = &node.value else { return Err(fail()) };
    match items.as_slice() {
        [low, high] => match (number(low), number(high)) {
            (Some(low), Some(high)) if low <= high => Ok((low, high)),
            _ => Err(fail()),
        },
        _ => Err(fail()),
    }
}

pub(super) fn change_point(node: &Node) -> Result<(f64, f64), ConfigError> {
    let fail = || node.fail("a tool change point has both coordinates: { X = 300.0, Z = 400.0 }");
    let (mut x, mut z) = (None, None);
    for (name, node) in table_of(node) {
        match name.as_str() {
            "X" => x = number(node),
            "Z" => z = number(node),
            _ => return Err(fail()),
        }
    }
    x.zip(z).ok_or_else(fail)
}

pub(super) fn tool_key(name: &str, node: &Node) -> Result<ToolKey, ConfigError> {
    let (number, index) = name.split_once('.').unwrap_or((name, "0"));
    if name.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
        let fail = || node.fail(format!("`{name}` is no tool number"));
        return Ok(ToolKey::Number(number.parse().map_err(|_| fail())?, index.parse().map_err(|_| fail())?));
    }
    Ok(ToolKey::Name(name.to_owned()))
}

/// 1 for `G54` … 9 for `G59.3`.
pub(super) fn work_offset(word: &str) -> Option<u8> {
    const WORDS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];
    let word = word.to_ascii_uppercase();
    let named = WORDS.iter().position(|known| *known == word).map(|i| i as u8 + 1);
    named.or_else(|| further_offset(&word))
}

/// 7 for `G54.1 P1` and `G154 P1`, 10 for `G510`.
fn further_offset(word: &str) -> Option<u8> {
    let number = |digits: &str| digits.parse::<u8>().ok().filter(|_| digits.bytes().all(|b| b.is_ascii_digit()));
    if let Some(digits) = word.strip_prefix("G5").filter(|digits| digits.len() == 2) {
        return number(digits).filter(|n| *n >= 5);
    }
    let (digits, most) = match word.strip_prefix("G54.1") {
        Some(rest) => (rest, 48),
        None => (word.strip_prefix("G154")?, 99),
    };
    let number = number(digits.trim_start().strip_prefix('P')?)?;
    (1..=most).contains(&number).then_some(number + 6)
}

/// What a work offset of the configuration may be.
pub(super) const OFFSETS: &str = "G54 to G59, G59.1 to G59.3, G54.1 P1 to P48, G154 P1 to P99, G505 to G599";
