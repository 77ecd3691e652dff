//! Faults put into what is printed, and into the printer: each has to be noticed.

use crate::emit::printer::disturb::Disturbance;
use crate::ir::Function;
use crate::ir::motion::Path;
use crate::machine::Axis;

use super::streams::{Dice, Item, Stream, stream, stream_for};
use super::{LENGTH, as_it_is, validate};

/// Faults of each kind.
const EACH: usize = 40;
/// Streams that are tried for them.
const MOST_SEEDS: u64 = 400_000;

/// Puts a fault into the text of an item, or cannot.
type Fault = fn(&str, &mut Dice) -> Option<String>;

const FAULTS: &[(&str, Fault)] = &[
    ("another sign", |t, d| change(t, d, "XYZAC", is_move, |v| if v == 0 { None } else { Some(-v) })),
    ("another sign of a centre", |t, d| change(t, d, "IJK", is_arc, |v| if v == 0 { None } else { Some(-v) })),
    // A place between two parts of an arc may be rounded either way.
    ("a unit more", |t, d| change(t, d, "XYZ", is_move, |v| Some(v + 1)).filter(|_| single(t))),
    ("a unit less", |t, d| change(t, d, "XYZ", is_move, |v| Some(v - 1)).filter(|_| single(t))),
    ("two units beside the centre", |t, d| change(t, d, "IJK", is_arc, |v| Some(v + 2))),
    ("ten times as far", |t, d| change(t, d, "XYZIJK", is_move, |v| if v == 0 { None } else { Some(v * 10) })),
    ("centres exchanged", |t, d| {
        let (a, b) = d.of(&[(" I", " J"), (" I", " K"), (" J", " K")]);
        let number = |letter: &str| t.split_once(letter)?.1.split([' ', '\n']).next();
        if number(a)? == number(b)? || !is_arc(t) || !single(t) {
            return None;
        }
        Some(t.replace(a, " ?").replace(b, a).replace(" ?", b))
    }),
    ("axes exchanged", |t, d| {
        let (a, b) = d.of(&[(" X", " Y"), (" Y", " Z"), (" X", " Z")]);
        let number = |letter: &str| t.split_once(letter).map(|(_, rest)| rest.split([' ', '\n']).next());
        if number(a) == number(b) || !is_move(t) || t.contains(" I") || t.contains(" J") {
            return None;
        }
        Some(t.replace(a, " ?").replace(b, a).replace(" ?", b))
    }),
    ("a block less", |t, _| (single(t) && !t.starts_with(['(', '%'])).then(String::new)),
    ("a block twice", |t, _| (single(t) && is_act(t)).then(|| format!("{t}{t}"))),
    ("the other way round", |t, _| swap(t, "G2 ", "G3 ")),
    ("rapid or not", |t, _| swap(t, "G0 ", "G1 ")),
    ("more turns", |t, d| if is_arc(t) { change(t, d, "P", is_arc, |v| Some(v + 10_000)) } else { None }),
    ("no turns", |t, _| without(t, 'P').filter(|_| is_arc(t))),
    ("another feed", |t, d| change(t, d, "F", is_move, |v| Some(v + 1))),
    ("no feed", |t, _| without(t, 'F').filter(|_| single(t))),
    ("another kind of feed", |t, d| word(t, d, &["G93", "G94", "G95"])),
    ("the kind of feed lost", |t, d| lost(t, d, &["G93", "G94", "G95"])),
    ("another plane", |t, d| word(t, d, &["G17", "G18", "G19"])),
    ("the plane lost", |t, d| lost(t, d, &["G17", "G18", "G19"])),
    ("another mode of the head", |t, d| {
        let (from, to) =
            d.of(&[("G90 ", "G91 "), ("G21 ", "G20 "), ("G91.1 ", "G90.1 "), ("G94\n", "G95\n"), ("G8 ", "G7 ")]);
        t.contains(from).then(|| t.replace(from, to))
    }),
    ("a mode of the head lost", |t, d| {
        let word = d.of(&["G90 ", "G21 ", "G91.1 ", " G94", "G17 ", "G18 ", "G8 ", "G7 ", "G40 ", "G49 ", " G80"]);
        t.contains(word).then(|| t.replacen(word, "", 1))
    }),
    ("an exact path or not", |t, _| {
        let exact = t.contains("G61").then(|| t.replace("G61", "G64"));
        exact.or_else(|| t.contains("G64").then(|| t.split(" P").next().unwrap_or(t).replace("G64", "G61") + "\n"))
    }),
    ("another bound", |t, _| t.contains("G64 P0.0").then(|| t.replace("G64 P0.0", "G64 P0.1"))),
    ("a smaller bound", |t, _| t.contains("G64 P0.0").then(|| t.replace("G64 P0.0", "G64 P0.00"))),
    ("the bound lost", |t, _| t.contains("G64 P").then(|| format!("{}G64\n", t.split("G64 ").next().unwrap_or(t)))),
    ("the word for corners lost", |t, _| {
        (single(t) && (t.starts_with("G64") || t.starts_with("G61"))).then(String::new)
    }),
    ("machine coordinates lost", |t, _| t.contains("G53 ").then(|| t.replace("G53 ", ""))),
    ("machine coordinates instead", |t, _| (single(t) && t.starts_with("G0 ")).then(|| format!("G53 {t}"))),
    ("another speed", |t, d| change(t, d, "S", |_| true, |v| Some(v + 1))),
    ("another limit of the speed", |t, d| change(t, d, "D", |line| line.starts_with("G96"), |v| Some(v + 1))),
    ("the speed as it was", |t, _| t.contains("G97 ").then(|| t.replace("G97 ", ""))),
    ("another tool", |t, d| change(t, d, "T", |_| true, |v| Some(v + 10_000))),
    ("another length", |t, d| change(t, d, "H", |_| true, |v| Some(v + 10_000))),
    ("another spindle", |t, d| change(t, d, "$", |_| true, |v| Some(v + 10_000))),
    ("another lead", |t, d| change(t, d, "K", |line| line.starts_with("G33"), |v| Some(v + 1))),
    ("another dwell", |t, d| change(t, d, "P", |line| line.starts_with("G4 "), |v| Some(v + 1))),
    ("another angle", |t, d| change(t, d, "R", |line| line.starts_with("M19"), |v| Some(v + 1))),
    ("another side", |t, d| word(t, d, &["G41", "G42"]).or_else(|| word(t, d, &["G41.1", "G42.1"]))),
    ("another cutter", |t, d| change(t, d, "D", |line| line.starts_with("G4"), |v| Some(v + 10_000))),
    ("the side lost", |t, _| {
        let kept: Vec<&str> =
            t.split_inclusive('\n').filter(|l| !l.starts_with("G41") && !l.starts_with("G42")).collect();
        Some(kept.concat()).filter(|text| text != t)
    }),
    ("compensation that goes on", |t, d| lost(t, d, &["G40"])),
    ("another function", |t, d| {
        let pairs = [
            ("M3\n", "M4\n"),
            ("M5\n", "M3\n"),
            ("M8\n", "M9\n"),
            ("M0\n", "M1\n"),
            ("M7\n", "M8\n"),
            ("M77\n", "M78\n"),
        ];
        let (a, b) = d.of(&pairs);
        swap(t, a, b)
    }),
    ("another end", |t, _| swap(t, "M2\n", "M30\n")),
    ("no change of the tool", |t, _| t.contains(" M6").then(|| t.replace(" M6", ""))),
    ("another offset", |t, d| word(t, d, &["G54", "G55", "G56", "G57", "G58", "G59"])),
    ("a letter that is none", |t, d| {
        let (at, _) = t.char_indices().filter(|(_, c)| "XYZ".contains(*c)).nth(d.roll(4))?;
        is_move(t).then(|| format!("{}Q{}", &t[..at], &t[at + 1..]))
    }),
    ("a digit less", |t, _| {
        let line = t.strip_suffix('\n').filter(|line| single(t) && is_move(line))?;
        let (rest, last) = (line.get(..line.len() - 1)?, line.chars().last()?);
        // A zero behind the point is not printed.
        (last.is_ascii_digit() && rest.ends_with(|c: char| c.is_ascii_digit()) && last != '0')
            .then(|| format!("{rest}\n"))
    }),
];

/// The same in a dialog.
const DIALOG: &[(&str, Fault)] = &[
    ("another sign", |t, d| change(t, d, "XYZ", is_block, |v| if v == 0 { None } else { Some(-v) })),
    ("a unit more", |t, d| change(t, d, "XYZ", |l| has(l, "L"), |v| Some(v + 1)).filter(|_| single(t))),
    ("two units beside the centre", |t, d| change(t, d, "XYZ", |l| has(l, "CC"), |v| Some(v + 2))),
    ("the centre lost", |t, _| less(t, "CC")),
    ("the other way round", |t, _| exchanged(t, " DR+", " DR-")),
    ("another angle", |t, _| t.contains(" IPA+").then(|| t.replace(" IPA+", " IPA+1"))),
    ("another way", |t, _| t.contains(" IZ+").then(|| t.replace(" IZ+", " IZ+1"))),
    ("increments", |t, _| (single(t) && t.contains(" L X")).then(|| t.replace(" L X", " L IX"))),
    ("the line behind a helix lost", |t, _| t.contains(" CP ").then(|| less(t, "L")).flatten()),
    ("rapid traverse lost", |t, _| t.contains(" FMAX").then(|| t.replace(" FMAX", ""))),
    ("rapid traverse instead", |t, _| (single(t) && has(t, "L")).then(|| t.replace('\n', " FMAX\n"))),
    ("another feed", |t, d| change(t, d, "F", is_block, |v| Some(v + 10))),
    ("no feed", |t, _| (single(t) && !t.contains("FMAX")).then(|| without(t, 'F')).flatten()),
    ("machine coordinates lost", |t, _| t.contains(" M91").then(|| t.replace(" M91", ""))),
    ("machine coordinates instead", |t, _| (single(t) && has(t, "L")).then(|| t.replace('\n', " M91\n"))),
    ("another tool", |t, _| t.contains("TOOL CALL 1").then(|| t.replace("TOOL CALL 1", "TOOL CALL 2"))),
    ("the tool lost", |t, _| t.contains("TOOL CALL 1").then(|| t.replace("TOOL CALL", "TOOL DEF").replace(" Z", ""))),
    ("another speed", |t, d| change(t, d, "S", |l| has(l, "TOOL"), |v| Some(v + 10))),
    ("another tolerance", |t, _| t.contains("32.1 T0.0").then(|| t.replace("32.1 T0.0", "32.1 T0.1"))),
    ("the tolerance lost", |t, _| {
        t.contains("32.1 T").then(|| format!("{}32.1\n", t.split("32.1").next().unwrap_or(t)))
    }),
    ("another preset", |t, _| exchanged(t, "Q339=+1", "Q339=+2")),
    ("a wait of another time", |t, _| t.contains("DWELL 1").then(|| t.replace("DWELL 1", "DWELL 2"))),
    ("half a wait", |t, _| t.contains("DWELL TIME").then(|| t.lines().skip(1).map(|l| format!("{l}\n")).collect())),
    ("another unit", |t, _| exchanged(t, " MM\n", " INCH\n")),
    ("the spindle stopped, too", |t, _| t.contains("STOP").then(|| t.replace("STOP", "M0"))),
    ("another function", |t, _| exchanged(t, "M8", "M9")),
    ("no end", |t, _| less(t, "END")),
    ("another number", |t, _| t.starts_with('1').then(|| format!("1{t}"))),
    ("a block twice", |t, _| (single(t) && t.starts_with('1')).then(|| format!("{t}{t}"))),
    ("compensation", |t, _| t.contains(" R0").then(|| t.replace(" R0", " RL"))),
];

/// Is this a block that begins with `word`?
fn has(line: &str, word: &str) -> bool {
    line.split(' ').nth(1) == Some(word)
}

fn is_block(line: &str) -> bool {
    ["L", "C", "CC", "CP"].iter().any(|word| has(line, word))
}

fn exchanged(text: &str, a: &str, b: &str) -> Option<String> {
    text.contains(a).then(|| text.replacen(a, b, 1)).or_else(|| text.contains(b).then(|| text.replacen(b, a, 1)))
}

/// Without the last block of this kind; the numbers stay right.
fn less(text: &str, word: &str) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let at = lines.iter().rposition(|line| has(line, word))?;
    let mut left = String::new();
    for (i, line) in lines.iter().enumerate().filter(|(i, _)| *i != at) {
        let (number, rest) = line.split_once(' ')?;
        let number: u64 = number.parse().ok()?;
        left += &format!("{} {rest}\n", number - u64::from(i > at));
    }
    Some(left)
}

fn single(text: &str) -> bool {
    text.ends_with('\n') && text.lines().count() == 1
}

fn is_arc(line: &str) -> bool {
    line.starts_with("G2 ") || line.starts_with("G3 ")
}

fn is_move(line: &str) -> bool {
    is_arc(line) || ["G0 ", "G1 ", "G33 ", "G53 "].iter().any(|word| line.starts_with(word))
}

fn is_act(line: &str) -> bool {
    is_move(line) || line.starts_with("G4 ") || line.starts_with(['T', 'S', 'M'])
}

/// Changes a number, in ten-thousandths, of one of the lines that `fits` takes.
fn change(
    text: &str,
    dice: &mut Dice,
    letters: &str,
    fits: fn(&str) -> bool,
    to: fn(i64) -> Option<i64>,
) -> Option<String> {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let at = dice.roll(lines.len());
    let line = lines.get(at).filter(|line| fits(line) && !line.starts_with('('))?;
    let words: Vec<&str> = line.trim_end().split(' ').collect();
    let places: Vec<usize> = (0..words.len()).filter(|i| words[*i].starts_with(|c| letters.contains(c))).collect();
    let place = *places.get(dice.roll(places.len()))?;
    let (letter, number) = words[place].split_at(1);
    let units = (number.parse::<f64>().ok()? * 1e4).round();
    // Finer numbers would be rounded here.
    if (units / 1e4 - number.parse::<f64>().ok()?).abs() > 1e-9 {
        return None;
    }
    let new = to(units as i64)? as f64 / 1e4;
    let mut words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
    words[place] = format!("{letter}{new}");
    let mut lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
    lines[at] = words.join(" ") + "\n";
    Some(lines.concat())
}

fn swap(text: &str, a: &str, b: &str) -> Option<String> {
    if text.starts_with(a) {
        return single(text).then(|| text.replacen(a, b, 1));
    }
    (text.starts_with(b) && single(text)).then(|| text.replacen(b, a, 1))
}

fn without(text: &str, letter: char) -> Option<String> {
    let at = text.find(&format!(" {letter}"))?;
    let rest = &text[at + 1..];
    let end = rest.find([' ', '\n'])?;
    Some(format!("{}{}", &text[..at], &rest[end..]))
}

/// Another one of the lines that are one word, or begin with it.
fn word(text: &str, dice: &mut Dice, all: &[&str]) -> Option<String> {
    let is = |line: &str, word: &str| line == word || line.starts_with(&format!("{word} "));
    let lines: Vec<&str> = text.lines().collect();
    if lines.first().is_some_and(|line| *line == "%" || line.starts_with("(partc")) {
        return None;
    }
    let (at, own) =
        lines.iter().enumerate().find_map(|(i, line)| Some((i, all.iter().find(|word| is(line, word))?)))?;
    let others: Vec<&&str> = all.iter().filter(|word| *word != own).collect();
    let other = others[dice.roll(others.len())];
    let mut lines: Vec<String> = lines.iter().map(|line| format!("{line}\n")).collect();
    lines[at] = lines[at].replacen(own, other, 1);
    Some(lines.concat())
}

fn lost(text: &str, _: &mut Dice, all: &[&str]) -> Option<String> {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let at = lines.iter().position(|line| all.contains(&line.trim_end()))?;
    Some(lines.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, line)| *line).collect())
}

fn of(seed: u64) -> (Dice, Stream) {
    for_target(seed, None)
}

fn for_target(seed: u64, target: Option<&str>) -> (Dice, Stream) {
    let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95) | 1);
    let mut stream = match target {
        Some(target) => stream_for(&mut dice, LENGTH, target),
        None => stream(&mut dice, LENGTH),
    };
    // What a unit is.
    stream.settings.output.decimals.length = Some(4);
    (dice, stream)
}

#[test]
fn every_fault_in_the_text_is_noticed() {
    let all = notices(FAULTS, None);
    println!("{all} faults in the text of {} kinds, all of them noticed", FAULTS.len());
    assert!(all >= 1_000);
}

#[test]
fn every_fault_in_a_dialog_is_noticed() {
    let all = notices(DIALOG, Some("heidenhain"));
    println!("{all} faults in a dialog of {} kinds, all of them noticed", DIALOG.len());
    assert!(all >= 700);
}

/// Puts faults of each kind into printed streams; how many were noticed, all of them.
fn notices(faults: &[(&str, Fault)], target: Option<&str>) -> usize {
    let mut all = 0;
    for (kind, (name, fault)) in faults.iter().enumerate() {
        let mut found = 0;
        for seed in (1..).map(|n: u64| n + kind as u64 * 1_000_000).take(MOST_SEEDS as usize) {
            let (dice, stream) = for_target(seed, target);
            let Some(usual) = validate(&stream, None, &mut as_it_is) else { continue };
            let places: Vec<usize> =
                (0..usual.pieces.len()).filter(|n| fault(&usual.pieces[*n], &mut dice.clone()).is_some()).collect();
            let Some(at) = places.get(dice.clone().roll(places.len())).copied() else { continue };
            let mut roll = dice.clone();
            let wrong = fault(&usual.pieces[at], &mut roll).filter(|text| *text != usual.pieces[at]);
            let Some(wrong) = wrong else { continue };
            let mut put = |n: usize, _: &str| (n == at).then(|| wrong.clone());
            let outcome = validate(&stream, None, &mut put).expect("the printer does the same again");
            assert!(
                outcome.mismatch.is_some(),
                "{name}, seed {seed}: {:?} instead of {:?} is not noticed\n{}",
                wrong,
                usual.pieces[at],
                usual.pieces.concat()
            );
            found += 1;
            if found == EACH {
                break;
            }
        }
        assert!(found >= EACH.min(10), "{name}: only {found} faults");
        all += found;
    }
    all
}

/// The texts of two items change places.
#[test]
fn every_wrong_order_is_noticed() {
    let mut found = 0;
    for seed in 1.. {
        let (mut dice, stream) = of(seed);
        let Some(usual) = validate(&stream, None, &mut as_it_is) else { continue };
        let at = 1 + dice.roll(usual.pieces.len() - 2);
        let [a, b] = [&usual.pieces[at], &usual.pieces[at + 1]];
        if a == b || a.is_empty() || b.is_empty() || a.starts_with('(') || b.starts_with('(') {
            continue;
        }
        let mut put =
            |n: usize, _: &str| [(at, b), (at + 1, a)].iter().find(|(i, _)| *i == n).map(|(_, t)| (*t).clone());
        let outcome = validate(&stream, None, &mut put).expect("the printer does the same again");
        assert!(outcome.mismatch.is_some(), "seed {seed}: {a:?} behind {b:?} is not noticed");
        found += 1;
        if found == 200 {
            break;
        }
    }
}

/// What would make the printer leave something out, or print it wrong, in front of the item of this number.
fn disturbance(stream: &Stream, kind: usize, dice: &mut Dice) -> Option<(usize, Disturbance)> {
    let n = 1 + dice.roll(stream.items.len());
    let item = &stream.items[n - 1];
    let Item::Move(mv) = item else {
        return match (item, kind) {
            (Item::Function(Function::Plane(plane)), 1) => Some((n, Disturbance::Plane(*plane))),
            (Item::Function(Function::Spindle(_)), 6) => Some((n, Disturbance::CuttingSpeed(false))),
            _ => None,
        };
    };
    let disturbance = match kind {
        0 if !mv.machine => {
            let axes: Vec<Axis> = mv.axes.iter().collect();
            let axis = dice.of(&axes);
            Disturbance::Place(axis, mv.end.get(axis)?)
        }
        1 => match &mv.path {
            Path::Arc(arc, _) => Disturbance::Plane(arc.plane),
            _ => return None,
        },
        2 => Disturbance::Feed(mv.path.feed()?),
        3 => Disturbance::FeedKind(mv.path.feed()?),
        4 if stream.settings.machine.kind == crate::machine::MachineKind::Lathe => Disturbance::Diameter,
        5 => Disturbance::Decimals(dice.of(&[0, 1, 2])),
        7 => Disturbance::Side(mv.side),
        8 => Disturbance::Trusted,
        _ => return None,
    };
    Some((n, disturbance))
}

#[test]
fn every_fault_of_the_printer_is_noticed() {
    const KINDS: usize = 9;
    let mut all = 0;
    for kind in 0..KINDS {
        let mut found = 0;
        for seed in (1..).map(|n: u64| n + kind as u64 * 1_000_000).take(MOST_SEEDS as usize) {
            let (mut dice, stream) = of(seed);
            let Some(disturbance) = disturbance(&stream, kind, &mut dice) else { continue };
            let Some(usual) = validate(&stream, None, &mut as_it_is) else { continue };
            let Some(outcome) = validate(&stream, Some(disturbance), &mut as_it_is) else { continue };
            // An arc that does not close any more becomes lines, which are right; and a word more says nothing new.
            let lines = |piece: &str| !piece.lines().any(is_arc);
            let words = |piece: &str| piece.split_whitespace().count();
            let more = |now: &str, before: &str| !matches!(kind, 4 | 5) && words(now) >= words(before);
            let mut pairs = outcome.pieces.iter().zip(&usual.pieces).filter(|(a, b)| a != b);
            if pairs.next().is_none_or(|(now, before)| lines(now) && !lines(before) || more(now, before)) {
                continue;
            }
            assert!(
                outcome.mismatch.is_some(),
                "seed {seed}: {disturbance:?} is not noticed: {:?}",
                outcome.pieces.iter().zip(&usual.pieces).find(|(a, b)| a != b)
            );
            found += 1;
            if found == 2 * EACH {
                break;
            }
        }
        println!("kind {kind}: {found} faults of the printer, all of them noticed");
        assert!(found >= 10, "kind {kind}: only {found} faults");
        all += found;
    }
    assert!(all >= 400, "only {all}");
}
