// Runs partc beside the page, so that a long program does not stop it. One request at a time; an answer is its bytes.

import { unpacked } from "./lzma.js";

let module;

/** The module: packed by gzip where it was made without `xz`. */
async function bytesOf(packed) {
  if (packed[0] !== 0x1f) return unpacked(packed);
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

onmessage = async ({ data }) => {
  if (data.module) {
    module = (await WebAssembly.instantiate(await bytesOf(data.module), {})).instance.exports;
    postMessage({ ready: ask({ what: "about", files: [] }, []) });
    return;
  }
  const { id, asked, files } = data;
  const began = performance.now();
  try {
    const made = ask({ ...asked, what: "make" }, files);
    postMessage({ id, made, took: performance.now() - began }, [made.buffer]);
    const checked = ask({ ...asked, what: "check" }, files);
    postMessage({ id, checked, took: performance.now() - began }, [checked.buffer]);
  } catch (error) {
    postMessage({ id, broken: String(error) });
  }
};

/** The bytes of an answer of partc. */
function ask(asked, files) {
  const json = new TextEncoder().encode(JSON.stringify({ ...asked, files: files.map(({ name, bytes }) => [name, bytes.length]) }));
  const size = 4 + json.length + files.reduce((all, { bytes }) => all + bytes.length, 0);
  let at = module.request(size);
  const memory = new Uint8Array(module.memory.buffer);
  new DataView(module.memory.buffer).setUint32(at, json.length, true);
  memory.set(json, at + 4);
  at += 4 + json.length;
  for (const { bytes } of files) { memory.set(bytes, at); at += bytes.length; }
  const length = module.answer();
  return new Uint8Array(module.memory.buffer).slice(module.answer_at(), module.answer_at() + length);
}
