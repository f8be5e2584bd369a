/** Generators to begin with: bodies with names, the paper's figure, special positions. */

import { CUBE, ICOSAHEDRAL, PARALLEL, polar, randomGenerators, RHOMBIC, TRUNCATED } from "../../data/bodies";
import type { Preset } from "../../kit/chapter";
import type { Vec3 } from "../../library/shapes";
import { first, type State } from "./state";

const of = (generators: readonly Vec3[], sweep = 2): State => ({ generators, sweep, lit: null });

export const presets: readonly Preset<State>[] = [
  { name: "Five generators", note: "In general position: 10 tiles, 20 facets.", make: first },
  {
    name: "Cube",
    note: "Seen straight from above it is a square: one tile, and the third generator is vertical.",
    make: () => of(CUBE, 1),
  },
  {
    name: "Tilted cube",
    note: "Three tiles, three lines that form a triangle.",
    make: () =>
      of(
        [
          [1, 0, 0.6],
          [-0.5, 0.9, 0.6],
          [-0.5, -0.9, 0.6],
        ],
        1,
      ),
  },
  {
    name: "Rhombic dodecahedron",
    note: "Twelve rhombi; its generators are the diagonals of a cube.",
    make: () => of(RHOMBIC),
  },
  {
    name: "Truncated octahedron",
    note: "Four triples of its generators lie in planes: eight hexagons.",
    make: () => of(TRUNCATED),
  },
  { name: "Rhombic triacontahedron", note: "Thirty rhombi, six generators.", make: () => of(ICOSAHEDRAL) },
  {
    name: "Polar zonohedron of 7",
    note: "Its lines all touch one circle; from above it looks like a flower.",
    make: () => of(polar(7, 0.8), 10),
  },
  { name: "Polar zonohedron of 16", note: "Sixteen generators, 240 facets.", make: () => of(polar(16, 0.6), 40) },
  {
    name: "Parallel generators",
    note: "The first and the fourth share their line and their zone.",
    make: () => of(PARALLEL, 1),
  },
  {
    name: "Three in a plane",
    note: "The lines of the first three meet in one point, and their tile has six sides.",
    make: () =>
      of(
        [
          [1, 0, 0.5],
          [0, 1, 0.5],
          [1, 1, 1],
          [0.5, -0.6, 0.8],
        ],
        1,
      ),
  },
  {
    name: "All in one plane",
    note: "The body is flat, a zonogon in space; seen from above it is one tile.",
    make: () =>
      of(
        [
          [1, 0, 0.3],
          [0, 1, 0.2],
          [1, 1, 0.5],
        ],
        0,
      ),
  },
  { name: "One generator", note: "A segment, without any tile.", make: () => of([[1, 0.5, 0.4]], 0) },
  { name: "Twenty at random", note: "190 tiles.", make: () => of(randomGenerators(5, 20), 95) },
  {
    name: "Sixty at random",
    note: "3,540 facets; the tiling is computed when you let go.",
    make: () => of(randomGenerators(6, 60), 900),
  },
];
