//! Outputs of a block in short, without loss: what the source says already is a mark, what repeats is named once.

use std::cmp::Reverse;

/// Stands for the comment of the block, printed as it is written.
const COMMENT: &str = "(…)";

/// Bytes of a comment in a line of output, without its brackets.
const COMMENT_ROOM: usize = 78;

/// Lines of a run that is named where it comes again.
const RUN: usize = 6;

/// Values of an axis that a run has at most, to be named.
const VALUES: usize = 2;

/// Lines of output of a block, in short.
pub fn outputs(source: &str, outputs: &[String]) -> Vec<String> {
    let printed = comment(source).map(printed).unwrap_or_default();
    let runs = outputs.chunk_by(|a, b| a.starts_with('(') && b.starts_with('('));
    let marked = runs.flat_map(|run| if run == printed { vec![COMMENT.to_owned()] } else { run.to_vec() });
    folded(&marked.collect::<Vec<_>>())
}

/// The comment of a block: behind a semicolon, or in brackets.
fn comment(source: &str) -> Option<&str> {
    if let Some((_, comment)) = source.split_once(';') {
        return Some(comment);
    }
    let open = source.find(['(', '['])?;
    let close = source.rfind(if source[open..].starts_with('(') { ')' } else { ']' })?;
    source.get(open + 1..close)
}

/// A comment as a controller takes it, in lines that are filled word by word.
fn printed(comment: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in comment.replace('(', "[").replace(')', "]").replace('%', "#").split_ascii_whitespace() {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= COMMENT_ROOM => line.extend([" ", word]),
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| format!("({line})")).collect()
}

/// Names runs that come again at once, the same or with other values of one axis: `… the last 14 again at Z-8, Z-12`. Two values of a
/// run stand in the order in which the run has them.
fn folded(lines: &[String]) -> Vec<String> {
    let (mut folded, mut rest) = (Vec::new(), lines);
    while let Some((first, behind)) = rest.split_first() {
        let runs = (RUN..=rest.len() / 2).map(|length| (length, repeats(rest, length)));
        let longest = runs.max_by_key(|(length, repeats)| (length * repeats.len(), Reverse(*length)));
        match longest {
            Some((length, repeats)) if !repeats.is_empty() => {
                folded.extend_from_slice(&rest[..length]);
                let again = match repeats.len() {
                    1 if repeats[0].is_empty() => String::new(),
                    times if repeats[0].is_empty() => format!(" {times} times"),
                    _ => format!(" at {}", repeats.join(", ")),
                };
                folded.push(format!("… the last {length} again{again}"));
                rest = &rest[length * (repeats.len() + 1)..];
            }
            _ => {
                folded.push(first.clone());
                rest = behind;
            }
        }
    }
    folded
}

/// The values of an axis in each repeat of the first `length` lines; empty texts where no value changes.
fn repeats(lines: &[String], length: usize) -> Vec<String> {
    let (run, rest) = lines.split_at(length);
    let mut axis = None;
    let like_run = |now: &&[String]| {
        axis = axis.or_else(|| changed(run, now));
        axis.map_or(run == *now, |axis| values(run, now, axis).is_some())
    };
    let repeats: Vec<&[String]> = rest.chunks_exact(length).take_while(like_run).collect();
    let axis = repeats.iter().find_map(|now| changed(run, now));
    let texts = repeats.iter().map(|now| axis.and_then(|axis| values(run, now, axis)).unwrap_or_default().join(" "));
    texts.collect()
}

/// The letter of the first word that differs.
fn changed(run: &[String], now: &[String]) -> Option<char> {
    let pairs = run.iter().zip(now).flat_map(|(a, b)| a.split(' ').zip(b.split(' ')));
    pairs.filter(|(a, b)| a != b).find_map(|(a, _)| a.chars().next())
}

/// The words of an axis, if nothing but its numbers differs and each comes from one of the run.
fn values<'t>(run: &[String], now: &'t [String], axis: char) -> Option<Vec<&'t str>> {
    let is_axis = |word: &str| "XYZABCUVW".contains(axis) && word.strip_prefix(axis).is_some_and(is_number);
    let mut values: Vec<(&str, &str)> = Vec::new();
    for (before, now) in run.iter().zip(now) {
        if before.split(' ').count() != now.split(' ').count() {
            return None;
        }
        for (before, now) in before.split(' ').zip(now.split(' ')) {
            if !(is_axis(before) && is_axis(now)) {
                if before != now {
                    return None;
                }
            } else if let Some((_, other)) = values.iter().find(|(known, _)| *known == before) {
                if *other != now {
                    return None;
                }
            } else {
                values.push((before, now));
            }
        }
    }
    (values.len() <= VALUES).then(|| values.iter().map(|(_, now)| *now).collect())
}

fn is_number(text: &str) -> bool {
    text.parse::<f64>().is_ok()
}

#[test]
fn outputs_in_short_tell_all() {
    let short =
        |source: &str, lines: &str| outputs(source, &lines.split('/').map(str::to_owned).collect::<Vec<_>>()).join("/");
    assert_eq!(short("G0 X1 ; to (1)", "(to [1])/G0 X1"), "(…)/G0 X1");
    assert_eq!(short("G0 X1 ; to (1)", "(to [2])/G0 X1"), "(to [2])/G0 X1");
    let level = |z| format!("G1 Z{z}/G1 X1/G1 X2/G1 Y2/G1 X1/G1 Y1");
    let levels = |last: &str| short("", &["G0 Z2", &level(-1), &level(-2), last, "G0 Z2"].join("/"));
    let folded = |behind: &str| format!("G0 Z2/{}/… the last 6 again at {behind}/G0 Z2", level(-1));
    assert_eq!(levels(&level(-3)), folded("Z-2, Z-3"));
    // One number of another word, and the run is written.
    let other = level(-3).replace("X2", "X3");
    assert_eq!(levels(&other), folded(&format!("Z-2/{other}")));
    let same = ["G0 Z2", &level(-1), &level(-1), &level(-1)].join("/");
    assert_eq!(short("", &same), format!("G0 Z2/{}/… the last 6 again 2 times", level(-1)));
}
