/** A bar of the step of time from 0 to 1, with intervals in it and a mark for now; dragging it moves the time. */

import { html } from "./elements";
import { short } from "./layer";
import { digits } from "./vectors";

export interface Span {
  readonly from: number;
  readonly to: number;
  readonly look: string;
  readonly title: string;
}

export class TimeBar {
  readonly element: HTMLElement;
  private readonly spans = html("div", { class: "spans", "aria-hidden": "true" });
  private shown: readonly Span[] = [];
  private readonly slider = html("input", { type: "range", min: 0, max: 1, step: 0.001, "aria-label": "Time" });

  constructor(moved: (time: number, finished: boolean) => void) {
    this.slider.addEventListener("input", () => moved(Number(this.slider.value), false));
    this.slider.addEventListener("change", () => moved(Number(this.slider.value), true));
    this.element = html("div", { class: "time" }, this.spans, this.slider);
  }

  draw(time: number, spans: readonly Span[]): void {
    this.slider.value = String(time);
    this.slider.setAttribute("aria-valuetext", `time ${digits(time)}`);
    if (this.shown === spans) return;
    this.shown = spans;
    this.spans.replaceChildren(
      ...spans.map((span) =>
        html("span", {
          class: `span ${span.look}`,
          title: span.title,
          style: `left:${short(span.from * 100)}%;width:${short((span.to - span.from) * 100)}%`,
        }),
      ),
    );
  }
}
