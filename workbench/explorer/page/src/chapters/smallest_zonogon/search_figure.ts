/** The figure of the search of Theorem 4.5: a vertical line through the middle of the candidates, and the side left. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { html } from "../../kit/elements";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { Stepper } from "../../kit/stepper";
import { digits, sub2 } from "../../kit/vectors";
import type { AreaSearch, Pruning } from "../../library/pictures";
import type { Vec2 } from "../../library/shapes";
import { numberOf } from "../words";
import type { Answers, Late, State } from "./state";

/** A sentence about the line, but for its end. */
const SIDES: Readonly<Record<AreaSearch["steps"][number]["side"], string>> = {
  left: "From its lowest point f falls to the left, so the line and everything on its right are discarded",
  right: "From its lowest point f falls to the right, so the line and everything on its left are discarded",
  optimal: "From its lowest point f falls to neither side: that point is a best centre, and the search ends",
  unbounded: "On this line f has no least value",
};

export function searchFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView(
    "The lines ℓ_t and the vertical line of the search",
    ["lines", "discarded", "vertices", "line"],
    {},
    () => control.redraw(),
  );
  const stepper = new Stepper("Steps of the search", (step) => control.commit({ ...control.state, step }));
  return {
    element: html("div", {}, view.element, stepper.element),
    svg: () => standalone(view.svg),
    draw(state, answers) {
      const search = answers.late?.search;
      if (!search || search.steps.length === 0) {
        for (const layer of ["lines", "discarded", "vertices", "line"]) view.draw(layer, []);
        stepper.draw(
          0,
          1,
          answers.late
            ? "These points lie on a line, or their hull has too many edges to draw the search."
            : "The search is being computed …",
        );
        return;
      }
      const now = Math.min(state.step, search.steps.length - 1);
      const step = search.steps[now] as AreaSearch["steps"][number];
      const corners = search.hull.map((index) => state.points[index] as Vec2);
      view.fit(boxAround(corners));
      const lines = search.lines.map(([one, other]) => view.line(one, sub2(other, one), { class: "thin" }));
      view.draw("lines", [
        view.polygon(corners, { class: "hull", "fill-opacity": 0.4 }),
        ...lines.filter((line) => line !== null),
      ]);
      const [low, high] = slab(search, now);
      view.draw("discarded", discarded(view, low, high));
      const vertices = search.vertices ?? [];
      view.draw(
        "vertices",
        vertices.map((point) => {
          const left = point[0] > low && point[0] < high;
          return view.dot(point, left ? 3 : 1.5, { fill: left ? "var(--blue)" : "var(--quiet)" });
        }),
      );
      const line = view.line([step.x, 0], [0, 1], { class: "sweep", "stroke-width": 2.5 });
      const minimum = step.minimum ? [view.dot(step.minimum, 6, { fill: "var(--green)" })] : [];
      view.draw("line", [...(line ? [line] : []), ...minimum]);
      const sentence =
        `Step ${now + 1} of ${search.steps.length}: ${numberOf(step.candidates, "candidate")}. The line x = ` +
        `${digits(step.x)} goes through the middle one. ${SIDES[step.side]}; candidates left: ` +
        `${step.left}.`;
      stepper.draw(now, search.steps.length, sentence);
    },
  };
}

/** The part of the plane that is still left before a step. */
function slab(search: AreaSearch, now: number): [number, number] {
  let [low, high] = [-Infinity, Infinity];
  for (const { x, side } of search.steps.slice(0, now)) {
    if (side === "left") high = Math.min(high, x);
    if (side === "right") low = Math.max(low, x);
  }
  return [low, high];
}

function discarded(view: PlaneView, low: number, high: number) {
  const left = view.pixel([low, 0])[0];
  const right = view.pixel([high, 0])[0];
  const blank = (from: number, to: number) => ({
    tag: "rect" as const,
    attributes: { x: from, y: 0, width: Math.max(0, to - from), height: view.height, class: "blank" },
  });
  return [
    ...(Number.isFinite(left) ? [blank(0, Math.min(left, view.width))] : []),
    ...(Number.isFinite(right) ? [blank(Math.max(right, 0), view.width)] : []),
  ];
}

/** The figure of pruning: ever smaller cells around the best centre, and the lines that cross them. */
export function pruningFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView("The lines ℓ_t and the cells of pruning", ["lines", "cells", "center", "names"], {}, () =>
    control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, answers) {
      const { hull, lines } = answers.zonogon;
      view.fit(boxAround(hull.map((index) => state.points[index] as Vec2)));
      const cells = cellsOfAll(answers.late);
      const crossing = new Set(cells[cells.length - 1]?.crossing ?? []);
      const drawn = lines.map(([one, other], index) =>
        view.line(one, sub2(other, one), { class: crossing.has(index) ? "good" : "thin" }),
      );
      view.draw(
        "lines",
        drawn.filter((line) => line !== null),
      );
      view.draw(
        "cells",
        cells.map((cell) => view.polygon(cell.corners, { class: "run", fill: "var(--fill-blue)", "stroke-width": 2 })),
      );
      view.draw("center", [view.dot(answers.best.result.center, 5, { fill: "var(--green)" })]);
      const names = cells.map((cell) =>
        view.text(
          cell.corners[2] ?? [0, 0],
          `${cell.crossing.length} of ${cell.lines.length} lines`,
          { class: "quiet" },
          [6, -6],
        ),
      );
      view.draw("names", names);
    },
  };
}

/** The cells for all lines, as long as each leaves fewer of them; those for samples are left out. */
export function cellsOfAll(late: Late | null): Pruning["cells"] {
  const cells = late?.pruning?.cells ?? [];
  const most = Math.max(0, ...cells.map((cell) => cell.lines.length));
  const from = cells.map((cell) => cell.lines.length).lastIndexOf(most);
  const after = cells.slice(Math.max(0, from));
  const end = after.findIndex((cell) => cell.crossing.length >= cell.lines.length);
  return end < 0 ? after : after.slice(0, end);
}
