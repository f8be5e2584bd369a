/** The exercises of the chapter; the library marks them. */

import type { Asking, Exercise } from "../../kit/chapter";
import { decimal } from "../../library/fraction";
import { meshesMeet, meshLevel, meshTests } from "../../library/meshes";
import { count } from "../../library/space";
import { presets } from "./presets";
import { first, meshOf, poseOf, type State } from "./state";
import { SHAPES } from "./shapes";

const made = (name: string): State => presets.find((preset) => preset.name === name)?.make() ?? first();

/** The volume of the body around all of a mesh. */
function volumeAround(shape: string, name: string, { ask }: Asking): number {
  const mesh = SHAPES[shape];
  const node = mesh && ask(meshLevel(mesh, 0, name)).result.nodes[0];
  return node ? decimal(ask(count(node.generators)).result.measure) : Number.NaN;
}

const CHOICES = ["aabb", "obb", "zonotope_6"] as const;

export const exercises: readonly Exercise<State>[] = [
  {
    id: "halves",
    title: "Three levels down",
    task: "<p>Each volume is split in two, and again. How many volumes has level 3 of the ring?</p>",
    reply: { number: "Volumes" },
    check(reply, _, { ask }) {
      const { nodes } = ask(meshLevel(SHAPES["ring"] ?? meshOf(first()), 3, "aabb")).result;
      const right = reply === nodes.length;
      return { right, because: right ? "Two times two times two." : "Count the halves of the halves of the halves." };
    },
  },
  {
    id: "plate",
    title: "A plate that leans",
    task:
      "<p>The plate among the presets leans to all three axes. How many times the volume of the parallelepiped " +
      "around it has its box along the axes?</p>",
    reply: { choices: ["Less than 2 times", "Between 2 and 10 times", "More than 10 times"] },
    setting: () => ({ ...made("Plates"), level: 0, volume: "aabb" }),
    check(reply, _, asking) {
      const times = volumeAround("plate", "aabb", asking) / volumeAround("plate", "zonotope_3", asking);
      const answer = times < 2 ? 0 : times <= 10 ? 1 : 2;
      return { right: reply === answer, because: `The library finds ${times.toFixed(1)} times the volume.` };
    },
  },
  {
    id: "balls",
    title: "Two balls side by side",
    task: "<p>Two balls are near each other and do not meet. With which volume does the fewest tests of nodes prove it?</p>",
    reply: { choices: ["Boxes along the axes", "Boxes turned as they fit", "Zonotopes of 6 generators"] },
    setting: () => made("Balls"),
    check(reply, _, { ask }) {
      const state = made("Balls");
      const tests = CHOICES.map((name) => ask(meshTests(meshOf(state), poseOf(state), name)).result.node_tests);
      const right = tests[reply] === Math.min(...tests);
      return { right, because: `In the order of the choices they take ${tests.join(", ")} tests.` };
    },
  },
  {
    id: "hidden",
    title: "Apart, but not at first sight",
    task:
      "<p>Drag the second copy so that the meshes do not meet, and so that one test of two zonotopes of 6 " +
      "generators does not tell it, because those around the whole meshes overlap.</p>",
    reply: "figure",
    check(_, state, { ask }) {
      const { witness, node_tests } = ask(meshTests(meshOf(state), poseOf(state), "zonotope_6")).result;
      const words = witness ? "The meshes meet" : "The meshes are apart";
      const tests = node_tests === 1 ? "one test" : `${node_tests} tests`;
      return { right: !witness && node_tests > 1, because: `${words}; it took ${tests} of nodes.` };
    },
  },
  {
    id: "meet",
    title: "Until they meet",
    task: "<p>Drag the second copy until the meshes meet in some pair of triangles.</p>",
    reply: "figure",
    check(_, state, { ask, verify }) {
      const answer = ask(meshesMeet(meshOf(state), poseOf(state)));
      const { intersects, witness } = answer.result;
      const verdict = verify(answer).verdict;
      const right = intersects && verdict === "right";
      return {
        right,
        because: witness
          ? `Triangles ${witness[0] + 1} and ${witness[1] + 1} have a common point; the verifier says: ${verdict}.`
          : "There is still a gap between them.",
      };
    },
  },
];
