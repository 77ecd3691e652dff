//! `partc config`: the configuration in force, and the schema of its file.

use crate::machine::tree::Value;
use crate::machine::{schema, show};
use crate::text::decode::escaped_json;

use super::args::Config;
use super::config::{NAME, set, settings, tree_for};
use super::listing::print;
use super::options::Format;
use super::program::dialect_of;
use super::{Exit, Trouble};

/// `partc config`
pub(super) fn config(args: &Config) -> Result<Exit, Trouble> {
    let Some(path) = &args.show else {
        return print(format!("{:#}\n", schema::schema()).as_bytes());
    };
    if !path.exists() {
        return Err(format!("{}: no such file or folder", path.display()));
    }
    // The folder of a program in it is the folder itself.
    let input = if path.is_dir() { path.join(NAME) } else { path.clone() };
    // What cannot be used is not in force.
    settings(&input, &args.common)?;
    let mut tree = tree_for(&input, &args.common)?;
    let text = |value: &String| Value::Text(value.clone());
    for (section, key, value) in [
        ("tools", "table", args.common.tools.as_ref().map(|path| Value::Text(path.to_string_lossy().into_owned()))),
        ("output", "target", args.common.target.as_ref().map(text)),
        ("output", "line_numbers", args.common.numbers.map(|step| Value::Whole(i64::from(step)))),
        ("output", "compensation", args.common.compensation.as_ref().map(text)),
    ] {
        if let Some(value) = value {
            set(&mut tree, section, key, value);
        }
    }
    let text = match args.common.report.format {
        Some(Format::Json) => format!("{}\n", show::json(&tree)),
        None | Some(Format::Human | Format::Concise) => show::toml_of(&tree, dialect_of(path, &args.common)),
        Some(_) => return Err("`partc config` writes human or json".to_owned()),
    };
    // Escapes of JSON are those of TOML, too.
    print(escaped_json(&text).as_bytes())
}
