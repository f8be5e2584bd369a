/** The state of the chapter, and the questions that it asks. */

import { polar, randomGenerators } from "../../data/bodies";
import type { Answer, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { fields, list, vec3, within } from "../../kit/reading";
import {
  cutting,
  directionTree,
  faces,
  tiling,
  type CuttingAndImage,
  type Faces,
  type Tiling,
} from "../../library/pictures";
import { locateMany, reduce, walk, type FacetName, type Reduced } from "../../library/space";
import type { Body, Vec3 } from "../../library/shapes";
import { meetingAt, STEPS, type MeetingOfTwo } from "./meeting";

export interface State {
  readonly generators: readonly Vec3[];
  /** Generators that the reduced body may have at most. */
  readonly most: number;
  readonly rule: string;
  /** The facets that the walk has been on; the last one is where it stands. */
  readonly path: readonly FacetName[];
  /** Each trapezoid of the cutting is crossed by at most this part of the lines: one divided by it. */
  readonly r: number;
  /** The direction of the question to the tree, in degrees. */
  readonly turn: number;
  /** The step of the second body on its way. */
  readonly at: number;
}

export interface Effort {
  readonly method: string;
  readonly generators: number;
  readonly build: number;
  /** Operations for each point. */
  readonly query: number;
}

export interface Answers {
  readonly body: Faces;
  readonly reduced: Answer<Reduced>;
  readonly around: Faces;
  /** The facets next to the last one of the walk; null where the generators are in special position. */
  readonly neighbours: readonly FacetName[] | null;
  readonly efforts: readonly Effort[];
  readonly verdict: Verdict | null;
  readonly cut: Cut | null;
  /** The generators of each leaf of the tree of `PREPARED`. */
  readonly tree: readonly (readonly number[])[] | null;
  readonly meeting: MeetingOfTwo;
}

/** A cutting with the tiling in which its image lies. */
export interface Cut {
  readonly cutting: CuttingAndImage;
  readonly tiling: Tiling;
}

export interface Late {
  readonly of: State;
  readonly cut: Cut;
  readonly tree: readonly (readonly number[])[];
  readonly verdict: Verdict;
  readonly efforts: readonly Effort[];
}

export const RULES = ["cluster", "lemma_5_5", "girard", "combastel", "pca", "scott", "adaptive", "best"] as const;

export const MOST_GENERATORS = 40;

/** The finest cutting that is drawn. */
export const MOST_PARTS = 5;

const ORIGIN: Vec3 = [0, 0, 0];

/** What the figures of prepared bodies begin with. */
const ASIDE = { r: 2, turn: 25, at: 10 } as const;

/** The generators of the figure of the tree. */
export const PREPARED: readonly Vec3[] = randomGenerators(21, 600);

export const first = (): State => ({
  generators: polar(11, 0.65),
  most: 5,
  rule: "cluster",
  path: [[0, 4, 1]],
  ...ASIDE,
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const generators = list(object?.["generators"], vec3, MOST_GENERATORS);
  if (!generators || generators.length < 3) return null;
  const path = list(object?.["path"], (one) => facetName(one, generators.length), 1000);
  return {
    generators,
    most: Math.round(within(object?.["most"], 3, MOST_GENERATORS) ?? 5),
    rule: RULES.find((rule) => rule === object?.["rule"]) ?? "cluster",
    path: path && path.length > 0 ? path : [[0, 1, 1]],
    r: Math.round(within(object?.["r"], 1, MOST_PARTS) ?? ASIDE.r),
    turn: within(object?.["turn"], 0, 360) ?? ASIDE.turn,
    at: Math.round(within(object?.["at"], 0, STEPS) ?? ASIDE.at),
  };
}

function facetName(told: unknown, count: number): FacetName | null {
  const name = vec3(told);
  if (!name) return null;
  const [i, j, side] = name;
  return Number.isInteger(i) && Number.isInteger(j) && 0 <= i && i < j && j < count && (side === 1 || side === -1)
    ? [i, j, side]
    : null;
}

export const bodyOf = (state: State): Body => ({ center: ORIGIN, generators: state.generators });

export function questions(state: State, { ask }: Asking, late: Late | null): Answers {
  const body = bodyOf(state);
  const reduced = ask(reduce(body, Math.min(state.most, Math.max(3, state.generators.length)), state.rule));
  const last = state.path[state.path.length - 1] as FacetName;
  return {
    body: ask(faces(body)).result,
    reduced,
    around: ask(faces(reduced.result)).result,
    neighbours: ignoreRefusal(() => ask(walk(state.generators, last)).result.neighbours),
    efforts: late?.efforts ?? [],
    verdict:
      late && late.of.generators === state.generators && late.of.most === state.most && late.of.rule === state.rule
        ? late.verdict
        : null,
    cut: late && late.of.generators === state.generators && late.of.r === state.r ? late.cut : null,
    tree: late?.tree ?? null,
    meeting: meetingAt(state.at, ask),
  };
}

/** The library walks over generators in general position alone. */
function ignoreRefusal<Value>(ask: () => Value): Value | null {
  try {
    return ask();
  } catch {
    return null;
  }
}

/** Numbers of generators for which the effort is counted, and points that are asked. */
const SIZES = [50, 200, 800];
const ASKED = 40;

let leaves: readonly (readonly number[])[] | null = null;
let counted: readonly Effort[] | null = null;

export async function later(state: State, { askLater, verifyLater }: AskingLater): Promise<Late> {
  const reduced = await askLater(
    reduce(bodyOf(state), Math.min(state.most, Math.max(3, state.generators.length)), state.rule),
  );
  const verdict = await verifyLater(reduced);
  const [cut, tiles] = await Promise.all([
    askLater(cutting(state.generators, state.r)),
    askLater(tiling(state.generators)),
  ]);
  leaves ??= (await askLater(directionTree(PREPARED))).result.leaves;
  counted ??= await Promise.all(
    SIZES.flatMap((size) =>
      ["by_lad", "by_direction_tree", "by_cutting"].map(async (method): Promise<Effort> => {
        const body = { center: ORIGIN, generators: randomGenerators(11, size) };
        const reach = Math.sqrt(size) * 0.9;
        const points = randomGenerators(12, ASKED).map((one): Vec3 => [one[0] * reach, one[1] * reach, one[2] * reach]);
        const { build, query } = (await askLater(locateMany(body, points, method))).result;
        return { method, generators: size, build, query: query / ASKED };
      }),
    ),
  );
  return { of: state, cut: { cutting: cut.result, tiling: tiles.result }, tree: leaves, verdict, efforts: counted };
}
