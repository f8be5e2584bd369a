/** The links between the three views: tile, crossing and facet; corner, cell and vertex; line and zone. */

import { dot3, sub3 } from "../../kit/vectors";
import { zoneColour } from "../../kit/zone_colours";
import type { Faces, Tiling } from "../../library/pictures";
import type { Vec2, Vec3 } from "../../library/shapes";
import type { Lit } from "./state";

/** The colour of a class of parallel generators: that of its first one. */
export function classColour(tiling: Tiling, index: number): string {
  return zoneColour(tiling.classes[index]?.generators[0] ?? 0);
}

/** The tile of a facet, or null for facets of the lower hull and vertical ones. */
export function tileOfFacet(tiling: Tiling, facet: number): number | null {
  const found = tiling.tiles.findIndex((tile) => tile.facet === facet);
  return found < 0 ? null : found;
}

/** The vertex of the body at a corner of the tiling. */
export function vertexOfCorner(faces: Faces, tiling: Tiling, corner: number): number | null {
  const place = tiling.vertices[corner];
  if (!place) return null;
  let [best, distance] = [0, Infinity];
  faces.vertices.forEach((vertex, index) => {
    const apart = sub3(vertex, place);
    const size = dot3(apart, apart);
    if (size < distance) [best, distance] = [index, size];
  });
  return best;
}

/** Half-planes d · (x, y, 1) ≥ 0 whose common part is the cell of a corner. */
export function cellSides(tiling: Tiling, corner: number): Vec3[] {
  return tiling.edges.flatMap(({ ends: [one, other] }) => {
    if (one !== corner && other !== corner) return [];
    const [here, there] = one === corner ? [one, other] : [other, one];
    return [sub3(tiling.vertices[here] as Vec3, tiling.vertices[there] as Vec3)];
  });
}

export function inCell(sides: readonly Vec3[], [x, y]: Vec2): boolean {
  return sides.every((side) => dot3(side, [x, y, 1]) >= 0);
}

/** The part of a polygon on the side d · (x, y, 1) ≥ 0. */
export function clipped(polygon: readonly Vec2[], side: Vec3): Vec2[] {
  const value = ([x, y]: Vec2) => dot3(side, [x, y, 1]);
  return polygon.flatMap((from, place) => {
    const to = polygon[(place + 1) % polygon.length] as Vec2;
    const [here, there] = [value(from), value(to)];
    const kept = here >= 0 ? [from] : [];
    if (here >= 0 === there >= 0) return kept;
    const part = here / (here - there);
    return [...kept, [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])] as Vec2];
  });
}

/** The tiles that are lit up: the tile itself, those at the corner, those of the class. */
export function litTiles(tiling: Tiling, lit: Lit | null): ReadonlySet<number> {
  if (!lit) return new Set();
  if (lit.kind === "tile") return new Set([lit.index]);
  const chosen = tiling.tiles.flatMap((tile, index) => {
    const corners = [...tile.left, ...tile.right];
    const meant = lit.kind === "class" ? tile.classes.includes(lit.index) : corners.includes(lit.index);
    return meant ? [index] : [];
  });
  return new Set(chosen);
}

/** The separator with so many tiles on its left, from top to bottom, as corners of the tiling. */
export function separator(tiling: Tiling, rank: number): number[] {
  const chain = [...tiling.left_side];
  for (const { left, right } of tiling.tiles.slice(0, rank)) {
    const from = chain.indexOf(left[0] as number);
    if (from >= 0) chain.splice(from, left.length, ...right);
  }
  return chain;
}
