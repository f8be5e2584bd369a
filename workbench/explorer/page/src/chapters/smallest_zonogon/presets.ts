/** Points to begin with: the paper's, regular, degenerate ones, and outlines of countries. */

import croatia from "../../../../../../experiments/data/outline_croatia.csv";
import iceland from "../../../../../../experiments/data/outline_iceland.csv";
import italy from "../../../../../../experiments/data/outline_italy.csv";
import type { Preset } from "../../kit/chapter";
import { randoms, tidy } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import { first, type State } from "./state";

function around(points: readonly Vec2[], center?: Vec2): State {
  const middle: Vec2 = [mean(points, 0) + 0.1 * spread(points, 0), mean(points, 1) + 0.07 * spread(points, 1)];
  return { ...first(), points, center: center ?? [tidy(middle[0]), tidy(middle[1])] };
}

const mean = (points: readonly Vec2[], axis: 0 | 1) =>
  points.reduce((sum, point) => sum + point[axis], 0) / points.length;
const spread = (points: readonly Vec2[], axis: 0 | 1) => {
  const values = points.map((point) => point[axis]);
  return Math.max(...values) - Math.min(...values);
};

function regular(count: number, radius: number): Vec2[] {
  return Array.from({ length: count }, (_, index): Vec2 => {
    const angle = (2 * Math.PI * index) / count + 0.3;
    return [tidy(radius * Math.cos(angle)), tidy(radius * Math.sin(angle))];
  });
}

function outline(table: string): Vec2[] {
  const rows = table.trim().split("\n").slice(1);
  return rows.map((row) => row.split(",").map(Number) as unknown as Vec2);
}

export function randomPoints(seed: number, count: number): Vec2[] {
  const random = randoms(seed);
  return Array.from({ length: count }, (): Vec2 => {
    const [angle, far] = [2 * Math.PI * random(), 3 * Math.sqrt(random())];
    return [tidy(far * Math.cos(angle)), tidy(far * Math.sin(angle))];
  });
}

export const presets: readonly Preset<State>[] = [
  { name: "Nine points", note: "Eight of them are corners of the hull; the one inside changes nothing.", make: first },
  {
    name: "Triangle",
    note: "Every centre in the triangle of the middles of its sides is a best one.",
    make: () =>
      around([
        [0, 0],
        [4, 0],
        [1, 3],
      ]),
  },
  {
    name: "Square",
    note: "It is a zonogon itself. All four lines meet in its middle.",
    make: () =>
      around([
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]),
  },
  {
    name: "Regular pentagon",
    note: "The five lines make a small pentagon. Show the level sets of f.",
    make: () => around(regular(5, 2)),
  },
  {
    name: "Regular heptagon",
    note: "The more corners, the less area a zonogon must add.",
    make: () => around(regular(7, 2)),
  },
  {
    name: "Two wings, as in Figure 2",
    note: "Long runs of points and of reflections alternate.",
    make: () =>
      around(
        [
          [0, 0],
          [3, -0.8],
          [5.5, -0.6],
          [6.3, 0.6],
          [5.6, 2.1],
          [2.4, 2.6],
          [0.8, 2],
        ],
        [3.1, 1.1],
      ),
  },
  {
    name: "Three points on a line",
    note: "The points have no area, and neither has the zonogon: it is a segment.",
    make: () =>
      around([
        [0, 0],
        [1, 0.5],
        [4, 2],
      ]),
  },
  {
    name: "One point",
    note: "The smallest zonogon around one point is the point.",
    make: () => around([[1, 1]], [1.5, 1.5]),
  },
  {
    name: "200 points on a circle",
    note: "All of them are corners, so there are 200 lines.",
    make: () => around(regular(200, 3)),
  },
  {
    name: "Italy",
    note: "Longitude and latitude in degrees, taken as coordinates of the plane.",
    make: () => around(outline(italy)),
  },
  { name: "Croatia", note: "A country that leaves much of its hull empty.", make: () => around(outline(croatia)) },
  { name: "Iceland", note: "Close to its smallest zonogon.", make: () => around(outline(iceland)) },
];
