// Puts the bundle and the module of the library into one HTML file.
//
//     node assemble.mjs MODULE.wasm OUT.html
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "fflate";

const [modulePath, out] = process.argv.slice(2);
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const text = (name) => readFileSync(here(name), "utf8");
const module = Buffer.from(gzipSync(readFileSync(modulePath), { level: 9, mtime: 0 })).toString("base64");
const parts = {
  STYLE: text("dist/page.css").trim(),
  MODULE: module,
  // The one sequence that would end the element early.
  SCRIPT: text("dist/page.js").trim().replaceAll("</script", "<\\/script"),
};
const page = text("shell.html").replace(/%(STYLE|MODULE|SCRIPT)%/g, (_, name) => parts[name]);
writeFileSync(out, page);
console.log(`${out}: ${page.length} characters, of which ${module.length} are the module`);
