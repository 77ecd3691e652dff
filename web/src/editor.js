// The two texts: the program with its findings and positions, and the G-code.

import { Compartment, EditorState, RangeSetBuilder, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, ViewPlugin, WidgetType, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { history, historyKeymap, standardKeymap } from "@codemirror/commands";
import { search, searchKeymap } from "@codemirror/search";
import { setDiagnostics } from "@codemirror/lint";

const theme = EditorView.theme({
  "&": { backgroundColor: "var(--panel)", color: "var(--text)" },
  ".cm-content": { caretColor: "var(--text)" },
  ".cm-cursor": { borderLeftColor: "var(--text)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--soft)", border: "0" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--mark)" },
  "&.cm-focused": { outline: "none" },
  "&.cm-focused .cm-content": { outline: "none" },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--text)", border: "1px solid var(--line)", maxWidth: "60ch", whiteSpace: "pre-wrap" },
  ".cm-panels": { backgroundColor: "var(--panel)", color: "var(--text)" },
  ".cm-textfield, .cm-button": { backgroundColor: "var(--panel)", backgroundImage: "none", color: "var(--text)", border: "1px solid var(--line)" },
  ".place": { color: "var(--hint)", fontStyle: "italic", paddingLeft: "2.5ch", fontSize: "92%", pointerEvents: "none", whiteSpace: "pre" },
  ".w": { color: "var(--word)" }, ".a": { color: "var(--address)" }, ".c": { color: "var(--comment)" }, ".s": { color: "var(--comment)" },
});

const WORDS = /;.*|~|"[^"]*"|[A-Z_]{2,}[A-Z0-9_]*|[A-Z](?=[ +\-=]*[\d.])/gi;
const CODE = /\([^)]*\)|;.*|"[^"]*"|[GMTNO](?=\d)|[A-Z](?=[ +\-=]*[\d.])/gi;
const marks = Object.fromEntries(["w", "a", "c", "s"].map((name) => [name, Decoration.mark({ class: name })]));

/** Colours what is to be seen, by what the words look like. */
const colours = (pattern) => ViewPlugin.fromClass(class {
  constructor(view) { this.decorations = this.build(view); }
  update(update) { if (update.docChanged || update.viewportChanged) this.decorations = this.build(update.view); }
  build(view) {
    const set = new RangeSetBuilder();
    for (const { from, to } of view.visibleRanges) {
      const text = view.state.sliceDoc(from, Math.min(to, from + 60000));
      for (const found of text.matchAll(pattern)) {
        const [word] = found, first = word[0];
        const name = first === ";" || first === "(" ? "c" : first === '"' ? "s" : word.length > 1 || "GM".includes(first) ? "w" : "a";
        set.add(from + found.index, from + found.index + word.length, marks[name]);
      }
    }
    return set.finish();
  }
}, { decorations: (plugin) => plugin.decorations });

class Place extends WidgetType {
  constructor(text) { super(); this.text = text; }
  eq(other) { return other.text === this.text; }
  toDOM() {
    const span = document.createElement("span");
    span.className = "place";
    span.textContent = this.text;
    return span;
  }
}

const setPlaces = StateEffect.define();
/** Where the blocks lead, by line. What stands behind a change is not known until it is looked at again. */
const places = StateField.define({
  create: () => new Map(),
  update(value, change) {
    for (const effect of change.effects) if (effect.is(setPlaces)) return effect.value;
    if (!change.docChanged || !value.size) return value;
    let first = Infinity;
    change.changes.iterChanges((from) => { first = Math.min(first, change.startState.doc.lineAt(from).number); });
    return new Map([...value].filter(([line]) => line < first));
  },
});
const hints = ViewPlugin.fromClass(class {
  constructor(view) { this.decorations = this.build(view); }
  update(update) {
    const other = update.startState.field(places) !== update.state.field(places);
    if (other || update.docChanged || update.viewportChanged) this.decorations = this.build(update.view);
  }
  build(view) {
    const known = view.state.field(places), set = new RangeSetBuilder();
    if (!known.size) return set.finish();
    for (const { from, to } of view.visibleRanges) {
      for (let at = from; at <= to;) {
        const line = view.state.doc.lineAt(at), text = known.get(line.number);
        if (text) set.add(line.to, line.to, Decoration.widget({ widget: new Place(text), side: 1 }));
        at = line.to + 1;
      }
    }
    return set.finish();
  }
}, { decorations: (plugin) => plugin.decorations });

const common = (label) => [
  lineNumbers(), highlightActiveLine(), highlightActiveLineGutter(), search({ top: true }), theme,
  EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
];

/** `on.change(text)` for edits of the user, `on.caret(line)` for movements of the caret by the user. */
export function program(parent, readOnly, on) {
  const quiet = { now: false };
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        ...common("Program"), history(), keymap.of([...standardKeymap, ...historyKeymap, ...searchKeymap]), colours(WORDS), places, hints,
        readOnly ? EditorState.readOnly.of(true) : [],
        EditorView.updateListener.of((update) => {
          if (quiet.now) return;
          if (update.docChanged) on.change();
          if (update.selectionSet) on.caret(update.state.doc.lineAt(update.state.selection.main.head).number);
        }),
      ],
    }),
  });
  const silently = (what) => { quiet.now = true; try { view.dispatch(what); } finally { quiet.now = false; } };
  return {
    view,
    text: () => view.state.doc.toString(),
    set(text) { silently({ changes: { from: 0, to: view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true }); },
    line: () => view.state.doc.lineAt(view.state.selection.main.head).number,
    lines: () => view.state.doc.lines,
    lineText: (number) => (number >= 1 && number <= view.state.doc.lines ? view.state.doc.line(number).text : ""),
    go(line, column = 1, focus = false) { go(view, silently, line, column); if (focus) view.focus(); },
    places(text) {
      const map = new Map();
      for (const row of text.split("\n")) {
        const tab = row.indexOf("\t");
        if (tab > 0) map.set(Number(row.slice(0, tab)), row.slice(tab + 1));
      }
      silently({ effects: setPlaces.of(map) });
    },
    findings(list) {
      const doc = view.state.doc, shown = [];
      for (const found of list) {
        if (found.line < 1 || found.line > doc.lines) continue;
        const from = offset(doc, found.line, found.column);
        const to = Math.max(from, found.end_line <= doc.lines ? offset(doc, Math.max(found.end_line, found.line), found.end_column) : from);
        const help = found.help ? `\n${found.help}` : "";
        shown.push({ from, to: to > from ? to : Math.min(from + 1, doc.length), severity: found.severity === "note" ? "info" : found.severity, message: `${found.code} ${found.message}${help}` });
      }
      silently(setDiagnostics(view.state, shown));
    },
  };
}

/** Columns count characters. */
function offset(doc, number, column) {
  const line = doc.line(number);
  let at = 0;
  for (let left = column - 1; left > 0 && at < line.length; left--) at += line.text.codePointAt(at) > 0xffff ? 2 : 1;
  return line.from + at;
}

function go(view, silently, line, column) {
  if (line < 1 || line > view.state.doc.lines) return;
  const anchor = offset(view.state.doc, line, column);
  silently({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
}

/** The G-code, to look at. */
export function code(parent, on) {
  const quiet = { now: false }, lineShown = new Compartment();
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        ...common("G-code"), keymap.of([...standardKeymap, ...searchKeymap]), colours(CODE), EditorState.readOnly.of(true), lineShown.of([]),
        EditorView.updateListener.of((update) => {
          if (!quiet.now && update.selectionSet) on.caret(update.state.doc.lineAt(update.state.selection.main.head).number);
        }),
      ],
    }),
  });
  const silently = (what) => { quiet.now = true; try { view.dispatch(what); } finally { quiet.now = false; } };
  return {
    view,
    set(text) { silently({ changes: { from: 0, to: view.state.doc.length, insert: text } }); },
    go(line) { go(view, silently, line, 1); },
  };
}
