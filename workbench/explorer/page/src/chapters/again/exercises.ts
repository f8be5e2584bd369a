/** The exercises of the chapter; the library marks them. */

import { polar } from "../../data/bodies";
import type { Exercise } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { locateMany, reduce, walk, type FacetName } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { bodyOf, first, type State } from "./state";

const WALKED = polar(7, 0.65);

export const exercises: readonly Exercise<State>[] = [
  {
    id: "shared",
    title: "What stays, what goes",
    task:
      "<p>From a facet of the generators 1 and 3 the walk goes over one edge. How many " +
      "generators do the old and the new facet have in common?</p>",
    reply: { number: "Generators" },
    check(reply, _, { ask }) {
      const shared = ask(walk(WALKED, [0, 2, 1])).result.neighbours.map(
        ([i, j]) => [i, j].filter((one) => one === 0 || one === 2).length,
      );
      const right = shared.every((count) => count === reply);
      return {
        right,
        because: right
          ? "The edge between them belongs to one generator, and both facets lie in its zone."
          : "Two facets that share an edge lie in the same zone.",
      };
    },
  },
  {
    id: "round",
    title: "Once around",
    task:
      "<p>In the figure, walk along one zone until you stand on the facet opposite to the first " +
      "one: the same two generators, on the other side.</p>",
    reply: "figure",
    figure: "walk",
    setting: first,
    check(_, state) {
      const [begin, end] = [state.path[0], state.path[state.path.length - 1]] as [FacetName, FacetName];
      const right = begin[0] === end[0] && begin[1] === end[1] && begin[2] === -end[2];
      return {
        right,
        because: `You began on ${begin[0] + 1} and ${begin[1] + 1} and made ${state.path.length - 1} steps.`,
      };
    },
  },
  {
    id: "close",
    title: "Close enough",
    task:
      "<p>Choose a rule and as few generators as you can, such that the distance to the body is " +
      "at most a tenth of the longest generator's length times the number of generators. At " +
      "most six generators are allowed.</p>",
    reply: "figure",
    setting: () => ({ ...first(), most: 3, rule: "girard" }),
    check(_, state, { ask }) {
      const { hausdorff } = ask(reduce(bodyOf(state), state.most, state.rule)).result;
      const longest = Math.max(...state.generators.map((one) => Math.hypot(...one)));
      const goal = 0.1 * longest * state.generators.length;
      return {
        right: hausdorff.upper <= goal && state.most <= 6,
        because:
          `The distance is at most ${digits(hausdorff.upper)}, the goal ${digits(goal)}, with ` +
          `${state.most} generators.`,
      };
    },
  },
  {
    id: "tree",
    title: "Does the tree pay?",
    task: "<p>For 800 generators and forty points: which needs fewer operations for each point?</p>",
    reply: { choices: ["Asking without preparation", "The tree over directions"] },
    check(reply, state, { ask }) {
      const generators = Array.from(
        { length: 800 },
        (_, index): Vec3 => [Math.cos(index * 2.4), Math.sin(index * 2.4), ((index * 37) % 97) / 48 - 1],
      );
      const points = Array.from(
        { length: 40 },
        (_, index): Vec3 => [300 * Math.cos(index), 300 * Math.sin(index), 100],
      );
      const body = { ...bodyOf(state), generators };
      const [plain, tree] = ["by_lad", "by_direction_tree"].map(
        (method) => ask(locateMany(body, points, method)).result.query,
      ) as [number, number];
      return {
        right: tree < plain === (reply === 1),
        because: `${digits(plain / 40)} operations without, ${digits(tree / 40)} with the tree.`,
      };
    },
  },
];
