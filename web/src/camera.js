// Where the eye is: three axes of the picture, the point in its middle, and pixels a millimetre. No perspective: lengths are true.

const ISO = 1 / Math.SQRT2, ISO6 = 1 / Math.sqrt(6), ISO3 = 1 / Math.sqrt(3);

/** Rows: to the right, upwards, towards the eye. */
export const VIEWS = {
  XY: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  XZ: [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
  YZ: [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
  ZX: [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
  "3-D": [[ISO, ISO, 0], [-ISO6, ISO6, 2 * ISO6], [ISO3, -ISO3, ISO3]],
};

export class Camera {
  constructor() {
    this.width = this.height = 1;
    this.center = [0, 0, 0];
    this.scale = 1;
    this.look("XY");
  }

  look(name) {
    this.name = name;
    this.rows = VIEWS[name].map((row) => [...row]);
    const up = VIEWS["3-D"];
    this.yaw = Math.atan2(-up[2][1], up[2][0]);
    this.tilt = Math.asin(up[2][2]);
  }

  get flat() { return this.name !== "3-D"; }

  /** Axes that must be known to be drawn, as bits 16, 32, 64. */
  get needs() {
    return [16, 32, 64].reduce((all, bit, a) => all | (Math.abs(this.rows[0][a]) + Math.abs(this.rows[1][a]) > 1e-6 ? bit : 0), 0);
  }

  turn(dx, dy) {
    this.yaw -= dx * 0.008;
    this.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.tilt + dy * 0.008));
    const cy = Math.cos(this.yaw), sy = Math.sin(this.yaw), ct = Math.cos(this.tilt), st = Math.sin(this.tilt);
    const eye = [cy * ct, -sy * ct, st], right = [sy, cy, 0], up = [-cy * st, sy * st, ct];
    this.rows = [right, up, eye];
  }

  pan(dx, dy) {
    for (let a = 0; a < 3; a++) this.center[a] += (-dx * this.rows[0][a] + dy * this.rows[1][a]) / this.scale;
  }

  zoom(factor, x, y) {
    const dx = x - this.width / 2, dy = y - this.height / 2;
    const most = 1e5, scale = Math.max(1e-4, Math.min(most, this.scale * factor));
    const change = 1 / this.scale - 1 / scale;
    this.scale = scale;
    for (let a = 0; a < 3; a++) this.center[a] += (dx * this.rows[0][a] - dy * this.rows[1][a]) * change;
  }

  /** Shows the whole path, or its cuts only. */
  fit({ points: p, kinds, blank, origin }, rapids) {
    const [r, u, e] = this.rows, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], needs = this.needs;
    // Of very long paths some points are enough.
    const stride = Math.max(1, Math.floor(kinds.length / 400000));
    const take = (i) => put([p[3 * i], p[3 * i + 1], p[3 * i + 2]]);
    const put = (at) => {
      [r, u, e].forEach((row, k) => {
        const value = row[0] * at[0] + row[1] * at[1] + row[2] * at[2];
        if (value < low[k]) low[k] = value;
        if (value > high[k]) high[k] = value;
      });
    };
    for (let i = 1; i < kinds.length; i += stride) {
      const k = kinds[i];
      if (k === 0xff || k & needs || (!rapids && (k & 15) === 0)) continue;
      take(i - 1);
      take(i);
    }
    // The corners of the blank, or of the box around it.
    if (blank) for (let bits = 0; bits < 8; bits++) {
      const round = (a, end) => (a === blank.axis ? end : end === blank.low ? -blank.radius : blank.radius);
      const corner = (a) => { const end = (bits >> a) & 1 ? blank.high : blank.low; return (blank.axis === undefined ? end[a] : round(a, end)) - origin[a]; };
      put([0, 1, 2].map(corner));
    }
    if (!(low[0] <= high[0])) { low.fill(-1); high.fill(1); }
    const middle = low.map((value, k) => (value + high[k]) / 2);
    this.center = [0, 1, 2].map((a) => r[a] * middle[0] + u[a] * middle[1] + e[a] * middle[2]);
    const w = Math.max(high[0] - low[0], 1e-3), h = Math.max(high[1] - low[1], 1e-3);
    this.scale = Math.min((this.width - 90) / w, (this.height - 80) / h, 1e4);
    if (!(this.scale > 0)) this.scale = 1;
  }

  /** Pixels of a point seen from the origin of the path. */
  project(x, y, z) {
    const [r, u] = this.rows, c = this.center;
    const dx = x - c[0], dy = y - c[1], dz = z - c[2];
    return [this.width / 2 + this.scale * (r[0] * dx + r[1] * dy + r[2] * dz), this.height / 2 - this.scale * (u[0] * dx + u[1] * dy + u[2] * dz)];
  }

  /** The point of the plane through the middle of the picture that is seen at these pixels. */
  unproject(x, y) {
    const dx = (x - this.width / 2) / this.scale, dy = (this.height / 2 - y) / this.scale;
    return [0, 1, 2].map((a) => this.center[a] + dx * this.rows[0][a] + dy * this.rows[1][a]);
  }
}

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
