// The page at several widths, dark and light: nothing is wider than the window, and nothing lies over something else.
import { mkdirSync } from "node:fs";
import { holds } from "./kit.mjs";

const WIDTHS = [320, 360, 1280, 2560];

export async function test(opened, _library, { ids, shots }) {
  const { page } = opened;
  if (shots) mkdirSync(shots, { recursive: true });
  for (const id of ids) {
    await opened.turn(id);
    for (const scheme of ["light", "dark"]) {
      for (const width of WIDTHS) {
        await page.emulateMedia({ colorScheme: scheme });
        await page.setViewportSize({ width, height: width < 500 ? 740 : width > 2000 ? 1440 : 900 });
        // The size is seen in one frame, and what follows from it is drawn in the next ones.
        for (let round = 0; round < 2; round += 1) await opened.drawn();
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        holds(wide <= width, `${id}: the page is ${wide} pixels wide in a window of ${width}`);
        const head = await page.evaluate(() => document.querySelector("header").clientHeight);
        holds(width < 360 || head <= (width < 500 ? 230 : 110), `${id} at ${width}: the head is ${head} pixels high`);
        const tables = await page
          .locator(".wide")
          .evaluateAll((all) => all.map((one) => one.scrollWidth - one.clientWidth));
        holds(width < 360 || Math.max(0, ...tables) <= 0, `${id} at ${width}: a table is ${tables} pixels too wide`);
        const over = await page.evaluate(overlaps);
        holds(over.length === 0, `${id} at ${width}: ${over.join("; ")}`);
        if (shots && width !== 320)
          await page.screenshot({ path: `${shots}/${id}-${width}-${scheme}.png`, fullPage: true });
      }
    }
  }
}

/** Neighbours in the flow of the page that lie over each other, and texts of buttons that are cut off. */
function overlaps() {
  const found = [];
  for (const parent of document.querySelectorAll("article, header, nav, .tools, .figures, .reply, .stepper")) {
    const children = [...parent.children].filter(
      (one) => one.getClientRects().length > 0 && getComputedStyle(one).position !== "absolute",
    );
    for (const [index, one] of children.entries()) {
      for (const other of children.slice(index + 1)) {
        const [a, b] = [one.getBoundingClientRect(), other.getBoundingClientRect()];
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > 1 && down > 1)
          found.push(`${one.tagName}.${one.className} lies over ${other.tagName}.${other.className}`);
      }
    }
  }
  for (const button of document.querySelectorAll("button")) {
    if (button.scrollWidth > button.clientWidth + 1) found.push(`the button ${button.textContent} is cut off`);
  }
  return found;
}
