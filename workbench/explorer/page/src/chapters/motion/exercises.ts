/** The exercises of the chapter; the library marks them. */

import type { Exercise } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { collide, count, sweep } from "../../library/space";
import { decimal } from "../../library/fraction";
import type { Body } from "../../library/shapes";
import { CUBE } from "../../data/bodies";
import { first, questions, REST, type State } from "./state";

const cube: Body = { center: [0, 0, 0], generators: CUBE };
const small: Body = {
  center: [0, 0, 0],
  generators: [
    [0.5, 0, 0],
    [0, 0.5, 0],
    [0, 0, 0.5],
  ],
};

export const exercises: readonly Exercise<State>[] = [
  {
    id: "shift",
    title: "A cube that is shifted",
    task: "<p>A cube of edge 1 is shifted by (4, 0, 0), without a turn. What is the volume of what it sweeps over?</p>",
    reply: { number: "Volume" },
    check(reply, _, { ask }) {
      const swept = ask(sweep(small, { ...REST, translation: [4, 0, 0] }, "by_least_rectangle")).result;
      const volume = decimal(ask(count(swept.generators)).result.measure);
      const right = Math.abs(reply - volume) < 0.01;
      return {
        right,
        because: right
          ? "It is a box of 5 by 1 by 1: half of the shift is one more generator."
          : "How long is the box that the cube drags along?",
      };
    },
  },
  {
    id: "contact",
    title: "When do they meet?",
    task:
      "<p>A cube of edge 2 with its centre in (0, 0, 0) moves by (4, 0, 0) during the step. " +
      "Another of the same size rests with its centre in (5, 0, 0). At which time do they touch " +
      "first?</p>",
    reply: { number: "Time" },
    setting: () => ({
      ...first(),
      time: 0,
      scene: { a: cube, b: { ...cube, center: [5, 0, 0] }, moves: { a: { ...REST, translation: [4, 0, 0] }, b: REST } },
    }),
    check(reply, _, { ask }) {
      const { time } = ask(
        collide(cube, { ...cube, center: [5, 0, 0] }, { a: { ...REST, translation: [4, 0, 0] } }),
      ).result;
      const right = time !== undefined && Math.abs(reply - time[1]) < 1e-3;
      return {
        right,
        because: right
          ? `The library brackets it between ${digits(time?.[0] ?? 0, 10)} and ${digits(time?.[1] ?? 0, 10)}.`
          : "How wide is the gap between them at the beginning?",
      };
    },
  },
  {
    id: "miss",
    title: "Fool the sampling",
    task:
      "<p>Change angles, shifts or bodies so that the bodies meet during the step, but at none " +
      "of the sampled times. Take at least four samples.</p>",
    reply: "figure",
    check(_, state, asking) {
      const { collision, hits } = questions(state, asking, null);
      const { status } = collision.result;
      const right = status === "contact" && hits.length === 0 && state.samples >= 4;
      return { right, because: `The library says ${status}; of ${state.samples} samples ${hits.length} meet.` };
    },
  },
  {
    id: "pass",
    title: "Just past",
    task:
      "<p>Let the first body turn by at least one radian and still stay clear of the other " +
      "during the whole step, with a single interval in the bar.</p>",
    reply: "figure",
    check(_, state, asking) {
      const { status, certificate } = questions(state, asking, null).collision.result;
      const pieces = certificate.intervals.length;
      const right = status === "separate" && pieces === 1 && Math.abs(state.scene.moves.a.angle) >= 1;
      return {
        right,
        because: `The library says ${status}, with ${pieces} ${pieces === 1 ? "interval" : "intervals"}.`,
      };
    },
  },
];
