/** The figure of the search of Theorem 5.2: separators on both sides of the point, and the tile in which it ends. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { html } from "../../kit/elements";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { Stepper } from "../../kit/stepper";
import { digits } from "../../kit/vectors";
import { mixed, zoneColour } from "../../kit/zone_colours";
import { outline, type LocationSearch } from "../../library/pictures";
import type { Vec2 } from "../../library/shapes";
import type { Answers, State } from "./state";

const LAYERS = ["tiles", "found", "chains", "point"] as const;

export function insideSearchFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView("The tiling with the separators of the search", LAYERS, {}, () => control.redraw());
  const stepper = new Stepper("Steps of the search", (step) => control.commit({ ...control.state, step }));
  return {
    element: html("div", {}, view.element, stepper.element),
    svg: () => standalone(view.svg),
    draw(state, { late }) {
      const search = late?.search;
      if (!search || !late.tiling) {
        for (const layer of LAYERS) view.draw(layer, []);
        stepper.draw(
          0,
          1,
          late
            ? "The search of this question is not drawn: the body has too many generators, or is flat."
            : "The search is being computed …",
        );
        return;
      }
      const flat = late.tiling.vertices.map(([x, y]): Vec2 => [x, y]);
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
      const tiles = late.tiling.tiles.map((tile) => {
        const zones = tile.classes.map((one) => zoneColour(late.tiling?.classes[one]?.generators[0] ?? 0));
        return view.polygon(
          outline(tile).map((corner) => flat[corner] as Vec2),
          { class: "tile", fill: mixed(zones), opacity: 0.6 },
        );
      });
      view.draw("tiles", tiles);
      const steps = search.steps.length;
      const now = Math.min(state.step, steps);
      const step = search.steps[now];
      const hull = step?.hull ?? search.found[search.found.length - 1]?.hull ?? "upper";
      const found = step ? [] : search.found;
      view.draw(
        "found",
        found.map((one) => view.polygon(sided(one.corners, one.hull), { class: "lit", fill: "var(--fill-green)" })),
      );
      view.draw(
        "chains",
        step
          ? step.chains.map((chain) =>
              view.path(
                chain.map((place) => placed(place, step.hull)),
                { class: "sweep" },
              ),
            )
          : [],
      );
      const [x, y] = state.point;
      view.draw("point", [view.dot([x, y], 7, { fill: "var(--red)", stroke: "var(--paper)", "stroke-width": 2 })]);
      stepper.draw(now, steps + 1, step ? told(step, now, steps) : ended(search, hull));
    },
  };
}

/** The lower hull is the upper one after a reflection in the centre; its separators are drawn where they lie. */
function placed([x, y]: Vec2, _hull: "upper" | "lower"): Vec2 {
  return [x, y];
}

function sided(corners: readonly Vec2[], hull: "upper" | "lower"): Vec2[] {
  return corners.map((corner) => placed(corner, hull));
}

function told(step: LocationSearch["steps"][number], now: number, steps: number): string {
  const where = { left: "on its left", right: "on its right", within: "on it" }[step.side];
  return (
    `Step ${now + 1} of ${steps}, ${step.hull} hull: ${step.tiles} tiles are candidates. The ` +
    `vertical line x = ${digits(step.x)} gives this separator; the point is ${where}, and ` +
    `${step.left} tiles are left.`
  );
}

function ended(search: LocationSearch, hull: "upper" | "lower"): string {
  const tiles = search.found.map((one) => {
    const generators = one.generators.map((index) => index + 1).join(" and ");
    return (
      `The point lies ${digits(Math.abs(one.depth))} ` +
      `${one.depth < 0 === (one.hull === "upper") ? "above" : "below"} the facet of generators ` +
      `${generators} of the ${one.hull} hull.`
    );
  });
  const verdict = { inside: "So it is inside.", boundary: "So it is on the boundary.", outside: "So it is outside." }[
    search.status
  ];
  return `${tiles.length > 0 ? tiles.join(" ") : `The point is not under the ${hull} hull at all.`} ${verdict}`;
}
