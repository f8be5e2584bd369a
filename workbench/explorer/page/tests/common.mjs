// What every chapter owes its readers: presets, links, undo, downloads, takeaways, own data, slides.
import { readFileSync } from "node:fs";
import { copiedBy, holds, same, text } from "./kit.mjs";

export const options = { acceptDownloads: true };

const OWN = {
  "smallest-zonogon": "x,y\n0,0\n2,0\n0,2\n3,1\n",
  tiling: "1 0 0.5\n0 1 0.5\n1 1 0.2\n",
  inside: '{"center": [0, 0, 0], "generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}',
  short: '{"type": "LineString", "coordinates": [[0, 0], [2, 0], [2, 2]]}',
  again: "1 0 0.5\n0 1 0.5\n1 1 0.2\n-1 1 0.3\n",
  volumes: "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
  motion: '{"generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}',
};

export async function test(opened, library, { ids }) {
  const { page } = opened;
  for (const id of ids) {
    await opened.turn(id);
    const presets = await page.getByRole("combobox", { name: "Preset" }).locator("option").allTextContents();
    for (const name of presets.slice(1)) {
      await opened.preset(name);
      holds(!(await page.locator(".notice").first().isVisible()), `${id}: the library answers ${name}`);
      for (const read of await page.locator("output.read").allTextContents())
        holds(!/NaN|undefined|null/.test(read), `${id}, ${name}: a read-out is ${read}`);
    }

    // A link brings the state back.
    await opened.preset(presets[2]);
    const told = await opened.state();
    const link = await copiedBy(page, "Copy link");
    await page.goto("about:blank");
    await page.goto(link);
    await page.waitForSelector(`article#${id} figure`);
    await page.locator('[data-tool="reset"]').click();
    await opened.rest();
    await page.locator('[data-tool="undo"]').click();
    await opened.rest();
    same(text(await opened.state()), text(told), `${id}: the state of a link`);
    await page.locator('[data-tool="redo"]').click();
    await opened.rest();
    holds(text(await opened.state()) !== text(told), `${id}: redo goes on`);

    // The command holds a question that the library answers.
    const command = await copiedBy(page, "Copy as command");
    const question = /^printf '%s\\n' '(.*)' \| zonobench solve$/.exec(command)?.[1];
    holds(question && JSON.parse(library.call("answer", question)).result, `${id}: the command is answered`);
    JSON.parse(await copiedBy(page, "Copy as JSON"));

    // Downloads are pictures.
    for (const [kind, begins] of [
      ["SVG", "<svg"],
      ["PNG", "\x89PNG"],
    ]) {
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.locator(".figure-tools").first().getByRole("button", { name: kind }).click(),
      ]);
      const content = readFileSync(await download.path());
      holds(
        content.subarray(0, begins.length).toString("latin1") === begins,
        `${id}: the ${kind} begins with ${begins}`,
      );
      holds(content.length > 800, `${id}: the ${kind} has ${content.length} bytes`);
    }

    // Random data and own data.
    if ((await page.getByRole("button", { name: "Random" }).count()) > 0) {
      await page.getByRole("button", { name: "Random" }).click();
      await opened.rest();
      holds(!(await page.locator(".notice").first().isVisible()), `${id}: the library answers random data`);
    }
    await page.getByRole("button", { name: "Own data …" }).click();
    await page.getByRole("textbox", { name: "Data" }).fill("nothing here");
    await page.getByRole("button", { name: "Show", exact: true }).click();
    holds(
      (await page.locator(".problem").innerText()).length > 10,
      `${id}: a text without numbers is refused with a reason`,
    );
    await page.getByRole("textbox", { name: "Data" }).fill(OWN[id] ?? OWN.inside);
    await page.getByRole("button", { name: "Show", exact: true }).click();
    await opened.rest();
    await page.waitForSelector("dialog", { state: "detached" });

    // Slides.
    const before = text(await opened.state());
    await page.getByRole("button", { name: "Slides" }).click();
    holds(/^1 of/.test(await page.locator(".slide-bar .count").innerText()), `${id}: the first slide`);
    const stage = await page.locator(".on-stage .view").boundingBox();
    holds(stage.height > 300, `${id}: the figure of a slide is ${stage.height} pixels high`);
    await page.keyboard.press("ArrowRight");
    await opened.rest();
    holds(/^2 of/.test(await page.locator(".slide-bar .count").innerText()), `${id}: the second slide`);
    await page.keyboard.press("Escape");
    await opened.rest();
    same(text(await opened.state()), before, `${id}: the state after the slides`);
    same(await page.locator(".on-stage").count(), 0, `${id}: no figure stays on the stage`);
  }
}
