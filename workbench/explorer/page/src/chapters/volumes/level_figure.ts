/** The figure of a level: the mesh in the bounding volumes, each in a colour with its triangles. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid, solidOf, type SolidShape } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { Stepper } from "../../kit/stepper";
import { mixed, zoneColour } from "../../kit/zone_colours";
import type { MeshData } from "../../library/meshes";
import type { Vec3 } from "../../library/shapes";
import { DEEPEST, DRAWN, meshOf, type Answers, type Level, type State } from "./state";

const GREY = "#9aa3ad";

export function levelFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("A mesh in the bounding volumes of a level", {}, [2.6, -1.4, 2.6]);
  const [inner, outer] = [new Solid(), new Solid()];
  view.put("mesh", inner);
  view.put("volumes", outer);
  const choice = html(
    "select",
    { "aria-label": "Volume" },
    ...DRAWN.map(({ id, name }) => html("option", { value: id }, name)),
  );
  choice.addEventListener("change", () => control.commit({ ...control.state, volume: choice.value }));
  const stepper = new Stepper("The level", (level) => control.commit({ ...control.state, level }));
  let shown: { mesh: MeshData; level: Level | null } | null = null;
  return {
    element: html("div", {}, view.element, stepper.element, html("p", {}, html("label", {}, "Volume: ", choice))),
    svg: () => view.svg(),
    draw(state, { level }) {
      choice.value = state.volume;
      const mesh = meshOf(state);
      stepper.draw(state.level, DEEPEST + 1, told(state, level));
      // Until the worker has answered, the last level stays, but for another mesh.
      if (shown?.mesh === mesh && (level === null || shown.level === level)) return;
      shown = { mesh, level };
      inner.draw(surfaceOf(mesh), {
        facets: coloured(mesh, level),
        opacity: 1,
        edge: "#2b3036",
        isTwoSided: true,
      });
      const shape = together(level);
      outer.draw(shape, {
        facets: (level?.faces ?? []).flatMap((faces, at) => faces.facets.map(() => zoneColour(at))),
        opacity: 0.24,
        edge: "#5b6570",
      });
      view.fit(shape.vertices.length > 0 ? shape.vertices : mesh.vertices);
      view.draw([]);
    },
  };
}

/** A mesh as it is drawn. */
export function surfaceOf({ vertices, triangles }: MeshData): SolidShape {
  return { vertices, facets: triangles, ends: triangles.flatMap(([a, b, c]) => [a, b, b, c, c, a]) };
}

/** The colour of each triangle: that of its volume, paler. */
function coloured(mesh: MeshData, level: Level | null): string[] {
  const colours = mesh.triangles.map(() => GREY);
  level?.nodes.forEach(({ triangles }, at) => {
    const colour = mixed([zoneColour(at), "#ffffff", GREY]);
    for (const triangle of triangles) colours[triangle] = colour;
  });
  return colours;
}

/** All volumes of a level as one solid. */
function together(level: Level | null): SolidShape {
  const vertices: Vec3[] = [];
  const facets: number[][] = [];
  const ends: number[] = [];
  for (const faces of level?.faces ?? []) {
    const before = vertices.length;
    const shape = solidOf(faces);
    vertices.push(...shape.vertices);
    facets.push(...shape.facets.map((facet) => facet.map((at) => at + before)));
    for (let end = 0; end < shape.ends.length; end += 1) ends.push((shape.ends[end] as number) + before);
  }
  return { vertices, facets, ends };
}

function told(state: State, level: Level | null): string {
  if (!level) return `Level ${state.level}: the library is building the hierarchy …`;
  const most = Math.max(...level.nodes.map(({ triangles }) => triangles.length));
  const volumes = level.nodes.length === 1 ? "one volume" : `${level.nodes.length} volumes`;
  return `Level ${state.level}: ${volumes}, with at most ${most} of ${meshOf(state).triangles.length} triangles each.`;
}
