/**
 * The slide mode: one figure, or two side by side, fill the screen; the arrow keys and the keys of a presenter lead
 * from one prepared state to the next.
 */

import type { AnyChapter, Control } from "./chapter";
import { button, html } from "./elements";

/** Classes of two figures that share the screen. */
const HALVES = ["first-half", "second-half"] as const;

/** What has uses of its own for the arrows: a handle, a slider, a text, and pictures that have the focus. */
const ARROWS_OF_THEIR_OWN = "[data-handle], input, [role=slider], .space, svg[tabindex]";

/** `shown` is the value of a read-out, as it is printed. */
export function startSlides(
  chapter: AnyChapter,
  control: Control<unknown>,
  figures: ReadonlyMap<string, HTMLElement>,
  shown: (read: string) => string,
): void {
  const before = control.state;
  const title = html("h2");
  const words = html("p");
  const value = html("p", { class: "slide-read" });
  const count = html("span", { class: "count" });
  const bar = html("section", { class: "slide-bar", "aria-label": "Slides", "aria-live": "polite" });
  let now = 0;

  const show = (next: number) => {
    now = Math.min(Math.max(next, 0), chapter.slides.length - 1);
    const slide = chapter.slides[now];
    if (!slide) return;
    const staged = typeof slide.figure === "string" ? [slide.figure] : slide.figure;
    for (const [name, figure] of figures) {
      figure.classList.toggle("on-stage", staged.includes(name));
      HALVES.forEach((half, place) => figure.classList.toggle(half, staged.length > 1 && staged[place] === name));
    }
    title.textContent = slide.title;
    words.textContent = slide.words;
    // The value belongs to the slide before until the new state is drawn.
    value.textContent = "";
    count.textContent = `${now + 1} of ${chapter.slides.length}`;
    control.commit(slide.make());
  };
  const drawn = () => {
    const read = chapter.slides[now]?.read;
    const text = read === undefined ? "" : shown(read);
    if (value.textContent !== text) value.textContent = text;
  };
  const end = () => {
    document.removeEventListener("keydown", key, true);
    document.removeEventListener("pointerup", released);
    document.removeEventListener("drawn", drawn);
    document.body.classList.remove("slides");
    for (const figure of figures.values()) figure.classList.remove("on-stage", ...HALVES);
    bar.remove();
    control.commit(before);
    if (document.fullscreenElement) void document.exitFullscreen();
  };
  const key = (event: KeyboardEvent) => {
    if (event.key === "Escape") return end();
    const arrow = event.key === "ArrowRight" || event.key === "ArrowLeft";
    if (arrow && (event.target as Element).closest(ARROWS_OF_THEIR_OWN)) return;
    if (event.key === "ArrowRight" || event.key === "PageDown") show(now + 1);
    else if (event.key === "ArrowLeft" || event.key === "PageUp") show(now - 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const next = button("▶", () => show(now + 1), { "aria-label": "Next slide" });
  // A body that was turned by the pointer does not keep the arrows; who wants to turn it by keys goes there with Tab.
  const released = (event: PointerEvent) => {
    if ((event.target as Element).closest?.(".space")) next.focus();
  };
  bar.append(
    html("div", { class: "slide-words" }, title, words, value),
    html(
      "div",
      { class: "tools" },
      button("◀", () => show(now - 1), { "aria-label": "Slide before" }),
      count,
      next,
      button("End", end),
    ),
  );
  document.addEventListener("keydown", key, true);
  document.addEventListener("pointerup", released);
  document.addEventListener("drawn", drawn);
  document.body.classList.add("slides");
  document.body.append(bar);
  void document.documentElement.requestFullscreen?.().catch(() => undefined);
  next.focus();
  show(0);
}
