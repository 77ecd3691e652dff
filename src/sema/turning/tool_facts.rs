//! What the configuration knows of the tool in the cutting position.

use crate::diag::{Answer, Fault, codes};
use crate::ir::cycle::recess::RecessTool;
use crate::machine::tools::Corner;
use crate::machine::{Settings, Tool};

use super::state::State;

impl State {
    /// What partc.toml says of the tool in the cutting position.
    pub fn known_tool<'s>(&self, settings: &'s Settings) -> Option<&'s Tool> {
        let active = self.tool.as_ref()?;
        let by_name = || active.name.as_deref().and_then(|name| settings.tools.by_name(name)).map(|(_, tool)| tool);
        settings.tools.by_number(active.number, active.edge).or_else(by_name)
    }

    /// The tool in the cutting position as a recessing tool, and whether it cuts radially.
    pub fn recess_tool(&self, settings: &Settings) -> Result<(RecessTool, bool), Fault> {
        let Some(active) = &self.tool else { return Err(codes::P2004::no_tool_is_in_cutting_position()) };
        let known = self.known_tool(settings);
        let radial = match known.and_then(|tool| tool.kind.as_deref()) {
            Some("recess-radial") => Some(true),
            Some("recess-axial") => Some(false),
            _ => None,
        };
        let data = known.and_then(|tool| Some((tool.width?, tool.radius?, tool.reference)));
        let (Some(radial), Some((width, nose, reference))) = (radial, data) else {
            let number = active.number;
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
