/** The chapter on bounding volumes: hierarchies of boxes and zonotopes over meshes. */

import { lineOf } from "../../engine/questions";
import type { Chapter, OwnData } from "../../kit/chapter";
import { digits, place3, randoms, tidy } from "../../kit/vectors";
import { meshLevel } from "../../library/meshes";
import type { Vec3 } from "../../library/shapes";
import { verdictSentence } from "../words";
import { exercises } from "./exercises";
import { levelFigure } from "./level_figure";
import { presets } from "./presets";
import { SHAPES } from "./shapes";
import {
  COUNTED,
  DEEPEST,
  DRAWN,
  first,
  later,
  meshOf,
  middleOf,
  MOST_TRIANGLES,
  questions,
  read,
  type Answers,
  type Late,
  type State,
} from "./state";
import text from "./text.html";
import { testsFigure } from "./tests_figure";

const WAITING = "…";

const preset = (name: string) => () => presets.find((one) => one.name === name)?.make() ?? first();

export const volumesChapter: Chapter<State, Answers, Late> = {
  id: "volumes",
  title: "Bounding volumes",
  about: "Meshes in boxes and zonotopes, level by level, and the tests that a better fit saves.",
  text,
  first,
  read,
  presets,
  questions,
  later,
  exercises,
  figures: { level: levelFigure, tests: testsFigure },
  reads: {
    nodes: (_, { level }) => level?.nodes.length ?? WAITING,
    generators: (_, { level }) => level?.nodes.reduce((sum, { generators }) => sum + generators.length, 0) ?? WAITING,
    total: (_, { level }) => level?.total ?? WAITING,
    verdict: (_, { level }) => (level ? verdictSentence(level.verdict) : "it is waiting for the library …"),
    meeting,
    fewest,
  },
  scrubs: {
    level: {
      label: "Level of the hierarchy",
      least: 0,
      most: DEEPEST,
      step: 1,
      get: (state) => state.level,
      set: (state, level) => ({ ...state, level }),
    },
    turn: {
      label: "Turn of the second copy in degrees",
      least: -180,
      most: 180,
      step: 5,
      get: (state) => state.turn,
      set: (state, turn) => ({ ...state, turn }),
    },
  },
  actions: {},
  slides: [
    {
      figure: "level",
      title: "One box",
      words: "A box along the axes around the whole mesh: most of it is empty.",
      make: () => ({ ...first(), level: 0, volume: "aabb" }),
    },
    {
      figure: "level",
      title: "One zonotope",
      words: "Six generators fit closer.",
      make: () => ({ ...first(), level: 0 }),
    },
    { figure: "level", title: "Level 3", words: "Eight zonotopes, each around an eighth of the ring.", make: first },
    {
      figure: "level",
      title: "Level 5",
      words: "Deep down all volumes fit.",
      make: () => ({ ...first(), level: 5 }),
    },
    {
      figure: "tests",
      title: "Near each other",
      words: "The better the fit, the fewer tests.",
      make: preset("Balls"),
    },
    {
      figure: "tests",
      title: "Overlapping",
      words: "Whatever the volume, the search goes down to triangles that meet.",
      make: preset("Overlapping balls"),
    },
  ],
  takeaways: (state) => {
    const line = lineOf(meshLevel(meshOf(state), state.level, state.volume));
    return [
      { name: "command", text: `printf '%s\\n' '${line}' | zonobench solve` },
      { name: "JSON", text: line },
    ];
  },
  accept(data: OwnData, state) {
    if (!("points3" in data) || !data.mesh)
      return "This chapter takes a mesh with its faces: the text of an OBJ or OFF file.";
    const { triangles } = data.mesh;
    if (triangles.length > MOST_TRIANGLES)
      return `The mesh has ${triangles.length} triangles; the chapter takes ${MOST_TRIANGLES}, the program a million.`;
    return { ...state, own: data.mesh, place: [1.1 * middleOf(data.mesh).size, 0, 0], turn: 0 };
  },
  random: (seed, state) => {
    const random = randoms(seed);
    const names = Object.keys(SHAPES);
    const direction = (): number => tidy(2 * random() - 1);
    return {
      ...state,
      own: null,
      shape: names[Math.floor(random() * names.length)] ?? "ring",
      place: [2 * direction(), 2 * direction(), 2 * direction()] as Vec3,
      turn: 5 * Math.round(36 * direction()),
    };
  },
  sentence: (state, answers) => {
    const volume = DRAWN.find(({ id }) => id === state.volume)?.name ?? state.volume;
    return `Level ${state.level} in ${volume}. The second copy is at ${place3(state.place)}. ${meeting(state, answers)}`;
  },
};

function meeting(_: State, { counted }: Answers): string {
  const tests = counted?.[0]?.tests;
  if (!tests) return "The library is counting …";
  const { witness, distance } = tests;
  if (witness) return `The meshes meet, in triangle ${witness[0] + 1} and triangle ${witness[1] + 1} of the copy.`;
  const [lower, upper] = distance ?? [0, 0];
  const bounds = [...new Set([digits(lower), digits(upper)])];
  return `The meshes are apart, by ${bounds.join(" to ")}.`;
}

function fewest(_: State, { counted }: Answers): string {
  if (!counted) return "";
  const least = Math.min(...counted.map(({ tests }) => tests.node_tests));
  const best = counted.filter(({ tests }) => tests.node_tests === least).map(({ id }) => id);
  const names = COUNTED.filter(({ id }) => best.includes(id)).map(({ name }) => name);
  if (names.length === COUNTED.length) return `Every volume takes ${least === 1 ? "one test" : `${least} tests`}.`;
  return `The fewest tests of nodes, ${least}, are those of ${names.join("; ")}.`;
}
