// Starts `partc lsp`, and runs `partc` for the commands.
"use strict";

const { execFile } = require("node:child_process");
const os = require("node:os");
const path = require("node:path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

const LANGUAGES = ["klartext", "sinumerik", "heidenhain-turning", "mtc200"];
/// Time that a command may take, in milliseconds.
const LONGEST = 60_000;

let client;
let output;

function settings() {
  return vscode.workspace.getConfiguration("partc");
}

function server() {
  return settings().get("path") || "partc";
}

async function start() {
  const run = { command: server(), args: ["lsp"] };
  const documentSelector = LANGUAGES.flatMap((language) => [
    { language, scheme: "file" },
    { language, scheme: "untitled" },
  ]);
  client = new LanguageClient("partc", "partc", run, { documentSelector, outputChannel: output });
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    vscode.window.showErrorMessage(`partc does not start: ${error.message}. Is “partc.path” right?`);
  }
}

async function stop() {
  const running = client;
  client = undefined;
  if (running) await running.stop().catch(() => {});
}

/// Runs partc beside the document, which goes in as it stands in the editor.
function run(args, document) {
  const cwd = document.uri.scheme === "file" ? path.dirname(document.fileName) : os.tmpdir();
  return new Promise((resolve) => {
    const child = execFile(
      server(),
      args,
      { cwd, timeout: LONGEST, maxBuffer: 256 << 20, encoding: "utf8" },
      (error, stdout, stderr) => resolve({ code: error ? (typeof error.code === "number" ? error.code : 2) : 0, stdout, stderr, error }),
    );
    // A partc that is not there or ends early has said so already.
    child.stdin.on("error", () => {});
    child.stdin.end(document.getText());
  });
}

function input(document) {
  return ["-", "--dialect", document.languageId, "--stdin-filename", document.fileName, "--color", "never"];
}

/// The document of the command; a word to the user where there is none.
function program() {
  const document = vscode.window.activeTextEditor?.document;
  if (document && LANGUAGES.includes(document.languageId)) return document;
  vscode.window.showInformationMessage("Open a part program first.");
  return undefined;
}

function failed(ran, what) {
  if (ran.code === 0) return false;
  output.appendLine(ran.stderr || String(ran.error));
  const text = ran.error?.code === "ENOENT" ? `${server()} is not there; set “partc.path”` : what;
  vscode.window.showErrorMessage(`partc: ${text}`, "Show").then((answer) => answer && output.show());
  return true;
}

async function compile() {
  const document = program();
  if (!document) return;
  const target = settings().get("target");
  const args = ["compile", ...input(document), "-o", "-", ...(target ? ["--target", target] : [])];
  const ran = await run(args, document);
  if (failed(ran, "the program has errors, nothing was compiled")) return;
  const made = await vscode.workspace.openTextDocument({ content: ran.stdout, language: "plaintext" });
  await vscode.window.showTextDocument(made, vscode.ViewColumn.Beside, true);
}

async function plot() {
  const document = program();
  if (!document) return;
  const view = settings().get("plot.view");
  const ran = await run(["plot", ...input(document), "-o", "-", ...(view ? ["--view", view] : [])], document);
  if (failed(ran, "the program has errors, nothing was drawn")) return;
  const panel = vscode.window.createWebviewPanel(
    "partc.plot",
    `Path of ${path.basename(document.fileName)}`,
    { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
    {},
  );
  panel.webview.html = page(ran.stdout);
}

/// The picture and nothing else: no scripts, nothing from elsewhere.
function page(svg) {
  const policy = "default-src 'none'; style-src 'unsafe-inline'";
  return `<!DOCTYPE html><html><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}">
<style>body{margin:0} svg{width:100%;height:auto;max-height:100vh}</style></head><body>${svg}</body></html>`;
}

async function explain() {
  const editor = vscode.window.activeTextEditor;
  const here = editor ? vscode.languages.getDiagnostics(editor.document.uri) : [];
  const code = (found) => String(typeof found.code === "object" ? found.code.value : found.code);
  const at = here.filter((found) => found.source === "partc" && found.range.contains(editor.selection.active)).map(code);
  const asked =
    at[0] ?? (await vscode.window.showInputBox({ prompt: "Code of a finding", placeHolder: "K2104", validateInput: wrongCode }));
  if (!asked || wrongCode(asked)) return;
  const document = editor?.document ?? { uri: { scheme: "none" }, getText: () => "" };
  const ran = await run(["explain", asked], document);
  if (failed(ran, `no finding has the code ${asked}`)) return;
  const text = await vscode.workspace.openTextDocument({ content: ran.stdout, language: "markdown" });
  await vscode.window.showTextDocument(text, vscode.ViewColumn.Beside, true);
}

function wrongCode(text) {
  return /^[A-Za-z]\d{4}$/.test(text) ? undefined : "A letter and four digits";
}

async function activate(context) {
  output = vscode.window.createOutputChannel("partc");
  context.subscriptions.push(
    output,
    vscode.commands.registerCommand("partc.compile", compile),
    vscode.commands.registerCommand("partc.plot", plot),
    vscode.commands.registerCommand("partc.explain", explain),
    vscode.commands.registerCommand("partc.restart", async () => {
      await stop();
      await start();
    }),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("partc.path")) {
        await stop();
        await start();
      }
    }),
  );
  await start();
}

module.exports = { activate, deactivate: stop };
