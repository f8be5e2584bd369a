// What the tests share: a browser, the page opened from a file, and the library in Node.
import { existsSync, readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const NAMES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** The path of a browser, or null. */
export function browserPath() {
  return [process.env.CHROMIUM, ...NAMES].find((path) => path && existsSync(path)) ?? null;
}

export function launch() {
  return chromium.launch({
    executablePath: browserPath(),
    // Machines of tests have no graphics card. Pictures of space are drawn in software; that the page is put together
    // in software directly, and not by a card that is software, leaves more time for them.
    args: [
      "--no-sandbox",
      "--disable-dev-shm-usage",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--disable-gpu-compositing",
    ],
  });
}

/** The text that a button copies. Pages of one browser share its clipboard, so the text is taken before it is there. */
export async function copiedBy(page, name) {
  await page.evaluate(() => {
    window.copied = new Promise((take) => {
      navigator.clipboard.writeText = async (text) => take(text);
    });
  });
  await page.getByRole("button", { name }).click();
  return page.evaluate(() => window.copied);
}

/** The library in Node: the same module, without the page. */
export class Library {
  static async open(path) {
    const { instance } = await WebAssembly.instantiate(readFileSync(path), {});
    return new Library(instance.exports);
  }

  constructor(entries) {
    this.entries = entries;
  }

  call(entry, text) {
    return new TextDecoder().decode(this.bytes(entry, text));
  }

  /** The bytes that an entry leaves for a text, or for numbers. */
  bytes(entry, ...taken) {
    const { memory, input, output } = this.entries;
    if (typeof taken[0] === "string") {
      const bytes = new TextEncoder().encode(taken[0]);
      const start = input(bytes.length);
      new Uint8Array(memory.buffer, start, bytes.length).set(bytes);
    }
    const length = this.entries[entry](...taken.filter((one) => typeof one === "number"));
    return new Uint8Array(memory.buffer, output(), length).slice();
  }

  ask(entry, kind, input, method) {
    const answer = JSON.parse(
      this.call(entry, JSON.stringify({ id: "test", kind, input, ...(method ? { method } : {}) })),
    );
    if (answer.error) throw new Error(`${kind}: ${answer.error.message}`);
    return answer.result;
  }
}

/** The page, with everything that it must not do written down: complaints on the console, errors, requests. */
export class Opened {
  constructor(page, file) {
    this.page = page;
    this.file = pathToFileURL(file).href;
    this.complaints = [];
    page.on("console", (message) => {
      if (message.type() === "error") this.complaints.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => this.complaints.push(`error: ${error.message}`));
    page.on("request", (request) => {
      const url = request.url();
      if (!/^(blob|data):/.test(url) && url.split("#")[0] !== this.file) this.complaints.push(`request: ${url}`);
    });
  }

  /** Opens a chapter anew, in a state if one is given. */
  async chapter(id, state) {
    await this.page.goto("about:blank");
    const told = state === undefined ? "" : `?${encodeURIComponent(JSON.stringify(state))}`;
    await this.page.goto(`${this.file}#${id}${told}`);
    await this.page.waitForSelector(`article#${id} figure`, { timeout: 30_000 });
    await this.rest();
  }

  /** Goes to a chapter by the list of chapters; the first one is opened. */
  async turn(id) {
    if (!this.page.url().startsWith(this.file)) return this.chapter(id);
    await this.page.locator(`nav a[data-chapter="${id}"]`).click();
    await this.page.waitForSelector(`article#${id} figure`);
    await this.rest();
  }

  /** Waits until the present state is drawn, whether or not the worker has answered. */
  async drawn() {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /**
   * Waits until nothing is drawn any more and the worker has answered. The page gets clicks and keys before its next
   * frame, however long that takes; after two frames it is busy with what they asked for, or has done it.
   */
  async rest() {
    await this.drawn();
    await this.page.waitForSelector("article:not([aria-busy])", { timeout: 60_000 });
  }

  /** The state that the address tells. */
  async state() {
    const hash = await this.page.evaluate(() => location.hash);
    return JSON.parse(decodeURIComponent(hash.split("?")[1] ?? "null"));
  }

  /** A number of the text, as the page holds it. */
  async read(name) {
    const value = await this.page.locator(`[data-read="${name}"]`).first().getAttribute("data-value");
    return Number.isNaN(Number(value)) ? value : Number(value);
  }

  async place(selector) {
    await this.page.locator(selector).first().scrollIntoViewIfNeeded();
    const box = await this.page.locator(`${selector} .mark`).first().boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** Drags a handle by some pixels. */
  async drag(selector, dx, dy, steps = 8) {
    const { x, y } = await this.place(selector);
    await this.page.mouse.move(x, y);
    await this.page.mouse.down();
    await this.page.mouse.move(x + dx, y + dy, { steps });
    await this.drawn();
    // The view may be drawn anew around its content when the handle is let go, so the place is looked at before.
    const box = await this.page.locator(`${selector} .mark`).first().boundingBox();
    await this.page.mouse.up();
    await this.rest();
    const off = Math.hypot(box.x + box.width / 2 - x - dx, box.y + box.height / 2 - y - dy);
    holds(off < 2, `the handle ${selector} is ${off} pixels off the pointer`);
  }

  async preset(name) {
    await this.page.getByRole("combobox", { name: "Preset" }).selectOption({ label: name });
    await this.rest();
  }

  async exercise(id, reply) {
    const item = this.page.locator(`[data-exercise="${id}"]`);
    if (typeof reply === "string") await item.locator("input[type=text]").fill(reply);
    if (typeof reply === "number") await item.locator("input[type=radio]").nth(reply).check();
    await item.locator("button.check").click();
    return (await item.locator(".verdict").getAttribute("class")).includes("right");
  }
}

export function same(found, expected, about) {
  if (!Object.is(found, expected)) throw new Error(`${about}: ${found} where ${expected} is expected`);
}

/** A text that is the same for the same data, whatever the order of their fields. */
export function text(data) {
  return JSON.stringify(data, (_, value) =>
    value && typeof value === "object" && !Array.isArray(value)
      ? Object.fromEntries(Object.entries(value).sort())
      : value,
  );
}

export function holds(condition, about) {
  if (!condition) throw new Error(about);
}
