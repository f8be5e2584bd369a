// Bundles the page's script and style into dist/page.js and dist/page.css. The same sources give the same bytes.
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
  entryPoints: { page: "src/main.ts" },
  outdir: "dist",
  format: "iife",
  define: { WORKER_SCRIPT: JSON.stringify(worker.outputFiles[0].text) },
});
await build({ ...common, entryPoints: { page: "src/styles/page.css" }, outdir: "dist" });
