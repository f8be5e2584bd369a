/** Words that several chapters use in their sentences. */

import type { Verdict } from "../engine/questions";

/** A number with its noun, which has an s where the number is not one. */
export function numberOf(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

/** The verdict of the verifier as the end of a sentence. A gap of nothing is told as that, and one thing as one. */
export function verdictSentence({ verdict, reason }: Verdict): string {
  const plain = reason
    .replace(/is within -?0\.0e0 of the/, "is equal to the")
    .replace("all 1 points", "the one point")
    .replace(/\b1 (point|generator|facet|interval|tile)s\b/g, "1 $1");
  return `${verdict}, ${plain}.`;
}
