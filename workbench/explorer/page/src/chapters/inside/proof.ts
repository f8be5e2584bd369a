/** The certificate as sentences with its numbers. */

import { digits, dot3, length3, place3, scale3 } from "../../kit/vectors";
import type { Exact, Vec3 } from "../../library/shapes";
import { sumOf, type Answers, type State } from "./state";

/** Coefficients that a sentence lists. */
const LISTED = 12;

/** Coefficients up to which the figure draws the walk to the point. */
export const WALKED = 60;

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
    const centre = two ? "that of the first" : "the centre";
    const begin = `Take the direction u = ${place3(u)}. In this direction ${goal}`;
    const end = "the plane at right angles to u between them separates the two.";
    if (far <= reach)
      return (
        `${begin} beyond ${centre} farther than ${body}, the sum of all |u · v|: the gap is less than the rounding ` +
        `of this sentence, but exact numbers show it, and ${end}`
      );
    const [farTold, reachTold] = told(far, reach);
    return (
      `${begin} ${farTold} beyond ${centre}, but ${body} only ${reachTold} far: the sum of all |u · v|. So there is a ` +
      `gap of ${digits(far - reach)}, and ${end}`
    );
  }
  const numbers = coefficients(answers) ?? [];
  const listed = numbers
    .slice(0, LISTED)
    .map((value) => digits(value, 3))
    .join(", ");
  const more = numbers.length > LISTED ? `, and ${numbers.length - LISTED} more` : "";
  const goal = two ? "the way from centre to centre is" : "the point is the centre plus";
  const path =
    numbers.length <= WALKED ? " The dashed path in the figure takes one generator after the other and arrives." : "";
  return (
    `With the coefficients ${listed}${more}, all between −1 and 1, ${goal} the sum of coefficients times ` +
    `generators.${path}`
  );
}

/** Two numbers as a sentence that compares them tells them: with all digits where a few would be the same. */
function told(one: number, other: number): [string, string] {
  const short: [string, string] = [digits(one), digits(other)];
  return short[0] === short[1] ? [String(one), String(other)] : short;
}

/** The gauge: with all digits where a few would say 1. */
export function gaugeTold({ gauge }: Answers): number | string {
  if (!gauge) return "…";
  const value = gauge.gauge;
  return digits(value) === "1" && value !== 1 ? String(value) : value;
}

/** The gauge in words, after its number. */
export function gaugeWords(state: State): string {
  return state.others.length > 0
    ? "so many times the generators of both bodies must be taken to reach from the first centre to the second exactly. " +
        "Up to 1 the bodies meet."
    : "so many times the body must be taken about its centre to reach the point exactly. Up to 1 the point is in the " +
        "body.";
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
