//! The changes of a program as people read them.

use std::fmt::Write as _;

use similar::TextDiff;

/// Lines shown around a change.
const CONTEXT: usize = 3;

/// Old and new text as a unified diff. Where no line came or went, lines are compared one by one: the search for what
/// moved takes the square of the changes.
pub(super) fn unified(old: &str, new: &str, name: &str) -> String {
    let (before, after): (Vec<&str>, Vec<&str>) =
        (old.split_inclusive('\n').collect(), new.split_inclusive('\n').collect());
    if before.len() == after.len() {
        line_by_line(&before, &after, name)
    } else {
        TextDiff::from_lines(old, new).unified_diff().header(name, name).to_string()
    }
}

fn line_by_line(before: &[&str], after: &[&str], name: &str) -> String {
    let changed: Vec<usize> = (0..before.len()).filter(|at| before[*at] != after[*at]).collect();
    let mut out = if changed.is_empty() { String::new() } else { format!("--- {name}\n+++ {name}\n") };
    for group in changed.chunk_by(|one, next| next - one <= 2 * CONTEXT + 1) {
        let (Some(first), Some(last)) = (group.first(), group.last()) else { continue };
        let (from, to) = (first.saturating_sub(CONTEXT), (last + 1 + CONTEXT).min(before.len()));
        let range = if to - from == 1 { format!("{}", from + 1) } else { format!("{},{}", from + 1, to - from) };
        let _ = writeln!(out, "@@ -{range} +{range} @@");
        let mut at = from;
        while at < to {
            let same = before[at] == after[at];
            let run = (at..to).find(|next| (before[*next] == after[*next]) != same).unwrap_or(to);
            let parts = [(' ', before, same), ('-', before, !same), ('+', after, !same)];
            for (sign, lines, _) in parts.into_iter().filter(|(.., shown)| *shown) {
                lines[at..run].iter().for_each(|line| push(&mut out, sign, line));
            }
            at = run;
        }
    }
    out
}

fn push(out: &mut String, sign: char, line: &str) {
    out.push(sign);
    out.push_str(line);
    if !line.ends_with('\n') {
        out.push_str("\n\\ No newline at end of file\n");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_one_by_one_look_like_any_other_diff() {
        let text: String = (0..60).map(|n| format!("G1 X{n} F100\n")).collect::<String>() + "M30";
        let mut new = text.clone();
        for n in [0, 1, 9, 16, 17, 40, 47, 55] {
            new = new.replace(&format!(" X{n} F100\n"), &format!(" X{n}\n"));
        }
        for new in [new.clone(), new.replace("M30", "M2"), text.clone(), text.replace("M30", "M30\n")] {
            let wanted = TextDiff::from_lines(&*text, &*new).unified_diff().header("a", "a").to_string();
            assert_eq!(unified(&text, &new, "a"), wanted);
        }
        assert_eq!(
            unified("a", "b", "a"),
            "--- a\n+++ a\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+b\n\\ No newline at end of file\n"
        );
    }
}
