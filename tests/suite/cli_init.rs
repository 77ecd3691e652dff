//! `partc init`, and what check and compile say of keys that a configuration lacks.

use partc::diagnostics::{Diagnostic, Severity};

use super::book;
use super::cli_run::{Folder, PART, RADIUS, WRONG};

/// Everything that `partc init` wrote with its blanks filled in, as nobody should do who has a machine.
pub(super) fn filled(config: &str) -> String {
    let (mut text, mut section) = (String::new(), String::new());
    for line in config.lines() {
        let open = line
            .strip_prefix('#')
            .filter(|rest| rest.starts_with('[') || rest.contains(" = ") && !rest.starts_with(' '));
        let line = open.unwrap_or(line);
        let (entry, remark) = line.split_once(" # ").unwrap_or((line, ""));
        let entry = entry.trim_end();
        if entry.starts_with('[') {
            entry.clone_into(&mut section);
        }
        if let Some((head, fields)) = entry.strip_suffix(" }").and_then(|rest| rest.split_once(" = { ")) {
            // A tool in one line.
            let field = |field: &str| match field.trim_end().strip_suffix(" =") {
                Some(key) => format!("{key} = {}", value(&section, key, "")),
                None => field.to_owned(),
            };
            let fields: Vec<String> = fields.split(", ").map(field).collect();
            text += &format!("{head} = {{ {} }}\n", fields.join(", "));
            continue;
        }
        text += entry;
        if entry.ends_with('=') {
            text += " ";
            text += &value(&section, entry.trim_end_matches(['=', ' ']), remark);
        }
        text.push('\n');
    }
    text
}

/// Some value for a key, of those that its remark names.
fn value(section: &str, key: &str, remark: &str) -> String {
    if let Some(choice) = remark.strip_prefix('"').and_then(|rest| rest.split_once('"')) {
        return format!("\"{}\"", choice.0);
    }
    if let Some((choice, _)) = remark.strip_prefix("{ ").and_then(|rest| rest.split_once(" }")) {
        return format!("{{ {choice} }}");
    }
    // Programs of one folder may be of several machines: the order of the axes that is in force stands last, and stays.
    if let Some(orders) = remark.split("; ").next().filter(|orders| orders.starts_with('[')) {
        return orders.rsplit(" or ").next().unwrap_or(orders).to_owned();
    }
    match key {
        "radius" => "1.0",
        "length" => "100.0",
        "tip_angle" => "118.0",
        "orientation" => "3",
        "width" => "3.0",
        "number" => "1",
        "feed" | "rapid_feed" => "1000.0",
        "diameter_axis" => "\"X\"",
        // Others than 0 can be divided by.
        _ if section == "[variables]" => "1.0",
        _ if key.starts_with("roots.") => "\".\"",
        _ if remark.starts_with("a work offset") => "\"G54\"",
        _ if remark.starts_with("true or false") => "true",
        _ => "0.0",
    }
    .to_owned()
}

/// A Klartext program that needs the radius of tool 5 for its path, an M function, a feed, and a tool by its name.
const NEEDS: &str = "0 BEGIN PGM NEEDS MM\n1 TOOL CALL 5 Z S2000\n2 L X+0 Y+0 R0 FMAX M3\n3 L X+0 Y+0 R0 F AUTO M77\n\
                     4 L X+10 Y+10 RL F200\n5 L X+50 RL\n6 L X+60 Y+0 R0\n7 TOOL CALL \"MILL_D8\" Z S3000\n\
                     8 L X+0 Y+0 R0 FMAX M3\n9 FN 0: Q1 = Q50\n10 L Z+50 FMAX M30\n11 END PGM NEEDS MM\n";

#[test]
fn one_round_answers_everything() {
    let folder = Folder::new("init").with(&[("shop/A.H", NEEDS), ("shop/B.H", PART)]);
    folder.run(&["compile", "shop/A.H"]).exits(1);
    folder.run(&["init", "shop"]).exits(0).says("2 programs read, 1 compiles now, 2 with");
    let config = folder.read("shop/partc.toml");
    for wanted in [
        "#feed = ",
        "[tools]\n# radius: ",
        "\n#5 = { radius =  } ",
        "\n#1 = { name = \"MILL_D8\" } ",
        "#Q50 = ",
        "#pass_m = [77]",
        "shop/A.H:4 `3 L X+0 Y+0 R0 F AUTO M77`",
        "#   5: radius compensation; ",
    ] {
        assert!(config.contains(wanted), "{wanted} is missing in:\n{config}");
    }
    // As it was written it changes nothing.
    folder.run(&["compile", "shop/B.H", "-o", "-"]).exits(0);
    folder.write("shop/partc.toml", &filled(&config));
    folder.run(&["compile", "shop/A.H", "-o", "-"]).exits(0);
}

#[test]
fn an_existing_configuration_is_kept() {
    let folder = Folder::new("init_kept").with(&[("A.H", NEEDS), ("partc.toml", "[output]\npass_m = [5]\n")]);
    folder.run(&["init", "."]).exits(2).says("use --update").says("--force");
    let printed = folder.run(&["init", ".", "-o", "-"]).exits(0).out;
    assert!(printed.contains("pass_m = [5, 77]"), "{printed}");
    assert_eq!(folder.read("partc.toml"), "[output]\npass_m = [5]\n");
    folder.run(&["init", ".", "--update"]).exits(0);
    let updated = folder.read("partc.toml");
    assert!(updated.starts_with("[output]\npass_m = [5]\n#pass_m = [5, 77] "), "{updated}");
    assert!(updated.contains("\n[tools]\n") && updated.contains("\n#5 = { radius =  } "), "{updated}");
    folder.run(&["init", ".", "--update"]).exits(0);
    assert_eq!(folder.read("partc.toml"), updated, "a second time there is nothing new");
    folder.run(&["init", ".", "--force"]).exits(0);
    let anew = folder.read("partc.toml");
    assert!(anew.starts_with("# Written by `partc init`") && anew.contains("#pass_m = [77] "), "{anew}");
    folder.run(&["init", "nowhere"]).exits(2);
}

/// A new file hides the one above it, whose values the programs had.
#[test]
fn a_configuration_above_goes_on_to_hold() {
    let above = "[tools.5]\nradius = 4.0\n";
    let folder = Folder::new("init_above").with(&[("shop/new/A.H", NEEDS), ("partc.toml", above)]);
    folder.run(&["init", "shop/new"]).exits(0);
    let config = folder.read("shop/new/partc.toml");
    assert!(config.contains("\nextend = \"../../partc.toml\"\n") && !config.contains("#radius = "), "{config}");
    folder.write("shop/new/partc.toml", &filled(&config));
    folder.run(&["compile", "shop/new/A.H"]).exits(0);
}

#[test]
fn programs_of_the_machine_builder_and_folders_are_named() {
    let call = "N10 G54\nN20 TC(\"MILL_D10\",1)\nN30 G0 X0 Y0 Z5\nN40 SUB\nN50 M77\nN60 M30\n";
    let folder = Folder::new("init_calls").with(&[("MPF/A.MPF", call), ("LIB/SUB.SPF", "G1 X5 F100\nM17\n")]);
    // The missing program does not hide what comes behind it.
    let found = folder.run(&["check", "MPF/A.MPF", "--format", "concise"]).exits(1);
    assert_eq!(found.codes().iter().filter(|code| **code == "P2007").count(), 1, "{}", found.err);
    folder.run(&["init", "."]).exits(0);
    let config = folder.read("partc.toml");
    for wanted in [
        "#TC = ",
        "# { tool = 1 } or { ignore = true }; ",
        "#roots.\"/_N_SPF_DIR\" = \"LIB\"",
        "#1 = { name = \"MILL_D10\" }",
    ] {
        assert!(config.contains(wanted), "{wanted} is missing in:\n{config}");
    }
    folder.write("partc.toml", &filled(&config));
    folder.run(&["compile", "MPF/A.MPF", "-o", "-"]).exits(0);
}

/// A call that is found nowhere may change the tool, or not: what the user has not said changes none and loses none.
#[test]
fn nothing_is_guessed_of_a_call() {
    let plain = "G17 G90 G54 ; a\nT1 M6\nT2\nS1000 M3\nG0 X0 Y0 Z50\nTIME_OFF ; counter of hours\nG0 X10 Y10\nM30\n";
    let named = "G18 G54 G90\nT=\"ROUGH\"\nTC(1,0,0,2,90,0) ; tool change\nS320 M4 F200\nG0 X60 Z2\nG1 Z-10\nM30\n";
    let folder = Folder::new("init_calls_open").with(&[("a/A.MPF", plain), ("b/B.MPF", named)]);
    for (at, name, block) in [("a", "TIME_OFF", "counter of hours"), ("b", "TC", "TC(1,0,0,2,90,0) ; tool change")] {
        folder.run(&["init", at]).exits(0);
        let config = folder.read(&format!("{at}/partc.toml"));
        let line = config.lines().find(|line| line.starts_with(&format!("#{name} = "))).expect("a line for the call");
        let (entry, remark) = line.split_once(" # ").expect("a remark");
        assert_eq!(entry.trim_end(), format!("#{name} ="), "{config}");
        assert!(remark.contains("{ change = true } or { ignore = true }") && remark.contains(block), "{line}");
        // Taking the marks away decides nothing.
        let bare = |line: &str| line.strip_prefix('#').filter(|rest| !rest.starts_with(' ')).unwrap_or(line).to_owned();
        folder.write(&format!("{at}/partc.toml"), &config.lines().map(|line| bare(line) + "\n").collect::<String>());
        let program = format!("{at}/{}.MPF", at.to_uppercase());
        folder.run(&["compile", &program, "-o", "-"]).exits(2);
    }
}

/// On request the values are asked for one by one: what is no value is asked for again, and what is left open stays open.
#[test]
fn values_are_asked_for_one_by_one() {
    let folder = Folder::new("init_asks").with(&[("A.H", RADIUS), ("B.H", NEEDS)]);
    let said = folder.run_with(&["init", ".", "-i"], "wide\n4.5\nq\n").exits(0).err;
    assert!(said.contains("0 of 2 programs compile as they are"), "{said}");
    assert!(said.contains("[tools.5] radius (1 of ") && said.contains("and another program"), "{said}");
    assert!(said.matches("\n  radius: ").count() == 2 && said.contains("  1 of 2 programs compile\n"), "{said}");
    let config = folder.read("partc.toml");
    assert!(config.contains("\n5 = { radius = 4.5 } ") && config.contains("\n#feed = "), "{config}");
    folder.run(&["compile", "A.H", "-o", "-"]).exits(0);
    // What is left is asked for by a further conversation; the first answers stay.
    folder.run_with(&["init", ".", "-i", "--update"], "-\n-\n-\n[77]\n").exits(0);
    let updated = folder.read("partc.toml");
    assert!(updated.contains("\n5 = { radius = 4.5 } ") && updated.contains("\npass_m = [77]"), "{updated}");
}

/// Files of other names are named, with how they become programs.
#[test]
fn files_that_are_passed_over_are_named() {
    let folder = Folder::new("init_others").with(&[("shop/a.txt", "G0 X1\n"), ("shop/b.txt", "x"), ("shop/L10", "y")]);
    for command in ["init", "compile"] {
        let said = folder.run(&[command, "shop"]).exits(2).err;
        assert!(
            said.contains("passed over: 2 `.txt`, 1 without an extension") && said.contains("[dialects]"),
            "{said}"
        );
    }
}

/// Where the first choice of a key does not do, the others are tried, and the kind of machine is a line.
#[test]
fn each_choice_is_tried_before_a_program_is_given_up() {
    let turned = "G18 G54 G90 G96\nT1 D1\nS300 LIMS=3000 M4\nG0 X60 Z2 M8\nG1 Z-10 F0.2\nM30\n";
    let folder = Folder::new("init_choices").with(&[("A.MPF", turned)]);
    folder.run(&["init", "."]).exits(0).says("1 with");
    let config = folder.read("partc.toml");
    assert!(config.contains("#kind = ") && config.contains("# \"lathe\" or \"mill\"; "), "{config}");
    assert!(!config.contains("left whatever"), "{config}");
    // The keys of the target are asked for as those of the control are.
    let changed = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 R0 FMAX M3\n3 TOOL CALL 2 Z S1000\n4 L X+9 R0 FMAX M30\n5 END PGM A MM\n";
    let folder = Folder::new("init_target").with(&[("A.H", changed)]);
    folder.run(&["init", ".", "--target", "grbl"]).exits(0);
    let config = folder.read("partc.toml");
    assert!(config.contains("#tool_change = \"stop\""), "{config}");
}

#[test]
fn the_lines_to_paste_are_complete_for_a_program() {
    let folder = Folder::new("paste").with(&[("A.H", NEEDS)]);
    let said = folder.run(&["compile", "A.H"]).exits(1).err;
    let (_, lines) = said.split_once("Paste into partc.toml and fill in:").expect("lines to paste");
    for wanted in ["[control]", "feed =", "[tools.5]", "radius =", "name = \"MILL_D8\"", "Q50 =", "pass_m = [77]"] {
        assert!(lines.contains(wanted), "{wanted} is missing in:\n{said}");
    }
    // What is not filled in is no configuration.
    let pasted: String = lines.lines().map(|line| line.trim_start().to_owned() + "\n").collect();
    let (pasted, _) = pasted.split_once("\n\n\n").unwrap_or((&pasted, ""));
    folder.write("partc.toml", pasted);
    folder.run(&["compile", "A.H"]).exits(2);
}

#[test]
fn several_programs_are_a_line_a_finding_and_a_table() {
    let folder = Folder::new("folder").with(&[("a/A.H", RADIUS), ("a/B.H", RADIUS), ("a/C.H", WRONG), ("a/D.H", PART)]);
    let said = folder.run(&["check", "a"]).exits(1).err;
    assert!(said.contains("a/A.H:4:") && !said.contains("a/B.H:4:"), "a key is told once:\n{said}");
    assert!(said.contains("a/C.H:2:14: error[P1003]: "), "{said}");
    assert!(said.contains("programs findings") && said.contains("<- [tools.5] radius"), "{said}");
    assert!(said.contains("Begin with what partc.toml can answer") && said.contains("and another program"), "{said}");
    assert!(said.contains("4 programs, 3 errors"), "{said}");
    let short = folder.run(&["check", "a", "--max", "0"]).exits(1).err;
    assert!(short.contains("a/C.H: … and 1 more"), "{short}");
    // Whoever names a format gets it.
    let concise = folder.run(&["check", "a", "--format", "concise"]).exits(1).err;
    assert!(concise.contains("a/B.H:4:") && !concise.contains("programs findings"), "{concise}");
}

#[test]
fn the_keys_are_in_json() {
    let folder = Folder::new("asked").with(&[("A.H", RADIUS)]);
    let found = folder.run(&["check", "A.H", "--format", "json"]).exits(1).json();
    let answers = &found["diagnostics"][0]["answers"];
    assert_eq!(answers[0]["table"], "tools.5");
    assert_eq!(answers[0]["key"], "radius");
}

#[test]
fn long_quotes_are_cut() {
    let long = format!("N10 G0 X0\nN20 {}=5\nN30 M30\n", "NAME".repeat(40));
    let folder = Folder::new("quotes").with(&[("A.MPF", &long)]);
    let found = folder.run(&["check", "A.MPF", "--format", "json"]).exits(1).json();
    let message = found["diagnostics"][0]["message"].as_str().expect("a message");
    assert!(message.contains('…') && message.len() < 200, "{message}");
}

#[test]
fn keys_are_explained_and_commands_have_pages() {
    let folder = Folder::new("explained");
    let text = folder.run(&["explain", "control.cp_sign"]).exits(0).out;
    assert!(text.starts_with("[control] cp_sign\n") && text.contains("values: "), "{text}");
    let both = folder.run(&["explain", "rapid_feed"]).exits(0).out;
    assert!(both.starts_with("[control] rapid_feed\n") && both.contains("\n\n[output] rapid_feed\n"), "{both}");
    let one = folder.run(&["explain", "output.rapid_feed"]).exits(0).out;
    assert!(one.starts_with("[output] rapid_feed\n") && !one.contains("[control]"), "{one}");
    assert!(folder.run(&["explain", "pole-missing"]).exits(0).out.starts_with("K2101"));
    let page = folder.run(&["man", "compile"]).exits(0).out;
    assert!(page.contains(".TH partc-compile"), "{}", &page[..200]);
    folder.run(&["man", "compil"]).exits(2).says("did you mean `compile`?");
    folder.run(&["man", "--out-dir", "pages"]).exits(0);
    assert!(folder.has("pages/partc-init.1") && folder.has("pages/partc.1"));
}

#[test]
fn the_configuration_shown_is_that_of_the_language() {
    let folder = Folder::new("shown").with(&[("A.H", PART), ("A.MPF", "G0 X0\nM30\n")]);
    let klartext = folder.run(&["config", "--show", "A.H"]).exits(0).out;
    let sinumerik = folder.run(&["config", "--show", "A.MPF"]).exits(0).out;
    assert!(klartext.contains("cp_sign") && !klartext.contains("md10760"), "{klartext}");
    assert!(!sinumerik.contains("cp_sign") && sinumerik.contains("md10760"), "{sinumerik}");
    assert!(klartext.contains("; one of "), "{klartext}");
}

#[test]
fn an_unknown_language_is_asked_for_with_all_names() {
    let folder = Folder::new("language").with(&[("A.txt", "hello\nworld\n")]);
    let said = folder.run(&["check", "A.txt"]).exits(2).err;
    for name in ["klartext", "sinumerik", "mtc200", "heidenhain-turning", "cannot be read"] {
        assert!(said.contains(name), "{said}");
    }
}

#[test]
fn inches_leave_no_digits_in_a_trace() {
    let inch = "0 BEGIN PGM INCH INCH\n1 L X+6 Y+0.1 Z+2.3 R0 FMAX\n2 L Z+50 FMAX M30\n3 END PGM INCH INCH\n";
    let folder = Folder::new("inches").with(&[("A.H", inch)]);
    let out = folder.run(&["trace", "A.H"]).exits(0).out;
    assert!(out.contains("\"X\":152.4,") && !out.contains("99999"), "{out}");
}

#[test]
fn what_no_configuration_can_say_is_a_finding_all_the_same() {
    for (block, code) in [
        ("CYCL DEF 247 DATUM SETTING ~\n  Q339=-1", "P9014"),
        ("TOOL CALL \"A\\B\" Z S100", "K2005"),
        ("L X+1 M99999", ""),
    ] {
        let program = format!("0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 FMAX\n2 {block}\n3 END PGM A MM\n");
        let folder = Folder::new("init_odd").with(&[("A.H", &program)]);
        for command in ["check", "compile"] {
            let ran = folder.run(&[command, "A.H", "--format", "concise"]);
            let said = format!("{}{}", ran.out, ran.err);
            assert!(ran.code == Some(1) && said.contains("A.H:3") && said.contains(code), "{block}: {ran:?}");
        }
    }
}

/// What a program says of its tools stands beside the empty value, and is none.
#[test]
fn measures_in_names_and_comments_are_hints() {
    let program = "0 BEGIN PGM A MM\n1 ; T5 - L0 R4 - finisher\n2 ; T9 - L0 R3 - other\n3 * - TOOL: T188451270 | GUH / DM=12 CR=0.5 TL=148\n\
                   4 TOOL CALL 7 Z S2000\n5 L X+0 Y+0 R0 FMAX M3\n6 L X+10 RL F200\n7 L X+60 R0\n8 TOOL CALL 5 Z S3000\n\
                   9 L X+0 Y+0 R0 FMAX M3\n10 L X+10 RL F200\n11 L X+60 R0\n12 TOOL CALL \"MILL_8\" Z S3000 DR+0.1\n13 L X+0 Y+0 R0 FMAX M3\n\
                   14 L X+10 RL F200\n15 L X+60 R0\n16 TOOL CALL 3 Z S3000 ; end mill 10 mm\n17 L X+0 Y+0 R0 FMAX M3\n\
                   18 L X+10 RL F200\n19 L X+60 R0\n20 L Z+50 FMAX M30\n21 END PGM A MM\n";
    let folder = Folder::new("init_hints").with(&[("A.H", program)]);
    folder.run(&["init", "."]).exits(0);
    let config = folder.read("partc.toml");
    for wanted in [
        "#7 = { radius =  } ",
        "radius 6, corner radius 0.5, length 148 by \"TOOL: T188451270 | GUH / DM=12 CR=0.5 TL=148\"?; called in A.H:5 `4 TOOL CALL 7 Z S2000`, asked for by A.H:7 `6 L X+10 RL F200`",
        "radius 4 by \"T5 - L0 R4 - finisher\"?; called in A.H:9",
        "radius 4 by \"MILL_8\"?; ",
        "radius 5 by \"end mill 10 mm\"?; ",
    ] {
        assert!(config.contains(wanted), "{wanted} is missing in:\n{config}");
    }
    // Taking the marks away gives no tool a measure.
    let bare = |line: &str| line.strip_prefix('#').filter(|rest| !rest.starts_with(' ')).unwrap_or(line).to_owned();
    folder.write("partc.toml", &config.lines().map(|line| bare(line) + "\n").collect::<String>());
    folder.run(&["compile", "A.H", "-o", "-"]).exits(2);
    // They are offered in a conversation, and taken by nobody but the user.
    let said = folder.run_with(&["init", ".", "-i", "--force"], "-\n-\n-\n-\n-\n").exits(0).err;
    assert!(said.contains("radius 5 by \"end mill 10 mm\"?") && said.contains("  radius: "), "{said}");
}

/// Of no program of the machine builder a line says what it does before the user has: also where there is one choice only.
#[test]
fn no_line_makes_a_promise() {
    let mut asked = 0;
    for name in book::names() {
        for case in book::of(&name) {
            let asks = |finding: &Diagnostic| finding.answers.iter().any(|answer| answer.section == "programs");
            let is_flat = !case.called.keys().any(|name| name.contains(['/', '\\']));
            if !is_flat || !case.compile().findings.iter().any(|found| found.severity == Severity::Error && asks(found))
            {
                continue;
            }
            asked += 1;
            let folder = Folder::new("init_promises");
            std::fs::write(folder.0.join(&case.file), &case.program).expect("a program");
            for (name, bytes) in &case.called {
                std::fs::write(folder.0.join(name), bytes).expect("a program");
            }
            folder.write("partc.toml", &case.config);
            let config = folder.run(&["init", &case.file, "-o", "-", "--dialect", &case.dialect]).exits(0).out;
            let lines =
                config.lines().skip_while(|line| *line != "[programs]").skip(1).take_while(|line| !line.is_empty());
            for line in lines {
                let (entry, _) = line.split_once(" # ").expect("a remark");
                assert!(line.starts_with('#') && entry.trim_end().ends_with('='), "{}: {line}", case.name);
            }
        }
    }
    assert!(asked >= 9, "{asked}");
}

/// A folder of a lathe course: tools by name, a tool changer, axes and spindles of the builder. A tool is one line.
#[test]
fn a_course_is_asked_for_in_few_lines() {
    let folder = Folder::new("init_course");
    let tools = [
        "DR_R0.8K95E80",
        "DR_R0.4K93E35",
        "SR_R0.8K95E80",
        "SR_R0.2K93E35",
        "GR_3.0",
        "TH_1.5",
        "FS_D10",
        "DRILL_D8.5",
    ];
    for n in 0..24 {
        let [rough, fine] = [tools[n % 8], tools[(n + 3) % 8]];
        let part = format!(
            "; PART {n}\nN10 G18 G54 G90 DIAMON\nN15 LIMS=3000\nN20 T=\"{rough}\"\nN25 TC(1,0,0,2,90,0) ; change\nN30 B1=90\n\
             N35 G96 S200 M4\nN40 G0 X62 Z2\nN45 G42 G1 X20 Z0 F0.2\nN50 G1 X30 Z-5 RND=1\nN55 G1 Z-30\nN60 G40 G1 X66\nN65 G0 X150 Z150\n\
             N70 T=\"{fine}\"\nN75 TC(1,0,0,2,90,0)\nN80 G96 S200 M4\nN85 G0 X62 Z2\nN90 G1 X-1.6 F0.2\nN95 G0 X150 Z150\nN100 TIME_OFF\nN105 M{}\nN110 M30\n",
            60 + n % 5
        );
        folder.write(&format!("P{n}.MPF"), &part);
    }
    folder.run(&["init", "."]).exits(0);
    let config = folder.read("partc.toml");
    let asked =
        config.lines().filter(|line| line.starts_with('#') && !line.starts_with("# ") && line.contains(" = ")).count();
    assert!(asked <= 20, "{asked} lines:\n{config}");
    for tool in tools {
        assert_eq!(config.matches(&format!("{{ name = \"{tool}\"")).count(), 1, "{config}");
    }
}

/// Whether an M function changes the tool only the user knows: passed where it does, the old tool would cut on.
#[test]
fn an_m_function_that_may_change_the_tool_is_not_passed_by_enter() {
    const PROGRAM: &str = "G17 G90 G54\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM77\nT2\nM66\nG1 Z-2\nM30\n";
    let folder = Folder::new("init_change").with(&[("X.MPF", PROGRAM)]);
    folder.run_with(&["init", ".", "-i"], "\n\n\n").exits(0);
    let config = folder.read("partc.toml");
    assert!(!config.contains("66]") || config.contains("# [66], if that is so"), "{config}");
    folder.run(&["compile", "X.MPF", "-o", "-"]).exits(1);
    folder.run(&["init", ".", "--force"]).exits(0);
    let config = folder.read("partc.toml");
    assert!(config.contains("#pass_m = [77] ") && config.contains("# and 66, if it changes no tool; "), "{config}");
    assert!(config.contains("#tool_change_m =  "), "{config}");
}

/// A trial answers a call of a program that is nowhere, and what follows counts.
#[test]
fn a_builders_program_is_tried_as_left_out() {
    const PROGRAM: &str = "0 BEGIN PGM Y MM\n1 TOOL CALL 5 Z S2000 F300\n2 L X+0 Y+0 Z+50 R0 FMAX M3\n3 CALL PGM HC\n\
                           4 L X+20 F200 M30\n5 END PGM Y MM\n";
    let folder = Folder::new("init_nowhere").with(&[("Y.H", PROGRAM)]);
    let said = folder.run(&["init", ".", "-o", "-"]).exits(0).out;
    assert!(said.contains("# 0 compile as it is, 1 once the values below are filled in."), "{said}");
    assert!(said.contains("put them beside the programs") && said.contains("\n#HC =  "), "{said}");
}
