// What a reader and a teacher do beside the figures: tools, exercises, slides, downloads, paper.
import { readFileSync } from "node:fs";
import { holds, same, text } from "./kit.mjs";

export const options = { acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"] };

export async function test(opened, _library, { ids }) {
  await tools(opened);
  await notes(opened);
  await replies(opened);
  await setting(opened);
  await downloads(opened);
  await contrast(opened);
  await labels(opened);
  await paper(opened);
  await turned(opened);
  for (const id of ids) await slides(opened, id);
}

/** The tools tell what can be done, and the list of presets and its note what is seen. */
async function tools(opened) {
  const { page } = opened;
  await opened.chapter("smallest-zonogon");
  const [undo, redo, reset] = ["undo", "redo", "reset"].map((name) => page.locator(`[data-tool="${name}"]`));
  const list = page.getByRole("combobox", { name: "Preset" });
  const note = page.locator(".toolbox .note");
  holds(await undo.isDisabled(), "there is nothing to undo in the beginning");
  await list.selectOption({ index: 2 });
  await opened.rest();
  same(await list.inputValue(), "1", "the list names the preset");
  holds((await note.innerText()).length > 10, "the preset has a note");
  holds((await undo.isEnabled()) && (await redo.isDisabled()), "a preset can be undone, and nothing done again");
  await undo.click();
  same(`${await list.inputValue()}${await note.innerText()}`, "", "the list and the note after an undo");
  holds((await undo.isDisabled()) && (await redo.isEnabled()), "the preset can be done again");
  await redo.click();
  same(await list.inputValue(), "1", "the list names the preset that was done again");
  await reset.click();
  same(`${await list.inputValue()}${await note.innerText()}`, "", "the list and the note after a reset");

  const random = page.getByRole("button", { name: "Random" });
  const seed = page.getByRole("spinbutton", { name: "Seed" });
  const seen = async () => {
    await opened.rest();
    return text(await opened.state());
  };
  await random.click();
  const first = await seen();
  same(await seed.inputValue(), "1", "the seed of what is seen");
  await random.click();
  holds((await seen()) !== first && (await seed.inputValue()) === "2", "the next random data have the next seed");
  await seed.fill("1");
  await random.click();
  same(await seen(), first, "the same seed gives the same data");
}

async function notes(opened) {
  const { page } = opened;
  const note = page.locator(".toolbox .note");
  await opened.chapter("tiling");
  await page.getByRole("button", { name: "Copy as command" }).click();
  await page.waitForFunction(() => document.querySelector(".note").textContent.includes("zonobench"));
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.waitForFunction(() => document.querySelector(".note").textContent.includes("link"));
  holds(/turned/.test(await note.innerText()), "the note says that the turn of a view is not in the link");
  await opened.chapter("smallest-zonogon");
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.waitForFunction(() => document.querySelector(".note").textContent.includes("link"));
  holds(!/turned/.test(await note.innerText()), "a chapter of the plane has no turned views");
}

/** Numbers are read as people write them; what is none is told, and a verdict ends with its reply. */
async function replies(opened) {
  const { page } = opened;
  await opened.chapter("tiling");
  const item = page.locator('[data-exercise]:has(input[type="text"])').first();
  const [field, verdict] = [item.locator('input[type="text"]'), item.locator(".verdict")];
  const check = async (reply) => {
    await field.fill(reply);
    same(await verdict.innerText(), "", `the verdict before ${reply} is checked`);
    await item.locator(".check").click();
    return verdict.innerText();
  };
  const [right, told] = [await check("30"), await check("7,5")];
  holds(right.startsWith("✓") && told.startsWith("✗"), "the exercise asks for 30");
  for (const reply of ["60/2", " 3e1 ", "90 / 3", "30,0", "+30."]) same(await check(reply), right, reply);
  for (const reply of ["−30", "1/2", ".5"]) holds((await check(reply)).startsWith("✗"), `${reply} is a number`);
  for (const reply of ["thirty", "30 facets", "1/0", "1e999", "1/2/3", "0x1e", "1.2.3"])
    holds((await check(reply)).startsWith("Write a number"), `${reply} is none: ${await verdict.innerText()}`);
  holds((await check("")).startsWith("Write down"), "nothing is no answer");
}

/** An exercise that sets its figure up leads there and back. */
async function setting(opened) {
  const { page } = opened;
  await opened.chapter("inside");
  const item = page.locator("[data-exercise]:has(button:text-is('Set it up'))").first();
  await item.locator(".check").click();
  await item.getByRole("button", { name: "Set it up" }).click();
  await opened.rest();
  same(await item.locator(".verdict").innerText(), "", "the verdict after the exercise was set up");
  const isSeen = (locator) =>
    locator.evaluate((one) => {
      const { top, bottom } = one.getBoundingClientRect();
      return top >= 0 && bottom <= innerHeight;
    });
  holds(await isSeen(page.locator("figure:has(.set-up) .view").first()), "the figure that was set up is seen");
  await page.getByRole("button", { name: "Back to the exercise" }).click();
  holds(await isSeen(item.locator(".reply")), "the exercise is seen again");
  same(await page.locator(".set-up").count(), 0, "nothing is set up any more");
}

/** A picture that is taken along keeps its colours without the page. */
async function downloads(opened) {
  const { page } = opened;
  await opened.chapter("inside");
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.locator("#inside-search .figure-tools").getByRole("button", { name: "SVG" }).click(),
  ]);
  const picture = readFileSync(await download.path(), "utf8");
  holds(/<polygon/.test(picture) && !/var\(|style=/.test(picture), "the picture stands by itself");
}

/** Lines in the colours of the zones stand off from the paper, be it light or dark. */
async function contrast(opened) {
  const { page } = opened;
  await opened.chapter("tiling");
  for (let more = 0; more < 3; more += 1) await page.getByRole("button", { name: "Add a generator" }).click();
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await opened.rest();
    const found = await page.evaluate(() => {
      const luminance = (colour) => {
        const [r, g, b] = colour
          .match(/\d+/g)
          .slice(0, 3)
          .map((one) => one / 255)
          .map((one) => (one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const paper = luminance(getComputedStyle(document.body).backgroundColor);
      return [...document.querySelectorAll("#tiling-arrangement .lines line")].map((line) => {
        const two = [paper, luminance(getComputedStyle(line).stroke)].sort((one, other) => other - one);
        return (two[0] + 0.05) / (two[1] + 0.05);
      });
    });
    same(found.length, 8, "lines of the arrangement");
    holds(
      Math.min(...found) >= 2.95,
      `contrasts of lines on ${colorScheme} paper: ${found.map((one) => one.toFixed(2))}`,
    );
  }
  await page.emulateMedia({ colorScheme: "light" });
}

/** Names in a view lie in it whole, however large its letters are. */
async function labels(opened) {
  const { page } = opened;
  await opened.chapter("tiling");
  for (const [width, height] of [
    [360, 740],
    [2560, 1440],
    [1280, 900],
  ]) {
    await page.setViewportSize({ width, height });
    for (let round = 0; round < 2; round += 1) await opened.drawn();
    const out = await page.evaluate(() => {
      const view = document.querySelector("#tiling-arrangement svg").getBoundingClientRect();
      return [...document.querySelectorAll("#tiling-arrangement .names text")]
        .map((one) => [one.textContent, one.getBoundingClientRect()])
        .filter(
          ([, box]) => box.left < view.left || box.right > view.right || box.top < view.top || box.bottom > view.bottom,
        )
        .map(([name]) => name);
    });
    same(out.join(), "", `names at the edge of the arrangement at ${width}`);
  }
}

/** On paper predictions can be ticked, and there is nothing to press. */
async function paper(opened) {
  const { page } = opened;
  await opened.chapter("inside");
  await page.emulateMedia({ media: "print" });
  same(
    await page
      .locator("canvas.space")
      .first()
      .evaluate((one) => getComputedStyle(one).objectFit),
    "contain",
    "fit",
  );
  holds(await page.locator(".reply fieldset").first().isVisible(), "predictions are on the paper");
  const pressed = await page
    .locator("article button, header button")
    .evaluateAll((all) => all.filter((one) => one.getClientRects().length > 0).map((one) => one.textContent));
  same(pressed.join("; "), "", "buttons on the paper");
  await page.emulateMedia({ media: "screen" });
}

/** A body that was turned on a slide does not keep the keys. */
async function turned(opened) {
  const { page } = opened;
  await opened.chapter("tiling");
  await page.getByRole("button", { name: "Slides" }).click();
  await opened.rest();
  const count = page.locator(".slide-bar .count");
  await page.locator(".on-stage canvas").click({ position: { x: 200, y: 100 } });
  await page.keyboard.press("ArrowRight");
  holds(/^2 of/.test(await count.innerText()), `an arrow after a turn: ${await count.innerText()}`);
  await page.keyboard.press("ArrowLeft");
  await page.locator(".on-stage canvas").focus();
  await page.keyboard.press("ArrowRight");
  holds(/^1 of/.test(await count.innerText()), "arrows turn a body that was reached by Tab");
  await page.keyboard.press("PageDown");
  holds(/^2 of/.test(await count.innerText()), "the keys of a presenter lead on, whatever has the focus");
  await page.keyboard.press("Escape");
}

/** On each slide the pictures lie side by side in the window, and sentences are not cut off. */
async function slides(opened, id) {
  const { page } = opened;
  await opened.turn(id);
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.getByRole("button", { name: "Slides" }).click();
  await opened.rest();
  const count = Number(/\d+$/.exec(await page.locator(".slide-bar .count").innerText())[0]);
  for (let slide = 1; slide <= count; slide += 1) {
    const wrong = await page.evaluate(() => {
      const box = (one) => one.getBoundingClientRect();
      const views = [...document.querySelectorAll(".on-stage")].map(box);
      const told = [...document.querySelectorAll(".on-stage .told, .slide-words > *")].filter(
        (one) => one.scrollWidth > one.clientWidth + 1 || box(one).right > innerWidth,
      );
      return [
        ...(views.length === 0 ? ["no figure"] : []),
        ...(views.length > 1 && views[0].right > views[1].left + 1 ? ["figures over each other"] : []),
        ...told.map((one) => `cut off: ${one.textContent}`),
      ];
    });
    same(wrong.join("; "), "", `slide ${slide} of ${id}`);
    await page.keyboard.press("PageDown");
    await opened.rest();
  }
  await page.keyboard.press("Escape");
  await opened.rest();
}
