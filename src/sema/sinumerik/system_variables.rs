//! System variables that the program wrote.

use std::collections::BTreeMap;

use crate::machine::table::Edge;

use super::value::Val;

/// The values by their names with indices: `$TC_DP6[1,1]`.
#[derive(Debug, Clone, Default)]
pub(super) struct SystemVariables {
    written: BTreeMap<String, Val>,
}

impl SystemVariables {
    /// Those that the tool data of the control have written before the program.
    pub fn of_edges(edges: &BTreeMap<Edge, f64>) -> SystemVariables {
        let value = |(edge, value): (&Edge, &f64)| {
            (format!("$TC_DP{}[{},{}]", edge.parameter, edge.tool, edge.edge), Val::Real(*value))
        };
        SystemVariables { written: edges.iter().map(value).collect() }
    }

    pub fn get(&self, key: &str) -> Option<&Val> {
        self.written.get(key)
    }

    pub fn number(&self, key: &str) -> Option<f64> {
        self.get(key).and_then(Val::number)
    }

    /// `$TC_DP…[tool,edge]`
    pub fn of_edge(&self, parameter: u8, tool: u32, edge: u32) -> Option<f64> {
        self.number(&format!("$TC_DP{parameter}[{tool},{edge}]"))
    }

    /// The tool that the program gave this name, `$TC_TP2[number]`.
    pub fn tool_named(&self, name: &str) -> Option<u32> {
        let named = |(key, value): (&String, &Val)| match value {
            Val::Text(text) if **text == *name.as_bytes() => {
                key.strip_prefix("$TC_TP2[")?.strip_suffix(']')?.parse::<u32>().ok()
            }
            _ => None,
        };
        self.written.iter().find_map(named)
    }

    pub fn set(&mut self, key: String, value: Val) {
        self.written.insert(key, value);
    }

    /// What the program wrote is no more what the control has.
    pub fn forget(&mut self, key: &str) {
        self.written.remove(key);
    }

    pub fn forget_where(&mut self, is_it: impl Fn(&str) -> bool) {
        self.written.retain(|key, _| !is_it(key));
    }

    pub fn is_written(&self, key: &str) -> bool {
        self.written.contains_key(key)
    }
}
