//! The JSON Schema of `partc.toml`, made from [`SECTIONS`], for editors that complete and check TOML.

use serde_json::{Map, Value, json};

use super::keys::{Key, Kind, SECTIONS, Section};
use super::tree;

/// The schema as a document.
pub fn schema() -> Value {
    let mut properties = Map::new();
    properties.insert(
        "extend".to_owned(),
        json!({ "type": "string", "description": "another configuration file, which this one extends" }),
    );
    for section in SECTIONS {
        properties.insert(section.name.to_owned(), section_schema(section));
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "partc.toml",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
    })
}

fn section_schema(section: &Section) -> Value {
    let mut schema = object(section.keys());
    schema.insert("description".to_owned(), json!(section.doc));
    let others = if !section.entry.is_empty() {
        Value::Object(object(section.entry.iter()))
    } else if section.keys.is_empty() {
        // Any name: numbers, texts, or tables of them.
        json!({ "type": ["number", "object", "string"] })
    } else {
        json!(false)
    };
    schema.insert("additionalProperties".to_owned(), others);
    Value::Object(schema)
}

fn object<'k>(keys: impl Iterator<Item = &'k Key>) -> Map<String, Value> {
    let properties: Map<String, Value> = keys.map(|key| (key.name.to_owned(), key_schema(key))).collect();
    let mut schema = Map::new();
    schema.insert("type".to_owned(), json!("object"));
    schema.insert("properties".to_owned(), Value::Object(properties));
    schema.insert("additionalProperties".to_owned(), json!(false));
    schema
}

fn key_schema(key: &Key) -> Value {
    let mut schema = match key.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Number => json!({ "type": "number" }),
        Kind::Whole => json!({ "type": "integer" }),
        Kind::Choice(choices) => json!({ "enum": choices }),
        Kind::Wholes => json!({ "type": "array", "items": { "type": "integer" } }),
        Kind::Digits => {
            json!({ "type": "array", "items": { "type": "integer", "minimum": 0, "maximum": 9 } })
        }
        Kind::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Kind::Free => json!({ "type": "object" }),
        Kind::Places => json!({ "type": ["integer", "object"] }),
        Kind::Corners => json!({ "anyOf": [
            { "enum": ["exact", "none"] },
            {
                "type": "object",
                "properties": { "tolerance": { "type": "number", "minimum": 0.001, "maximum": 1 } },
                "required": ["tolerance"],
                "additionalProperties": false
            }
        ] }),
        Kind::Words => json!({ "type": ["array", "object"] }),
        Kind::NumberOr(word) => json!({ "anyOf": [{ "type": "number" }, { "enum": [word] }] }),
    };
    schema["description"] = json!(key.doc);
    if let Some(default) = key.default_node() {
        schema["default"] = plain(&default.value);
    }
    schema
}

/// A value of the configuration as JSON.
pub fn plain(value: &tree::Value) -> Value {
    match value {
        tree::Value::Text(text) => json!(text),
        tree::Value::Whole(n) => json!(n),
        tree::Value::Number(x) => json!(x),
        tree::Value::Flag(flag) => json!(flag),
        tree::Value::List(items) => items.iter().map(|item| plain(&item.value)).collect(),
        tree::Value::Table(table) => {
            Value::Object(table.iter().map(|(key, node)| (key.clone(), plain(&node.value))).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_in_the_schema_with_its_text() {
        let schema = schema();
        for section in SECTIONS {
            let properties = &schema["properties"][section.name]["properties"];
            for key in section.keys() {
                assert_eq!(properties[key.name]["description"], json!(key.doc), "{}", key.name);
            }
        }
        assert_eq!(schema["properties"]["output"]["properties"]["line_numbers"]["default"], json!(0));
        assert_eq!(schema["properties"]["tools"]["additionalProperties"]["properties"]["radius"]["type"], "number");
        assert_eq!(schema["additionalProperties"], json!(false));
    }
}
