/** The exercises of the chapter; the library marks them. */

import type { Exercise } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { alongDirections, leastLength } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";
import { directionsOf, EPSILON, first, type State } from "./state";

const SQUARE: readonly Vec2[] = [
  [0, 0],
  [2, 0],
  [2, 2],
  [0, 2],
];
const SEGMENT: readonly Vec2[] = [
  [0, 0],
  [3, 4],
];

export const exercises: readonly Exercise<State>[] = [
  {
    id: "segment",
    title: "Two points",
    task:
      "<p>What is the total length of the shortest zonogon around (0, 0) and (3, 4)? A " +
      "generator is half of its segment.</p>",
    reply: { number: "Length" },
    setting: () => ({ ...first(), points: SEGMENT }),
    check(reply, _, { ask }) {
      const { length } = ask(leastLength(SEGMENT, EPSILON)).result;
      const right = Math.abs(reply - length) < 0.01;
      return {
        right,
        because: right
          ? "One generator, half of the way from point to point."
          : "It is a segment with one generator. Remember the half.",
      };
    },
  },
  {
    id: "axes",
    title: "Two points along the axes",
    task: "<p>For the same two points the generators must now lie along the axes. What is the total length?</p>",
    reply: { number: "Length" },
    setting: () => ({ ...first(), points: SEGMENT, directions: 2, turn: 0 }),
    check(reply, _, { ask }) {
      const value =
        ask(
          alongDirections(SEGMENT, [
            [1, 0],
            [0, 1],
          ]),
        ).result.value ?? 0;
      const right = Math.abs(reply - value) < 0.01;
      return {
        right,
        because: right
          ? "Half of 3 and half of 4: a rectangle."
          : "The zonogon is a rectangle now. How long are its half sides?",
      };
    },
  },
  {
    id: "square",
    title: "A square that stands on a corner",
    task:
      "<p>Around the square with the corners (0, 0), (2, 0), (2, 2), (0, 2) the shortest " +
      "zonogon has the length 2. Two directions are turned by 45 degrees. How long is the " +
      "shortest zonogon along them?</p>",
    reply: { number: "Length" },
    setting: () => ({ ...first(), points: SQUARE, directions: 2, turn: 45 }),
    check(reply, _, { ask }) {
      const value =
        ask(
          alongDirections(SQUARE, [
            [Math.SQRT1_2, Math.SQRT1_2],
            [-Math.SQRT1_2, Math.SQRT1_2],
          ]),
        ).result.value ?? 0;
      const right = Math.abs(reply - value) < 0.01;
      return {
        right,
        because: right
          ? "Two generators of length √2: the larger square on its corner."
          : `The library says ${digits(value)}.`,
      };
    },
  },
  {
    id: "cheap",
    title: "Good directions",
    task:
      "<p>Choose at most four directions, and turn them, so that they cost less than one per " +
      "cent of length in the first figure. You may also move the points.</p>",
    reply: "figure",
    check(_, state, { ask }) {
      const along = ask(alongDirections(state.points, directionsOf(state))).result.value ?? Infinity;
      const best = ask(leastLength(state.points, EPSILON)).result.length;
      const right = state.directions <= 4 && along <= 1.01 * best;
      return {
        right,
        because: `${state.directions} directions give ${digits(along)}; all directions ${digits(best)}.`,
      };
    },
  },
];
