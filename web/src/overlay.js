// Over the lines: rulers, directions of the axes, the tool, the ends of moves, what is measured.

import { BEGINS } from "./data.js";

const AXES = ["X", "Y", "Z"];

/** 1, 2 or 5 times a power of ten, at least this. */
function step(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least);
}

export const short = (value, places = 3) => {
  const text = value.toFixed(places).replace(/\.?0+$/, "");
  return text === "-0" ? "0" : text;
};

export class Overlay {
  constructor(canvas) { this.canvas = canvas; this.c = canvas.getContext("2d"); }

  draw(plot, style) {
    const { camera, path } = plot, { c, canvas } = this, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const w = Math.round(camera.width * ratio), h = Math.round(camera.height * ratio);
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, camera.width, camera.height);
    c.font = "11px system-ui, sans-serif";
    c.lineWidth = 1;
    if (!path?.segments) return;
    if (path.blank) this.blank(plot, style);
    if (camera.flat) this.rulers(plot, style); else this.bar(plot, style);
    this.cross(plot, style);
    if (plot.dots) this.points(plot, style);
    this.tool(plot, style);
    this.measured(plot, style);
    this.triad(plot, style);
  }

  /** The numbers of a lathe's X are those of the program. */
  label(plot, axis, value) { return short(value * plot.path.factor(axis), 4); }

  rulers(plot, style) {
    const { camera, path } = plot, { c } = this, s = camera.scale, every = step(70 / s);
    const [right, up] = [0, 1].map((row) => camera.rows[row].findIndex((v) => Math.abs(v) > 0.5));
    const first = camera.unproject(0, camera.height), last = camera.unproject(camera.width, 0);
    c.fillStyle = style.soft;
    const each = (axis, draw) => {
      const o = path.origin[axis], by = every / path.factor(axis);
      for (let n = Math.ceil((first[axis] + o) / by); n * by <= last[axis] + o; n++) {
        const at = [...camera.center];
        at[axis] = n * by - o;
        draw(camera.project(...at), n * by);
      }
    };
    c.strokeStyle = style.axis;
    c.textAlign = "center";
    each(right, ([x], value) => { c.beginPath(); c.moveTo(x, camera.height); c.lineTo(x, camera.height - 6); c.stroke(); if (x > 90) c.fillText(this.label(plot, right, value), x, camera.height - 9); });
    c.textAlign = "left";
    each(up, ([, y], value) => { c.beginPath(); c.moveTo(0, y); c.lineTo(6, y); c.stroke(); if (y < camera.height - 90 && y > 8) c.fillText(this.label(plot, up, value), 9, y + 4); });
  }

  /** A length, where no ruler can be. */
  bar({ camera }, style) {
    const { c } = this, length = step(80 / camera.scale), w = length * camera.scale, x = camera.width - w - 16, y = camera.height - 14;
    c.strokeStyle = c.fillStyle = style.soft;
    c.beginPath(); c.moveTo(x, y - 4); c.lineTo(x, y); c.lineTo(x + w, y); c.lineTo(x + w, y - 4); c.stroke();
    c.textAlign = "center";
    c.fillText(`${short(length, 4)} mm`, x + w / 2, y - 6);
  }

  /** The edges of the blank. */
  blank({ camera, path }, style) {
    const { c } = this, { low, high, axis, radius, bore } = path.blank;
    const at = (p) => camera.project(...p.map((v, a) => v - path.origin[a]));
    const chain = (points) => { c.beginPath(); points.forEach((p, i) => (i ? c.lineTo(...at(p)) : c.moveTo(...at(p)))); c.stroke(); };
    c.strokeStyle = style.blank;
    c.setLineDash([12, 4, 2, 4]);
    if (axis === undefined) {
      const corner = (bits) => [0, 1, 2].map((a) => ((bits >> a) & 1 ? high : low)[a]);
      // Seen along an axis, the other four faces are lines.
      if (camera.flat) {
        const [p, q] = [at(low), at(high)];
        c.strokeRect(Math.min(p[0], q[0]), Math.min(p[1], q[1]), Math.abs(q[0] - p[0]), Math.abs(q[1] - p[1]));
      } else for (let bits = 0; bits < 8; bits++) for (let a = 0; a < 3; a++) if (!((bits >> a) & 1)) chain([corner(bits), corner(bits | (1 << a))]);
    } else for (const r of bore > 0 ? [radius, bore] : [radius]) {
      const place = (along, turn) => { const p = [0, 0, 0]; p[axis] = along; p[(axis + 1) % 3] = r * Math.cos(turn); p[(axis + 2) % 3] = r * Math.sin(turn); return p; };
      const ring = (along) => chain(Array.from({ length: 73 }, (_, i) => place(along, i * Math.PI / 36)));
      const edge = camera.flat && camera.rows[2][axis] === 0;
      ring(high);
      if (camera.flat && !edge) continue;
      ring(low);
      const middle = at([0, 1, 2].map((a) => (a === axis ? low : 0)));
      for (let i = 0; i < 4; i++) {
        const [x, y] = at(place(low, i * Math.PI / 2));
        // From the side, two of them lie on the axis, where there is no edge.
        if (!camera.flat || Math.hypot(x - middle[0], y - middle[1]) > 0.5) chain([place(low, i * Math.PI / 2), place(high, i * Math.PI / 2)]);
      }
    }
    c.setLineDash([]);
  }

  /** The zero of the workpiece. */
  cross({ camera, path }, style) {
    const { c } = this, [x, y] = camera.project(...path.origin.map((o) => -o));
    c.strokeStyle = style.soft;
    c.beginPath(); c.arc(x, y, 5, 0, 7); c.moveTo(x - 9, y); c.lineTo(x + 9, y); c.moveTo(x, y - 9); c.lineTo(x, y + 9); c.stroke();
  }

  triad({ camera }, style) {
    const { c } = this, o = [46, camera.height - 46];
    c.textAlign = "center";
    c.lineWidth = 1.5;
    AXES.forEach((name, a) => {
      const x = camera.rows[0][a] * 26, y = -camera.rows[1][a] * 26;
      if (Math.hypot(x, y) < 3) return;
      c.strokeStyle = c.fillStyle = style.text;
      c.beginPath(); c.moveTo(...o); c.lineTo(o[0] + x, o[1] + y); c.stroke();
      c.fillText(name, o[0] + x * 1.35, o[1] + y * 1.35 + 4);
    });
    c.lineWidth = 1;
  }

  points(plot, style) {
    const { camera, path } = plot, { c } = this, p = path.points;
    c.fillStyle = style.text;
    let drawn = 0;
    for (let m = 0; m < path.moves && drawn < 20000; m++) {
      const i = path.ends[m] - 1;
      if (i < 0 || path.kinds[i] === BEGINS || !plot.shown(i) || (plot.at !== null && i > plot.at)) continue;
      const [x, y] = camera.project(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
      if (x < 0 || y < 0 || x > camera.width || y > camera.height) continue;
      c.fillRect(x - 1.5, y - 1.5, 3, 3);
      drawn++;
    }
  }

  tool(plot, style) {
    const { c } = this, { camera, path } = plot;
    const at = plot.tool() ?? (plot.chosen !== null && path.ends[plot.chosen] ? [0, 1, 2].map((a) => path.points[3 * (path.ends[plot.chosen] - 1) + a]) : null);
    if (!at) return;
    const [x, y] = camera.project(...at);
    c.strokeStyle = style.selectCss;
    c.fillStyle = style.panel;
    c.lineWidth = 2;
    c.beginPath(); c.arc(x, y, 5, 0, 7); c.fill(); c.stroke();
    c.lineWidth = 1;
  }

  measured(plot, style) {
    if (!plot.measuring) return;
    const { c } = this, { camera, path, marks } = plot;
    const all = [...marks];
    if (marks.length < 2 && marks.free) all.push(marks.free.p);
    c.strokeStyle = c.fillStyle = style.selectCss;
    for (const mark of all) { const [x, y] = camera.project(...mark); c.beginPath(); c.moveTo(x - 6, y - 6); c.lineTo(x + 6, y + 6); c.moveTo(x + 6, y - 6); c.lineTo(x - 6, y + 6); c.stroke(); }
    // In a plane view nobody knows how deep a free point lies: what is seen is measured.
    const seen = [0, 1, 2].filter((a) => path.known[a] && (!camera.flat || camera.needs & (16 << a)));
    const of = (p) => seen.map((a) => `${AXES[a]}${this.label(plot, a, Number((p[a] + path.origin[a]).toFixed(4)))}`).join(" ");
    let text = all.length ? of(all[0]) : "Measure: click two points; ends of moves are caught";
    if (all.length === 2) {
      const [a, b] = all, d = b.map((v, i) => v - a[i]);
      const [p, q] = [camera.project(...a), camera.project(...b)];
      c.beginPath(); c.moveTo(...p); c.lineTo(...q); c.stroke();
      text = `${of(a)}\n${of(b)}\n${seen.map((i) => `d${AXES[i]} ${short(d[i])}`).join("  ")}\ndistance ${short(Math.hypot(...seen.map((i) => d[i])))} mm`;
    }
    const rows = text.split("\n");
    c.textAlign = "left";
    const wide = Math.max(...rows.map((row) => c.measureText(row).width)) + 16;
    c.fillStyle = style.panel;
    c.fillRect(10, 10, wide, rows.length * 16 + 10);
    c.strokeStyle = style.line;
    c.strokeRect(10.5, 10.5, wide, rows.length * 16 + 10);
    c.fillStyle = style.text;
    rows.forEach((row, i) => c.fillText(row, 18, 27 + i * 16));
  }
}
