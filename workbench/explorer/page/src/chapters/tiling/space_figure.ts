/** The view of the zonohedron, with its generators as arrows that can be pulled. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { place3, tidy3 } from "../../kit/vectors";
import { crossingColour, lineColour, zoneColour } from "../../kit/zone_colours";
import type { Faces, Tiling } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { litTiles, tileOfFacet, vertexOfCorner } from "./links";
import { stepLit } from "./lighting";
import { separatorLines, type SeenLine } from "./separator_lines";
import type { Answers, State } from "./state";

/** Generators up to which each is a handle. */
const HANDLE_LIMIT = 24;

/** The colour of a facet that is lit up: it differs from all others in lightness. */
const LIT = "#fff3b0";

/** The colours of the arrows and of their tips, as rules: each generator has that of its zone. */
const VECTOR_COLOURS = Array.from({ length: HANDLE_LIMIT }, (_, index) => {
  const colour = lineColour(zoneColour(index));
  return (
    `#tiling-space .vector-${index} { stroke: ${colour}; stroke-width: 3; }` +
    `#tiling-space [data-handle="${index}"] .mark { fill: ${colour}; }`
  );
});

/** With a rim of paper the arrows stand off from facets of their own colour. */
const VECTOR_RIM = "#tiling-space .vector-rim { stroke: var(--paper); stroke-width: 6; }";

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
    element: html("div", {}, html("style", {}, [VECTOR_RIM, ...VECTOR_COLOURS].join("\n")), view.element),
    svg: () => view.svg(),
    draw(state, { faces, tiling }) {
      shown = faces ? { faces, tiling } : null;
      const lines: SeenLine[] = [];
      if (faces) {
        const lit = new Set([...(tiling ? litTiles(tiling, state.lit) : [])].map((tile) => tiling?.tiles[tile]?.facet));
        const colours = faces.facet_zones.map((zones, facet) =>
          lit.has(facet) ? LIT : crossingColour(zones.map((zone) => faces.zones[zone]?.[0] ?? 0)),
        );
        solid.draw(solidOf(faces), { facets: colours, opacity: 1, edge: "#20242a" });
        view.fit([...faces.vertices, ...state.generators]);
        if (tiling && !state.isPlain) lines.push(...separatorLines(faces, tiling, state.sweep, () => view.gaze));
      }
      const named = state.generators.length <= HANDLE_LIMIT;
      const tips = named ? state.generators : [];
      lines.push(...tips.map((tip) => ({ points: [[0, 0, 0] as Vec3, tip], look: "vector-rim" })));
      lines.push(...tips.map((tip, index) => ({ points: [[0, 0, 0] as Vec3, tip], look: `vector-${index}` })));
      const vertex =
        faces && tiling && state.lit?.kind === "corner" ? vertexOfCorner(faces, tiling, state.lit.index) : null;
      const names =
        vertex !== null && faces ? [{ at: faces.vertices[vertex] as Vec3, text: "", dot: "var(--ink)" }] : [];
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
