/** Figure 3 of the paper: the arcs of the vertices on a plane at right angles to the axis, moved to a common origin. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import type { Shape } from "../../kit/layer";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { turned } from "../../kit/placement";
import { cross3, digits, dot3, length2, length3, scale3, sub3 } from "../../kit/vectors";
import type { Vec2, Vec3 } from "../../library/shapes";
import { forwards, type Answers, type Scene, type State } from "./state";

/** Pieces in which an arc is drawn. */
const PIECES = 24;

export function arcsFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView(
    "The arcs of the vertices, moved to a common origin",
    ["square", "circle", "arcs", "names"],
    {},
    () => control.redraw(),
  );
  let shown: { scene: Scene; size: string } | null = null;
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw({ scene }, { a }) {
      // While the motion plays only the time changes, which this figure does not show.
      const size = `${view.width} ${view.height}`;
      if (shown?.scene === scene && shown.size === size) return;
      shown = { scene, size };
      const { axis, angle, axis_point } = forwards(scene.moves.a);
      const [across, up] = frameOf(axis);
      const flat = (place: Vec3): Vec2 => [dot3(place, across), dot3(place, up)];
      const arcs = a.vertices.map((vertex) => {
        const from = sub3(vertex, axis_point);
        return Array.from({ length: PIECES + 1 }, (_, piece) =>
          flat(sub3(turned(from, axis, (angle * piece) / PIECES), from)),
        );
      });
      // Without a turn the arcs are points; what the computation of a point leaves is rounding.
      const radius = angle === 0 ? 0 : Math.max(0, ...arcs.map((arc) => length2(arc[PIECES] as Vec2)));
      const farthest = radius || 1e-9;
      const square: Vec2[] = [
        [-farthest, -farthest],
        [farthest, -farthest],
        [farthest, farthest],
        [-farthest, farthest],
      ];
      view.fit(boxAround(square));
      view.draw("square", [view.polygon(square, { class: "run reflected", "stroke-width": 2 })]);
      const round = Array.from(
        { length: 97 },
        (_, index): Vec2 => [
          farthest * Math.cos((2 * Math.PI * index) / 96),
          farthest * Math.sin((2 * Math.PI * index) / 96),
        ],
      );
      view.draw("circle", [view.path(round, { class: "best" })]);
      const drawn: Shape[] = arcs.map((arc) => view.path(arc, { class: "run", "stroke-width": 1.5 }));
      view.draw("arcs", [
        ...drawn,
        ...arcs.map((arc) => view.dot(arc[PIECES] as Vec2, 3, { fill: "var(--blue)" })),
        view.dot([0, 0], 4, { fill: "var(--ink)" }),
      ]);
      view.draw("names", [
        view.text(
          [0, farthest],
          `radius ${digits(radius)}${radius === 0 ? ": no turn, no arcs" : ""}`,
          { class: "quiet", "text-anchor": "middle" },
          [0, -8],
        ),
      ]);
    },
  };
}

/** Two unit vectors at right angles to an axis. */
function frameOf(axis: Vec3): [Vec3, Vec3] {
  const u = scale3(axis, 1 / (length3(axis) || 1));
  const side = cross3(u, Math.abs(u[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
  const across = scale3(side, 1 / length3(side));
  return [across, cross3(u, across)];
}
