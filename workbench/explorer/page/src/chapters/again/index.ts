/** The chapter on bodies that are asked again and again: Section 5.2. */

import { polar, randomGenerators, RHOMBIC, TRUNCATED } from "../../data/bodies";
import { lineOf } from "../../engine/questions";
import type { Chapter, OwnData } from "../../kit/chapter";
import { digits } from "../../kit/vectors";
import { reduce, type FacetName } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { cuttingFigure } from "./cutting_figure";
import { verdictSentence } from "../words";
import { exercises } from "./exercises";
import { effortFigure, reducedFigure, said, walkFigure } from "./figures";
import {
  bodyOf,
  first,
  later,
  MOST_GENERATORS,
  MOST_PARTS,
  PREPARED,
  questions,
  read,
  type Answers,
  type Late,
  type State,
} from "./state";
import { hierarchyFigure } from "./hierarchy_figure";
import { asked, isCrossed, treeFigure } from "./tree_figure";
import text from "./text.html";

const of = (generators: readonly Vec3[], most: number): State => ({ ...first(), generators, most, path: [[0, 1, 1]] });

export const againChapter: Chapter<State, Answers, Late> = {
  id: "again",
  title: "Asked again and again",
  about: "Bodies of few generators, walks over facets, and what preparation saves.",
  text,
  first,
  read,
  presets: [
    { name: "Polar zonohedron of 11", note: "Five generators around eleven.", make: first },
    { name: "Twenty at random", note: "Reduce them to six.", make: () => of(randomGenerators(5, 20), 6) },
    {
      name: "Nearly a ball",
      note: "Polar zonohedra at three slopes.",
      make: () => of([...polar(9, 0.25), ...polar(7, 0.8), ...polar(5, 2)], 9),
    },
    {
      name: "A needle",
      note: "All generators point nearly in one direction.",
      make: () =>
        of(
          randomGenerators(8, 12).map((one): Vec3 => [one[0] * 0.15, one[1] * 0.15, 1 + one[2] * 0.2]),
          3,
        ),
    },
    { name: "Rhombic dodecahedron", note: "Three generators of four: a box around it.", make: () => of(RHOMBIC, 3) },
    {
      name: "Truncated octahedron",
      note: "Its generators are in special position, so the walk has no names for its hexagons.",
      make: () => of(TRUNCATED, 4),
    },
  ],
  questions,
  later,
  exercises,
  figures: {
    reduced: reducedFigure,
    hierarchy: hierarchyFigure,
    walk: walkFigure,
    cutting: cuttingFigure,
    tree: treeFigure,
    effort: effortFigure,
  },
  reads: {
    count: (state) => state.generators.length,
    lower: (_, { reduced }) => reduced.result.hausdorff.lower,
    upper: (_, { reduced }) => reduced.result.hausdorff.upper,
    verdict: (_, { verdict }) => (verdict ? verdictSentence(verdict) : "it is checking …"),
    standing,
    trapezoids: (_, { cut }) => cut?.cutting.trapezoids.length ?? "…",
    crossing: (_, { cut }) => cut?.cutting.limit ?? "…",
    prepared: () => PREPARED.length,
    leaves: (_, { tree }) => tree?.length ?? "…",
    crossed: (state, { tree }) => tree?.filter((leaf) => isCrossed(leaf, asked(state))).length ?? "…",
    levels: (_, { meeting }) => meeting.found.a.map((body) => body.generators.length).join(", "),
  },
  scrubs: {
    most: {
      label: "Generators at most",
      least: 3,
      most: MOST_GENERATORS,
      step: 1,
      get: (state) => state.most,
      set: (state, most) => ({ ...state, most }),
    },
    r: {
      label: "Parts of the cutting",
      least: 1,
      most: MOST_PARTS,
      step: 1,
      get: (state) => state.r,
      set: (state, r) => ({ ...state, r }),
    },
    turn: {
      label: "Direction of the question in degrees",
      least: 0,
      most: 360,
      step: 5,
      get: (state) => state.turn,
      set: (state, turn) => ({ ...state, turn }),
    },
  },
  actions: {},
  slides: [
    { figure: "reduced", title: "A simpler body around it", words: "Eleven generators in five.", make: first },
    {
      figure: "reduced",
      title: "Finer",
      words: "With eight generators hardly anything is lost.",
      make: () => ({ ...first(), most: 8 }),
    },
    {
      figure: "walk",
      title: "A walk",
      words: "Each facet has four neighbours, found from the generators alone.",
      make: first,
    },
    {
      figure: "hierarchy",
      title: "Coarse bodies decide",
      words: "While the bodies are far apart, bodies of few generators tell it.",
      make: () => ({ ...first(), at: 2 }),
    },
    {
      figure: "hierarchy",
      title: "Nearer",
      words: "When they come close, finer levels are needed.",
      make: () => ({ ...first(), at: 11 }),
    },
    {
      figure: "hierarchy",
      title: "Nearly touching",
      words: "Only the bodies themselves tell.",
      make: () => ({ ...first(), at: 12 }),
    },
    {
      figure: "cutting",
      title: "A cutting and its image",
      words: "Each trapezoid is crossed by half of the lines at most; its colour comes again in the tiling.",
      make: first,
    },
    {
      figure: "tree",
      title: "The tree over directions",
      words: "Only leaves on the circle are opened; the others count with their sums.",
      make: first,
    },
  ],
  takeaways: (state) => {
    const line = lineOf(reduce(bodyOf(state), state.most, state.rule));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: JSON.stringify(bodyOf(state)) },
    ];
  },
  accept(data: OwnData) {
    const generators = "generators" in data ? data.generators : "points3" in data ? data.points3 : null;
    if (!generators) return "This chapter takes generators of space: three numbers a row.";
    if (generators.length < 3 || generators.length > MOST_GENERATORS)
      return `The chapter takes 3 to ${MOST_GENERATORS} generators.`;
    return of(generators, Math.max(3, Math.ceil(generators.length / 2)));
  },
  random: (seed) => of(randomGenerators(seed, 12), 6),
  sentence: (state, { reduced }) =>
    `${state.generators.length} generators in at most ${state.most}; the distance is at most ` +
    `${digits(reduced.result.hausdorff.upper)}.`,
};

function standing(state: State, { neighbours }: Answers): string {
  const last = state.path[state.path.length - 1] as FacetName;
  if (!neighbours)
    return (
      "These generators are in special position: three of them lie in a plane, or two are " +
      "parallel, and the walk takes none of that."
    );
  return `The walk stands on the facet of ${said(last)}, after ${state.path.length - 1} steps.`;
}
