//! What is known of the edge in use: what the program wrote goes before the table, which knows that of D1.

use super::State;
use crate::machine::{Settings, Tool};

impl State {
    pub(super) fn active_tool(&self, settings: &Settings) -> Option<Tool> {
        let number = self.tool.active()?;
        let mut tool = settings.tools.called(number).cloned().unwrap_or_default();
        let edge = self.tool.edge_or_first();
        let written = self.system.of_edge(6, number, edge);
        let wear = self.system.of_edge(15, number, edge);
        tool.radius = written.or(tool.radius.filter(|_| edge == 1)).map(|radius| radius + wear.unwrap_or(0.0));
        Some(tool)
    }

    /// Position of a cutting edge: what the program wrote goes before the table, which knows that of D1.
    pub(super) fn edge_position(&self, settings: &Settings, number: u32, edge: u32) -> Option<f64> {
        let listed = || settings.tools.called(number).filter(|_| edge == 1)?.orientation.map(f64::from);
        self.system.of_edge(2, number, edge).or_else(listed)
    }

    /// The radius of the active edge with its wear: what the program wrote goes before the table.
    pub(super) fn known_radius(&self, settings: &Settings) -> Option<f64> {
        let (number, edge) = (self.tool.active()?, self.tool.edge_or_first());
        if self.system.is_written("$P_AD[6]") || self.system.is_written("$P_AD[15]") || self.tool.edge_in_doubt() {
            return None;
        }
        let written = |parameter: u8| self.system.of_edge(parameter, number, edge);
        // A tool that is called by its name stands under that in the table.
        let listed = || settings.tools.radius_of_called(number).filter(|_| edge == 1);
        Some(written(6).or_else(listed)? + written(15).unwrap_or(0.0))
    }
}
