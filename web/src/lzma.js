// LZMA as `xz --format=lzma` writes it, with the length of what is packed in its head: the module is a quarter smaller in it than in
// the gzip that browsers unpack themselves.

// Where the probabilities of each kind begin.
const MATCH = 0, REP = 192, REP0 = 204, REP1 = 216, REP2 = 228, LONG = 240, SLOT = 432, FAR = 688, ALIGN = 803, LENGTH = 819, REP_LENGTH = 1333, LITERAL = 1847;

/** The bytes that were packed. */
export function unpacked(input) {
  const lc = input[0] % 9, rest = (input[0] / 9) | 0, lp = rest % 5, pb = (rest / 5) | 0;
  const size = new DataView(input.buffer, input.byteOffset, 13).getUint32(5, true), out = new Uint8Array(size);
  const probs = new Uint16Array(LITERAL + (0x300 << (lc + lp))).fill(1024);
  // Range and code: elements of an array stay plain numbers, which is twice as fast as variables of this function.
  const s = new Uint32Array([0xffffffff, 0]);
  let at = 13;
  for (let i = 0; i < 5; i++) s[1] = ((s[1] << 8) | input[at++]) >>> 0;

  function bit(i) {
    const p = probs[i], bound = (s[0] >>> 11) * p;
    let b = 0;
    if (s[1] < bound) { s[0] = bound; probs[i] = p + ((2048 - p) >> 5); } else { s[1] -= bound; s[0] -= bound; probs[i] = p - (p >> 5); b = 1; }
    if (s[0] < 0x1000000) { s[0] *= 256; s[1] = s[1] * 256 + input[at++]; }
    return b;
  }
  const tree = (base, bits) => {
    let m = 1;
    for (let i = 0; i < bits; i++) m = m << 1 | bit(base + m);
    return m - (1 << bits);
  };
  const reversed = (base, bits) => {
    let m = 1, value = 0;
    for (let i = 0; i < bits; i++) { const b = bit(base + m); m = m << 1 | b; value |= b << i; }
    return value;
  };
  const direct = (bits) => {
    let value = 0;
    for (; bits > 0; bits--) {
      s[0] = s[0] >>> 1;
      let b = 0;
      if (s[1] >= s[0]) { s[1] -= s[0]; b = 1; }
      value = value * 2 + b;
      if (s[0] < 0x1000000) { s[0] *= 256; s[1] = s[1] * 256 + input[at++]; }
    }
    return value;
  };
  const length = (base, side) => (bit(base) === 0 ? tree(base + 2 + (side << 3), 3) : bit(base + 1) === 0 ? 8 + tree(base + 130 + (side << 3), 3) : 16 + tree(base + 258, 8));
  const far = (long) => {
    const slot = tree(SLOT + (Math.min(long, 3) << 6), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1, base = (2 | slot & 1) * 2 ** bits;
    return slot < 14 ? base + reversed(FAR + base - slot, bits) : base + direct(bits - 4) * 16 + reversed(ALIGN, 4);
  };

  let n = 0, state = 0, r0 = 0, r1 = 0, r2 = 0, r3 = 0;
  while (n < size) {
    const side = n & ((1 << pb) - 1);
    if (!bit(MATCH + (state << 4) + side)) {
      const before = n > 0 ? out[n - 1] : 0, base = LITERAL + 0x300 * (((n & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
      let symbol = 1;
      if (state >= 7) {
        let match = out[n - r0 - 1];
        do {
          const wanted = match >> 7 & 1, b = bit(base + ((1 + wanted) << 8) + symbol);
          match <<= 1;
          symbol = symbol << 1 | b;
          if (wanted !== b) break;
        } while (symbol < 0x100);
      }
      while (symbol < 0x100) symbol = symbol << 1 | bit(base + symbol);
      out[n++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let long;
    if (!bit(REP + state)) {
      r3 = r2; r2 = r1; r1 = r0;
      long = length(LENGTH, side);
      state = state < 7 ? 7 : 10;
      r0 = far(long);
    } else {
      if (!bit(REP0 + state)) {
        if (!bit(LONG + (state << 4) + side)) {
          state = state < 7 ? 9 : 11;
          out[n] = out[n++ - r0 - 1];
          continue;
        }
      } else {
        let back = r1;
        if (bit(REP1 + state)) {
          back = r2;
          if (bit(REP2 + state)) { back = r3; r3 = r2; }
          r2 = r1;
        }
        r1 = r0;
        r0 = back;
      }
      long = length(REP_LENGTH, side);
      state = state < 7 ? 8 : 11;
    }
    // What was damaged on its way ends here.
    if (r0 >= n || at > input.length + 8) throw new Error("the module is damaged");
    for (const end = Math.min(n + long + 2, size); n < end; n++) out[n] = out[n - r0 - 1];
  }
  return out;
}
