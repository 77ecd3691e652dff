// What partc made, as arrays: src/page_data of the library packs it.

const ARRAYS = {
  lines: Uint32Array, points: Float32Array, kinds: Uint8Array, owners: Uint32Array, blocks: Uint32Array, printed: Uint32Array,
  feeds: Float32Array, radii: Float32Array, ways: Uint8Array, tool_of: Uint16Array,
};
const TEXTS = new Set(["code", "places"]);

/** The parts by name; those of the JSON in front stand beside them. */
export function unpack(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes[0] === 0x7b) return JSON.parse(new TextDecoder().decode(bytes));
  const count = view.getUint32(0, true);
  let at = 4 + 4 * count;
  const parts = [];
  for (let i = 0; i < count; i++) {
    const length = view.getUint32(4 + 4 * i, true);
    at = (at + 7) & ~7;
    parts.push(bytes.subarray(at, at + length));
    at += length;
  }
  const about = JSON.parse(new TextDecoder().decode(parts[0]));
  about.parts.forEach((name, i) => {
    const part = parts[i + 1];
    if (TEXTS.has(name)) about[name] = new TextDecoder().decode(part);
    else if ((part.byteOffset & 3) === 0) about[name] = new ARRAYS[name](part.buffer, part.byteOffset, part.byteLength / ARRAYS[name].BYTES_PER_ELEMENT);
    else about[name] = new ARRAYS[name](part.slice().buffer);
  });
  return about;
}

export const AXES = ["X", "Y", "Z"];
export const BEGINS = 0xff;
/** In the kind of a point: it lies behind the first error. */
export const BROKEN = 128;
export const RAPID = 0, LINE = 1, ARC = 2, THREAD = 3;

/** The colour of a tool, by its place in the list, which begins with no tool. */
export const shade = (tool) => (tool + 7) % 8;

/** The path with what a page asks of it: the last point of each move, the moves of each block, times, extents. */
export class Path {
  constructor(made) {
    Object.assign(this, made);
    const n = this.kinds.length, moves = this.blocks.length;
    // The points of move m end in front of ends[m].
    this.ends = new Uint32Array(moves);
    for (let i = 0; i < n; i++) this.ends[this.owners[i]] = i + 1;
    for (let m = 0, last = 0; m < moves; m++) last = this.ends[m] = Math.max(last, this.ends[m]);
    this.byBlock = order(this.blocks);
    this.times = this.pace();
    this.box = this.extents(false);
    this.whole = this.extents(true);
  }

  /** What is shown for a millimetre of an axis: of a diameter axis two. */
  factor(axis) { return this.diameter === AXES[axis] ? 2 : 1; }

  get segments() { return this.kinds.length; }
  get moves() { return this.blocks.length; }

  /** Seconds until each point, as if the speed were reached at once: for playing only. */
  pace() {
    const { points: p, kinds, owners, feeds, ways } = this, times = new Float64Array(kinds.length);
    let time = 0;
    for (let i = 1; i < kinds.length; i++) {
      const m = owners[i], k = kinds[i];
      if (k !== BEGINS && !(k & 112)) {
        const length = Math.hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2], p[3 * i + 2] - p[3 * i - 1]);
        // A feed per turn says nothing of time here.
        const feed = (k & 15) === RAPID ? this.model.rapid : ways[m] & 12 ? 300 : feeds[m];
        time += length / Math.max(feed, 1) * 60;
      }
      times[i] = time;
    }
    return times;
  }

  extents(rapids) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const { points: p, kinds } = this;
    for (let i = 1; i < kinds.length; i++) {
      const k = kinds[i];
      if (k === BEGINS || (!rapids && (k & 15) === RAPID)) continue;
      for (let a = 0; a < 3; a++) {
        if (k & (16 << a)) continue;
        const from = p[3 * i - 3 + a], to = p[3 * i + a];
        if (from < low[a]) low[a] = from;
        if (from > high[a]) high[a] = from;
        if (to < low[a]) low[a] = to;
        if (to > high[a]) high[a] = to;
      }
    }
    for (let a = 0; a < 3; a++) if (!(low[a] <= high[a])) low[a] = high[a] = 0;
    return { low, high };
  }

  /** The first point of move m, where it begins. */
  start(m) { return Math.max((m > 0 ? this.ends[m - 1] : 1) - 1, 0); }

  /** The moves of the block that begins on this line, in order. */
  movesOf(line) {
    const { sorted, keys } = this.byBlock;
    const from = lower(keys, line), to = lower(keys, line + 1);
    return sorted.subarray(from, to);
  }

  /** The move of an output line, or the next one. */
  moveOfPrinted(line) {
    return Math.min(lower(this.printed, line), this.moves - 1);
  }

  /** The coordinates of a point, in the workpiece. */
  place(i) {
    return [0, 1, 2].map((a) => this.points[3 * i + a] + this.origin[a]);
  }
}

/** Numbers of moves in the order of their blocks. */
function order(blocks) {
  let most = 0;
  for (const b of blocks) if (b > most) most = b;
  const counts = new Uint32Array(most + 2);
  for (const b of blocks) counts[b + 1]++;
  for (let i = 1; i < counts.length; i++) counts[i] += counts[i - 1];
  const sorted = new Uint32Array(blocks.length), keys = new Uint32Array(blocks.length);
  for (let m = 0; m < blocks.length; m++) {
    const at = counts[blocks[m]]++;
    sorted[at] = m;
    keys[at] = blocks[m];
  }
  return { sorted, keys };
}

/** The first place whose value is not below `value`. */
export function lower(list, value) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] < value) low = middle + 1; else high = middle;
  }
  return low;
}
