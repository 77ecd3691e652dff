//! Documents, messages and answers.

use std::collections::BTreeMap;

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types as lsp;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::diag::Severity;
use crate::driver::Session;
use crate::machine::Settings;
use crate::text::{FileError, FileId, Files, Memory, Opened, Request as FileRequest, Span};

use super::document::{Document, World};
use super::study::{Study, study};
use super::text::{Columns, Text};
use super::{actions, completion, hints, hover, names, symbols, tokens};

/// Steps of a program between two keys.
const MOST_STEPS: u64 = 1_000_000;

/// Called programs, with the text of open documents in place of their files.
struct WithOpen<'a> {
    files: &'a dyn Files,
    open: BTreeMap<&'a str, &'a str>,
}

impl Files for WithOpen<'_> {
    fn open(&self, request: &FileRequest<'_>) -> Result<Opened, FileError> {
        let mut opened = self.files.open(request)?;
        if let Some(text) = self.open.get(opened.identity.as_str()) {
            opened.text = Box::new(Memory::new(text.as_bytes()));
        }
        Ok(opened)
    }

    fn copy_of(&self, folder: &str) -> Option<(String, &'static str)> {
        self.files.copy_of(folder)
    }

    fn home(&self) -> Option<&str> {
        self.files.home()
    }
}

/// The state of a session with an editor.
#[derive(Debug)]
pub struct Server<W> {
    world: W,
    documents: BTreeMap<String, Document>,
    columns: Columns,
    /// The client asks for hints anew when it is told to.
    refreshes_hints: bool,
    asked: i32,
    shut: bool,
}

impl<W: World> Server<W> {
    /// A server for a client that can do so much.
    pub fn new(world: W, client: &lsp::ClientCapabilities) -> Server<W> {
        let general = client.general.as_ref().and_then(|general| general.position_encodings.as_deref());
        let inlay = client.workspace.as_ref().and_then(|workspace| workspace.inlay_hint.as_ref());
        Server {
            world,
            documents: BTreeMap::new(),
            columns: Columns::of(general.unwrap_or_default()),
            refreshes_hints: inlay.and_then(|inlay| inlay.refresh_support).unwrap_or(false),
            asked: 0,
            shut: false,
        }
    }

    /// What the server can do.
    pub fn capabilities(&self) -> lsp::ServerCapabilities {
        lsp::ServerCapabilities {
            position_encoding: Some(self.columns.kind()),
            text_document_sync: Some(lsp::TextDocumentSyncCapability::Kind(lsp::TextDocumentSyncKind::INCREMENTAL)),
            hover_provider: Some(lsp::HoverProviderCapability::Simple(true)),
            definition_provider: Some(lsp::OneOf::Left(true)),
            references_provider: Some(lsp::OneOf::Left(true)),
            document_highlight_provider: Some(lsp::OneOf::Left(true)),
            document_symbol_provider: Some(lsp::OneOf::Left(true)),
            folding_range_provider: Some(lsp::FoldingRangeProviderCapability::Simple(true)),
            inlay_hint_provider: Some(lsp::OneOf::Left(true)),
            rename_provider: Some(lsp::OneOf::Right(lsp::RenameOptions {
                prepare_provider: Some(true),
                work_done_progress_options: lsp::WorkDoneProgressOptions::default(),
            })),
            code_action_provider: Some(lsp::CodeActionProviderCapability::Simple(true)),
            completion_provider: Some(lsp::CompletionOptions::default()),
            semantic_tokens_provider: Some(lsp::SemanticTokensServerCapabilities::SemanticTokensOptions(
                lsp::SemanticTokensOptions {
                    legend: tokens::legend(),
                    full: Some(lsp::SemanticTokensFullOptions::Bool(true)),
                    range: Some(true),
                    ..lsp::SemanticTokensOptions::default()
                },
            )),
            ..lsp::ServerCapabilities::default()
        }
    }

    /// Takes a message; answers go to `out`. False where it was the last one.
    pub fn handle(&mut self, message: Message, out: &mut Vec<Message>) -> bool {
        match message {
            Message::Request(request) => out.push(Message::Response(self.answer(request))),
            Message::Notification(said) => {
                if said.method == "exit" {
                    return false;
                }
                self.hear(said, out);
            }
            // Nothing is asked whose answer matters.
            Message::Response(_) => {}
        }
        true
    }

    /// Did the client say that it is about to go?
    pub fn was_shut_down(&self) -> bool {
        self.shut
    }

    /// Is there something to do before the next message?
    pub fn is_behind(&self) -> bool {
        self.documents.values().any(|document| document.unsaid)
    }

    /// Publishes what is known of the documents that changed. A check that is not wanted any more, since there `is_more` to
    /// hear, is given up, and made anew the next time.
    pub fn catch_up(&mut self, is_more: &dyn Fn() -> bool, out: &mut Vec<Message>) {
        let uris: Vec<String> =
            self.documents.iter().filter(|(_, document)| document.unsaid).map(|(uri, _)| uri.clone()).collect();
        let mut said = false;
        for uri in &uris {
            self.study_while(uri, &|| !is_more());
            let studied = self.documents.get(uri).is_some_and(|document| document.study.is_some());
            if !studied {
                break;
            }
            said = true;
            if let Some(document) = self.documents.get_mut(uri) {
                document.unsaid = false;
                let params = published(document, &self.world);
                out.push(notification("textDocument/publishDiagnostics", &params));
            }
        }
        if self.refreshes_hints && said {
            self.asked += 1;
            let method = "workspace/inlayHint/refresh".to_owned();
            out.push(Message::Request(Request { id: RequestId::from(self.asked), method, params: Value::Null }));
        }
    }

    /// The text of an open document.
    #[cfg(test)]
    pub fn text(&self, uri: &str) -> Option<&str> {
        self.documents.get(uri).map(|document| document.text.as_str())
    }

    fn hear(&mut self, said: Notification, out: &mut Vec<Message>) {
        match said.method.as_str() {
            "textDocument/didOpen" => {
                let Some(lsp::DidOpenTextDocumentParams { text_document: opened }) = read(said.params) else { return };
                let key = opened.uri.as_str().to_owned();
                let identity = self.world.identity(&key);
                let document = Document {
                    version: opened.version,
                    language: opened.language_id,
                    text: Text::new(opened.text, self.columns),
                    uri: opened.uri,
                    identity,
                    study: None,
                    dialect: None,
                    trouble: None,
                    unsaid: true,
                };
                self.documents.insert(key, document);
                self.forget_studies();
            }
            "textDocument/didChange" => {
                let Some(changed) = read::<lsp::DidChangeTextDocumentParams>(said.params) else { return };
                let Some(document) = self.documents.get_mut(changed.text_document.uri.as_str()) else { return };
                document.version = changed.text_document.version;
                for change in changed.content_changes {
                    document.text.change(change.range, &change.text);
                }
                let identity = document.identity.clone();
                self.forget_studies_of(&identity);
            }
            "textDocument/didClose" => {
                let Some(closed) = read::<lsp::DidCloseTextDocumentParams>(said.params) else { return };
                self.documents.remove(closed.text_document.uri.as_str());
                let params = lsp::PublishDiagnosticsParams::new(closed.text_document.uri, Vec::new(), None);
                out.push(notification("textDocument/publishDiagnostics", &params));
                self.forget_studies();
            }
            // A configuration, a tool table or a called program may be another one.
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" | "workspace/didChangeConfiguration" => {
                self.forget_studies();
            }
            _ => {}
        }
    }

    /// The text of a file changed: it counts for its document, and for those that call it.
    fn forget_studies_of(&mut self, identity: &str) {
        for document in self.documents.values_mut() {
            let calls = |study: &Study| study.files.iter().any(|(_, file)| file == identity);
            if document.identity == identity || document.study.as_ref().is_none_or(calls) {
                document.study = None;
                document.unsaid = true;
            }
        }
    }

    /// A document may be called by any other one.
    fn forget_studies(&mut self) {
        for document in self.documents.values_mut() {
            document.study = None;
            document.unsaid = true;
        }
    }

    /// The document, with a study of its text where there can be one.
    fn study(&mut self, uri: &str) -> Option<&Document> {
        self.study_while(uri, &|| true)?;
        let document = self.documents.get_mut(uri)?;
        if let (Some(study), Some(dialect)) = (&mut document.study, document.dialect) {
            study.look_up(document.text.as_str(), dialect);
        }
        Some(document)
    }

    /// The same, with no study where it does not go on to its end.
    fn study_while(&mut self, uri: &str, goes_on: &dyn Fn() -> bool) -> Option<&Document> {
        let document = self.documents.get(uri)?;
        if document.study.is_none() {
            let made = self.world.setting(uri, &document.language, document.text.as_str()).map(|setting| {
                let setting = setting?;
                let files = WithOpen { files: setting.files.as_ref(), open: self.open_beside(document) };
                let settings = bounded(setting.settings);
                let (name, text) = (setting.name.as_str(), document.text.as_str());
                let made = study(name, &setting.identity, text, setting.dialect, &settings, &files, goes_on);
                Some((made, setting.dialect))
            });
            let document = self.documents.get_mut(uri)?;
            match made {
                Ok(Some((made, dialect))) => {
                    (document.study, document.dialect, document.trouble) = (made, Some(dialect), None);
                }
                Ok(None) => (document.study, document.dialect, document.trouble) = (Some(Study::default()), None, None),
                Err(trouble) => {
                    (document.study, document.trouble) = (Some(Study::default()), Some(trouble));
                }
            }
        }
        self.documents.get(uri)
    }

    fn answer(&mut self, request: Request) -> Response {
        let Request { id, method, params } = request;
        if self.shut {
            return Response::new_err(id, ErrorCode::InvalidRequest as i32, "the server was shut down".to_owned());
        }
        if method == "shutdown" {
            self.shut = true;
            return Response::new_ok(id, Value::Null);
        }
        match self.result(&method, params) {
            Some(Ok(result)) => Response::new_ok(id, result),
            Some(Err(why)) => Response::new_err(id, ErrorCode::InvalidParams as i32, why),
            None => Response::new_err(id, ErrorCode::MethodNotFound as i32, format!("no method {method}")),
        }
    }

    fn result(&mut self, method: &str, params: Value) -> Option<Result<Value, String>> {
        use lsp::{CodeActionParams, CompletionParams, HoverParams, InlayHintParams};
        use lsp::{DocumentHighlightParams, DocumentSymbolParams, FoldingRangeParams, GotoDefinitionParams};
        use lsp::{ReferenceParams, SemanticTokensParams, SemanticTokensRangeParams, TextDocumentPositionParams};
        Some(match method {
            "textDocument/hover" => self.with(
                params,
                |p: &HoverParams| &p.text_document_position_params.text_document,
                |doc, p| Ok(hover::hover(doc, p.text_document_position_params.position)),
            ),
            "textDocument/inlayHint" => {
                self.with(params, |p: &InlayHintParams| &p.text_document, |doc, p| Ok(hints::hints(doc, p.range)))
            }
            "textDocument/documentSymbol" => {
                self.with(params, |p: &DocumentSymbolParams| &p.text_document, |doc, _| Ok(symbols::symbols(doc)))
            }
            "textDocument/foldingRange" => {
                self.with(params, |p: &FoldingRangeParams| &p.text_document, |doc, _| Ok(symbols::folds(doc)))
            }
            "textDocument/definition" => self.with_world(
                params,
                |p: &GotoDefinitionParams| &p.text_document_position_params.text_document,
                |doc, p, world| Ok(names::definition(doc, p.text_document_position_params.position, world)),
            ),
            "textDocument/references" => self.with(
                params,
                |p: &ReferenceParams| &p.text_document_position.text_document,
                |doc, p| Ok(names::references(doc, p.text_document_position.position, p.context.include_declaration)),
            ),
            "textDocument/documentHighlight" => self.with(
                params,
                |p: &DocumentHighlightParams| &p.text_document_position_params.text_document,
                |doc, p| Ok(names::highlights(doc, p.text_document_position_params.position)),
            ),
            "textDocument/prepareRename" => self.with(
                params,
                |p: &TextDocumentPositionParams| &p.text_document,
                |doc, p| Ok(names::can_rename(doc, p.position)),
            ),
            "textDocument/rename" => self.rename(params),
            "textDocument/codeAction" => {
                self.with(params, |p: &CodeActionParams| &p.text_document, |doc, p| Ok(actions::actions(doc, p.range)))
            }
            "textDocument/completion" => self.with(
                params,
                |p: &CompletionParams| &p.text_document_position.text_document,
                |doc, p| Ok(completion::complete(doc, p.text_document_position.position)),
            ),
            "textDocument/semanticTokens/full" => {
                self.with(params, |p: &SemanticTokensParams| &p.text_document, |doc, _| Ok(tokens::tokens(doc, None)))
            }
            "textDocument/semanticTokens/range" => self.with(
                params,
                |p: &SemanticTokensRangeParams| &p.text_document,
                |doc, p| Ok(tokens::tokens(doc, Some(p.range))),
            ),
            _ => return None,
        })
    }

    /// Another name, if the program does the same with it.
    fn rename(&mut self, params: Value) -> Result<Value, String> {
        let params: lsp::RenameParams = serde_json::from_value(params).map_err(|error| error.to_string())?;
        let place = params.text_document_position;
        let uri = place.text_document.uri.as_str();
        self.study(uri);
        let document = self.documents.get(uri).ok_or_else(|| format!("{uri} is not open"))?;
        let calls = |other: &Document| {
            other.identity != document.identity
                && other.study.iter().flat_map(|study| &study.files).any(|(_, file)| *file == document.identity)
        };
        let shared = self.documents.values().any(calls) || document.study.iter().any(|study| study.files.len() > 1);
        let edit = names::rename(document, place.position, &params.new_name, shared)?;
        let mut changed = document.text.clone();
        let edits = edit.changes.iter().flat_map(|changes| changes.values().flatten());
        let mut edits: Vec<&lsp::TextEdit> = edits.collect();
        edits.sort_by_key(|edit| std::cmp::Reverse((edit.range.start.line, edit.range.start.character)));
        for edit in edits {
            changed.change(Some(edit.range), &edit.new_text);
        }
        let [before, after] = [document.text.as_str(), changed.as_str()].map(|text| self.fingerprint(document, text));
        if before? != after? {
            return Err(format!("with `{}` the program would do something else", params.new_name));
        }
        serde_json::to_value(edit).map_err(|error| error.to_string())
    }

    /// What the document would do with this text, as one number, and how many errors it would have.
    fn fingerprint(&self, document: &Document, text: &str) -> Result<(u128, u32), String> {
        let setting = self.world.setting(document.uri.as_str(), &document.language, text)?;
        let setting = setting.ok_or("the language of the program is not known")?;
        let main = Opened {
            name: setting.name.clone(),
            identity: setting.identity.clone(),
            text: Box::new(Memory::new(text.as_bytes())),
        };
        let session = Session::new(main);
        let files = WithOpen { files: setting.files.as_ref(), open: self.open_beside(document) };
        let number = session.fingerprint(setting.dialect, &bounded(setting.settings.clone()), &files);
        Ok((number, session.diags.errors()))
    }

    /// The texts of the other documents, by what tells their files apart.
    fn open_beside(&self, document: &Document) -> BTreeMap<&str, &str> {
        let others = self.documents.values().filter(|other| other.identity != document.identity);
        others.map(|other| (other.identity.as_str(), other.text.as_str())).collect()
    }

    fn with<P: DeserializeOwned, R: Serialize>(
        &mut self,
        params: Value,
        of: impl Fn(&P) -> &lsp::TextDocumentIdentifier,
        answer: impl Fn(&Document, &P) -> Result<R, String>,
    ) -> Result<Value, String> {
        self.with_world(params, of, |document, params, _| answer(document, params))
    }

    fn with_world<P: DeserializeOwned, R: Serialize>(
        &mut self,
        params: Value,
        of: impl Fn(&P) -> &lsp::TextDocumentIdentifier,
        answer: impl Fn(&Document, &P, &W) -> Result<R, String>,
    ) -> Result<Value, String> {
        let params: P = serde_json::from_value(params).map_err(|error| error.to_string())?;
        let uri = of(&params).uri.as_str();
        if self.study(uri).is_none() {
            return Err(format!("{uri} is not open"));
        }
        let document = self.documents.get(uri).ok_or_else(String::new)?;
        serde_json::to_value(answer(document, &params, &self.world)?).map_err(|error| error.to_string())
    }
}

/// An editor does not wait for a program without an end.
fn bounded(mut settings: Settings) -> Settings {
    settings.limits.steps = settings.limits.steps.min(MOST_STEPS);
    settings
}

fn read<P: DeserializeOwned>(params: Value) -> Option<P> {
    serde_json::from_value(params).ok()
}

fn notification<P: Serialize>(method: &str, params: &P) -> Message {
    Message::Notification(Notification::new(method.to_owned(), params))
}

/// The findings of a document as the protocol has them.
fn published<W: World>(document: &Document, world: &W) -> lsp::PublishDiagnosticsParams {
    let mut list = Vec::new();
    if let Some(trouble) = &document.trouble {
        let line = lsp::Range { start: lsp::Position::default(), end: lsp::Position::default() };
        list.push(diagnostic(line, lsp::DiagnosticSeverity::ERROR, trouble.clone()));
    }
    for found in document.study.iter().flat_map(|study| &study.findings) {
        let severity = match found.severity {
            Severity::Error => lsp::DiagnosticSeverity::ERROR,
            Severity::Warning => lsp::DiagnosticSeverity::WARNING,
            Severity::Note => lsp::DiagnosticSeverity::INFORMATION,
        };
        let mut shown = diagnostic(document.text.range(found.span), severity, found.message.clone());
        shown.code = Some(lsp::NumberOrString::String(found.code.id.to_owned()));
        let here = |(span, text): &(Span, String)| lsp::DiagnosticRelatedInformation {
            location: lsp::Location { uri: document.uri.clone(), range: document.text.range(*span) },
            message: text.clone(),
        };
        let mut related: Vec<lsp::DiagnosticRelatedInformation> = found.more.iter().map(here).collect();
        related.extend(found.elsewhere.and_then(|place| elsewhere(document, place, &found.message, world)));
        shown.related_information = (!related.is_empty()).then_some(related);
        list.push(shown);
    }
    lsp::PublishDiagnosticsParams { uri: document.uri.clone(), diagnostics: list, version: Some(document.version) }
}

fn diagnostic(range: lsp::Range, severity: lsp::DiagnosticSeverity, message: String) -> lsp::Diagnostic {
    let source = Some("partc".to_owned());
    lsp::Diagnostic { range, severity: Some(severity), source, message, ..lsp::Diagnostic::default() }
}

/// The place of a finding in a called program.
fn elsewhere<W: World>(
    document: &Document,
    (file, line, column): (FileId, u32, u32),
    message: &str,
    world: &W,
) -> Option<lsp::DiagnosticRelatedInformation> {
    let (_, identity) = document.study.as_ref()?.files.get(usize::from(file.0))?;
    let at = lsp::Position { line: line.saturating_sub(1), character: column.saturating_sub(1) };
    let location = lsp::Location { uri: world.uri(identity)?.parse().ok()?, range: lsp::Range { start: at, end: at } };
    Some(lsp::DiagnosticRelatedInformation { location, message: message.lines().next().unwrap_or_default().to_owned() })
}
