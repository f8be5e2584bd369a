/** The state of the chapter, and the questions that it asks. */

import type { Answer, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { fields, list, vec3, within } from "../../kit/reading";
import { bodyAt } from "../../kit/placement";
import { faces, type Faces } from "../../library/pictures";
import { decimal } from "../../library/fraction";
import { collide, count, meet, sweep, type Collision, type Motion } from "../../library/space";
import type { Body } from "../../library/shapes";

/** Two bodies and how they move during the step. */
export interface Scene {
  readonly a: Body;
  readonly b: Body;
  readonly moves: { readonly a: Motion; readonly b: Motion };
}

export interface State {
  readonly scene: Scene;
  readonly time: number;
  /** Evenly spaced times at which a sampling test looks. */
  readonly samples: number;
  /** The method that encloses the swept volume of the first body. */
  readonly method: string;
}

export interface Late {
  readonly of: Scene;
  readonly verdict: Verdict;
  /** For each method the volume of its zonotope. */
  readonly volumes: readonly { readonly method: string; readonly volume: number; readonly generators: number }[];
}

export interface Answers {
  readonly collision: Answer<Collision>;
  readonly a: Faces;
  readonly b: Faces;
  /** The zonotope around all placements of the first body. */
  readonly swept: Body;
  readonly around: Faces;
  /** Of the sampled times those at which the bodies meet. */
  readonly hits: readonly number[];
  readonly late: Late | null;
}

export const METHODS = [
  "by_farthest_vertex",
  "by_middle_placement",
  "by_least_rectangle",
  "by_shadow",
  "by_turned_generators",
] as const;

export const MOST_GENERATORS = 30;

/** A body at rest. */
export const REST: Motion = { axis_point: [0, 0, 0], axis: [0, 0, 1], angle: 0, translation: [0, 0, 0] };

export const first = (): State => ({
  scene: {
    a: {
      center: [-2.4, 0, 0],
      generators: [
        [1.1, 0.1, 0],
        [0, 0.22, 0.05],
        [0.05, 0, 0.3],
      ],
    },
    b: {
      center: [1.4, 0.9, 0],
      generators: [
        [0.35, 0.1, 0.1],
        [-0.1, 0.4, 0.1],
        [0.1, -0.1, 0.45],
        [0.2, 0.2, -0.2],
      ],
    },
    moves: {
      a: { axis_point: [-2.4, 0, 0], axis: [0, 0, 1], angle: 2.2, translation: [3.9, -0.6, 0] },
      b: { axis_point: [1.4, 0.9, 0], axis: [0.3, 0.2, 1], angle: 1.4, translation: [-0.4, 0.3, 0] },
    },
  },
  time: 0.25,
  samples: 5,
  method: METHODS[0],
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const scene = fields(object?.["scene"]);
  const [a, b] = [readBody(scene?.["a"]), readBody(scene?.["b"])];
  const moves = fields(scene?.["moves"]);
  const [one, other] = [readMotion(moves?.["a"]), readMotion(moves?.["b"])];
  if (!a || !b || !one || !other) return null;
  return {
    scene: { a, b, moves: { a: one, b: other } },
    time: within(object?.["time"], 0, 1) ?? 0,
    samples: Math.round(within(object?.["samples"], 2, 60) ?? 5),
    method: METHODS.find((method) => method === object?.["method"]) ?? METHODS[0],
  };
}

function readBody(told: unknown): Body | null {
  const object = fields(told);
  const center = vec3(object?.["center"]);
  const generators = list(object?.["generators"], vec3, MOST_GENERATORS);
  return center && generators ? { center, generators } : null;
}

function readMotion(told: unknown): Motion | null {
  const object = fields(told);
  const [axis_point, axis, translation] = ["axis_point", "axis", "translation"].map((name) => vec3(object?.[name]));
  const angle = within(object?.["angle"], -20, 20);
  if (!axis_point || !axis || !translation || angle === null || axis.every((value) => value === 0)) return null;
  return { axis_point, axis, angle, translation };
}

/** The axis and the angle of a sweep, whose angle is not negative. */
export function forwards(motion: Motion): Motion {
  const { axis, angle } = motion;
  return angle >= 0 ? motion : { ...motion, angle: -angle, axis: [-axis[0], -axis[1], -axis[2]] };
}

// Only the time changes while a motion plays: the answers about the whole step stay.
let remembered: { scene: Scene; method: string; samples: number; answers: Omit<Answers, "late"> } | null = null;

export function questions(state: State, asking: Asking, late: Late | null): Answers {
  const { scene, method, samples } = state;
  if (remembered?.scene !== scene || remembered.method !== method || remembered.samples !== samples) {
    remembered = { scene, method, samples, answers: answered(state, asking) };
  }
  return { ...remembered.answers, late: late?.of === scene ? late : null };
}

function answered({ scene, method, samples }: State, { ask }: Asking): Omit<Answers, "late"> {
  const { a, b, moves } = scene;
  const swept = ask(sweep(a, forwards(moves.a), method)).result;
  const times = Array.from({ length: samples }, (_, index) => index / (samples - 1));
  return {
    collision: ask(collide(a, b, moves)),
    a: ask(faces(a)).result,
    b: ask(faces(b)).result,
    swept,
    around: ask(faces(swept)).result,
    hits: times.filter((time) => ask(meet(bodyAt(a, moves.a, time), bodyAt(b, moves.b, time))).result.intersects),
  };
}

export async function later({ scene }: State, { askLater, verifyLater }: AskingLater): Promise<Late> {
  const { a, b, moves } = scene;
  const collision = await askLater(collide(a, b, moves));
  const [verdict, ...volumes] = await Promise.all([
    verifyLater(collision),
    ...METHODS.map(async (method) => {
      const body = (await askLater(sweep(a, forwards(moves.a), method))).result;
      const { measure } = (await askLater(count(body.generators))).result;
      return { method, volume: decimal(measure), generators: body.generators.length };
    }),
  ]);
  return { of: scene, verdict, volumes };
}
