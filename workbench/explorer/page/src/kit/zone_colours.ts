/** Colours of zones, classes and generators: Okabe and Ito's first, then steps that differ in lightness, too. */

const FIRST = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442", "#8c6bb1"];

export function zoneColour(index: number): string {
  const round = Math.floor(index / FIRST.length);
  const colour = FIRST[index % FIRST.length] as string;
  if (round === 0) return colour;
  // Later rounds are mixed with white and black in turn.
  const part = round % 2 === 1 ? 0.35 : 0.6;
  const goal = round % 2 === 1 ? 255 : 0;
  const channels = [1, 3, 5].map((at) => {
    const value = parseInt(colour.slice(at, at + 2), 16);
    return Math.round(value + (goal - value) * part)
      .toString(16)
      .padStart(2, "0");
  });
  return `#${channels.join("")}`;
}

/** The colour between two colours, as it comes about where two zones cross. */
export function mixed(colours: readonly string[]): string {
  const sums = [1, 3, 5].map((at) => colours.reduce((sum, colour) => sum + parseInt(colour.slice(at, at + 2), 16), 0));
  return `#${sums
    .map((sum) =>
      Math.round(sum / Math.max(1, colours.length))
        .toString(16)
        .padStart(2, "0"),
    )
    .join("")}`;
}
