/** A plane between two bodies, drawn as a square at right angles to the direction that separates them. */

import type { Vec3 } from "../library/shapes";
import type { Solid } from "./solid";
import { add3, cross3, length3, scale3 } from "./vectors";

const COLOUR = "#d55e00";

export function drawPlane(plane: Solid, through: Vec3, normal: Vec3, half: number): void {
  const u = unit(normal);
  const across = unit(cross3(u, Math.abs(u[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  const upwards = cross3(u, across);
  const corner = (s: number, t: number) => add3(through, add3(scale3(across, s * half), scale3(upwards, t * half)));
  const vertices = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  plane.draw(
    {
      vertices,
      facets: [[0, 1, 2, 3]],
      ends: [0, 1, 1, 2, 2, 3, 3, 0],
    },
    { facets: [COLOUR], opacity: 0.25, edge: COLOUR },
  );
}

function unit(v: Vec3): Vec3 {
  return scale3(v, 1 / (length3(v) || 1));
}
