//! Messages on a stream of bytes: each behind a head that says how long it is.
//!
//! What is no message of JSON-RPC is answered, and the next one counts. Where nobody can tell where the next one begins, the
//! stream ends with a reason. Nothing is kept of a length but the bytes that came.

use std::io::{self, BufRead, Read as _, Write};

use lsp_server::{ErrorCode, Message};
use serde_json::{Value, json};

/// Bytes of a message: more than the largest program that is looked at.
const MOST: u64 = 1 << 29;
/// Bytes of a line of the head.
const MOST_OF_LINE: u64 = 4096;

/// What came.
#[derive(Debug)]
pub enum Frame {
    Message(Message),
    /// No message: what is answered.
    Wrong(Value),
}

/// The next message; `None` at the end of the stream.
///
/// # Errors
/// The stream cannot be read, or goes on where no message can be found.
pub fn read(input: &mut dyn BufRead) -> io::Result<Option<Frame>> {
    let Some(length) = head(input)? else { return Ok(None) };
    let mut body = Vec::new();
    let came = input.take(length).read_to_end(&mut body)?;
    if came as u64 != length {
        return Err(broken(format!("the stream ends after {came} of {length} bytes of a message")));
    }
    Ok(Some(frame(&body)))
}

/// Writes an answer to what was no message.
///
/// # Errors
/// The first error of the stream.
pub fn write(out: &mut dyn Write, answer: &Value) -> io::Result<()> {
    let text = answer.to_string();
    write!(out, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    out.flush()
}

/// The length that the lines of a head say.
fn head(input: &mut dyn BufRead) -> io::Result<Option<u64>> {
    let mut length = None;
    let mut is_first = true;
    loop {
        let mut line = Vec::new();
        input.take(MOST_OF_LINE).read_until(b'\n', &mut line)?;
        if line.is_empty() && is_first {
            return Ok(None);
        }
        let text = String::from_utf8_lossy(&line);
        let Some(text) = text.strip_suffix('\n') else {
            return Err(broken(format!("no line of a head: {:?}", shortened(&text))));
        };
        let text = text.trim_end_matches('\r');
        if text.is_empty() {
            return length.map(Some).ok_or_else(|| broken("a message without a Content-Length".to_owned()));
        }
        let (name, value) =
            text.split_once(':').ok_or_else(|| broken(format!("no line of a head: {:?}", shortened(text))))?;
        if name.eq_ignore_ascii_case("Content-Length") {
            let number = value.trim().parse().ok().filter(|length| *length <= MOST);
            let wrong = || {
                broken(format!("a Content-Length of {}: a message has at most {MOST} bytes", shortened(value.trim())))
            };
            length = Some(number.ok_or_else(wrong)?);
        }
        is_first = false;
    }
}

fn frame(body: &[u8]) -> Frame {
    match serde_json::from_slice(body) {
        Ok(message) => Frame::Message(message),
        Err(_) => Frame::Wrong(match serde_json::from_slice::<Value>(body) {
            Ok(value) => {
                let id = value.get("id").filter(|id| id.is_string() || id.is_number()).cloned();
                let what = "neither a request, nor a notification, nor an answer".to_owned();
                answer(id.unwrap_or(Value::Null), ErrorCode::InvalidRequest, what)
            }
            Err(error) => answer(Value::Null, ErrorCode::ParseError, format!("no JSON: {error}")),
        }),
    }
}

fn answer(id: Value, code: ErrorCode, message: String) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code as i32, "message": message } })
}

fn broken(reason: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, reason)
}

fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn framed(body: &[u8]) -> Vec<u8> {
        [format!("Content-Length: {}\r\n\r\n", body.len()).as_bytes(), body].concat()
    }

    /// What comes of a stream: methods, codes of wrong messages, and why it ends.
    fn all(mut bytes: &[u8]) -> (Vec<String>, Option<String>) {
        let mut list = Vec::new();
        loop {
            match read(&mut bytes) {
                Ok(Some(Frame::Message(Message::Notification(said)))) => list.push(said.method),
                Ok(Some(Frame::Message(_))) => list.push("other".to_owned()),
                Ok(Some(Frame::Wrong(answer))) => list.push(format!("{} {}", answer["id"], answer["error"]["code"])),
                Ok(None) => return (list, None),
                Err(error) => return (list, Some(error.to_string())),
            }
        }
    }

    const NOTE: &[u8] = br#"{"jsonrpc":"2.0","method":"a","params":{}}"#;

    #[test]
    fn what_is_no_message_is_answered_and_the_next_one_counts() {
        for (body, expected) in [
            (&b"{\"method\":"[..], "null -32700"),
            (b"", "null -32700"),
            (b"\xff\xfe", "null -32700"),
            (b"[]", "null -32600"),
            (br#"{"id":7}"#, "7 -32600"),
            (br#"{"id":"x","method":1}"#, "\"x\" -32600"),
        ] {
            let bytes = [framed(body), framed(NOTE)].concat();
            assert_eq!(all(&bytes), (vec![expected.to_owned(), "a".to_owned()], None));
        }
    }

    #[test]
    fn a_head_that_nobody_can_follow_ends_the_stream() {
        for (head, reason) in [
            ("Content-Length: 99999999999\r\n\r\n{}", "at most"),
            ("Content-Length: many\r\n\r\n{}", "many"),
            ("Content-Length: -1\r\n\r\n{}", "-1"),
            ("Content-Type: x\r\n\r\n{}", "without a Content-Length"),
            ("what\r\n\r\n", "no line of a head"),
            ("Content-Length: 9\r\n\r\n{}", "2 of 9 bytes"),
            ("Content-Length: 9", "no line of a head"),
        ] {
            let (list, ends) = all(&[&framed(NOTE), head.as_bytes()].concat());
            assert_eq!(list, ["a"]);
            assert!(ends.as_ref().is_some_and(|ends| ends.contains(reason)), "{head:?}: {ends:?}");
        }
        assert!(all(&vec![b'x'; 1 << 20]).1.is_some_and(|reason| reason.len() < 100));
    }

    proptest! {
        #[test]
        fn any_bytes_end(bytes in prop::collection::vec(any::<u8>(), 0..400), body in "\\PC{0,60}") {
            all(&bytes);
            let (list, ends) = all(&[framed(body.as_bytes()), framed(NOTE), bytes].concat());
            prop_assert!(list.len() >= 2 && list[1] == "a", "{:?} {:?}", list, ends);
        }
    }
}
