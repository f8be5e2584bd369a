/** The generators as a table whose numbers can be typed. */

import type { Control, Figure } from "../../kit/chapter";
import { button, html } from "../../kit/elements";
import { NUMBER_HINT, readNumber } from "../../kit/number_reply";
import { tidy } from "../../kit/vectors";
import { zoneColour } from "../../kit/zone_colours";
import type { Vec3 } from "../../library/shapes";
import { MOST_GENERATORS, type Answers, type State } from "./state";

/** Generators up to which the table has a row for each. */
const ROW_LIMIT = 24;

/** What the arrow keys add to a number and take from it. */
const KEY_STEP = 0.1;

const AXES = ["x", "y", "z"] as const;

export function generatorsFigure(control: Control<State>): Figure<State, Answers> {
  const body = html("tbody");
  const problem = html("p", { class: "note", role: "status", hidden: true });
  const more = html("p", { class: "note" });
  const add = button("Add a generator", () => {
    const { state } = control;
    if (state.generators.length >= MOST_GENERATORS) return;
    const count = state.generators.length;
    const next: Vec3 = [Number(Math.cos(2.4 * count).toFixed(2)), Number(Math.sin(2.4 * count).toFixed(2)), 0.7];
    control.commit({ ...state, generators: [...state.generators, next] });
  });
  const head = html(
    "tr",
    {},
    ...["vᵢ", ...AXES, ""].map((name) => (name ? html("th", { scope: "col" }, name) : html("td"))),
  );
  const table = html("table", { class: "generators" }, html("thead", {}, head), body);
  let rows: HTMLInputElement[][] = [];

  const begin = (count: number) => {
    rows = Array.from({ length: count }, (_, index) =>
      AXES.map((axis, place) => {
        const label = `Generator ${index + 1}, ${axis}`;
        const field = html("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": label });
        const now = () => control.state.generators[index]?.[place] ?? 0;
        const commit = (value: number) => {
          const { state } = control;
          const put = (one: Vec3) => one.map((old, at) => (at === place ? value : old)) as unknown as Vec3;
          control.commit({ ...state, generators: state.generators.map((one, at) => (at === index ? put(one) : one)) });
        };
        field.addEventListener("change", () => {
          const value = readNumber(field.value);
          // The field shows the number that the body has: what was typed is written anew, or taken back.
          field.value = String(value ?? now());
          problem.textContent = value === null ? NUMBER_HINT : "";
          problem.hidden = value !== null;
          if (value !== null) commit(value);
        });
        field.addEventListener("keydown", (event) => {
          const steps = Number(event.key === "ArrowUp") - Number(event.key === "ArrowDown");
          if (steps === 0) return;
          const value = tidy((readNumber(field.value) ?? now()) + steps * KEY_STEP);
          field.value = String(value);
          commit(value);
          event.preventDefault();
        });
        return field;
      }),
    );
    body.replaceChildren(
      ...rows.map((fields, index) => {
        const remove = button(
          "×",
          () => {
            const { state } = control;
            control.commit({ ...state, lit: null, generators: state.generators.filter((_, at) => at !== index) });
          },
          { "aria-label": `Delete generator ${index + 1}` },
        );
        const swatch = html("span", { class: "swatch", style: `background:${zoneColour(index)}` });
        const cells = fields.map((field) => html("td", {}, field));
        return html("tr", {}, html("th", { scope: "row" }, swatch, ` ${index + 1}`), ...cells, html("td", {}, remove));
      }),
    );
  };
  return {
    element: html("div", {}, html("div", { class: "wide" }, table), problem, more, add),
    draw(state) {
      const count = Math.min(state.generators.length, ROW_LIMIT);
      if (rows.length !== count) begin(count);
      rows.forEach((fields, index) =>
        fields.forEach((field, place) => {
          const value = String(state.generators[index]?.[place] ?? 0);
          if (document.activeElement !== field && field.value !== value) field.value = value;
        }),
      );
      const rest = state.generators.length - count;
      more.hidden = rest === 0;
      more.textContent = rest > 0 ? `and ${rest} more generators` : "";
    },
  };
}
