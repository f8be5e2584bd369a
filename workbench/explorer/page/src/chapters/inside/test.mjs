// The chapter in a browser: answers and gauges are the library's, and the proof changes its kind at the boundary.
import { copiedBy, holds, same } from "../../../tests/kit.mjs";

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

  // Numbers that are compared differ as they stand in the sentence; with two bodies none of them speaks of a point.
  await opened.preset("Two cubes a hair apart");
  const apart = await opened.read("proof");
  holds(/lies 2\.0+2 beyond that of the first, but the two bodies together reach only 2 far/.test(apart), apart);
  const gaugeRead = page.locator('[data-read="gauge"]');
  holds((await gaugeRead.innerText()) !== "1", "the gauge is told to be more than 1");
  holds(!(await opened.read("gaugeWords")).includes("point"), "the gauge of two bodies is not that of a point");
  await opened.preset("Two cubes that touch");
  holds(!(await opened.read("proof")).includes("centre plus"), "the way is a sum and not a place");

  // The point goes along with the body.
  await opened.preset("A point in a cube");
  const copied = JSON.parse(await copiedBy(page, "Copy as JSON"));
  same(JSON.stringify(copied.point), "[0.4,-0.7,0.2]", "the point of the JSON");
  same(copied.generators.length, 3, "the generators of the JSON");

  await opened.preset("Ten thousand generators");
  holds(!(await opened.read("proof")).includes("figure"), "no path is told that is not drawn");
  holds(
    (await page.locator("#inside-space").innerText()).includes("too many facets to be drawn"),
    "the empty figure says why it is empty",
  );
  holds(Number.isFinite(await opened.read("gauge")), "ten thousand generators have a gauge");

  same(await opened.exercise("gauge", "1.5"), true, "the exercise on the gauge");
  same(await opened.exercise("direction", 1), true, "the exercise on directions");
  same(await opened.exercise("direction", 2), false, "the exercise on directions, answered wrongly");
  same(await opened.exercise("rival", 1), true, "the exercise on the rival");
  holds(
    (await page.locator('[data-exercise="rival"] .verdict').innerText()).includes("Rival: “inside”"),
    "the rival's answer in the words of the choices",
  );

  // Slides tell how far two bodies are apart, and how deep they overlap.
  await page.getByRole("button", { name: "Slides" }).click();
  const told = [];
  for (let slide = 0; slide < 4; slide += 1) {
    await opened.rest();
    told.push(await page.locator(".slide-read").innerText());
    await page.getByRole("button", { name: "Next slide" }).click();
  }
  for (const [slide, words] of [/outside/, /inside/, /are .* apart, between an? /, /They overlap/].entries())
    holds(words.test(told[slide]), `slide ${slide + 1} says ${told[slide]}`);
  await page.keyboard.press("Escape");
  await opened.rest();
}
