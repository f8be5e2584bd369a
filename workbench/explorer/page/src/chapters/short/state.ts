/** The state of the chapter, and the questions that it asks. */

import type { Answer, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { fields, list, vec2, within } from "../../kit/reading";
import { scale2 } from "../../kit/vectors";
import { zonogon } from "../../library/pictures";
import { alongDirections, leastLength, type AlongDirections, type LeastLength } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";

export interface State {
  readonly points: readonly Vec2[];
  /** Evenly spaced directions along which generators may lie. */
  readonly directions: number;
  /** The first of them, in degrees. */
  readonly turn: number;
  /** Generators that the short zonogon may have at most. */
  readonly most: number;
}

export interface Late {
  readonly of: readonly Vec2[];
  readonly verdict: Verdict;
}

export interface Answers {
  readonly along: AlongDirections;
  readonly alongOutline: readonly Vec2[];
  /** Over all directions, with as many generators as it takes. */
  readonly all: Answer<LeastLength>;
  readonly allOutline: readonly Vec2[];
  readonly few: LeastLength;
  readonly fewOutline: readonly Vec2[];
  /** The zonogon of the forces, scaled until its farthest vertex lies on the unit circle. */
  readonly dual: readonly Vec2[];
  readonly late: Late | null;
}

/** The part by which the length over all directions may exceed the least one. */
export const EPSILON = 0.001;

export const MOST_POINTS = 1000;

export const first = (): State => ({
  points: [
    [0.3, 0.2],
    [2.8, -0.4],
    [4.9, 0.6],
    [5.3, 2.2],
    [3.4, 3.5],
    [1.2, 3.1],
    [-0.3, 1.7],
    [2.4, 1.4],
  ],
  directions: 3,
  turn: 10,
  most: 3,
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const points = list(object?.["points"], vec2, MOST_POINTS);
  if (!points || points.length === 0) return null;
  return {
    points,
    directions: Math.round(within(object?.["directions"], 2, 40) ?? 3),
    turn: within(object?.["turn"], 0, 180) ?? 0,
    most: Math.round(within(object?.["most"], 2, 20) ?? 3),
  };
}

export function directionsOf({ directions, turn }: State): Vec2[] {
  return Array.from({ length: directions }, (_, index): Vec2 => {
    const angle = (turn * Math.PI) / 180 + (index * Math.PI) / directions;
    return [Math.cos(angle), Math.sin(angle)];
  });
}

export function questions(state: State, { ask }: Asking, late: Late | null): Answers {
  const outline = (center: Vec2, generators: readonly Vec2[]) => ask(zonogon(center, generators)).result.vertices;
  const directions = directionsOf(state);
  const along = ask(alongDirections(state.points, directions)).result;
  const all = ask(leastLength(state.points, EPSILON));
  const few = ask(leastLength(state.points, EPSILON, state.most)).result;
  const scaled = directions.map((one, index) => scale2(one, along.coefficients?.[index] ?? 0));
  const forces = all.result.certificate.forces.map((force) => force.vector);
  const dual = forces.length > 0 ? outline([0, 0], forces) : [];
  const farthest = Math.max(1e-300, ...dual.map(([x, y]) => Math.hypot(x, y)));
  return {
    along,
    alongOutline: along.center ? outline(along.center, scaled) : [],
    all,
    allOutline: outline(all.result.center, all.result.generators),
    few,
    fewOutline: outline(few.center, few.generators),
    dual: dual.map((vertex) => scale2(vertex, 1 / farthest)),
    late: late?.of === state.points ? late : null,
  };
}

export async function later({ points }: State, { askLater, verifyLater }: AskingLater): Promise<Late> {
  return { of: points, verdict: await verifyLater(await askLater(leastLength(points, EPSILON))) };
}
