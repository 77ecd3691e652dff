// Makes the page: `dist/report.html`, which is built into partc and stands in the repository, and, where the module is there,
// the playground, one file that needs nothing else.
//
//   node build.mjs                       dist/report.html
//   node build.mjs WASM PLAYGROUND       the playground, too
//   node build.mjs --check               fails where dist/report.html is not what the sources give

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const read = (name) => readFileSync(join(here, "src", name), "utf8");
const common = { bundle: true, minify: true, write: false, target: ["es2022"], charset: "utf8", legalComments: "none", loader: { ".H": "text" }, logLevel: "warning" };
const inputs = new Set();
async function bundle(name, more) {
  const made = await build({ ...common, entryPoints: [join(here, "src", name)], absWorkingDir: here, metafile: true, ...more });
  Object.keys(made.metafile.inputs).forEach((input) => inputs.add(input));
  return made.outputFiles[0].text.trim();
}

const licences = "/*! CodeMirror, style-mod, w3c-keyname, crelt: MIT, Copyright (C) 2018 by Marijn Haverbeke and others. See web/THIRD-PARTY.txt of partc. */";
// Nothing in it may end the element that it stands in.
const inside = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const script = `${licences}${inside(await bundle("main.js", { format: "iife" }))}`;
const worker = inside(await bundle("worker.js", { format: "iife" }));
const style = await bundle("style.css", {});

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
/** Nothing is asked for over any network; scripts are the one of the page and, in the playground, its worker. */
const policy = (more) => `default-src 'none'; script-src ${hash(script)}${more}; style-src 'unsafe-inline'; img-src data:; connect-src 'none'; form-action 'none'; base-uri 'none'`;

const page = (mark, parts, more) => {
  const values = { MARK: `<!-- (partc ${mark}) -->`, POLICY: policy(more), STYLE: style, PARTS: parts, SCRIPT: script };
  return read("index.html").replace(/@@(\w+)@@/g, (all, name) => values[name] ?? all);
};

/** The licences of what is in the page. */
const packages = [...new Set([...inputs].map((input) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(input)?.[1]).filter(Boolean))].sort();
const notice = packages.map((name) => {
  const { version, license } = JSON.parse(readFileSync(join(here, "node_modules", name, "package.json"), "utf8"));
  return `${name} ${version} (${license})\n\n${readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim()}\n`;
});
const notices = `The page of partc contains the packages below.\n\n${notice.join("\n" + "-".repeat(80) + "\n\n")}`;
const noticeFile = join(here, "THIRD-PARTY.txt");

const reportFile = join(here, "dist/report.html");
const same = (file, text) => existsSync(file) && readFileSync(file, "utf8") === text;
const report = page("report", "@@RESULT@@", "");
if (process.argv[2] === "--check") {
  if (!same(reportFile, report) || !same(noticeFile, notices)) {
    console.error("web/dist/report.html is not what its sources give: run `npm run build` in web");
    process.exit(1);
  }
} else {
  mkdirSync(dirname(reportFile), { recursive: true });
  writeFileSync(reportFile, report);
  writeFileSync(noticeFile, notices);
  console.log(`web/dist/report.html: ${report.length} bytes`);
}

/** LZMA with its length in the head, for `src/lzma.js`; without `xz`, gzip, which is a third more. */
function packed(file) {
  const bytes = readFileSync(file);
  try {
    const made = execFileSync("xz", ["--format=lzma", "--lzma1=preset=9e,lc=4,pb=0", "--stdout", file], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });
    made.writeBigUInt64LE(BigInt(bytes.length), 5);
    return made;
  } catch {
    console.warn("no `xz`: the module is packed by gzip");
    return gzipSync(bytes, { level: 9 });
  }
}

const [wasm, playground] = process.argv.slice(2).filter((argument) => argument !== "--check");
if (wasm && playground) {
  const parts = `<script type="text/plain" id="wasm">${packed(wasm).toString("base64")}</script>\n<script type="text/plain" id="worker">${worker}</script>`;
  const made = page("playground", parts, " blob: 'wasm-unsafe-eval'; worker-src blob:");
  writeFileSync(playground, made);
  console.log(`${playground}: ${made.length} bytes, ${gzipSync(made, { level: 9 }).length} packed`);
}
