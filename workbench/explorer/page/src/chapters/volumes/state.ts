/** The state of the chapter, and the questions that it asks. */

import type { Answer, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { turned } from "../../kit/placement";
import { fields, list, vec3, within } from "../../kit/reading";
import { add3, sub3 } from "../../kit/vectors";
import { decimal } from "../../library/fraction";
import { meshLevel, meshTests, type MeshData, type MeshTests, type Node, type Pose } from "../../library/meshes";
import { faces, type Faces } from "../../library/pictures";
import { count } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { SHAPES } from "./shapes";

export interface State {
  /** The name of one of the chapter's meshes; that of none where the reader has brought one. */
  readonly shape: string;
  readonly own: MeshData | null;
  readonly volume: string;
  readonly level: number;
  /** The shift of the second copy, and its turn about `AXIS` through its middle in degrees. */
  readonly place: Vec3;
  readonly turn: number;
}

/** The volumes that the first figure draws. */
export const DRAWN: readonly { readonly id: string; readonly name: string }[] = [
  { id: "aabb", name: "boxes along the axes" },
  { id: "obb", name: "boxes turned as they fit" },
  { id: "zonotope_3", name: "parallelepipeds" },
  { id: "zonotope_4", name: "zonotopes of 4 generators" },
  { id: "zonotope_5", name: "zonotopes of 5 generators" },
  { id: "zonotope_6", name: "zonotopes of 6 generators" },
];

/** The volumes whose tests the second figure counts. */
export const COUNTED: readonly { readonly id: string; readonly name: string }[] = [
  { id: "sphere", name: "spheres" },
  { id: "aabb", name: "boxes along the axes" },
  { id: "dop_18", name: "polytopes of 18 fixed normals" },
  { id: "dop_26", name: "polytopes of 26 fixed normals" },
  { id: "obb", name: "boxes turned as they fit" },
  { id: "zonotope_3", name: "parallelepipeds" },
  { id: "zonotope_4", name: "zonotopes, 4 generators" },
  { id: "zonotope_6", name: "zonotopes, 6 generators" },
];

export const DEEPEST = 5;

export const MOST_TRIANGLES = 1500;

/** The axis of the second copy's turn. */
export const AXIS: Vec3 = [0.3, -0.5, 1];

export const first = (): State => ({
  shape: "ring",
  own: null,
  volume: "zonotope_6",
  level: 3,
  place: [1.1, 0.24, 0.99],
  turn: -135,
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const own = readMesh(object?.["own"]);
  const shape = typeof object?.["shape"] === "string" && object["shape"] in SHAPES ? object["shape"] : null;
  const place = vec3(object?.["place"]);
  if (!object || (!own && !shape) || !place) return null;
  return {
    shape: shape ?? "ring",
    own,
    volume: DRAWN.find(({ id }) => id === object["volume"])?.id ?? "zonotope_6",
    level: Math.round(within(object["level"], 0, DEEPEST) ?? 3),
    place,
    turn: within(object["turn"], -360, 360) ?? 0,
  };
}

function readMesh(told: unknown): MeshData | null {
  const object = fields(told);
  const vertices = list(object?.["vertices"], vec3, 3 * MOST_TRIANGLES);
  const triangles = list(object?.["triangles"], vec3, MOST_TRIANGLES);
  const isCorner = (at: number) => Number.isInteger(at) && at >= 0 && at < (vertices?.length ?? 0);
  if (!vertices || !triangles?.length || !triangles.flat().every(isCorner)) return null;
  return { vertices, triangles };
}

export const meshOf = (state: State): MeshData => state.own ?? (SHAPES[state.shape] as MeshData);

/** The middle of a mesh, about which its copy is turned, and its longest side. */
export function middleOf(mesh: MeshData): Middle {
  const known = MIDDLES.get(mesh) ?? measured(mesh);
  MIDDLES.set(mesh, known);
  return known;
}

interface Middle {
  readonly middle: Vec3;
  readonly size: number;
}

const MIDDLES = new WeakMap<MeshData, Middle>();

function measured({ vertices }: MeshData): Middle {
  const sides = ([0, 1, 2] as const).map((axis) => {
    const along = vertices.map((vertex) => vertex[axis]);
    return [Math.min(...along), Math.max(...along)] as const;
  });
  const middle = sides.map(([low, high]) => (low + high) / 2) as unknown as Vec3;
  return { middle, size: Math.max(...sides.map(([low, high]) => high - low)) };
}

/** The place of a point of the second copy. */
export function moved(state: State, point: Vec3): Vec3 {
  const { middle } = middleOf(meshOf(state));
  const around = turned(sub3(point, middle), AXIS, (state.turn * Math.PI) / 180);
  return add3(add3(around, middle), state.place);
}

export function poseOf(state: State): Pose {
  const columns = (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).map((axis) => turned(axis, AXIS, (state.turn * Math.PI) / 180));
  const row = (at: 0 | 1 | 2) => columns.map((column) => column[at]) as unknown as Vec3;
  return { matrix: [row(0), row(1), row(2)], translation: moved(state, [0, 0, 0]) };
}

/** The bodies of a level, with the faces of each. */
export interface Level {
  readonly nodes: readonly Node[];
  readonly faces: readonly Faces[];
  /** The sum of their volumes. */
  readonly total: number;
  readonly verdict: Verdict;
}

export interface Counted {
  readonly id: string;
  readonly tests: MeshTests;
}

export interface Late {
  readonly of: State;
  readonly level: Level;
  readonly counted: readonly Counted[];
}

export interface Answers {
  /** What the worker has found last; null of another mesh, volume or level. */
  readonly level: Level | null;
  /** Null of another mesh or place. */
  readonly counted: readonly Counted[] | null;
}

const isSameMesh = (one: State, other: State) => one.shape === other.shape && one.own === other.own;
const isSameLevel = (one: State, other: State) =>
  isSameMesh(one, other) && one.volume === other.volume && one.level === other.level;
const isSamePlace = (one: State, other: State) =>
  isSameMesh(one, other) && one.place === other.place && one.turn === other.turn;

/** Hierarchies are built in the worker: nothing that is asked in every frame. */
export function questions(state: State, _: Asking, late: Late | null): Answers {
  return {
    level: late && isSameLevel(late.of, state) ? late.level : null,
    counted: late && isSamePlace(late.of, state) ? late.counted : null,
  };
}

/** What was found last stays while only the other half of the state changes. */
let last: Late | null = null;

export async function later(state: State, asking: AskingLater): Promise<Late> {
  const before = last;
  const level = before && isSameLevel(before.of, state) ? before.level : await levelOf(state, asking);
  const counted = before && isSamePlace(before.of, state) ? before.counted : await countedOf(state, asking);
  last = { of: state, level, counted };
  return last;
}

async function levelOf(state: State, { askLater, verifyLater }: AskingLater): Promise<Level> {
  const answer: Answer<{ nodes: readonly Node[] }> = await askLater(
    meshLevel(meshOf(state), state.level, state.volume),
  );
  const { nodes } = answer.result;
  const drawn = await Promise.all(nodes.map((node) => askLater(faces(node))));
  const counts = await Promise.all(nodes.map(({ generators }) => askLater(count(generators))));
  const total = counts.reduce((sum, { result }) => sum + (result.affine_dim < 3 ? 0 : decimal(result.measure)), 0);
  return { nodes, faces: drawn.map(({ result }) => result), total, verdict: await verifyLater(answer) };
}

function countedOf(state: State, { askLater }: AskingLater): Promise<Counted[]> {
  const [mesh, pose] = [meshOf(state), poseOf(state)];
  return Promise.all(
    COUNTED.map(async ({ id }) => ({ id, tests: (await askLater(meshTests(mesh, pose, id))).result })),
  );
}
