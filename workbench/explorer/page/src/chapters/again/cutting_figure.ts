/** The figure of a cutting: trapezoids among the lines, and the same colours in the tiling. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { html } from "../../kit/elements";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { zoneColour } from "../../kit/zone_colours";
import { outline } from "../../library/pictures";
import type { Vec2 } from "../../library/shapes";
import { mean2 } from "./places";
import type { Answers, State } from "./state";

const LAYERS = ["cells", "lines"];

export function cuttingFigure(control: Control<State>): Figure<State, Answers> {
  const redraw = () => control.redraw();
  const plane = new PlaneView("The cutting of the arrangement", LAYERS, {}, redraw);
  const floor = new PlaneView("Its image in the tiling", LAYERS, {}, redraw);
  return {
    element: html("div", { class: "two-views" }, plane.element, floor.element),
    svg: () => inARow([plane, floor]),
    draw(_, { cut }) {
      if (!cut) {
        for (const layer of LAYERS) {
          plane.draw(layer, []);
          floor.draw(layer, []);
        }
        return;
      }
      const { cutting, tiling } = cut;
      const [low, high] = cutting.window;
      plane.fit({ low, high });
      plane.draw(
        "cells",
        cutting.trapezoids.flatMap((corners, index) => (corners.length > 2 ? [cell(plane, corners, index)] : [])),
      );
      const lines = tiling.classes.flatMap(({ line }) => {
        if (!line) return [];
        const [a, b, c] = line;
        const size = a * a + b * b;
        const shape = plane.line([(-a * c) / size, (-b * c) / size], [b, -a], { class: "axis" });
        return shape ? [shape] : [];
      });
      plane.draw("lines", lines);

      const flat = tiling.vertices.map(([x, y]): Vec2 => [x, y]);
      if (flat.length > 0) floor.fit(boxAround(flat));
      const outlines = tiling.tiles.map((tile) => outline(tile).map((corner) => flat[corner] as Vec2));
      floor.draw(
        "cells",
        outlines.flatMap((corners, tile) => quarters(floor, corners, cutting.images[tile] ?? [])),
      );
      floor.draw(
        "lines",
        outlines.map((corners) => floor.polygon(corners, { class: "axis" })),
      );
    },
  };
}

/** Pixels between the views in a picture of both. */
const GAP = 12;

/** The views side by side as one picture, whatever their places on the page. */
function inARow(views: readonly PlaneView[]): string {
  let width = 0;
  const parts = views.map((view) => {
    const at = width === 0 ? 0 : width + GAP;
    width = at + view.width;
    return standalone(view.svg).replace("<svg", `<svg x="${at}"`);
  });
  const height = Math.max(...views.map((view) => view.height));
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}">${parts.join("")}</svg>`;
}

function cell(view: PlaneView, corners: readonly Vec2[], trapezoid: number) {
  const fill = zoneColour(trapezoid);
  return view.polygon(corners, { fill, "fill-opacity": 0.45, stroke: "none", "data-trapezoid": trapezoid });
}

/** The parts of a tile around its corners, each in the colour of the trapezoid that holds the corner's face. */
function quarters(view: PlaneView, corners: readonly Vec2[], image: readonly (number | null)[]) {
  const middle = mean2(corners);
  return corners.flatMap((corner, place) => {
    const trapezoid = image[place];
    if (trapezoid === null || trapezoid === undefined) return [];
    const [before, after] = [place + corners.length - 1, place + 1].map((other) =>
      mean2([corner, corners[other % corners.length] as Vec2]),
    ) as [Vec2, Vec2];
    return [cell(view, [before, corner, after, middle], trapezoid)];
  });
}
