// The page: a program, its findings, its path and its G-code, each leading to the others.

import { AXES, BEGINS, BROKEN, Path, lower, shade, unpack } from "./data.js";
import { code, program } from "./editor.js";
import { EXAMPLE } from "./example.js";
import { bytesOf, decode, read, save } from "./files.js";
import { asked, clock, counted, el, figures, problems, together, toolName, tools } from "./panels.js";
import { Plot, VIEWS } from "./plot.js";
import { short } from "./overlay.js";
import { split } from "./split.js";

const $ = (id) => document.getElementById(id);
// Only a report brings what was made.
const report = $("made");
document.body.classList.toggle("report", !!report);

const state = { made: null, path: null, checked: null, files: [], config: "", edited: false, isNew: true, id: 0 };
const WAYS = ["rapid", "line", "arc", "thread"];

// What lies below the picture.
const codePage = el("div", { class: "text" }), toolsPage = el("div", { class: "page" }), figuresPage = el("div", { class: "page" });
const configPage = el("div", { class: "page text" });
const config = el("textarea", { "aria-label": "partc.toml", spellcheck: "false", placeholder: "# partc.toml: tools, limits, what the control is\n[tools.1]\nradius = 5.0", style: null });
Object.assign(config.style, { width: "100%", height: "100%", border: "0", padding: "8px 10px", resize: "none", background: "var(--panel)", color: "var(--text)", font: "13px ui-monospace, Consolas, 'DejaVu Sans Mono', monospace" });
configPage.append(config);
const answersPage = el("div", { class: "page" });
const pages = [["G-code", codePage], ["Tools", toolsPage], ["Figures", figuresPage], ["partc.toml", answersPage], ...(report ? [] : [["Configuration", configPage]])];
pages.forEach(([name, page], i) => {
  const tab = el("button", { role: "tab", id: `tab-${i}`, "aria-controls": `page-${i}`, onclick: () => open(i) }, name);
  page.id = `page-${i}`;
  page.setAttribute("role", "tabpanel");
  page.setAttribute("aria-labelledby", `tab-${i}`);
  if (page.classList.contains("page")) page.tabIndex = 0;
  $("tabs").append(tab);
  $("pages").append(page);
});
$("tabs").addEventListener("keydown", (event) => {
  const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!by) return;
  let i = [...$("tabs").children].indexOf(document.activeElement);
  do i = (i + by + pages.length) % pages.length; while ($("tabs").children[i].hidden);
  open(i);
  $("tabs").children[i].focus();
});
function open(i) {
  pages.forEach(([, page], k) => { page.hidden = k !== i; });
  [...$("tabs").children].forEach((tab, k) => { tab.setAttribute("aria-selected", k === i); tab.tabIndex = k === i ? 0 : -1; });
}
open(0);

const editor = program($("program"), !!report, {
  change() { state.edited = true; soon(300); },
  caret(line) { fromProgram(line); },
});
const output = code(codePage, {
  caret(line) {
    const { path } = state;
    if (!path) return;
    const block = path.lines[line - 1];
    if (block) editor.go(block);
    const m = path.moveOfPrinted(line);
    if (path.moves && path.printed[m] === line) plot.choose([m]); else if (block) plot.choose([...path.movesOf(block)]);
    told();
  },
});
const plot = new Plot($("plot"), {
  move(m) { choose(m); },
  step(m) { stepped(m); },
  describe: (m) => describe(m),
  look(name) { for (const button of $("views").children) button.setAttribute("aria-pressed", button.textContent === name); },
  playing(on) { $("run").textContent = on ? "❚❚" : "▶"; $("run").setAttribute("aria-label", on ? "Pause" : "Play"); },
});

/** The first line of the block on this line: a block of Klartext goes on behind `~`. */
function blockOf(line) {
  while (line > 1 && /~\s*$/.test(editor.lineText(line - 1).replace(/;.*$/, ""))) line--;
  return line;
}

function fromProgram(line) {
  const { path } = state;
  if (!path) return;
  const moves = path.movesOf(blockOf(line));
  plot.choose([...moves]);
  if (moves.length) {
    output.go(path.printed[moves[0]]);
    if (plot.at !== null) { plot.stop(); plot.goTo(moves[0]); slide(moves[0]); }
  } else {
    const printed = path.lines.indexOf(blockOf(line));
    if (printed >= 0) output.go(printed + 1);
  }
  told();
}

/** A move of the picture was chosen. */
function choose(m) {
  const { path } = state;
  plot.choose([m]);
  editor.go(path.blocks[m]);
  output.go(path.printed[m]);
  told();
}

function stepped(m) {
  slide(m);
  if (m === null || !state.path) return;
  plot.choose([m]);
  editor.go(state.path.blocks[m]);
  output.go(state.path.printed[m]);
  told();
}

function slide(m) {
  const moves = state.path?.moves ?? 0;
  $("at").max = moves;
  $("at").value = m === null ? moves : m;
  $("count").textContent = moves ? `${m === null ? moves : m + 1} / ${moves}` : "";
}

function told() { plot.tell(null); }

/** The block of a move, and where it is printed. */
const blockAt = (path, m) => `line ${path.blocks[m]}${path.printed[m] ? ` → G-code ${path.printed[m]}` : ""}${m >= (path.incomplete?.from ?? Infinity) ? ", after the error" : ""}`;

/** A move in words. */
function describe(m) {
  const { path } = state;
  const place = path.place(Math.max(path.ends[m] - 1, 0)), way = path.ways[m];
  const at = AXES.map((name, a) => (path.known[a] ? `${name}${path.factor(a) === 2 ? "\u2300" : ""}${short(place[a] * path.factor(a), 4)}` : "")).filter(Boolean).join(" ");
  const radius = path.radii[m], feed = path.feeds[m];
  const arc = radius ? ` R${short(Math.abs(radius), 4)} ${radius > 0 ? "counter-clockwise" : "clockwise"}` : "";
  const unit = way & 4 ? "mm/rev" : way & 8 ? "moves/min" : "mm/min";
  const side = way & 16 ? ", compensated left" : way & 32 ? ", compensated right" : "";
  const machine = way & 64 ? " in machine coordinates" : "";
  const tool = path.tools[path.tool_of[m]];
  const passes = path.movesOf(path.blocks[m]).length;
  return `${WAYS[way & 3]}${arc}${side}${machine}\n${machine ? "" : `to ${at}\n`}${feed ? `F ${short(feed)} ${unit}, ` : ""}${toolName(tool)}\n${blockAt(path, m)}${passes > 1 ? `\none of ${passes} moves of this block` : ""}`;
}

// The picture's buttons.
function views() {
  const names = state.path?.lathe ? ["ZX", "XY", "YZ", "3-D"] : ["XY", "XZ", "YZ", "3-D"];
  $("views").replaceChildren(...names.map((name, i) => el("button", { "aria-pressed": plot.camera.name === name, title: `View ${name} (${i + 1})`, onclick: () => plot.look(name) }, name)));
}
const toggle = (id, set) => $(id).addEventListener("click", () => {
  const on = $(id).getAttribute("aria-pressed") !== "true";
  $(id).setAttribute("aria-pressed", on);
  set(on);
  plot.ask();
});
toggle("rapids", (on) => { plot.rapids = on; });
toggle("points", (on) => { plot.dots = on; });
toggle("measure", (on) => plot.measure(on));
$("fit").addEventListener("click", () => { plot.touched = false; plot.fit(); });
$("run").addEventListener("click", () => { if (plot.playing) plot.stop(); else plot.play(Number($("pace").value)); });
$("pace").addEventListener("change", () => { plot.factor = Number($("pace").value); });
function step(by) {
  const { path } = state;
  if (!path?.moves) return;
  plot.stop();
  const from = plot.at === null ? (by > 0 ? (plot.chosen ?? -1) : plot.chosen ?? path.moves) : plot.moveAt;
  const m = Math.max(0, Math.min(path.moves - 1, from + by));
  plot.goTo(m);
  stepped(m);
}
$("back").addEventListener("click", () => step(-1));
$("step").addEventListener("click", () => step(1));
$("at").addEventListener("input", () => {
  const m = Number($("at").value);
  plot.stop();
  if (!state.path || m >= state.path.moves) { plot.goTo(null); plot.choose([]); slide(null); return; }
  plot.goTo(m);
  stepped(m);
});

const colour = (i) => `var(--t${shade(i)})`;
function legend() {
  const { path } = state, used = new Set();
  for (let m = 0; m < path.moves; m++) used.add(path.tool_of[m]);
  const rapid = el("span", {}, el("i", { class: "dash" }), " rapid");
  rapid.firstChild.style.color = "var(--rapid)";
  const blank = el("span", {}, el("i", { class: "dash" }), " blank");
  blank.firstChild.style.color = "var(--blank)";
  const buttons = [...used].sort((a, b) => a - b).slice(0, 12).map((i) => {
    const button = el("button", { "aria-pressed": !((plot.hidden >> shade(i)) & 1), title: "Show this tool, or not", onclick() {
      plot.hidden ^= 1 << shade(i);
      legend();
      plot.ask();
    } }, el("i"), toolName(path.tools[i]) + (path.tools[i].name ? ` ${path.tools[i].name}` : ""));
    button.firstChild.style.color = colour(i);
    return button;
  });
  $("legend").replaceChildren(rapid, ...(path.blank ? [blank] : []), ...buttons);
}

/** Why there is no G-code, and what of the path is shown. */
function refused({ incomplete, kinds }) {
  if (!incomplete) return "The findings let no output pass (--fail-on): there is no G-code.";
  const { code, file, own, line } = incomplete;
  const where = `line ${line}${own ? "" : ` of ${file}`} (${code})`;
  if (!kinds.length) return `Incomplete: the program is refused at ${where}, and no move is known.`;
  const after = kinds.some((kind) => kind !== BEGINS && kind & BROKEN && !(kind & 112));
  return `Incomplete: the path stops at ${where}. ${after ? "What is pale comes after it. " : ""}There is no G-code.`;
}

/** What a compilation made. */
function showMade(made) {
  state.made = made;
  $("plot").classList.toggle("stale", !!made.trouble);
  $("save").disabled = !!(made.failed || made.trouble);
  if (made.trouble) {
    $("veil").hidden = false;
    $("veil").textContent = made.trouble;
    problems($("problems"), [], 0, "", () => {});
    $("problems").replaceChildren(el("div", { class: "none" }, made.trouble));
    return says("error", "not compiled");
  }
  $("veil").hidden = !made.failed;
  $("veil").textContent = made.failed ? refused(made) : "";
  state.path = new Path(made);
  plot.hidden = 0;
  plot.show(state.path, state.isNew && state.path.segments > 0);
  if (!state.isNew) plot.choose([...state.path.movesOf(blockOf(editor.line()))]);
  if (state.path.segments) state.isNew = false;
  // The picture comes first.
  requestAnimationFrame(() => setTimeout(() => { if (state.made === made) output.set(made.code); }));
  views();
  legend();
  slide(null);
  tools(toolsPage, made, colour);
  figures(figuresPage, made);
  $("facts").textContent = [made.dialect, made.target, counted(state.path.moves + made.left_out, "move") + (made.incomplete ? ", incomplete" : ""), made.stats ? clock(made.stats.time_s) : ""].filter(Boolean).join(" · ");
  showFindings();
}

function showFindings() {
  const { made, checked } = state;
  const list = together(checked?.findings ?? [], made.findings);
  problems($("problems"), list, Math.max(checked?.dropped ?? 0, made.dropped), made.name, (line, column) => { editor.go(line, column, true); fromProgram(line); });
  const own = list.map((found) => (found.file === made.name ? found : { ...found, line: found.stack[found.stack.length - 1]?.line ?? 0, column: 1, end_line: 0, end_column: 1 }));
  editor.findings(own);
  showAnswers(list);
  const count = (severity) => list.filter((found) => found.severity === severity).length;
  const [errors, warnings] = [count("error"), count("warning")];
  if (errors) says("error", `${counted(errors, "error")}: no G-code`);
  else if (made.failed) says("error", `${counted(list.length, "finding")}: no G-code`);
  else if (warnings) says("warning", counted(warnings, "warning"));
  else says("ok", "no errors");
}

/** Lines of a configuration that would answer errors. */
function showAnswers(list) {
  const lines = report ? decode(bytesOf($("paste").textContent)) : asked(list);
  answersPage.replaceChildren(...(lines
    ? [el("p", {}, report ? "Paste into partc.toml and fill in:" : "Put into the configuration and fill in:"), el("pre", { tabindex: 0, "aria-label": "Lines for partc.toml" }, lines)]
    : []));
  const tab = $("tab-3");
  tab.hidden = !lines;
  if (!lines && tab.getAttribute("aria-selected") === "true") open(0);
  else if (lines && state.made.failed && !state.pointed) open(3);
  state.pointed = !!lines;
}

function showChecked(checked) {
  if (!checked.findings) return;
  state.checked = checked;
  editor.places(checked.places);
  showFindings();
}

function says(kind, text) { $("state").className = `state ${kind}`; $("state").textContent = text; }

$("save").addEventListener("click", () => {
  const { made } = state;
  if (made?.code) save(`${made.name.replace(/\.[^.]*$/, "")}.${made.extension}`, made.code);
});

// Light or dark.
const dark = matchMedia("(prefers-color-scheme: dark)");
function theme(name) {
  document.documentElement.dataset.theme = name;
  const probe = el("span");
  document.body.append(probe);
  const css = (variable) => { probe.style.color = `var(--${variable})`; return getComputedStyle(probe).color; };
  const rgb = (variable) => [...css(variable).match(/[\d.]+/g).slice(0, 3).map((v) => v / 255), 1];
  const names = ["t0", "t1", "t2", "t3", "t4", "t5", "t6", "t7", "rapid", "done"];
  plot.theme({ colours: names.map(rgb), select: rgb("select"), blank: css("blank"), selectCss: css("select"), soft: css("soft"), axis: css("axis"), text: css("text"), panel: css("panel"), line: css("line") });
  probe.remove();
}
// Paper is white.
let shown;
addEventListener("beforeprint", () => { shown = document.documentElement.dataset.theme; theme("light"); plot.draw(performance.now()); });
addEventListener("afterprint", () => theme(shown));
dark.addEventListener("change", () => theme(dark.matches ? "dark" : "light"));
$("theme").addEventListener("click", () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
theme(dark.matches ? "dark" : "light");

// Sizes.
const root = document.documentElement.style;
split($("bar-main"), "x", (share) => root.setProperty("--left", `${share * 100}%`));
split($("bar-left"), "y", (share) => root.setProperty("--problems", `${(1 - share) * 100}%`));
split($("bar-right"), "y", (share) => root.setProperty("--below", `${(1 - share) * 100}%`));

// Keys.
const KEYS = [["1 2 3 4", "views"], ["F", "show all"], ["R", "rapids"], ["P", "ends of moves"], ["M", "measure"], ["Space", "play, pause"], [", .", "one move back, on"], ["Home End", "first move, the whole"], ["+ − arrows", "zoom, move the picture; with Shift turn it"], ["T", "light or dark"], ["Ctrl+F", "search in a text"], ["Esc", "choose nothing"], ["?", "these keys"]];
$("keys").append(el("h2", {}, "Keys"), el("p", {}, "Outside of the texts. A click on the path leads to its block, the caret in a block to its path; a drag moves the picture, in 3-D it turns."),
  el("table", {}, el("tbody", {}, ...KEYS.map(([keys, what]) => el("tr", {}, el("td", {}, ...keys.split(" ").flatMap((key) => [el("kbd", {}, key), " "])), el("td", {}, what))))),
  el("form", { method: "dialog" }, el("button", {}, "Close")));
$("help").addEventListener("click", () => $("keys").showModal());
document.addEventListener("keydown", (event) => {
  if (!report && (event.ctrlKey || event.metaKey) && event.key === "o") { event.preventDefault(); return $("file").click(); }
  if (event.ctrlKey || event.metaKey || event.altKey || $("keys").open) return;
  if (event.target.closest(".cm-editor, textarea, select, input:not([type=range]), [role=tab]")) return;
  if (event.key === " " && event.target.closest("button")) return;
  const press = { f: "fit", r: "rapids", p: "points", m: "measure", t: "theme", "?": "help", " ": "run", ",": "back", ".": "step" }[event.key.toLowerCase()];
  if (press) $(press).click();
  else if ("1234".includes(event.key)) $("views").children[Number(event.key) - 1]?.click();
  else if (event.key === "Home" && state.path?.moves) { plot.stop(); plot.goTo(0); stepped(0); }
  else if (event.key === "End") { plot.stop(); plot.goTo(null); slide(null); }
  else if (event.key === "Escape") { plot.choose([]); plot.measure(false); $("measure").setAttribute("aria-pressed", "false"); told(); }
  else return;
  event.preventDefault();
});

/** A program that runs so long, in ms, is given up when it changes. */
const PATIENCE = 2000;
let worker, timer, busy = false, again = false, since = 0;
function begin() {
  const source = URL.createObjectURL(new Blob([$("worker").textContent], { type: "text/javascript" }));
  worker = new Worker(source);
  worker.onerror = (event) => says("error", `partc does not run here: ${event.message}`);
  worker.onmessage = ({ data }) => {
    if (data.ready) return ready(JSON.parse(new TextDecoder().decode(data.ready)));
    if (data.broken) { restart(false); return says("error", `partc broke off: ${data.broken}`); }
    if (data.made) { if (data.id === state.id) { state.checked = null; showMade(unpack(data.made)); state.took = data.took; } return; }
    busy = false;
    if (data.id === state.id) { showChecked(unpack(data.checked)); document.body.dataset.done = String(data.id); }
    if (again) compile();
  };
  const module = bytesOf($("wasm").textContent);
  worker.postMessage({ module }, [module.buffer]);
  says("busy", "starting…");
}

/** A module that broke off is in no state to go on. */
function restart(goesOn) { worker.terminate(); busy = false; again = goesOn; begin(); }

function ready({ targets, dialects }) {
  const options = (list, chosen) => list.map((name) => el("option", { value: name, selected: name === chosen }, name));
  if (!$("target").children.length) {
    $("dialect").replaceChildren(...options(["auto", ...dialects], "auto"));
    $("target").replaceChildren(...options(["as configured", ...targets], "as configured"));
    load([{ name: "FLANGE.H", bytes: new TextEncoder().encode(EXAMPLE) }]);
  } else if (again) compile();
  else says("error", "partc broke off");
  document.body.dataset.ready = "";
}

/** Programs take the place of those before: the first one runs. */
function load(files) {
  state.files = files;
  state.edited = false;
  state.isNew = true;
  state.path = null;
  plot.clear();
  $("legend").replaceChildren();
  slide(null);
  editor.set(decode(files[0].bytes));
  editor.places("");
  $("name").textContent = files.map(({ name }) => name).join(", ");
  document.title = `${files[0].name} – partc`;
  compile();
}

function soon(after) { clearTimeout(timer); timer = setTimeout(compile, after); }

function compile() {
  clearTimeout(timer);
  if (!state.files.length) return;
  if (busy && performance.now() - since > PATIENCE) return restart(true);
  if (busy) { again = true; return; }
  busy = true;
  since = performance.now();
  again = false;
  if (state.edited) state.files[0] = { name: state.files[0].name, bytes: new TextEncoder().encode(editor.text()) };
  const target = $("target").value;
  state.id++;
  says("busy", "working…");
  worker.postMessage({ id: state.id, asked: { dialect: $("dialect").value, target: target === "as configured" ? "" : target, config: config.value }, files: state.files });
}

$("dialect").addEventListener("change", compile);
$("target").addEventListener("change", compile);
config.addEventListener("input", () => soon(500));
$("open").addEventListener("click", () => $("file").click());
async function take(list) {
  const { programs, config: toml } = await read(list);
  if (toml) { config.value = decode(toml.bytes); }
  if (programs.length) load(programs); else compile();
}
$("file").addEventListener("change", () => { if ($("file").files.length) take($("file").files); $("file").value = ""; });
if (!report) {
  addEventListener("dragover", (event) => { event.preventDefault(); $("drop").hidden = false; });
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) $("drop").hidden = true; });
  addEventListener("drop", (event) => { event.preventDefault(); $("drop").hidden = true; if (event.dataTransfer.files.length) take(event.dataTransfer.files); });
}

// A report brings what was made; the page makes it.
if (report) {
  const part = (id) => bytesOf($(id).textContent);
  const made = unpack(part("made"));
  editor.set(decode(part("source")));
  $("name").textContent = made.name;
  document.title = `${made.name} – partc`;
  showMade(made);
  showChecked(unpack(part("checked")));
} else begin();

// For tests and measurements.
window.partc = { state, plot, editor, load, lower, VIEWS, config };
