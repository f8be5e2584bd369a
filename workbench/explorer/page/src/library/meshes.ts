/** Questions about meshes of triangles and the bounding volumes of their hierarchies. */

import type { Question } from "../engine/questions";
import type { Body, Vec3 } from "./shapes";

/** A surface: triangles by the positions of their corners, counted from 0. */
export interface MeshData {
  readonly vertices: readonly Vec3[];
  readonly triangles: readonly Vec3[];
}

/** A rotation by its rows, and a shift. */
export interface Pose {
  readonly matrix: readonly [Vec3, Vec3, Vec3];
  readonly translation: Vec3;
}

export interface Node extends Body {
  /** With a cube of this half-length added to it, the body contains the triangles exactly. */
  readonly margin: number;
  readonly triangles: readonly number[];
}

/** The bounding volumes of a level of a mesh's hierarchy: boxes or zonotopes, by the name of the volume. */
export function meshLevel(a: MeshData, level: number, volume: string): Question<{ nodes: readonly Node[] }> {
  return { entry: "answer", kind: "mesh_level", input: { a, level }, method: volume };
}

export interface MeshTests {
  /** Tests of two nodes, and of two triangles, until it was decided whether the meshes meet. */
  readonly node_tests: number;
  readonly triangle_tests: number;
  /** Two triangles that meet, one of each mesh. */
  readonly witness?: readonly [number, number];
  /** Bounds of the distance of meshes that do not meet. */
  readonly distance?: readonly [number, number];
}

/** The work that a volume makes of the question whether a mesh meets its copy in another place. */
export function meshTests(a: MeshData, pose: Pose, volume: string): Question<MeshTests> {
  return { entry: "columns", kind: "mesh_tests", input: { a, b: { ...a, pose }, volume } };
}

export interface MeshMeeting {
  readonly intersects: boolean;
  readonly witness?: readonly [number, number];
  readonly distance?: { readonly lower: number; readonly upper: number };
}

/** Whether a mesh meets its copy in another place. */
export function meshesMeet(a: MeshData, pose: Pose): Question<MeshMeeting> {
  return { entry: "answer", kind: "mesh", input: { a, b: { ...a, pose } } };
}
