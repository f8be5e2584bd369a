/** Going through tiles and corners by keys, and the sentences about what is lit up. */

import type { Control } from "../../kit/chapter";
import type { Tiling } from "../../library/pictures";
import { numberOf } from "../words";
import type { Lit, State } from "./state";

/** Moves the light by a key; true if the key was one for it. */
export function stepLit(key: string, tiling: Tiling, control: Control<State>): boolean {
  const keys: Readonly<Record<string, readonly [Lit["kind"], number]>> = {
    ArrowRight: ["tile", 1],
    ArrowLeft: ["tile", -1],
    ArrowUp: ["corner", 1],
    ArrowDown: ["corner", -1],
  };
  if (key === "Escape") {
    control.change({ ...control.state, lit: null });
    return true;
  }
  const meant = keys[key];
  if (!meant) return false;
  const [kind, step] = meant;
  const all = kind === "tile" ? tiling.tiles.length : tiling.vertices.length;
  if (all === 0) return true;
  const before = control.state.lit;
  const index = before?.kind === kind ? (before.index + step + all) % all : 0;
  control.change({ ...control.state, lit: { kind, index } });
  return true;
}

/** What is lit up, in all three views. */
export function litSentence(tiling: Tiling | null, lit: Lit | null): string {
  if (!tiling) return "The tiling is being computed.";
  if (!lit) return "Nothing is lit up. Point at a tile, a corner, a crossing, a line or a facet.";
  const listed = (indices: readonly number[]) => indices.map((index) => `${index + 1}`).join(" and ");
  const ofClass = (index: number) => listed(tiling.classes[index]?.generators ?? []);
  if (lit.kind === "class") {
    const tiles = tiling.tiles.filter((tile) => tile.classes.includes(lit.index)).length;
    return (
      `Line and zone of generator ${ofClass(lit.index)}: the line has ${numberOf(tiles, "crossing")}, the ` +
      `upper half of the zone ${numberOf(tiles, "facet")}.`
    );
  }
  if (lit.kind === "corner") {
    const tiles = tiling.tiles.filter((tile) => tile.left.includes(lit.index) || tile.right.includes(lit.index)).length;
    const sides = tiling.edges.filter((edge) => edge.ends.includes(lit.index)).length;
    return (
      `Corner ${lit.index + 1}: ${numberOf(sides, "edge")} and ${numberOf(tiles, "tile")} meet in it, so its cell has ` +
      `${numberOf(sides, "side")} and ${numberOf(tiles, "corner")}.`
    );
  }
  const tile = tiling.tiles[lit.index];
  if (!tile) return "";
  const generators = tile.classes.map(ofClass);
  const shape =
    tile.classes.length > 2
      ? `These ${tile.classes.length} lie in one plane, so their lines meet in one point and the ` +
        `tile has ${2 * tile.classes.length} sides.`
      : "";
  return (
    `Tile ${lit.index + 1} of generators ${generators.join(", ")} is the crossing of their ` +
    `lines, and one facet. ${shape}`
  );
}
