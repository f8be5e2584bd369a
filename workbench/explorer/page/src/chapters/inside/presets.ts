/** Questions to begin with. */

import type { Preset } from "../../kit/chapter";
import type { Vec3 } from "../../library/shapes";
import { CUBE, polar, RHOMBIC, TRUNCATED } from "../../data/bodies";
import { first, type State } from "./state";

const of = (generators: readonly Vec3[], point: Vec3, others: readonly Vec3[] = []): State => ({
  generators,
  many: 0,
  point,
  others,
  step: 0,
  rivalStep: 0,
});

/** A point beyond the face of the cube by the least that a double can be beyond 1. */
export const beyondByALastPlace = (): State => of(CUBE, [1 + Number.EPSILON, 0.3, 0.2]);

export const presets: readonly Preset<State>[] = [
  {
    name: "A point beside five generators",
    note: "Drag the point into the body, and the proof changes its kind.",
    make: first,
  },
  { name: "A point in a cube", note: "Its coefficients are its coordinates.", make: () => of(CUBE, [0.4, -0.7, 0.2]) },
  {
    name: "A corner of a cube",
    note: "The point is exactly a corner: on the boundary.",
    make: () => of(CUBE, [1, 1, 1]),
  },
  {
    name: "Beyond a face by 2⁻⁵²",
    note: "No double lies nearer to the face outside of it. The rival below is fooled.",
    make: beyondByALastPlace,
  },
  {
    name: "Two cubes that touch",
    note: "They share a part of a face, and not more.",
    make: () => of(CUBE, [2, 0.5, 0.5], CUBE),
  },
  {
    name: "Two cubes a hair apart",
    note: "The gap is one part in a million million; the answer is exact all the same.",
    make: () => of(CUBE, [2.000000000002, 0.5, 0.5], CUBE),
  },
  {
    name: "Rhombic dodecahedron and octahedron",
    note: "A rhombic dodecahedron and a truncated octahedron.",
    make: () => of(RHOMBIC, [4.6, 2.2, 1.4], TRUNCATED),
  },
  {
    name: "Two polar zonohedra",
    note: "Nine generators and seven.",
    make: () => of(polar(9, 0.7), [7.5, 3, 2], polar(7, 0.4)),
  },
  {
    name: "A flat body",
    note: "Two generators make a parallelogram in space; it has no inside, and a point in it is on the boundary.",
    make: () =>
      of(
        [
          [1, 0, 0.5],
          [0, 1, 0.2],
        ],
        [0.5, 0.5, 0.35],
      ),
  },
  { name: "A segment and a point", note: "One generator.", make: () => of([[1, 1, 1]], [0.5, 0.5, 0.6]) },
  {
    name: "Ten thousand generators",
    note: "The body has about a hundred million facets. It cannot be drawn, but the question is answered at once.",
    make: () => ({ ...first(), many: 10_000, point: [1900, 1000, 1500] }),
  },
];
