/** Motions to begin with. */

import { CUBE, polar, randomGenerators, RHOMBIC } from "../../data/bodies";
import type { Preset } from "../../kit/chapter";
import { scale3 } from "../../kit/vectors";
import type { Motion } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { first, REST, type Scene, type State } from "./state";

const smaller = (generators: readonly Vec3[], factor: number) => generators.map((one) => scale3(one, factor));

const about = (axis_point: Vec3, axis: Vec3, angle: number, translation: Vec3): Motion => ({
  axis_point,
  axis,
  angle,
  translation,
});

const of = (scene: Scene): State => ({ ...first(), scene, time: 0 });

export const presets: readonly Preset<State>[] = [
  { name: "A bar and a stone", note: "The bar turns and flies past.", make: first },
  {
    name: "A thin plate through a gap in time",
    note: "Between two samples the plate has passed through the post.",
    make: () =>
      of({
        a: {
          center: [-2, 0, 0],
          generators: [
            [0.05, 0, 0],
            [0, 0.8, 0],
            [0, 0, 0.8],
          ],
        },
        b: {
          center: [0.23, 0, 0],
          generators: [
            [0.05, 0, 0],
            [0, 0.1, 0],
            [0, 0, 1],
          ],
        },
        moves: { a: { ...REST, translation: [4, 0, 0] }, b: REST },
      }),
  },
  {
    name: "Two cubes face to face",
    note: "A shift alone: they touch at the time 3/4.",
    make: () =>
      of({
        a: { center: [0, 0, 0], generators: CUBE },
        b: { center: [5, 0, 0], generators: CUBE },
        moves: { a: { ...REST, translation: [4, 0, 0] }, b: REST },
      }),
  },
  {
    name: "Two gears",
    note: "Polar zonohedra that turn beside each other.",
    make: () =>
      of({
        a: { center: [-2.05, 0, 0], generators: smaller(polar(5, 0.4), 0.55) },
        b: { center: [2.05, 0, 0], generators: smaller(polar(5, 0.4), 0.55) },
        moves: {
          a: about([-2.05, 0, 0], [0, 0, 1], 3.1, [0.15, 0, 0]),
          b: about([2.05, 0, 0], [0, 0, 1], -3.1, [0, 0, 0]),
        },
      }),
  },
  {
    name: "Rhombic dodecahedra that tumble",
    note: "Both turn about slanted axes.",
    make: () =>
      of({
        a: { center: [-2.4, 0, 0], generators: smaller(RHOMBIC, 0.5) },
        b: { center: [1.4, 1.6, 0], generators: smaller(RHOMBIC, 0.4) },
        moves: {
          a: about([-2.4, 0, 0], [1, 1, 0.2], 2.8, [3.2, -0.8, 0.4]),
          b: about([1.4, 1.6, 0], [0, 1, 1], 2.2, [0, 0.4, 0]),
        },
      }),
  },
  {
    name: "Thirty generators each",
    note: "870 facets each; the test counts its frames here.",
    make: () =>
      of({
        a: { center: [-1.6, 0, 0], generators: smaller(randomGenerators(3, 30), 0.09) },
        b: { center: [1.6, 0.5, 0], generators: smaller(randomGenerators(4, 30), 0.09) },
        moves: {
          a: about([-1.6, 0, 0], [1, 0.3, 0.6], 3, [0.5, -0.6, 0]),
          b: about([1.6, 0.5, 0], [0.2, 1, 0.4], 3, [-0.2, 0.4, 0]),
        },
      }),
  },
  {
    name: "At rest",
    note: "Nothing moves: one interval, one direction.",
    make: () => of({ ...first().scene, moves: { a: REST, b: REST } }),
  },
];
