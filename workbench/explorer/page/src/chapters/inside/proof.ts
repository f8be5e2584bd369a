/** The certificate as sentences with its numbers. */

import { digits, dot3, length3, place3, scale3 } from "../../kit/vectors";
import type { Exact, Vec3 } from "../../library/shapes";
import { sumOf, type Answers, type State } from "./state";

/** Coefficients that a sentence lists. */
const LISTED = 12;

/** A separating direction as doubles, scaled to the length 1 for pictures and sentences. */
export function direction(answers: Answers): Vec3 | null {
  const { certificate } = answers.located;
  if (!("separating_direction" in certificate)) return null;
  const [x = 0, y = 0, z = 0] = certificate.separating_direction.map(toNumber);
  const size = length3([x, y, z]);
  return size > 0 ? scale3([x, y, z], 1 / size) : null;
}

/** How far the body, or both together, reach in a direction. */
export function reachIn(state: State, u: Vec3): number {
  return sumOf(state).generators.reduce((sum, generator) => sum + Math.abs(dot3(u, generator)), 0);
}

/** The coefficients, those of the basis included. */
export function coefficients(answers: Answers): readonly number[] | null {
  const { certificate } = answers.located;
  return "coefficients" in certificate ? certificate.coefficients : null;
}

export function proofSentence(state: State, answers: Answers): string {
  const two = state.others.length > 0;
  const u = direction(answers);
  if (u) {
    const [far, reach] = [dot3(u, state.point), reachIn(state, u)];
    const goal = two ? "the centre of the second body lies" : "the point lies";
    const body = two ? "the two bodies together reach" : "the body reaches";
    return (
      `Take the direction u = ${place3(u)}. In this direction ${goal} ${digits(far)} beyond the ` +
      `centre, but ${body} only ${digits(reach)} far: the sum of all |u · v|. So there is a gap ` +
      `of ${digits(far - reach)}, and the plane at right angles to u between them separates the ` +
      "two."
    );
  }
  const numbers = coefficients(answers) ?? [];
  const listed = numbers
    .slice(0, LISTED)
    .map((value) => digits(value, 3))
    .join(", ");
  const more = numbers.length > LISTED ? `, and ${numbers.length - LISTED} more` : "";
  const goal = two ? "the way from centre to centre is" : "the point is";
  return (
    `With the coefficients ${listed}${more}, all between −1 and 1, ${goal} the centre plus ` +
    "the sum of coefficients times generators. The dashed path in the figure takes one " +
    "generator after the other and arrives."
  );
}

/** The word for a status. */
export function statusWord(state: State, answers: Answers): string {
  const { status } = answers.located;
  if (state.others.length > 0)
    return { inside: "the bodies overlap", boundary: "the bodies just touch", outside: "the bodies are apart" }[status];
  return { inside: "the point is inside", boundary: "the point is on the boundary", outside: "the point is outside" }[
    status
  ];
}

function toNumber(exact: Exact): number {
  if (typeof exact === "number") return exact;
  const [over = "0", under = "1"] = exact.split("/");
  return Number(over) / Number(under);
}
