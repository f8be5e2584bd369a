// A finger on a phone: handles are dragged, and the page still scrolls beside them.
import { holds } from "./kit.mjs";

export const options = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

export async function test(opened, _library, { ids }) {
  const { page } = opened;
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  for (const id of ids) {
    await opened.turn(id);
    const handle = page.locator("[data-handle]").first();
    if ((await handle.count()) === 0) continue;
    const selector = `[data-handle="${await handle.getAttribute("data-handle")}"]`;
    const { x, y } = await opened.place(selector);
    await touch("touchStart", [{ x, y }]);
    for (let step = 1; step <= 6; step += 1) await touch("touchMove", [{ x: x + 5 * step, y: y + 3 * step }]);
    await opened.drawn();
    const box = await page.locator(`${selector} .mark`).first().boundingBox();
    const after = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    await touch("touchEnd", []);
    await opened.rest();
    holds(
      Math.hypot(after.x - x - 30, after.y - y - 18) < 3,
      `${id}: the finger left the handle at ${after.x}, ${after.y}, from ${x}, ${y}`,
    );
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    holds(width <= 390, `${id}: the page is ${width} pixels wide on a phone`);
  }
}
