// The chapter in a browser: distances are the library's, and the walk goes where the library says.
import { readFileSync } from "node:fs";
import { holds, same } from "../../../tests/kit.mjs";

export const id = "again";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  await opened.preset("Twenty at random");
  await opened.preset("Polar zonohedron of 11");
  const agree = async () => {
    const { generators, most, rule } = await opened.state();
    const { hausdorff } = library.ask("answer", "reduce", { center: [0, 0, 0], generators, count: most, rule });
    same(await opened.read("upper"), hausdorff.upper, "the upper bound of the distance");
    same(await opened.read("lower"), hausdorff.lower, "the lower bound of the distance");
    holds((await opened.read("verdict")).startsWith("right"), `the verifier says ${await opened.read("verdict")}`);
  };
  await agree();
  await page.locator('[data-scrub="most"]').focus();
  await page.keyboard.press("ArrowRight");
  await opened.rest();
  await agree();
  await page.getByRole("combobox", { name: "Rule" }).selectOption("lemma_5_5");
  await opened.rest();
  await agree();

  const { generators, path } = await opened.state();
  const { neighbours } = library.ask("answer", "walk", { generators, facet: path[path.length - 1] });
  same(await page.locator("#again-walk [data-step]").count(), neighbours.length, "neighbours");
  await page.locator("#again-walk [data-step]").first().click();
  await opened.rest();
  const walked = (await opened.state()).path;
  same(JSON.stringify(walked[walked.length - 1]), JSON.stringify(neighbours[0]), "the facet after a step");

  const cut = library.ask("picture", "cutting", { generators, r: 2 });
  same(await opened.read("trapezoids"), cut.trapezoids.length, "trapezoids");
  holds((await page.locator("#again-cutting [data-trapezoid]").count()) > cut.trapezoids.length, "there is an image");
  await page.locator('[data-scrub="r"]').focus();
  await page.keyboard.press("ArrowRight");
  await opened.rest();
  const finer = library.ask("picture", "cutting", { generators, r: 3 });
  same(await opened.read("crossing"), finer.limit, "lines that cross a trapezoid");
  holds((await opened.read("crossed")) < (await opened.read("leaves")), "some leaves stay closed");

  // On its way the second body is told apart from the first, and found in it, by each of the levels.
  const flight = page.getByRole("group", { name: "The second body on its way" });
  const before = (await opened.state()).at;
  await flight.getByLabel("One step on").click();
  await opened.rest();
  same((await opened.state()).at, before + 1, "the place on the way after a step");
  const levels = (await opened.read("levels")).split(", ");
  holds(levels.length > 2, `the bodies have the levels ${levels}`);
  const told = new Set();
  for (let at = 0; at <= 30; at += 1) {
    await flight.getByLabel("Step", { exact: true }).fill(String(at));
    await opened.drawn();
    const [, status, level] = /^They (are apart|overlap).* (\d+) generators/.exec(
      await flight.locator(".told").innerText(),
    );
    told.add(`${status} ${level}`);
  }
  for (const level of levels)
    for (const status of ["are apart", "overlap"])
      holds(told.has(`${status} ${level}`), `no place on the way has ${status} ${level}: ${[...told].join("; ")}`);

  same(await opened.exercise("shared", "1"), true, "the exercise on neighbours");
  same(await opened.exercise("shared", "2"), false, "the exercise on neighbours, answered wrongly");
  same(await opened.exercise("tree", 1), true, "the exercise on the tree");

  // A picture of a figure of two views has both.
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.locator("#again-cutting").getByRole("button", { name: "SVG" }).click(),
  ]);
  const picture = readFileSync(await download.path(), "utf8");
  same(picture.split("<svg ").length - 1, 3, "pictures in the picture of the cutting, itself included");
}
