// How long a drag computes, how soon the first picture comes, and how many frames a second two tumbling bodies have.

const CIRCLE = Array.from({ length: 200 }, (_, index) => {
  const angle = (2 * Math.PI * index) / 200;
  return [3 * Math.cos(angle), 2.5 * Math.sin(angle)];
});

export async function test(opened) {
  const { page } = opened;
  const first = [];
  for (let round = 0; round < 3; round += 1) {
    await page.goto("about:blank");
    await page.goto(`${opened.file}#smallest-zonogon`);
    await page.waitForSelector("article figure polygon");
    first.push(await page.evaluate(() => performance.now()));
  }
  const rows = [["first picture after opening", Math.min(...first), Math.max(...first)]];
  rows.push(
    await drag(
      opened,
      "smallest-zonogon",
      { points: CIRCLE, center: [0.4, 0.3], turn: 10, step: 0, levels: false },
      '[data-handle="O"]',
      "drag O among 200 points",
    ),
  );
  rows.push(
    await drag(
      opened,
      "smallest-zonogon",
      { points: CIRCLE, center: [0.4, 0.3], turn: 10, step: 0, levels: false },
      '[data-handle="20"]',
      "drag one of 200 points",
    ),
  );
  await opened.chapter("tiling");
  await opened.preset("Sixty at random");
  rows.push(await typed(opened, "Generator 1, x", "change one of 60 generators"));
  await opened.chapter("inside");
  await opened.preset("Ten thousand generators");
  rows.push(await pulled(opened, '#inside-space [data-handle="point"]', "drag a point, 10,000 generators"));
  await opened.chapter("motion");
  await opened.preset("Thirty generators each");
  rows.push(await frames(opened));
  console.log("      milliseconds                             median    99 %   and to draw: median    99 %");
  for (const [name, ...times] of rows)
    console.log(`      ${name.padEnd(40)} ${times.map((time) => time.toFixed(1).padStart(7)).join(" ")}`);
}

async function listen(page) {
  await page.evaluate(() => {
    window.drawn = [];
    document.addEventListener("drawn", (event) => window.drawn.push(event.detail));
  });
}

async function drag(opened, id, state, selector, name) {
  await opened.chapter(id, state);
  return pulled(opened, selector, name);
}

async function pulled(opened, selector, name) {
  const { page } = opened;
  await listen(page);
  const { x, y } = await opened.place(selector);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 120; step += 1) {
    await page.mouse.move(x + 25 * Math.sin(step / 9), y + 20 * Math.sin(step / 7));
    await page.waitForTimeout(8);
  }
  await page.mouse.up();
  return [name, ...(await quantiles(page))];
}

async function typed(opened, label, name) {
  const { page } = opened;
  await listen(page);
  const field = page.getByLabel(label, { exact: true });
  for (let round = 1; round <= 60; round += 1) {
    await field.fill(String(round / 10));
    await field.press("Enter");
    await page.waitForTimeout(20);
  }
  return [name, ...(await quantiles(page))];
}

async function quantiles(page) {
  const drawn = await page.evaluate(() => window.drawn);
  return ["questions", "drawing"].flatMap((part) => {
    const times = drawn.map((one) => one[part]).sort((one, other) => one - other);
    return [times[Math.floor(times.length / 2)] ?? NaN, times[Math.floor(times.length * 0.99)] ?? NaN];
  });
}

async function frames({ page }) {
  await listen(page);
  await page.locator('[data-tool="play"]').click();
  await page.waitForTimeout(3000);
  const count = await page.evaluate(() => window.drawn.length);
  const times = await quantiles(page);
  await page.locator('[data-tool="play"]').click();
  return [`two bodies of 30 tumble: ${(count / 3).toFixed(0)} frames a second`, ...times];
}
