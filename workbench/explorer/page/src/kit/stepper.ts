/** A stepper: the steps of a search one after the other, by buttons, a slider or the arrow keys. */

import { button, html } from "./elements";

export class Stepper {
  readonly element: HTMLElement;
  private readonly slider = html("input", { type: "range", min: 0, value: 0, "aria-label": "Step" });
  private readonly told = html("span", { class: "told" });
  private readonly back: HTMLButtonElement;
  private readonly on: HTMLButtonElement;
  private steps = 1;
  private now = 0;

  constructor(
    label: string,
    private readonly chosen: (step: number) => void,
  ) {
    this.back = button("◀", () => this.go(this.now - 1), { "aria-label": "One step back" });
    this.on = button("▶", () => this.go(this.now + 1), { "aria-label": "One step on" });
    this.slider.addEventListener("input", () => this.go(Number(this.slider.value)));
    this.element = html(
      "div",
      { class: "stepper", role: "group", "aria-label": label },
      this.back,
      this.slider,
      this.on,
      this.told,
    );
  }

  /** Shows that the step `now` of so many is seen, with a sentence about it. */
  draw(now: number, steps: number, sentence: string): void {
    [this.now, this.steps] = [now, steps];
    this.slider.max = String(steps - 1);
    this.slider.value = String(now);
    this.slider.setAttribute("aria-valuetext", sentence);
    this.back.disabled = now <= 0;
    this.on.disabled = now >= steps - 1;
    this.told.textContent = sentence;
  }

  private go(step: number): void {
    this.chosen(Math.min(Math.max(step, 0), this.steps - 1));
  }
}
