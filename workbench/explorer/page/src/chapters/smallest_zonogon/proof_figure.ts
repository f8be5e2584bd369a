/** The figure of the proof: the coefficient of each edge of the hull, and the arrows δ_t e_t, which close. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import type { Shape } from "../../kit/layer";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { add2, digits, scale2 } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import { balance } from "./proof";
import type { Answers, State } from "./state";

/** Edges up to which each carries its coefficient as text. */
const TEXT_LIMIT = 14;

/** Pixels between an edge and its text, half of a letter's width, and half of its height. */
const [BESIDE, HALF_WIDE, HALF_HIGH] = [9, 4, 5];

export function proofFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView(
    "The hull with the coefficients of its edges",
    ["hull", "edges", "center", "names"],
    {},
    () => control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, answers) {
      const { center, certificate } = answers.best.result;
      const corners = certificate.hull.map((index) => state.points[index] as Vec2);
      const outline = answers.outline;
      view.fit(boxAround([...corners, ...outline]));
      view.draw("hull", [view.polygon(outline, { class: "best" }), view.polygon(corners, { class: "hull" })]);
      const edges: Shape[] = [];
      const names: Shape[] = [];
      const free = beside();
      for (const edge of balance(state, answers)) {
        const end = add2(edge.from, edge.vector);
        const look = edge.coefficient > 0 ? "run" : "run reflected";
        if (edge.coefficient !== 0)
          edges.push(view.path([edge.from, end], { class: look, "stroke-width": 1 + 4 * Math.abs(edge.coefficient) }));
        if (corners.length <= TEXT_LIMIT) {
          const middle = add2(edge.from, scale2(edge.vector, 0.5));
          const name = digits(edge.coefficient, 3);
          names.push(view.text(middle, name, { "text-anchor": "middle" }, free(view.pixel(middle), edge.vector, name)));
        }
      }
      view.draw("edges", edges);
      view.draw("center", [view.dot(center, 5, { fill: "var(--green)" })]);
      view.draw("names", [...names, view.text(center, "best centre", { class: "quiet" }, [8, 4])]);
    },
  };
}

/** The shifts of texts, one after the other: on the side of the hull, or on the other where a text is there already. */
function beside(): (middle: Vec2, vector: Vec2, text: string) => Vec2 {
  const taken: { at: Vec2; letters: number }[] = [];
  const isFree = ([x, y]: Vec2, letters: number) =>
    taken.every(
      ({ at, letters: others }) =>
        Math.abs(x - at[0]) > HALF_WIDE * (letters + others) || Math.abs(y - at[1]) > 3 * HALF_HIGH,
    );
  return (middle, vector, text) => {
    const inside = inwards(vector, text);
    const other = inwards(scale2(vector, -1), text);
    const shift = isFree(add2(middle, inside), text.length) ? inside : other;
    taken.push({ at: add2(middle, shift), letters: text.length });
    return shift;
  };
}

/** The shift in pixels that puts a text beside an edge of a hull, on the side of the hull, which is the left one. */
function inwards([x, y]: Vec2, text: string): Vec2 {
  const size = Math.hypot(x, y) || 1;
  const [across, down] = [-y / size, -x / size];
  const far = BESIDE + HALF_WIDE * text.length * Math.abs(across) + HALF_HIGH * Math.abs(down);
  return [far * across, far * down + HALF_HIGH];
}
