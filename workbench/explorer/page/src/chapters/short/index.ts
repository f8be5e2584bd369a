/** The chapter on zonotopes of least total length: Sections 4.2 and 4.3, in the plane. */

import { lineOf } from "../../engine/questions";
import { digits, randoms, tidy } from "../../kit/vectors";
import type { Chapter, OwnData } from "../../kit/chapter";
import { leastLength } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";
import { verdictSentence } from "../words";
import { exercises } from "./exercises";
import { alongFigure, dualFigure, fewFigure } from "./figures";
import { EPSILON, first, later, MOST_POINTS, questions, read, type Answers, type Late, type State } from "./state";
import text from "./text.html";

export const shortChapter: Chapter<State, Answers, Late> = {
  id: "short",
  title: "Short zonotopes",
  about: "The zonotope of least total length, along given directions and along all.",
  text,
  first,
  read,
  presets: [
    { name: "Eight points", note: "Pull the number of directions.", make: first },
    {
      name: "Square",
      note: "Two directions suffice, if they are the right ones.",
      make: () => ({
        ...first(),
        points: [
          [0, 0],
          [2, 0],
          [2, 2],
          [0, 2],
        ],
        directions: 2,
        turn: 0,
      }),
    },
    {
      name: "Triangle",
      note: "No triangle is a zonogon.",
      make: () => ({
        ...first(),
        points: [
          [0, 0],
          [3, 0],
          [1, 2.5],
        ],
        turn: 0,
      }),
    },
    {
      name: "Two points",
      note: "A single generator is the best.",
      make: () => ({
        ...first(),
        points: [
          [0, 0],
          [3, 4],
        ],
        directions: 2,
        turn: 0,
      }),
    },
    {
      name: "Circle of 60",
      note: "The more directions, the better: there are no best few.",
      make: () => ({ ...first(), points: circle(60), directions: 4, turn: 0, most: 4 }),
    },
  ],
  questions,
  later,
  exercises,
  figures: { along: alongFigure, few: fewFigure, dual: dualFigure },
  reads: {
    along: (_, { along }) => along.value ?? "not defined: no such zonogon holds the points",
    length: (_, { all }) => all.result.length,
    bound: (_, { all }) => all.result.lower_bound,
    cost: (_, { along, all }) =>
      along.value === undefined || all.result.length === 0
        ? "nothing that can be compared"
        : `${digits(Math.max(0, 100 * (along.value / all.result.length - 1)), 3)} %`,
    few: (_, { few }) => few.length,
    ratio: (_, { few }) => few.ratio,
    generators: (_, { all }) => all.result.generators.length,
    verdict: (_, { late }) => (late ? verdictSentence(late.verdict) : "it is checking …"),
  },
  scrubs: {
    directions: {
      label: "Number of directions",
      least: 2,
      most: 40,
      step: 1,
      get: (state) => state.directions,
      set: (state, directions) => ({ ...state, directions }),
    },
    turn: {
      label: "Angle of the first direction in degrees",
      least: 0,
      most: 180,
      step: 1,
      get: (state) => state.turn,
      set: (state, turn) => ({ ...state, turn }),
    },
    most: {
      label: "Generators at most",
      least: 2,
      most: 20,
      step: 1,
      get: (state) => state.most,
      set: (state, most) => ({ ...state, most }),
    },
  },
  actions: {},
  slides: [
    {
      figure: "along",
      title: "Three directions",
      words: "The shortest zonogon along three given directions.",
      make: first,
    },
    {
      figure: "along",
      title: "Twelve directions",
      words: "The more directions, the shorter.",
      make: () => ({ ...first(), directions: 12 }),
    },
    { figure: "few", title: "Few generators", words: "Three generators come close to the best.", make: first },
    {
      figure: "dual",
      title: "A proof by forces",
      words: "The zonogon of the forces lies in the unit circle.",
      make: first,
    },
  ],
  takeaways: (state) => {
    const line = lineOf(leastLength(state.points, EPSILON));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: JSON.stringify({ points: state.points }) },
    ];
  },
  accept(data: OwnData, state) {
    if (!("points" in data)) return "This chapter takes points of the plane: two numbers a row.";
    return data.points.length > MOST_POINTS
      ? `The chapter takes at most ${MOST_POINTS} points.`
      : { ...state, points: data.points };
  },
  random: (seed, state) => {
    const random = randoms(seed);
    return { ...state, points: Array.from({ length: 10 }, (): Vec2 => [tidy(5 * random()), tidy(3.5 * random())]) };
  },
  sentence: (state, { along, all }) =>
    `${state.directions} directions give the length ${digits(along.value ?? Infinity)}, all ` +
    `directions ${digits(all.result.length)}.`,
};

function circle(count: number): Vec2[] {
  return Array.from({ length: count }, (_, index): Vec2 => {
    const angle = (2 * Math.PI * index) / count;
    return [tidy(2 * Math.cos(angle)), tidy(2 * Math.sin(angle))];
  });
}
