// The chapter in a browser: numbers are the library's, handles move what they should.
import { holds, same } from "../../../tests/kit.mjs";

export const id = "smallest-zonogon";

const FIRST = [
  [5.5, 2.5],
  [4, 3.1],
  [1.6, 3.3],
  [0.3, 2.8],
  [0.7, 1.5],
  [1.8, 0.1],
  [3, 0.2],
  [4.9, 1.3],
  [2.4, 1.7],
];

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const numbersAgree = async (points, center) => {
    same(await opened.read("least"), library.ask("answer", "min_area", { points }).area, "the least area");
    same(
      await opened.read("area"),
      library.ask("picture", "centered_zonogon", { points, center }).area,
      "the area of Z(O)",
    );
  };
  await numbersAgree(FIRST, [3.6, 2.3]);
  holds((await opened.read("verdict")).startsWith("right"), "the verifier agrees");

  // A drag moves the point by what the pointer moved, and keeps all others.
  await opened.drag('[data-handle="0"]', -30, 25);
  const dragged = (await opened.state()).points;
  holds(dragged[0][0] < FIRST[0][0] && dragged[0][1] < FIRST[0][1], "the point was dragged to the left and down");
  same(JSON.stringify(dragged.slice(1)), JSON.stringify(FIRST.slice(1)), "the other points stay");
  await numbersAgree(dragged, [3.6, 2.3]);

  // The same by keys, and back by undo.
  await page.locator('[data-handle="O"]').first().focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await opened.rest();
  const keyed = (await opened.state()).center;
  holds(keyed[0] < 3.6 && keyed[1] === 2.3, "the arrow key moved O to the left");
  await page.locator('[data-tool="undo"]').click();
  await page.locator('[data-tool="undo"]').click();
  await opened.rest();
  same(JSON.stringify((await opened.state()).points), JSON.stringify(FIRST), "undo brings the points back");

  // Delete removes a point, a double click adds one.
  await page.locator('[data-handle="8"]').first().focus();
  await page.keyboard.press("Delete");
  await opened.rest();
  same((await opened.state()).points.length, 8, "points after Delete");
  await page.locator("#smallest-zonogon-zonogon svg").scrollIntoViewIfNeeded();
  const view = await page.locator("#smallest-zonogon-zonogon svg").boundingBox();
  await page.mouse.dblclick(view.x + view.width * 0.9, view.y + view.height * 0.8);
  await opened.rest();
  same((await opened.state()).points.length, 9, "points after a double click");

  // The best centre is best.
  await page.locator('button[data-do="best"]').click();
  await opened.rest();
  const [area, least] = [await opened.read("area"), await opened.read("least")];
  holds(area <= least * (1 + 1e-12), `the area at the best centre is ${area}, the least one ${least}`);

  // The search ends, step by step.
  await opened.preset("Nine points");
  const steps = page.locator("#smallest-zonogon-search .stepper");
  const on = steps.getByRole("button", { name: "One step on" });
  let count = 0;
  while (!(await on.isDisabled()) && count < 60) {
    await on.click();
    await opened.drawn();
    count += 1;
  }
  holds(/neither side|candidates left: 0/.test(await steps.innerText()), `the search ends: ${await steps.innerText()}`);

  same(await opened.exercise("triangle", "12"), true, "the exercise on the triangle, answered rightly");
  same(await opened.exercise("triangle", "11"), false, "the exercise on the triangle, answered wrongly");
  same(await opened.exercise("plateau", 2), true, "the exercise on the plateau");
  same(await opened.exercise("plateau", 0), false, "the exercise on the plateau, answered wrongly");
  same(await opened.exercise("bends", 0), true, "the exercise on bends");
  await opened.preset("Square");
  await page.locator('button[data-do="best"]').click();
  await opened.rest();
  same(await opened.exercise("by-hand"), true, "the exercise on the centre, at the best centre");

  // Bound and area have digits enough to be compared.
  await opened.preset("Nine points");
  same(await opened.read("bound"), 14.185, "the bound with its digits");
  same(await opened.read("reached"), 14.185, "the area with its digits");

  // Keys and pointers move by whole pixels: the hexagon is closed as far as they can.
  await page.locator('[data-exercise="symmetric"]').getByRole("button", { name: "Set it up" }).click();
  await opened.rest();
  same(await opened.exercise("symmetric"), false, "the hexagon that is pulled out has area to spare");
  await page.locator('#smallest-zonogon-zonogon [data-handle="0"]').focus();
  let right = false;
  for (let press = 0; press < 120 && !right; press += 1) {
    await page.keyboard.press("ArrowLeft");
    await opened.rest();
    right = await opened.exercise("symmetric");
    await page.locator('#smallest-zonogon-zonogon [data-handle="0"]').focus();
  }
  holds(right, "the arrow key brings the corner where nothing is to be gained");

  // One point is told as one.
  await opened.chapter(id, { ...(await opened.state()), points: [[1, 2]] });
  const words = await page.locator(`article#${id}`).innerText();
  holds(!/\b1 (points|corners)\b|0\.0e0/.test(words), "one point is not told as several");
}
