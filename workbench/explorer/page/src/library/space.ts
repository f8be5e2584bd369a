/** Questions about zonotopes of space (Sections 3, 5 and 6). */

import type { AsksHeld, Question } from "../engine/questions";
import type { AnyNumber, Body, Exact, LocationProof, Status, Vec3 } from "./shapes";

export interface Located {
  readonly member: boolean;
  readonly status: Status;
  readonly certificate: LocationProof;
}

/** Whether a point lies in a body. */
export function locate(point: Vec3, body: Body): Question<Located> {
  return { entry: "answer", kind: "member", input: { point, center: body.center, generators: body.generators } };
}

/** Questions that hold a body; the same body has the same question, so that it is read once. */
const HOLDING = new WeakMap<readonly Vec3[], { readonly center: Vec3; readonly question: Question<never> }>();

function holding({ center, generators }: Body): Question<never> {
  const known = HOLDING.get(generators);
  if (known && known.center.every((value, axis) => value === center[axis])) return known.question;
  const question: Question<never> = { entry: "answer", kind: "body", input: { center, generators } };
  HOLDING.set(generators, { center, question });
  return question;
}

/** Whether a point lies in a body, as `locate` asks, for points that move while the body stays. */
export function locateHeld(asking: AsksHeld, point: Vec3, body: Body): Located {
  const found = asking.askHeld<{
    member: boolean;
    status: Status;
    coefficients?: readonly number[];
    separating_direction?: readonly Exact[];
    basis: readonly number[];
  }>("locate", holding(body), point);
  const { member, status, coefficients, separating_direction, basis } = found;
  const certificate = separating_direction ? { separating_direction } : { coefficients: coefficients ?? [], basis };
  return { member, status, certificate };
}

/** The steps of an algorithm that believes, and does not prove, where a point lies. */
export interface Belief {
  readonly belief: "intersecting" | "disjoint" | "gave_up";
  readonly steps: readonly {
    /** The direction in which the step looks; the body is shifted so that the point is the origin. */
    readonly direction: Vec3;
    /** The vertex that it finds there. */
    readonly vertex: Vec3;
    /** The point nearest to the origin of the simplex with this vertex; null in a step that is the last. */
    readonly nearest: Vec3 | null;
  }[];
}

/** The algorithm of Gilbert, Johnson and Keerthi in floating point. */
export function believe(asking: AsksHeld, point: Vec3, body: Body): Belief {
  return asking.askHeld("rival", holding(body), point);
}

export interface Gauge {
  readonly gauge: AnyNumber;
  readonly at_most_one: boolean;
}

/** The number of times that a body must be taken about its centre to reach a point. */
export function gauge(point: Vec3, body: Body): Question<Gauge> {
  return { entry: "answer", kind: "gauge", input: { p: body.center, q: point, generators: body.generators } };
}

export interface Meeting {
  readonly intersects: boolean;
  readonly status: Status;
  readonly certificate: LocationProof;
}

/** Whether two bodies meet. */
export function meet(a: Body, b: Body): Question<Meeting> {
  return { entry: "answer", kind: "intersect", input: { a, b } };
}

export interface Apart {
  readonly distance: number;
  readonly status: Status;
  readonly nearest: { readonly a: Vec3; readonly b: Vec3 };
  readonly features: { readonly a: string; readonly b: string };
  readonly penetration?: { readonly lower: number; readonly upper: number; readonly direction: Vec3 };
}

/** How far two bodies are apart, or how deep they overlap. */
export function apart(a: Body, b: Body): Question<Apart> {
  return { entry: "answer", kind: "distance", input: { a, b } };
}

export interface Counted {
  readonly affine_dim: number;
  readonly vertices: number;
  readonly edges: number;
  readonly facets: number;
  readonly facet_sizes: Readonly<Record<string, number>>;
  /** The exact volume, as a fraction. */
  readonly measure: string;
}

/** The numbers of faces of the body of these generators, and its volume. */
export function count(generators: readonly Vec3[]): Question<Counted> {
  return { entry: "answer", kind: "combinatorics", input: { generators } };
}

/** A turn about a line and a translation at the same time, both at constant rate. */
export interface Motion {
  readonly axis_point: Vec3;
  readonly axis: Vec3;
  readonly angle: number;
  readonly translation: Vec3;
}

export interface Interval {
  readonly from: number;
  readonly to: number;
  readonly frame: "space" | "a" | "b" | "edges";
  readonly direction: Vec3 | readonly [Vec3, Vec3];
}

export interface Collision {
  readonly status: "separate" | "contact" | "grazing";
  readonly time?: readonly [number, number];
  readonly certificate: { readonly intervals: readonly Interval[] };
}

/** When two moving bodies meet first during the step from 0 to 1, or that they do not. */
export function collide(a: Body, b: Body, motion: { a?: Motion; b?: Motion }): Question<Collision> {
  return { entry: "answer", kind: "collide", input: { a, b, motion } };
}

/** A zonotope around all placements of a body in a motion: Theorem 6.1, or one of the tighter methods. */
export function sweep(body: Body, motion: Motion, method: string): Question<Body> {
  return { entry: "answer", kind: "sweep", input: { ...body, ...motion }, method };
}

export interface Reduced extends Body {
  readonly hausdorff: { readonly lower: number; readonly upper: number };
}

/** A zonotope of at most so many generators around a body. */
export function reduce(body: Body, most: number, rule: string): Question<Reduced> {
  return { entry: "answer", kind: "reduce", input: { ...body, count: most, rule } };
}

/** A facet by its two generators, and the side on which it lies. */
export type FacetName = readonly [number, number, 1 | -1];

/** The four facets that have an edge in common with a facet. */
export function walk(generators: readonly Vec3[], facet: FacetName): Question<{ neighbours: readonly FacetName[] }> {
  return { entry: "answer", kind: "walk", input: { generators, facet } };
}

export interface Batch {
  readonly status: readonly Status[];
  /** Operations spent before the points, and on them. */
  readonly build: number;
  readonly query: number;
}

/** Where many points lie, by one of the methods that prepare the body or do not. */
export function locateMany(body: Body, points: readonly Vec3[], method: string): Question<Batch> {
  return { entry: "answer", kind: "member_batch", input: { ...body, points }, method };
}
