// The chapter in a browser: distances are the library's, and the walk goes where the library says.
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
  const told = [];
  for (let press = 0; press < 8; press += 1) {
    await page.getByRole("group", { name: "The second body on its way" }).getByLabel("One step on").click();
    await opened.rest();
    told.push(await page.getByRole("group", { name: "The second body on its way" }).locator(".told").innerText());
  }
  holds(new Set(told).size > 1, `the levels stay the same: ${told[0]}`);

  same(await opened.exercise("shared", "1"), true, "the exercise on neighbours");
  same(await opened.exercise("shared", "2"), false, "the exercise on neighbours, answered wrongly");
  same(await opened.exercise("tree", 1), true, "the exercise on the tree");
}
