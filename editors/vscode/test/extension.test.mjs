// The commands with the real partc, in an editor that is only as much of VS Code as they use. PARTC names the program.
import assert from "node:assert/strict";
import Module, { createRequire } from "node:module";
import test from "node:test";

const require = createRequire(import.meta.url);
const partc = process.env.PARTC;
const PROGRAM = "0 BEGIN PGM T MM\n1 L X+10 Y+0 Z+2 R0 FMAX\n2 L X+50 F200\n3 END PGM T MM\n";

/// As much of VS Code as the extension uses; `seen` is what a user would see.
function editor(settings) {
  const seen = { opened: [], pages: [], errors: [], started: [] };
  const commands = new Map();
  const disposable = { dispose() {} };
  const vscode = {
    workspace: {
      getConfiguration: () => ({ get: (name) => settings[name] }),
      onDidChangeConfiguration: () => disposable,
      openTextDocument: async (text) => text,
    },
    window: {
      activeTextEditor: undefined,
      createOutputChannel: () => ({ appendLine() {}, show() {}, dispose() {} }),
      showErrorMessage: async (text) => void seen.errors.push(text),
      showInformationMessage: async (text) => void seen.errors.push(text),
      showInputBox: async () => "G3216",
      showTextDocument: async (text) => void seen.opened.push(text.content),
      createWebviewPanel: () => {
        const panel = { webview: { html: "" } };
        seen.pages.push(panel.webview);
        return panel;
      },
    },
    languages: { getDiagnostics: () => [] },
    commands: { registerCommand: (name, run) => (commands.set(name, run), disposable) },
    ViewColumn: { Beside: -2 },
  };
  class LanguageClient {
    constructor(_id, _name, run, options) {
      seen.started.push({ run, options });
    }
    async start() {}
    async stop() {}
  }
  return { seen, commands, modules: { vscode, "vscode-languageclient/node": { LanguageClient } }, vscode };
}

/// Loads the extension anew, with these modules in place of the real ones.
async function activated(settings) {
  const made = editor(settings);
  const load = Module._load;
  Module._load = (name, ...rest) => made.modules[name] ?? load(name, ...rest);
  try {
    const file = require.resolve("../src/extension.js");
    delete require.cache[file];
    await require(file).activate({ subscriptions: [] });
  } finally {
    Module._load = load;
  }
  made.open = (text, languageId = "klartext") => {
    const document = { languageId, fileName: "T.H", uri: { scheme: "untitled" }, getText: () => text };
    made.vscode.window.activeTextEditor = { document, selection: {} };
  };
  return made;
}

test("the language server is started for all languages", async () => {
  const { seen } = await activated({ path: "partc" });
  const [{ run, options }] = seen.started;
  assert.deepEqual(run, { command: "partc", args: ["lsp"] });
  assert.equal(options.documentSelector.length, 8);
});

test("without a program a word to the user", async () => {
  const { seen, commands } = await activated({ path: "partc" });
  await commands.get("partc.compile")();
  assert.deepEqual(seen.errors, ["Open a part program first."]);
});

test("a partc that is not there is said", async () => {
  const made = await activated({ path: "/nowhere/partc" });
  made.open(PROGRAM);
  await made.commands.get("partc.compile")();
  assert.match(made.seen.errors[0], /is not there; set “partc.path”/);
});

test("compile, plot and explain with partc", { skip: partc ? false : "PARTC is not set" }, async () => {
  const made = await activated({ path: partc, target: "grbl", "plot.view": "xz" });
  made.open(PROGRAM);
  await made.commands.get("partc.compile")();
  assert.match(made.seen.opened[0], /G1 X50/);
  await made.commands.get("partc.plot")();
  assert.match(made.seen.pages[0].html, /<svg /);
  assert.match(made.seen.pages[0].html, /M10 2L50 2/);
  await made.commands.get("partc.explain")();
  assert.match(made.seen.opened[1], /G3216/);
  assert.deepEqual(made.seen.errors, []);
  made.open("0 BEGIN PGM T MM\n1 L X+10 R5\n2 END PGM T MM\n");
  await made.commands.get("partc.compile")();
  assert.match(made.seen.errors[0], /has errors/);
});
