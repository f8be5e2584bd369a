/**
 * The figure of the kernel's plane: directions in which the point is at height 1, and the one in which the body
 * reaches least.
 */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { digits } from "../../kit/vectors";
import { zoneColour } from "../../kit/zone_colours";
import type { Vec2 } from "../../library/shapes";
import type { Answers, State } from "./state";

export function directionsFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView(
    "The plane of directions with a line for each generator",
    ["lines", "optimum", "names"],
    {},
    () => control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(_, { late }) {
      const plane = late?.directions;
      if (!plane) {
        for (const layer of ["lines", "optimum", "names"]) view.draw(layer, []);
        return;
      }
      const [x, y] = plane.optimum ?? [0, 0];
      const near = plane.lines
        .map(([a, b, c]) => Math.abs(a * x + b * y + c) / (Math.hypot(a, b) || 1))
        .filter(Number.isFinite);
      const radius = near.sort((one, other) => one - other)[Math.floor(near.length * 0.75)] || 1;
      view.fit(
        boxAround([
          [x - radius, y - radius],
          [x + radius, y + radius],
        ]),
      );
      const lines = plane.lines.flatMap(([a, b, c], index) => {
        const size = a * a + b * b;
        if (size === 0) return [];
        const through: Vec2 = [(-a * c) / size, (-b * c) / size];
        const line = view.line(through, [b, -a], { stroke: zoneColour(index), "stroke-width": 2 });
        return line ? [line] : [];
      });
      view.draw("lines", lines);
      view.draw(
        "optimum",
        !plane.optimum
          ? []
          : [view.dot(plane.optimum, 7, { fill: "var(--green)", stroke: "var(--paper)", "stroke-width": 2 })],
      );
      view.draw(
        "names",
        !plane.optimum ? [] : [view.text(plane.optimum, `gauge ${digits(plane.gauge)}`, {}, [11, -9])],
      );
    },
  };
}
