//! `partc lsp`: the language server on standard input and output.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use std::thread;

use lsp_server::{Connection, Message};
use serde_json::json;

use crate::dialect;
use crate::lsp::frames::{self, Frame};
use crate::lsp::{Server, Setting, World};

use super::disk::{IncludeRoots, text_of};
use super::options::Common;
use super::program::said_dialect;
use super::{Exit, Trouble, config};

/// Bytes looked at to tell the language.
const HEAD: usize = 64 * 1024;

/// `partc lsp`
pub(super) fn serve(common: &Common) -> Result<Exit, Trouble> {
    let (connection, Connection { sender, receiver }) = Connection::memory();
    let broken = Arc::new(OnceLock::new());
    // It ends with its input: nobody waits for an editor that is silent.
    let reason = Arc::clone(&broken);
    thread::spawn(move || {
        if let Err(error) = hear(|message| sender.send(message).is_ok()) {
            let _ = reason.set(format!("messages of the editor: {error}"));
        }
    });
    let writer = thread::spawn(move || receiver.iter().try_for_each(|message| message.write(&mut io::stdout().lock())));
    let ended = talk(&connection, common);
    drop(connection);
    match (broken.get(), writer.join()) {
        (Some(reason), _) => Err(reason.clone()),
        (None, Ok(Err(error))) => Err(format!("stdout: {error}")),
        (None, _) => ended,
    }
}

/// Hands on what the editor says, and answers what is no message.
fn hear(mut hand_on: impl FnMut(Message) -> bool) -> io::Result<()> {
    let mut input = io::stdin().lock();
    while let Some(frame) = frames::read(&mut input)? {
        match frame {
            Frame::Wrong(answer) => frames::write(&mut io::stdout().lock(), &answer)?,
            Frame::Message(message) => {
                let is_last = matches!(&message, Message::Notification(said) if said.method == "exit");
                if !hand_on(message) || is_last {
                    break;
                }
            }
        }
    }
    Ok(())
}

fn talk(connection: &Connection, common: &Common) -> Result<Exit, Trouble> {
    let (id, params) = connection.initialize_start().map_err(|error| error.to_string())?;
    let params: lsp_types::InitializeParams = serde_json::from_value(params).map_err(|error| error.to_string())?;
    let mut server = Server::new(OnDisk { common }, &params.capabilities);
    let about = json!({ "name": "partc", "version": env!("CARGO_PKG_VERSION") });
    let answer = json!({ "capabilities": server.capabilities(), "serverInfo": about });
    connection.initialize_finish(id, answer).map_err(|error| error.to_string())?;
    let mut out = Vec::new();
    loop {
        // What is written while a program runs ends the run, and is taken together.
        let message = match connection.receiver.try_recv() {
            Ok(message) => message,
            Err(_) => {
                if server.is_behind() {
                    server.catch_up(&|| !connection.receiver.is_empty(), &mut out);
                    send(connection, &mut out)?;
                    continue;
                }
                match connection.receiver.recv() {
                    Ok(message) => message,
                    Err(_) => return Ok(Exit::Errors),
                }
            }
        };
        let goes_on = server.handle(message, &mut out);
        send(connection, &mut out)?;
        if !goes_on {
            return Ok(if server.was_shut_down() { Exit::Clean } else { Exit::Errors });
        }
    }
}

fn send(connection: &Connection, out: &mut Vec<Message>) -> Result<(), Trouble> {
    for message in out.drain(..) {
        connection.sender.send(message).map_err(|_| "the editor is gone".to_owned())?;
    }
    Ok(())
}

/// Documents that are files of this machine.
#[derive(Debug)]
struct OnDisk<'c> {
    common: &'c Common,
}

impl World for OnDisk<'_> {
    fn setting(&self, uri: &str, language: &str, text: &str) -> Result<Option<Setting>, String> {
        let path = path_of(uri).unwrap_or_else(|| PathBuf::from(uri.rsplit('/').next().unwrap_or(uri)));
        let settings = config::settings(&path, self.common)?;
        let identity = self.identity(uri);
        let name = path.file_name().map_or_else(|| text_of(&path), |name| name.to_string_lossy().into_owned());
        let head = &text.as_bytes()[..text.len().min(HEAD)];
        let said = if self.common.dialect == "auto" { language } else { self.common.dialect.as_str() };
        let said = said_dialect(&identity, &settings)?.or_else(|| dialect::find(said));
        let Some(dialect) = said.or_else(|| dialect::read_as(&name, head)) else { return Ok(None) };
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let roots = settings.include.roots.clone();
        let files = IncludeRoots::of_control(folder.to_path_buf(), roots, dialect.folders);
        Ok(Some(Setting { name, identity, dialect, settings, files: Box::new(files) }))
    }

    fn identity(&self, uri: &str) -> String {
        let Some(path) = path_of(uri) else { return uri.to_owned() };
        text_of(&fs::canonicalize(&path).unwrap_or(path))
    }

    fn uri(&self, identity: &str) -> Option<String> {
        Path::new(identity).is_absolute().then(|| uri_of(identity))
    }
}

/// The path of a `file:` address.
fn path_of(uri: &str) -> Option<PathBuf> {
    let rest = uri.strip_prefix("file://")?;
    let path = &rest[rest.find('/')?..];
    let mut bytes = Vec::with_capacity(path.len());
    let mut at = path.bytes();
    while let Some(byte) = at.next() {
        let digit = |byte: Option<u8>| byte.and_then(|b| char::from(b).to_digit(16));
        match byte {
            b'%' => bytes.push(u8::try_from(digit(at.next())? * 16 + digit(at.next())?).ok()?),
            _ => bytes.push(byte),
        }
    }
    let text = String::from_utf8(bytes).ok()?;
    // `/C:/parts/a.h`
    let drive = text.as_bytes().get(2) == Some(&b':') && cfg!(windows);
    Some(PathBuf::from(if drive { &text[1..] } else { &text }))
}

/// The `file:` address of an absolute path.
fn uri_of(path: &str) -> String {
    let mut uri = "file://".to_owned();
    let path = path.replace('\\', "/");
    if !path.starts_with('/') {
        uri.push('/');
    }
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"/-._~:".contains(&byte) {
            uri.push(char::from(byte));
        } else {
            uri.push_str(&format!("%{byte:02X}"));
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_paths() {
        for (uri, path) in [
            ("file:///parts/a%20b.h", "/parts/a b.h"),
            ("file:///parts/%C3%A4.H", "/parts/\u{e4}.H"),
            ("file://localhost/parts/a.h", "/parts/a.h"),
        ] {
            assert_eq!(path_of(uri).as_deref(), Some(Path::new(path)));
        }
        assert_eq!(
            (path_of("untitled:Untitled-1"), path_of("file:///%G0"), path_of("file:///%FF")),
            (None, None, None)
        );
        assert_eq!(uri_of("/parts/a b.h"), "file:///parts/a%20b.h");
    }
}
