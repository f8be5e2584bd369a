/** The chapter on motion: Section 6, and collisions that no sampling finds. */

import { lineOf } from "../../engine/questions";
import type { Chapter, OwnData, Scrub } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { collide, type Motion } from "../../library/space";
import { randomGenerators } from "../../data/bodies";
import type { Vec3 } from "../../library/shapes";
import { arcsFigure } from "./arcs_figure";
import { verdictSentence } from "../words";
import { exercises } from "./exercises";
import { motionFigure } from "./motion_figure";
import { presets } from "./presets";
import { first, later, MOST_GENERATORS, questions, read, type Answers, type Late, type State } from "./state";
import { sweptFigure } from "./swept_figure";
import text from "./text.html";

export const motionChapter: Chapter<State, Answers, Late> = {
  id: "motion",
  title: "Motion",
  about: "Two bodies that move: when they meet first, or a proof that they never do.",
  text,
  first,
  read,
  presets,
  questions,
  later,
  exercises,
  figures: { motion: motionFigure, arcs: arcsFigure, swept: sweptFigure },
  reads: {
    status: statusSentence,
    verdict: (_, { late }) => (late ? verdictSentence(late.verdict) : "it is checking …"),
    hits: (_, { hits }) => hits.length,
    missed: missedSentence,
  },
  scrubs: {
    angleA: turn("a"),
    angleB: turn("b"),
    shiftX: shift(0),
    shiftY: shift(1),
    shiftZ: shift(2),
    samples: {
      label: "Number of samples",
      least: 2,
      most: 60,
      step: 1,
      get: (state) => state.samples,
      set: (state, samples) => ({ ...state, samples }),
    },
  },
  actions: {},
  slides: [
    {
      figure: "motion",
      title: "Two bodies move",
      words: "Every interval of the bar has one direction, good at every time of it.",
      make: first,
    },
    {
      figure: "motion",
      title: "A thin plate",
      words: "Five samples see nothing; the certificate finds the contact.",
      make: () => presets[1]?.make() ?? first(),
    },
    { figure: "arcs", title: "Figure 3", words: "The arcs of all vertices, moved to a common origin.", make: first },
    { figure: "swept", title: "The swept volume", words: "Three more generators enclose all placements.", make: first },
    {
      figure: "swept",
      title: "Tighter",
      words: "Each generator turned by itself.",
      make: () => ({ ...first(), method: "by_turned_generators" }),
    },
  ],
  takeaways: ({ scene }) => {
    const line = lineOf(collide(scene.a, scene.b, scene.moves));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: line },
    ];
  },
  accept(data: OwnData, state) {
    if (!("generators" in data)) return "This chapter takes a body of space: JSON with center and generators.";
    if (data.generators.length > MOST_GENERATORS) return `The chapter takes at most ${MOST_GENERATORS} generators.`;
    return { ...state, scene: { ...state.scene, a: { ...state.scene.a, generators: data.generators } } };
  },
  random: (seed, state) => ({
    ...state,
    scene: {
      ...state.scene,
      a: {
        ...state.scene.a,
        generators: randomGenerators(seed, 5).map((one): Vec3 => [one[0] / 4, one[1] / 4, one[2] / 4]),
      },
    },
  }),
  sentence: (state, answers) => `Time ${digits(state.time)}. ${statusSentence(state, answers)}`,
};

function statusSentence(_: State, { collision }: Answers): string {
  const { status, time, certificate } = collision.result;
  const pieces = certificate.intervals.length;
  const proved = `${pieces} ${pieces === 1 ? "interval" : "intervals"}`;
  if (status === "separate") return `The bodies stay apart during the whole step; the proof has ${proved}.`;
  if (status === "contact")
    return time?.[1] === 0
      ? "The bodies meet at the beginning already."
      : `The bodies meet first between the times ${digits(time?.[0] ?? 0, 9)} and ` +
          `${digits(time?.[1] ?? 0, 9)}; that they are apart before is proved by ${proved}.`;
  return `The bodies come closer than anything that can be decided, at time ${digits(time?.[1] ?? 0, 9)}.`;
}

function missedSentence(_: State, { collision, hits }: Answers): string {
  const { status } = collision.result;
  if (status === "contact" && hits.length === 0)
    return "The samples say that nothing happened; the certificate knows better.";
  if (status === "contact") return "Here the samples notice the contact, but not when it began.";
  return "They are right this time, but they could not know.";
}

function change(state: State, key: "a" | "b", part: Partial<Motion>): State {
  const { scene } = state;
  return { ...state, scene: { ...scene, moves: { ...scene.moves, [key]: { ...scene.moves[key], ...part } } } };
}

function turn(key: "a" | "b"): Scrub<State> {
  return {
    label: key === "a" ? "Angle of the first body in radians" : "Angle of the second body in radians",
    least: -3.1,
    most: 3.1,
    step: 0.05,
    get: (state) => state.scene.moves[key].angle,
    set: (state, angle) => change(state, key, { angle }),
  };
}

function shift(axis: 0 | 1 | 2): Scrub<State> {
  return {
    label: `Shift of the first body along ${["x", "y", "z"][axis]}`,
    least: -8,
    most: 8,
    step: 0.05,
    get: (state) => state.scene.moves.a.translation[axis],
    set: (state, value) =>
      change(state, "a", {
        translation: state.scene.moves.a.translation.map((old, at) => (at === axis ? value : old)) as unknown as Vec3,
      }),
  };
}
