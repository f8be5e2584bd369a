// The chapter in a browser: the bar shows the intervals of the certificate, and the clock runs.
import { holds, same } from "../../../tests/kit.mjs";

export const id = "motion";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const agree = async () => {
    const { scene } = await opened.state();
    const found = library.ask("answer", "collide", { a: scene.a, b: scene.b, motion: scene.moves });
    const spans = found.certificate.intervals.length + (found.status === "separate" ? 0 : 1);
    same(await page.locator("#motion-motion .span").count(), spans, "parts of the bar");
    holds((await opened.read("verdict")).startsWith("right"), `the verifier says ${await opened.read("verdict")}`);
  };
  for (const name of [
    "A bar and a stone",
    "A thin plate through a gap in time",
    "Two cubes face to face",
    "Rhombic dodecahedra that tumble",
    "At rest",
  ]) {
    await opened.preset(name);
    await agree();
  }
  await opened.preset("A thin plate through a gap in time");
  same(await opened.read("hits"), 0, "samples that meet");
  holds((await opened.read("status")).startsWith("The bodies meet first"), "the certificate finds the contact");
  same(await opened.exercise("miss"), true, "the exercise on sampling");
  same(await opened.exercise("shift", "5"), true, "the exercise on a shift");
  same(await opened.exercise("contact", "0.75"), true, "the exercise on the time of contact");
  same(await opened.exercise("contact", "0.5"), false, "the exercise on the time of contact, answered wrongly");

  await opened.preset("Two cubes face to face");
  const radius = await page.locator("#motion-arcs .names text").textContent();
  same(radius, "radius 0: no turn, no arcs", "the circle around the arcs of a pure shift");

  await opened.preset("A bar and a stone");
  await page.locator('[data-scrub="angleA"]').focus();
  await page.keyboard.press("ArrowLeft");
  await opened.rest();
  same((await opened.state()).scene.moves.a.angle, 2.15, "the angle after a key");
  await agree();
  await page.locator('[data-tool="play"]').click();
  const clock = page.locator("#motion-motion input[type=range]");
  await page.waitForFunction((bar) => Number(bar.value) > 0.1, await clock.elementHandle(), { timeout: 10_000 });
  await page.locator('[data-tool="play"]').click();
  await opened.drawn();
  const time = await clock.inputValue();
  await opened.drawn();
  same(await clock.inputValue(), time, "the time while the clock stands");
}
