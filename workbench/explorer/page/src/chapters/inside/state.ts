/** The state of the chapter, and the questions that it asks. */

import type { Question, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { fields, finite, list, vec3, within } from "../../kit/reading";
import { add3 } from "../../kit/vectors";
import {
  faces,
  locationSearch,
  planeOfDirections,
  tiling,
  type Faces,
  type LocationSearch,
  type PlaneOfDirections,
  type Tiling,
} from "../../library/pictures";
import {
  apart,
  believe,
  gauge,
  locate,
  locateHeld,
  meet,
  type Apart,
  type Belief,
  type Gauge,
  type Located,
  type Meeting,
} from "../../library/space";
import type { Body, Vec3 } from "../../library/shapes";
import { randomGenerators } from "../../data/bodies";

export interface State {
  /** The generators of the body, around the origin. */
  readonly generators: readonly Vec3[];
  /** Instead of listed generators, so many random ones: too many for a link. */
  readonly many: number;
  /** The point, or the centre of the other body. */
  readonly point: Vec3;
  /** The generators of the other body; none where there is only a point. */
  readonly others: readonly Vec3[];
  readonly step: number;
  /** The step of the rival that is seen. */
  readonly rivalStep: number;
}

export interface Late {
  readonly of: State;
  readonly verdict: Verdict;
  readonly gauge: Gauge;
  readonly search: LocationSearch | null;
  readonly tiling: Tiling | null;
  readonly directions: PlaneOfDirections | null;
  readonly apart: Apart | null;
}

export interface Answers {
  readonly located: Located;
  /** What the rival believes, of bodies that are drawn. */
  readonly belief: Belief | null;
  /** Null while it is being computed: of very many generators it is not asked in every frame. */
  readonly gauge: Gauge | null;
  /** The body of both generators, where it is drawn. */
  readonly sum: Faces | null;
  readonly body: Faces | null;
  /** The second body, with its centre in the origin. */
  readonly other: Faces | null;
  readonly late: Late | null;
}

/** Generators up to which a body is drawn, and its search told. */
export const DRAWN = 40;

export const MOST_GENERATORS = 1000;

const ORIGIN: Vec3 = [0, 0, 0];

export const first = (): State => ({
  generators: [
    [1, 0.1, 0.8],
    [0.35, 1, 0.7],
    [-0.8, 0.65, 0.75],
    [-0.85, -0.6, 0.65],
    [0.3, -0.95, 0.85],
  ],
  many: 0,
  point: [0.9, 0.4, 3.6],
  others: [],
  step: 0,
  rivalStep: 2,
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const generators = list(object?.["generators"], vec3, MOST_GENERATORS);
  const point = vec3(object?.["point"]);
  if (!generators || !point) return null;
  return {
    generators,
    point,
    many: Math.round(within(object?.["many"], 0, 20_000) ?? 0),
    others: list(object?.["others"], vec3, MOST_GENERATORS) ?? [],
    step: Math.max(0, Math.round(finite(object?.["step"]) ?? 0)),
    rivalStep: Math.max(0, Math.round(finite(object?.["rivalStep"]) ?? 0)),
  };
}

const MANY = new Map<number, readonly Vec3[]>();

/** The generators of the body, those that are only counted included. */
export function generatorsOf(state: State): readonly Vec3[] {
  if (state.many === 0) return state.generators;
  const known = MANY.get(state.many) ?? randomGenerators(7, state.many);
  MANY.set(state.many, known);
  return known;
}

export const bodyOf = (state: State): Body => ({ center: ORIGIN, generators: generatorsOf(state) });
export const otherOf = (state: State): Body => ({ center: state.point, generators: state.others });

let sum: { own: readonly Vec3[]; others: readonly Vec3[]; all: readonly Vec3[] } = { own: [], others: [], all: [] };

/**
 * The body of both generators, in which the point lies exactly if the two bodies meet (Lemma 5.1). It stays the same
 * list while the point moves.
 */
export function sumOf(state: State): Body {
  const [own, { others }] = [generatorsOf(state), state];
  if (others.length === 0) return { center: ORIGIN, generators: own };
  if (sum.own !== own || sum.others !== others) sum = { own, others, all: [...own, ...others] };
  return { center: ORIGIN, generators: sum.all };
}

export function question(state: State): Question<Located | Meeting> {
  return state.others.length > 0 ? meet(bodyOf(state), otherOf(state)) : locate(state.point, bodyOf(state));
}

// Bodies keep their faces while the point moves.
const FACES = new WeakMap<readonly Vec3[], Faces>();

function facesOf(generators: readonly Vec3[], asking: Asking): Faces | null {
  if (generators.length > DRAWN) return null;
  const known = FACES.get(generators) ?? asking.ask(faces({ center: ORIGIN, generators })).result;
  FACES.set(generators, known);
  return known;
}

export function questions(state: State, asking: Asking, late: Late | null): Answers {
  const body = sumOf(state);
  const other = state.others.length > 0 ? facesOf(state.others, asking) : null;
  const current = late && sameQuestion(late.of, state) ? late : null;
  return {
    located: locateHeld(asking, state.point, body),
    belief: body.generators.length <= DRAWN ? believe(asking, state.point, body) : null,
    gauge: state.many === 0 ? asking.ask(gauge(state.point, body)).result : (current?.gauge ?? null),
    sum: facesOf(body.generators, asking),
    body: facesOf(generatorsOf(state), asking),
    other,
    late: current,
  };
}

function sameQuestion(one: State, other: State): boolean {
  return (
    one.generators === other.generators &&
    one.many === other.many &&
    one.others === other.others &&
    one.point === other.point
  );
}

export async function later(state: State, asking: AskingLater): Promise<Late> {
  const { askLater, verifyLater } = asking;
  const body = sumOf(state);
  const drawn = body.generators.length <= DRAWN;
  const spans = state.point.some((value) => value !== 0);
  const located = await askLater(question(state));
  const [verdict, measured, search, tiles, directions, distance] = await Promise.all([
    verifyLater(located),
    askLater(gauge(state.point, body)),
    drawn ? askLater(locationSearch(state.point, body)).catch(() => null) : null,
    drawn ? askLater(tiling(body.generators)).catch(() => null) : null,
    drawn && spans ? askLater(planeOfDirections(state.point, body)).catch(() => null) : null,
    state.others.length > 0 && drawn ? askLater(apart(bodyOf(state), otherOf(state))).catch(() => null) : null,
  ]);
  return {
    of: state,
    verdict,
    gauge: measured.result,
    search: search?.result ?? null,
    tiling: tiles?.result ?? null,
    directions: directions?.result ?? null,
    apart: distance?.result ?? null,
  };
}

/** The generators with coefficients that lead from the centre to the point, as the steps of a walk. */
export function walk(state: State, coefficients: readonly number[]): Vec3[] {
  const places: Vec3[] = [ORIGIN];
  sumOf(state).generators.forEach((generator, index) => {
    const part = coefficients[index] ?? 0;
    const from = places[places.length - 1] as Vec3;
    if (part !== 0) places.push(add3(from, [generator[0] * part, generator[1] * part, generator[2] * part]));
  });
  return places;
}
