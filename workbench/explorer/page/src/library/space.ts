/** Questions about zonotopes of space (Sections 3, 5 and 6). */

import type { Question } from "../engine/questions";
import type { AnyNumber, Body, LocationProof, Status, Vec3 } from "./shapes";

export interface Located {
  readonly member: boolean;
  readonly status: Status;
  readonly certificate: LocationProof;
}

/** Whether a point lies in a body. */
export function locate(point: Vec3, body: Body): Question<Located> {
  return { entry: "answer", kind: "member", input: { point, center: body.center, generators: body.generators } };
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
