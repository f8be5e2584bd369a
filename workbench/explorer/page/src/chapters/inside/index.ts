/** The chapter on membership and collision: Section 5.1. */

import { lineOf } from "../../engine/questions";
import type { Chapter, OwnData } from "../../kit/chapter";
import { add3, digits, scale3, tidy3 } from "../../kit/vectors";
import { CUBE, randomGenerators } from "../../data/bodies";
import type { PlaneOfDirections } from "../../library/pictures";
import { verdictSentence } from "../words";
import { directionsFigure } from "./directions_figure";
import { exercises } from "./exercises";
import { beyondByALastPlace, presets } from "./presets";
import { gaugeTold, gaugeWords, proofSentence, reachIn, statusWord } from "./proof";
import { beliefWords, rivalFigure } from "./rival_figure";
import { insideSearchFigure } from "./search_figure";
import { insideSpaceFigure } from "./space_figure";
import {
  bodyOf,
  first,
  later,
  MOST_GENERATORS,
  question,
  questions,
  read,
  type Answers,
  type Late,
  type State,
} from "./state";
import text from "./text.html";

export const insideChapter: Chapter<State, Answers, Late> = {
  id: "inside",
  title: "Is it inside?",
  about: "Whether a point lies in a zonohedron, and whether two zonohedra meet, with a proof.",
  text,
  first,
  read,
  presets,
  questions,
  later,
  exercises,
  figures: { space: insideSpaceFigure, search: insideSearchFigure, directions: directionsFigure, rival: rivalFigure },
  reads: {
    status: statusWord,
    proof: proofSentence,
    verdict: (_, { late }) => (late ? verdictSentence(late.verdict) : "it is checking …"),
    gauge: (_, answers) => gaugeTold(answers),
    gaugeWords,
    least: (state, { late }) => leastReach(state, late?.directions ?? null),
    answer: answerSentence,
    apart: apartSentence,
    belief: beliefSentence,
  },
  scrubs: {},
  actions: {
    fool: beyondByALastPlace,
    second: (state) => ({ ...state, many: 0, others: state.others.length > 0 ? [] : CUBE }),
    touch: (state, { gauge }) => {
      const factor = Number(gauge?.gauge);
      return Number.isFinite(factor) && factor > 0
        ? { ...state, point: tidy3(scale3(state.point, 1 / factor)) }
        : state;
    },
  },
  slides: [
    {
      figure: "space",
      title: "Outside",
      words: "A plane stands between the body and the point.",
      read: "answer",
      make: first,
    },
    {
      figure: "space",
      title: "Inside",
      words: "A walk along the generators leads to the point.",
      read: "answer",
      make: () => ({ ...first(), point: [0.6, 0.5, 1.2] }),
    },
    {
      figure: "space",
      title: "Two bodies apart",
      words: "They are apart if the way from centre to centre does not lie in the body of all generators.",
      read: "apart",
      make: () => ({ ...first(), point: [3.9, 1.4, 2.6], others: CUBE }),
    },
    {
      figure: "space",
      title: "Two bodies overlap",
      words: "They meet if the way from centre to centre lies in the body of all generators.",
      read: "apart",
      make: () => ({ ...first(), point: [2.1, 0.7, 1.4], others: CUBE }),
    },
    {
      figure: "search",
      title: "A search over separators",
      words: "Each separator leaves half of the tiles.",
      make: () => ({ ...first(), point: [0.6, 0.5, 1.2] }),
    },
    {
      figure: "directions",
      title: "The plane of directions",
      words: "The reach is a convex function, bent along one line for each generator.",
      make: first,
    },
    {
      figure: "rival",
      title: "A rival that believes",
      words: "It walks towards the point in rounded numbers, and takes a gap of 2⁻⁵² for nothing.",
      read: "belief",
      make: () => ({ ...beyondByALastPlace(), rivalStep: 1 }),
    },
  ],
  takeaways: (state) => {
    const line = lineOf(question(state));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      {
        name: "JSON",
        text: state.others.length > 0 ? line : JSON.stringify({ point: state.point, ...bodyOf(state) }),
      },
    ];
  },
  accept(data: OwnData, state) {
    const generators = "generators" in data ? data.generators : "points3" in data ? data.points3 : null;
    if (!generators) return "This chapter takes generators of space: three numbers a row.";
    if (generators.length > MOST_GENERATORS) return `The chapter takes at most ${MOST_GENERATORS} generators.`;
    return { ...state, generators, many: 0, step: 0 };
  },
  random: (seed, state) => ({ ...state, generators: randomGenerators(seed, 7), many: 0, step: 0 }),
  sentence: answerSentence,
};

function beliefSentence(_: State, { belief, located }: Answers): string {
  if (!belief) return "The body has too many generators for this view.";
  const right = belief.belief === (located.member ? "intersecting" : "disjoint");
  const steps = belief.steps.length === 1 ? "one step" : `${belief.steps.length} steps`;
  const proved = located.member ? "inside or on the boundary" : "outside";
  return (
    `After ${steps} it says ${beliefWords(belief.belief)}. The proof says that the point is ${proved}: the rival is ` +
    `${right ? "right" : "wrong"}.`
  );
}

const withArticle = (noun: string): string => `${/^[aeiou]/.test(noun) ? "an" : "a"} ${noun}`;

/** The state and its main answer, in one line. */
function answerSentence(state: State, answers: Answers): string {
  const status = statusWord(state, answers);
  const gauge = digits(answers.gauge ? gaugeTold(answers) : "being computed");
  return `${status.charAt(0).toUpperCase()}${status.slice(1)}; the gauge is ${gauge}.`;
}

/** The reach in the direction at the lowest point. */
function leastReach(state: State, plane: PlaneOfDirections | null): number | string {
  if (!plane?.optimum) return "not defined here";
  const { origin, axes, optimum } = plane;
  const u = add3(origin, add3(scale3(axes[0], optimum[0]), scale3(axes[1], optimum[1])));
  return reachIn(state, u);
}

function apartSentence(state: State, { late }: Answers): string {
  if (state.others.length === 0 || !late?.apart) return "";
  const { distance, penetration, features } = late.apart;
  if (distance > 0)
    return (
      `The two bodies are ${digits(distance)} apart, between ${withArticle(features.a)} of the first and ` +
      `${withArticle(features.b)} of the second.`
    );
  if (penetration && penetration.upper > 0)
    return (
      `They overlap: a shift by ${digits(penetration.upper)} would part them, and one by less ` +
      `than ${digits(penetration.lower)} would not.`
    );
  return "They touch without overlapping.";
}
