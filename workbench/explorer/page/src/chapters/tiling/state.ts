/** The state of the chapter, and the questions that it asks. */

import type { Asking, AskingLater } from "../../kit/chapter";
import { fields, finite, list, vec3 } from "../../kit/reading";
import { faces, tiling, type Faces, type Tiling } from "../../library/pictures";
import { count, type Counted } from "../../library/space";
import type { Vec3 } from "../../library/shapes";

/** What is lit up in all three views. */
export interface Lit {
  readonly kind: "tile" | "corner" | "class";
  readonly index: number;
}

export interface State {
  readonly generators: readonly Vec3[];
  /** The rank of the separator: so many tiles lie on its left. */
  readonly sweep: number;
  readonly lit: Lit | null;
  /** Whether the separator and its vertical line are left out, where nothing is said of them. */
  readonly isPlain?: boolean;
}

export interface Late {
  readonly of: readonly Vec3[];
  readonly tiling: Tiling | null;
  readonly faces: Faces | null;
  readonly counted: Counted;
}

export interface Answers {
  readonly faces: Faces | null;
  readonly tiling: Tiling | null;
  readonly counted: Counted | null;
}

/** Generators up to which the tiling is asked for in every frame of a drag. */
export const TILING_AT_ONCE = 30;

/** Generators up to which the faces are. */
const FACES_AT_ONCE = 60;

/** Generators that the chapter takes; their tiling has some thousands of tiles. */
export const MOST_GENERATORS = 80;

export const first = (): State => ({
  generators: [
    [1, 0.1, 0.8],
    [0.35, 1, 0.7],
    [-0.8, 0.65, 0.75],
    [-0.85, -0.6, 0.65],
    [0.3, -0.95, 0.85],
  ],
  sweep: 4,
  lit: { kind: "tile", index: 3 },
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const generators = list(object?.["generators"], vec3, MOST_GENERATORS);
  if (!generators) return null;
  const lit = fields(object?.["lit"]);
  const kind = lit?.["kind"];
  const index = finite(lit?.["index"]);
  return {
    generators,
    sweep: Math.max(0, Math.round(finite(object?.["sweep"]) ?? 0)),
    lit: index !== null && (kind === "tile" || kind === "corner" || kind === "class") ? { kind, index } : null,
    ...(object?.["isPlain"] === true ? { isPlain: true } : {}),
  };
}

export function questions(state: State, asking: Asking, late: Late | null): Answers {
  const { generators } = state;
  const current = late?.of === generators ? late : null;
  const body = { center: [0, 0, 0] as Vec3, generators };
  return {
    faces: generators.length <= FACES_AT_ONCE ? asking.ask(faces(body)).result : (current?.faces ?? null),
    tiling: generators.length <= TILING_AT_ONCE ? asking.ask(tiling(generators)).result : (current?.tiling ?? null),
    counted: current?.counted ?? null,
  };
}

export async function later({ generators }: State, { askLater }: AskingLater): Promise<Late> {
  const body = { center: [0, 0, 0] as Vec3, generators };
  const [counted, tiles, solid] = await Promise.all([
    askLater(count(generators)),
    generators.length > TILING_AT_ONCE ? askLater(tiling(generators)) : null,
    generators.length > FACES_AT_ONCE ? askLater(faces(body)) : null,
  ]);
  return { of: generators, counted: counted.result, tiling: tiles?.result ?? null, faces: solid?.result ?? null };
}
