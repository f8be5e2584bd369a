/** The two bodies of the figure of the hierarchy, and how they meet while the second one flies past the first. */

import { randomGenerators } from "../../data/bodies";
import type { Asking } from "../../kit/chapter";
import { length3, scale3 } from "../../kit/vectors";
import { faces, hierarchy, type Faces, type HierarchyOfTwo } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";

/** Steps of the way of the second body. */
export const STEPS = 60;

/**
 * The generators of each body, the second's turned so that the two are not alike. Bodies of few generators have no
 * levels, so these are not those of the chapter's state.
 */
const GENERATORS = randomGenerators(7, 60);
const TURNED = GENERATORS.map(([x, y, z]): Vec3 => [z, x, y]);

const REACH = GENERATORS.reduce((sum, generator) => sum + length3(generator), 0);

const ORIGIN: Vec3 = [0, 0, 0];

/** Places of the second body's centre: from afar into the first one and out again. */
export const WAY: readonly Vec3[] = Array.from({ length: STEPS + 1 }, (_, step) => {
  const along = (2 * step) / STEPS - 1;
  return scale3([1.5 * along, 0.25, 0.75 - 0.6 * (1 - along * along)], REACH);
});

export interface MeetingOfTwo {
  readonly found: HierarchyOfTwo;
  /** The faces of the bodies, and of those around them that were looked at last, all about the origin. */
  readonly bodies: readonly [Faces, Faces];
  readonly around: readonly [Faces, Faces];
}

let last: { readonly at: number; readonly meeting: MeetingOfTwo } | null = null;

/** The faces of a level, by the body and the level. */
const drawn = new Map<string, Faces>();

export function meetingAt(at: number, ask: Asking["ask"]): MeetingOfTwo {
  if (last?.at === at) return last.meeting;
  const center = WAY[at] ?? ORIGIN;
  const found = ask(hierarchy({ center: ORIGIN, generators: GENERATORS }, { center, generators: TURNED })).result;
  const level = (body: "a" | "b", index: number): Faces => {
    const name = `${body} ${index}`;
    const shape =
      drawn.get(name) ?? ask(faces({ center: ORIGIN, generators: found[body][index]?.generators ?? [] })).result;
    drawn.set(name, shape);
    return shape;
  };
  const meeting: MeetingOfTwo = {
    found,
    bodies: [level("a", found.a.length - 1), level("b", found.b.length - 1)],
    around: [level("a", found.levels[0]), level("b", found.levels[1])],
  };
  last = { at, meeting };
  return meeting;
}
