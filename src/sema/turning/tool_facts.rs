//! What the configuration knows of the tool in the cutting position.

use crate::diag::{Answer, Fault, codes};
use crate::ir::cycle::recess::RecessTool;
use crate::machine::tools::Corner;
use crate::machine::{Settings, Tool};

/// The tool in the cutting position.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActiveTool {
    pub number: u32,
    /// Its edge: 0 for the only one.
    pub edge: u8,
    /// Its name of the turret section.
    pub name: Option<String>,
}

impl ActiveTool {
    /// The number that it is printed by.
    pub fn printed(&self, settings: &Settings) -> Result<u32, Fault> {
        let ActiveTool { number, edge, name } = self;
        let tools = &settings.tools;
        let known = match tools.by_number(*number, *edge) {
            Some(tool) => tool.number,
            None => name.as_deref().and_then(|name| tools.by_name(name)).and_then(|(own, tool)| own.or(tool.number)),
        };
        match known {
            Some(printed) => Ok(printed),
            None if *edge == 0 => Ok(*number),
            None => Err(codes::T2007::edge_of_tool_has_no_tool_number(edge, number)
                .answer(Answer::tool(format!("{number}.{edge}"), "number"))),
        }
    }

    /// What partc.toml says of it.
    pub fn known<'s>(&self, settings: &'s Settings) -> Option<&'s Tool> {
        let by_name = || self.name.as_deref().and_then(|name| settings.tools.by_name(name)).map(|(_, tool)| tool);
        settings.tools.by_number(self.number, self.edge).or_else(by_name)
    }

    /// The same as a recessing tool, and whether it cuts radially.
    pub fn recess_tool(&self, settings: &Settings) -> Result<(RecessTool, bool), Fault> {
        let known = self.known(settings);
        let radial = match known.and_then(|tool| tool.kind.as_deref()) {
            Some("recess-radial") => Some(true),
            Some("recess-axial") => Some(false),
            _ => None,
        };
        let data = known.and_then(|tool| Some((tool.width?, tool.radius?, tool.reference)));
        let (Some(radial), Some((width, nose, reference))) = (radial, data) else {
            let number = self.number;
            return Err(codes::P2004::kind_width_or_nose_radius_of_recessing(&number).answers([
                Answer::tool(number, "kind").one_of(&["\"recess-radial\"", "\"recess-axial\""]),
                Answer::tool(number, "width"),
                Answer::tool(number, "radius"),
            ]));
        };
        let edge = match reference {
            Corner::Minus => 0.0,
            Corner::Plus => -width,
            Corner::Middle => -width / 2.0,
        };
        Ok((RecessTool { width, nose, edge }, radial))
    }
}
