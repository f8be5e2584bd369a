/**
 * A number in a sentence that the reader changes: pulled to the left and right, by arrow keys, or typed in after
 * Enter or a double click.
 */

import type { Control, Scrub } from "./chapter";
import { html } from "./elements";
import { digits } from "./vectors";

/** Pixels of a pull that change the number by one step. */
const PIXELS_A_STEP = 6;

export function scrubber<State>(scrub: Scrub<State>, control: Control<State>) {
  const element = html("span", {
    class: "scrub",
    role: "slider",
    tabindex: 0,
    "aria-label": scrub.label,
    "aria-valuemin": scrub.least,
    "aria-valuemax": scrub.most,
  });
  const fit = (value: number) => {
    const stepped = Math.round(value / scrub.step) * scrub.step;
    return Math.min(scrub.most, Math.max(scrub.least, Number(stepped.toPrecision(12))));
  };
  const put = (value: number, finished: boolean) => {
    const state = scrub.set(control.state, fit(value));
    if (finished) control.commit(state);
    else control.change(state);
  };
  let pull: { x: number; value: number } | null = null;
  element.addEventListener("pointerdown", (event) => {
    pull = { x: event.clientX, value: scrub.get(control.state) };
    element.setPointerCapture(event.pointerId);
    element.focus();
    event.preventDefault();
  });
  element.addEventListener("pointermove", (event) => {
    if (pull) put(pull.value + Math.round((event.clientX - pull.x) / PIXELS_A_STEP) * scrub.step, false);
  });
  const release = () => {
    if (pull) put(scrub.get(control.state), true);
    pull = null;
  };
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
  const type = () => {
    const field = html("input", {
      type: "number",
      min: scrub.least,
      max: scrub.most,
      step: scrub.step,
      "aria-label": scrub.label,
      class: "typed",
    });
    field.value = String(scrub.get(control.state));
    element.replaceWith(field);
    field.select();
    const end = (keep: boolean) => {
      if (!field.isConnected) return;
      const value = field.valueAsNumber;
      field.replaceWith(element);
      element.focus();
      if (keep && Number.isFinite(value)) put(value, true);
    };
    field.addEventListener("blur", () => end(true));
    field.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === "Escape") end(event.key === "Enter");
      event.stopPropagation();
    });
  };
  element.addEventListener("dblclick", type);
  element.addEventListener("keydown", (event) => {
    if (event.key === "Enter") {
      event.preventDefault();
      return type();
    }
    const value = scrub.get(control.state);
    const steps: Record<string, number> = {
      ArrowRight: value + scrub.step,
      ArrowUp: value + scrub.step,
      ArrowLeft: value - scrub.step,
      ArrowDown: value - scrub.step,
      PageUp: value + 10 * scrub.step,
      PageDown: value - 10 * scrub.step,
      Home: scrub.least,
      End: scrub.most,
    };
    const next = steps[event.key];
    if (next === undefined) return;
    put(next, true);
    event.preventDefault();
    event.stopPropagation();
  });
  const draw = (state: State) => {
    const value = scrub.get(state);
    element.textContent = digits(value);
    element.setAttribute("aria-valuenow", String(value));
  };
  return { element, draw };
}
