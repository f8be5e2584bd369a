/** Meshes and places to begin with. */

import type { Preset } from "../../kit/chapter";
import type { Vec3 } from "../../library/shapes";
import { first, type State } from "./state";

const of = (shape: string, place: Vec3, turn: number, part: Partial<State> = {}): State => ({
  ...first(),
  shape,
  place,
  turn,
  ...part,
});

export const presets: readonly Preset<State>[] = [
  { name: "Rings", note: "Two rings, the second beside the first.", make: first },
  {
    name: "Linked rings",
    note: "One ring passes through the other and does not touch it: whatever volumes are around them overlap.",
    make: () => of("ring", [0.41, -0.84, 0.2], 120, { level: 4 }),
  },
  {
    name: "Balls",
    note: "Bodies with volume, a twentieth of their size apart: here zonotopes pay.",
    make: () => of("ball", [2.02, 0.3, 0.3], 40, { level: 2 }),
  },
  {
    name: "Angles",
    note: "Flat faces along the axes: boxes fit, and more generators change nothing.",
    make: () => of("angle", [-0.27, -0.57, -1.36], 55, { level: 2, volume: "obb" }),
  },
  {
    name: "Needles",
    note: "Long and thin: boxes turned as they fit, and polytopes of fixed normals, do as well.",
    make: () => of("needle", [0.33, 0.15, -0.09], -25, { level: 3, volume: "obb" }),
  },
  {
    name: "Plates",
    note: "Flat faces that lean: parallelepipeds are enough.",
    make: () => of("plate", [0.9, -0.3, 0.5], 20, { level: 3, volume: "zonotope_3" }),
  },
  {
    name: "Overlapping balls",
    note: "They meet: whatever the volume, the search goes down to triangles that meet.",
    make: () => of("ball", [1.2, 0.2, 0.1], 40, { level: 2 }),
  },
];
