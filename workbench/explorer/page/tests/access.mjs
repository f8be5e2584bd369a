// What axe-core finds, and what it cannot: names of handles, spoken read-outs.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { holds } from "./kit.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

export async function test(opened, _library, { ids }) {
  const { page } = opened;
  for (const id of ids) {
    await opened.turn(id);
    if (id === ids[0]) await page.evaluate(axe);
    for (const scheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: scheme });
      await opened.drawn();
      const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
      const serious = found.violations.filter(({ impact }) => impact === "serious" || impact === "critical");
      const told = serious.map(
        (one) =>
          `${one.id}: ${one.nodes
            .slice(0, 3)
            .map((node) => node.html.slice(0, 160))
            .join(" | ")}`,
      );
      holds(serious.length === 0, `${id}, ${scheme}: ${told.join("\n")}`);
      for (const label of await page
        .locator("[data-handle]")
        .evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")))) {
        holds(label && /\d/.test(label), `${id}: a handle is called ${label}`);
      }
    }
    await page.waitForFunction(() => document.querySelector(".speech").innerText.length > 10, null, {
      timeout: 10_000,
    });
  }
}
