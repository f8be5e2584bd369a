/** Colours of zones, classes and generators: Okabe and Ito's first, then steps that differ in lightness, too. */

const FIRST = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442", "#8c6bb1"];

const ZONES: string[] = [];

export function zoneColour(index: number): string {
  return (ZONES[index] ??= colourOfZone(index));
}

function colourOfZone(index: number): string {
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

/** Bounds of the luminance of a line that stands off from white paper, and from black paper, by a contrast of three. */
const [LIGHTEST, DARKEST] = [0.3, 0.125];

/** The colour of a line, from that of its zone: darker on light paper and lighter on dark paper, where it must be. */
export function lineColour(colour: string): string {
  return `light-dark(${toned(colour, "#000000")}, ${toned(colour, "#ffffff")})`;
}

/** The colour moved towards black or white until it stands off from the opposite one. */
function toned(colour: string, goal: "#000000" | "#ffffff"): string {
  const near = (value: number) => (goal === "#000000" ? value <= LIGHTEST : value >= DARKEST);
  let now = colour;
  for (let part = 1; !near(luminance(now)); part += 1)
    now = mixed([...Array<string>(20 - part).fill(colour), ...Array<string>(part).fill(goal)]);
  return now;
}

/** The relative luminance of WCAG 2. */
function luminance(colour: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5]
    .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
    .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/** Colours of crossings that were asked for before: a body has thousands of facets, in few colours. */
const CROSSINGS = new Map<number, string>();

/** Colours that the crossings remember are of indices below it. */
const REMEMBERED = 1000;

/** The colour where zones cross, by their indices. */
export function crossingColour(zones: readonly number[]): string {
  const [one = 0, other = 0] = zones;
  if (zones.length !== 2 || Math.max(one, other) >= REMEMBERED) return mixed(zones.map(zoneColour));
  const name = one * REMEMBERED + other;
  let known = CROSSINGS.get(name);
  if (known === undefined) CROSSINGS.set(name, (known = mixed(zones.map(zoneColour))));
  return known;
}

/** The colour between colours. */
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
