// The page in a browser.
//
//     node tests/run.mjs PAGE.html MODULE.wasm [--only NAME] [--shots FOLDER] [--gallery FOLDER]
import { readdirSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { browserPath, launch, Library, Opened } from "./kit.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const words = process.argv.slice(2);
const option = (name) => (words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : null);
const [only, shots, gallery] = ["--only", "--shots", "--gallery"].map(option);
const [pagePath, modulePath] = words.map((word) => resolve(word));
if (!browserPath()) {
  console.log("\n*** SKIPPED: there is no browser, so nobody has looked at the page ***\n");
  process.exit(0);
}

const library = await Library.open(modulePath);
const browser = await launch();
const chapters = readdirSync(resolve(here, "../src/chapters"), { withFileTypes: true }).filter((entry) =>
  entry.isDirectory(),
);
const tests = await Promise.all([
  ...chapters.map(async ({ name }) => ({ name, ...(await import(`../src/chapters/${name}/test.mjs`)) })),
  ...["columns", "common", "lesson", "access", "touch", "widths", "gallery", "speed"].map(async (name) => ({
    name,
    ...(await import(`./${name}.mjs`)),
  })),
]);
const ids = tests.flatMap((test) => (test.id ? [test.id] : []));
let failed = 0;

async function run({ name, test, options }) {
  const begin = Date.now();
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const opened = new Opened(await context.newPage(), pagePath);
  try {
    await test(opened, library, { ids, shots, gallery });
    if (opened.complaints.length > 0) throw new Error(opened.complaints.join("\n"));
    console.log(`ok    ${name} (${((Date.now() - begin) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed += 1;
    console.log(`WRONG ${name}: ${error.stack ?? error}\n${opened.complaints.join("\n")}`);
  }
  await context.close();
}

// A test waits more than it works, so two of them run at a time; the longest begins, and times are taken alone.
const queue = tests.filter(({ name }) => (only ? name === only : name !== "speed"));
queue.sort((one, other) => (other.name === "common") - (one.name === "common"));
const lane = async () => {
  for (let next = queue.shift(); next; next = queue.shift()) await run(next);
};
await Promise.all([lane(), lane()]);
if (!only) await run(tests.find(({ name }) => name === "speed"));
await browser.close();
process.exit(failed === 0 ? 0 : 1);
