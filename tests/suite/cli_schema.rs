//! The JSON Schemas in `docs` say what the command writes: no key more, none less, each of its kind.

use std::fs;
use std::path::Path;

use serde_json::Value;

use super::cli_run::{Folder, HOLE, PART, RADIUS, WARNED, WRONG, caller};

fn schema(name: &str) -> Value {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(name)).expect("a schema");
    serde_json::from_str(&text).expect("JSON")
}

fn is_a(kind: &str, value: &Value) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("the schema has a type `{other}`"),
    }
}

/// The words of JSON Schema that the two files use.
fn fits(schema: &Value, value: &Value, at: &str) {
    let kinds: Vec<&str> = match &schema["type"] {
        Value::String(kind) => vec![kind],
        Value::Array(kinds) => kinds.iter().map(|kind| kind.as_str().expect("a type")).collect(),
        _ => panic!("{at}: the schema has no type"),
    };
    assert!(kinds.iter().any(|kind| is_a(kind, value)), "{at}: {value} is no {kinds:?}");
    if let Some(list) = schema["enum"].as_array() {
        assert!(list.contains(value), "{at}: {value} is none of {list:?}");
    }
    if let Some(items) = value.as_array() {
        for item in items {
            fits(&schema["items"], item, &format!("{at}[]"));
        }
    }
    let Some(object) = value.as_object() else { return };
    for name in schema["required"].as_array().into_iter().flatten() {
        let name = name.as_str().expect("a name");
        assert!(object.contains_key(name), "{at}: {name} is missing");
    }
    for (name, value) in object {
        let place = format!("{at}.{name}");
        match (&schema["properties"][name], &schema["additionalProperties"]) {
            (Value::Null, Value::Object(_)) => fits(&schema["additionalProperties"], value, &place),
            (Value::Null, _) => panic!("{place} is not in the schema"),
            (known, _) => fits(known, value, &place),
        }
    }
}

#[test]
fn findings_fit_their_schema() {
    let alarm = "N10 G1 X5\nN20 M30\n";
    let folder = Folder::new("schema").with(&[
        ("a/A.H", RADIUS),
        ("a/B.H", WRONG),
        ("a/C.H", WARNED),
        ("a/D.H", &caller("E")),
        ("a/E.H", &HOLE.replace("F150", "R5")),
        ("a/F.MPF", alarm),
    ]);
    let found = folder.run(&["check", "a", "--format", "json"]).exits(1).json();
    assert!(found["diagnostics"].as_array().expect("findings").len() >= 5);
    fits(&schema("findings.schema.json"), &found, "findings");
    let troubled = folder.run(&["check", "nowhere.H", "--format", "json"]).exits(2).json();
    fits(&schema("findings.schema.json"), &troubled, "findings");
}

#[test]
fn moves_fit_their_schema() {
    let turning = "N10 G54 G18 G90 G0 X50 Z5 S500 M3\nN20 G1 Z-10 G95 F0.2\nN30 G33 Z-20 K2\nN40 G2 X55 Z-25 I5 K0 F0.1\nN50 G53 G0 X0\nN60 M30\n";
    let folder = Folder::new("schema_trace").with(&[
        ("A.H", PART),
        ("B.MPF", turning),
        ("partc.toml", "[machine]\nkind = \"lathe\"\n"),
    ]);
    for program in ["A.H", "B.MPF"] {
        let out = folder.run(&["trace", program]).exits(0).out;
        assert!(out.lines().count() >= 2, "{program}");
        for line in out.lines() {
            fits(&schema("trace.schema.json")["$defs"]["move"], &serde_json::from_str(line).expect("JSON"), "move");
        }
    }
    folder.write("R.H", &PART.replace("2 L Z-5 F150", "2 L X+5 R5"));
    let out = folder.run(&["trace", "R.H"]).exits(1).out;
    let last = serde_json::from_str(out.lines().last().expect("lines")).expect("JSON");
    fits(&schema("trace.schema.json")["$defs"]["incomplete"], &last, "incomplete");
}

#[test]
fn figures_are_those_of_the_path() {
    // 10 mm at F600 with a stop at both ends, 1 m/s²: 1 s + 10 mm/s / 1000 mm/s² = 1.01 s; a half circle of 10 mm radius.
    let part = "0 BEGIN PGM S MM\n1 TOOL CALL 3 Z S1000\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n3 L Z-5 F600\n4 CC X+10 Y+0\n5 C X+20 Y+0 DR- F600\n6 L Z+5 FMAX M30\n7 END PGM S MM\n";
    let folder = Folder::new("stats").with(&[("A.H", part), ("B.H", WRONG)]);
    let found = folder.run(&["stats", "A.H", "--as", "json"]).exits(0).json();
    let program = &found["programs"][0];
    let number = |key: &str| program[key].as_f64().expect("a number");
    assert!((number("cutting_mm") - (10.0 + 10.0 * std::f64::consts::PI)).abs() < 0.001, "{program}");
    assert!((number("rapid_mm") - 10.0).abs() < 0.001, "{program}");
    assert!((number("cutting_s") - (1.01 + std::f64::consts::PI + 0.01)).abs() < 0.001, "{program}");
    assert_eq!(program["extents"]["Y"], serde_json::json!([0.0, 10.0]));
    assert_eq!(program["extents"]["Z"], serde_json::json!([-5.0, 5.0]));
    assert_eq!(program["tools"][0]["tool"], 3);
    assert_eq!(found["model"]["acceleration_m_s2"], 1.0);
    let table = folder.run(&["stats", "A.H"]).exits(0).out;
    assert!(table.contains("T3") && table.contains("acceleration 1 m/s²"), "{table}");
    assert!(folder.run(&["stats", "A.H", "--as", "csv"]).exits(0).out.contains("\"A.H\",3,1,"));
    // Of a program with errors nobody knows what it does.
    let refused = folder.run(&["stats", "B.H", "--as", "json"]).exits(1);
    assert_eq!(refused.json()["programs"], serde_json::json!([]));
}
