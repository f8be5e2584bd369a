/** The chapter on zonogons of least area: Section 4.1. */

import type { Chapter, OwnData } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { lineOf } from "../../engine/questions";
import { leastArea } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";
import { numberOf, verdictSentence } from "../words";
import { exercises } from "./exercises";
import { lineFigure } from "./line_figure";
import { presets, randomPoints } from "./presets";
import { balance } from "./proof";
import { proofFigure } from "./proof_figure";
import { cellsOfAll, pruningFigure, searchFigure } from "./search_figure";
import { first, later, questions, read, type Answers, type Late, type State } from "./state";
import text from "./text.html";
import { zonogonFigure } from "./zonogon_figure";

/** Digits of numbers that a sentence compares. */
const COMPARED = 8;

export const smallestZonogon: Chapter<State, Answers, Late> = {
  id: "smallest-zonogon",
  title: "The smallest zonogon",
  about: "Around points of the plane, the zonogon of least area, with a proof.",
  text,
  first,
  read,
  presets,
  questions,
  later,
  exercises,
  figures: {
    zonogon: zonogonFigure,
    line: lineFigure,
    proof: proofFigure,
    search: searchFigure,
    pruning: pruningFigure,
  },
  reads: {
    area: (_, { zonogon }) => zonogon.area,
    count: (state) => numberOf(state.points.length, "point"),
    corners: (_, { zonogon }) => numberOf(zonogon.hull.length, "corner"),
    least: (_, { best }) => best.result.area,
    excess: (_, { zonogon, best }) => excess(zonogon.area, Number(best.result.area)),
    bends: (_, { line }) => Math.max(0, line.at.length - 2),
    closing: (state, answers) => closing(state, answers),
    // The bound and the area are compared, so both have digits enough to be compared.
    bound: (_, { best }) => digits(best.result.lower_bound, COMPARED),
    reached: (_, { best }) => digits(best.result.area, COMPARED),
    pruned: (_, { late }) => prunedSentence(late),
    verdict: (_, { late }) => (late ? verdictSentence(late.verdict) : "it is checking …"),
  },
  scrubs: {
    turn: {
      label: "Direction of the line in degrees",
      least: -180,
      most: 180,
      step: 1,
      get: (state) => state.turn,
      set: (state, turn) => ({ ...state, turn }),
    },
  },
  actions: {
    best: (state, { best }) => ({ ...state, center: best.result.center }),
    levels: (state) => ({ ...state, levels: !state.levels }),
  },
  slides: [
    {
      figure: "zonogon",
      title: "Points, and their reflections",
      words: "A zonogon with centre O that holds the points holds their reflections, too.",
      make: first,
    },
    {
      figure: "zonogon",
      title: "A better centre",
      words: "At the best centre the zonogon has the least area.",
      make: () => ({ ...first(), center: [2.9, 1.85] }),
    },
    {
      figure: "line",
      title: "A valley without side valleys",
      words: "Along every line the area falls, then rises.",
      make: first,
    },
    {
      figure: "zonogon",
      title: "Level sets",
      words: "The area is a convex function of the centre.",
      make: () => ({ ...first(), levels: true }),
    },
    {
      figure: "search",
      title: "The search",
      words: "A vertical line through the middle candidate; green: the lowest point on it. Half of the candidates go.",
      make: first,
    },
    {
      figure: "search",
      title: "The next step",
      words: "Again the middle one of those that are left.",
      make: () => ({ ...first(), step: 1 }),
    },
  ],
  takeaways: (state) => {
    const line = lineOf(leastArea(state.points));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: JSON.stringify({ points: state.points }) },
    ];
  },
  accept(data: OwnData, state) {
    if (!("points" in data)) return "This chapter takes points of the plane: two numbers a row.";
    return { ...state, points: data.points, center: middle(data.points), step: 0 };
  },
  random: (seed, state) => {
    const points = randomPoints(seed, 12);
    return { ...state, points, center: middle(points), step: 0 };
  },
  sentence: (state, { zonogon, best }) =>
    `${numberOf(state.points.length, "point")}; the area of the zonogon is ${digits(zonogon.area)}, the ` +
    `least area ${digits(best.result.area)}.`,
};

function middle(points: readonly Vec2[]): Vec2 {
  const sum = points.reduce<Vec2>((total, point) => [total[0] + point[0], total[1] + point[1]], [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
}

function excess(area: number, least: number): string {
  return least > 0 ? `${digits(100 * (area / least - 1), 3)} %` : `${digits(area)}`;
}

function closing(state: State, answers: Answers): string {
  const sum = balance(state, answers).reduce<Vec2>(
    (total, { vector, coefficient }) => [total[0] + coefficient * vector[0], total[1] + coefficient * vector[1]],
    [0, 0],
  );
  // The page adds up in doubles; the verifier does it exactly.
  const rounded = sum.map((value) => (Math.abs(value) < 1e-9 ? 0 : value));
  return `(${digits(rounded[0] ?? 0)}, ${digits(rounded[1] ?? 0)})`;
}

function prunedSentence(late: Late | null): string {
  const cells = cellsOfAll(late);
  if (cells.length === 0) return "For these points no cell is needed: there are too few lines.";
  const told = cells.map((cell) => `${cell.crossing.length} of ${cell.lines.length}`).join(", then ");
  return `Here the lines that cross the cells are ${told}.`;
}
