/** The exercises of the chapter; the library marks them. */

import type { Exercise } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { believe, gauge, locate, meet } from "../../library/space";
import type { Body, Vec3 } from "../../library/shapes";
import { CUBE, RHOMBIC } from "../../data/bodies";
import { beyondByALastPlace } from "./presets";
import { beliefWords } from "./rival_figure";
import { bodyOf, first, otherOf, question, sumOf, type State } from "./state";

const cube: Body = { center: [0, 0, 0], generators: CUBE };
const POINT: Vec3 = [1.5, -0.5, 0.5];

export const exercises: readonly Exercise<State>[] = [
  {
    id: "gauge",
    title: "How many times the cube?",
    task:
      "<p>The cube has the generators (1, 0, 0), (0, 1, 0), (0, 0, 1) and the centre 0. How " +
      "many times must it be taken to reach the point (1.5, −0.5, 0.5)?</p>",
    reply: { number: "Gauge" },
    setting: () => ({ ...first(), generators: CUBE, point: POINT }),
    check(reply, _, { ask }) {
      const value = Number(ask(gauge(POINT, cube)).result.gauge);
      const right = Math.abs(reply - value) < 1e-6;
      return {
        right,
        because: right
          ? "The largest coordinate decides: the cube holds the points with all coordinates between −1 and 1."
          : "Which of the three coordinates leaves the cube first?",
      };
    },
  },
  {
    id: "direction",
    title: "Find a separating direction",
    task:
      "<p>The rhombic dodecahedron has the generators (1, 1, 1), (−1, 1, 1), (1, −1, 1), (1, 1, " +
      "−1). The point is (3, 3, 0). Which direction separates it?</p>",
    reply: { choices: ["(1, 0, 0)", "(1, 1, 0)", "(0, 0, 1)", "None: the point is inside."] },
    setting: () => ({ ...first(), generators: RHOMBIC, point: [3, 3, 0] }),
    check(reply, _, { ask }) {
      const { status } = ask(locate([3, 3, 0], { center: [0, 0, 0], generators: RHOMBIC })).result;
      const directions: readonly Vec3[] = [
        [1, 0, 0],
        [1, 1, 0],
        [0, 0, 1],
      ];
      const dot = (u: Vec3, v: Vec3) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
      const u = directions[reply];
      if (!u) return { right: status !== "outside", because: `The library says ${status}.` };
      const [far, reach] = [dot(u, [3, 3, 0]), RHOMBIC.reduce((sum, v) => sum + Math.abs(dot(u, v)), 0)];
      return {
        right: far > reach,
        because: `In this direction the point is ${far} far and the body reaches ${reach}.`,
      };
    },
  },
  {
    id: "rival",
    title: "Proof and belief",
    task:
      "<p>The point lies beyond the face of the cube by 2⁻⁵², the least that a double can be beyond 1. What do the " +
      "proof and the rival say?</p>",
    reply: {
      choices: ["Both say outside.", "The proof says outside, the rival inside.", "Both say inside."],
    },
    figure: "rival",
    setting: beyondByALastPlace,
    check(reply, _, asking) {
      const { point } = beyondByALastPlace();
      const { member } = asking.ask(locate(point, cube)).result;
      const { belief } = believe(asking, point, cube);
      const truth = member ? 2 : belief === "disjoint" ? 0 : 1;
      return {
        right: reply === truth,
        because: `Proof: ${member ? "inside" : "outside"}. Rival: ${beliefWords(belief)}.`,
      };
    },
  },
  {
    id: "boundary",
    title: "Hit the boundary",
    task:
      "<p>Drag the point until its gauge is between 0.98 and 1.02. The button that does it for " +
      "you does not count.</p>",
    reply: "figure",
    setting: first,
    check(_, state, { ask }) {
      const value = Number(ask(gauge(state.point, sumOf(state))).result.gauge);
      return { right: value >= 0.98 && value <= 1.02, because: `The gauge is ${digits(value)}.` };
    },
  },
  {
    id: "meet",
    title: "Just a little",
    task:
      "<p>Put a second body and move it so that the two meet, but would be apart if both were " +
      "one tenth smaller.</p>",
    reply: "figure",
    setting: () => ({ ...first(), others: CUBE, point: [4, 2, 2] }),
    check(_, state, { ask }) {
      if (state.others.length === 0) return { right: false, because: "There is no second body yet." };
      const { status } = ask(question(state)).result;
      const smaller = (body: Body): Body => ({
        ...body,
        generators: body.generators.map((v): Vec3 => [0.9 * v[0], 0.9 * v[1], 0.9 * v[2]]),
      });
      const without = ask(meet(smaller(bodyOf(state)), smaller(otherOf(state)))).result.status;
      const right = status !== "outside" && without === "outside";
      return { right, because: `At this size: ${status}. One tenth smaller: ${without}.` };
    },
  },
];
