// The chapter in a browser: three views show the same, and special positions are told.
import { holds, same } from "../../../tests/kit.mjs";

export const id = "tiling";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const { generators } = await opened.state().then((state) => state ?? { generators: null });
  holds(generators === null || Array.isArray(generators), "the address holds the state or none");
  const expected = async (list) => {
    const counted = library.ask("answer", "combinatorics", { generators: list });
    for (const name of ["vertices", "edges", "facets"]) same(await opened.read(name), counted[name], name);
    const { tiles } = library.ask("picture", "tiling", { generators: list });
    same(await page.locator("#tiling-tiling .tile").count(), tiles.length, "tiles in the picture");
    same(await page.locator("#tiling-arrangement .crossings circle").count(), tiles.length, "crossings in the picture");
  };
  await page.locator("#tiling-sweep .stepper button").last().click();
  await opened.rest();
  await expected((await opened.state()).generators);
  for (const name of [
    "Cube",
    "Rhombic dodecahedron",
    "Truncated octahedron",
    "Polar zonohedron of 7",
    "Three in a plane",
    "All in one plane",
    "One generator",
    "Parallel generators",
  ]) {
    await opened.preset(name);
    await expected((await opened.state()).generators);
  }
  holds((await page.locator("article").innerText()).includes("are parallel"), "parallel generators are told");

  // A tile under the pointer lights up its crossing.
  await opened.preset("Five generators");
  const tile = page.locator("#tiling-tiling .tile").nth(5);
  await tile.scrollIntoViewIfNeeded();
  const box = await tile.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await opened.drawn();
  holds((await tile.getAttribute("class")).includes("lit"), "the tile is lit up");
  same(
    await page.locator("#tiling-arrangement .crossings circle").nth(5).getAttribute("r"),
    "8",
    "the radius of the crossing that is lit up",
  );

  // Keys go from tile to tile.
  await page.locator("#tiling-tiling svg").focus();
  await page.keyboard.press("ArrowRight");
  await opened.drawn();
  holds(
    (await page.locator("#tiling-tiling .tile").nth(6).getAttribute("class")).includes("lit"),
    "the key lights up the next tile",
  );

  // A generator is pulled in space, and by keys.
  await opened.preset("Five generators");
  const before = (await opened.state()).generators;
  await opened.drag('#tiling-space [data-handle="0"]', 25, -10);
  const after = (await opened.state()).generators;
  holds(JSON.stringify(after[0]) !== JSON.stringify(before[0]), "the generator was pulled");
  same(JSON.stringify(after.slice(1)), JSON.stringify(before.slice(1)), "the other generators stay");
  await expected(after);

  // Numbers are typed.
  const type = async (name, text) => {
    await page.getByRole("textbox", { name }).fill(text);
    await page.keyboard.press("Tab");
    await opened.rest();
  };
  for (const [text, value] of [
    ["1.5", 1.5],
    ["0,5", 0.5],
    ["1/2", 0.5],
    ["−3/4", -0.75],
  ]) {
    await type("Generator 3, x", text);
    same((await opened.state()).generators[2][0], value, `the number that was typed as ${text}`);
    same(await page.getByRole("textbox", { name: "Generator 3, x" }).inputValue(), String(value), "the field after it");
  }
  for (const text of ["", "1e999", "thirty"]) {
    await type("Generator 3, x", text);
    same((await opened.state()).generators[2][0], -0.75, `the number after “${text}” was typed`);
    same(await page.getByRole("textbox", { name: "Generator 3, x" }).inputValue(), "-0.75", "the field has it again");
  }

  await page.getByRole("textbox", { name: "Generator 3, x" }).focus();
  await page.keyboard.press("ArrowUp");
  await opened.rest();
  same((await opened.state()).generators[2][0], -0.65, "the number after an arrow key");

  // Each generator has its colour, and the separator is faint where it runs behind the body.
  await opened.preset("Five generators");
  const colours = await page
    .locator("#tiling-space [data-handle] .mark")
    .evaluateAll((marks) => marks.map((mark) => getComputedStyle(mark).fill));
  same(new Set(colours).size, 5, "colours of the tips of five generators");
  same(
    await page.locator("#tiling-space .over .thin.dashed").count(),
    0,
    "from above no step of the separator is hidden",
  );
  await page.locator("#tiling-space canvas").focus();
  for (let press = 0; press < 16; press += 1) await page.keyboard.press("ArrowDown");
  await opened.drawn();
  const hidden = await page.locator("#tiling-space .over .thin.dashed").count();
  holds(hidden > 0, "seen from the side some steps of the separator are behind the body");

  same(await opened.exercise("facets", "30"), true, "the exercise on facets");
  same(await opened.exercise("facets", "15"), false, "the exercise on facets, answered wrongly");
  same(await opened.exercise("parallel", "6"), true, "the exercise on parallel generators");
  same(await opened.exercise("cell", "3"), true, "the exercise on cells");
  same(await opened.exercise("polar", 1), true, "the exercise on polar zonohedra");
  same(await opened.exercise("hexagon"), false, "five generators in general position have no hexagon");
  await page.locator('[data-exercise="hexagon"]').getByRole("button", { name: "Set it up" }).click();
  await opened.rest();
  for (const [axis, value] of Object.entries({ x: "3", y: "2", z: "2" })) await type(`Generator 3, ${axis}`, value);
  same(await opened.exercise("hexagon"), true, "the third generator is the sum of the first two");
  await opened.preset("Three in a plane");
  same(await opened.exercise("hexagon"), true, "three generators in a plane have a hexagon");

  // Slides: the tile beside its crossing, without a separator that nobody has explained.
  await page.getByRole("button", { name: "Slides" }).click();
  await page.getByRole("button", { name: "Next slide" }).click();
  await opened.rest();
  same(await page.locator("#tiling-tiling polyline.sweep").count(), 0, "separators before they are explained");
  await page.getByRole("button", { name: "Next slide" }).click();
  await opened.rest();
  for (const name of ["tiling", "arrangement"])
    holds(await page.locator(`#tiling-${name}.on-stage`).isVisible(), `the view ${name} of the slide`);
  holds(/^Tile 4 of/.test(await page.locator(".slide-read").innerText()), "the slide says what is lit up");
  same(await page.locator("#tiling-arrangement line.sweep").count(), 0, "vertical lines before they are explained");
  await page.keyboard.press("Escape");
  await opened.rest();
}
