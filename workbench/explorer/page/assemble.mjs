// Puts the bundle and the module of the library into one HTML file. Module and script are gzipped, as text that a browser
// unpacks by itself.
//
//     node assemble.mjs MODULE.wasm OUT.html COMPILER
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "fflate";

const [modulePath, out, compiler = "unknown"] = process.argv.slice(2);
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const text = (name) => readFileSync(here(name), "utf8");
const packed = (bytes) => Buffer.from(gzipSync(bytes, { level: 9, mtime: 0 })).toString("base64");
const parts = {
  COMPILER: compiler.replace(/["&<>]/g, ""),
  STYLE: text("dist/page.css").trim(),
  MODULE: packed(readFileSync(modulePath)),
  SCRIPT: packed(Buffer.from(text("dist/page.js").trim())),
};
const page = text("shell.html").replace(/%(COMPILER|STYLE|MODULE|SCRIPT)%/g, (_, name) => parts[name]);
writeFileSync(out, page);
console.log(`${out}: ${page.length} characters, ${parts.MODULE.length} of the module, ${parts.SCRIPT.length} of the script`);
