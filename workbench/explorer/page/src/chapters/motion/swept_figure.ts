/** The zonotope around all placements of the first body, with copies of the body inside. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { digits } from "../../kit/vectors";
import { drawPlaced } from "./motion_figure";
import { METHODS, type Answers, type State } from "./state";

/** Copies of the body that are drawn along its way. */
const COPIES = 7;

const NAMES: Readonly<Record<string, string>> = {
  by_farthest_vertex: "a square around the arcs (Theorem 6.1)",
  by_middle_placement: "the same, from the placement in the middle",
  by_least_rectangle: "the least rectangle around the arcs",
  by_shadow: "the body's own shadow, turned by a quarter",
  by_turned_generators: "each generator turned by itself",
};

export function sweptFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("The zonotope around all placements of the first body", {}, [1.2, -2.2, 3.2]);
  const outer = new Solid();
  view.put("outer", outer);
  let drawn: Pick<Answers, "a" | "around" | "late"> | null = null;
  const copies = Array.from({ length: COPIES }, (_, index) => {
    const copy = new Solid();
    view.put(`copy ${index}`, copy);
    return copy;
  });
  const choice = html(
    "select",
    { "aria-label": "Method" },
    ...METHODS.map((method) => html("option", { value: method }, NAMES[method] ?? method)),
  );
  choice.addEventListener("change", () => control.commit({ ...control.state, method: choice.value }));
  const body = html("tbody");
  const head = html("tr", {}, ...["Method", "Generators", "Volume"].map((name) => html("th", { scope: "col" }, name)));
  return {
    element: html(
      "div",
      {},
      view.element,
      html("p", {}, choice),
      html("div", { class: "wide" }, html("table", {}, html("thead", {}, head), body)),
    ),
    svg: () => view.svg(),
    draw(state, { a, around, late }) {
      // While the motion plays only the time changes, which this figure does not show.
      if (drawn?.around === around && drawn.a === a && drawn.late === late) return;
      drawn = { a, around, late };
      choice.value = state.method;
      outer.draw(solidOf(around), { facets: around.facets.map(() => "#cc79a7"), opacity: 0.25, edge: "#a8457f" });
      copies.forEach((copy, index) => drawPlaced(copy, a, state.scene.moves.a, index / (COPIES - 1), "#0072b2", 0.8));
      view.fit(around.vertices);
      view.draw([]);
      body.replaceChildren(
        ...(late?.volumes ?? []).map(({ method, volume, generators }) =>
          html(
            "tr",
            method === state.method ? { "aria-current": "true" } : {},
            html("th", { scope: "row" }, NAMES[method] ?? method),
            html("td", {}, String(generators)),
            html("td", {}, digits(volume)),
          ),
        ),
      );
    },
  };
}
