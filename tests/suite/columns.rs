//! The trace as a table: every form holds what the JSON Lines say, and its schema is the documented one.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type};
use arrow_array::{Array, RecordBatch};
use arrow_schema::DataType;
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::text::{Memory, Opened};
use partc::table::{COLUMNS, Form, Kind, Model, Options, Table, VERSION, schema};
use serde_json::{Map, Value, json};

use super::book::{self, Case};
use super::cli_run::{Folder, HOLE, PART, WRONG, caller};
use super::quality::process;

fn session(case: &Case) -> Session {
    let text = Box::new(Memory::new(case.program.clone()));
    Session::new(Opened { name: case.file.clone(), identity: case.file.clone(), text })
}

/// Rows of a case; some run into their limits.
const MOST: usize = 5000;

/// The batches of a case; none where it has errors or very many moves.
fn batches(case: &Case, rows: usize) -> Option<Vec<RecordBatch>> {
    let (session, mut all) = (session(case), Vec::new());
    let dialect = dialect::find(&case.dialect).expect("a dialect");
    let mut left = MOST;
    let mut take = |batch: RecordBatch| {
        left = left.saturating_sub(batch.num_rows());
        all.push(batch);
        left > 0
    };
    let options = Options { rows, ..Options::default() };
    session.trace_batches(dialect, &case.settings(), case, options, &mut take);
    (left > 0 && !session.diags.has_errors()).then_some(all)
}

/// A row as an object; what is missing is left out.
fn row(batch: &RecordBatch, row: usize) -> Map<String, Value> {
    let mut object = Map::new();
    for (field, column) in batch.schema().fields().iter().zip(batch.columns()) {
        if column.is_null(row) {
            continue;
        }
        let value = match field.data_type() {
            DataType::Float64 => json!(column.as_primitive::<Float64Type>().value(row)),
            DataType::Int64 => json!(column.as_primitive::<Int64Type>().value(row)),
            DataType::Boolean => json!(column.as_boolean().value(row)),
            DataType::Utf8 => json!(column.as_string::<i32>().value(row)),
            DataType::Dictionary(..) => {
                let words = column.as_dictionary::<Int32Type>();
                json!(words.values().as_string::<i32>().value(words.key(row).expect("a key")))
            }
            other => panic!("{other}"),
        };
        object.insert(field.name().clone(), value);
    }
    object
}

fn rows(batches: &[RecordBatch]) -> Vec<Map<String, Value>> {
    batches.iter().flat_map(|batch| (0..batch.num_rows()).map(|n| row(batch, n))).collect()
}

/// Without the last digits, as JSON Lines write a number.
fn rounded(value: f64) -> f64 {
    let scaled = (value * 1e9).round() / 1e9;
    if scaled.is_finite() { scaled + 0.0 } else { value }
}

/// What a line of JSON says, as a row.
fn expected(line: &Value) -> Map<String, Value> {
    let mut row = Map::new();
    for (key, value) in line.as_object().expect("an object") {
        let mut say = |name: &str, value: &Value| drop(row.insert(name.to_owned(), value.clone()));
        match key.as_str() {
            "start" | "end" => {
                let front = if key == "start" { "start_" } else { "" };
                for (axis, value) in value.as_object().expect("axes") {
                    say(&format!("{front}{}", axis.to_lowercase()), value);
                }
            }
            "center" => {
                for (axis, value) in value.as_object().expect("axes") {
                    say(["i", "j", "k"]["XYZ".find(axis.as_str()).expect("a main axis")], value);
                }
            }
            "sweep_deg" => say("sweep", value),
            "feed" | "feed_per_rev" | "feed_inverse_time" => {
                say("feed", value);
                let mode = [("feed", "per_minute"), ("feed_per_rev", "per_revolution")];
                let mode = mode.iter().find(|(name, _)| name == key).map_or("inverse_time", |(_, mode)| mode);
                say("feed_mode", &json!(mode));
            }
            "spindle" | "cutting_speed" => {
                say("spindle", value);
                say("spindle_mode", &json!(if key == "spindle" { "speed" } else { "cutting_speed" }));
            }
            "stack" => {
                let sites = value.as_array().expect("sites").iter().rev();
                let calls: Vec<String> =
                    sites.map(|site| format!("{}:{}", site["file"].as_str().expect("a file"), site["line"])).collect();
                if !calls.is_empty() {
                    say("call_path", &json!(calls.join(" > ")));
                }
            }
            "tool_axis" => {
                let axis = value.as_array().into_iter().flatten();
                ["tx", "ty", "tz"].into_iter().zip(axis).for_each(|(name, value)| say(name, value));
            }
            "tool" if value.is_null() => {}
            _ => say(key, value),
        }
    }
    row.entry("machine").or_insert(json!(false));
    if line.get("tool_axis").is_none() {
        for (name, value) in [("tx", 0.0), ("ty", 0.0), ("tz", 1.0)] {
            row.insert(name.to_owned(), json!(value));
        }
    }
    row
}

fn sorted(row: Map<String, Value>) -> BTreeMap<String, Value> {
    let round = |value: Value| match value.as_f64() {
        Some(number) if value.is_f64() => json!(rounded(number)),
        _ => value,
    };
    row.into_iter().map(|(key, value)| (key, round(value))).collect()
}

#[test]
fn rows_say_what_the_lines_say() {
    let (mut compared, mut seen) = (0, std::collections::BTreeSet::new());
    for case in book::cases("") {
        let Some(batches) = batches(case, 7) else { continue };
        let (session, mut lines) = (session(case), Vec::new());
        let dialect = dialect::find(&case.dialect).expect("a dialect");
        session.trace(dialect, &case.settings(), case, Model::default(), &mut lines).expect("memory");
        let lines = String::from_utf8(lines).expect("UTF-8");
        let lines: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
        let rows = rows(&batches);
        assert_eq!(rows.len(), lines.len(), "{}", case.name);
        for (n, (row, line)) in rows.into_iter().zip(&lines).enumerate() {
            seen.extend(row.keys().cloned());
            assert_eq!(sorted(row), sorted(expected(line)), "{} move {n}", case.name);
            compared += 1;
        }
    }
    assert!(compared > 10_000, "{compared}");
    let never: Vec<&str> = COLUMNS.iter().map(|column| column.name).filter(|name| !seen.contains(*name)).collect();
    assert!(never.iter().all(|name| name.ends_with(['u', 'v', 'w'])), "no case has {never:?}");
}

#[test]
fn times_and_lengths_add_up_to_the_figures() {
    for case in book::cases("") {
        let Some(batches) = batches(case, 50) else { continue };
        let session = session(case);
        let dialect = dialect::find(&case.dialect).expect("a dialect");
        let figures = session.stats(dialect, &case.settings(), case, Model::default()).total();
        let rows = rows(&batches);
        let sum = |name: &str| -> f64 { rows.iter().filter_map(|row| row.get(name)?.as_f64()).sum() };
        let time = figures.cutting_time + figures.rapid_time;
        assert!((sum("time") - time).abs() <= 1e-9 * time.max(1.0), "{}: {} {time}", case.name, sum("time"));
    }
}

/// Batches of a program that calls another one late.
fn late() -> Vec<RecordBatch> {
    let mut program = "0 BEGIN PGM LATE MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 Z+10 R0 FMAX M3\n".to_owned();
    for n in 3..40 {
        let _ = writeln!(program, "{n} L X+{n} Y+0.{n} F200");
    }
    program += "40 CALL PGM B\n41 L X+0.1 F MAX\n42 M30\n43 END PGM LATE MM\n";
    let called = BTreeMap::from([("B.H".to_owned(), HOLE.as_bytes().to_vec())]);
    let case = Case {
        name: "late".to_owned(),
        dialect: "klartext".to_owned(),
        file: "LATE, \"B\".H".to_owned(),
        program: program.into_bytes(),
        called,
        ..Case::default()
    };
    batches(&case, 10).expect("no errors")
}

fn written(form: Form, batches: &[RecordBatch]) -> Vec<u8> {
    let mut table = Table::open(form, Vec::new()).expect("memory");
    batches.iter().for_each(|batch| table.write(batch).expect("memory"));
    table.finish().expect("memory")
}

/// Forms that this build writes, with how their files begin.
fn forms() -> Vec<(&'static str, &'static [u8])> {
    let mut forms = vec![("a.jsonl", &b"{\"kind\":"[..]), ("a.csv", b"kind,start_x")];
    if cfg!(feature = "columns") {
        forms.extend([("a.arrow", &b"ARROW1"[..]), ("a.parquet", b"PAR1")]);
    }
    forms
}

/// A build without the files of Arrow and Parquet says how to get them.
#[cfg(not(feature = "columns"))]
#[test]
fn a_form_that_is_not_built_is_refused() {
    let folder = Folder::new("columns_not_built").with(&[("A.H", PART)]);
    for file in ["a.arrow", "a.parquet"] {
        folder.run(&["trace", "A.H", "-o", file]).exits(2).says("--features columns");
        assert!(!folder.has(file));
    }
}

#[cfg(feature = "columns")]
#[test]
fn arrow_and_parquet_are_read_back() {
    let batches = late();
    assert!(batches.len() > 3);
    let wanted = rows(&batches);
    let file = std::io::Cursor::new(written(Form::ArrowFile, &batches));
    let file = arrow_ipc::reader::FileReader::try_new(file, None).expect("a file");
    assert_eq!(file.schema(), schema());
    assert_eq!(rows(&file.map(|batch| batch.expect("a batch")).collect::<Vec<_>>()), wanted);
    let stream = std::io::Cursor::new(written(Form::ArrowStream, &batches));
    let stream = arrow_ipc::reader::StreamReader::try_new(stream, None).expect("a stream");
    assert_eq!(rows(&stream.map(|batch| batch.expect("a batch")).collect::<Vec<_>>()), wanted);
    let scratch = Folder::new("columns_read_back");
    fs::write(scratch.0.join("a.parquet"), written(Form::Parquet, &batches)).expect("a file");
    let (about, read) = parquet(&scratch.0.join("a.parquet"));
    assert_eq!(rows(&read), wanted);
    assert!(about.contains(&format!("{}={VERSION}", partc::table::VERSION_KEY)), "{about}");
    assert!(about.contains(concat!("created_by=partc ", env!("CARGO_PKG_VERSION"), "\n")), "{about}");
}

#[cfg(feature = "columns")]
/// What a Parquet file says of itself, and its batches.
fn parquet(path: &Path) -> (String, Vec<RecordBatch>) {
    use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
    let reader = ParquetRecordBatchReaderBuilder::try_new(fs::File::open(path).expect("a file")).expect("Parquet");
    let about = reader.metadata().file_metadata();
    let mut text = format!("created_by={}\n", about.created_by().unwrap_or_default());
    for pair in about.key_value_metadata().into_iter().flatten() {
        let _ = writeln!(text, "{}={}", pair.key, pair.value.as_deref().unwrap_or_default());
    }
    (text, reader.build().expect("a reader").map(|batch| batch.expect("a batch")).collect())
}

#[test]
fn empty_tables_are_tables() {
    assert!(!written(Form::Csv, &[]).is_empty());
    #[cfg(feature = "columns")]
    {
        for form in [Form::ArrowFile, Form::ArrowStream, Form::Parquet] {
            assert!(!written(form, &[]).is_empty(), "{form:?}");
        }
        let file = std::io::Cursor::new(written(Form::ArrowFile, &[]));
        assert_eq!(arrow_ipc::reader::FileReader::try_new(file, None).expect("a file").count(), 0);
    }
}

#[test]
fn values_between_commas() {
    let text = String::from_utf8(written(Form::Csv, &late())).expect("UTF-8");
    let names: Vec<&str> = COLUMNS.iter().map(|column| column.name).collect();
    let lines: Vec<&str> = text.split("\r\n").collect();
    assert_eq!(lines[0], names.join(","));
    assert!(!text.replace("\r\n", "").contains(['\r', '\n']) && text.ends_with("\r\n"));
    assert_eq!(
        lines[2],
        "line,0,0,10,,,,,,,3,0.3,10,,,,,,,,,,,,,,200,per_minute,2000,speed,,cw,3,,false,3.014962686336267,0.9061554725675467,\
         \"LATE, \"\"B\"\".H\",4,3,,0,0,1"
    );
    assert!(lines[39].contains(",B.H,2,1,\"LATE, \"\"B\"\".H:41\""), "{}", lines[39]);
}

/// Set, writes the table of docs/trace.md anew.
const UPDATE: &str = "PARTC_UPDATE_DOCS";
const BEHIND: &str = "<!-- written by a test: columns -->\n";
const BEFORE: &str = "<!-- end -->\n";

#[test]
fn the_documentation_lists_every_column() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/trace.md");
    let found = fs::read_to_string(&path).expect("the documentation").replace("\r\n", "\n");
    let (text, rest) = found.split_once(BEHIND).expect("the mark in front of the table");
    let (_, rest) = rest.split_once(BEFORE).expect("the mark behind it");
    let mut made = format!(
        "{text}{BEHIND}\nVersion {VERSION}.\n\n| column | type | unit | | null |\n| --- | --- | --- | --- | --- |\n"
    );
    for (column, field) in COLUMNS.iter().zip(schema().fields()) {
        let kind = match column.kind {
            Kind::Number => "float64",
            Kind::Whole => "int64",
            Kind::Truth => "bool",
            Kind::Word => "dictionary<int32, utf8>",
            Kind::Text => "utf8",
        };
        assert_eq!((field.name().as_str(), field.is_nullable()), (column.name, !column.null.is_empty()));
        let null = if column.null.is_empty() { "never" } else { column.null };
        let _ = writeln!(made, "| `{}` | {kind} | {} | {} | {null} |", column.name, column.unit, column.meaning);
    }
    made += "\n";
    made += BEFORE;
    made += rest;
    if std::env::var_os(UPDATE).is_some() {
        fs::write(&path, &made).expect("the documentation");
    }
    assert!(found == made, "{} is not up to date: {UPDATE}=1 writes it", path.display());
}

#[test]
fn the_schema_is_the_one_of_its_version() {
    let mut listed = String::new();
    for field in schema().fields() {
        let unit = field.metadata().get("unit").map(|unit| format!(" [{unit}]")).unwrap_or_default();
        let null = if field.is_nullable() { "?" } else { "" };
        let _ = writeln!(listed, "{}: {}{null}{unit}", field.name(), field.data_type());
    }
    // A change of what is here raises VERSION; a column more at the end does not.
    insta::assert_snapshot!("trace_columns", format!("version {VERSION}\n{listed}"));
}

#[test]
fn the_command_writes_each_form() {
    let folder = Folder::new("columns_command").with(&[("A.H", &caller("HOLE")), ("HOLE.H", HOLE), ("WRONG.H", WRONG)]);
    for (file, mark) in forms() {
        folder.run(&["trace", "A.H", "-o", file]).exits(0).quietly();
        let made = fs::read(folder.0.join(file)).expect("a file");
        assert!(made.starts_with(mark), "{file}");
        // The same again, over the older one.
        folder.run(&["trace", "A.H", "-o", file]).exits(0);
        assert_eq!(fs::read(folder.0.join(file)).expect("a file"), made, "{file}");
        let ran = folder.run(&["trace", "WRONG.H", "-o", file]).exits(1);
        if file == "a.jsonl" {
            // Its only line says that it is not whole, and it is ours.
            assert!(
                folder.read(file).starts_with("{\"kind\":\"incomplete\",\"code\":\"P1003\""),
                "{}",
                folder.read(file)
            );
            folder.run(&["trace", "A.H", "-o", file]).exits(0);
            continue;
        }
        // A table cannot say it: there is none, and the older one is not taken for it.
        ran.says("was renamed").says("--format jsonl");
        assert!(!folder.has(file) && folder.has(&format!("{file}.stale")), "{file}");
    }
    assert_eq!(folder.run(&["trace", "A.H", "--format", "csv"]).exits(0).out.lines().count(), 5);
    assert_eq!(folder.run(&["trace", "WRONG.H", "--format", "csv"]).exits(1).out, "");
    let same = folder.run(&["trace", "A.H"]).exits(0).out;
    assert_eq!(folder.run(&["trace", "A.H", "--format", "jsonl"]).exits(0).out, same);
    assert_eq!(folder.run(&["trace", "A.H", "--format", "concise", "-o", "-"]).exits(0).out, same);
    folder.run(&["trace", "A.H", "-o", "A.H"]).exits(2).says("no form of moves");
    folder.run(&["trace", "A.H", "--format", "csv", "-o", "A.H"]).exits(2).says("would replace the program");
    folder.run(&["trace", "A.H", "--format", "csv", "-o", "HOLE.H"]).exits(2).says("is no trace");
    // Others write such forms, too.
    let of_others = [
        ("other.jsonl", "{\"kind\":\"x\"}\n"),
        ("near.jsonl", "{\"kind\":\"line\",\"of\":1}\n"),
        ("other.parquet", "PAR1 a PAR1"),
        ("other.arrow", "ARROW1\0\0 a ARROW1"),
    ];
    let is_built =
        |file: &str| forms().iter().any(|(name, _)| Path::new(name).extension() == Path::new(file).extension());
    for (file, text) in of_others.into_iter().filter(|(file, _)| is_built(file)) {
        folder.write(file, text);
        folder.run(&["trace", "A.H", "-o", file]).exits(2).says("is no trace");
        if !file.ends_with("jsonl") {
            folder.run(&["trace", "WRONG.H", "-o", file, "--force"]).exits(1);
            assert_eq!(folder.read(file), text, "{file}");
        }
        folder.run(&["trace", "A.H", "-o", file, "--force"]).exits(0);
        folder.run(&["trace", "A.H", "-o", file]).exits(0);
    }
    folder.run(&["check", "A.H", "--format", "parquet"]).exits(2);
    folder.run(&["trace", "A.H", "--report", "csv=a.csv"]).exits(2);
}

#[test]
fn times_are_those_of_the_machine_that_is_described() {
    let folder = Folder::new("columns_model").with(&[("A.H", PART)]);
    let time = |more: &[&str]| -> f64 {
        let out = folder.run(&[&["trace", "A.H"], more].concat()).exits(0).out;
        out.lines().filter_map(|line| serde_json::from_str::<Value>(line).expect("JSON")["time"].as_f64()).sum()
    };
    assert!(time(&["--rapid", "1000"]) > time(&[]) && time(&["--acceleration", "0.1"]) > time(&[]));
}

#[test]
fn memory_does_not_grow_with_the_program() {
    let scratch = process::folder(Path::new(env!("CARGO_TARGET_TMPDIR")), "columns_memory");
    let mut peaks = Vec::new();
    for (name, blocks) in [("SMALL.H", 150_000), ("LARGE.H", 450_000)] {
        let mut program = "0 BEGIN PGM P MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 Z+10 R0 FMAX M3\n".to_owned();
        for n in 3..blocks {
            let _ = writeln!(program, "{n} L X+{}.{} Y+{}.{} F200", n % 977, n % 991, n % 983, n % 997);
        }
        let _ = write!(program, "{blocks} M30\n{} END PGM P MM\n", blocks + 1);
        fs::write(scratch.join(name), program).expect("a program");
        let args = ["trace", name, "-o", if cfg!(feature = "columns") { "out.arrow" } else { "out.csv" }];
        let partc = Path::new(env!("CARGO_BIN_EXE_partc"));
        let mut command = Command::new(partc);
        // An allocator that does not keep what was given back makes the peak the same in every run.
        command.args(args).env("MALLOC_MMAP_THRESHOLD_", "131072");
        let took = process::run_with(&mut command, &scratch, Duration::from_secs(120));
        assert_eq!(took.code, Some(0), "{}", took.said);
        peaks.push(took.memory);
    }
    if peaks[0] > 0 {
        assert!(peaks[1] < peaks[0] * 5 / 4, "{peaks:?} KiB for three times the program");
    }
    let _ = fs::remove_dir_all(&scratch);
}
