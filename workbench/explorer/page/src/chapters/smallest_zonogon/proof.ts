/** The numbers of the proof of least area, edge by edge, as they stand in the certificate. */

import { cross2, scale2, sub2 } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import type { Answers, State } from "./state";

export interface Edge {
  readonly from: Vec2;
  /** The edge e_t as a vector. */
  readonly vector: Vec2;
  /** Its coefficient δ_t. */
  readonly coefficient: number;
  /** v_t at the best centre: e_t × (2 O − P_s − P_t). */
  readonly value: number;
}

export function balance(state: State, answers: Answers): Edge[] {
  const { center, certificate } = answers.best.result;
  const { hull, farthest, coefficients, basis } = certificate;
  const at = (place: number): Vec2 => state.points[hull[place % hull.length] ?? 0] as Vec2;
  const edges = coefficients.map((coefficient, place) => {
    const vector = sub2(at(place + 1), at(place));
    const [s, t] = [at(farthest[place] ?? 0), at(place)];
    const twice = sub2(sub2(scale2(center, 2), s), t);
    return { from: at(place), vector, coefficient, value: cross2(vector, twice) };
  });
  return solved(edges, basis);
}

/** The coefficients of the basis are written as 0 and solved from Σ δ_t e_t = 0. */
function solved(edges: Edge[], basis: readonly number[]): Edge[] {
  const rest = edges.reduce<Vec2>((sum, edge) => sub2(sum, scale2(edge.vector, edge.coefficient)), [0, 0]);
  const [one, other] = basis.map((place) => edges[place]);
  const answer = [...edges];
  if (one && other) {
    const area = cross2(one.vector, other.vector);
    answer[basis[0] as number] = { ...one, coefficient: cross2(rest, other.vector) / area };
    answer[basis[1] as number] = { ...other, coefficient: cross2(one.vector, rest) / area };
  } else if (one) {
    const size = one.vector[0] ** 2 + one.vector[1] ** 2;
    const along = (rest[0] * one.vector[0] + rest[1] * one.vector[1]) / size;
    answer[basis[0] as number] = { ...one, coefficient: along };
  }
  return answer;
}
