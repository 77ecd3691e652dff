// What the grammars say of words in examples of each language.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

const require = createRequire(import.meta.url);
const here = path.dirname(fileURLToPath(import.meta.url));
const at = (...parts) => path.join(here, ...parts);
const oniguruma = require("vscode-oniguruma");
const { INITIAL, Registry, parseRawGrammar } = require("vscode-textmate");

const wasm = readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
const onigLib = oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength)).then(() => ({
  createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
  createOnigString: (text) => new oniguruma.OnigString(text),
}));
const registry = new Registry({
  onigLib,
  loadGrammar: async (scope) => {
    const file = at("..", "syntaxes", `${scope.replace("source.", "")}.tmLanguage.json`);
    return parseRawGrammar(readFileSync(file, "utf8"), file);
  },
});

/// Tokens of an example: line from 1, text, scope without the language.
async function tokens(language, file) {
  const grammar = await registry.loadGrammar(`source.${language}`);
  const all = [];
  let state = INITIAL;
  const lines = readFileSync(at("examples", file), "utf8").split("\n");
  for (const [index, line] of lines.entries()) {
    const result = grammar.tokenizeLine(line, state);
    state = result.ruleStack;
    for (const token of result.tokens) {
      const text = line.slice(token.startIndex, token.endIndex).trim();
      const scope = token.scopes.length > 1 ? token.scopes.at(-1).replace(`.${language}`, "") : "";
      if (text) all.push({ line: index + 1, text, scope });
    }
  }
  return all;
}

const expected = {
  klartext: ["part.H", [
    [1, "BEGIN PGM", "keyword.control.program"], [1, "PART", "entity.name.function"], [1, "; a comment", "comment.line.semicolon"],
    [2, "* - Roughing", "markup.heading.structure"], [3, "BLK FORM", "keyword.control"], [4, "TOOL CALL", "keyword.control.tool"],
    [4, "2500", "constant.numeric"], [4, "+0,1", "constant.numeric"], [5, "LBL", "keyword.control.label"],
    [5, "\"HOLES\"", "string.quoted.double"], [6, "4", "constant.numeric.line-number"], [6, "L", "keyword.operator.path"],
    [6, "X", "variable.parameter.axis"], [6, "IY", "variable.parameter.axis"], [6, "-5,5", "constant.numeric"],
    [6, "R0", "keyword.operator.compensation"], [6, "FMAX", "constant.language.feed"], [6, "M3", "support.function.m"],
    [7, "CYCL DEF", "keyword.control.cycle"], [7, "200", "constant.numeric.cycle"], [7, "DRILLING", "entity.name.type.cycle"],
    [7, "~", "punctuation.separator.continuation"], [8, "Q200", "variable.other.q"], [8, ";SET-UP CLEARANCE", "comment.line.semicolon"],
    [9, "DATUM SHIFT", "entity.name.type.cycle"], [10, "APPR LCT", "keyword.operator.path"], [10, "RL", "keyword.operator.compensation"],
    [11, "CC", "keyword.operator.path"], [12, "CP", "keyword.operator.path"], [12, "IPA", "variable.parameter.axis"],
    [12, "DR-", "keyword.operator.compensation"], [13, "FN", "keyword.control.function"], [13, "GOTO", "keyword.control"],
    [14, "SIN", "support.function.math"], [15, "CALL LBL", "keyword.control.label"], [15, "3", "entity.name.label"],
    [15, "REP", "keyword.control.repeat"], [16, "CALL PGM", "keyword.control.call"], [16, "TNC:\\SUB.H", "entity.name.function"],
  ]],
  sinumerik: ["part.mpf", [
    [1, "%_N_PART_MPF", "entity.name.section"], [2, "; a comment", "comment.line.semicolon"], [3, "PROC", "keyword.control"],
    [3, "PART", "entity.name.function"], [3, "REAL", "storage.type"], [4, "DEF", "storage.type"], [4, "12.5", "constant.numeric"],
    [5, "N10", "constant.numeric.line-number"], [5, "G0", "keyword.operator.path.g"], [5, "X", "variable.parameter.axis"],
    [5, "R1", "variable.other.r"], [5, "20.5", "constant.numeric"], [5, "S", "keyword.other.address"], [5, "M3", "support.function.m"],
    [6, "/2", "keyword.control.skip"], [6, "F", "keyword.other.address"], [6, "_FEED", "variable.other"],
    [7, "NEXT", "entity.name.label"], [7, "IF", "keyword.control"], [7, "AND", "keyword.operator.word"], [7, "$P_TOOL", "variable.language.system"],
    [8, "GOTOF", "keyword.control.jump"], [8, "DONE", "entity.name.label"], [10, "MCALL", "keyword.control"],
    [10, "CYCLE81", "support.function.cycle"], [10, "-15", "constant.numeric"], [11, "\"hello ; no comment\"", "string.quoted.double"],
    [12, "TRANS", "support.function.frame"], [13, "CR", "keyword.other.address"], [14, "DONE", "entity.name.label"], [15, "M17", "keyword.control"],
  ]],
  "heidenhain-turning": ["part.ncs", [
    [1, "HEADER", "markup.heading.section"], [2, "#UNIT", "keyword.other.directive"], [3, "FINISHED PART", "markup.heading.section"],
    [4, "N2", "constant.numeric.line-number"], [4, "G0", "keyword.operator.path.g"], [4, "X", "variable.parameter.axis"],
    [6, "T", "keyword.other.address"], [6, "0.3", "constant.numeric"], [6, "M3", "support.function.m"], [6, "[a comment]", "comment.block.bracket"],
    [7, "NS", "keyword.other.address"], [8, "IF", "keyword.control"], [8, "#l1", "variable.other"], [8, "THEN", "keyword.control"],
    [9, "Xi", "variable.parameter.axis"], [9, "-2.5", "constant.numeric"], [9, "#l2", "variable.other"], [12, "END", "markup.heading.section"],
  ]],
  mtc200: ["part.npg", [
    [1, "%NPG:0:00:0:0", "entity.name.section.header"], [2, "*PART", "string.unquoted.name"], [3, "N10", "constant.numeric.line-number"],
    [3, "G90", "keyword.operator.path.g"], [3, "X", "variable.parameter.axis"], [3, "@5", "variable.other"], [3, "-10.5", "constant.numeric"],
    [3, "(a comment)", "comment.block.parenthesis"], [4, ".LOOP", "entity.name.label"], [4, "; another", "comment.line.semicolon"],
    [5, "BEQ", "keyword.control.jump"], [5, ".LOOP", "entity.name.label"], [6, "JSR", "keyword.control.call"], [6, "P12", "entity.name.function"],
    [7, "@1", "variable.other"], [8, "RET", "keyword.control"],
  ]],
};

for (const [language, [file, words]] of Object.entries(expected)) {
  test(language, async () => {
    const all = await tokens(language, file);
    const lost = words.filter(([line, text, scope]) => !all.some((t) => t.line === line && t.text === text && t.scope === scope));
    const found = lost.map(([line, text, scope]) => ({
      line, text, scope, instead: all.filter((t) => t.line === line).map((t) => `${t.text}: ${t.scope}`),
    }));
    assert.deepEqual(found, []);
    // Nothing in an example is without a colour but what stands between words.
    const plain = all.filter((t) => t.scope === "" && /\w/.test(t.text)).map((t) => `${t.line}: ${t.text}`);
    assert.deepEqual(plain, []);
  });
}
