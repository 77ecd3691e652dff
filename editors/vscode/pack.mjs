// Packs the extension: a .vsix is a ZIP with two lists in front. The same files give the same bytes.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import * as zlib from "node:zlib";

const meta = JSON.parse(readFileSync("package.json", "utf8"));
const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.codePointAt(0)};`);
const folder = (name) => readdirSync(name).sort().map((file) => `${name}/${file}`);

const { scripts, dependencies, devDependencies, private: _, ...shipped } = meta;
const files = new Map([
  ["package.json", Buffer.from(JSON.stringify(shipped, null, 2))],
  ["README.md", readFileSync("README.md")],
  ["LICENSE.txt", readFileSync("../../LICENSE-MIT")],
]);
for (const path of [...folder("dist"), ...folder("language"), ...folder("syntaxes")]) files.set(path, readFileSync(path));

const manifest = `<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
<Metadata><Identity Language="en-US" Id="${meta.name}" Version="${meta.version}" Publisher="${meta.publisher}"/>
<DisplayName>${escaped(meta.displayName)}</DisplayName><Description xml:space="preserve">${escaped(meta.description)}</Description>
<Tags>${escaped(meta.keywords.join(","))}</Tags><Categories>${escaped(meta.categories.join(","))}</Categories>
<License>extension/LICENSE.txt</License>
<Properties><Property Id="Microsoft.VisualStudio.Code.Engine" Value="${escaped(meta.engines.vscode)}"/></Properties></Metadata>
<Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation><Dependencies/>
<Assets><Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true"/>
<Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true"/>
<Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true"/></Assets>
</PackageManifest>
`;
const ends = { json: "application/json", js: "application/javascript", md: "text/markdown", txt: "text/plain", vsixmanifest: "text/xml" };
const types = `<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">${Object.entries(ends)
  .map(([end, type]) => `<Default Extension=".${end}" ContentType="${type}"/>`)
  .join("")}</Types>
`;

const entries = [
  ["extension.vsixmanifest", Buffer.from(manifest)],
  ["[Content_Types].xml", Buffer.from(types)],
  ...[...files].map(([name, content]) => [`extension/${name}`, content]),
];
const parts = [];
const list = [];
let at = 0;
for (const [name, content] of entries) {
  const packed = zlib.deflateRawSync(content, { level: 9 });
  // Version 2.0, names in UTF-8, deflated, 1 January 1980.
  const head = Buffer.alloc(26);
  head.writeUInt16LE(20, 0);
  head.writeUInt16LE(0x0800, 2);
  head.writeUInt16LE(8, 4);
  head.writeUInt16LE(0, 6);
  head.writeUInt16LE(0x0021, 8);
  head.writeUInt32LE(checksum(content), 10);
  head.writeUInt32LE(packed.length, 14);
  head.writeUInt32LE(content.length, 18);
  head.writeUInt16LE(Buffer.byteLength(name), 22);
  const place = Buffer.alloc(14);
  place.writeUInt32LE(at, 10);
  parts.push(Buffer.from("PK\x03\x04"), head, Buffer.from(name), packed);
  list.push(Buffer.from("PK\x01\x02"), Buffer.from([20, 0]), head, place, Buffer.from(name));
  at += 4 + head.length + Buffer.byteLength(name) + packed.length;
}
const directory = Buffer.concat(list);
const end = Buffer.alloc(18);
end.writeUInt16LE(entries.length, 4);
end.writeUInt16LE(entries.length, 6);
end.writeUInt32LE(directory.length, 8);
end.writeUInt32LE(at, 12);
const file = `${meta.name}-${meta.version}.vsix`;
writeFileSync(file, Buffer.concat([...parts, directory, Buffer.from("PK\x05\x06"), end]));
console.log(`${file}: ${at + directory.length + 22} bytes, ${entries.length} files`);

/// CRC-32; Node has it from version 22 on.
function checksum(bytes) {
  if (zlib.crc32) return zlib.crc32(bytes);
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let i = 0; i < 8; i++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
