/** The slide mode: one figure fills the screen, the arrow keys lead from one prepared state to the next. */

import type { AnyChapter, Control } from "./chapter";
import { button, html } from "./elements";

export function startSlides(
  chapter: AnyChapter,
  control: Control<unknown>,
  figures: ReadonlyMap<string, HTMLElement>,
): void {
  const before = control.state;
  const title = html("h2");
  const words = html("p");
  const count = html("span", { class: "count" });
  const bar = html("section", { class: "slide-bar", "aria-label": "Slides", "aria-live": "polite" });
  let now = 0;

  const show = (next: number) => {
    now = Math.min(Math.max(next, 0), chapter.slides.length - 1);
    const slide = chapter.slides[now];
    if (!slide) return;
    for (const [name, figure] of figures) figure.classList.toggle("on-stage", name === slide.figure);
    title.textContent = slide.title;
    words.textContent = slide.words;
    count.textContent = `${now + 1} of ${chapter.slides.length}`;
    control.commit(slide.make());
  };
  const end = () => {
    document.removeEventListener("keydown", key, true);
    document.body.classList.remove("slides");
    for (const figure of figures.values()) figure.classList.remove("on-stage");
    bar.remove();
    control.commit(before);
    if (document.fullscreenElement) void document.exitFullscreen();
  };
  const key = (event: KeyboardEvent) => {
    if (event.key === "Escape") return end();
    // A handle, a slider and a text have uses of their own for the arrows.
    if ((event.target as Element).closest("[data-handle], input, [role=slider], .space, svg[tabindex]")) return;
    if (event.key === "ArrowRight" || event.key === "PageDown") show(now + 1);
    else if (event.key === "ArrowLeft" || event.key === "PageUp") show(now - 1);
    else return;
    event.preventDefault();
  };
  const next = button("▶", () => show(now + 1), { "aria-label": "Next slide" });
  bar.append(
    html("div", { class: "slide-words" }, title, words),
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
  document.body.classList.add("slides");
  document.body.append(bar);
  void document.documentElement.requestFullscreen?.().catch(() => undefined);
  next.focus();
  show(0);
}
