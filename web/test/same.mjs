// Runs requests in the module for browsers and compares its answers with those of the native library, byte for byte.
//
//   node same.mjs MODULE REQUESTS      REQUESTS: length, request, length, answer …

import { readFileSync } from "node:fs";

const [moduleFile, requestsFile] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(moduleFile), {});
const partc = instance.exports;
const all = readFileSync(requestsFile);
let at = 0, count = 0, size = 0;
const wrong = [];
const next = () => { const n = all.readUInt32LE(at); at += 4 + n; return all.subarray(at - n, at); };
while (at < all.length) {
  const request = next(), expected = next();
  const to = partc.request(request.length);
  new Uint8Array(partc.memory.buffer).set(request, to);
  const length = partc.answer();
  const answer = Buffer.from(partc.memory.buffer, partc.answer_at(), length);
  if (!answer.equals(expected)) {
    let i = 0;
    while (i < length && answer[i] === expected[i]) i++;
    wrong.push(`${request.subarray(4, 4 + request.readUInt32LE(0))}\n  byte ${i} of ${expected.length} and ${length}: ${expected.subarray(Math.max(i - 60, 0), i + 40)}\n  module: ${answer.subarray(Math.max(i - 60, 0), i + 40)}`);
  }
  count++;
  size += length;
}
console.log(`${count} answers, ${size} bytes, ${wrong.length} differ`);
if (wrong.length) {
  console.log(wrong.slice(0, 5).join("\n"));
  process.exit(1);
}
