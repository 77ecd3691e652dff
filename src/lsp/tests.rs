//! Any messages in any order: answers, never a panic, and findings as if the document were new.

use lsp_server::{Message, Notification, Request, RequestId};
use proptest::prelude::*;
use serde_json::{Value, json};

use super::study::Survey;
use super::{Server, Setting, World};
use crate::dialect;
use crate::driver::Session;
use crate::lint::lead;
use crate::machine::Settings;
use crate::sema::Job;
use crate::sema::run::survey::{Surveyed, Visitor, Wanted};
use crate::text::files::NoFiles;
use crate::text::{FileId, Memory, Opened};

/// Documents without files.
#[derive(Debug)]
struct Nowhere;

impl World for Nowhere {
    fn setting(&self, uri: &str, _: &str, text: &str) -> Result<Option<Setting>, String> {
        let Some(dialect) = dialect::guess(uri, text.as_bytes()) else { return Ok(None) };
        let (name, identity) = (uri.to_owned(), uri.to_owned());
        Ok(Some(Setting { name, identity, dialect, settings: Settings::default(), files: Box::new(NoFiles) }))
    }

    fn identity(&self, uri: &str) -> String {
        uri.to_owned()
    }

    fn uri(&self, identity: &str) -> Option<String> {
        Some(identity.to_owned())
    }
}

const PROGRAM: &str = "0 BEGIN PGM T MM\r\n1 L X+0 Y+0 Z+5 FMAX\r\n2 CC X+50 Y+50\r\n3 LP PR+20 PA+30 F500 ; \u{e4}\u{1f600}\r\n\
4 Q1 = 5\r\n5 LBL 5\r\n6 L IX+Q1\r\n7 CALL LBL 5 REP 3\r\n8 CYCL DEF 200 DRILLING ~\r\n  Q200=2 ~\r\n  Q201=-20\r\n9 END PGM T MM\r\n";

fn say(method: &str, params: Value) -> Message {
    Message::Notification(Notification { method: method.to_owned(), params })
}

fn ask(method: &str, params: Value) -> Message {
    Message::Request(Request { id: RequestId::from(1), method: method.to_owned(), params })
}

fn open(uri: &str, text: &str) -> Message {
    say("textDocument/didOpen", json!({ "textDocument": { "uri": uri, "languageId": "", "version": 1, "text": text } }))
}

fn server() -> Server<Nowhere> {
    Server::new(Nowhere, &lsp_types::ClientCapabilities::default())
}

/// What is published of a document that was just opened.
fn findings(uri: &str, text: &str) -> Value {
    let (mut server, mut out) = (server(), Vec::new());
    server.handle(open(uri, text), &mut out);
    server.catch_up(&|| false, &mut out);
    published(&out)
}

fn published(out: &[Message]) -> Value {
    let last = out.iter().rev().find_map(|message| match message {
        Message::Notification(said) => Some(said.params["diagnostics"].clone()),
        _ => None,
    });
    last.unwrap_or_default()
}

#[test]
fn a_check_gives_way_to_what_comes() {
    let (mut server, mut out) = (server(), Vec::new());
    server.handle(open("file:///T.H", PROGRAM), &mut out);
    server.catch_up(&|| true, &mut out);
    assert!(out.is_empty() && server.is_behind(), "{out:?}");
    server.catch_up(&|| false, &mut out);
    assert_eq!(published(&out), findings("file:///T.H", PROGRAM));
    assert!(!server.is_behind());
}

/// A survey that looks at each line as a whole.
#[derive(Default)]
struct Whole(Survey);

impl Visitor for Whole {
    fn wanted(&self) -> Wanted<'_> {
        Wanted::ALL
    }

    fn items(&self) -> bool {
        true
    }

    fn block(&mut self, block: &Surveyed<'_>, job: &Job<'_>) {
        self.0.block(block, job);
    }
}

proptest! {
    #[test]
    fn straight_lines_have_their_places(
        lines in prop::collection::vec(
            ("[0-9]{0,3} ?L [XY][+-][0-9]{1,7}( F[0-9]{3})? {0,2}|[0-9]{1,3} L X\\+Q1|N?[0-9]{0,3} ?(G1 )?X[0-9]{1,7} {0,2}|; X", 1..9usize),
            1..12,
        ),
        end in prop::sample::select(vec!["\n", "\r\n"]),
    ) {
        let lines: Vec<&str> = lines.iter().flat_map(|(line, times)| vec![line.as_str(); *times]).collect();
        let text = lines.join(end);
        for dialect in ["klartext", "sinumerik"] {
            let text = Box::new(Memory::new(text.as_bytes().to_vec()));
            let session = Session::new(Opened { name: "A".to_owned(), identity: "A".to_owned(), text });
            let survey = dialect::find(dialect).expect("a dialect").survey;
            let (mut places, mut whole) = (Survey::default(), Whole::default());
            lead(&session.sources, FileId(0), survey, &mut places);
            lead(&session.sources, FileId(0), survey, &mut whole);
            prop_assert_eq!(format!("{:?}", places), format!("{:?}", whole.0));
        }
    }
}

const ASKED: [&str; 13] = [
    "textDocument/hover",
    "textDocument/inlayHint",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/documentHighlight",
    "textDocument/prepareRename",
    "textDocument/rename",
    "textDocument/codeAction",
    "textDocument/completion",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/range",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn edits_and_questions_in_any_order(
        steps in prop::collection::vec(
            (0usize..16, 0u32..14, 0u32..30, 0u32..14, 0u32..30, "[ -~\r\n\u{e4}\u{1f600}]{0,9}"),
            1..10,
        ),
    ) {
        let uri = "file:///T.H";
        let (mut server, mut out) = (server(), Vec::new());
        server.handle(open(uri, PROGRAM), &mut out);
        for (what, line, character, to_line, to_character, text) in steps {
            let position = json!({ "line": line, "character": character });
            let range = json!({ "start": position, "end": { "line": to_line, "character": to_character } });
            let document = json!({ "uri": uri, "version": 2 });
            match ASKED.get(what) {
                Some(method) => {
                    let params = json!({
                        "textDocument": { "uri": uri }, "position": position, "range": range, "newName": text,
                        "context": { "diagnostics": [], "includeDeclaration": true, "triggerKind": 1 },
                    });
                    server.handle(ask(method, params), &mut out);
                    let Some(Message::Response(answer)) = out.last() else { panic!("{method} has no answer") };
                    prop_assert!(answer.response_result.is_ok() || *method == "textDocument/rename", "{answer:?}");
                }
                None => {
                    let changes = json!([{ "range": range, "text": text }]);
                    server.handle(
                        say("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes })),
                        &mut out,
                    );
                }
            }
        }
        server.catch_up(&|| false, &mut out);
        let text = server.text(uri).unwrap_or_default().to_owned();
        prop_assert_eq!(published(&out), findings(uri, &text));
    }
}
