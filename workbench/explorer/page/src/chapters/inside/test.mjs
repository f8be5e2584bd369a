// The chapter in a browser: answers and gauges are the library's, and the proof changes its kind at the boundary.
import { holds, same } from "../../../tests/kit.mjs";

export const id = "inside";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const agree = async () => {
    const { generators, point, others } = await opened.state();
    const center = [0, 0, 0];
    const gauge = library.ask("answer", "gauge", { p: center, q: point, generators: [...generators, ...others] }).gauge;
    same(String(await opened.read("gauge")), String(gauge), "the gauge");
    const found =
      others.length > 0
        ? library.ask("answer", "intersect", { a: { center, generators }, b: { center: point, generators: others } })
        : library.ask("answer", "member", { point, center, generators });
    const words = { inside: /inside|overlap/, boundary: /boundary|touch/, outside: /outside|apart/ };
    holds(
      words[found.status].test(await opened.read("status")),
      `the page says ${await opened.read("status")}, the library ${found.status}`,
    );
    holds((await opened.read("verdict")).startsWith("right"), `the verifier says ${await opened.read("verdict")}`);
  };
  await opened.drag('#inside-space [data-handle="point"]', 12, -7);
  await agree();
  for (const name of [
    "A point in a cube",
    "A corner of a cube",
    "Two cubes that touch",
    "Two cubes a hair apart",
    "Two polar zonohedra",
    "A flat body",
    "A segment and a point",
  ]) {
    await opened.preset(name);
    await agree();
  }
  await opened.preset("A point in a cube");
  holds((await opened.read("proof")).startsWith("With the coefficients"), "a point inside has coefficients");
  await page.locator('#inside-space [data-handle="point"]').focus();
  for (let press = 0; press < 8; press += 1) await page.keyboard.press("Shift+ArrowRight");
  await opened.rest();
  await agree();
  holds((await opened.read("proof")).startsWith("Take the direction"), "a point outside has a direction");

  await page.locator('button[data-do="fool"]').click();
  await opened.rest();
  await agree();
  holds((await opened.read("belief")).includes("wrong"), `the rival is not fooled: ${await opened.read("belief")}`);
  await opened.preset("A point in a cube");
  holds((await opened.read("belief")).includes("right"), `the rival errs: ${await opened.read("belief")}`);

  await opened.preset("Ten thousand generators");
  holds(Number.isFinite(await opened.read("gauge")), "ten thousand generators have a gauge");

  same(await opened.exercise("gauge", "1.5"), true, "the exercise on the gauge");
  same(await opened.exercise("direction", 1), true, "the exercise on directions");
  same(await opened.exercise("direction", 2), false, "the exercise on directions, answered wrongly");
  same(await opened.exercise("rival", 1), true, "the exercise on the rival");
}
