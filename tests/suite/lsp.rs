//! `partc lsp` with a client that speaks the protocol.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

use super::cli_run::Folder;

/// A client, and the server it started.
struct Client {
    server: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    asked: i32,
    /// What was published last, by address.
    published: Vec<Value>,
}

impl Client {
    fn start(folder: &Folder, capabilities: Value) -> Client {
        let mut server = Command::new(env!("CARGO_BIN_EXE_partc"))
            .arg("lsp")
            .current_dir(&folder.0)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the server");
        let to = server.stdin.take().expect("its input");
        let from = BufReader::new(server.stdout.take().expect("its output"));
        let mut client = Client { server, to, from, asked: 0, published: Vec::new() };
        client.ask("initialize", json!({ "capabilities": capabilities, "processId": null, "rootUri": null }));
        client.say("initialized", json!({}));
        client
    }

    fn send(&mut self, message: Value) {
        let text = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("the server reads");
        self.to.flush().expect("the server reads");
    }

    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.from.read_line(&mut line).expect("a line") > 0, "the server is gone");
            match line.trim_end().split_once(": ") {
                Some(("Content-Length", number)) => length = number.parse().expect("a number"),
                Some(_) => {}
                None => break,
            }
        }
        let mut text = vec![0; length];
        self.from.read_exact(&mut text).expect("a message");
        serde_json::from_slice(&text).expect("JSON")
    }

    fn ask_for(&mut self, method: &str, params: Value) -> Value {
        self.asked += 1;
        let id = self.asked;
        self.send(json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message["id"] == json!(id) && message.get("method").is_none() {
                return message;
            }
            self.published.push(message);
        }
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        let mut answer = self.ask_for(method, params);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].take()
    }

    fn say(&mut self, method: &str, params: Value) {
        self.send(json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Opens a document of the folder; its address.
    fn open(&mut self, folder: &Folder, name: &str, text: &str) -> String {
        let uri = format!("file://{}", folder.0.join(name).display());
        let document = json!({ "uri": uri, "languageId": "plaintext", "version": 1, "text": text });
        self.say("textDocument/didOpen", json!({ "textDocument": document }));
        uri
    }

    fn change(&mut self, uri: &str, version: i32, changes: Value) {
        let document = json!({ "uri": uri, "version": version });
        self.say("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The findings of a document at a version.
    fn findings(&mut self, uri: &str, version: i32) -> Vec<Value> {
        loop {
            let found = self.published.iter().position(|message| {
                message["params"]["uri"] == json!(uri) && message["params"]["version"] == json!(version)
            });
            if let Some(at) = found {
                let message = self.published.remove(at);
                return message["params"]["diagnostics"].as_array().cloned().unwrap_or_default();
            }
            let message = self.receive();
            self.published.push(message);
        }
    }

    fn at(&mut self, method: &str, uri: &str, line: u32, character: u32, more: Value) -> Value {
        let mut params =
            json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } });
        for (key, value) in more.as_object().into_iter().flatten() {
            params[key] = value.clone();
        }
        self.ask_for(method, params)
    }

    fn hover(&mut self, uri: &str, line: u32, character: u32) -> String {
        let answer = self.at("textDocument/hover", uri, line, character, json!({}));
        answer["result"]["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    fn whole(&mut self, method: &str, uri: &str) -> Value {
        let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 9999, "character": 0 } });
        let context = json!({ "diagnostics": [] });
        self.ask(method, json!({ "textDocument": { "uri": uri }, "range": range, "context": context }))
    }

    /// Line and label of each hint.
    fn hints(&mut self, uri: &str) -> Vec<(u64, String)> {
        let hints = self.whole("textDocument/inlayHint", uri);
        let list = hints.as_array().expect("a list").iter();
        list.map(|hint| (hint["position"]["line"].as_u64().unwrap(), hint["label"].as_str().unwrap().to_owned()))
            .collect()
    }

    fn end(mut self) {
        self.ask("shutdown", Value::Null);
        self.say("exit", Value::Null);
        assert!(self.server.wait().expect("an end").success());
    }
}

/// The text of a document after the edits of an answer.
fn edited(text: &str, uri: &str, edits: &Value) -> String {
    let mut list: Vec<&Value> = edits["changes"][uri].as_array().expect("edits").iter().collect();
    let place = |v: &Value| (v["line"].as_u64().unwrap() as usize, v["character"].as_u64().unwrap() as usize);
    list.sort_by_key(|edit| std::cmp::Reverse(place(&edit["range"]["start"])));
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    for edit in list {
        let ((line, from), (last, to)) = (place(&edit["range"]["start"]), place(&edit["range"]["end"]));
        assert_eq!(line, last, "edits of one line");
        lines[line].replace_range(from..to, edit["newText"].as_str().unwrap());
    }
    lines.join("\n")
}

const POLAR: &str = "0 BEGIN PGM T MM
1 L X+0 Y+0 Z+50 R0 FMAX M3
2 CC X+50 Y+50
3 LP PR+20 PA+30 R0 F500
4 CP IPA+360 IZ-2 DR+
5 Q1 = 5
6 LBL 5
7 L IX+Q1 F200
8 CALL LBL 5 REP 3
9 CALL LBL 7
10 L Z+100 R0 FMAX M30
11 END PGM T MM
";

const JUMPS: &str = "R1=0
ANF: G0 X0 Y0 Z10 S1000 M3
G1 X=R1+5 F100
R1=R1+1
IF R1<3 GOTOB ANF
CYCLE81(20,0,2,-5)
M30
";

#[test]
fn hints_show_where_blocks_lead() {
    let folder = Folder::new("lsp_hints").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    let shown =
        |list: &[(u64, &str)]| list.iter().map(|(line, label)| (*line, (*label).to_owned())).collect::<Vec<_>>();
    // The point at 30 degrees on a radius of 20 about (50, 50), and a full helix back to it.
    let wanted = [(1, "X0 Y0 Z50"), (3, "X67.321 Y60 Z50"), (4, "X67.321 Y60 Z48"), (7, "X72.321 Y60 Z48 \u{d7}4")];
    assert_eq!(client.hints(&uri)[..4], shown(&wanted));
    let jumps = client.open(&folder, "P.MPF", JUMPS);
    let wanted = [(1, "X0 Y0 Z10 \u{d7}3"), (2, "X5 Y0 Z10 \u{d7}3"), (5, "X7 Y0 Z20")];
    assert_eq!(client.hints(&jumps), shown(&wanted));
    client.end();
}

/// Behind an error places are shown where they are known again, and say so.
#[test]
fn hints_go_on_behind_an_error() {
    let folder = Folder::new("lsp_refused").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let text = "0 BEGIN PGM R MM\n1 L X+0 Y+0 Z+5 R0 FMAX\n2 L X+10 F200\n3 L X+20 R5\n4 L IX+5\n5 L X+30 Y+0 Z+0\n6 L X+40\n7 END PGM R MM\n";
    let uri = client.open(&folder, "R.H", text);
    let wanted = [(1, "X0 Y0 Z5"), (2, "X10 Y0 Z5"), (5, "X30 Y0 Z0 after an error"), (6, "X40 Y0 Z0 after an error")];
    assert_eq!(client.hints(&uri), wanted.map(|(line, label)| (line, label.to_owned())));
    client.end();
}

/// A block that rounds or chamfers moves nothing by itself: its place is the corner.
#[test]
fn hints_of_corners_show_the_corner() {
    let folder = Folder::new("lsp_corners").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let text = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+5 R0 FMAX\n2 L X+20 F200\n3 RND R5\n4 L Y+20\n5 CHF 2\n6 L X+0\n7 END PGM T MM\n";
    let uri = client.open(&folder, "T.H", text);
    let list = client.hints(&uri);
    let corners: Vec<&(u64, String)> = list.iter().filter(|(line, _)| [3, 5].contains(line)).collect();
    assert_eq!(corners, [&(3, "X20 Y0 Z5 corner".to_owned()), &(5, "X20 Y20 Z5 corner".to_owned())]);
    // SINUMERIK writes the corner into the block that moves.
    let inside = client.open(&folder, "S.MPF", "G17 G90 G71\nG0 X0 Y0 Z5\nG1 X20 F200 RND=5\nY20 CHF=2\nX0\nM30\n");
    let labels: Vec<String> = client.hints(&inside).into_iter().map(|(_, label)| label).collect();
    assert_eq!(labels, ["X0 Y0 Z5", "X20 Y0 Z5", "X20 Y20 Z5", "X0 Y20 Z5"]);
    client.end();
}

/// What is no message is answered and the next one counts; where none can be found any more, the server says so and ends.
#[test]
fn broken_messages_are_answered_or_end_the_server() {
    let folder = Folder::new("lsp_broken").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    for (body, id, code) in [("{\"method\":", Value::Null, -32700), ("{\"id\":77}", json!(77), -32600)] {
        write!(client.to, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        let answer = client.receive();
        assert_eq!((&answer["id"], &answer["error"]["code"]), (&id, &json!(code)), "{answer}");
    }
    let uri = client.open(&folder, "T.H", POLAR);
    assert_eq!(client.findings(&uri, 1).len(), 1);
    write!(client.to, "Content-Length: 99999999999\r\n\r\n{{}}").expect("the server reads");
    client.to.flush().expect("the server reads");
    assert_eq!(client.server.wait().expect("an end").code(), Some(2));
}

/// X of a lathe is shown as its diameter and marked so, also under DIAMOF.
#[test]
fn hints_and_hover_of_a_lathe_show_diameters() {
    let config = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n";
    let folder = Folder::new("lsp_diameter").with(&[("partc.toml", config)]);
    let mut client = Client::start(&folder, json!({}));
    let text = "G18 G90 G71 DIAMON\nT1 D1\nG97 S1000 M4\nG0 X70 Z2\nG1 X20 F0.2\nDIAMOF\nG1 X12.5\nM30\n";
    let uri = client.open(&folder, "L.MPF", text);
    let wanted = [(3, "X\u{2300}70 Z2"), (4, "X\u{2300}20 Z2"), (6, "X\u{2300}25 Z2")];
    assert_eq!(client.hints(&uri), wanted.map(|(line, label)| (line, label.to_owned())));
    let text = client.hover(&uri, 3, 4);
    assert!(text.contains("**X\u{2300}70 Z2** (rapid traverse, X is a diameter"), "{text}");
    client.end();
}

#[test]
fn hover_explains_words_parameters_and_values() {
    let folder = Folder::new("lsp_hover").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    let text = client.hover(&uri, 3, 3);
    assert!(
        text.contains("polar coordinates") && text.contains("X67.321 Y60 Z50") && text.contains("500 mm/min"),
        "{text}"
    );
    assert!(client.hover(&uri, 5, 3).contains("= 5"));
    let text = client.hover(&uri, 7, 7);
    assert!(text.contains("= 5") && text.contains("first of 4 passes"), "{text}");
    assert!(client.hover(&uri, 8, 11).contains("label in line 7; used in line 9"));
    let uri = client.open(&folder, "P.MPF", JUMPS);
    assert!(client.hover(&uri, 5, 12).starts_with("**RFP**: reference plane"));
    assert!(client.hover(&uri, 2, 6).contains("= 0"));
    assert!(client.hover(&uri, 3, 0).contains("= 1 first, 3 last of 3 times"));
    assert_eq!(client.hover(&uri, 99, 0), "");
    client.end();
}

#[test]
fn findings_come_while_typing_and_go_when_mended() {
    let folder = Folder::new("lsp_findings").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    let found = client.findings(&uri, 1);
    let codes: Vec<&str> = found.iter().filter_map(|f| f["code"].as_str()).collect();
    assert!(codes.contains(&"P2011"), "{codes:?}");
    let missing = found.iter().find(|f| f["code"] == json!("P2011")).expect("the missing label");
    assert_eq!(missing["range"]["start"], json!({ "line": 9, "character": 2 }));
    // `CALL LBL 7` becomes `CALL LBL 5`; the column counts UTF-16 behind the comment.
    let range = json!({ "start": { "line": 9, "character": 11 }, "end": { "line": 9, "character": 12 } });
    client.change(&uri, 2, json!([{ "range": range, "text": "5 ; \u{1f600}" }]));
    let codes: Vec<Value> = client.findings(&uri, 2).iter().map(|f| f["code"].clone()).collect();
    assert!(!codes.contains(&json!("P2011")), "{codes:?}");
    let range = json!({ "start": { "line": 9, "character": 15 }, "end": { "line": 9, "character": 17 } });
    client.change(&uri, 3, json!([{ "range": range, "text": "" }]));
    client.findings(&uri, 3);
    client.change(&uri, 4, json!([{ "text": "X+1 nonsense" }]));
    assert!(!client.findings(&uri, 4).is_empty());
    client.end();
}

#[test]
fn called_programs_are_read_as_they_are_typed() {
    let folder = Folder::new("lsp_calls");
    let folder = folder.with(&[("HOLE.H", "0 BEGIN PGM HOLE MM\n1 L Z-5 F150\n2 END PGM HOLE MM\n")]);
    let mut client = Client::start(&folder, json!({}));
    let caller = "0 BEGIN PGM A MM\n1 L X+1 Y+1 Z+2 R0 FMAX\n2 CALL PGM HOLE.H\n3 L IZ+1 FMAX\n4 END PGM A MM\n";
    let uri = client.open(&folder, "A.H", caller);
    assert_eq!(client.hints(&uri).last(), Some(&(3, "X1 Y1 Z-4".to_owned())));
    let place = client.at("textDocument/definition", &uri, 2, 12, json!({}));
    assert!(place["result"][0]["uri"].as_str().unwrap_or_default().ends_with("/HOLE.H"), "{place}");
    // Not saved, and deeper.
    let hole = client.open(&folder, "HOLE.H", "0 BEGIN PGM HOLE MM\n1 L Z-8 F150\n2 END PGM HOLE MM\n");
    assert_eq!(client.hints(&uri).last(), Some(&(3, "X1 Y1 Z-7".to_owned())));
    // A finding of the called program stands at its call.
    client.change(&hole, 2, json!([{ "text": "0 BEGIN PGM HOLE MM\n1 L Z-8 R5 F150\n2 END PGM HOLE MM\n" }]));
    client.published.clear();
    client.change(&uri, 2, json!([{ "text": caller }]));
    let found = client.findings(&uri, 2);
    let at_call = found.iter().find(|f| f["range"]["start"]["line"] == json!(2)).expect("a finding at the call");
    assert!(at_call["message"].as_str().unwrap_or_default().starts_with("HOLE.H, line 2"), "{at_call}");
    assert!(at_call["relatedInformation"][0]["location"]["uri"].as_str().unwrap_or_default().ends_with("/HOLE.H"));
    client.end();
}

#[test]
fn called_programs_of_sinumerik_are_found_by_their_names() {
    let sub = "G1 X5 F100\nM17\n";
    let folder = Folder::new("lsp_calls_sinumerik");
    let folder = folder.with(&[("SUB1.SPF", sub), ("SUB2.SPF", sub), ("L100.SPF", sub)]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "MAIN.MPF", "G0 X1 Y1\nN20 SUB1\nCALL \"SUB2\"\nL100\nSUB1 P2\nM30\n");
    for (line, character, file) in [(1, 5, "SUB1"), (2, 7, "SUB2"), (3, 2, "L100"), (4, 1, "SUB1")] {
        let place = client.at("textDocument/definition", &uri, line, character, json!({}));
        let found = place["result"][0]["uri"].as_str().unwrap_or_default();
        assert!(found.ends_with(&format!("/{file}.SPF")), "{line}: {place}");
    }
    client.end();
}

#[test]
fn names_are_found_and_renamed() {
    let folder = Folder::new("lsp_names").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    let place = client.at("textDocument/definition", &uri, 8, 12, json!({}));
    assert_eq!(place["result"][0]["range"]["start"], json!({ "line": 6, "character": 6 }));
    let all = client.at("textDocument/references", &uri, 5, 3, json!({ "context": { "includeDeclaration": true } }));
    assert_eq!(all["result"].as_array().map(Vec::len), Some(2));
    let renamed = client.at("textDocument/rename", &uri, 6, 6, json!({ "newName": "9" }));
    let text = edited(POLAR, &uri, &renamed["result"]);
    assert_eq!(text, POLAR.replace("LBL 5", "LBL 9"));
    let renamed = client.at("textDocument/rename", &uri, 7, 7, json!({ "newName": "Q7" }));
    assert_eq!(edited(POLAR, &uri, &renamed["result"]), POLAR.replace("Q1", "Q7"));
    for (line, character, name) in [(5, 3, "7"), (5, 3, "R 5"), (6, 6, "NEW"), (1, 3, "Q9"), (9, 11, "3")] {
        let refused = client.at("textDocument/rename", &uri, line, character, json!({ "newName": name }));
        assert!(refused["error"]["message"].is_string(), "{line} {name}: {refused}");
    }
    let uri = client.open(&folder, "P.MPF", JUMPS);
    let renamed = client.at("textDocument/rename", &uri, 4, 15, json!({ "newName": "START" }));
    assert_eq!(edited(JUMPS, &uri, &renamed["result"]), JUMPS.replace("ANF", "START"));
    // A name that the language has already.
    let refused = client.at("textDocument/rename", &uri, 4, 15, json!({ "newName": "G1" }));
    assert!(refused["error"]["message"].is_string(), "{refused}");
    client.end();
}

/// A name in a text or in the name of a program is another matter, and so are variables that programs share.
#[test]
fn renames_that_would_do_more_are_refused() {
    let folder = Folder::new("lsp_renames").with(&[("SUB.H", "0 BEGIN PGM SUB MM\n1 L X+Q3 F100\n2 END PGM SUB MM\n")]);
    let mut client = Client::start(&folder, json!({}));
    let program =
        |middle: &str| format!("0 BEGIN PGM A MM\n1 Q1 = 5\n2 Q3 = 6\n{middle}\n4 L X+Q1 R0 FMAX\n5 END PGM A MM\n");
    for middle in
        ["3 QS1 = \"Q1 mm\"", "3 FN 16: F-PRINT TNC:\\x.a / TNC:\\Q1.txt", "3 CALL PGM TNC:\\Q1.h", "3 LBL \"Q1\""]
    {
        let uri = client.open(&folder, "A.H", &program(middle));
        let refused = client.at("textDocument/rename", &uri, 1, 3, json!({ "newName": "Q5" }));
        assert!(refused["error"]["message"].is_string(), "{middle}: {refused}");
    }
    let uri = client.open(&folder, "A.H", &program("3 ;"));
    for (name, taken) in [("Q5", false), ("Q3", true), ("Q108", true), ("QS5", true)] {
        let answer = client.at("textDocument/rename", &uri, 1, 3, json!({ "newName": name }));
        assert_eq!(answer["error"].is_object(), taken, "{name}: {answer}");
    }
    // The called program reads Q3, and the other way round.
    let caller = client.open(&folder, "A.H", &program("3 CALL PGM SUB.H"));
    let called = client.open(&folder, "SUB.H", "0 BEGIN PGM SUB MM\n1 Q3 = 1\n2 L X+Q3 F100\n3 END PGM SUB MM\n");
    client.hints(&caller);
    for (uri, line) in [(&caller, 2), (&called, 1)] {
        let refused = client.at("textDocument/rename", uri, line, 3, json!({ "newName": "Q60" }));
        assert!(refused["error"]["message"].as_str().unwrap_or_default().contains("Q3"), "{refused}");
    }
    client.end();
}

#[test]
fn a_closed_document_has_no_findings_and_others_are_let_alone() {
    let folder = Folder::new("lsp_closed").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    let notes = client.open(&folder, "notes.txt", "which language is this\n");
    assert!(!client.findings(&uri, 1).is_empty() && client.findings(&notes, 1).is_empty());
    client.say("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    let message = client.receive();
    assert_eq!((&message["params"]["uri"], &message["params"]["diagnostics"]), (&json!(uri), &json!([])));
    client.say("exit", Value::Null);
    // Nobody asked for the shutdown.
    assert_eq!(client.server.wait().expect("an end").code(), Some(1));
}

#[test]
fn symbols_folds_tokens_and_completion() {
    let folder = Folder::new("lsp_symbols").with(&[("partc.toml", "[tools]\nunit = \"mm\"\n[tools.3]\nradius = 4\n")]);
    let mut client = Client::start(&folder, json!({ "general": { "positionEncodings": ["utf-8", "utf-16"] } }));
    let text = "0 BEGIN PGM S MM\n1 TOOL CALL 3 Z S2000\n2 L X+0 Y+0 R0 FMAX M3 ; \u{e4}\n3 CYCL DEF 200 DRILLING ~\n  Q200=2 ~\n  Q201=-20\n4 END PGM S MM\n";
    let uri = client.open(&folder, "S.H", text);
    let symbols = client.whole("textDocument/documentSymbol", &uri);
    let names: Vec<&str> = symbols.as_array().unwrap().iter().filter_map(|s| s["name"].as_str()).collect();
    assert_eq!(names, ["BEGIN PGM S MM", "T3"]);
    let folds = client.whole("textDocument/foldingRange", &uri);
    assert!(
        folds.as_array().unwrap().iter().any(|f| f["startLine"] == json!(3) && f["endLine"] == json!(5)),
        "{folds}"
    );
    let tokens = client.whole("textDocument/semanticTokens/full", &uri);
    let data = tokens["data"].as_array().unwrap();
    assert!(data.len().is_multiple_of(5) && data.len() > 50, "{}", data.len());
    let list = client.at("textDocument/completion", &uri, 3, 4, json!({}));
    let items = list["result"].as_array().unwrap();
    let drilling = items.iter().find(|item| item["label"] == json!("CYCL DEF 200")).expect("the cycle");
    let snippet = drilling["textEdit"]["newText"].as_str().unwrap();
    assert!(snippet.starts_with("CYCL DEF 200 DRILLING ~\n  Q200=${1:+0} ;set-up clearance"), "{snippet}");
    client.end();
}

#[test]
fn actions_mend_and_ignore() {
    let folder = Folder::new("lsp_actions").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let text = "0 BEGIN PGM W MM\n1 L X+10 Y+0 R0 F300\n2 CC X+0\n3 C X+0 Y+10 DR+\n4 END PGM W MM\n";
    let uri = client.open(&folder, "W.H", text);
    let found = client.findings(&uri, 1);
    let warned = found.iter().find(|f| f["severity"] == json!(2)).expect("a warning").clone();
    let actions = client.whole("textDocument/codeAction", &uri);
    let title = format!("{}: ignore in this block", warned["code"].as_str().unwrap());
    let action = actions.as_array().unwrap().iter().find(|a| a["title"] == json!(title)).expect("the action");
    let ignored = edited(text, &uri, &action["edit"]);
    client.change(&uri, 2, json!([{ "text": ignored }]));
    let found = client.findings(&uri, 2);
    assert!(found.iter().all(|f| f["code"] != warned["code"]), "{found:?}");
    client.end();
}

#[test]
fn nonsense_gets_an_error_and_no_more() {
    let folder = Folder::new("lsp_nonsense").with(&[("partc.toml", "[tools\n")]);
    let mut client = Client::start(&folder, json!({}));
    assert_eq!(client.ask_for("textDocument/nothing", json!({}))["error"]["code"], json!(-32601));
    assert_eq!(client.ask_for("textDocument/hover", json!({ "a": 1 }))["error"]["code"], json!(-32602));
    assert!(client.at("textDocument/hover", "file:///not/open.H", 0, 0, json!({}))["error"].is_object());
    client.say("textDocument/didChange", json!({ "textDocument": 5 }));
    // The configuration cannot be read: that is what is said.
    let uri = client.open(&folder, "T.H", POLAR);
    let found = client.findings(&uri, 1);
    assert!(found.len() == 1 && found[0]["message"].as_str().unwrap_or_default().contains("partc.toml"), "{found:?}");
    client.end();
}

#[test]
fn edits_leave_no_memory_behind() {
    let folder = Folder::new("lsp_edits").with(&[]);
    let mut client = Client::start(&folder, json!({}));
    let uri = client.open(&folder, "T.H", POLAR);
    client.findings(&uri, 1);
    let range = json!({ "start": { "line": 7, "character": 9 }, "end": { "line": 7, "character": 9 } });
    let back = json!({ "start": { "line": 7, "character": 9 }, "end": { "line": 7, "character": 10 } });
    let mut before = None;
    for version in (2..402).step_by(2) {
        client.change(&uri, version, json!([{ "range": range, "text": " " }]));
        client.change(&uri, version + 1, json!([{ "range": back, "text": "" }]));
        client.findings(&uri, version + 1);
        client.published.clear();
        if version == 102 {
            before = memory(client.server.id());
        }
    }
    if let (Some(before), Some(after)) = (before, memory(client.server.id())) {
        assert!(after < before + 2_000, "{before} to {after} KB");
    }
    client.end();
}

/// Memory of a process in KB, where the system says it.
fn memory(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_ascii_whitespace().nth(1)?.parse().ok()
}
