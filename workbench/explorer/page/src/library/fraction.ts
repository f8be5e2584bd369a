/** Exact fractions, as answers tell them. */

/** An exact fraction as a double. */
export function decimal(exact: string): number {
  const [over = "0", under = "1"] = exact.split("/");
  // Both parts may be longer than any double: as many digits are dropped of one as of the other.
  const extra = Math.max(0, Math.min(over.length, under.length) - 30);
  return Number(over.slice(0, over.length - extra)) / Number(under.slice(0, under.length - extra));
}
