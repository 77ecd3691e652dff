// Lines of constant width in pixels, drawn by WebGL2, all from one array of points: one rectangle an element, or, where there are
// many, one strip.

import { BEGINS, BROKEN, shade } from "./data.js";

const VERTEX = `#version 300 es
layout(location=0) in vec3 a;
layout(location=1) in vec3 b;
layout(location=2) in uvec4 what;   // kind, colour, of the point it leads to
layout(location=3) in uint id;
uniform mat3 rows; uniform vec3 center; uniform vec2 size; uniform float scale, width;
uniform uint needs, now, hidden; uniform int show; uniform vec4 colours[10]; uniform vec4 only; uniform float ahead; uniform vec3 relief; uniform int strip;
flat out vec4 colour; flat out float dash; out float along;
void main() {
  uint kind = what.x & 15u, tool = what.y;
  bool off = what.x == 255u || (what.x & needs) != 0u || (kind == 0u && (show & 1) == 0) || ((hidden >> tool) & 1u) != 0u;
  vec2 p = (rows * (a - center)).xy * scale, q = (rows * (b - center)).xy * scale;
  vec2 d = q - p; float l = length(d); d = l > 1e-4 ? d / l : vec2(1.0, 0.0);
  // Seen along its own direction a cut is a point: where a drill goes in.
  bool deep = kind != 0u && l < 1.0 && length(b - a) * scale > 4.0;
  float w = width * (kind == 0u ? 0.6 : deep ? 3.2 : 1.0);
  float e = float(gl_VertexID & 1), s = float(gl_VertexID >> 1) * 2.0 - 1.0;
  // Rounded enough: each end goes half the width further.
  vec2 at = mix(p - d * w * 0.5, q + d * w * 0.5, e) + vec2(-d.y, d.x) * s * w * 0.5;
  along = e * l; dash = kind == 0u && only.a == 0.0 && l > 10.0 ? 1.0 : 0.0;
  colour = only.a > 0.0 ? only : kind == 0u ? colours[8] : colours[tool];
  // Dense paths show their form by height and slope.
  if (relief.z > 0.0 && kind != 0u && only.a == 0.0) {
    vec3 t = b - a; float slope = t.z / max(length(t), 1e-6);
    colour.rgb *= clamp(0.6 + 0.5 * (b.z - relief.x) / relief.y + relief.z * slope, 0.35, 1.25);
  }
  // What is known behind an error is pale.
  if (only.a == 0.0 && (what.x & 128u) != 0u) colour = vec4(mix(colours[9].rgb, colour.rgb, 0.22), 1.0);
  if (id > now) colour = mix(colours[9], colour, ahead);
  if (strip == 1) {
    // A line from point to point, of one pixel: what is flat comes from the point it leads to.
    if (off) colour.a = 0.0;
    dash = kind == 0u ? 2.0 : 0.0;
    gl_Position = vec4(q / size * 2.0, 0.0, 1.0);
    return;
  }
  gl_Position = off ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(at / size * 2.0, 0.0, 1.0);
}`;
const FRAGMENT = `#version 300 es
precision mediump float;
flat in vec4 colour; flat in float dash; in float along; out vec4 o;
void main() {
  if (colour.a == 0.0 || (dash == 1.0 && mod(along, 9.0) > 5.0) || (dash == 2.0 && mod(gl_FragCoord.x + gl_FragCoord.y, 9.0) > 5.0)) discard;
  o = vec4(colour.rgb, 1.0);
}`;

/** Elements up to which nothing is left out while the picture moves. */
const FEW = 60000;
/** The same where a frame of those takes longer than so many ms, as without a graphics card. */
const FEWER = 12000, LONG = 90;
/** Elements of one frame: where no graphics card helps, the page stays awake. */
const SLICE = 250000;
/** From so many elements on lines lie on lines: they are thin, and show the form by light. */
const DENSE = 20000;

export class Lines {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = (this.gl = canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true }));
    if (!gl) {
      this.flat = canvas.getContext("2d");
      return;
    }
    this.begin();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => { this.begin(); if (this.path) this.load(this.path); this.again?.(); });
  }

  begin() {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    this.program = program;
    this.u = (name) => gl.getUniformLocation(program, name);
    this.places = Object.fromEntries(["rows", "center", "size", "scale", "width", "needs", "now", "hidden", "show", "colours", "only", "ahead", "relief", "strip"].map((name) => [name, this.u(name)]));
  }

  load(path) {
    this.clear();
    this.path = path;
    const n = path.kinds.length, what = new Uint8Array(2 * n), ids = new Uint32Array(n);
    for (let i = 0; i < n; i++) {
      what[2 * i] = path.kinds[i];
      what[2 * i + 1] = shade(path.tool_of[path.owners[i]]);
      ids[i] = i;
    }
    this.levels = [this.level(path.points, what, ids, 0)];
    const size = Math.hypot(...path.whole.high.map((high, a) => high - path.whole.low[a]));
    this.quick = null;
    if (n <= FEW) return;
    // The first picture does not wait for them.
    setTimeout(() => {
      if (this.path !== path) return;
      for (const share of [1500, 600]) {
        const coarse = this.thinned(path, what, size / share);
        if (coarse.n < 0.7 * this.levels.at(-1).n) this.levels.push(coarse); else coarse.free?.();
      }
      const coarse = this.levels.at(-1);
      this.quick = coarse.n > FEW ? this.sparse(coarse, FEW) : coarse;
      this.quicker = this.sparse(coarse, FEWER);
    }, 50);
  }

  /** A frame that moved took so long: two long ones behind each other are no accident. */
  lasted(ms) {
    this.late = ms > LONG ? this.late + 1 : 0;
    this.slow ||= this.late > 1;
  }

  /** Stretches of a level, so that about so many elements are left: what is seen of very long paths while they move. */
  sparse({ points, what, ids, n, error }, most) {
    const stretch = 64, every = Math.ceil(n / most), keep = [];
    for (let i = 0; i < n; i++) if (Math.floor(i / stretch) % every === 0) keep.push(i);
    const fewer = { points: new Float32Array(3 * keep.length), what: new Uint8Array(2 * keep.length), ids: new Uint32Array(keep.length) };
    keep.forEach((i, k) => {
      fewer.points.set(points.subarray(3 * i, 3 * i + 3), 3 * k);
      fewer.what.set(i % stretch ? what.subarray(2 * i, 2 * i + 2) : [BEGINS, 0], 2 * k);
      fewer.ids[k] = ids[i];
    });
    return this.level(fewer.points, fewer.what, fewer.ids, error);
  }

  clear() {
    [...(this.levels ?? []), this.quick, this.quicker].forEach((level) => level?.free?.());
    this.levels = [];
    this.path = this.quick = this.quicker = null;
    this.late = 0;
    this.slow = false;
  }

  level(points, what, ids, error) {
    const level = { points, what, ids, n: ids.length, error }, gl = this.gl;
    if (!gl || !level.n) return level;
    level.array = gl.createVertexArray();
    level.buffers = [points, what, ids].map((data) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      return buffer;
    });
    level.free = () => { level.buffers.forEach((buffer) => gl.deleteBuffer(buffer)); gl.deleteVertexArray(level.array); };
    return level;
  }

  /** Points that lie closer together than `error` and lead on in the same way become one. */
  thinned(path, what, error) {
    const { points: p, kinds } = path, n = kinds.length, keep = [];
    let x = 0, y = 0, z = 0;
    const square = error * error;
    for (let i = 0; i < n; i++) {
      const dx = p[3 * i] - x, dy = p[3 * i + 1] - y, dz = p[3 * i + 2] - z;
      const turns = i + 1 === n || kinds[i + 1] !== kinds[i] || what[2 * i + 3] !== what[2 * i + 1];
      if (turns || kinds[i] === BEGINS || dx * dx + dy * dy + dz * dz > square) {
        keep.push(i);
        x = p[3 * i]; y = p[3 * i + 1]; z = p[3 * i + 2];
      }
    }
    const points = new Float32Array(3 * keep.length), kinds2 = new Uint8Array(2 * keep.length), ids = Uint32Array.from(keep);
    keep.forEach((i, k) => {
      points.set(p.subarray(3 * i, 3 * i + 3), 3 * k);
      kinds2[2 * k] = what[2 * i]; kinds2[2 * k + 1] = what[2 * i + 1];
    });
    return this.level(points, kinds2, ids, error);
  }

  /** `ranges` are points [from, to) whose elements stand out. True where only a part is drawn yet, and the next call `goesOn`. */
  draw(camera, style, moving, goesOn) {
    const ratio = style.ratio, w = Math.round(camera.width * ratio), h = Math.round(camera.height * ratio);
    if (this.canvas.width !== w || this.canvas.height !== h) { this.canvas.width = w; this.canvas.height = h; }
    const levels = this.levels ?? [];
    let level = levels[0];
    for (const coarse of levels) if (coarse.error * camera.scale < (moving ? 3 : 0.8)) level = coarse;
    // Near by, few elements lie in the picture, and a graphics card finds them soon.
    const quick = this.slow ? this.quicker : this.quick;
    if (moving && quick && level.n > quick.n) level = quick;
    if (!this.gl) { this.drawFlat(camera, style, level); return false; }
    const gl = this.gl, at = this.places;
    gl.viewport(0, 0, w, h);
    if (!goesOn) {
      this.next = 0;
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
    }
    if (!level?.n) return false;
    gl.useProgram(this.program);
    const [r, u, e] = camera.rows;
    gl.uniformMatrix3fv(at.rows, false, [r[0], u[0], e[0], r[1], u[1], e[1], r[2], u[2], e[2]]);
    gl.uniform3fv(at.center, camera.center);
    gl.uniform2f(at.size, w, h);
    gl.uniform1f(at.scale, camera.scale * ratio);
    gl.uniform1f(at.width, style.width * ratio);
    gl.uniform1ui(at.needs, camera.needs);
    gl.uniform1ui(at.now, style.now);
    gl.uniform1ui(at.hidden, style.hidden);
    gl.uniform1i(at.show, style.rapids ? 1 : 0);
    gl.uniform4fv(at.colours, style.colours.flat());
    gl.uniform4f(at.only, 0, 0, 0, 0);
    gl.uniform1f(at.ahead, 0.0);
    gl.uniform1i(at.strip, 0);
    const { low, high } = this.path.box;
    gl.uniform3f(at.relief, low[2], Math.max(high[2] - low[2], 1e-3), levels[0].n > DENSE && !camera.flat ? 0.35 : 0);
    const thin = level.n > (moving ? DENSE / 4 : DENSE), count = Math.min(SLICE, level.n - 1 - this.next);
    if (thin) {
      // The strip begins at the second point.
      if (this.next === 0) this.rectangles(level, 0, 1);
      gl.uniform1i(at.strip, 1);
      this.bind(level, this.next, 0);
      gl.drawArrays(gl.LINE_STRIP, 0, count);
      gl.uniform1i(at.strip, 0);
    } else this.rectangles(level, this.next, count);
    // A strip goes on at its last point.
    this.next += thin && this.next + count < level.n - 1 ? count - 1 : count;
    if (this.next < level.n - 1) return true;
    if (style.ranges.length) {
      gl.uniform4fv(at.only, style.select);
      gl.uniform1f(at.ahead, 1.0);
      gl.uniform1i(at.show, 1);
      gl.uniform1f(at.width, (style.width + 1.6) * ratio);
      for (const [from, to] of style.ranges) this.rectangles(levels[0], from, to - from - 1);
    }
    return false;
  }

  /** Elements with a width: one rectangle each. */
  rectangles(level, from, count) {
    if (count <= 0) return;
    this.bind(level, from, 1);
    this.gl.drawArraysInstanced(this.gl.TRIANGLE_STRIP, 0, 4, count);
  }

  bind(level, from, divisor) {
    const gl = this.gl, [points, what, ids] = level.buffers;
    gl.bindVertexArray(level.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, points);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 12, 12 * from);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 12, 12 * from + 12);
    gl.bindBuffer(gl.ARRAY_BUFFER, what);
    gl.vertexAttribIPointer(2, 2, gl.UNSIGNED_BYTE, 2, 2 * from + 2);
    gl.bindBuffer(gl.ARRAY_BUFFER, ids);
    gl.vertexAttribIPointer(3, 1, gl.UNSIGNED_INT, 4, 4 * from + 4);
    for (let i = 0; i < 4; i++) { gl.enableVertexAttribArray(i); gl.vertexAttribDivisor(i, divisor); }
  }

  /** Where a browser has no WebGL2. */
  drawFlat(camera, style, level) {
    const c = this.flat, ratio = style.ratio;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, camera.width, camera.height);
    if (!level?.n) return;
    const css = (v) => `rgb(${v.slice(0, 3).map((x) => Math.round(x * 255)).join()})`;
    const run = (lev, from, to, colour, width) => {
      let last = null;
      const { points: p, what, ids } = lev;
      for (let i = from + 1; i < to; i++) {
        const k = what[2 * i], kind = k & 15;
        if (k === BEGINS || k & camera.needs || (kind === 0 && !style.rapids && !colour) || (style.hidden >> what[2 * i + 1]) & 1) { last = null; continue; }
        const pen = colour ?? (ids[i] > style.now || k & BROKEN ? 9 : kind === 0 ? 8 : what[2 * i + 1]);
        if (pen !== last) {
          if (last !== null) c.stroke();
          c.beginPath();
          c.strokeStyle = colour ?? css(style.colours[pen]);
          c.lineWidth = width * (kind === 0 ? 0.6 : 1);
          c.setLineDash(kind === 0 && !colour ? [5, 4] : []);
          c.moveTo(...camera.project(p[3 * i - 3], p[3 * i - 2], p[3 * i - 1]));
          last = pen;
        }
        c.lineTo(...camera.project(p[3 * i], p[3 * i + 1], p[3 * i + 2]));
      }
      if (last !== null) c.stroke();
    };
    run(level, 0, level.n, null, style.width);
    for (const [from, to] of style.ranges) run(this.levels[0], from, to, css(style.select), style.width + 1.6);
  }
}
