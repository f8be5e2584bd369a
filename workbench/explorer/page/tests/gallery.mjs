// A picture of each chapter as it opens, for the gallery: its first figure. Taken where a folder is given.
import { mkdirSync, statSync } from "node:fs";
import { holds } from "./kit.mjs";

// Without a graphics card edges are not smooth; dots that are averaged make them so.
export const options = { viewport: { width: 1000, height: 800 }, deviceScaleFactor: 2 };

export async function test(opened, _library, { ids, gallery }) {
  if (!gallery) return;
  mkdirSync(gallery, { recursive: true });
  for (const id of ids) {
    await opened.turn(id);
    const path = `${gallery}/${id}.png`;
    await opened.page.locator("article figure .stage").first().screenshot({ path, scale: "css" });
    holds(statSync(path).size > 5000, `${id}: the picture is empty`);
  }
}
