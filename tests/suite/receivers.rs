//! The targets: one registry, no word outside their tables.

use std::fs;
use std::path::Path;

use serde_json::json;

use partc::internals::diag::{Diags, Severity};
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::emit::Printer;
use partc::internals::ir::motion::{Move, Place, Sink};
use partc::internals::ir::{Function, Origin, Pos, Tap};
use partc::internals::machine::settings::{Quantity, ToolChange};
use partc::internals::machine::{Settings, schema};
use partc::internals::target::{self, Target};
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};

use super::book::{Case, cases};
use super::cli_run::Folder;
use super::common::{compile_bytes, settings};
use super::grbl_reader::{self, Event, Feed, Rules};

#[test]
fn command_line_configuration_and_registry_know_the_same_targets() {
    let names: Vec<&str> = target::ALL.iter().map(|target| target.name).collect();
    assert_eq!(target::NAMES, names[..]);
    let key = &schema::schema()["properties"]["output"]["properties"]["target"];
    assert_eq!(key["enum"], json!(names));
    assert_eq!(key["default"], json!(names[0]));
    assert_eq!(Settings::default().output.target, target::ALL[0]);
    for name in &names {
        assert_eq!(target::find(name).expect("a target").name, *name);
        assert_eq!(settings(&format!("[output]\ntarget = \"{name}\"")).output.target.name, *name);
    }
    let folder = Folder::new("target_names");
    let offered = format!("possible values: {}]", names.join(", "));
    folder.run(&["compile", "--target", "nobody", "A.H"]).exits(2).says(&offered);
}

/// The lines of a SINUMERIK program behind the head.
fn body(target: &str, configuration: &str, program: &str) -> String {
    let mut settings = settings(configuration);
    settings.output.target = target::find(target).expect("a target");
    let compiled = compile_bytes("PART.MPF", program.as_bytes().to_vec(), "sinumerik", &settings, &NoFiles);
    assert!(!compiled.has_errors(), "{:#?}", compiled.rendered);
    let lines = compiled.output.lines().skip_while(|line| !line.contains("G80")).skip(1);
    lines.collect::<Vec<_>>().join("\n")
}

const PART: &str = "G0 X40 Y10 Z-1\nG3 X40 Y10 Z-7 I-10 J0 TURN=2 F100\nG3 X20 Y30 I-20 J0\nG4 F4000\nM30\n";

#[test]
fn grbl_has_halves_instead_of_turns_and_short_waits() {
    let halves = "G0 X40 Y10 Z-1\n\
        G3 X20 Y10 Z-2 I-10 J0 F100\nG3 X40 Y10 Z-3 I10 J0\n\
        G3 X20 Y10 Z-4 I-10 J0\nG3 X40 Y10 Z-5 I10 J0\n\
        G3 X20 Y10 Z-6 I-10 J0\nG3 X40 Y10 Z-7 I10 J0\n\
        G3 X20 Y30 I-20 J0\nG4 P3000\nG4 P1000\nM30";
    assert_eq!(body("grbl", "", PART), halves);
    let turns = "G0 X40 Y10 Z-1\nG3 X40 Y10 Z-7 I-10 J0 P3 F100\nG3 X20 Y30 I-20 J0\nG4 P3000\nG4 P1000\nM30";
    assert_eq!(body("grblhal", "", PART), turns);
}

#[test]
fn a_tool_is_changed_by_hand_where_nothing_else_changes_it() {
    let stop = "[output]\ntool_change = \"stop\"";
    let program = "T3 M6\nG0 X0 Y0 Z5\nT0 M6\nM30\n";
    let by_hand = "M5\n(change to tool 3)\nM0\nG0 X0 Y0 Z5\nM5\n(take the tool out)\nM0\nM30";
    assert_eq!(body("grbl", stop, program), by_hand);
    assert_eq!(body("grblhal", "", program), "T3 M6\nG0 X0 Y0 Z5\nT0 M6\nM30");
}

/// What is not confirmed of a receiver is refused with its block and with what to do.
#[test]
fn what_a_receiver_may_not_have_is_refused() {
    let ninth = |name: &str| target::find(name).expect("a target").offset(9);
    for name in ["fanuc", "haas", "mazak", "centroid", "mach3", "uccnc", "okuma", "klipper", "marlin"] {
        let mut wanted = vec![("G1 A90 F100", "", "O9309")];
        let compensates = target::find(name).expect("a target").compensation.is_some();
        wanted.extend((!compensates).then_some(("T1 D1\nM6\nG41 G1 X9 Y9 F100", CONTROL, "O9308")));
        wanted.extend(ninth(name).is_none().then_some(("G509", "", "O9310")));
        for (block, configuration, code) in wanted {
            let mut settings = settings(configuration);
            settings.output.target = target::find(name).expect("a target");
            let text = format!("G0 X0 Y0 Z5\n{block}\nM30\n").into_bytes();
            let compiled = compile_bytes("PART.MPF", text, "sinumerik", &settings, &NoFiles);
            let found = compiled.findings.iter().find(|found| found.code.id == code);
            assert!(found.is_some_and(|found| found.help.is_some()), "{name}, {block}: {:#?}", compiled.rendered);
        }
    }
}

/// Work offsets behind the ninth are those that the target has.
#[test]
fn work_offsets_are_those_of_the_target() {
    let print = |name: &str, configuration: &str, word: &str| {
        let mut settings = settings(configuration);
        settings.output.target = target::find(name).expect("a target");
        let text = format!("{word}\nG0 X0 Y0 Z5\nM30\n").into_bytes();
        compile_bytes("PART.MPF", text, "sinumerik", &settings, &NoFiles)
    };
    for (name, word, printed, told) in [
        ("fanuc", "G510", "G54.1 P4", true),
        ("fanuc", "G554", "G54.1 P48", true),
        ("haas", "G599", "G154 P93", true),
        ("sinumerik", "G54", "G54", false),
        ("sinumerik", "G507", "G507", true),
        ("sinumerik", "G599", "G599", true),
        ("okuma", "G508", "G15 H8", true),
        ("linuxcnc", "G508", "G59.2", false),
    ] {
        let compiled = print(name, "", word);
        let said = compiled.findings.iter().any(|found| found.code.id == "O4003" && found.message.ends_with(printed));
        assert!(compiled.output.lines().any(|line| line == printed), "{name} {word}: {}", compiled.output);
        assert_eq!(said, told, "{name} {word}: {:?}", compiled.rendered);
    }
    for (name, configuration, code) in [
        ("linuxcnc", "", "P9014"),
        ("mazak", "", "P9014"),
        ("mazak", "[datums]\nG510 = \"G54.1 P4\"", "O9310"),
        ("fanuc", "[datums]\nG510 = \"G154 P49\"", "O9310"),
    ] {
        let compiled = print(name, configuration, "G510");
        assert!(compiled.findings.iter().any(|found| found.code.id == code), "{name}: {:?}", compiled.rendered);
    }
    let configured = print("fanuc", "[datums]\nG510 = \"g54.1 p7\"", "G510");
    assert!(configured.output.contains("\nG54.1 P7\n"), "{}", configured.output);
    for word in ["G54.1 P0", "G54.1 P49", "G154 P100", "G504", "G5.5", "G54.1", "G600", "G54.1 P+1"] {
        let errors =
            partc::internals::machine::config::from_toml(&format!("[datums]\nG510 = \"{word}\""), "partc.toml");
        let errors = errors.expect_err(word);
        assert!(errors[0].message.contains("G54.1 P1 to P48"), "{word}: {errors:?}");
    }
}

const CONTROL: &str = "[control]\ntool_change = \"m6\"\n[output]\ncompensation = \"control\"";

/// A receiver acts on some characters as they arrive.
#[test]
fn comments_do_nothing_to_a_receiver() {
    let program = "G0 X0 Y0 Z5 ; stop! go~ why? 100%\nM30\n";
    assert!(body("grbl", "", program).contains("(stop. go. why. 100#)"), "{}", body("grbl", "", program));
    assert!(body("linuxcnc", "", program).contains("(stop! go~ why? 100#)"));
}

/// Single precision cannot tell a very short arc from a full circle, nor a very flat one from another.
#[test]
fn arcs_beyond_single_precision_are_lines() {
    let short = "G0 X100 Y0 Z5\nG2 X100.001 Y0 CR=5 F100\nM30\n";
    assert!(body("linuxcnc", "", short).contains("G2 X100.001"));
    assert!(body("grbl", "", short).contains("G1 X100.001"));
    let flat = "G0 X0 Y0 Z5\nG2 X10 Y0 CR=2000 F100\nM30\n";
    assert!(body("linuxcnc", "", flat).contains("G2 X10"));
    let lines = body("grbl", "", flat);
    assert!(!lines.contains("G2") && lines.contains("G1 X10 Y0"), "{lines}");
}

#[test]
fn the_list_of_targets_is_what_the_document_shows() {
    let folder = Folder::new("target_list");
    let list = folder.run(&["targets"]).exits(0).quietly().out.clone();
    let document = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/targets.md");
    let document = fs::read_to_string(document).expect("docs/targets.md");
    assert!(document.contains(&list), "docs/targets.md is to hold this table:\n{list}");
    let json = folder.run(&["targets", "--format", "json"]).exits(0).json();
    assert_eq!(json[0]["name"], json!(target::NAMES[0]));
    assert_eq!(json[0]["abilities"]["threads"], json!("G33"));
}

/// A literal in the printer core would be a word that a table cannot change.
#[test]
fn no_word_of_a_target_stands_in_the_printer() {
    let emit = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/emit");
    let core = ["arc.rs", "comment.rs", "compensation.rs", "line.rs", "line_writer.rs", "modal.rs", "printer.rs"];
    let parts = fs::read_dir(emit.join("printer")).expect("a folder").map(|entry| entry.expect("a file").path());
    for path in core.iter().map(|name| emit.join(name)).chain(parts) {
        let text = fs::read_to_string(&path).expect("a readable source");
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
            let words = line.split('"').skip(1).step_by(2).any(is_word);
            let letters = line.split("b'").skip(1).any(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()));
            assert!(!words && !letters, "{}: {line}", path.display());
        }
    }
}

/// `G40`, ` F`, `%`
fn is_word(text: &str) -> bool {
    let text = text.trim();
    let digits = text.trim_start_matches(|c: char| c.is_ascii_uppercase());
    let letters = text.len() - digits.len();
    text == "%" || letters == 1 && digits.chars().all(|c| c.is_ascii_digit() || c == '.')
}

/// The one run of a program, printed for several targets.
struct Both<'a>(Vec<Printer<'a>>);

impl Sink for Both<'_> {
    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        self.0.iter_mut().for_each(|printer| printer.tap(tap, place, origin));
    }

    fn movement(&mut self, mv: &Move, origin: &Origin) {
        self.0.iter_mut().for_each(|printer| printer.movement(mv, origin));
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.0.iter_mut().for_each(|printer| printer.function(function, origin));
    }

    fn lost(&mut self, origin: &Origin) {
        self.0.iter_mut().for_each(|printer| printer.lost(origin));
    }

    fn begins_at(&mut self, at: &Pos) {
        self.0.iter_mut().for_each(|printer| printer.begins_at(at));
    }
}

/// What a program came to on one target.
struct Printed {
    text: String,
    /// The last printed place in mm.
    unit: f64,
    codes: Vec<&'static str>,
    failed: bool,
}

/// A golden case on all `targets`; `None` where its own errors leave nothing to print.
fn print_for(case: &Case, targets: &[&'static Target]) -> Option<Vec<Printed>> {
    let (base, name) = (case.settings(), case.file.clone());
    let text = Box::new(Memory::new(case.program.clone()));
    let session = Session::new(Opened { name: name.clone(), identity: name.clone(), text });
    let dialect = dialect::find(&case.dialect).expect("a dialect");
    let of = |target: &&'static Target| {
        let mut settings = dialect.settings(&base).into_owned();
        settings.output.target = target;
        // Hands change the tools and set up their lengths, as it has to be for the simplest target.
        settings.output.tool_change = ToolChange::Stop;
        settings.output.tool_length = Some(false);
        settings
    };
    let each: Vec<Settings> = targets.iter().map(of).collect();
    let mut texts: Vec<Vec<u8>> = vec![Vec::new(); targets.len()];
    let found: Vec<Diags> = targets.iter().map(|_| Diags::default()).collect();
    let printers = each.iter().zip(&found).zip(&mut texts);
    let mut both = Both(printers.map(|((s, d), t)| Printer::new(s, &name, d, t, None)).collect());
    session.lower(dialect, &base, case, &mut both);
    both.0.into_iter().for_each(|printer| printer.finish(0).expect("memory takes everything"));
    let unit = 0.1f64.powi(i32::from(base.output.places(Quantity::Length)));
    let printed = texts.into_iter().zip(found).map(|(text, found)| {
        let failed = found.has_errors();
        let list = found.into_sorted();
        assert!(list.iter().all(|d| d.code.id.starts_with(['O', 'P']) && d.label.loc.line >= 1), "{list:#?}");
        let refusals = list.iter().filter(|d| d.code.severity == Severity::Error && d.code.id >= "O93");
        refusals.for_each(|d| assert!(d.help.is_some(), "{}: no help", d.code.id));
        let codes = list.iter().map(|d| d.code.id).collect();
        Printed { text: String::from_utf8(text).expect("plain text"), unit, codes, failed }
    });
    let printed = printed.collect();
    (!session.diags.has_errors()).then_some(printed)
}

/// What a full-precision control of the same words takes: it reads the text of LinuxCNC.
const LINUXCNC: Rules = Rules {
    length: 80,
    digits: 99,
    m: &[],
    more_m: true,
    more_offsets: true,
    turns: true,
    most_tool: f64::INFINITY,
    double: true,
    streamed: false,
};

const GRBLHAL: Rules = Rules {
    length: 256,
    digits: 8,
    m: &[],
    more_m: true,
    more_offsets: true,
    turns: true,
    most_tool: 2_147_483_647.0,
    double: true,
    streamed: true,
};

/// The events of a program behind its head, without the words whose effect every move shows.
fn events(text: &str, rules: &Rules) -> Result<Vec<Event>, String> {
    // The frame, the radii of a lathe and how corners are taken are words of LinuxCNC alone.
    let corners = |line: &str| line.starts_with("G61") || line.starts_with("G64");
    let lines = text.lines().filter(|line| *line != "%" && !corners(line));
    let plain = |line: &str| match line {
        _ if line.starts_with('(') => line.to_owned(),
        _ => line.split(" G6").next().unwrap_or(line).replacen("G18 G8 ", "G18 ", 1),
    };
    let body: String = lines.map(|line| format!("{}\n", plain(line))).collect();
    let mut events = grbl_reader::read(&body, rules)?;
    let head = events.iter().position(|event| matches!(event, Event::Words(code) if code.contains("G80")));
    events.drain(..head.map_or(0, |at| at + 1));
    let shown = ["G17", "G18", "G19", "G93", "G94"];
    events.retain(|event| !matches!(event, Event::Words(code) if shown.contains(&code.as_str())));
    Ok(events)
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(&b).all(|(a, b)| a.is_nan() && b.is_nan() || (a - b).abs() < 1e-9)
}

/// Compares what two targets do, event by event: what one says in one block another may say in several.
struct Compare<'a> {
    rest: &'a [Event],
    at: [f64; 3],
    unit: f64,
}

impl<'a> Compare<'a> {
    fn next(&mut self) -> Result<&'a Event, String> {
        let (first, rest) = self.rest.split_first().ok_or("the other target ends earlier")?;
        self.rest = rest;
        Ok(first)
    }

    fn all(&mut self, wanted: &[Event]) -> Result<(), String> {
        let mut wanted = wanted;
        while let Some(first) = wanted.first() {
            let taken = match first {
                Event::Comment(_) => self.comments(wanted),
                Event::Words(code) => self.words(code).map(|()| 1),
                Event::Straight { end, .. } => self.straight(first, *end).map(|()| 1),
                Event::Arc { end, .. } => self.arc(first, *end).map(|()| 1),
            };
            wanted = &wanted[taken.map_err(|why| format!("{first:?}: {why}"))?..];
        }
        if self.rest.is_empty() { Ok(()) } else { Err(format!("the other target goes on: {:?}", self.rest[0])) }
    }

    /// A comment may be cut elsewhere, and characters that the receiver acts on are points.
    fn comments(&mut self, wanted: &[Event]) -> Result<usize, String> {
        let joined = |events: &[Event]| {
            let texts = events.iter().map_while(|event| match event {
                Event::Comment(text) => Some(text.as_str()),
                _ => None,
            });
            let texts: Vec<&str> = texts.collect();
            (texts.len(), texts.concat().replace(' ', "").replace(['!', '?', '~'], "."))
        };
        let ((count, wanted), (found, text)) = (joined(wanted), joined(self.rest));
        self.rest = &self.rest[found..];
        if wanted == text { Ok(count) } else { Err(text) }
    }

    fn words(&mut self, wanted: &str) -> Result<(), String> {
        let seconds = |code: &str| code.strip_prefix("G4P").and_then(|text| text.parse::<f64>().ok());
        let mut waited = 0.0;
        loop {
            let Event::Words(code) = self.next()? else { return Err("no words".to_owned()) };
            let (Some(all), Some(part)) = (seconds(wanted), seconds(code)) else {
                return if code == wanted { Ok(()) } else { Err(code.clone()) };
            };
            waited += part;
            if (waited - all).abs() < 1e-6 {
                return Ok(());
            }
        }
    }

    fn straight(&mut self, wanted: &Event, to: [f64; 3]) -> Result<(), String> {
        let found = self.next()?;
        let (Event::Straight { rapid, machine, feed, .. }, Event::Straight { rapid: r, machine: m, end, feed: f }) =
            (wanted, found)
        else {
            return Err(format!("{found:?}"));
        };
        // The feed of a rapid move counts for nothing.
        if (rapid, machine) != (r, m) || !near(to, *end) || !rapid && feed != f {
            return Err(format!("{found:?}"));
        }
        self.at = if *machine { [f64::NAN; 3] } else { to };
        Ok(())
    }

    /// The blocks that make up one arc: they stay on it, turn as far, and take as long.
    fn arc(&mut self, wanted: &Event, to: [f64; 3]) -> Result<(), String> {
        let Event::Arc { plane: [a, b, c], center, sweep, feed: Feed(feed, by_time), .. } = *wanted else {
            unreachable!("asked for arcs only")
        };
        let (start, mut turned, mut time) = (self.at, 0.0, 0.0);
        let radius = (to[a] - center[0]).hypot(to[b] - center[1]);
        let seen = |p: [f64; 3]| [p[a] - center[0], p[b] - center[1]];
        let room = 4.0 * self.unit;
        while !near(self.at, to) || (turned - sweep).abs() > 2.0 * room / radius + 1e-9 {
            let found = self.next()?;
            let (end, Feed(f, t)) = match *found {
                Event::Arc { plane, center: own, sweep, end, feed } => {
                    let off = (own[0] - center[0]).hypot(own[1] - center[1]);
                    if plane != [a, b, c] || off > room {
                        return Err(format!("another circle: {found:?}"));
                    }
                    turned += sweep;
                    (end, feed)
                }
                Event::Straight { rapid: false, machine: false, end, feed } => {
                    let (from, to) = (seen(self.at), seen(end));
                    turned += (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]);
                    (end, feed)
                }
                _ => return Err(format!("{found:?}")),
            };
            if t != by_time || !by_time && f != feed {
                return Err(format!("another feed: {found:?}"));
            }
            time += 1.0 / f;
            let off = (seen(end)[0].hypot(seen(end)[1]) - radius).abs();
            let along = start[c] + (to[c] - start[c]) * turned / sweep;
            if off > room || (end[c] - along).abs() > room + (to[c] - start[c]).abs() * room / radius {
                return Err(format!("off the arc by {off}, {}: {found:?}", end[c] - along));
            }
            self.at = end;
        }
        if by_time && (time * feed - 1.0).abs() > 1e-3 {
            return Err(format!("takes {time} minutes"));
        }
        Ok(())
    }
}

/// What the golden programs of one dialect came to on a target.
#[derive(Debug, Default, Clone, Copy)]
struct Count {
    printed: usize,
    refused: usize,
}

/// Prints one golden program for every target, and has each output read and compared with the first one.
fn judge(case: &Case, counts: &mut [Count]) -> Result<(), String> {
    let all = [target::ALL[0]].into_iter().chain(JUDGED.iter().map(|(name, _)| target::find(name).expect("a target")));
    let Some(printed) = print_for(case, &all.collect::<Vec<_>>()) else { return Ok(()) };
    let (base, others) = printed.split_first().expect("the default target");
    for ((other, (name, rules)), count) in others.iter().zip(JUDGED).zip(counts) {
        let says = |who: &'static str| move |why: String| format!("{}: {who}: {why}", case.name);
        if base.failed || other.failed {
            let own = other.codes.iter().any(|code| *code >= "O93" && code.starts_with('O'));
            if !own && !base.failed {
                return Err(says(name)(format!("fails with {:?}", other.codes)));
            }
            count.refused += 1;
            continue;
        }
        let found = events(&other.text, rules).map_err(says(name))?;
        // S counts turns on these receivers, which is what G97 says to LinuxCNC on a lathe.
        let lines = base.text.lines().map(|line| line.strip_prefix("G97 ").unwrap_or(line));
        let text: String = lines.flat_map(|line| [line, "\n"]).collect();
        let wanted = events(&text, &LINUXCNC).map_err(says("linuxcnc"))?;
        let mut compare = Compare { rest: &found, at: [0.0; 3], unit: base.unit };
        compare.all(&wanted).map_err(says(name))?;
        count.printed += 1;
    }
    Ok(())
}

/// Targets whose receivers have a reader here.
const JUDGED: [(&str, &Rules); 2] = [("grbl", &grbl_reader::GRBL), ("grblhal", &GRBLHAL)];

/// Every golden program on every target: taken by the receiver and moving alike, or refused with a code of the target.
#[test]
fn golden_programs_move_alike_on_every_target_or_are_refused() {
    let list = cases("");
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    let counts = std::thread::scope(|scope| {
        let part = |i: usize| {
            let list = &list;
            move || {
                let mut counts = [Count::default(); JUDGED.len()];
                let mine = list.iter().skip(i).step_by(threads);
                let wrong: Vec<String> = mine.filter_map(|case| judge(case, &mut counts).err()).collect();
                (counts, wrong)
            }
        };
        let running: Vec<_> = (0..threads).map(|i| scope.spawn(part(i))).collect();
        running.into_iter().map(|thread| thread.join().expect("no case panics")).collect::<Vec<_>>()
    });
    let wrong: Vec<&String> = counts.iter().flat_map(|(_, wrong)| wrong).collect();
    assert!(wrong.is_empty(), "{} programs: {:#?}", wrong.len(), &wrong[..wrong.len().min(20)]);
    for (i, (name, _)) in JUDGED.iter().enumerate() {
        let printed: usize = counts.iter().map(|(counts, _)| counts[i].printed).sum();
        let refused: usize = counts.iter().map(|(counts, _)| counts[i].refused).sum();
        println!("{name}: {printed} programs printed, {refused} refused");
        assert!(printed > 800 && refused > 200, "{name}: {printed} printed, {refused} refused");
    }
}
