// The picture: lines, and over them rulers, the tool, what is measured. Mouse, keys, play.

import { Camera, VIEWS, dot } from "./camera.js";
import { BEGINS, RAPID, lower, shade } from "./data.js";
import { Lines } from "./lines.js";
import { Overlay } from "./overlay.js";

const NEAR = 10, ALL = 0xffffffff;

export class Plot {
  /** `on.move(m)`: the user chose a move; `on.step(m)`: playing or stepping came to it, null for the whole. */
  constructor(place, on) {
    this.place = place;
    this.on = on;
    this.camera = new Camera();
    this.lines = new Lines(place.querySelector("#lines"));
    this.lines.again = () => this.ask();
    this.overlay = new Overlay(place.querySelector("#over"));
    this.read = place.querySelector("#read");
    this.rapids = true;
    this.dots = false;
    this.hidden = 0;
    this.ranges = [];
    this.chosen = null;
    this.at = null;
    this.measuring = false;
    this.marks = [];
    this.frames = [];
    new ResizeObserver(() => this.resize()).observe(place);
    this.listen();
    this.resize();
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.place;
    if (!w || !h) return;
    Object.assign(this.camera, { width: w, height: h });
    if (this.path && !this.touched) this.fit(); else this.ask();
  }

  /** The camera stays where the user has put it, while the program is the same. */
  show(path, isNew) {
    this.path = path;
    this.lines.load(path);
    this.ranges = [];
    this.chosen = null;
    this.marks = [];
    this.stop();
    this.at = null;
    if (isNew) { this.touched = false; this.look(path.lathe ? "ZX" : "XY"); } else if (!this.touched) this.fit();
    this.ask();
  }

  /** Nothing is known of a path. */
  clear() {
    this.stop();
    this.path = null;
    this.lines.clear();
    Object.assign(this, { ranges: [], chosen: null, at: null, marks: [] });
    this.tell(null);
    this.ask();
  }

  look(name) {
    this.camera.look(name);
    this.touched = false;
    this.fit();
    this.on.look?.(name);
  }

  fit() {
    if (!this.path) return;
    const { box, whole } = this.path;
    const empty = box.high.every((high, a) => high - box.low[a] < 1e-6);
    // A retract far away makes no small picture.
    this.camera.fit(this.path, empty || (this.rapids && span(whole) < 1.5 * span(box)));
    this.ask();
  }

  theme(style) { this.style = style; this.ask(); }

  ask(moving = false) {
    this.goesOn = false;
    this.stale = true;
    if (moving) {
      this.moving = true;
      clearTimeout(this.rest);
      this.rest = null;
    }
    this.frame();
  }

  frame() { this.asked ??= requestAnimationFrame((time) => { this.asked = null; this.draw(time); }); }

  draw(time) {
    if (!this.style) return;
    const { style, camera } = this;
    const now = this.at === null ? ALL : Math.floor(this.at);
    if (this.stale || this.goesOn) this.goesOn = this.lines.draw(camera, {
      ratio: Math.min(window.devicePixelRatio || 1, 2), width: 1.7, now, hidden: this.hidden, rapids: this.rapids,
      ranges: this.ranges.slice(0, 4000), colours: style.colours, select: style.select,
    }, this.moving || !!this.playing, this.goesOn);
    this.stale = false;
    if (this.moving) { const began = performance.now(); requestAnimationFrame(() => this.lines.lasted(performance.now() - began)); }
    if (this.goesOn) this.frame();
    this.overlay.draw(this, style);
    // The whole is drawn once the picture rests, however long a frame took.
    if (this.moving && !this.goesOn) {
      clearTimeout(this.rest);
      this.rest = setTimeout(() => { this.moving = false; this.ask(); }, 250);
    }
    if (this.path) this.first ??= performance.now();
    this.frames.push(time);
    if (this.frames.length > 120) this.frames.shift();
  }

  /** Marks moves, and shows the first of them. */
  choose(moves, first = moves[0]) {
    const { path } = this;
    this.ranges = [];
    for (const m of moves) {
      const from = path.start(m), to = path.ends[m], last = this.ranges[this.ranges.length - 1];
      if (last && last[1] - 1 === from) last[1] = to; else if (to - from > 1) this.ranges.push([from, to]);
    }
    this.chosen = first ?? null;
    this.ask();
  }

  /** Playing stands behind move m; null shows everything. */
  goTo(m) {
    this.at = m === null ? null : Math.max(this.path.ends[m] - 1, 0);
    this.ask();
  }

  get moveAt() { return this.at === null ? null : this.path.owners[Math.min(Math.ceil(this.at), this.path.segments - 1)]; }

  play(factor) {
    const { path } = this;
    if (!path?.segments) return;
    this.factor = factor;
    if (this.playing) return;
    const end = path.segments - 1;
    if (this.at === null || this.at >= end) this.at = 0;
    let before = performance.now(), time = path.times[Math.floor(this.at)];
    const tick = (now) => {
      if (!this.playing) return;
      time += (now - before) / 1000 * this.factor;
      before = now;
      const next = lower(path.times, time);
      if (next > end) { this.at = null; this.stop(); this.on.step(null); } else {
        const t0 = path.times[Math.max(next - 1, 0)], t1 = path.times[next];
        this.at = Math.max(next - 1, 0) + (t1 > t0 ? (time - t0) / (t1 - t0) : 0);
        this.on.step(this.moveAt);
        this.playing = requestAnimationFrame(tick);
      }
      this.ask();
    };
    this.playing = requestAnimationFrame(tick);
    this.on.playing?.(true);
  }

  stop() {
    if (this.playing) cancelAnimationFrame(this.playing);
    this.playing = null;
    this.on.playing?.(false);
  }

  /** Where the tool stands, seen from the origin of the path. */
  tool() {
    const { path, at } = this;
    if (!path?.segments || at === null) return null;
    const i = Math.floor(at), t = at - i, p = path.points, j = Math.min(i + 1, path.segments - 1);
    const mix = path.kinds[j] === BEGINS || path.kinds[j] & 112 ? 0 : t;
    return [0, 1, 2].map((a) => p[3 * i + a] + (p[3 * j + a] - p[3 * i + a]) * mix);
  }

  shown(i) {
    const k = this.path.kinds[i], tool = shade(this.path.tool_of[this.path.owners[i]]);
    return k !== BEGINS && !(k & this.camera.needs) && (this.rapids || (k & 15) !== RAPID) && !((this.hidden >> tool) & 1);
  }

  /** The element that is seen nearest to these pixels: its point, and how far along. */
  pick(x, y, near = NEAR) {
    const { path, camera } = this;
    if (!path?.segments) return null;
    const [r, u, e] = camera.rows, s = camera.scale, p = path.points;
    const cx = camera.width / 2 - s * dot(r, camera.center), cy = camera.height / 2 + s * dot(u, camera.center);
    let best = near * near, found = null, depth = -Infinity;
    let px = 0, py = 0;
    const most = this.at === null ? path.segments : Math.ceil(this.at) + 1;
    for (let i = 0; i < most; i++) {
      const X = p[3 * i], Y = p[3 * i + 1], Z = p[3 * i + 2];
      const qx = cx + s * (r[0] * X + r[1] * Y + r[2] * Z), qy = cy - s * (u[0] * X + u[1] * Y + u[2] * Z);
      if (i > 0) {
        const dx = qx - px, dy = qy - py, l = dx * dx + dy * dy;
        let t = l > 0 ? ((x - px) * dx + (y - py) * dy) / l : 1;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const ex = px + t * dx - x, ey = py + t * dy - y, d = ex * ex + ey * ey;
        if (d < best + 1 && this.shown(i)) {
          const z = e[0] * X + e[1] * Y + e[2] * Z;
          if (d < best - 1 || z > depth) { best = Math.min(d, best); depth = z; found = { i, t }; }
        }
      }
      px = qx; py = qy;
    }
    return found;
  }

  /** The end of an element near these pixels, or a point of the plane. */
  snap(x, y) {
    const hit = this.pick(x, y);
    if (hit) {
      const p = this.path.points;
      const ends = [hit.i - 1, hit.i].map((i) => [p[3 * i], p[3 * i + 1], p[3 * i + 2]]);
      const far = ends.map((end) => { const [a, b] = this.camera.project(...end); return Math.hypot(a - x, b - y); });
      const k = far[0] < far[1] ? 0 : 1;
      if (far[k] < NEAR) return { p: ends[k], on: "end" };
      return { p: [0, 1, 2].map((a) => ends[0][a] + (ends[1][a] - ends[0][a]) * hit.t), on: "path" };
    }
    return this.camera.flat ? { p: this.camera.unproject(x, y), on: "plane" } : null;
  }

  listen() {
    const { place, camera } = this;
    const at = (event) => { const box = place.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
    let drag = null;
    const fingers = new Map();
    place.addEventListener("contextmenu", (event) => event.preventDefault());
    place.addEventListener("pointerdown", (event) => {
      if (event.target.closest?.(".veil")) return;
      place.setPointerCapture(event.pointerId);
      const [x, y] = at(event);
      fingers.set(event.pointerId, [x, y]);
      drag = { x, y, far: 0, turn: !camera.flat && event.button === 0 && !event.shiftKey };
    });
    place.addEventListener("pointermove", (event) => {
      const [x, y] = at(event);
      if (fingers.size === 2 && fingers.has(event.pointerId)) {
        const [other] = [...fingers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
        const [ox, oy] = fingers.get(event.pointerId);
        camera.zoom(Math.hypot(x - other[0], y - other[1]) / Math.max(Math.hypot(ox - other[0], oy - other[1]), 1), (x + other[0]) / 2, (y + other[1]) / 2);
        fingers.set(event.pointerId, [x, y]);
        this.touched = true;
        return this.ask(true);
      }
      if (drag) {
        const dx = x - drag.x, dy = y - drag.y;
        drag.far += Math.abs(dx) + Math.abs(dy);
        drag.x = x; drag.y = y;
        if (drag.far > 3) {
          place.classList.add("pan");
          this.touched = true;
          if (drag.turn) camera.turn(dx, dy); else camera.pan(dx, dy);
          this.ask(true);
        }
        return;
      }
      this.hover = [x, y];
      if (this.measuring && this.path) { this.marks.free = this.snap(x, y); this.frame(); }
      if (this.path && this.path.segments < 400000) this.tell(this.pick(x, y, 6)); else this.tell(null);
    });
    const up = (event) => {
      fingers.delete(event.pointerId);
      place.classList.remove("pan");
      if (drag && drag.far <= 3 && event.type === "pointerup" && event.button === 0) this.click(drag.x, drag.y);
      drag = null;
    };
    place.addEventListener("pointerup", up);
    place.addEventListener("pointercancel", up);
    place.addEventListener("pointerleave", () => { this.tell(null); this.marks.free = null; this.frame(); });
    place.addEventListener("dblclick", () => { this.touched = false; this.fit(); });
    place.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.touched = true;
      camera.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), ...at(event));
      this.ask(true);
    }, { passive: false });
    place.addEventListener("keydown", (event) => {
      const by = 40, keys = { ArrowLeft: [by, 0], ArrowRight: [-by, 0], ArrowUp: [0, by], ArrowDown: [0, -by] };
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (keys[event.key]) { if (event.shiftKey && !camera.flat) camera.turn(...keys[event.key]); else camera.pan(...keys[event.key]); }
      else if (event.key === "+" || event.key === "=") camera.zoom(1.25, camera.width / 2, camera.height / 2);
      else if (event.key === "-") camera.zoom(0.8, camera.width / 2, camera.height / 2);
      else return;
      event.preventDefault();
      this.touched = true;
      this.ask(true);
    });
  }

  click(x, y) {
    if (!this.path) return;
    if (this.measuring) {
      const mark = this.snap(x, y);
      if (!mark) return;
      if (this.marks.length >= 2) this.marks = [];
      this.marks.push(mark.p);
      return this.ask();
    }
    const hit = this.pick(x, y);
    if (hit) this.on.move(this.path.owners[hit.i]);
    else { this.ranges = []; this.chosen = null; this.ask(); }
  }

  /** What lies under the pointer. */
  tell(hit) {
    const text = hit ? this.on.describe(this.path.owners[hit.i]) : this.chosen !== null && this.path ? this.on.describe(this.chosen) : "";
    if (this.read.textContent !== text) this.read.textContent = text;
  }

  measure(on) {
    this.measuring = on;
    this.marks = [];
    this.ask();
  }
}

const span = ({ low, high }) => Math.hypot(...high.map((value, a) => value - low[a]));
export { VIEWS };
