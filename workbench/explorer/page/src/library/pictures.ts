/** Questions for pictures: places and faces, as the library finds them. Indices count from 0. */

import type { Question } from "../engine/questions";
import type { AnyNumber, Body, Status, Vec2, Vec3 } from "./shapes";

function picture<Result>(kind: string, input: unknown): Question<Result> {
  return { entry: "columns", kind, input };
}

export interface CenteredZonogon {
  readonly area: number;
  /**
   * The vertices of the convex hull as indices of points, counter-clockwise; edge t leads from vertex t to the
   * next.
   */
  readonly hull: readonly number[];
  /** For each edge of the hull, the place in `hull` of a vertex farthest from it. */
  readonly farthest: readonly number[];
  /** For each edge of the hull its line ℓ_t, by two points. */
  readonly lines: readonly (readonly [Vec2, Vec2])[];
  readonly boundary: readonly { readonly point: Vec2; readonly source: number; readonly reflected: boolean }[];
}

/** The smallest zonogon Z(O) around points with a given centre. */
export function centeredZonogon(points: readonly Vec2[], center: Vec2): Question<CenteredZonogon> {
  return picture("centered_zonogon", { points, center });
}

/** The vertices of the zonogon of a centre and generators, counter-clockwise. */
export function zonogon(center: Vec2, generators: readonly Vec2[]): Question<{ vertices: readonly Vec2[] }> {
  return picture("zonogon", { center, generators });
}

/** The polygons on which the area of Z(O) is at most a level. */
export function levelSets(
  points: readonly Vec2[],
  levels: readonly number[],
): Question<{ polygons: readonly (readonly Vec2[])[] }> {
  return picture("level_sets", { points, levels });
}

/** The area of Z(O) for O on a segment: at its ends, and wherever it bends. */
export function areaAlong(
  points: readonly Vec2[],
  from: Vec2,
  to: Vec2,
): Question<{ at: readonly number[]; area: readonly number[] }> {
  return picture("area_along", { points, from, to });
}

export interface AreaSearch {
  readonly hull: readonly number[];
  readonly lines: readonly (readonly [Vec2, Vec2])[];
  /** The vertices of the arrangement; absent where there are too many of them. */
  readonly vertices?: readonly Vec2[];
  readonly steps: readonly {
    readonly x: number;
    readonly candidates: number;
    readonly left: number;
    readonly minimum: Vec2 | null;
    readonly side: "left" | "right" | "optimal" | "unbounded";
  }[];
}

/** The search of Theorem 4.5, step by step. */
export function areaSearch(points: readonly Vec2[]): Question<AreaSearch> {
  return picture("search_of_theorem_4_5", { points });
}

export interface Pruning {
  /** The cells in the order in which they are drawn, those for samples included: the lines before it, those that
   * cross it, its corners. */
  readonly cells: readonly {
    readonly lines: readonly number[];
    readonly crossing: readonly number[];
    readonly corners: readonly Vec2[];
  }[];
}

/** The search by pruning: cells around the best centre, and the few lines that cross them. */
export function pruning(points: readonly Vec2[], limit: number): Question<Pruning> {
  return picture("pruning", { points, line_search_limit: limit });
}

export interface Faces {
  readonly dimension: number;
  readonly vertices: readonly Vec3[];
  /** The vertices of each facet, counter-clockwise from outside. */
  readonly facets: readonly (readonly number[])[];
  /** For each facet the zones that run over it. */
  readonly facet_zones: readonly (readonly number[])[];
  readonly opposite_facets: readonly number[];
  readonly edges: readonly { readonly ends: readonly [number, number]; readonly zone: number }[];
  /** The generators of each zone: those that are parallel. */
  readonly zones: readonly (readonly number[])[];
  /** Columns without rows, of bodies with facets: the ends of all edges one after the other. */
  readonly flat: { readonly "edges.ends"?: ArrayLike<number> };
}

/** The faces of a body. */
export function faces(body: Body): Question<Faces> {
  return picture("faces", { center: body.center, generators: body.generators });
}

export interface Tiling {
  readonly dimension: number;
  /** Parallel generators are one class, with one line a x + b y + c = 0; vertical ones have none. */
  readonly classes: readonly { readonly generators: readonly number[]; readonly line: Vec3 | null }[];
  readonly zero: readonly number[];
  /** The vertices of the upper hull; the tiling is their shadow. */
  readonly vertices: readonly Vec3[];
  readonly edges: readonly {
    readonly class: number;
    readonly ends: readonly [number, number];
    readonly tiles: readonly [number | null, number | null];
  }[];
  /** In the order of the sweep. A tile lies between two chains, from its top to its bottom vertex. */
  readonly tiles: readonly {
    readonly classes: readonly number[];
    readonly left: readonly number[];
    readonly right: readonly number[];
    readonly dual: Vec2;
    /** The facet among the faces of the same generators. */
    readonly facet: number;
  }[];
  readonly left_side: readonly number[];
}

/** The corners of a tile in order around it. */
export function outline(tile: Tiling["tiles"][number]): number[] {
  return [...tile.left, ...[...tile.right].reverse().slice(1, -1)];
}

/** The tiling of the upper hull's shadow, and the arrangement dual to it. */
export function tiling(generators: readonly Vec3[]): Question<Tiling> {
  return picture("tiling", { generators });
}

export interface LocationSearch {
  readonly status: Status;
  readonly steps: readonly {
    readonly hull: "upper" | "lower";
    readonly x: number;
    readonly tiles: number;
    readonly left: number;
    readonly side: "left" | "right" | "within";
    readonly chains: readonly [readonly Vec2[], readonly Vec2[]];
  }[];
  readonly found: readonly {
    readonly hull: "upper" | "lower";
    readonly generators: readonly number[];
    readonly corners: readonly Vec2[];
    readonly depth: number;
  }[];
}

/** The search of Theorem 5.2 for the tiles above and below a point. */
export function locationSearch(point: Vec3, body: Body): Question<LocationSearch> {
  return picture("search_of_theorem_5_2", { point, center: body.center, generators: body.generators });
}

export interface PlaneOfDirections {
  readonly displacement: Vec3;
  readonly origin: Vec3;
  readonly axes: readonly [Vec3, Vec3];
  /** a s + b t + c = 0 for the directions u = origin + s axes[0] + t axes[1] orthogonal to a generator. */
  readonly lines: readonly Vec3[];
  /** The lowest point; null where the reach falls without end, or is zero. */
  readonly optimum: Vec2 | null;
  /** One divided by the reach at the optimum. */
  readonly gauge: AnyNumber;
}

/** The directions u with u · p = 1, in which the kernel looks for the one in which the body reaches least. */
export function planeOfDirections(point: Vec3, body: Body): Question<PlaneOfDirections> {
  return picture("plane_of_directions", { point, center: body.center, generators: body.generators });
}

export interface CuttingAndImage {
  /** The most lines that cross a trapezoid. */
  readonly limit: number;
  /** The part of the plane that the trapezoids are clipped to, from its lowest to its highest corner. */
  readonly window: readonly [Vec2, Vec2];
  readonly trapezoids: readonly (readonly Vec2[])[];
  /** For each tile the trapezoid of each corner: that which holds the face of the corner near the tile's crossing. */
  readonly images: readonly (readonly (number | null)[])[];
}

/** A (1/r)-cutting of the lines of generators, and its image in their tiling. */
export function cutting(generators: readonly Vec3[], r: number): Question<CuttingAndImage> {
  return picture("cutting", { generators, r });
}

/** The generators of each leaf of the tree over directions. */
export function directionTree(
  generators: readonly Vec3[],
): Question<{ readonly leaves: readonly (readonly number[])[] }> {
  return picture("direction_tree", { generators });
}

export interface HierarchyOfTwo {
  /** The bodies around each body, the coarsest first; the last is the body itself. */
  readonly a: readonly Body[];
  readonly b: readonly Body[];
  readonly status: Status;
  /** The level of each body at which it was decided whether they meet, from 0. */
  readonly levels: readonly [number, number];
  /** Pairs of levels that were looked at. */
  readonly visited: number;
  readonly generators_read: number;
}

/** The levels of two bodies, and how far down it is decided whether they meet. */
export function hierarchy(a: Body, b: Body): Question<HierarchyOfTwo> {
  return picture("hierarchy", { a, b });
}
