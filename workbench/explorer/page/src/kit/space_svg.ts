/** The picture of a view of space as SVG: facets that face away first, then those that face the reader. */

import type { Vec2, Vec3 } from "../library/shapes";
import { standalone } from "./downloads";
import { svg } from "./elements";
import { short } from "./layer";
import { normalOf, type Solid } from "./solid";
import { dot3 } from "./vectors";

export function pictureOf(
  over: SVGSVGElement,
  solids: readonly Solid[],
  pixelOf: (place: Vec3) => Vec2,
  gaze: Vec3,
  width: number,
  height: number,
): string {
  const group = svg("g");
  // Bodies that are farther away come first.
  const depth = ({ shape }: Solid) =>
    shape.vertices.reduce((sum, vertex) => sum + dot3(vertex, gaze), 0) / (shape.vertices.length || 1);
  for (const solid of [...solids].sort((one, other) => depth(other) - depth(one))) {
    const { shape, look } = solid;
    const facing = shape.facets.map((facet) => dot3(normalOf(shape, facet), gaze));
    // Of a body with dents facets that face the reader lie before each other, too.
    const far = shape.facets.map(
      (facet) => facet.reduce((sum, vertex) => sum + dot3(shape.vertices[vertex] as Vec3, gaze), 0) / facet.length,
    );
    const isAway = (index: number) => Number((facing[index] as number) > 0);
    const order = shape.facets
      .map((_, index) => index)
      .sort((one, other) => isAway(other) - isAway(one) || (far[other] as number) - (far[one] as number));
    for (const index of order) {
      const facet = shape.facets[index] as readonly number[];
      const away = (facing[index] as number) > 0;
      const points = facet
        .map((vertex) =>
          pixelOf(shape.vertices[vertex] as Vec3)
            .map(short)
            .join(","),
        )
        .join(" ");
      const opacity = away ? 0.15 * look.opacity : 0.85 * look.opacity;
      const fill = `fill:${look.facets[index] ?? "#888888"};fill-opacity:${short(opacity)}`;
      const style = `${fill};stroke:${look.edge};stroke-width:1`;
      group.append(svg("polygon", { points, style: away ? `${style};stroke-dasharray:2 3` : style }));
    }
  }
  const picture = over.cloneNode(true) as SVGSVGElement;
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  picture.prepend(group);
  // The style of the page applies only to what is in the page.
  picture.style.visibility = "hidden";
  over.after(picture);
  const text = standalone(picture);
  picture.remove();
  return text;
}
