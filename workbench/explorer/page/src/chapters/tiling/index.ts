/** The chapter on the duality of lines and tiles: Section 3 and Figure 1. */

import { polar, randomGenerators, TRUNCATED } from "../../data/bodies";
import { lineOf } from "../../engine/questions";
import type { Chapter, Control, Figure, OwnData } from "../../kit/chapter";
import { Stepper } from "../../kit/stepper";
import { count } from "../../library/space";
import { numberOf } from "../words";
import { arrangementFigure } from "./arrangement_figure";
import { exercises } from "./exercises";
import { generatorsFigure } from "./generators_figure";
import { litSentence } from "./lighting";
import { separator } from "./links";
import { presets } from "./presets";
import { spaceFigure } from "./space_figure";
import { first, later, MOST_GENERATORS, questions, read, type Answers, type Late, type State } from "./state";
import text from "./text.html";
import { tilingFigure } from "./tiling_figure";

/** A corner inside the tiling of the first generators, at which three tiles meet. */
const CORNER = 3;

export const tilingChapter: Chapter<State, Answers, Late> = {
  id: "tiling",
  title: "Arrangement, tiling, zonohedron",
  about: "Lines in a plane, tiles on a floor, facets in space: three views of the same generators.",
  text,
  first,
  read,
  presets,
  questions,
  later,
  exercises,
  figures: {
    space: spaceFigure,
    generators: generatorsFigure,
    tiling: tilingFigure,
    arrangement: arrangementFigure,
    sweep: sweepFigure,
  },
  reads: {
    count: (state) => numberOf(state.generators.length, "generator"),
    vertices: (_, { counted }) => counted?.vertices ?? "…",
    edges: (_, { counted }) => counted?.edges ?? "…",
    facets: (_, { counted }) => counted?.facets ?? "…",
    volume: (_, { counted }) => (counted ? fraction(counted.measure) : "…"),
    expected: (state) => state.generators.length * (state.generators.length - 1),
    degenerate: degenerate,
    lit: (state, { tiling }) => litSentence(tiling, state.lit),
    tiles: (_, { tiling }) => tiling?.tiles.length ?? "…",
  },
  scrubs: {
    sweep: {
      label: "Tiles on the left of the separator",
      least: 0,
      most: 3160,
      step: 1,
      get: (state) => state.sweep,
      set: (state, sweep) => ({ ...state, sweep, isPlain: false }),
    },
  },
  actions: {},
  slides: [
    {
      figure: "space",
      title: "Five vectors, one body",
      words: "Every pair of generators spans a facet above and a facet below.",
      make: () => ({ ...first(), lit: null, isPlain: true }),
    },
    {
      figure: "tiling",
      title: "Seen from above",
      words: "The upper facets tile a polygon.",
      make: () => ({ ...first(), isPlain: true }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "Tiles and lines",
      words: "Each tile of two generators is the crossing of their two lines.",
      read: "lit",
      make: () => ({ ...first(), isPlain: true }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "Corners and cells",
      words: "Each corner is a cell between lines: where three tiles meet, the cell is a triangle.",
      read: "lit",
      make: () => ({ ...first(), isPlain: true, lit: { kind: "corner", index: CORNER } }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "A zone and its line",
      words: "The tiles of one generator form a band from side to side; its line runs through their crossings.",
      read: "lit",
      make: () => ({ ...first(), isPlain: true, lit: { kind: "class", index: 0 } }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "A separator and its vertical line",
      words: "Four tiles lie on the left of the thick path, four crossings on the left of the thick line.",
      make: () => ({ ...first(), lit: null }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "One crossing further",
      words: "The line passes the fifth crossing, and the path flips over the fifth tile.",
      make: () => ({ ...first(), sweep: 5, lit: { kind: "tile", index: 4 } }),
    },
    {
      figure: "space",
      title: "Special positions",
      words: "Three generators in a plane make a hexagon: the truncated octahedron.",
      make: () => ({ generators: TRUNCATED, sweep: 2, lit: null, isPlain: true }),
    },
    {
      figure: ["tiling", "arrangement"],
      title: "A polar zonohedron",
      words: "Generators around an axis, all with the same slope: their lines touch one circle.",
      make: () => ({ generators: polar(9, 0.7), sweep: 12, lit: null, isPlain: true }),
    },
  ],
  takeaways: (state) => {
    const line = lineOf(count(state.generators));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: JSON.stringify({ center: [0, 0, 0], generators: state.generators }) },
    ];
  },
  accept(data: OwnData, state) {
    const generators = "generators" in data ? data.generators : "points3" in data ? data.points3 : null;
    if (!generators) return "This chapter takes generators of space: three numbers a row.";
    if (generators.length > MOST_GENERATORS) return `The chapter draws at most ${MOST_GENERATORS} generators.`;
    return { ...state, generators, sweep: 0, lit: null };
  },
  random: (seed, state) => ({ ...state, generators: randomGenerators(seed, 6), sweep: 5, lit: null }),
  sentence: (state, { tiling }) =>
    `${numberOf(state.generators.length, "generator")}, ${tiling ? numberOf(tiling.tiles.length, "tile") : "some tiles"}. ` +
    litSentence(tiling, state.lit),
};

/** Volumes are exact fractions; long ones are shown as decimals. */
function fraction(exact: string): string | number {
  if (exact.length <= 9) return exact;
  const [over = "0", under = "1"] = exact.split("/");
  return ratio(BigInt(over), BigInt(under));
}

/** The quotient of two whole numbers with twelve digits behind the point, as a double. */
function ratio(over: bigint, under: bigint): number {
  const scale = 10n ** 12n;
  return Number((over * scale) / under) / Number(scale);
}

function degenerate(state: State, { tiling }: Answers): string {
  if (!tiling) return "";
  const name = (indices: readonly number[]) => indices.map((index) => index + 1).join(" and ");
  const sentences: string[] = [];
  if (tiling.zero.length > 0) sentences.push(`Generator ${name(tiling.zero)} is zero and takes no part.`);
  for (const { generators, line } of tiling.classes) {
    if (generators.length > 1) sentences.push(`Generators ${name(generators)} are parallel: they share a line.`);
    if (!line) sentences.push(`Generator ${name(generators)} is vertical: it has no line.`);
  }
  const large = tiling.tiles.filter((tile) => tile.classes.length > 2).length;
  if (large > 0)
    sentences.push(
      `${large === 1 ? "One tile has" : `${large} tiles have`} more than four sides, because ` +
        "three or more generators lie in one plane.",
    );
  if (sentences.length === 0)
    return state.generators.length > 2
      ? "These generators are in general position, as far as the view from above shows."
      : "";
  return `Here there are fewer tiles, for these generators are in special position. ${sentences.join(" ")}`;
}

/** The stepper of the sweep. */
function sweepFigure(control: Control<State>): Figure<State, Answers> {
  const stepper = new Stepper("The sweep", (sweep) => control.commit({ ...control.state, sweep, isPlain: false }));
  return {
    element: stepper.element,
    draw(state, { tiling }) {
      if (!tiling) return stepper.draw(0, 1, "The tiling is being computed …");
      const rank = Math.min(state.sweep, tiling.tiles.length);
      const steps = separator(tiling, rank).length - 1;
      stepper.draw(
        rank,
        tiling.tiles.length + 1,
        `${numberOf(rank, "tile")} on the left of the separator, ${tiling.tiles.length - rank} on its right; ` +
          `it has ${numberOf(steps, "step")}.`,
      );
    },
  };
}
