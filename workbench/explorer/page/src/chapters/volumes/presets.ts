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
    make: () => of("ring", [0.95, -0.3, -0.2], 90, { level: 4 }),
  },
  {
    name: "Balls",
    note: "Bodies with volume, a twentieth of their size apart: here zonotopes pay.",
    make: () => of("ball", [2.02, 0.3, 0.3], 40, { level: 2 }),
  },
  {
    name: "Angles",
    note: "Bodies of flat faces along the axes: a box fits them, turned or not, until one of them is turned.",
    make: () => of("angle", [1.9, 0.9, 0.5], 115, { level: 2, volume: "obb" }),
  },
  {
    name: "Needles",
    note: "Long and thin: a box that is turned is nearly the best there is.",
    make: () => of("needle", [0.4, 0.2, -0.3], 70, { level: 3, volume: "obb" }),
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
