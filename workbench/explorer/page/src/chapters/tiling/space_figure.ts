/** The view of the zonohedron, with its generators as arrows that can be pulled. */

import type { Control, Figure } from "../../kit/chapter";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { add3, place3, tidy3 } from "../../kit/vectors";
import { crossingColour } from "../../kit/zone_colours";
import type { Faces, Tiling } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { litTiles, separator, tileOfFacet, vertexOfCorner } from "./links";
import { stepLit } from "./lighting";
import type { Answers, State } from "./state";

/** Generators up to which each is a handle. */
const HANDLE_LIMIT = 24;

/** The colour of a facet that is lit up: it differs from all others in lightness. */
const LIT = "#fff3b0";

export function spaceFigure(control: Control<State>): Figure<State, Answers> {
  let shown: { faces: Faces; tiling: Tiling | null } | null = null;
  const solid = new Solid();
  const view = new SpaceView(
    "The zonohedron with its generators",
    {
      moved: (id, place, finished) => {
        const { state } = control;
        const generators = state.generators.map((one, index) => (String(index) === id ? tidy3(place) : one));
        (finished ? control.commit : control.change)({ ...state, generators });
      },
      removed: (id) =>
        control.commit({
          ...control.state,
          lit: null,
          generators: control.state.generators.filter((_, index) => String(index) !== id),
        }),
      hovered: (hit) => {
        if (!hit || !shown?.tiling) return;
        const tile = tileOfFacet(shown.tiling, hit.facet);
        const before = control.state.lit;
        if (tile === null || (before?.kind === "tile" && before.index === tile)) return;
        control.change({ ...control.state, lit: { kind: "tile", index: tile } });
      },
      pressed: (key) => {
        const step = { n: "ArrowRight", p: "ArrowLeft" }[key.toLowerCase()];
        return step !== undefined && shown?.tiling ? stepLit(step, shown.tiling, control) : false;
      },
    },
    [2.2, -3.4, 4.2],
  );
  view.put("body", solid);
  return {
    element: view.element,
    svg: () => view.svg(),
    draw(state, { faces, tiling }) {
      shown = faces ? { faces, tiling } : null;
      const lines: { points: readonly Vec3[]; look: string }[] = [];
      if (faces) {
        const lit = new Set([...(tiling ? litTiles(tiling, state.lit) : [])].map((tile) => tiling?.tiles[tile]?.facet));
        const colours = faces.facet_zones.map((zones, facet) =>
          lit.has(facet) ? LIT : crossingColour(zones.map((zone) => faces.zones[zone]?.[0] ?? 0)),
        );
        solid.draw(solidOf(faces), { facets: colours, opacity: 1, edge: "#20242a" });
        view.fit([...faces.vertices, ...state.generators]);
        if (tiling)
          lines.push({
            points: separator(tiling, state.sweep).map((corner) => tiling.vertices[corner] as Vec3),
            look: "sweep",
          });
      }
      const named = state.generators.length <= HANDLE_LIMIT;
      const tips = named ? state.generators : [];
      lines.push(...tips.map((tip) => ({ points: [[0, 0, 0] as Vec3, tip], look: "thin dashed" })));
      const vertex =
        faces && tiling && state.lit?.kind === "corner" ? vertexOfCorner(faces, tiling, state.lit.index) : null;
      const names =
        vertex !== null && faces ? [{ at: add3(faces.vertices[vertex] as Vec3, [0, 0, 0]), text: "●" }] : [];
      view.draw(
        tips.map((tip, index) => ({
          id: String(index),
          at: tip,
          label: `Generator ${index + 1} at ${place3(tip)}; it moves in the plane of the screen`,
          look: "tip",
          removable: true,
          name: String(index + 1),
        })),
        names,
        lines,
      );
    },
  };
}
