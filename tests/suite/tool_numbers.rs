//! `[tools.N] number` changes what is printed for a tool, and nothing else: its data are those of the tool that the program
//! calls, whatever another tool is printed as.

use std::collections::BTreeMap;

use partc::internals::machine::tools::{Tool, ToolKey};
use partc::internals::text::files::NoFiles;

use super::book::cases;
use super::common::{compile_bytes, settings};

/// Numbers behind T, D and H are left out.
fn without_numbers(output: &str) -> String {
    let mut kept = String::new();
    for line in output.lines().filter(|line| !line.contains('(')) {
        for word in line.split(' ') {
            let bare = word.trim_start_matches(['T', 'D', 'H']);
            let is_number = bare.len() + 1 == word.len() && bare.bytes().all(|b| b.is_ascii_digit());
            kept.push_str(if is_number { &word[..1] } else { word });
            kept.push(' ');
        }
        kept.push('\n');
    }
    kept
}

/// Tools change places with decoys: each is printed by the number of one with other data.
#[test]
fn data_are_those_of_the_tool_that_is_called() {
    let (mut same, mut wrong) = (0, Vec::new());
    for case in cases("") {
        let first = case.compile();
        let before = case.settings();
        let own: Vec<u32> = before
            .tools
            .table
            .iter()
            .filter_map(|(key, tool)| match key {
                ToolKey::Number(n @ 1..40, 0) if tool.number.is_none() => Some(*n),
                _ => None,
            })
            .collect();
        let others = before.tools.table.iter().any(|(_, tool)| tool.number.is_some() || tool.name.is_some());
        if first.has_errors() || own.is_empty() || others || own.len() != before.tools.table.len() {
            continue;
        }
        let mut swapped = before.clone();
        let decoys: BTreeMap<ToolKey, Tool> = own
            .iter()
            .map(|n| {
                let decoy = Tool { number: Some(*n), radius: Some(0.7), length: Some(33.0), ..Tool::default() };
                (ToolKey::Number(n + 40, 0), decoy)
            })
            .collect();
        for tool in swapped.tools.table.iter_mut() {
            let ToolKey::Number(own, _) = tool.0 else { continue };
            tool.1.number = Some(own + 40);
        }
        swapped.tools.table.extend(decoys);
        let second = compile_bytes(&case.file, case.program.clone(), &case.dialect, &swapped, case);
        if without_numbers(&first.output) == without_numbers(&second.output) {
            same += 1;
        } else {
            wrong.push(format!("{}: {:?}\n{}", case.name, second.rendered, second.output));
        }
    }
    assert!(wrong.is_empty(), "{} of {}: {}", wrong.len(), same + wrong.len(), wrong[..wrong.len().min(3)].join("\n"));
    assert!(same > 300, "{same} cases");
}

fn codes(dialect: &str, name: &str, program: &str, config: &str) -> (Vec<&'static str>, String) {
    let compiled = compile_bytes(name, program.as_bytes().to_vec(), dialect, &settings(config), &NoFiles);
    (compiled.findings.iter().map(|found| found.code.id).collect(), compiled.output)
}

#[test]
fn a_named_tool_has_its_own_data() {
    let program = "G17 G90 G54\nT=\"MILL\" M6\nS1000 M3 F200\nG0 X-20 Y-10 Z0\nG41 G1 X0 Y0\nY20\nG40 X-20\nM30\n";
    let config = "[tools.MILL]\nnumber = 7\nradius = 1.0\n";
    let (found, output) = codes("sinumerik", "A.MPF", program, config);
    assert!(output.contains("T7 M6") && output.contains("X-1 "), "{found:?} {output}");
    // Tool 7 is another one.
    let (found, output) = codes("sinumerik", "A.MPF", program, &format!("{config}[tools.7]\nradius = 2.0\n"));
    assert!(found.contains(&"P0203") && output.is_empty(), "{found:?}");
    // The same, described in two places.
    let (found, output) =
        codes("sinumerik", "A.MPF", program, &format!("{config}[tools.7]\nradius = 1.0\nlength = 50\n"));
    assert!(!found.contains(&"P0203") && output.contains("X-1 "), "{found:?} {output}");
}

/// The control knows the name under another number, from its table or from the program.
#[test]
fn a_name_has_one_number_on_the_control() {
    let program = "T=\"MILL\" M6 D1\nS1000 M3 F200\nG0 X-20 Y-10 Z0\nG41 G1 X0 Y0\nY20\nG40 X-20\nM30\n";
    let written = format!("$TC_TP2[800]=\"MILL\"\n$TC_DP6[800,1]=1\n$TC_DP6[7,1]=2\n{program}");
    let row = "[tools.800]\nname = \"MILL\"\nradius = 1.0\n";
    for (program, config) in [(written.as_str(), ""), (program, row)] {
        let (found, output) = codes("sinumerik", "A.MPF", program, &format!("[tools.MILL]\nnumber = 7\n{config}"));
        assert!(found.contains(&"P0203") && output.is_empty(), "{found:?} {output}");
    }
    let (found, output) = codes("sinumerik", "A.MPF", program, &format!("{row}number = 7\n"));
    assert!(output.contains("T7 M6") && output.contains("X-1 "), "{found:?} {output}");
}

#[test]
fn a_named_tool_and_a_numbered_one_are_two() {
    let config = "[tools.MILL]\nnumber = 7\nradius = 1.0\n";
    for (dialect, name, program) in [
        ("sinumerik", "A.MPF", "T=\"MILL\" M6\nG0 Z100\nT7 M6\nG0 Z50\nM30\n"),
        (
            "klartext",
            "A.H",
            "0 BEGIN PGM A MM\n1 TOOL CALL \"MILL\" Z S100\n2 L Z+100 R0 FMAX\n3 TOOL CALL 7 Z S100\n4 L Z+50 R0 FMAX\n5 END PGM A MM\n",
        ),
        (
            "klartext",
            "A.H",
            "0 BEGIN PGM A MM\n1 TOOL CALL 7 Z S100\n2 L Z+100 R0 FMAX\n3 TOOL CALL \"MILL\" Z S100\n4 L Z+50 R0 FMAX\n5 END PGM A MM\n",
        ),
    ] {
        let (found, output) = codes(dialect, name, program, config);
        assert!(found.contains(&"P0203") && output.is_empty(), "{dialect}: {found:?} {output}");
    }
    let index = "0 BEGIN PGM A MM\n1 TOOL CALL 5.1 Z S100\n2 L Z+100 R0 FMAX\n3 TOOL CALL 5 Z S100\n4 L Z+50 R0 FMAX\n5 END PGM A MM\n";
    let (found, _) = codes("klartext", "A.H", index, "[tools.\"5.1\"]\nnumber = 5\nradius = 1.0\n");
    assert!(found.contains(&"P0203"), "{found:?}");
    // One tool called twice is one.
    let twice = "T=\"MILL\" M6\nG0 Z100\nT1 M6\nG0 Z5\nT=\"MILL\" M6\nG0 Z50\nM30\n";
    let (found, output) = codes("sinumerik", "A.MPF", twice, config);
    assert!(!found.contains(&"P0203") && output.matches("T7 M6").count() == 2, "{found:?} {output}");
}
