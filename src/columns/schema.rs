//! The columns of a trace: one table from which schema and documents come.

use std::sync::{Arc, LazyLock};

use arrow_schema::{DataType, Field, Metadata, Schema, SchemaRef};

/// Version of the columns. A new column is added at the end and keeps it; another meaning, type or name raises it.
pub const VERSION: &str = "1";
/// Key of the version in the metadata of the schema.
pub const VERSION_KEY: &str = "partc.trace";
/// Key of the version of partc there.
pub const MADE_BY_KEY: &str = "partc.version";

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// 64-bit floating-point number, as computed: nothing is rounded.
    Number,
    /// 64-bit integer.
    Whole,
    /// Yes or no.
    Truth,
    /// Text, each different one kept once (dictionary with 32-bit keys).
    Word,
    /// Text.
    Text,
}

/// A column of the table.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    pub name: &'static str,
    pub kind: Kind,
    /// Empty where there is none.
    pub unit: &'static str,
    pub meaning: &'static str,
    /// When there is no value; empty where there always is one.
    pub null: &'static str,
}

const fn column(
    name: &'static str,
    kind: Kind,
    unit: &'static str,
    meaning: &'static str,
    null: &'static str,
) -> Column {
    Column { name, kind, unit, meaning, null }
}

const UNKNOWN: &str = "not known";
const NO_ARC: &str = "no arc";
const NO_DIRECTION: &str = "in machine coordinates after a plane from which nothing turned back";
const NO_CENTER: &str = "no arc, or not in its plane";

/// All columns, in order.
pub const COLUMNS: &[Column] = &[
    column("kind", Kind::Word, "", "`rapid`, `line`, `arc` or `thread`", ""),
    column("start_x", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("start_y", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("start_z", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("start_a", Kind::Number, "deg", "where the move begins", UNKNOWN),
    column("start_b", Kind::Number, "deg", "where the move begins", UNKNOWN),
    column("start_c", Kind::Number, "deg", "where the move begins", UNKNOWN),
    column("start_u", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("start_v", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("start_w", Kind::Number, "mm", "where the move begins", UNKNOWN),
    column("x", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("y", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("z", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("a", Kind::Number, "deg", "where the move ends", UNKNOWN),
    column("b", Kind::Number, "deg", "where the move ends", UNKNOWN),
    column("c", Kind::Number, "deg", "where the move ends", UNKNOWN),
    column("u", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("v", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("w", Kind::Number, "mm", "where the move ends", UNKNOWN),
    column("i", Kind::Number, "mm", "X of the centre, absolute", NO_CENTER),
    column("j", Kind::Number, "mm", "Y of the centre, absolute", NO_CENTER),
    column("k", Kind::Number, "mm", "Z of the centre, absolute", NO_CENTER),
    column("radius", Kind::Number, "mm", "radius of the arc", NO_ARC),
    column("sweep", Kind::Number, "deg", "angle of the arc, counter-clockwise positive; may exceed a turn", NO_ARC),
    column("plane", Kind::Word, "", "plane of the arc: `XY`, `ZX` or `YZ`", NO_ARC),
    column("lead", Kind::Number, "mm", "way along the path a turn of the spindle", "no thread"),
    column("feed", Kind::Number, "", "feed along the path; `feed_mode` says its unit", "rapid or thread"),
    column(
        "feed_mode",
        Kind::Word,
        "",
        "`per_minute` (mm/min; deg/min where only rotary axes move), `per_revolution` (mm) or `inverse_time` (moves a minute)",
        "rapid or thread",
    ),
    column("spindle", Kind::Number, "", "S of the first spindle; `spindle_mode` says its unit", "not said yet"),
    column(
        "spindle_mode",
        Kind::Word,
        "",
        "`speed` (rev/min) or `cutting_speed` (m/min, kept constant)",
        "not said yet",
    ),
    column("spindle_limit", Kind::Number, "rev/min", "most turns under a constant cutting speed", "no limit"),
    column("spindle_direction", Kind::Word, "", "`cw`, `ccw` or `off`", "not said yet"),
    column("tool", Kind::Whole, "", "number of the tool in the spindle", "none was changed in yet"),
    column("compensation", Kind::Word, "", "side of the radius compensation: `left` or `right`", "none"),
    column("machine", Kind::Truth, "", "the end is in machine coordinates", ""),
    column(
        "length",
        Kind::Number,
        "mm",
        "way of the move; degrees where only rotary axes move; under a transformation the way along the contour",
        "the start is not known",
    ),
    column("time", Kind::Number, "s", "time of the move by the model of `partc stats`", "start or speed is not known"),
    column("file", Kind::Word, "", "file of the block", ""),
    column("line", Kind::Whole, "", "line of the block in its file, from 1", ""),
    column("block", Kind::Text, "", "number of the block as written, such as `14` or `N40`", "it has none"),
    column(
        "call_path",
        Kind::Word,
        "",
        "calls that lead there, the outermost first: `MAIN.H:12 > SUB.H:3`",
        "a block of the main program",
    ),
    column(
        "tx",
        Kind::Number,
        "",
        "X of the direction of the tool, Z of a tilted plane; 0, 0, 1 without one",
        NO_DIRECTION,
    ),
    column("ty", Kind::Number, "", "its Y", NO_DIRECTION),
    column("tz", Kind::Number, "", "its Z", NO_DIRECTION),
];

/// The schema of every batch. Its metadata hold [`VERSION`]; those of a field its unit.
pub fn schema() -> SchemaRef {
    static SCHEMA: LazyLock<SchemaRef> = LazyLock::new(|| Arc::new(made()));
    Arc::clone(&SCHEMA)
}

fn made() -> Schema {
    let fields: Vec<Field> = COLUMNS
        .iter()
        .map(|column| {
            let data = match column.kind {
                Kind::Number => DataType::Float64,
                Kind::Whole => DataType::Int64,
                Kind::Truth => DataType::Boolean,
                Kind::Word => DataType::Dictionary(Box::new(DataType::Int32), Box::new(DataType::Utf8)),
                Kind::Text => DataType::Utf8,
            };
            let field = Field::new(column.name, data, !column.null.is_empty());
            if column.unit.is_empty() { field } else { field.with_metadata(pairs(&[("unit", column.unit)])) }
        })
        .collect();
    let about = [(VERSION_KEY, VERSION), (MADE_BY_KEY, env!("CARGO_PKG_VERSION"))];
    Schema::new_with_metadata(fields, pairs(&about))
}

fn pairs(list: &[(&str, &str)]) -> Metadata {
    list.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect()
}
