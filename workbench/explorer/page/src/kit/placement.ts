/** Placements of a body in a motion, for drawing: rounded, while the library decides with exact numbers. */

import type { Body, Vec3 } from "../library/shapes";
import type { Motion } from "../library/space";
import { add3, cross3, dot3, length3, scale3, sub3 } from "./vectors";

/** A vector turned about an axis through the origin. */
export function turned(v: Vec3, axis: Vec3, angle: number): Vec3 {
  const size = length3(axis);
  if (size === 0) return v;
  const u = scale3(axis, 1 / size);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return add3(add3(scale3(v, cos), scale3(cross3(u, v), sin)), scale3(u, dot3(u, v) * (1 - cos)));
}

/** The place of a point at a time between 0 and 1. */
export function placeAt(point: Vec3, motion: Motion, time: number): Vec3 {
  const { axis_point, axis, angle, translation } = motion;
  return add3(add3(turned(sub3(point, axis_point), axis, angle * time), axis_point), scale3(translation, time));
}

/** The body at a time between 0 and 1. */
export function bodyAt(body: Body, motion: Motion, time: number): Body {
  return {
    center: placeAt(body.center, motion, time),
    generators: body.generators.map((generator) => turned(generator, motion.axis, motion.angle * time)),
  };
}
