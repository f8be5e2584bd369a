/** The exercises of the chapter; the library marks them. */

import { PARALLEL, polar } from "../../data/bodies";
import type { Exercise } from "../../kit/chapter";
import { tiling } from "../../library/pictures";
import { count } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { first, TILING_AT_ONCE, type State } from "./state";

/** Six generators of which no three lie in a plane. */
const SIX: readonly Vec3[] = [
  [1, 0.2, 0.5],
  [0.4, 0.9, 0.6],
  [-0.7, 0.8, 0.8],
  [0.7, -0.5, 0.9],
  [-0.1, 0.15, 1.1],
  [0.3, -0.8, 0.4],
];

/** Five generators of whole numbers in general position: their sums are exact, those of decimals often are not. */
const WHOLE: readonly Vec3[] = [
  [2, 0, 1],
  [1, 2, 1],
  [-2, 1, 2],
  [-1, -2, 1],
  [1, -2, 3],
];

export const exercises: readonly Exercise<State>[] = [
  {
    id: "facets",
    title: "Count without looking",
    task:
      "<p>Six generators are in general position: no three lie in a plane. How many facets has " +
      "their zonohedron?</p>",
    reply: { number: "Facets" },
    check(reply, _, { ask }) {
      const { facets } = ask(count(SIX)).result;
      return {
        right: reply === facets,
        because:
          reply === facets
            ? "Each of the 15 pairs gives one facet above and one below."
            : "Count the pairs of generators. How often does each pair appear?",
      };
    },
  },
  {
    id: "parallel",
    title: "Twice the same direction",
    task:
      "<p>To the three generators of a cube a fourth is added, parallel to the first and half " +
      "as long. How many facets has the body?</p>",
    reply: { number: "Facets" },
    check(reply, _, { ask }) {
      const { facets } = ask(count(PARALLEL)).result;
      return {
        right: reply === facets,
        because:
          reply === facets
            ? "It is a longer box: parallel generators share their zone."
            : "Drag a cube along one of its own edges. What comes out?",
      };
    },
  },
  {
    id: "hexagon",
    title: "Make a hexagon",
    task: "<p>Change the generators so that one tile has six sides. Typing whole numbers is easier than dragging.</p>",
    reply: "figure",
    setting: () => ({ ...first(), generators: WHOLE, lit: null }),
    check(_, state, { ask }) {
      if (state.generators.length > TILING_AT_ONCE) return { right: false, because: "Take fewer generators." };
      const most = Math.max(0, ...ask(tiling(state.generators)).result.tiles.map((tile) => 2 * tile.classes.length));
      return {
        right: most >= 6,
        because:
          most >= 6
            ? `There is a tile with ${most} sides.`
            : "All tiles have four sides. Three generators must lie in one plane through the origin: " +
              "make the third the sum of two others, with whole numbers: 0.35 + 1 is not exactly 1.35 in a computer.",
      };
    },
  },
  {
    id: "cell",
    title: "From corner to cell",
    task:
      "<p>In the inside of a tiling three tiles meet in a corner. How many sides has the cell " +
      "of the arrangement that belongs to the corner?</p>",
    reply: { number: "Sides" },
    check(reply, _, { ask }) {
      const tiles = ask(tiling(SIX)).result;
      const sides = tiles.vertices.flatMap((_place, corner) => {
        const around = tiles.tiles.filter((tile) => tile.left.includes(corner) || tile.right.includes(corner)).length;
        const edges = tiles.edges.filter((edge) => edge.ends.includes(corner)).length;
        return around === 3 && edges === around ? [edges] : [];
      });
      const expected = sides[0] ?? 3;
      return {
        right: reply === expected,
        because:
          reply === expected
            ? "Each tile at the corner is a corner of the cell, and each edge at the corner a side of it."
            : "Light up such a corner in the tiling and look at the arrangement.",
      };
    },
  },
  {
    id: "polar",
    title: "The flattest arrangement",
    task:
      "<p>The generators of a polar zonohedron stand around a vertical axis, all with the same " +
      "slope. Where are their lines?</p>",
    reply: { choices: ["They all go through one point.", "They all touch one circle.", "They are all parallel."] },
    figure: "arrangement",
    setting: () => ({ ...first(), generators: polar(7, 0.8), sweep: 8, lit: null }),
    check(reply, _, { ask }) {
      const { classes } = ask(tiling(polar(7, 0.8))).result;
      const far = classes.flatMap(({ line }) => (line ? [Math.abs(line[2]) / Math.hypot(line[0], line[1])] : []));
      const circle = far.every((one) => Math.abs(one - (far[0] ?? 0)) < 1e-3);
      return {
        right: circle === (reply === 1),
        because: `Their distances from the origin are ${far.map((one) => one.toFixed(2)).join(", ")}.`,
      };
    },
  },
];
