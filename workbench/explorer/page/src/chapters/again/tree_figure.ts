/** The figure of the tree over directions: leaves, and those that a direction of a question crosses. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { PlaneView } from "../../kit/plane_view";
import { cross3, dot3 } from "../../kit/vectors";
import { zoneColour } from "../../kit/zone_colours";
import type { Vec2, Vec3 } from "../../library/shapes";
import { onDisc } from "./places";
import { PREPARED, type Answers, type State } from "./state";

/** Points of the drawn circle. */
const ROUND = 180;

/** The direction in which the question of the figure asks. */
export function asked(state: State): Vec3 {
  const turn = (state.turn * Math.PI) / 180;
  return [Math.cos(turn) * 0.8, Math.sin(turn) * 0.8, 0.6];
}

/** Whether the generators of a leaf lie on both sides of the plane that the direction is normal to. */
export function isCrossed(leaf: readonly number[], u: Vec3): boolean {
  const signs = leaf.map((index) => {
    return Math.sign(dot3(turned(PREPARED[index] as Vec3), u));
  });
  return signs.some((sign) => sign > 0) && signs.some((sign) => sign < 0);
}

/** A generator as the tree turns it: its largest coordinate is positive. */
function turned(v: Vec3): Vec3 {
  const largest = v.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);
  return largest < 0 ? [-v[0], -v[1], -v[2]] : v;
}

export function treeFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView("Directions of generators by leaves", ["rim", "dots", "circle"], {}, () =>
    control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, { tree }) {
      const rim = Array.from({ length: ROUND }, (_, place): Vec2 => {
        const angle = (2 * Math.PI * place) / ROUND;
        return [Math.cos(angle), Math.sin(angle)];
      });
      view.fit({ low: [-1, -1], high: [1, 1] });
      view.draw("rim", [view.polygon(rim, { class: "axis" })]);
      const u = asked(state);
      const dots = (tree ?? []).flatMap((leaf, index) => {
        const crossed = isCrossed(leaf, u);
        return leaf.map((generator) =>
          view.dot(onDisc(PREPARED[generator] as Vec3), crossed ? 5 : 3, {
            fill: zoneColour(index),
            opacity: crossed ? 1 : 0.45,
          }),
        );
      });
      view.draw("dots", dots);
      view.draw("circle", [view.path(circle(u), { class: "sweep" })]);
    },
  };
}

/** The upper half of the great circle of the directions at right angles to one. */
function circle(u: Vec3): Vec2[] {
  const across = cross3(u, [0, 0, 1]);
  const upwards = cross3(across, u);
  const size = (v: Vec3) => Math.hypot(...v);
  const [s, t] = [1 / size(across), 1 / size(upwards)];
  return Array.from({ length: ROUND / 2 + 1 }, (_, place): Vec2 => {
    const angle = (2 * Math.PI * place) / ROUND;
    const at = [0, 1, 2].map(
      (k) => Math.cos(angle) * s * (across[k] as number) + Math.sin(angle) * t * (upwards[k] as number),
    );
    return onDisc([at[0] as number, at[1] as number, Math.max(0, at[2] as number)]);
  });
}
