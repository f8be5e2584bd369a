// Puts the bundle and the module of the library into one HTML file. Module and script are packed by LZMA and written as
// letters; the page unpacks them by itself, with the scripts of src/unpack.
//
//     node assemble.mjs MODULE.wasm OUT.html COMPILER
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { compress } from "lzma1";
import { fromLetters, toLetters, unpackedLzma } from "./dist/unpack.js";

const [modulePath, out, compiler = "unknown"] = process.argv.slice(2);
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const text = (name) => readFileSync(here(name), "utf8");

function packed(bytes) {
  const letters = toLetters(new Uint8Array(compress(bytes, 9)));
  if (Buffer.compare(unpackedLzma(fromLetters(letters)), bytes) !== 0)
    throw new Error("what was packed is not unpacked");
  return letters;
}

const parts = {
  COMPILER: compiler.replace(/["&<>]/g, ""),
  STYLE: text("dist/page.css").trim(),
  OPENING: text("dist/opening.js").trim(),
  MODULE: packed(readFileSync(modulePath)),
  SCRIPT: packed(Buffer.from(text("dist/page.js").trim())),
};
const page = text("shell.html").replace(/%(COMPILER|STYLE|OPENING|MODULE|SCRIPT)%/g, (_, name) => parts[name]);
writeFileSync(out, page);
const sizes = Object.entries(parts).map(([name, part]) => `${Buffer.byteLength(part)} ${name.toLowerCase()}`);
console.log(`${out}: ${sizes.join(", ")} bytes`);
