/** Questions about points of the plane (Section 4). */

import type { Question } from "../engine/questions";
import type { AnyNumber, Vec2 } from "./shapes";

export interface LeastArea {
  readonly area: AnyNumber;
  readonly center: Vec2;
  readonly generators: readonly Vec2[];
  readonly lower_bound: AnyNumber;
  readonly certificate: {
    readonly hull: readonly number[];
    readonly farthest: readonly number[];
    readonly coefficients: readonly number[];
    readonly basis: readonly number[];
  };
}

/** The zonogon of least area around the points. */
export function leastArea(points: readonly Vec2[]): Question<LeastArea> {
  return { entry: "answer", kind: "min_area", input: { points } };
}

export interface LeastLength {
  readonly length: number;
  readonly center: Vec2;
  readonly generators: readonly Vec2[];
  readonly lower_bound: number;
  readonly ratio: number;
  readonly within_epsilon: boolean;
  readonly certificate: { readonly forces: readonly { readonly point: number; readonly vector: Vec2 }[] };
}

/** A zonogon around the points whose total length is within 1 + epsilon of the least, over all directions. */
export function leastLength(points: readonly Vec2[], epsilon: number, most?: number): Question<LeastLength> {
  const input = most === undefined ? { points, epsilon } : { points, epsilon, max_generators: most };
  return { entry: "answer", kind: "min_length_all", input };
}

export interface AlongDirections {
  readonly status: "optimal" | "feasible" | "infeasible";
  readonly value?: number;
  readonly center?: Vec2;
  readonly coefficients?: readonly number[];
  readonly lower_bound?: number;
}

/** The zonogon of least total length around the points whose generators lie along given directions. */
export function alongDirections(points: readonly Vec2[], directions: readonly Vec2[]): Question<AlongDirections> {
  const weights = directions.map(() => 1);
  return { entry: "answer", kind: "min_length_dirs", input: { points, directions, weights } };
}
