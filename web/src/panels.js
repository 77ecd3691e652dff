// Findings, tools, figures: lists and tables of what partc found.

import { short } from "./overlay.js";

/** An element with attributes and children. */
export function el(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (key.startsWith("aria-")) made.setAttribute(key, value);
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

const ORDER = { error: 0, warning: 1, note: 2 };

/** What a check and a compilation found, the same once, the worst first. */
export function together(...lists) {
  const known = new Set(), all = [];
  for (const found of lists.flat()) {
    const key = [found.code, found.file, found.line, found.column, found.message].join("\0");
    if (!known.has(key)) { known.add(key); all.push(found); }
  }
  return all.sort((a, b) => ORDER[a.severity] - ORDER[b.severity] || a.line - b.line || a.column - b.column);
}

/** The keys that errors ask for, as lines of a configuration: one of their values, or none where only the user knows. */
export function asked(list) {
  const tables = new Map();
  for (const { severity, answers } of list) for (const { table, key, values } of (severity === "error" && answers) || []) {
    if (!tables.has(table)) tables.set(table, new Map());
    const keys = tables.get(table);
    keys.set(key, [...new Set([...(keys.get(key) ?? []), ...values])]);
  }
  const line = ([key, values]) => `${key} = ${values.length === 1 ? values[0] : ""}${values.length > 1 ? `  # ${values.join(", ")}` : ""}`;
  return [...tables].map(([table, keys]) => `[${table}]\n${[...keys].map(line).join("\n")}\n`).join("\n");
}

const MOST = 500;

export function problems(place, list, dropped, name, go) {
  place.replaceChildren();
  if (!list.length) return place.append(el("div", { class: "none" }, "Nothing was found."));
  for (const found of list.slice(0, MOST)) {
    const own = found.file === name, times = found.times > 1 ? ` (${found.times} times)` : "";
    const where = own ? `${found.line}` : `${found.file}:${found.line}`;
    const line = own ? found.line : found.stack[found.stack.length - 1]?.line ?? 0;
    const more = found.related.map((other) => `${other.file === name ? "line" : other.file} ${other.line}: ${other.message}`);
    if (found.alarm) more.push(`alarm ${found.alarm} of the control`);
    const small = [found.help, ...more].filter(Boolean).join("\n");
    place.append(el("button", { class: `problem ${found.severity}`, onclick: () => go(line, own ? found.column : 1) },
      el("b", {}, found.severity), el("span", {}, found.code), el("span", { class: "l" }, where),
      el("span", {}, found.message + times, small ? el("small", {}, small) : null)));
  }
  const left = list.length - Math.min(list.length, MOST) + dropped;
  if (left > 0) place.append(el("div", { class: "none" }, `${counted(left, "more finding")} not shown.`));
}

export const counted = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;

const number = (value, places = 1) => (value === null || value === undefined ? "" : short(value, places));

/** 1:02:03, or 2:03.4 below an hour. */
export function clock(seconds) {
  const tenths = Math.round(seconds * 10), h = Math.floor(tenths / 36000), m = Math.floor(tenths / 600) % 60, rest = tenths % 600;
  const two = (n) => String(Math.floor(n)).padStart(2, "0");
  return h ? `${h}:${two(m)}:${two(rest / 10)}` : `${m}:${two(rest / 10)}.${rest % 10}`;
}

function table(head, rows) {
  const cell = (kind) => (text, i) => el(kind, { class: i > 0 && head[i].n ? "n" : null, scope: kind === "th" ? "col" : null }, text);
  return el("table", {}, el("thead", {}, el("tr", {}, ...head.map((column, i) => cell("th")(column.t, i)))),
    el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map(cell("td"))))));
}

const n = (t) => ({ t, n: true }), t = (text) => ({ t: text });

export const toolName = (tool) => (tool.number === null ? "no tool" : `T${tool.number}`);

export function tools(place, made, colour) {
  place.replaceChildren();
  if (!made.stats) return place.append(el("p", {}, "No figures: the program has errors."));
  const used = made.tools.map((tool, i) => [tool, i, made.stats.tools.find((row) => row.tool === tool.number)]).filter(([, , row]) => row);
  place.append(table(
    [t("Tool"), t("Name"), t("Kind"), n("Radius mm"), n("Length mm"), n("Changes"), n("Moves"), n("Cutting mm"), n("Cutting"), n("Rapid")],
    used.map(([tool, i, row]) => [
      el("span", {}, el("i", { class: "swatch", style: null }), toolName(tool)), tool.name ?? "", tool.kind ?? "", number(tool.radius, 4), number(tool.length, 4),
      String(row.changes), String(row.moves), number(row.cutting_mm), clock(row.cutting_s), clock(row.rapid_s),
    ].map((value, column) => { if (column === 0) value.firstChild.style.background = colour(i); return value; })),
  ));
  if (used.every(([tool]) => tool.radius === undefined || tool.radius === null)) {
    place.append(el("p", {}, "Names and radii come from the tools of the configuration."));
  }
}

export function figures(place, made) {
  place.replaceChildren();
  const { stats, model } = made;
  if (!stats) return place.append(el("p", {}, "No figures: the program has errors."));
  const rows = [
    ["Time", clock(stats.time_s)], ["Cutting", `${clock(stats.cutting_s)}, ${number(stats.cutting_mm)} mm`], ["Rapid", `${clock(stats.rapid_s)}, ${number(stats.rapid_mm)} mm`],
    ["Dwell", clock(stats.dwell_s)], ["Tool changes", String(stats.tool_changes)], ["Moves", String(stats.moves)],
  ];
  for (const [axis, [low, high]] of Object.entries(stats.extents)) {
    const two = axis === made.diameter ? 2 : 1;
    rows.push([`Cuts in ${axis}`, `${number(low * two, 4)} to ${number(high * two, 4)}${two === 2 ? " (diameter)" : ""}`]);
  }
  place.append(table([t("Figure"), n("")], rows));
  const { rapid, acceleration, smooth } = model;
  place.append(el("p", {}, `Times of a simple machine: rapid ${rapid} mm/min, acceleration ${acceleration} m/s², stops between moves that turn by more than ${smooth}°, tool changes take no time.`));
  if (stats.unknown_moves) place.append(el("p", {}, `${counted(stats.unknown_moves, "move")} from or to a place that nobody knows: not in the figures.`));
  if (stats.untimed_moves) place.append(el("p", {}, `${counted(stats.untimed_moves, "move")} without a speed that is known: the time is missing.`));
  if (made.left_out) place.append(el("p", {}, `The picture ends before the program: ${counted(made.left_out, "move")} not drawn.`));
}
