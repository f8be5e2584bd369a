/** The separator in space: its steps on the front of the body, and those on its back, which look fainter. */

import { normalOf, solidOf } from "../../kit/solid";
import { dot3 } from "../../kit/vectors";
import type { Faces, Tiling } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { separator, vertexOfCorner } from "./links";

export interface SeenLine {
  readonly points: readonly Vec3[];
  readonly look: string;
}

/**
 * The steps of a separator as lines. Their look is found anew whenever it is asked for, because the view may have been
 * turned since.
 */
export function separatorLines(faces: Faces, tiling: Tiling, rank: number, gaze: () => Vec3): SeenLine[] {
  const corners = separator(tiling, rank);
  const vertices = corners.map((corner) => vertexOfCorner(faces, tiling, corner) ?? 0);
  const name = (one: number, other: number) => Math.min(one, other) * faces.vertices.length + Math.max(one, other);
  const normals = new Map<number, Vec3[]>();
  vertices.slice(1).forEach((vertex, step) => normals.set(name(vertices[step] as number, vertex), []));
  const shape = solidOf(faces);
  for (const facet of faces.facets) {
    facet.forEach((vertex, place) => {
      const next = facet[(place + 1) % facet.length] as number;
      normals.get(name(vertex, next))?.push(normalOf(shape, facet));
    });
  }
  return vertices.slice(1).map((vertex, step) => {
    const sides = normals.get(name(vertices[step] as number, vertex)) ?? [];
    const points = [corners[step], corners[step + 1]].map((corner) => tiling.vertices[corner as number] as Vec3);
    return {
      points,
      get look() {
        const isBehind = sides.length > 0 && sides.every((normal) => dot3(normal, gaze()) > ROUNDING);
        return isBehind ? "thin dashed" : "sweep";
      },
    };
  });
}

/** The cosine that counts as a right angle: a facet that is seen from its edge hides nothing. */
const ROUNDING = 1e-9;
