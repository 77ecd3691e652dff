//! An open document, and what it is to the file system.

use lsp_types as lsp;

use crate::dialect::Dialect;
use crate::machine::Settings;
use crate::text::Files;

use super::study::Study;
use super::text::Text;

/// What a document is to the file system: the command line knows, tests make it up.
pub trait World {
    /// What a document with this text is compiled with; `None` where it is in no language of parts.
    ///
    /// # Errors
    /// The configuration cannot be read.
    fn setting(&self, uri: &str, language: &str, text: &str) -> Result<Option<Setting>, String>;
    /// What tells the file of `uri` apart, as [`Opened::identity`] does.
    fn identity(&self, uri: &str) -> String;
    /// The address of a file.
    fn uri(&self, identity: &str) -> Option<String>;
}

/// See [`World::setting`].
pub struct Setting {
    pub name: String,
    pub identity: String,
    pub dialect: &'static Dialect,
    pub settings: Settings,
    pub files: Box<dyn Files>,
}

impl std::fmt::Debug for Setting {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Setting").field("name", &self.name).field("dialect", &self.dialect).finish_non_exhaustive()
    }
}

/// An open document.
#[derive(Debug)]
pub struct Document {
    pub uri: lsp::Uri,
    pub version: i32,
    pub language: String,
    pub text: Text,
    pub identity: String,
    /// `None` where the text changed since, or where there is none.
    pub study: Option<Study>,
    pub dialect: Option<&'static Dialect>,
    /// Why there is no study.
    pub trouble: Option<String>,
    /// Its findings are to be published.
    pub unsaid: bool,
}
