/** The view of the tiling: the upper hull from above, tile by tile, with the separator of the sweep. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { mixed } from "../../kit/zone_colours";
import { outline, type Tiling } from "../../library/pictures";
import type { Vec2 } from "../../library/shapes";
import { classColour, litTiles, separator } from "./links";
import { stepLit } from "./lighting";
import type { Answers, Lit, State } from "./state";

/** Pixels within which a corner is meant rather than a tile. */
const CORNER_REACH = 9;

export function tilingFigure(control: Control<State>): Figure<State, Answers> {
  let shown: Tiling | null = null;
  const light = (lit: Lit | null) => {
    if (lit?.kind !== control.state.lit?.kind || lit?.index !== control.state.lit?.index)
      control.change({ ...control.state, lit });
  };
  const view = new PlaneView(
    "The tiling: arrow keys to the left and right go through the tiles, up and down through the corners",
    ["tiles", "edges", "chain", "marks"],
    {
      hovered: (point) => point && shown && light(meant(view, shown, point)),
      pressed: (key) => shown !== null && stepLit(key, shown, control),
    },
    () => control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, { tiling }) {
      shown = tiling;
      if (!tiling) {
        for (const layer of ["tiles", "edges", "chain", "marks"]) view.draw(layer, []);
        return;
      }
      const flat = tiling.vertices.map(([x, y]): Vec2 => [x, y]);
      view.fit(
        boxAround(
          flat.length > 0
            ? flat
            : [
                [-1, -1],
                [1, 1],
              ],
        ),
      );
      const lit = litTiles(tiling, state.lit);
      const tiles = tiling.tiles.map((tile, index) =>
        view.polygon(
          outline(tile).map((corner) => flat[corner] as Vec2),
          {
            class: lit.has(index) ? "tile lit" : "tile",
            fill: mixed(tile.classes.map((one) => classColour(tiling, one))),
            "data-tile": index,
          },
        ),
      );
      view.draw("tiles", tiles);
      const lone =
        tiling.tiles.length === 0
          ? tiling.edges
          : tiling.edges.filter((edge) => state.lit?.kind === "class" && edge.class === state.lit.index);
      // Outlines come after all tiles, so that no neighbour covers a part of them.
      const outlines = tiling.tiles.flatMap((tile, index) =>
        lit.has(index)
          ? [
              view.polygon(
                outline(tile).map((corner) => flat[corner] as Vec2),
                { "stroke-width": 1.5 },
              ),
            ]
          : [],
      );
      view.draw("edges", [
        ...outlines,
        ...lone.map(({ ends, class: one }) =>
          view.path(
            ends.map((end) => flat[end] as Vec2),
            { stroke: classColour(tiling, one), "stroke-width": 4 },
          ),
        ),
      ]);
      const chain = separator(tiling, state.sweep).map((corner) => flat[corner] as Vec2);
      view.draw("chain", state.isPlain ? [] : [view.path(chain, { class: "sweep" })]);
      const corner = state.lit?.kind === "corner" ? flat[state.lit.index] : undefined;
      view.draw("marks", corner ? [view.dot(corner, 7, { fill: "var(--ink)" })] : []);
    },
  };
}

function meant(view: PlaneView, tiling: Tiling, point: Vec2): Lit | null {
  const [px, py] = view.pixel(point);
  const corner = tiling.vertices.findIndex(([x, y]) => {
    const [cx, cy] = view.pixel([x, y]);
    return Math.hypot(cx - px, cy - py) < CORNER_REACH;
  });
  if (corner >= 0) return { kind: "corner", index: corner };
  const tile = tiling.tiles.findIndex((one) => {
    const places = outline(one).map((index) => tiling.vertices[index] as readonly number[]);
    const turns = places.map((from, at) => {
      const to = places[(at + 1) % places.length] as readonly number[];
      return (
        ((to[0] ?? 0) - (from[0] ?? 0)) * (point[1] - (from[1] ?? 0)) -
        ((to[1] ?? 0) - (from[1] ?? 0)) * (point[0] - (from[0] ?? 0))
      );
    });
    return turns.every((turn) => turn >= 0) || turns.every((turn) => turn <= 0);
  });
  return tile >= 0 ? { kind: "tile", index: tile } : null;
}
