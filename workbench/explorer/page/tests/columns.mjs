// What comes in columns is what comes in lines, and a body that is held has the answers of the kind.
import { folded } from "../dist/columns.js";
import { same, text } from "./kit.mjs";

const BODIES = [
  [],
  [[1, 2, 3]],
  [
    [1, 0, 1],
    [0, 1, 0],
    [1, 1, 1],
  ],
  [
    [1, 1, 1],
    [1, 1, -1],
    [1, -1, 1],
    [-1, 1, 1],
  ],
  [
    [3, 1, 0.5],
    [1, 4, -1],
    [-2, 1, 1.5],
    [0.5, -1, 3],
    [1, 1, 1],
    [0, 0, 0],
  ],
];

export async function test(_opened, library) {
  const question = (kind, input) => JSON.stringify({ id: "test", kind, input });
  for (const generators of BODIES) {
    const body = { center: [0.5, -1, 0], generators };
    for (const [kind, input] of [
      ["faces", body],
      ["tiling", { generators }],
      ["cutting", { generators, r: 2 }],
      ["hierarchy", { a: body, b: { ...body, center: [1, 1, 1] } }],
    ]) {
      const found = folded(library.bytes("columns", question(kind, input)));
      same(text(found), text(library.ask("picture", kind, input)), `${kind} of ${JSON.stringify(generators)}`);
    }
    same(library.bytes("hold", question("body", body)).length, 0, "a body is held");
    for (const point of [
      [0.6, -0.9, 0.1],
      [9, 1, -2],
      [1.5, 1, 3],
    ]) {
      const { status, coefficients, separating_direction } = folded(library.bytes("locate", ...point));
      const member = library.ask("answer", "member", { point, ...body });
      const proof = separating_direction ? { separating_direction } : { coefficients };
      same(status, member.status, "the status");
      for (const [name, value] of Object.entries(proof)) same(text(value), text(member.certificate[name]), name);
    }
  }
}
