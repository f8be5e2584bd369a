// Bundles the page's scripts and its style into dist/page.js, dist/opening.js and dist/page.css, what packs and unpacks
// them into dist/unpack.js, and what reads columns into dist/columns.js, for the tests. The same sources give the same bytes.
import { build } from "esbuild";

const common = {
  bundle: true,
  minify: true,
  charset: "utf8",
  target: "es2022",
  legalComments: "none",
  logLevel: "warning",
  loader: { ".csv": "text", ".html": "text" },
};
const worker = await build({ ...common, entryPoints: ["src/engine/worker.ts"], format: "iife", write: false });
await build({
  ...common,
  entryPoints: { page: "src/main.ts", opening: "src/opening.ts" },
  outdir: "dist",
  format: "iife",
  define: { WORKER_SCRIPT: JSON.stringify(worker.outputFiles[0].text) },
});
await build({ ...common, entryPoints: { page: "src/styles/page.css" }, outdir: "dist" });
await build({
  ...common,
  entryPoints: { unpack: "src/unpack/index.ts", columns: "src/engine/columns.ts" },
  outdir: "dist",
  format: "esm",
});
