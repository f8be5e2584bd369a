/** The exercises of the chapter; the library marks them. */

import type { Exercise } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { areaAlong, centeredZonogon } from "../../library/pictures";
import { leastArea } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";
import { first, type State } from "./state";

const TRIANGLE: readonly Vec2[] = [
  [0, 0],
  [4, 0],
  [1, 3],
];
const HEXAGON: readonly Vec2[] = [
  [2, 0],
  [1, 2],
  [-1, 2],
  [-2, 0],
  [-1, -2],
  [1, -2],
];
const MIDDLES: readonly Vec2[] = [
  [2, 0],
  [2.5, 1.5],
  [0.5, 1.5],
  [1.7, 1],
];

/** The part by which an area may exceed the least one in the exercise on finding the centre. */
const CLOSE = 0.01;

/** The part by which a zonogon may exceed the hull that it is to be: keys and pointers move by whole pixels. */
const SPARE = 0.005;

/** The part by which a number of the reader may be off. */
const ROUNDING = 0.005;

export const exercises: readonly Exercise<State>[] = [
  {
    id: "by-hand",
    title: "Find the centre by hand",
    task:
      "<p>Drag <i class='math'>O</i> until the area of <i class='math'>Z(O)</i> is within one " +
      "per cent of the least area. Do not use the button. The graph along the line tells you " +
      "which way is down.</p>",
    reply: "figure",
    setting: first,
    check(_, state, { ask }) {
      const area = ask(centeredZonogon(state.points, state.center)).result.area;
      const least = Number(ask(leastArea(state.points)).result.area);
      const right = area <= least * (1 + CLOSE);
      return { right, because: `The area is ${digits(area)}, the least one ${digits(least)}.` };
    },
  },
  {
    id: "triangle",
    title: "Around a triangle",
    task:
      "<p>A triangle has the corners (0, 0), (4, 0) and (1, 3), and the area 6. What is the " +
      "area of the smallest zonogon around it?</p>",
    reply: { number: "Area" },
    setting: () => ({ ...first(), points: TRIANGLE, center: [3, 2] }),
    check(reply, _, { ask }) {
      const least = Number(ask(leastArea(TRIANGLE)).result.area);
      const right = Math.abs(reply - least) <= ROUNDING * least;
      return right
        ? {
            right,
            because:
              "It is twice the triangle: a triangle and its reflection in the middle of a side make a parallelogram.",
          }
        : { right, because: "Reflect the triangle in the middle of one of its sides. Which polygon do the two make?" };
    },
  },
  {
    id: "plateau",
    title: "More than one best centre",
    task:
      "<p>In the same triangle, <i class='math'>O</i> goes from the middle of one side to the " +
      "middle of another. What does the area of <i class='math'>Z(O)</i> do on the way?</p>",
    reply: { choices: ["It grows, then falls.", "It falls, then grows.", "It stays the same."] },
    setting: () => ({ ...first(), points: TRIANGLE, center: [2, 0] }),
    check(reply, _, { ask }) {
      const areas = MIDDLES.map((center) => ask(centeredZonogon(TRIANGLE, center)).result.area);
      const same = areas.every((area) => Math.abs(area - (areas[0] ?? 0)) <= 1e-9);
      const right = same === (reply === 2);
      return {
        right,
        because:
          "At the three middles, and at a point between them, the area is " +
          `${areas.map((area) => digits(area)).join(", ")}. Every centre in the triangle of the ` +
          "middles is a best one.",
      };
    },
  },
  {
    id: "bends",
    title: "Which way does it bend?",
    task: "<p>Along a line, <i class='math'>f</i> has slopes from left to right. How do they change at the bends?</p>",
    reply: {
      choices: [
        "The slopes always increase.",
        "The slopes always decrease.",
        "They increase at some bends and decrease at others.",
      ],
    },
    check(reply, state, { ask }) {
      const { at, area } = ask(areaAlong(state.points, [-50, -20], [50, 30])).result;
      const slopes = at
        .slice(1)
        .map((t, index) => ((area[index + 1] ?? 0) - (area[index] ?? 0)) / (t - (at[index] ?? 0)));
      const rising = slopes.every(
        (slope, index) => index === 0 || slope >= (slopes[index - 1] ?? 0) - 1e-6 * Math.abs(slope),
      );
      const right = rising === (reply === 0);
      return {
        right,
        because: `On a long line through your figure the slopes are ${slopes
          .slice(0, 8)
          .map((slope) => digits(slope, 3))
          .join(", ")}${slopes.length > 8 ? ", …" : ""}.`,
      };
    },
  },
  {
    id: "symmetric",
    title: "Nothing to gain",
    task:
      "<p>Put at least five points so that the smallest zonogon around them is their own hull, " +
      "with no area to spare.</p>",
    reply: "figure",
    setting: () => ({
      ...first(),
      points: HEXAGON.map(([x, y], index): Vec2 => (index === 0 ? [x + 0.8, y] : [x, y])),
      center: [0, 0],
    }),
    check(_, state, { ask }) {
      const least = ask(leastArea(state.points)).result;
      const corners = least.certificate.hull.map((index) => state.points[index] as Vec2);
      const area = corners.reduce((sum, [x, y], index) => {
        const [u, v] = corners[(index + 1) % corners.length] as Vec2;
        return sum + (x * v - u * y) / 2;
      }, 0);
      if (state.points.length < 5 || area === 0)
        return { right: false, because: "Take at least five points that do not lie on a line." };
      const right = Number(least.area) <= area * (1 + SPARE);
      return {
        right,
        because:
          `The hull has the area ${digits(area)}, the smallest zonogon ` +
          `${digits(Number(least.area))}. They agree when the hull looks the same after half a ` +
          "turn.",
      };
    },
  },
];
