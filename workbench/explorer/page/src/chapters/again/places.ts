/** Places of figures that are drawn and not decided. */

import type { Vec2, Vec3 } from "../../library/shapes";

/** The mean of points. */
export function mean2(points: readonly Vec2[]): Vec2 {
  const sum = points.reduce(([x, y], point) => [x + point[0], y + point[1]], [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
}

/** A direction turned to the upper half, as a place of a disc in which areas are true. */
export function onDisc(direction: Vec3): Vec2 {
  const turned = direction[2] < 0 ? direction.map((value) => -value) : direction;
  const [x = 0, y = 0, z = 0] = turned;
  const size = Math.hypot(x, y, z) || 1;
  const spread = 1 / Math.sqrt(size * (size + z));
  return [x * spread, y * spread];
}
