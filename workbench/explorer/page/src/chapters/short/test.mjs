// The chapter in a browser: lengths and bounds are the library's.
import { holds, same } from "../../../tests/kit.mjs";

export const id = "short";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const agree = async () => {
    const { points, most } = await opened.state();
    const all = library.ask("answer", "min_length_all", { points, epsilon: 0.001 });
    same(await opened.read("length"), all.length, "the length");
    same(await opened.read("bound"), all.lower_bound, "the bound");
    same(
      await opened.read("few"),
      library.ask("answer", "min_length_all", { points, epsilon: 0.001, max_generators: most }).length,
      "few generators",
    );
    holds((await opened.read("verdict")).startsWith("right"), "the verifier agrees");
  };
  await opened.drag('#short-along [data-handle="1"]', 20, 15);
  await agree();
  for (const name of ["Square", "Triangle", "Two points"]) {
    await opened.preset(name);
    await agree();
  }
  await page.locator('[data-scrub="directions"]').focus();
  await page.keyboard.press("End");
  await opened.rest();
  same((await opened.state()).directions, 40, "directions after the key End");
  same(await opened.exercise("segment", "2.5"), true, "the exercise on a segment");
  same(await opened.exercise("axes", "3.5"), true, "the exercise on axes");
  same(await opened.exercise("square", "2.828"), true, "the exercise on the square");
  same(await opened.exercise("square", "2"), false, "the exercise on the square, answered wrongly");
}
